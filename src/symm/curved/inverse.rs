//! The way back from the disk of a solved boundary of curved edges: beside the circle the complex measure is inverted, within
//! Cauchy's formula gives the place; where that is lost, the way there is followed from the center outwards.

use super::super::log_moments::bernstein;
use super::cauchy;
use super::solution::{Cauchy, CurvedSolution, MIDDLE, Map};
use crate::plane::Complex64;
use std::f64::consts::TAU;

/// A panel's density goes on so far beyond it: Bernstein's ρ.
const CONTINUED_BACK: f64 = 1.08;
/// Rounding in points of the region (scaled units).
const ROUNDING: f64 = 4e-15;
/// The way back errs by no more than this share of the estimate.
const POLISHED: f64 = 0.1;
/// Ways that are seen, in scaled units.
const LONG_WAY: f64 = 1e-5;
/// Steps from the center outwards are no shorter than this, as shares of the radius.
const SHORTEST_STEP: f64 = 1e-12;
/// From a good guess Newton's method takes no more steps than this, none of them shortened to less than this share.
const NEWTON_STEPS: usize = 10;
const SHORTENED: f64 = 0.1;

impl CurvedSolution {
    /// Disk (vertex 0 ↦ 1) → region, and the derivative of the way there, in scaled units; `None` where it is not found.
    #[must_use]
    pub fn from_disk(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        self.from_disk_by(w, &|w| cauchy::from_disk(self, self.parts(), w), &|z| self.to_disk(z))
    }

    /// The same with Cauchy's formula as `cauchy` sums it up, and the way there by `map`.
    #[must_use]
    pub fn from_disk_by(&self, w: Complex64, cauchy: Cauchy, map: Map) -> Option<(Complex64, Complex64)> {
        if let Some((z, slope)) = self.from_disk_beside(w) {
            let is_there = || map(z).is_some_and(|(f, _)| (w - f).norm() <= self.error_estimate);
            return if !self.is_lost(slope) || is_there() { Some((z, slope)) } else { self.marched(w, map) };
        }
        match cauchy(w) {
            Some((z, slope, one)) if (one - 1.0).norm() < self.whole() => self.polished(w, (z, slope.inv()), 0.0, map),
            _ => self.marched(w, map),
        }
    }

    /// z and f'(z) where f(z) should be w, z being good to `error`: where the disk is wide against the region, that weighs more,
    /// and a step of Newton's method takes it away. Where it weighs so much that z is lost, it is looked for anew.
    #[must_use]
    pub fn polished(
        &self,
        w: Complex64,
        (z, slope): (Complex64, Complex64),
        error: f64,
        map: Map,
    ) -> Option<(Complex64, Complex64)> {
        let is_lost = self.is_lost(slope);
        if slope.norm() * (error + ROUNDING) < POLISHED * self.error_estimate && !is_lost {
            return Some((z, slope));
        }
        match map(z) {
            Some((f, slope)) if (w - f).norm() <= self.error_estimate => {
                let step = if is_lost { Complex64::ZERO } else { (w - f) / slope };
                Some((z + step, slope))
            }
            _ => self.marched(w, map),
        }
    }

    /// Whether the map's error is a long way in the region, so that a place found may lie outside of it.
    fn is_lost(&self, slope: Complex64) -> bool {
        slope.norm() * LONG_WAY < self.error_estimate
    }

    /// Beside the circle: the complex measure is inverted.
    fn from_disk_beside(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        if w.norm_sqr() < 0.01 {
            return None;
        }
        let measure = Complex64::new((w.arg() / TAU).rem_euclid(1.0), -w.norm().ln() / TAU);
        let (q, foot) = self.locate_on_panel(measure.re);
        let panel = self.panel(q);
        let mut tau = Complex64::from(foot);
        if panel.start == 0.0 {
            // At a corner τ is about a power of the measure from there.
            let corner = if panel.outgoing { self.starts[q] } else { self.starts[q + 1] };
            let step = if panel.outgoing { measure - corner } else { corner - measure };
            let size = step.norm();
            if size > 0.0 && size < self.starts[q + 1] - self.starts[q] {
                let power = panel.exponent * self.discretisation.boundary.arm(panel).power;
                let real = self.tau_of(q, if panel.outgoing { corner + size } else { corner - size }, MIDDLE);
                tau = Complex64::from_polar(real, step.arg() / power);
            }
        }
        for _ in 0..20 {
            let sign = if panel.outgoing { 1.0 } else { -1.0 };
            let newton = (self.complex_measure(q, tau) - measure) / (self.continued_density(q, tau) * sign);
            if !newton.is_finite() {
                return None;
            }
            tau -= newton;
            if bernstein(2.0 * tau - 1.0) > 1.3 {
                return None;
            }
            if newton.norm() <= 1e-15 * tau.norm() {
                break;
            }
        }
        let miss = (self.complex_measure(q, tau) - measure).norm();
        if bernstein(2.0 * tau - 1.0) > CONTINUED_BACK || miss.is_nan() || miss > 1e-15 {
            return None;
        }
        let share = if panel.exponent == 1.0 { tau } else { tau.powf(panel.exponent) };
        let s = panel.start + panel.length() * share;
        let arm = self.discretisation.boundary.arm(panel);
        let z = self.discretisation.boundary.vertices[panel.corner] + arm.curve.from_start(s);
        Some((z, w * Complex64::i() * TAU * self.measure_slope(q, s, tau)))
    }

    /// Newton's method for f(z) = w, steps halved where they leave the region or do not help.
    fn newton(w: Complex64, guess: Complex64, map: Map) -> Option<(Complex64, Complex64)> {
        let mut z = guess;
        let (f, mut slope) = map(z)?;
        let mut miss = w - f;
        for _ in 0..NEWTON_STEPS {
            let step = miss / slope;
            if !step.is_finite() {
                return None;
            }
            let mut share = 1.0;
            let moved = loop {
                let there = z + step * share;
                match map(there) {
                    Some((f, slope)) if (w - f).norm() < miss.norm() => break Some((there, w - f, slope)),
                    _ if share > SHORTENED => share *= 0.5,
                    _ => break None,
                }
            };
            let Some((there, left, there_slope)) = moved else {
                // No better: rounding, or lost.
                return (miss.norm() < 1e-13).then_some((z, slope));
            };
            (z, miss, slope) = (there, left, there_slope);
            if miss.norm() < 1e-16 || step.norm() * share < 1e-16 {
                return Some((z, slope));
            }
        }
        (miss.norm() < 1e-12).then_some((z, slope))
    }

    /// From the center outwards along the radius, by steps as long as Newton's method bears; where far parts are crowded together so
    /// that none leads on, as near to w as the map itself is known.
    fn marched(&self, w: Complex64, map: Map) -> Option<(Complex64, Complex64)> {
        let (mut share, mut step) = (0.0, 0.5);
        let mut z = self.center;
        let (_, mut slope) = map(z)?;
        for _ in 0..400 {
            let next = f64::min(1.0, share + step);
            let guess = z + w * (next - share) / slope;
            match Self::newton(w * next, guess, map) {
                Some((there, there_slope)) => {
                    (z, slope, share) = (there, there_slope, next);
                    if share == 1.0 {
                        return Some((z, slope));
                    }
                    step *= 2.0;
                }
                None => step *= 0.5,
            }
            if step < SHORTEST_STEP || w.norm() * (1.0 - share) <= self.error_estimate {
                break;
            }
        }
        (w.norm() * (1.0 - share) <= self.error_estimate).then_some((z, slope))
    }
}
