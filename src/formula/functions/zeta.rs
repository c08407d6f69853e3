//! Riemann's zeta function.

use super::arithmetic::{UNDEFINED, ValueAndSlope, divide};
use super::exponential::{exp_value, sin_cos_pi};
use super::gamma::log_gamma_and_digamma;
use crate::plane::Complex64;
use std::f64::consts::{FRAC_PI_2, LN_2, TAU};

/// Terms of Euler and Maclaurin's correction.
const CORRECTIONS: usize = 16;

/// Above this |Im s| only what a short sum gives is known.
const HIGHEST: f64 = 1000.0;

/// From this real part on, a sum of some 400 terms is exact to the last digit.
const CONVERGENT: f64 = 8.0;

/// ζ(s) and ζ'(s); NaN at the pole 1, and for |Im s| > 1000 where −7 < Re s < 8.
///
/// About 1e-14, and 3e-13 where |Im s| nears 200 or Re s nears −200, by Euler and Maclaurin's formula and reflection.
pub fn zeta(s: Complex64) -> ValueAndSlope {
    let in_strip = s.re < CONVERGENT && s.re > 1.0 - CONVERGENT;
    if !s.is_finite() || s == Complex64::ONE || (s.im.abs() > HIGHEST && in_strip) {
        return UNDEFINED;
    }
    if s.re < -0.5 { reflected(s) } else { summed(s) }
}

/// Σ n^{−s} up to N − 1, the integral from N on and its corrections: DLMF 25.2.9.
fn summed(s: Complex64) -> ValueAndSlope {
    let count = (16.0 + 0.5 * s.norm().min(2.0 * HIGHEST)) as u32;
    let (mut value, mut slope) = (Complex64::ONE, Complex64::ZERO);
    for n in 2..count {
        let log = f64::from(n).ln();
        let term = exp_value(-s * log);
        value += term;
        slope -= log * term;
        if s.re > 2.0 && term.l1_norm() <= 1e-18 * slope.l1_norm() {
            return (value, slope);
        }
    }
    let n = f64::from(count);
    let log = n.ln();
    let last = exp_value(-s * log);
    let below = s - 1.0;
    let integral = divide(last * n, below);
    value += integral + 0.5 * last;
    slope -= log * (integral + 0.5 * last) + divide(integral, below);
    // B₂ₖ/(2k)! s(s + 1)…(s + 2k − 2) n^{1−s−2k}; `rising` is all but the first factor, and `change` its derivative.
    let (mut rising, mut change) = (s * last / n, (1.0 - s * log) * last / n);
    for k in 1..=CORRECTIONS {
        let coefficient = bernoulli_over_factorial(k);
        value += coefficient * rising;
        slope += coefficient * change;
        for j in [2 * k - 1, 2 * k] {
            let factor = s + j as f64;
            change = (change * factor + rising) / n;
            rising = rising * factor / n;
        }
    }
    (value, slope)
}

/// B₂ₖ/(2k)! = ∓2 ζ(2k)/(2π)²ᵏ.
fn bernoulli_over_factorial(k: usize) -> f64 {
    const FIRST: [f64; 4] = [1.0 / 12.0, -1.0 / 720.0, 1.0 / 30_240.0, -1.0 / 1_209_600.0];
    FIRST.get(k - 1).copied().unwrap_or_else(|| {
        let power = 2 * k as i32;
        let zeta = 1.0 + 0.5f64.powi(power) + 3f64.powi(-power) + 4f64.powi(-power) + 5f64.powi(-power);
        let size = 2.0 * zeta * TAU.powi(-power);
        if k.is_multiple_of(2) { -size } else { size }
    })
}

/// ζ(s) = 2 (2π)^{s−1} sin(πs/2) Γ(1 − s) ζ(1 − s): DLMF 25.4.1.
fn reflected(s: Complex64) -> ValueAndSlope {
    let mirrored = 1.0 - s;
    let (log_gamma, digamma) = log_gamma_and_digamma(mirrored);
    let (zeta, zeta_slope) = summed(mirrored);
    let high = s.im.abs() > 20.0;
    // sin(πs/2) and its derivative over π/2, both over e^{π|t|/2} where that is large.
    let (sin, cos) = sin_cos_pi(0.5 * s.re);
    let (sin, cos, growth) = if high {
        // e^{∓iπσ/2} times ±i/2 and 1/2.
        let turn = 0.5 * Complex64::new(cos, if s.im > 0.0 { -sin } else { sin });
        let quarter = Complex64::new(0.0, 1f64.copysign(s.im));
        (turn * quarter, turn, FRAC_PI_2 * s.im.abs())
    } else {
        let (sinh, cosh) = ((FRAC_PI_2 * s.im).sinh(), (FRAC_PI_2 * s.im).cosh());
        (Complex64::new(sin * cosh, cos * sinh), Complex64::new(cos * cosh, -sin * sinh), 0.0)
    };
    // Its square root, so that nothing overflows before the value does. The logarithm of Γ may be off by 2πi, which turns
    // the root's sign alone.
    let factor = exp_value(0.5 * (log_gamma - mirrored * TAU.ln() + LN_2 + growth));
    let change = (TAU.ln() - digamma) * sin + FRAC_PI_2 * cos;
    let [value, slope] = [sin * zeta, change * zeta - sin * zeta_slope];
    (factor * value * factor, factor * slope * factor)
}
