//! exp, log and the square root.

use super::arithmetic::{ValueAndSlope, divide, without_signed_zeros};
use crate::plane::Complex64;
use std::f64::consts::PI;

/// e^z.
pub fn exp(z: Complex64) -> ValueAndSlope {
    let value = exp_value(z);
    (value, value)
}

pub(super) fn exp_value(z: Complex64) -> Complex64 {
    if z.re == f64::NEG_INFINITY {
        return Complex64::ZERO;
    }
    if z.im == 0.0 {
        return Complex64::new(z.re.exp(), z.im);
    }
    let (sin, cos) = z.im.sin_cos();
    if z.re > 709.0 {
        // e^x itself may overflow although its product with a small sine does not.
        let half = (0.5 * z.re).exp();
        return Complex64::new(half * cos * half, half * sin * half);
    }
    let modulus = z.re.exp();
    Complex64::new(modulus * cos, modulus * sin)
}

/// e^{iπz}: exact at whole and half-whole numbers, where the branches of a square root need it.
pub fn cis_pi(z: Complex64) -> ValueAndSlope {
    let (sin, cos) = sin_cos_pi(z.re);
    let value = Complex64::new(cos, sin) * (-PI * z.im).exp();
    (value, Complex64::new(-PI * value.im, PI * value.re))
}

/// (sin πx, cos πx), the reduction of x being exact.
pub(super) fn sin_cos_pi(x: f64) -> (f64, f64) {
    let quarters = (2.0 * x).round();
    let (sin, cos) = (PI * (x - 0.5 * quarters)).sin_cos();
    match quarters.rem_euclid(4.0) {
        0.0 => (sin, cos),
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        3.0 => (-cos, sin),
        _ => (f64::NAN, f64::NAN),
    }
}

/// The principal logarithm, −π < Im ≤ π.
pub fn log(z: Complex64) -> ValueAndSlope {
    (log_value(z), divide(Complex64::ONE, z))
}

pub(super) fn log_value(z: Complex64) -> Complex64 {
    let z = without_signed_zeros(z);
    Complex64::new(log_modulus(z), z.im.atan2(z.re))
}

/// log|z|, accurate also where |z| is near 1.
pub(super) fn log_modulus(z: Complex64) -> f64 {
    let (small, large) = order(z.re.abs(), z.im.abs());
    if (0.5..2.0).contains(&large) {
        // |z|² − 1 without cancellation: large − 1 is exact.
        return 0.5 * ((large - 1.0) * (large + 1.0) + small * small).ln_1p();
    }
    large.hypot(small).ln()
}

fn order(a: f64, b: f64) -> (f64, f64) {
    if a < b { (a, b) } else { (b, a) }
}

/// The principal square root, Re ≥ 0.
pub fn sqrt(z: Complex64) -> ValueAndSlope {
    let value = sqrt_c99(without_signed_zeros(z));
    (value, divide(Complex64::new(0.5, 0.0), value))
}

/// The square root as C99 has it: the sign of a zero imaginary part tells the side of the cut.
pub(super) fn sqrt_c99(z: Complex64) -> Complex64 {
    let largest = z.re.abs().max(z.im.abs());
    if largest == 0.0 {
        return Complex64::new(0.0, z.im);
    }
    if !z.is_finite() {
        return Complex64::new(if z.re == f64::INFINITY { z.re } else { f64::NAN }, f64::NAN);
    }
    // A power of 4 on the way in is a power of 2 on the way out, so that hypot stays in range.
    let (up, down) = if largest > 1e300 {
        (0.0625, 4.0)
    } else if largest < 1e-290 {
        (2f64.powi(108), 2f64.powi(-54))
    } else {
        (1.0, 1.0)
    };
    let (x, y) = (z.re * up, z.im * up);
    let t = (0.5 * (x.abs() + x.hypot(y))).sqrt();
    let (re, im) = if x >= 0.0 { (t, 0.5 * y / t) } else { (0.5 * y.abs() / t, t.copysign(y)) };
    Complex64::new(re * down, im * down)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_unity_are_exact() {
        let quarter = |k: f64| cis_pi(Complex64::new(0.5 * k, 0.0)).0;
        for (k, expected) in [(0.0, (1.0, 0.0)), (1.0, (0.0, 1.0)), (2.0, (-1.0, 0.0)), (-1.0, (0.0, -1.0))] {
            assert_eq!(quarter(k), Complex64::new(expected.0, expected.1), "e^(iπ{k}/2)");
            assert_eq!(quarter(k + 4e6), quarter(k));
        }
    }

    #[test]
    fn the_cut_is_seen_from_above_whatever_the_sign_of_zero() {
        for zero in [0.0, -0.0] {
            assert_eq!(sqrt(Complex64::new(-4.0, zero)).0, Complex64::new(0.0, 2.0));
            assert_eq!(log(Complex64::new(-1.0, zero)).0, Complex64::new(0.0, PI));
        }
    }

    #[test]
    fn extremes_stay_in_range() {
        let c = Complex64::new;
        assert_eq!(sqrt(c(0.0, 2e-300)).0, c(1e-150, 1e-150));
        assert!((sqrt(c(1e308, 1e308)).0.norm() / 1.189207115002721e154 - 1.0).abs() < 1e-15);
        assert_eq!(exp(c(f64::NEG_INFINITY, f64::NAN)).0, Complex64::ZERO);
        assert!((exp(c(710.0, 1.57)).0.re / 1.7789897039328811e305 - 1.0).abs() < 1e-12);
        assert!(log(Complex64::ZERO).0.re == f64::NEG_INFINITY);
    }
}
