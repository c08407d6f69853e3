//! A curve through points: cubic splines between the corners, smooth elsewhere.

use super::{Complex64, Edge};
use crate::{Error, Result};

/// The closed curve through `points`, in their order, with corners at those of the given indices and smooth at the others: between
/// two corners the cubic spline that is twice differentiable, its parameter the length of the chords, and its third derivative
/// continuous next to the corners (not-a-knot); without corners the periodic one. An edge for each point, from it to the next.
///
/// It leaves a smooth curve through the same points by the fourth power of their distance.
///
/// ```
/// use conformal_warp::{Complex64, Region, spline};
/// use std::f64::consts::PI;
/// // The half disk: 16 points of the half circle, with corners where the diameter begins and ends.
/// let points: Vec<_> = (0..16).map(|k| Complex64::cis(PI * f64::from(k) / 15.0)).collect();
/// let region = Region::from_edges(&spline(&points, &[0, 15])?, Complex64::new(0.0, 0.5), Complex64::ONE)?;
/// assert!(region.contains(Complex64::new(0.0, 0.999)) && !region.contains(Complex64::new(0.0, -0.001)));
/// # Ok::<(), conformal_warp::Error>(())
/// ```
///
/// # Errors
/// [`Error::TooFewVertices`] for fewer than three points, [`Error::NotFinite`], [`Error::InvalidOption`] for a corner that is no
/// point's index, and [`Error::InvalidOutline`] where two neighbours are the same point.
pub fn spline(points: &[Complex64], corners: &[usize]) -> Result<Vec<Edge>> {
    let n = points.len();
    check(points, corners)?;
    let mut corners = corners.to_vec();
    corners.sort_unstable();
    corners.dedup();
    let around = |from: usize, count: usize| (0..=count).map(|k| points[(from + k) % n]).collect::<Vec<_>>();
    let Some(&first) = corners.first() else {
        return Ok(edges(&around(0, n), closed(&around(0, n))));
    };
    let mut runs = Vec::with_capacity(n);
    for (k, &from) in corners.iter().enumerate() {
        let to = corners.get(k + 1).copied().unwrap_or(first + n);
        let run = around(from, to - from);
        runs.extend(edges(&run, open(&run)));
    }
    // As the points count them.
    runs.rotate_right(first);
    Ok(runs)
}

fn check(points: &[Complex64], corners: &[usize]) -> Result<()> {
    let n = points.len();
    if n < 3 {
        return Err(Error::TooFewVertices { found: n });
    }
    if let Some(k) = points.iter().position(|z| !z.is_finite()) {
        return Err(Error::NotFinite { what: format!("Point {k}") });
    }
    if let Some(&corner) = corners.iter().find(|&&corner| corner >= n) {
        return Err(Error::InvalidOption { name: "corners", expected: "indices of points", value: corner as f64 });
    }
    match (0..n).find(|&k| points[k] == points[(k + 1) % n]) {
        Some(k) => Err(Error::InvalidOutline { reason: format!("points {k} and {} are the same", (k + 1) % n) }),
        None => Ok(()),
    }
}

/// Lengths of the chords of a run of points, and the divided differences along them.
fn chords(run: &[Complex64]) -> (Vec<f64>, Vec<Complex64>) {
    let steps = run.windows(2).map(|ends| ends[1] - ends[0]);
    steps.map(|step| (step.norm(), step / step.norm())).unzip()
}

/// The Bézier curves of a spline with these second derivatives at its points.
fn edges(run: &[Complex64], second: Vec<Complex64>) -> Vec<Edge> {
    let (h, d) = chords(run);
    let edge = |k: usize| {
        let (a, b) = (run[k], run[k + 1]);
        if second[k] == Complex64::ZERO && second[k + 1] == Complex64::ZERO {
            return Edge::line(a, b);
        }
        let start = d[k] - (2.0 * second[k] + second[k + 1]) * (h[k] / 6.0);
        let end = d[k] + (second[k] + 2.0 * second[k + 1]) * (h[k] / 6.0);
        Edge::Cubic([a, a + start * (h[k] / 3.0), b - end * (h[k] / 3.0), b])
    };
    (0..h.len()).map(edge).collect()
}

/// Second derivatives of the spline from corner to corner.
fn open(run: &[Complex64]) -> Vec<Complex64> {
    let (h, d) = chords(run);
    let last = h.len();
    if last == 1 {
        return vec![Complex64::ZERO; 2];
    }
    let bend = |k: usize| 6.0 * (d[k] - d[k - 1]);
    if last == 2 {
        // One parabola.
        return vec![bend(1) / (3.0 * (h[0] + h[1])); 3];
    }
    let mut rows: Vec<Row> = (1..last)
        .map(|k| Row { before: h[k - 1], own: 2.0 * (h[k - 1] + h[k]), after: h[k], right: bend(k) })
        .collect();
    // Next to the corners the third derivative goes on: the outermost second derivative is in line with the next two.
    let (start, end) = (h[0] / h[1], h[last - 1] / h[last - 2]);
    rows[0].own += h[0] * (1.0 + start);
    rows[0].after -= h[0] * start;
    let row = rows.len() - 1;
    rows[row].own += h[last - 1] * (1.0 + end);
    rows[row].before -= h[last - 1] * end;
    let inner = solve(rows);
    let outer = |near: Complex64, next: Complex64, ratio: f64| near + (near - next) * ratio;
    let mut second = vec![outer(inner[0], inner[1], start)];
    second.extend(&inner);
    second.push(outer(inner[row], inner[row - 1], end));
    second
}

