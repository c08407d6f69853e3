//! A smooth piece of a map, from its jets at the four corners of a square block of pixels.
//!
//! Cubic Hermite along the edges and blended linearly between them (a Coons patch; as a finite element, Adini's): it
//! reproduces cubics, its error falls as the fourth power of the block's side, and two blocks with a common edge agree
//! along it.

use super::node::{Node, Pair};
use super::strip::Strip;

/// Coefficients of a cubic, the constant first.
type Cubic = [f64; 4];

/// The patch over [0, `side`]², in pixels from the block's top left corner.
pub(super) struct CoonsPatch {
    /// Whether the map is conformal at the corners.
    conformal: bool,
    /// The polynomials of the texture's columns and rows.
    of: [Component; 2],
}

/// A polynomial of column and row: `rows[i]` is the coefficient of xⁱ as a cubic of y.
struct Component {
    rows: [Cubic; 4],
}

impl Component {
    /// The blend of the edges' cubics: top and bottom along x, left and right along y.
    fn new([top, bottom, left, right]: [Cubic; 4], side: f64) -> Self {
        let across = |k: usize| [top[k], (bottom[k] - top[k]) / side, 0.0, 0.0];
        let mut rows = [across(0), across(1), across(2), across(3)];
        // What the left and right edges add to the straight lines between their ends.
        let bulge = |[_, _, c2, c3]: Cubic| [0.0, -(c3 * side + c2) * side, c2, c3];
        let (left, right) = (bulge(left), bulge(right));
        for k in 1..4 {
            rows[0][k] += left[k];
            rows[1][k] += (right[k] - left[k]) / side;
        }
        Self { rows }
    }

    /// The cubic along the row at height y.
    fn row(&self, y: f64) -> Cubic {
        self.rows.map(|cubic| value(&cubic, y))
    }

    /// The cubic ∂/∂y along the row at height y.
    fn down(&self, y: f64) -> Cubic {
        self.rows.map(|cubic| slope(&cubic, y))
    }
}

impl CoonsPatch {
    /// `corners`: top left, top right, bottom left, bottom right.
    pub fn new(corners: [&Node; 4], side: f64) -> Self {
        let [a, b, c, d] = corners;
        let component = |k: usize| {
            let top = hermite(a.at[k], a.dx[k], b.at[k], b.dx[k], side);
            let bottom = hermite(c.at[k], c.dx[k], d.at[k], d.dx[k], side);
            let left = hermite(a.at[k], a.dy[k], c.at[k], c.dy[k], side);
            let right = hermite(b.at[k], b.dy[k], d.at[k], d.dy[k], side);
            Component::new([top, bottom, left, right], side)
        };
        let conformal = corners.into_iter().all(Node::is_conformal);
        Self { conformal, of: [component(0), component(1)] }
    }

    /// The texture's point at the top left corner.
    pub fn corner(&self) -> Pair {
        [self.of[0].rows[0][0], self.of[1].rows[0][0]]
    }

    /// The patch at (x, y) pixels from its top left corner.
    pub fn node(&self, x: f64, y: f64) -> Node {
        let (rows, down) = (self.of.each_ref().map(|c| c.row(y)), self.of.each_ref().map(|c| c.down(y)));
        let at = |cubics: &[Cubic; 2]| cubics.each_ref().map(|cubic| value(cubic, x));
        Node { at: at(&rows), dx: rows.each_ref().map(|cubic| slope(cubic, x)), dy: at(&down) }
    }

    /// Writes one row of the block: pixels `start..start + count` of the strip, whose centres lie at columns ½, 1½, …
    /// and height `y` of the patch. `shift` texels are taken off first, to keep single precision exact.
    pub fn draw_row(&self, strip: &mut Strip, start: usize, count: usize, y: f64, shift: Pair) {
        let span = start..start + count;
        let [u, v] = [0, 1].map(|k| {
            let [constant, rest @ ..] = self.of[k].row(y);
            let [c1, c2, c3] = rest;
            [constant - shift[k], c1, c2, c3]
        });
        write(&mut strip.u[span.clone()], &u);
        write(&mut strip.v[span.clone()], &v);
        if strip.has_levels() && self.conformal {
            write_conformal_levels(&mut strip.level[span.clone()], [&u, &v].map(derivative));
        }
        if strip.has_jacobian() || strip.has_levels() && !self.conformal {
            let [dx, dy] = [[&u, &v].map(derivative), self.of.each_ref().map(|c| c.down(y))];
            let jacobian = [&dx[0], &dx[1], &dy[0], &dy[1]];
            for (plane, cubic) in strip.jacobian.iter_mut().zip(jacobian) {
                if let Some(plane) = plane.get_mut(span.clone()) {
                    write(plane, cubic);
                }
            }
            if !self.conformal {
                write_levels(&mut strip.level[span], jacobian);
            }
        }
    }
}

/// The cubic with values a, b and slopes da, db at 0 and h.
fn hermite(a: f64, da: f64, b: f64, db: f64, h: f64) -> Cubic {
    let mean = (b - a) / h;
    [a, da, (3.0 * mean - 2.0 * da - db) / h, (da + db - 2.0 * mean) / (h * h)]
}

fn value(c: &Cubic, x: f64) -> f64 {
    ((c[3] * x + c[2]) * x + c[1]) * x + c[0]
}

