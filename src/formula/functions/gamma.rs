//! The gamma function.

use super::arithmetic::{UNDEFINED, ValueAndSlope, divide};
use super::exponential::{exp_value, log_value, sin_cos_pi};
use crate::plane::Complex64;
use std::f64::consts::{LN_2, PI};

/// B₂ₖ / (2k(2k−1)), k = 1…9: the coefficients of Stirling's series.
const STIRLING: [f64; 9] = [
    1.0 / 12.0,
    -1.0 / 360.0,
    1.0 / 1260.0,
    -1.0 / 1680.0,
    1.0 / 1188.0,
    -691.0 / 360_360.0,
    1.0 / 156.0,
    -3617.0 / 122_400.0,
    43867.0 / 244_188.0,
];

/// B₂ₖ / 2k, k = 1…9: the coefficients of the digamma function's series.
const DIGAMMA: [f64; 9] = [
    1.0 / 12.0,
    -1.0 / 120.0,
    1.0 / 252.0,
    -1.0 / 240.0,
    1.0 / 132.0,
    -691.0 / 32760.0,
    1.0 / 12.0,
    -3617.0 / 8160.0,
    43867.0 / 14364.0,
];

/// The series are used from this modulus on, where their last term is below 1e-18.
const FAR: f64 = 13.0;

/// Γ(z) and Γ'(z) = Γ(z)ψ(z); NaN at the poles 0, −1, −2, …
///
/// Stirling's series after a shift to |z| ≥ 13, reflection for Re z < ½. About 1e-14 relative, growing as |log Γ|.
pub fn gamma(z: Complex64) -> ValueAndSlope {
    if !z.is_finite() {
        return UNDEFINED;
    }
    let (value, psi) = if z.re < 0.5 { reflected(z) } else { right_half_plane(z) };
    (value, value * psi)
}

/// Γ and ψ for Re z ≥ ½: Γ(z) = Γ(z + n) / (z(z+1)…(z+n−1)).
fn right_half_plane(z: Complex64) -> (Complex64, Complex64) {
    let (far, product, sum) = shift(z);
    (divide(exp_value(log_gamma_far(far)), product), digamma_far(far) - sum)
}

/// z + n with |z + n| ≥ 13, the product of z, …, z + n − 1 and the sum of their reciprocals.
fn shift(mut z: Complex64) -> (Complex64, Complex64, Complex64) {
    let (mut product, mut sum) = (Complex64::ONE, Complex64::ZERO);
    while z.norm_sqr() < FAR * FAR {
        product *= z;
        sum += z.inv();
        z.re += 1.0;
    }
    (z, product, sum)
}

/// log Γ by Stirling's series.
fn log_gamma_far(z: Complex64) -> Complex64 {
    const HALF_LOG_TAU: f64 = 0.918_938_533_204_672_8;
    let inverse = z.inv();
    (z - 0.5) * log_value(z) - z + HALF_LOG_TAU + odd_series(&STIRLING, inverse)
}

fn digamma_far(z: Complex64) -> Complex64 {
    let inverse = z.inv();
    log_value(z) - 0.5 * inverse - odd_series(&DIGAMMA, inverse) * inverse
}

/// c₁x + c₂x³ + c₃x⁵ + …
fn odd_series(coefficients: &[f64], x: Complex64) -> Complex64 {
    let square = x * x;
    x * coefficients.iter().rev().fold(Complex64::ZERO, |sum, &c| sum * square + c)
}

/// Γ(z) = π / (sin(πz) Γ(1 − z)), ψ(z) = ψ(1 − z) − π cot(πz).
fn reflected(z: Complex64) -> (Complex64, Complex64) {
    let mirrored = Complex64::ONE - z;
    if z.im.abs() > 30.0 || mirrored.re > 100.0 {
        return reflected_far(z, mirrored);
    }
    let (gamma, psi) = right_half_plane(mirrored);
    let (sin, cos) = sin_cos_pi_complex(z);
    (divide(Complex64::new(PI, 0.0), sin * gamma), psi - PI * divide(cos, sin))
}

/// log Γ(z), up to a multiple of 2πi, and ψ(z) for Re z ≥ ½.
pub(super) fn log_gamma_and_digamma(z: Complex64) -> (Complex64, Complex64) {
    let (far, product, sum) = shift(z);
    (log_gamma_far(far) - log_value(product), digamma_far(far) - sum)
}

/// Reflection through logarithms: sin(πz) and Γ(1 − z) may be out of range although their product is not.
fn reflected_far(z: Complex64, mirrored: Complex64) -> (Complex64, Complex64) {
    let (log_gamma, psi) = log_gamma_and_digamma(mirrored);
    if z.im.abs() > 30.0 {
        // sin πz = ½ e^{π|y|} e^{∓i(πx − π/2)} to the last digit, and cot πz = ∓i.
        let upper = z.im > 0.0;
        let (sin, cos) = sin_cos_pi(z.re - 0.5);
        let turn = if upper { Complex64::new(cos, sin) } else { Complex64::new(cos, -sin) };
        let size = exp_value(Complex64::new(PI.ln() + LN_2 - PI * z.im.abs(), 0.0) - log_gamma);
        let cot = Complex64::new(0.0, if upper { -1.0 } else { 1.0 });
        return (size * turn, psi - PI * cot);
    }
    let (sin, cos) = sin_cos_pi_complex(z);
    (divide(PI * exp_value(-log_gamma), sin), psi - PI * divide(cos, sin))
}

/// sin πz and cos πz, the reduction of Re z being exact.
fn sin_cos_pi_complex(z: Complex64) -> (Complex64, Complex64) {
    let (sin, cos) = sin_cos_pi(z.re);
    let (sinh, cosh) = ((PI * z.im).sinh(), (PI * z.im).cosh());
    (Complex64::new(sin * cosh, cos * sinh), Complex64::new(cos * cosh, -sin * sinh))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factorials_and_poles() {
        let mut factorial = 1.0;
        for n in 1..=20 {
            let (value, _) = gamma(Complex64::new(f64::from(n), 0.0));
            assert!((value.re / factorial - 1.0).abs() < 1e-14 && value.im == 0.0, "Γ({n}) = {value}");
            factorial *= f64::from(n);
        }
        for pole in [0.0, -1.0, -7.0, -250.0] {
            assert!(!gamma(Complex64::new(pole, 0.0)).0.is_finite(), "Γ({pole}) must not be a number");
        }
    }

    #[test]
    fn every_region_satisfies_the_recurrence() {
        let points =
            [(0.4, 0.1), (-3.3, 0.7), (-3.3, -29.9), (-0.2, 31.0), (-99.2, 1.0), (-150.5, 0.01), (-5.0, -80.0)];
        for (re, im) in points {
            let z = Complex64::new(re, im);
            let (next, here) = (gamma(z + 1.0).0, gamma(z).0);
            assert!(
                (next - z * here).norm() < 1e-12 * next.norm() + 1e-310,
                "Γ({z} + 1) = {next}, zΓ(z) = {}",
                z * here
            );
        }
    }
}
