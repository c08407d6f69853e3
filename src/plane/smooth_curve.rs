//! Smooth closed curves through given points, by trigonometric interpolation.

use super::{BoundaryPoint, Complex64, Polygon};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// The closed curve z(t) = Σ cₖ e^{ikt}, |k| ≤ n/2, through n points at t = 2πj/n; counter-clockwise and simple.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothCurve {
    /// c₋ₘ … cₘ.
    coefficients: Vec<Complex64>,
    /// m.
    highest: i32,
    /// The points it was made from.
    points: Vec<Complex64>,
    /// The curve finely sampled: where it roughly is.
    outline: Polygon,
}

/// Samples of the outline for each point given.
const OVERSAMPLING: usize = 8;

impl SmoothCurve {
    /// The curve through `points`; they are put in counter-clockwise order, the first one first.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooFewVertices`], and [`Error::SelfIntersecting`] if the curve (not only the polygon
    /// of its points) crosses itself; its edges are counted from one given point to the next.
    pub fn new(points: &[Complex64]) -> Result<Self> {
        if let Some(index) = points.iter().position(|z| !z.is_finite()) {
            return Err(Error::NotFinite { what: format!("Boundary point {index}") });
        }
        let mut points = points.to_vec();
        points.dedup();
        if points.len() > 1 && points[0] == points[points.len() - 1] {
            points.pop();
        }
        if points.len() < 3 {
            return Err(Error::TooFewVertices { found: points.len() });
        }
        let mut curve = Self::through(points)?;
        if curve.outline.vertices()[1] != curve.point(TAU / (OVERSAMPLING * curve.points.len()) as f64) {
            // The outline came out reversed, so the points run clockwise.
            curve.points[1..].reverse();
            curve = Self::through(curve.points)?;
        }
        Ok(curve)
    }

    fn through(points: Vec<Complex64>) -> Result<Self> {
        let n = points.len();
        let highest = (n / 2) as i32;
        let mut coefficients: Vec<Complex64> = (-highest..=highest).map(|k| fourier_coefficient(&points, k)).collect();
        if n.is_multiple_of(2) {
            // Shared between the two waves of the highest frequency, which look alike at the points.
            let last = coefficients.len() - 1;
            coefficients[0] *= 0.5;
            coefficients[last] *= 0.5;
        }
        let samples = OVERSAMPLING * n;
        let at = |j: usize| evaluate(&coefficients, highest, TAU * j as f64 / samples as f64, 0);
        let outline = Polygon::new(&(0..samples).map(at).collect::<Vec<_>>()).map_err(|error| match error {
            Error::SelfIntersecting { first, second, at } => {
                Error::SelfIntersecting { first: first / OVERSAMPLING, second: second / OVERSAMPLING, at }
            }
            other => other,
        })?;
        Ok(Self { coefficients, highest, points, outline })
    }

    /// The points it was made from, counter-clockwise.
    #[must_use]
    pub fn points(&self) -> &[Complex64] {
        &self.points
    }

    /// The polygon of fine samples.
    #[must_use]
    pub fn outline(&self) -> &Polygon {
        &self.outline
    }

    /// z(t).
    #[must_use]
    pub fn point(&self, t: f64) -> Complex64 {
        evaluate(&self.coefficients, self.highest, t, 0)
    }

    /// z'(t).
    #[must_use]
    pub fn tangent(&self, t: f64) -> Complex64 {
        evaluate(&self.coefficients, self.highest, t, 1)
    }

    /// The parameter of a place between two given points.
    #[must_use]
    pub fn parameter(&self, place: BoundaryPoint) -> f64 {
        TAU * (place.edge as f64 + place.t) / self.points.len() as f64
    }

    /// The place of a parameter between two given points.
    #[must_use]
    pub fn place(&self, t: f64) -> BoundaryPoint {
        let n = self.points.len();
        let steps = t.rem_euclid(TAU) / TAU * n as f64;
        let edge = (steps as usize).min(n - 1);
        let share = steps - edge as f64;
        let point = if share == 0.0 { self.points[edge] } else { self.point(t) };
        BoundaryPoint { edge, t: share, point }
    }

    /// The parameter of the point of the curve nearest to `z`: Newton's method for Re (z(t) − z)·conj z'(t) = 0 from the
    /// nearest point of the outline.
    #[must_use]
    pub fn nearest_parameter(&self, z: Complex64) -> f64 {
        let start = self.outline.nearest(z);
        let step = TAU / self.outline.len() as f64;
        let first = (start.edge as f64 + start.t) * step;
        let mut t = first;
        for _ in 0..8 {
            let (gap, tangent) = (self.point(t) - z, self.tangent(t));
            let bend = evaluate(&self.coefficients, self.highest, t, 2);
            let slope = tangent.norm_sqr() + (gap * bend.conj()).re;
            let newton = -(gap * tangent.conj()).re / slope;
            if !newton.is_finite() || slope <= 0.0 {
                break;
            }
            t = (t + newton).clamp(first - step, first + step);
        }
        t.rem_euclid(TAU)
    }

