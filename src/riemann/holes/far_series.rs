//! L far from all bodies: Q log(z − m) + Σ aₖ (R/(z − m))ᵏ.

use super::super::atlas::power_series::value_and_slope;
use crate::plane::Complex64;
use crate::plane::fourier::transform;
use std::f64::consts::TAU;

/// The series of L around infinity.
#[derive(Clone, Debug)]
pub struct FarSeries {
    middle: Complex64,
    radius: f64,
    charge: f64,
    /// a₁ ….
    coefficients: Vec<Complex64>,
}

/// L' is sampled at so many points,
const SAMPLES: usize = 128;
/// this many times as far as the bodies reach.
const SAMPLED: f64 = 1.5;
/// At 2.5 times as far (1.5/2.5)ᵏ is left of samples' rounding after so many, and 0.4ᵏ of L.
const TERMS: usize = 44;

impl FarSeries {
    /// For bodies that reach so far from `middle`; `slope` gives L'.
    #[must_use]
    pub fn new(middle: Complex64, reach: f64, slope: &dyn Fn(Complex64) -> Complex64) -> Self {
        let radius = SAMPLED * reach;
        let at = |j: usize| {
            let from = Complex64::from_polar(radius, TAU * j as f64 / SAMPLES as f64);
            slope(middle + from) * from
        };
        // (z − m)L' = Q − Σ k aₖ (R/(z − m))ᵏ: frequency −k is k steps from the end.
        let samples: Vec<Complex64> = (0..SAMPLES).map(at).collect();
        let spectrum = transform(&samples);
        let coefficient = |k: usize| -spectrum[SAMPLES - k] / (SAMPLES * k) as f64;
        let coefficients = (1..=TERMS).map(coefficient).collect();
        Self { middle, radius, charge: spectrum[0].re / SAMPLES as f64, coefficients }
    }

    /// Where the cut of its logarithm begins.
    #[must_use]
    pub fn middle(&self) -> Complex64 {
        self.middle
    }

    /// (L, L') at a point far away.
    #[must_use]
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        let from = z - self.middle;
        let u = self.radius / from;
        let (value, slope) = value_and_slope(&self.coefficients, u);
        // d/dz (value·u) = (value + slope·u)·u' with u' = −u/(z − m).
        let by_z = -(value + slope * u) * u / from;
        if self.charge == 0.0 {
            return (value * u, by_z);
        }
        (self.charge * from.ln() + value * u, by_z + self.charge / from)
    }
}
