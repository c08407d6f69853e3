//! Floating-point scan conversion: a polygon filled with the points of a rectangular grid.

use crate::plane::{Complex64, Polygon, sort_by_number};
use crate::{Error, Result};

/// Samples keep this share of the spacing away from the boundary, where its own nodes are.
pub(super) const CLEARANCE: f64 = 0.4;

/// More grid points than this in a bounding box is a mistake in the units, not a mesh.
const MOST_POINTS: f64 = 16e6;

/// Polygon → the points of the grid `anchor + spacing·(i + j·i)` inside it, row by row upwards, that are at
/// least `clearance` away from its boundary. Any simple polygon will do; a part thinner than the grid gets no point.
///
/// # Errors
/// [`Error::InvalidOption`] if the grid over the bounding box has more than 16 million points.
pub(super) fn fill(polygon: &Polygon, anchor: Complex64, spacing: f64, clearance: f64) -> Result<Vec<Complex64>> {
    let mut grid = Grid::over(polygon, anchor, spacing)?;
    grid.mark_inside(polygon);
    for k in 0..polygon.len() {
        grid.clear_near(polygon.edge(k), clearance);
    }
    Ok(grid.marked())
}

/// The grid points of a bounding box, each marked or not.
struct Grid {
    anchor: Complex64,
    spacing: f64,
    /// Column and row of the lower left point, counted from the anchor.
    first: [i64; 2],
    columns: usize,
    rows: usize,
    marks: Vec<bool>,
}

impl Grid {
    fn over(polygon: &Polygon, anchor: Complex64, spacing: f64) -> Result<Self> {
        let (low, high) = polygon.bounds();
        let (low, high) = ((low - anchor) / spacing, (high - anchor) / spacing);
        let [columns, rows] = [high.re.floor() - low.re.ceil() + 1.0, high.im.floor() - low.im.ceil() + 1.0];
        let count = columns * rows;
        if !count.is_finite() || count > MOST_POINTS || low.norm().max(high.norm()) > 1e9 {
            let expected = "large enough for at most 16 million samples over the region";
            return Err(Error::InvalidOption { name: "spacing", expected, value: spacing });
        }
        let [columns, rows] = [columns, rows].map(|n| n.max(0.0) as usize);
        let first = [low.re.ceil() as i64, low.im.ceil() as i64];
        Ok(Self { anchor, spacing, first, columns, rows, marks: vec![false; columns * rows] })
    }

    fn x(&self, column: usize) -> f64 {
        self.anchor.re + (self.first[0] + column as i64) as f64 * self.spacing
    }

    fn y(&self, row: usize) -> f64 {
        self.anchor.im + (self.first[1] + row as i64) as f64 * self.spacing
    }

    /// The columns with `from ≤ x ≤ to`.
    fn columns_between(&self, from: f64, to: f64) -> std::ops::Range<usize> {
        indices_between(
            (from - self.anchor.re) / self.spacing,
            (to - self.anchor.re) / self.spacing,
            self.first[0],
            self.columns,
        )
    }

    fn rows_between(&self, from: f64, to: f64) -> std::ops::Range<usize> {
        indices_between(
            (from - self.anchor.im) / self.spacing,
            (to - self.anchor.im) / self.spacing,
            self.first[1],
            self.rows,
        )
    }

    /// Even-odd fill. An edge owns its lower end but not its upper one, so that a vertex on a grid line counts once
    /// and a horizontal edge not at all.
    fn mark_inside(&mut self, polygon: &Polygon) {
        let mut crossings: Vec<Vec<f64>> = vec![Vec::new(); self.rows];
        for k in 0..polygon.len() {
            let (a, b) = polygon.edge(k);
            let (low, high) = if a.im < b.im { (a, b) } else { (b, a) };
            for row in self.rows_between(low.im, high.im) {
                let y = self.y(row);
                if low.im <= y && y < high.im {
                    crossings[row].push(low.re + (high.re - low.re) * ((y - low.im) / (high.im - low.im)));
                }
            }
        }
        for (row, xs) in crossings.iter_mut().enumerate() {
            sort_by_number(xs, |x| *x);
            for span in xs.chunks_exact(2) {
                let columns = self.columns_between(span[0], span[1]);
                self.marks[row * self.columns..][columns].fill(true);
            }
        }
    }

    /// Unmarks the points within `clearance` of the segment.
    fn clear_near(&mut self, (a, b): (Complex64, Complex64), clearance: f64) {
        for row in self.rows_between(a.im.min(b.im) - clearance, a.im.max(b.im) + clearance) {
            let (left, right) = capsule_section(a, b, clearance, self.y(row));
            let columns = self.columns_between(left, right);
            self.marks[row * self.columns..][columns].fill(false);
        }
    }