/// Second derivatives of the periodic spline through a run that ends where it began.
fn closed(run: &[Complex64]) -> Vec<Complex64> {
    let (h, d) = chords(run);
    let n = h.len();
    let before = |k: usize| (k + n - 1) % n;
    let rows = |right: &dyn Fn(usize) -> Complex64| -> Vec<Row> {
        let row =
            |k: usize| Row { before: h[before(k)], own: 2.0 * (h[before(k)] + h[k]), after: h[k], right: right(k) };
        (0..n).map(row).collect()
    };
    // The rows are tridiagonal but for what ties the last point to the first one: a matrix of rank one, u vᵀ (Sherman and Morrison).
    let tie = h[n - 1];
    let corrected = |mut rows: Vec<Row>| {
        rows[0].own -= tie;
        rows[n - 1].own -= tie;
        solve(rows)
    };
    let free = corrected(rows(&|k| 6.0 * (d[k] - d[before(k)])));
    let tied = corrected(rows(&|k| Complex64::from(if k == 0 || k == n - 1 { tie } else { 0.0 })));
    let share = (free[0] + free[n - 1]) / (1.0 + tied[0] + tied[n - 1]);
    let mut second: Vec<_> = free.iter().zip(&tied).map(|(free, tied)| free - tied * share).collect();
    second.push(second[0]);
    second
}

/// before·xₖ₋₁ + own·xₖ + after·xₖ₊₁ = right.
struct Row {
    before: f64,
    own: f64,
    after: f64,
    right: Complex64,
}

/// A tridiagonal system, by elimination: its rows are dominated by their own entries.
fn solve(mut rows: Vec<Row>) -> Vec<Complex64> {
    for k in 1..rows.len() {
        let share = rows[k].before / rows[k - 1].own;
        rows[k].own -= share * rows[k - 1].after;
        let right = rows[k - 1].right;
        rows[k].right -= right * share;
    }
    let mut found = vec![Complex64::ZERO; rows.len()];
    for k in (0..rows.len()).rev() {
        let beyond = found.get(k + 1).map_or(Complex64::ZERO, |next| next * rows[k].after);
        found[k] = (rows[k].right - beyond) / rows[k].own;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::CurvedOutline;
    use std::f64::consts::{PI, TAU};

    /// How far the edges leave the unit circle.
    fn off(edges: &[Edge]) -> f64 {
        let places = edges.iter().flat_map(|edge| (0..20).map(|k| edge.point(f64::from(k) / 20.0)));
        places.map(|z| (z.norm() - 1.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn circles_and_half_circles_are_followed_to_the_fourth_order() {
        for end in [TAU, PI] {
            let errors = [12, 24, 48].map(|n| {
                let steps = if end == TAU { n } else { n - 1 };
                // Unevenly spaced.
                let at = |k: i32| {
                    let s = f64::from(k) / f64::from(steps);
                    Complex64::cis(end * (s + 0.03 * (TAU * s).sin()))
                };
                let points: Vec<_> = (0..n).map(at).collect();
                let corners = if end == TAU { vec![] } else { vec![0, n as usize - 1] };
                let edges = spline(&points, &corners).unwrap();
                assert_eq!(edges.len(), points.len());
                assert!(edges.iter().zip(&points).all(|(edge, point)| edge.from() == *point));
                let curved = if end == TAU { &edges[..] } else { &edges[..n as usize - 1] };
                off(curved)
            });
            let order = 0.5 * (errors[0] / errors[2]).log2();
            assert!(order > 3.6 && errors[2] < 1e-5, "{errors:?}: order {order}");
        }
    }

    #[test]
    fn corners_are_where_they_are_marked_and_nowhere_else() {
        let points: Vec<_> = (0..20)
            .map(|k| Complex64::from_polar(1.0 + 0.2 * (TAU * f64::from(k) / 10.0).cos(), TAU * f64::from(k) / 20.0))
            .collect();
        for corners in [vec![], vec![7], vec![19, 3, 3, 4]] {
            let outline = CurvedOutline::new(&spline(&points, &corners).unwrap()).unwrap();
            for k in 0..20 {
                let is_smooth = (outline.alpha(k) - 1.0).abs() < 1e-9;
                assert_eq!(is_smooth, !corners.contains(&k), "{k} of {corners:?}: {}", outline.alpha(k));
            }
        }
        // Corners alone make a polygon.
        let all: Vec<_> = (0..20).collect();
        assert!(spline(&points, &all).unwrap().iter().all(|edge| matches!(edge, Edge::Line { .. })));
    }

    #[test]
    fn what_makes_no_curve_is_refused() {
        let at = Complex64::new;
        let square = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
        assert_eq!(spline(&square[..2], &[]).unwrap_err().code(), "too-few-vertices");
        assert_eq!(spline(&square, &[4]).unwrap_err().code(), "invalid-option");
        let twice = [square[0], square[1], square[1], square[2]];
        assert!(spline(&twice, &[]).unwrap_err().to_string().contains("points 1 and 2 are the same"));
        assert_eq!(spline(&[at(f64::NAN, 0.0), square[1], square[2]], &[]).unwrap_err().code(), "not-finite");
    }
}
