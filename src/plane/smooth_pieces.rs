//! A smooth curve as a chain of edges, for boundaries of which other components have edges and corners.

use super::polygon::origin_of;
use super::{Complex64, Edge, SmoothCurve};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// The smooth curve through points ([`Curve::Smooth`](super::Curve::Smooth)) as a closed chain of cubic Bézier curves, no farther
/// from it than a few 10⁻¹³ of its size: a boundary may have it beside polygons and other edges.
///
/// ```
/// use conformal_warp::{AnnulusMap, Complex64, Domain, Edge, SolveOptions, smooth_edges};
/// use std::f64::consts::TAU;
/// let circle: Vec<_> = (0..32).map(|k| Complex64::from_polar(0.5, TAU * f64::from(k) / 32.0)).collect();
/// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let square: Vec<_> = (0..4).map(|k| Edge::line(corners[k], corners[(k + 1) % 4])).collect();
/// let domain = Domain::from_edges(&square, &[smooth_edges(&circle)?])?;
/// let ring = AnnulusMap::solve(&domain, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!(ring.inner_radius() < 0.5 && ring.inner_radius() > 0.46);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
///
/// # Errors
/// Those of [`SmoothCurve::new`]; [`Error::InvalidOutline`] where the curve turns back on itself.
pub fn smooth_edges(points: &[Complex64]) -> Result<Vec<Edge>> {
    // Far from 0 coordinates have not the digits that pieces are fitted to.
    let origin = if points.iter().all(|z| z.is_finite()) { origin_of(points) } else { Complex64::ZERO };
    let curve = SmoothCurve::new(&points.iter().map(|z| z - origin).collect::<Vec<_>>())?;
    let pieces = FEWEST.max(2 * curve.waves());
    let share = TAU / pieces as f64;
    let mut edges = Vec::new();
    for k in 0..pieces {
        add(&curve, [k as f64 * share, (k + 1) as f64 * share], DEEPEST, &mut edges)?;
    }
    Ok(edges.iter().map(|edge| edge.moved(origin)).collect())
}

/// The largest distance of a piece from the curve, as a share of the curve's size.
const CLOSE: f64 = 1e-13;
/// Pieces to begin with, unless the curve has many waves.
const FEWEST: usize = 8;
/// They are halved so often; what is not close then has a point at which the curve stands still.
const DEEPEST: u32 = 12;
/// Steps that fit one piece: it converges quadratically.
const STEPS: usize = 5;
/// Places at which a piece is fitted, by its parameter.
const PLACES: [f64; 5] = [0.15, 0.325, 0.5, 0.675, 0.85];

/// Adds the part of the curve between two parameters, in pieces that are close to it.
fn add(curve: &SmoothCurve, [from, to]: [f64; 2], depth: u32, edges: &mut Vec<Edge>) -> Result<()> {
    let (piece, distance) = fitted(curve, [from, to]);
    if distance <= CLOSE * curve.outline().size() {
        edges.push(piece);
        return Ok(());
    }
    if depth == 0 {
        return Err(Error::InvalidOutline { reason: "the smooth curve through its points turns back".to_string() });
    }
    let middle = 0.5 * (from + to);
    add(curve, [from, middle], depth - 1, edges)?;
    add(curve, [middle, to], depth - 1, edges)
}

