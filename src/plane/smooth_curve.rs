//! Smooth closed curves through given points, by trigonometric interpolation.

use super::fourier::{sum_of_waves, transform};
use super::lie::Lie;
use super::polygon::{ON_BOUNDARY, origin_of};
use super::{BoundaryPoint, Complex64, Polygon};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// The closed curve z(t) = Σ cₖ e^{ikt}, |k| ≤ n/2, through n points at t = 2πj/n; counter-clockwise and simple. Waves that
/// only rounding made are left out.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothCurve {
    /// c₋ₘ … cₘ, of z − `origin`.
    coefficients: Vec<Complex64>,
    /// m.
    highest: i32,
    origin: Complex64,
    tail: Tail,
    /// The points it was made from.
    points: Vec<Complex64>,
    /// The curve finely sampled: where it roughly is.
    outline: Polygon,
}

/// What the spectrum says of waves that are too short for the points to show.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tail {
    /// Sum of their sizes, about.
    size: f64,
    /// The factor by which waves shrink over an eighth of the points.
    ratio: f64,
}

/// Samples of the outline for each wave.
const OVERSAMPLING: usize = 8;
/// Fewest samples of the outline.
const LEAST_SAMPLES: usize = 64;
/// The sum of all waves that rounding makes of n points of size 1 is at most this times √n.
const NOISE: f64 = 8.0 * f64::EPSILON;
/// Waves that do not fall faster than this are those of a corner, whose sum goes on for long.
const SLOWEST: f64 = 0.75;
/// The sum of the waves beyond the last is at most this times what their fall predicts.
const DOUBT: f64 = 2.0;
/// Newton's method for the nearest point takes so many steps at most,
const MOST_STEPS: usize = 8;
/// and after one this small, in radians, there is nothing left to do.
const SETTLED: f64 = 1e-10;
/// Farther from the curve than this share of its size over the number of samples, the sampled outline tells inside from outside.
const FAR: f64 = 0.8;
/// A curve that the points leave open by more than this share of its size is not known well enough to cross itself.
const UNKNOWN: f64 = 1e-5;

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
        // The area that the points enclose, twice.
        let origin = points[0];
        let cross = |a: Complex64, b: Complex64| (a.conj() * b).im;
        let area: f64 = points.windows(2).map(|pair| cross(pair[0] - origin, pair[1] - origin)).sum();
        if area < 0.0 {
            points[1..].reverse();
        }
        Self::through(points)
    }

    fn through(points: Vec<Complex64>) -> Result<Self> {
        let n = points.len();
        let origin = origin_of(&points);
        let relative: Vec<Complex64> = points.iter().map(|z| z - origin).collect();
        let size = relative.iter().map(|z| z.norm()).fold(0.0, f64::max);
        let spectrum: Vec<Complex64> = transform(&relative).iter().map(|c| c / n as f64).collect();
        // When the number is even, the two waves of the highest frequency look alike at the points, and share its coefficient.
        let wave = |k: usize| {
            let pair = [spectrum[(n - k) % n], spectrum[k % n]];
            if 2 * k == n { pair.map(|c| c * 0.5) } else { pair }
        };
        let sizes: Vec<f64> = (0..=n / 2).map(|k| wave(k).iter().map(|c| c.norm()).sum()).collect();
        let noise = NOISE * (n as f64).sqrt() * size;
        let (mut highest, mut left_out) = (n / 2, 0.0);
        while highest > 1 && left_out + sizes[highest] <= noise {
            left_out += sizes[highest];
            highest -= 1;
        }
        // Every other wave of a symmetric curve may be absent.
        let falls_to_noise = highest + sizes.len().div_ceil(4) <= n / 2;
        let tail = if falls_to_noise { Tail { size: left_out, ratio: 0.0 } } else { Tail::of(&sizes) };
        let waves = (1..=highest).rev().map(|k| wave(k)[0]).chain((0..=highest).map(|k| wave(k)[1]));
        let coefficients: Vec<Complex64> = waves.collect();
        let outline = outline_of(&coefficients, origin).map_err(|error| match error {
            Error::SelfIntersecting { .. } if tail.size > UNKNOWN * size && Polygon::new(&points).is_ok() => {
                Error::TooFewPoints { given: n, needed: tail.points_for(UNKNOWN * size, n) }
            }
            Error::SelfIntersecting { first, second, at } => {
                let edge = |sample: usize| sample * n / samples_for(highest);
                Error::SelfIntersecting { first: edge(first), second: edge(second), at }
            }
            other => other,
        })?;
        Ok(Self { coefficients, highest: highest as i32, origin, tail, points, outline })
    }

    /// The same curve, `by` plane units away; that should be no farther from 0 than this one.
    pub(crate) fn moved(&self, by: Complex64) -> Self {
        Self {
            origin: self.origin + by,
            points: self.points.iter().map(|z| z + by).collect(),
            outline: self.outline.moved(by),
            ..self.clone()
        }
    }

    /// By how much more than other points of its size a point of the curve is rounded, with what the waves lack that were
    /// left out.
    pub(crate) fn rounding(&self) -> f64 {
        1.0 + NOISE / ON_BOUNDARY * (self.points.len() as f64).sqrt()
    }

    /// Estimate of how far the curve is from the one that its points were taken from, which interpolation cannot know: from
    /// the fall of its waves.
    #[must_use]
    pub fn uncertainty(&self) -> f64 {
        self.tail.size
    }

    /// So many points, spread as these are, would make [`SmoothCurve::uncertainty`] as small as `uncertainty`, about.
    #[must_use]
    pub fn points_for(&self, uncertainty: f64) -> usize {
        self.tail.points_for(uncertainty, self.points.len())
    }

    /// The number m of the shortest waves: z(t) is a sum of e^{ikt} with |k| ≤ m.
    #[must_use]
    pub fn waves(&self) -> usize {
        self.highest as usize
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

    /// Parameter → curve: z(t), 2π-periodic in t.
    #[must_use]
    pub fn point(&self, t: f64) -> Complex64 {
        self.origin + self.jet(t)[0]
    }

    /// The derivative z'(t), which points along the curve.
    #[must_use]
    pub fn tangent(&self, t: f64) -> Complex64 {
        self.jet(t)[1]
    }

    /// Σ cₖ e^{ikt}, of z − `origin`, and its first two derivatives, by Horner's rule in e^{it}.
    fn jet(&self, t: f64) -> [Complex64; 3] {
        let (turn, i) = (Complex64::cis(t), Complex64::i());
        let [mut value, mut slope, mut bend] = [Complex64::ZERO; 3];
        for (index, c) in self.coefficients.iter().enumerate().rev() {
            let wave = f64::from(index as i32 - self.highest);
            let along = i * c * wave;
            value = value * turn + c;
            slope = slope * turn + along;
            bend = bend * turn + i * along * wave;
        }
        let back = Complex64::cis(-f64::from(self.highest) * t);
        [value * back, slope * back, bend * back]
    }

    /// Place between two given points → parameter t in [0, 2π].
    #[must_use]
    pub fn parameter(&self, place: BoundaryPoint) -> f64 {
        TAU * (place.edge as f64 + place.t) / self.points.len() as f64
    }

    /// Parameter t, in radians → place between two given points; the inverse of [`SmoothCurve::parameter`].
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
        self.parameter_near(z, self.outline.nearest(z))
    }

    /// The same from the nearest point of the outline.
    fn parameter_near(&self, z: Complex64, start: BoundaryPoint) -> f64 {
        let step = TAU / self.outline.len() as f64;
        let first = (start.edge as f64 + start.t) * step;
        let mut t = first;
        for _ in 0..MOST_STEPS {
            let [point, tangent, bend] = self.jet(t);
            let gap = self.origin + point - z;
            let slope = tangent.norm_sqr() + (gap * bend.conj()).re;
            let newton = -(gap * tangent.conj()).re / slope;
            if !newton.is_finite() || slope <= 0.0 {
                break;
            }
            t = (t + newton).clamp(first - step, first + step);
            if newton.abs() < SETTLED {
                break;
            }
        }
        t.rem_euclid(TAU)
    }

    /// Whether `z` lies inside, outside, or on the curve, as near to it as `thickness`.
    #[must_use]
    pub(crate) fn lie(&self, z: Complex64, thickness: f64) -> Lie {
        let start = self.outline.nearest(z);
        let is_far = (start.point - z).norm() > FAR * self.outline.size() / self.outline.len() as f64;
        let inside = if is_far {
            self.outline.contains(z)
        } else {
            let t = self.parameter_near(z, start);
            let [point, tangent, _] = self.jet(t);
            let gap = z - self.origin - point;
            if gap.norm() <= thickness {
                return Lie::On(self.place(t));
            }
            (gap * tangent.conj()).im >= 0.0
        };
        if inside { Lie::Inside } else { Lie::Outside }
    }

    /// Distance from the curve in plane units, positive inside, as precise as rounding allows near it.
    #[must_use]
    pub fn signed_distance(&self, z: Complex64) -> f64 {
        if !z.is_finite() {
            return f64::NEG_INFINITY;
        }
        let t = self.nearest_parameter(z);
        let (gap, tangent) = (z - self.point(t), self.tangent(t));
        let across = (gap * tangent.conj()).im / tangent.norm();
        // Far from the curve the sampled outline decides, whatever Newton's method found.
        let inside = if across.abs() < FAR * self.outline.size() / self.outline.len() as f64 {
            across >= 0.0
        } else {
            self.outline.contains(z)
        };
        if inside { gap.norm() } else { -gap.norm() }
    }
}

