//! The outline of a set of triangles: its edges, and how much of each pixel lies inside.

use super::strip::Strip;
use super::union::{self, EdgePiece, add_upright};
use crate::plane::sort_by;

/// An edge of the outline: its ends and the triangle that it bounds, which lies to its left (y down: to its right).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct OutlineEdge {
    pub from: u32,
    pub to: u32,
    pub triangle: u32,
}

/// The directed edges of `triangles` that no other triangle has the other way round.
///
/// Triangles of one orientation share every inner edge in opposite directions, so what is left is the outline. Where a
/// sheet is folded, both triangles have the edge in the same direction, and the fold counts as outline too.
pub(super) fn outline(nodes: usize, triangles: &[[u32; 3]]) -> Vec<OutlineEdge> {
    // Counting sort by the smaller end: linear in the mesh, unlike hashing every edge.
    let edges_of = |t: &[u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let mut starts = vec![0_u32; nodes + 1];
    for [a, b] in triangles.iter().flat_map(edges_of) {
        starts[a.min(b) as usize + 1] += 1;
    }
    for node in 0..nodes {
        starts[node + 1] += starts[node];
    }
    let mut next = starts.clone();
    let mut sorted = vec![(0_u32, false, 0_u32); 3 * triangles.len()];
    for (index, triangle) in triangles.iter().enumerate() {
        for [a, b] in edges_of(triangle) {
            let slot = &mut next[a.min(b) as usize];
            sorted[*slot as usize] = (a.max(b), a < b, index as u32);
            *slot += 1;
        }
    }
    let mut outline = Vec::new();
    for node in 0..nodes {
        let bucket = &mut sorted[starts[node] as usize..starts[node + 1] as usize];
        sort(bucket);
        for group in bucket.chunk_by(|a, b| a.0 == b.0) {
            let upward = group.partition_point(|edge| !edge.1);
            let (downs, ups) = group.split_at(upward);
            let paired = downs.len().min(ups.len());
            let node = node as u32;
            outline.extend(downs[paired..].iter().map(|e| OutlineEdge { from: e.0, to: node, triangle: e.2 }));
            outline.extend(ups[paired..].iter().map(|e| OutlineEdge { from: node, to: e.0, triangle: e.2 }));
        }
    }
    outline
}

/// The share of each pixel of a strip that lies inside a set of closed curves, exactly, from their edges alone.
///
/// Each edge adds its signed area to the cells that it crosses and its height to all cells on its right; a running sum
/// along the row gives the share. Curves around the same point add up, so that overlapping sheets stay covered.
pub(super) struct Coverage {
    cells: Vec<f32>,
    touched: Vec<bool>,
    /// The edges again, for rows in which sheets overlap.
    pieces: Vec<EdgePiece>,
    width: usize,
    first_row: usize,
    rows: usize,
}

impl Coverage {
    pub fn new(strip: &Strip) -> Self {
        let cells = vec![0.0; (strip.width + 2) * strip.rows];
        Self {
            cells,
            touched: vec![false; strip.rows],
            pieces: Vec::new(),
            width: strip.width,
            first_row: strip.first_row,
            rows: strip.rows,
        }
    }

    /// Adds the edge a → b (pixels) and calls `visit(row, columns)` with the cells of each of its rows.
    pub fn add_edge(&mut self, a: [f64; 2], b: [f64; 2], mut visit: impl FnMut(usize, std::ops::Range<usize>)) {
        let (sign, [x0, y0], [x1, y1]) = if a[1] <= b[1] { (1.0, a, b) } else { (-1.0, b, a) };
        let (top, bottom) = (self.first_row as f64, (self.first_row + self.rows) as f64);
        if !(y1 >= top && y0 < bottom) {
            return;
        }
        let slope = if y1 > y0 { (x1 - x0) / (y1 - y0) } else { 0.0 };
        let (first, last) = (y0.max(top).floor(), y1.min(bottom - 1.0).floor());
        for row in first as usize..=last as usize {
            let (enter, leave) = (y0.max(row as f64), y1.min(row as f64 + 1.0));
            let at = |y: f64| x0 + (y - y0) * slope;
            let (start, end) = if y1 > y0 { (at(enter), at(leave)) } else { (x0, x1) };
            let (top, row) = (row as f64, row - self.first_row);
            let (heights, sheets) = ([enter - top, leave - top], if sign > 0.0 { 1 } else { -1 });
            self.pieces.push(EdgePiece { row, heights, columns: [start, end], sheets });
            self.add_piece(row, start, end, sign * (leave - enter));
            let limit = |x: f64| x.clamp(0.0, self.width as f64) as usize;
            visit(row, limit(start.min(end).floor())..limit(start.max(end).floor() + 1.0));
        }
    }

    /// Adds the piece of an edge within one row, from column x = `start` to `end`, `height` high.
    fn add_piece(&mut self, row: usize, start: f64, end: f64, height: f64) {
        if height == 0.0 {
            return;
        }
        self.touched[row] = true;
        let (left, right) = (start.min(end), start.max(end));
        let limit = self.width as f64;
        let cells = &mut self.cells[row * (self.width + 2)..][..self.width + 2];
        // What lies left of the view covers all of the row; what lies right of it, none.
        let share = |from: f64, to: f64| if right > left { (to - from) / (right - left) } else { 1.0 };
        if left < 0.0 {
            cells[0] += (height * share(left, right.min(0.0))) as f32;
        }
        let (mut x, to) = (left.max(0.0), right.min(limit));
        if right <= left && left >= 0.0 {
            add_upright(cells, left, height);
        }
        while x < to {
            let cell = x.floor();
            let next = (cell + 1.0).min(to);
            let part = height * share(x, next);
            let inside = cell + 1.0 - 0.5 * (x + next);
            cells[cell as usize] += (part * inside) as f32;
            cells[cell as usize + 1] += (part * (1.0 - inside)) as f32;
            x = next;
        }
    }

    /// Adds the pixels (row, column, share) that lie neither wholly inside nor wholly outside to `shares`.
    pub fn partial(&mut self, shares: &mut Vec<(usize, usize, f32)>) {
        /// Rounding of the running sum must not dim what is wholly covered, nor look like a second sheet.
        const ROUNDING: f32 = 1.0 / 1024.0;
        let touched: Vec<usize> = (0..self.rows).filter(|&row| self.touched[row]).collect();
        touched.iter().for_each(|&row| self.sum_up(row));
        let overlaps = touched.iter().any(|&row| self.row(row).iter().any(|&share| share > 1.0 + ROUNDING));
        if overlaps {
            sort_by(&mut self.pieces, |a, b| a.row.cmp(&b.row));
        }
        for row in touched {
            let together = overlaps.then(|| {
                let pieces = self.pieces.partition_point(|piece| piece.row < row);
                let end = self.pieces.partition_point(|piece| piece.row <= row);
                union::shares(&self.pieces[pieces..end], self.width)
            });
            for (column, &own) in self.row(row).iter().enumerate() {
                let share = together.as_ref().and_then(|together| together[column]).unwrap_or(own);
                if share < 1.0 - ROUNDING {
                    shares.push((row, column, share));
                }
            }
        }
    }

    fn row(&self, row: usize) -> &[f32] {
        &self.cells[row * (self.width + 2)..][..self.width]
    }

    /// Turns a row's cells into the area that the sheets cover, each counted for itself.
    fn sum_up(&mut self, row: usize) {
        let mut sum = 0.0_f32;
        for cell in &mut self.cells[row * (self.width + 2)..][..self.width] {
            sum += *cell;
            *cell = sum.abs();
        }
    }
}

/// Sorts the edges of a node: few, but for hubs.
fn sort(bucket: &mut [(u32, bool, u32)]) {
    const FEW: usize = 24;
    if bucket.len() > FEW {
        sort_by(bucket, Ord::cmp);
        return;
    }
    for k in 1..bucket.len() {
        let mut at = k;
        while at > 0 && bucket[at] < bucket[at - 1] {
            bucket.swap(at, at - 1);
            at -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::warp::Quality;

    fn coverage_of(polygon: &[[f64; 2]], width: usize, rows: usize) -> Vec<u8> {
        let mut strip = Strip::new(width, Quality::Nearest);
        strip.reset(0, rows);
        let mut coverage = Coverage::new(&strip);
        for (k, &a) in polygon.iter().enumerate() {
            coverage.add_edge(a, polygon[(k + 1) % polygon.len()], |_, _| {});
        }
        let (mut alpha, mut shares) = (vec![255; width * rows], Vec::new());
        coverage.partial(&mut shares);
        for (row, column, share) in shares {
            alpha[row * width + column] = (255.0 * share + 0.5) as u8;
        }
        alpha
    }

    #[test]
    fn a_rectangle_between_pixels_covers_by_area() {
        let alpha = coverage_of(&[[0.5, 0.0], [2.25, 0.0], [2.25, 1.5], [0.5, 1.5]], 4, 2);
        assert_eq!(alpha, [128, 255, 64, 0, 64, 128, 32, 0]);
    }

    #[test]
    fn sheets_cover_their_union_once() {
        let twice = [[0.5, 0.0], [2.25, 0.0], [2.25, 1.5], [0.5, 1.5]].repeat(2);
        assert_eq!(coverage_of(&twice, 4, 2), [128, 255, 64, 0, 64, 128, 32, 0]);
        // The second sheet is wider by a pixel, and ends where the first does.
        let steps =
            [[0.5, 0.0], [2.25, 0.0], [2.25, 1.0], [0.5, 1.0], [0.5, 0.0], [3.25, 0.0], [3.25, 1.0], [0.5, 1.0]];
        assert_eq!(coverage_of(&steps, 4, 1), [128, 255, 255, 64]);
    }

    #[test]
    fn shares_sum_to_the_area_clipped_to_the_view() {
        let triangle = [[-3.0, -2.0], [7.3, 1.1], [2.2, 9.0]];
        let shares: f64 = coverage_of(&triangle, 5, 6).iter().map(|&a| f64::from(a) / 255.0).sum();
        // Clipped by hand: a fine count of points.
        let n = 400;
        let inside = |x: f64, y: f64| {
            (0..3).all(|k| {
                let ([ax, ay], [bx, by]) = (triangle[k], triangle[(k + 1) % 3]);
                (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0.0
            })
        };
        let at = |i: usize| (i as f64 + 0.5) / n as f64;
        let hits = (0..n * n).filter(|i| inside(5.0 * at(i % n), 6.0 * at(i / n))).count();
        let area = 30.0 * hits as f64 / (n * n) as f64;
        assert!((shares - area).abs() < 0.05, "{shares} against {area}");
    }

    #[test]
    fn few_and_many_edges_are_sorted_alike() {
        for count in [0, 1, 2, 24, 25, 300] {
            let mut bucket: Vec<(u32, bool, u32)> = (0..count).map(|k| ((k * 7919) % 13, k % 3 == 0, k)).collect();
            let mut expected = bucket.clone();
            expected.sort();
            sort(&mut bucket);
            assert_eq!(bucket, expected);
        }
    }

    #[test]
    fn inner_edges_cancel_and_folds_do_not() {
        let square = [[0, 1, 2], [0, 2, 3]];
        let edges: Vec<_> = outline(4, &square).iter().map(|e| (e.from, e.to)).collect();
        let mut sorted = edges.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, [(0, 1), (1, 2), (2, 3), (3, 0)]);
        assert_eq!(outline(4, &[[0, 1, 2], [0, 3, 2]]).len(), 6);
    }
}
