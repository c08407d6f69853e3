//! Scan conversion: a triangle of the view, with the texture over it, → pixels of a strip.

use super::strip::Strip;

/// A triangle's corner: where it lies in the view (pixels) and what it shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub x: f64,
    pub y: f64,
    pub u: f64,
    pub v: f64,
    /// log₂ of the footprint's diameter in texels, to be interpolated over the triangle.
    pub level: f64,
}

/// Which triangle is seen where several cover a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Overlap {
    /// The one drawn last.
    Later,
    /// The one that shows the lowest point of the texture.
    Lowest,
}

/// A quantity that varies linearly over the view: `value` at the first corner.
#[derive(Clone, Copy)]
struct Linear {
    value: f64,
    dx: f64,
    dy: f64,
}

/// A triangle with its affine map view → texture.
pub(super) struct Triangle {
    corners: [Corner; 3],
    edges: [Edge; 3],
    u: Linear,
    v: Linear,
    level: Linear,
}

impl Triangle {
    /// `None` for a triangle without area: its neighbours cover its pixels.
    pub fn new(corners: [Corner; 3]) -> Option<Self> {
        let [a, b, c] = &corners;
        let (bx, by, cx, cy) = (b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
        let area = bx * cy - by * cx;
        if !area.is_normal() {
            return None;
        }
        let linear = |of: fn(&Corner) -> f64| {
            let (db, dc) = (of(b) - of(a), of(c) - of(a));
            Linear { value: of(a), dx: (db * cy - dc * by) / area, dy: (dc * bx - db * cx) / area }
        };
        let (u, v, level) = (linear(|c| c.u), linear(|c| c.v), linear(|c| c.level));
        let edges = [Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)];
        Some(Self { corners, edges, u, v, level })
    }

    /// Rows of the view whose pixel centres it may cover, within 0..`height`.
    pub fn rows(&self, height: usize) -> std::ops::Range<usize> {
        let ys = self.corners.map(|c| c.y);
        let (low, high) = span_of(ys);
        centres_between(low, high, height)
    }

    /// ∂u/∂x, ∂v/∂x, ∂u/∂y, ∂v/∂y: texels per pixel.
    pub fn jacobian(&self) -> [f64; 4] {
        [self.u.dx, self.v.dx, self.u.dy, self.v.dy]
    }

    /// Writes the pixels whose centre lies in the triangle; a centre on an edge belongs to the triangle on its right
    /// or, on a level edge, below it. Triangles that share an edge compute the same crossing for it, to the bit, so
    /// that each pixel inside a mesh is written exactly once.
    pub fn draw(&self, strip: &mut Strip, overlap: Overlap) {
        let rows = self.rows(strip.first_row + strip.rows);
        for row in rows.start.max(strip.first_row)..rows.end {
            let y = row as f64 + 0.5;
            let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
            for x in self.edges.iter().filter_map(|edge| edge.crossing(y)) {
                left = if x < left { x } else { left };
                right = if x > right { x } else { right };
            }
            let columns = centres_between(left, right, strip.width);
            match overlap {
                _ if columns.is_empty() => {}
                Overlap::Later => self.draw_span(strip, row, columns),
                Overlap::Lowest => self.draw_lowest(strip, row, columns),
            }
        }
    }

    /// Draws the runs of the span where nothing lower in the texture is seen already.
    fn draw_lowest(&self, strip: &mut Strip, row: usize, columns: std::ops::Range<usize>) {
        let start = strip.start(row - strip.first_row);
        let (y, x0) = (row as f64 + 0.5 - self.corners[0].y, 0.5 - self.corners[0].x);
        let v = |column: usize| (self.v.value + (column as f64 + x0) * self.v.dx + y * self.v.dy) as f32;
        let hidden = |strip: &Strip, k: usize| !strip.u[start + k].is_nan() && strip.v[start + k] >= v(k);
        let mut first = columns.start;
        while first < columns.end {
            let end = (first..columns.end).find(|&k| hidden(strip, k)).unwrap_or(columns.end);
            if end > first {
                self.draw_span(strip, row, first..end);
            }
            first = (end..columns.end).find(|&k| !hidden(strip, k)).unwrap_or(columns.end);
        }
    }

    fn draw_span(&self, strip: &mut Strip, row: usize, columns: std::ops::Range<usize>) {
        let (x, y) = (columns.start as f64 + 0.5 - self.corners[0].x, row as f64 + 0.5 - self.corners[0].y);
        let start = strip.start(row - strip.first_row);
        let span = start + columns.start..start + columns.end;
        let ramp = |plane: &mut [f32], linear: &Linear| {
            let (first, step) = ((linear.value + x * linear.dx + y * linear.dy) as f32, linear.dx as f32);
            for (k, value) in plane.iter_mut().enumerate() {
                *value = first + k as i32 as f32 * step;
            }
        };
        ramp(&mut strip.u[span.clone()], &self.u);
        ramp(&mut strip.v[span.clone()], &self.v);
        if strip.has_levels() {
            ramp(&mut strip.level[span.clone()], &self.level);
        }
        if strip.has_jacobian() {
            for (plane, slope) in strip.jacobian.iter_mut().zip(self.jacobian()) {
                plane[span.clone()].fill(slope as f32);
            }
        }
    }
}

/// An edge, taken from its upper end whichever triangle has it.
struct Edge {
    top: f64,
    bottom: f64,
    /// Where it starts, at the top.
    x: f64,
    /// Columns per row.
    slope: f64,
}

impl Edge {
    fn new(a: &Corner, b: &Corner) -> Self {
        let (top, bottom) = if a.y <= b.y { (a, b) } else { (b, a) };
        let slope = (bottom.x - top.x) / (bottom.y - top.y);
        Self { top: top.y, bottom: bottom.y, x: top.x, slope }
    }

    /// Where it crosses the height y, if it does: half-open, so that a vertex counts once.
    fn crossing(&self, y: f64) -> Option<f64> {
        (self.top <= y && y < self.bottom).then_some(self.x + (y - self.top) * self.slope)
    }
}

/// The least and the greatest of three numbers. (`f64::min` is a call in wasm, for the sake of NaN.)
pub(super) fn span_of([a, b, c]: [f64; 3]) -> (f64, f64) {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    (if c < low { c } else { low }, if c > high { c } else { high })
}

/// The pixels of 0..`count` whose centre k + ½ lies in [low, high).
fn centres_between(low: f64, high: f64, count: usize) -> std::ops::Range<usize> {
    // The conversion takes what is negative to 0.
    let index = |t: f64| ((t - 0.5).ceil() as usize).min(count);
    index(low)..index(high)
}