    /// Whether `z` lies inside or on the curve.
    #[must_use]
    pub fn contains(&self, z: Complex64) -> bool {
        self.signed_distance(z) >= -1e-15 * self.outline.size()
    }

    /// Distance from the curve, positive inside, as precise as rounding allows near it.
    #[must_use]
    pub fn signed_distance(&self, z: Complex64) -> f64 {
        if !z.is_finite() {
            return f64::NEG_INFINITY;
        }
        let t = self.nearest_parameter(z);
        let (gap, tangent) = (z - self.point(t), self.tangent(t));
        let across = (gap * tangent.conj()).im / tangent.norm();
        // Far from the curve the sampled outline decides, whatever Newton's method found.
        let inside = if across.abs() < 0.1 * self.outline.size() / self.points.len() as f64 {
            across >= 0.0
        } else {
            self.outline.contains(z)
        };
        if inside { gap.norm() } else { -gap.norm() }
    }
}

/// (1/n) Σ z_j e^{−2πijk/n}.
fn fourier_coefficient(points: &[Complex64], k: i32) -> Complex64 {
    let n = points.len() as i64;
    let wave = |j: usize| Complex64::cis(-TAU * (i64::from(k) * j as i64).rem_euclid(n) as f64 / n as f64);
    points.iter().enumerate().map(|(j, z)| z * wave(j)).sum::<Complex64>() / n as f64
}

/// The derivative of the given order of Σ cₖ e^{ikt}, by Horner's rule in e^{it}.
fn evaluate(coefficients: &[Complex64], highest: i32, t: f64, order: i32) -> Complex64 {
    let turn = Complex64::cis(t);
    let wave_factor = |index: usize| Complex64::new(0.0, f64::from(index as i32 - highest)).powi(order);
    let terms = coefficients.iter().enumerate().rev();
    let sum = terms.fold(Complex64::ZERO, |sum, (index, c)| sum * turn + c * wave_factor(index));
    sum * Complex64::cis(-f64::from(highest) * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ellipse(n: usize, clockwise: bool) -> Vec<Complex64> {
        let sign = if clockwise { -1.0 } else { 1.0 };
        let at = |j: usize| TAU * j as f64 / n as f64;
        (0..n).map(|j| Complex64::new(2.0 * at(j).cos(), sign * at(j).sin())).collect()
    }

    #[test]
    fn passes_through_its_points_and_between_them() {
        for n in [9, 16] {
            let curve = SmoothCurve::new(&ellipse(n, false)).unwrap();
            for t in [0.0_f64, 0.3, 2.0, 5.5] {
                let exact = Complex64::new(2.0 * t.cos(), t.sin());
                assert!((curve.point(t) - exact).norm() < 1e-14);
                assert!((curve.tangent(t) - Complex64::new(-2.0 * t.sin(), t.cos())).norm() < 1e-13);
            }
        }
    }

    #[test]
    fn clockwise_points_are_reversed() {
        let curve = SmoothCurve::new(&ellipse(12, true)).unwrap();
        assert!((curve.point(0.5) - Complex64::new(2.0 * 0.5f64.cos(), 0.5f64.sin())).norm() < 1e-14);
        assert_eq!(curve.points()[0], Complex64::new(2.0, 0.0));
    }

    #[test]
    fn sides_are_told_apart_close_to_the_curve() {
        let curve = SmoothCurve::new(&ellipse(24, false)).unwrap();
        for t in [0.1, 1.0, 3.0, 4.4] {
            let (z, normal) = (curve.point(t), curve.tangent(t) * Complex64::i() / curve.tangent(t).norm());
            for depth in [1e-12, 1e-6, 0.3] {
                let inside = curve.signed_distance(z + normal * depth);
                assert!((inside - depth).abs() < 1e-14 + 1e-9 * depth, "{t} {depth}: {inside}");
                assert!((curve.signed_distance(z - normal * depth) + depth).abs() < 1e-14 + 1e-9 * depth);
            }
        }
        assert!(!curve.contains(Complex64::new(30.0, 1.0)) && curve.contains(Complex64::ZERO));
        assert!(!curve.contains(Complex64::new(f64::NAN, 0.0)));
    }

    #[test]
    fn a_curve_that_crosses_itself_is_refused() {
        let eight: Vec<_> =
            (0..32).map(|j| TAU * f64::from(j) / 32.0).map(|t| Complex64::new(t.sin(), (2.0 * t).sin())).collect();
        assert_eq!(SmoothCurve::new(&eight).unwrap_err().code(), "self-intersecting");
    }
}