/// The cubic with the curve's ends and directions between two parameters whose arms, the distances of the inner control points
/// from the ends, bring it nearest to the curve; and the largest distance found. Two free lengths leave the sixth power of the
/// piece's length.
fn fitted(curve: &SmoothCurve, [from, to]: [f64; 2]) -> (Edge, f64) {
    let [a, b] = [from, to].map(|t| curve.place(t).point);
    let [start, end] = [from, to].map(|t| curve.tangent(t));
    let third = (to - from) / 3.0;
    let mut arms = [start.norm() * third, end.norm() * third];
    let [start, end] = [start / start.norm(), end / end.norm()];
    let cubic = |[first, last]: [f64; 2]| [a, a + first * start, b - last * end, b];
    let mut best = (Edge::Cubic(cubic(arms)), f64::INFINITY);
    for _ in 0..STEPS {
        let control = cubic(arms);
        // Normal equations of the distances, linear in the arms' changes.
        let (mut matrix, mut rhs, mut farthest) = ([0.0; 3], [0.0; 2], 0.0f64);
        for u in PLACES {
            let v = 1.0 - u;
            let z = control[0] * (v * v * v)
                + control[1] * (3.0 * u * v * v)
                + control[2] * (3.0 * u * u * v)
                + control[3] * (u * u * u);
            let (distance, along) = across(curve, z, from + (to - from) * u);
            let slopes = [(start * along.conj()).im * 3.0 * u * v * v, -(end * along.conj()).im * 3.0 * u * u * v];
            matrix = [
                matrix[0] + slopes[0] * slopes[0],
                matrix[1] + slopes[0] * slopes[1],
                matrix[2] + slopes[1] * slopes[1],
            ];
            rhs = [rhs[0] - slopes[0] * distance, rhs[1] - slopes[1] * distance];
            farthest = farthest.max(distance.abs());
        }
        if farthest >= best.1 {
            break;
        }
        best = (Edge::Cubic(control), farthest);
        // Where the curve is nearly straight any arms do: they stay as they are.
        let damping = 1e-12 * (matrix[0] + matrix[2]) + f64::MIN_POSITIVE;
        let [p, q, r] = [matrix[0] + damping, matrix[1], matrix[2] + damping];
        let determinant = p * r - q * q;
        arms[0] += (rhs[0] * r - rhs[1] * q) / determinant;
        arms[1] += (rhs[1] * p - rhs[0] * q) / determinant;
        if !(arms[0] > 0.0 && arms[1] > 0.0) {
            break;
        }
    }
    best
}

/// How far to the left of the curve a point lies, near a parameter, and the curve's direction there.
fn across(curve: &SmoothCurve, z: Complex64, near: f64) -> (f64, Complex64) {
    let mut t = near;
    for _ in 0..3 {
        let tangent = curve.tangent(t);
        t -= ((curve.point(t) - z) / tangent).re;
    }
    let along = curve.tangent(t);
    let along = along / along.norm();
    (((z - curve.point(t)) * along.conj()).im, along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::CurvedOutline;

    fn around(n: usize, curve: impl Fn(f64) -> Complex64) -> Vec<Complex64> {
        (0..n).map(|k| curve(TAU * k as f64 / n as f64)).collect()
    }

    #[test]
    fn pieces_follow_the_curve_to_rounding() {
        let curves = [
            (16, around(16, Complex64::cis)),
            (64, around(64, |t| Complex64::new(3.0 * t.cos(), t.sin()))),
            // With inflections, far from 0.
            (96, around(96, |t| Complex64::from_polar(1.0 + 0.3 * (3.0 * t).cos(), t) + 1000.0)),
        ];
        for (n, points) in curves {
            let curve = SmoothCurve::new(&points).unwrap();
            let edges = smooth_edges(&points).unwrap();
            assert!(edges.len() <= 8 * n, "{n}: {} pieces", edges.len());
            let outline = CurvedOutline::new(&edges).unwrap();
            let size = curve.outline().size() + 1e-3 * points[0].norm();
            for edge in outline.edges() {
                for k in 0..=20 {
                    let z = edge.point(f64::from(k) / 20.0);
                    assert!(curve.signed_distance(z).abs() < 3e-13 * size, "{n}: {:e}", curve.signed_distance(z));
                }
            }
            let turn = |k: usize| (outline.alpha(k) - 1.0).abs();
            assert!((0..edges.len()).all(|k| turn(k) < 1e-12 * points[0].norm()), "no corners");
            assert!((edges[0].from() - curve.points()[0]).norm() < 1e-15 * points[0].norm());
        }
    }
}
