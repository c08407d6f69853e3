//! Weierstrass's elliptic function ℘ of the lattice ℤ + τℤ.

use super::arithmetic::{ValueAndSlope, divide, times_i};
use super::circular::sin;
use super::exponential::exp_value;
use crate::plane::Complex64;
use std::f64::consts::{PI, TAU};

/// Terms on both sides of the cell: Qⁿ with |Q| ≤ e^{−π√3} = 0.0043.
const TERMS: usize = 7;

/// Continued fractions' steps to the fundamental domain at most; each brings Im τ up.
const MOST_STEPS: usize = 64;

/// The lattice, ready for any z.
pub struct Lattice {
    /// ℘(z) = c² ℘(cz) of the lattice ℤ + τℤ below.
    scale: Complex64,
    /// In the fundamental domain of the modular group: |τ| ≥ 1, |Re τ| ≤ ½.
    ratio: Complex64,
    /// Qⁿ = e^{2πinτ}, n = 1, 2, …
    powers: [Complex64; TERMS],
    /// What ℘ has besides its sum.
    constant: Complex64,
    /// g₂/2, in ℘'' = 6℘² − g₂/2.
    half_invariant: Complex64,
}

impl Lattice {
    /// The lattice of periods 1 and τ; none for real τ.
    pub fn new(tau: Complex64) -> Option<Self> {
        // The lattice of −τ is the same.
        let mut ratio = if tau.im < 0.0 { -tau } else { tau };
        let mut scale = Complex64::ONE;
        for _ in 0..MOST_STEPS {
            ratio.re -= ratio.re.round();
            if ratio.norm_sqr() >= 1.0 - 1e-9 {
                break;
            }
            // Periods 1 and τ are −τ times −1/τ and −1.
            scale = divide(scale, ratio);
            ratio = divide(-Complex64::ONE, ratio);
        }
        if !(ratio.im > 0.8 && scale.is_finite()) {
            return None;
        }
        let nome = exp_value(Complex64::new(-TAU * ratio.im, TAU * ratio.re));
        let (mut powers, mut power) = ([Complex64::ZERO; TERMS], Complex64::ONE);
        // η₁ and g₂ as sums over divisors: DLMF 23.8.5, and 23.8.6 with E₄ = 1 + 240 Σ n³Qⁿ/(1 − Qⁿ).
        let (mut constant, mut quartic) = (Complex64::new(1.0 / 12.0, 0.0), Complex64::new(1.0 / 240.0, 0.0));
        for (n, entry) in powers.iter_mut().enumerate() {
            power *= nome;
            *entry = power;
            constant -= 2.0 * power / ((1.0 - power) * (1.0 - power));
            quartic += ((n + 1) as f64).powi(3) * power / (1.0 - power);
        }
        Some(Self { scale, ratio, powers, constant, half_invariant: quartic * (160.0 * PI.powi(4)) })
    }

    /// ℘(z) and ℘'(z).
    pub fn wp(&self, z: Complex64) -> ValueAndSlope {
        let [value, slope] = self.both(z);
        let square = self.scale * self.scale;
        (square * value, square * slope * self.scale)
    }

    /// ℘'(z) and ℘''(z).
    pub fn wp_prime(&self, z: Complex64) -> ValueAndSlope {
        let [value, slope] = self.both(z);
        let square = self.scale * self.scale;
        (square * slope * self.scale, square * square * (6.0 * value * value - self.half_invariant))
    }

    /// With w = e^{2πiz}: ℘ = (2πi)² (1/12 + Σ Qⁿw/(1 − Qⁿw)² − 2Σ Qⁿ/(1 − Qⁿ)²), the first sum over all n, the second
    /// over n ≥ 1: DLMF 23.8.3 with the cosecants written as powers. The term n = 0 is −1/(4 sin² πz).
    fn both(&self, z: Complex64) -> [Complex64; 2] {
        let mut z = z * self.scale;
        z -= self.ratio * (z.im / self.ratio.im).round();
        z.re -= z.re.round();
        let (sine, cosine) = sin(PI * z);
        let square = divide(Complex64::new(-0.25, 0.0), sine) / sine;
        let wave = exp_value(Complex64::new(-TAU * z.im, TAU * z.re));
        let back = exp_value(Complex64::new(TAU * z.im, -TAU * z.re));
        let mut value = self.constant;
        let mut slope = Complex64::ZERO;
        for power in self.powers {
            for (turn, sign) in [(wave, 1.0), (back, -1.0)] {
                let (a, gap) = (power * turn, 1.0 - power * turn);
                let term = a / (gap * gap);
                value += term;
                slope += sign * term * (1.0 + a) / gap;
            }
        }
        // d/dz of −1/(4 sin²) is π cos/(2 sin³), over 2πi.
        let near = times_i(divide(cosine * square, sine));
        [-(TAU * TAU) * (value + square), Complex64::new(0.0, -TAU.powi(3)) * (slope + near)]
    }
}