    fn marked(&self) -> Vec<Complex64> {
        let at = |k: usize| Complex64::new(self.x(k % self.columns), self.y(k / self.columns));
        self.marks.iter().enumerate().filter(|(_, mark)| **mark).map(|(k, _)| at(k)).collect()
    }
}

/// Indices k of `first + k` within [from, to], limited to `count`.
fn indices_between(from: f64, to: f64, first: i64, count: usize) -> std::ops::Range<usize> {
    let start = (from.ceil() - first as f64).max(0.0) as usize;
    let end = (to.floor() - first as f64 + 1.0).clamp(0.0, count as f64) as usize;
    start.min(end)..end
}

/// The interval of x in which the line at height y is within `radius` of the segment ab (empty: left > right).
fn capsule_section(a: Complex64, b: Complex64, radius: f64, y: f64) -> (f64, f64) {
    let mut section = (f64::INFINITY, f64::NEG_INFINITY);
    let mut include = |left: f64, right: f64| {
        if left <= right {
            section = (section.0.min(left), section.1.max(right));
        }
    };
    for end in [a, b] {
        let half = (radius * radius - (y - end.im) * (y - end.im)).sqrt();
        include(end.re - half, end.re + half); // NaN where the line misses the circle: not included
    }
    // The rectangle between the circles: its corners are the ends moved sideways; the line cuts two of its sides.
    let sideways = Complex64::i() * (b - a) * (radius / (b - a).norm());
    let corners = [a + sideways, b + sideways, b - sideways, a - sideways];
    for k in 0..4 {
        let (p, q) = (corners[k], corners[(k + 1) % 4]);
        let t = (y - p.im) / (q.im - p.im);
        if (0.0..=1.0).contains(&t) {
            let x = p.re + (q.re - p.re) * t;
            include(x, x);
        }
    }
    section
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(xy: &[(f64, f64)]) -> Polygon {
        Polygon::new(&xy.iter().map(|&(x, y)| Complex64::new(x, y)).collect::<Vec<_>>()).unwrap()
    }

    /// The same answer by asking every grid point of a generous box.
    fn by_search(polygon: &Polygon, anchor: Complex64, spacing: f64, clearance: f64) -> Vec<Complex64> {
        let mut found = Vec::new();
        for j in -100..=100 {
            for i in -100..=100 {
                let z = anchor + Complex64::new(i as f64, j as f64) * spacing;
                if polygon.contains(z) && (polygon.nearest(z).point - z).norm() > clearance {
                    found.push(z);
                }
            }
        }
        found
    }

    #[test]
    fn fills_what_a_search_finds() {
        let shapes: [&[(f64, f64)]; 4] = [
            &[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (2.0, 1.0), (2.0, 3.0), (0.0, 3.0)],
            &[(-3.0, -2.0), (3.0, -1.0), (0.5, 0.0), (3.0, 2.0), (-1.0, 1.0), (-2.0, 3.0)],
            &[(0.0, 0.0), (5.0, 0.05), (0.0, 0.1), (-1.0, 2.0), (-2.0, -1.0)],
            &[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0), (3.0, 1.0), (3.0, -2.0), (1.5, -0.5), (0.0, -2.0)],
        ];
        for xy in shapes {
            let polygon = polygon(xy);
            for (anchor, spacing, clearance) in [
                (Complex64::new(0.0, 0.0), 0.25, 0.1),
                (Complex64::new(0.013, -0.21), 0.11, 0.043),
                (Complex64::new(0.5, 0.5), 0.2, 0.15),
            ] {
                let filled = fill(&polygon, anchor, spacing, clearance).unwrap();
                let expected = by_search(&polygon, anchor, spacing, clearance);
                assert_eq!(filled.len(), expected.len(), "{xy:?} at {spacing}");
                assert!(filled.iter().zip(&expected).all(|(a, b)| (a - b).norm() < 1e-12));
            }
        }
    }

    #[test]
    fn a_part_thinner_than_the_grid_gets_no_point() {
        let sliver = polygon(&[(0.0, 0.0), (10.0, 0.01), (0.0, 0.02)]);
        assert!(fill(&sliver, Complex64::new(0.0, 0.01), 0.5, 0.2).unwrap().is_empty());
    }

    #[test]
    fn an_absurd_spacing_is_refused() {
        let triangle = polygon(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
        assert_eq!(fill(&triangle, Complex64::ZERO, 1e-9, 0.0).unwrap_err().code(), "invalid-option");
    }
}