fn slope(c: &Cubic, x: f64) -> f64 {
    (3.0 * c[3] * x + 2.0 * c[2]) * x + c[1]
}

fn derivative(c: &Cubic) -> Cubic {
    [c[1], 2.0 * c[2], 3.0 * c[3], 0.0]
}

fn write(span: &mut [f32], cubic: &Cubic) {
    let [c0, c1, c2, c3] = cubic.map(|c| c as f32);
    for (column, value) in span.iter_mut().enumerate() {
        let x = column as i32 as f32 + 0.5;
        *value = ((c3 * x + c2) * x + c1) * x + c0;
    }
}

/// log₂ of the length of ∂/∂x along a row: |f'|.
fn write_conformal_levels(span: &mut [f32], dx: [Cubic; 2]) {
    let [[u0, u1, u2, _], [v0, v1, v2, _]] = dx.map(|cubic| cubic.map(|c| c as f32));
    for (column, level) in span.iter_mut().enumerate() {
        let x = column as i32 as f32 + 0.5;
        let (u, v) = ((u2 * x + u1) * x + u0, (v2 * x + v1) * x + v0);
        *level = 0.5 * log2(u * u + v * v);
    }
}

/// log₂ of the larger singular value of the Jacobian along a row.
fn write_levels(span: &mut [f32], jacobian: [&Cubic; 4]) {
    let [ux, vx, uy, vy] = jacobian.map(|cubic| cubic.map(|c| c as f32));
    let at = |[c0, c1, c2, c3]: [f32; 4], x: f32| ((c3 * x + c2) * x + c1) * x + c0;
    for (column, level) in span.iter_mut().enumerate() {
        let x = column as i32 as f32 + 0.5;
        let (ux, vx, uy, vy) = (at(ux, x), at(vx, x), at(uy, x), at(vy, x));
        let (p, q, r, s) = (ux + vy, vx - uy, ux - vy, vx + uy);
        *level = log2(0.5 * ((p * p + q * q).sqrt() + (r * r + s * s).sqrt()));
    }
}

/// log₂ x for x ≥ 0 with an error below 2e-4 and no step: the exponent, and a quartic through the ends of each octave.
pub(super) fn log2(x: f32) -> f32 {
    let bits = x.to_bits() as i32;
    let exponent = ((bits >> 23) - 127) as f32;
    let m = f32::from_bits((bits & 0x007f_ffff) as u32 | 0x3f80_0000) - 1.0;
    exponent + m + m * (1.0 - m) * (0.438_725_68 + m * (-0.239_057_98 + m * 0.082_130_44))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log2_is_close_and_has_no_step() {
        for k in -4000..4000 {
            let x = (f64::from(k) / 200.0).exp2();
            assert!((f64::from(log2(x as f32)) - f64::from(k) / 200.0).abs() < 2e-4, "{x}");
        }
        assert!((log2(f32::from_bits(0x4000_0000 - 1)) - log2(2.0)).abs() < 1e-6);
        assert!(log2(0.0) < -126.0);
    }

    /// (x + iy)ⁿ about a point, in the patch's units.
    fn power(n: i32, x: f64, y: f64) -> Node {
        let z = num_complex::Complex64::new(0.05 * x - 0.3, 0.05 * y + 0.7);
        let (w, d) = (z.powi(n), z.powi(n - 1) * f64::from(n) * 0.05);
        Node { at: [w.re, w.im], dx: [d.re, d.im], dy: [-d.im, d.re] }
    }

    fn error(n: i32, side: f64) -> f64 {
        let corners = [(0.0, 0.0), (side, 0.0), (0.0, side), (side, side)].map(|(x, y)| power(n, x, y));
        let patch = CoonsPatch::new([&corners[0], &corners[1], &corners[2], &corners[3]], side);
        let at = [0.1, 0.35, 0.5, 0.8].map(|t| t * side);
        let pairs = at.into_iter().flat_map(|x| at.map(|y| (x, y)));
        let gaps = pairs.map(|(x, y)| {
            let (p, q) = (patch.node(x, y), power(n, x, y));
            (p.at[0] - q.at[0]).hypot(p.at[1] - q.at[1])
        });
        gaps.fold(0.0, f64::max)
    }

    #[test]
    fn cubics_are_exact_and_the_error_falls_as_the_fourth_power() {
        assert!(error(1, 4.0) < 1e-14 && error(2, 4.0) < 1e-14 && error(3, 4.0) < 1e-14);
        let order = (error(7, 2.0) / error(7, 1.0)).log2();
        assert!((order - 4.0).abs() < 0.3, "order {order}");
    }

    #[test]
    fn the_patch_differentiates_itself() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (4.0, 4.0)].map(|(x, y)| power(5, x, y));
        let patch = CoonsPatch::new([&corners[0], &corners[1], &corners[2], &corners[3]], 4.0);
        let (x, y, h) = (1.3, 2.9, 1e-5);
        let node = patch.node(x, y);
        for k in 0..2 {
            let dx = (patch.node(x + h, y).at[k] - patch.node(x - h, y).at[k]) / (2.0 * h);
            let dy = (patch.node(x, y + h).at[k] - patch.node(x, y - h).at[k]) / (2.0 * h);
            assert!((dx - node.dx[k]).abs() < 1e-9 && (dy - node.dy[k]).abs() < 1e-9);
        }
    }
}
