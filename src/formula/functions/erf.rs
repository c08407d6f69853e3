//! The error function and its complement.
//!
//! Through Faddeeva's w(z) = e^{−z²} erfc(−iz) by the modified trapezoidal rules of M. Al Azah and S. N. Chandler-Wilde,
//! *Computation of the complex error function using modified trapezoidal rules* (SIAM J. Numer. Anal. 59, 2021).

use super::arithmetic::{ValueAndSlope, divide, product_in_two, times_i, without_signed_zeros};
use crate::plane::Complex64;
use std::f64::consts::{FRAC_2_SQRT_PI, PI};

/// Points of the rule beyond the middle; the error falls as e^{−πN}.
const N: u32 = 11;

/// √(π/(N + 1)), the distance of the points.
const H: f64 = 0.511_663_353_941_432_2;

/// erf z and its derivative 2/√π e^{−z²}.
pub fn erf(z: Complex64) -> ValueAndSlope {
    let slope = times_gaussian(z, FRAC_2_SQRT_PI.into());
    let value = if z.norm_sqr() < 1.0 {
        near_zero(z)
    } else if z.re < 0.0 {
        erfc_right(-z) - 1.0
    } else {
        1.0 - erfc_right(z)
    };
    (value, slope)
}

/// erfc z = 1 − erf z, without cancellation where it is small.
pub fn erfc(z: Complex64) -> ValueAndSlope {
    let slope = -times_gaussian(z, FRAC_2_SQRT_PI.into());
    let value = if z.norm_sqr() < 1.0 {
        1.0 - near_zero(z)
    } else if z.re < 0.0 {
        2.0 - erfc_right(-z)
    } else {
        erfc_right(z)
    };
    (value, slope)
}

/// DLMF 7.6.1, for |z| < 1.
fn near_zero(z: Complex64) -> Complex64 {
    let square = -z * z;
    let mut sum = Complex64::ZERO;
    for n in (1..=19).rev() {
        let n = f64::from(n);
        sum = (sum + 1.0 / (2.0 * n + 1.0)) * square / n;
    }
    (sum + 1.0) * z * FRAC_2_SQRT_PI
}

/// erfc z = e^{−z²} w(iz) for Re z ≥ 0 and |z| ≥ 1.
fn erfc_right(z: Complex64) -> Complex64 {
    let at = times_i(without_signed_zeros(z));
    // w(−z̄) is the conjugate of w(z).
    let mirrored = Complex64::new(at.re.abs(), at.im);
    let w = faddeeva(mirrored);
    times_gaussian(z, if at.re < 0.0 { w.conj() } else { w })
}

/// w(z) in the first quadrant, |z| ≥ 1: equations (9) to (14) of the paper.
fn faddeeva(z: Complex64) -> Complex64 {
    if z.re.max(z.im) > 1e8 {
        return divide(Complex64::new(0.0, 0.5 * FRAC_2_SQRT_PI), z);
    }
    let offset = (z.re / H).fract();
    let between = z.im < z.re && (0.25..=0.75).contains(&offset);
    let shift = if z.im >= PI / H {
        return rule(z, 0.5);
    } else if between {
        0.5
    } else {
        0.0
    };
    // The residue of the pole between the real line and the line of integration.
    let wave = exp_of_parts(2.0 * PI / H * z.im, -2.0 * PI / H * z.re);
    let residue = divide(times_gaussian(z, 2.0.into()), if between { 1.0 + wave } else { 1.0 - wave });
    rule(z, shift) + residue
}

/// e^{x + iφ}
fn exp_of_parts(exponent: f64, phase: f64) -> Complex64 {
    Complex64::from_polar(exponent.exp(), phase)
}

/// (ih/π) Σ e^{−t²}/(z − t) over t = (k + shift)h, both signs taken together.
fn rule(z: Complex64, shift: f64) -> Complex64 {
    let square = z * z;
    let mut sum = Complex64::ZERO;
    for k in 0..=N {
        let t = (f64::from(k) + shift) * H;
        let weight = if t == 0.0 { 0.5 } else { (-t * t).exp() };
        sum += weight / (square - t * t);
    }
    times_i(sum * z) * (2.0 * H / PI)
}

/// a e^{−z²}, to the last digits also where |z²| is large, and infinite only where a double cannot hold it.
fn times_gaussian(z: Complex64, a: Complex64) -> Complex64 {
    // Beyond, the value is 0 or infinite, or its phase is lost.
    if z.re.abs().max(z.im.abs()) > 1e100 {
        let exponent = (z.im.abs() - z.re.abs()) * f64::INFINITY;
        return if exponent < 0.0 { Complex64::ZERO } else { Complex64::new(f64::NAN, f64::NAN) };
    }
    let (x, x_rest) = product_in_two(z.re, z.re);
    let (y, y_rest) = product_in_two(z.im, z.im);
    let (phase, phase_rest) = product_in_two(-2.0 * z.re, z.im);
    // In halves, so that e^{…} does not overflow before it is multiplied.
    let difference = y - x;
    let rounding = if x < y { (y - difference) - x } else { y - (difference + x) };
    let half = (0.5 * difference).exp();
    let rest = (rounding + y_rest - x_rest).exp();
    let turn = Complex64::cis(phase) * Complex64::cis(phase_rest);
    a * half * turn * rest * half
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_is_one_and_infinity_is_a_limit() {
        let c = Complex64::new;
        for z in [c(0.3, 0.2), c(0.999, 0.01), c(1.001, -0.01), c(2.0, 3.0), c(-1.0, 2.5), c(0.0, 5.0)] {
            assert!((erf(z).0 + erfc(z).0 - 1.0).norm() <= 1e-14 * erf(z).0.norm(), "at {z}");
        }
        assert_eq!((erf(c(1e200, 1.0)), erfc(c(1e200, 1.0)).0), ((Complex64::ONE, Complex64::ZERO), Complex64::ZERO));
        assert_eq!(erf(c(-30.0, 0.0)).0, -Complex64::ONE);
        assert!(!erf(c(0.0, 27.0)).0.is_finite() && erf(c(0.0, 26.7)).0.is_finite());
        assert!(!erf(c(f64::NAN, 1.0)).0.is_finite());
    }
}