impl Tail {
    /// The tail told by the sizes of all waves that the points show, longest first.
    fn of(sizes: &[f64]) -> Self {
        let (m, eighth) = (sizes.len() - 1, sizes.len().div_ceil(4));
        let sum = |part: &[f64]| part.iter().sum::<f64>();
        let last = sum(&sizes[m + 1 - eighth..]);
        let before = sum(&sizes[(m + 1).saturating_sub(2 * eighth).max(1)..m + 1 - eighth]);
        // Where waves are few, some may be absent by chance.
        let ratio = (last / before).clamp((4.0 / (m * m) as f64).min(SLOWEST), SLOWEST);
        Self { size: DOUBT * last * ratio / (1.0 - ratio), ratio }
    }

    /// How many points would leave a tail of `size`, of which there are `n`.
    fn points_for(self, size: f64, n: usize) -> usize {
        let eighths = if self.size > size { (size / self.size).ln() / self.ratio.ln() } else { 0.0 };
        (n as f64 * (1.0 + eighths / 4.0)).ceil() as usize
    }
}

/// How finely a curve of waves up to `highest` is sampled: a power of two.
fn samples_for(highest: usize) -> usize {
    (OVERSAMPLING * (2 * highest + 1)).max(LEAST_SAMPLES).next_power_of_two()
}

/// The curve with the coefficients c₋ₘ … cₘ, finely sampled.
fn outline_of(coefficients: &[Complex64], origin: Complex64) -> Result<Polygon> {
    let highest = coefficients.len() / 2;
    let samples = samples_for(highest);
    let mut spectrum = vec![Complex64::ZERO; samples];
    for (index, c) in coefficients.iter().enumerate() {
        spectrum[(samples + index - highest) % samples] = *c;
    }
    Polygon::new(&sum_of_waves(&spectrum).iter().map(|z| origin + z).collect::<Vec<_>>())
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
        for (z, inside) in
            [(Complex64::new(30.0, 1.0), false), (Complex64::ZERO, true), (Complex64::new(f64::NAN, 0.0), false)]
        {
            assert_eq!(curve.signed_distance(z) > 0.0, inside);
        }
    }

    #[test]
    fn a_curve_that_crosses_itself_is_refused() {
        let eight: Vec<_> =
            (0..32).map(|j| TAU * f64::from(j) / 32.0).map(|t| Complex64::new(t.sin(), (2.0 * t).sin())).collect();
        assert_eq!(SmoothCurve::new(&eight).unwrap_err().code(), "self-intersecting");
    }
}
