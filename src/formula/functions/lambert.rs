//! Lambert's W, the branches of the inverse of w e^w.
//!
//! R. M. Corless et al., *On the Lambert W function* (1996): branches and cuts are theirs, and mpmath's.

use super::arithmetic::{UNDEFINED, ValueAndSlope, divide, product_in_two, without_signed_zeros};
use super::exponential::{exp_value, log_value, sqrt};
use crate::plane::Complex64;
use std::f64::consts::{E, PI, TAU};

/// What E lacks of Euler's number.
const E_REST: f64 = 1.445_646_891_729_250_2e-16;

/// Newton's steps at most; from the starting values here six are enough.
const MOST_STEPS: usize = 20;

/// W_k(z) and its derivative W/(z(1 + W)); NaN where k is not a whole number.
pub fn lambert_w(branch: Complex64, z: Complex64) -> ValueAndSlope {
    let k = branch.re;
    if !z.is_finite() || branch.im != 0.0 || k.trunc() != k || (z == Complex64::ZERO && k != 0.0) {
        return UNDEFINED;
    }
    let z = without_signed_zeros(z);
    let above = from_branch_point(z);
    let meets = k == 0.0 || (k == -1.0 && z.im >= 0.0) || (k == 1.0 && z.im < 0.0);
    if meets && above.norm_sqr() < 0.09 {
        return near_branch_point(z, above, k == 0.0);
    }
    let small = k == 0.0 && z.re > -1.0 && z.re < 1.5 && z.im.abs() < 1.0 && -2.5 * z.im.abs() - 0.2 < z.re;
    let mut value = if small { near_zero(z) } else { by_logarithms(k, z) };
    if z.im == 0.0 && z.re < 0.0 && above.re > 0.0 && meets {
        value.im = 0.0;
    }
    (value, slope(z, value, 1.0 + value))
}

/// W/(z(1 + W)), which is e^{−W}/(1 + W).
fn slope(z: Complex64, value: Complex64, above: Complex64) -> Complex64 {
    if value.norm_sqr() < 0.25 { divide(exp_value(-value), above) } else { divide(divide(value, z), above) }
}

/// e z + 1, accurate beside −1/e.
fn from_branch_point(z: Complex64) -> Complex64 {
    if z.norm_sqr() > 100.0 {
        return z;
    }
    let (re, rest) = product_in_two(E, z.re);
    Complex64::new((re + 1.0) + (rest + E_REST * z.re), E * z.im)
}

/// u = W + 1 solves u²/2 + u³/3 + … + (n − 1)uⁿ/n! + … = 1 + (u − 1)e^u = ez + 1, without cancellation.
fn near_branch_point(z: Complex64, above: Complex64, upper: bool) -> ValueAndSlope {
    // Corless et al., equation (4.22).
    let root = if upper { sqrt(2.0 * above).0 } else { -sqrt(2.0 * above).0 };
    let mut u = root * (1.0 + root * (-1.0 / 3.0 + root * (11.0 / 72.0 - root * (43.0 / 540.0))));
    if u != Complex64::ZERO {
        for _ in 0..4 {
            let mut sum = Complex64::ZERO;
            for n in (2..=20).rev() {
                let n = f64::from(n);
                // Term n is (n − 1)/n! uⁿ: the sum from n on, times n!/uⁿ.
                sum = (n - 1.0) + sum * u / (n + 1.0);
            }
            u -= divide(0.5 * sum * u * u - above, u * exp_value(u));
        }
    }
    (u - 1.0, slope(z, u - 1.0, u))
}

/// Halley's method for w e^w = z.
fn near_zero(z: Complex64) -> Complex64 {
    // The Padé approximant of degree 2 over 2.
    let numerator = z * (z * 17.0 + 114.0) + 60.0;
    let mut w = z * divide(numerator, z * (z * 101.0 + 174.0) + 60.0);
    for _ in 0..MOST_STEPS {
        let exp = exp_value(w);
        let excess = w * exp - z;
        let step = divide(excess, exp * (w + 1.0) - (w + 2.0) * excess / (2.0 * w + 2.0));
        w -= step;
        if step.norm_sqr() <= 1e-30 * w.norm_sqr() {
            break;
        }
    }
    w
}

/// Newton's method for w + log w = log z + 2πik, which keeps its digits where e^w is large or small.
fn by_logarithms(k: f64, z: Complex64) -> Complex64 {
    // Continued over the negative axis, beside which W₁ and W₋₁ have values: rounding must not jump over its cut.
    let log = |w: Complex64| {
        if k == 0.0 || w.re > 0.0 { log_value(w) } else { log_value(-w) + Complex64::new(0.0, PI.copysign(k)) }
    };
    let target = log_value(z) + Complex64::new(0.0, TAU * k);
    let mut w = target - log(target);
    for _ in 0..MOST_STEPS {
        let step = divide(w * (w + log(w) - target), w + 1.0);
        w -= step;
        if step.norm_sqr() <= 1e-31 * w.norm_sqr() {
            break;
        }
    }
    w
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn branches_are_inverse_to_their_product() {
        for k in [-3.0, -1.0, 0.0, 1.0, 2.0] {
            for z in [(-0.5, 0.1), (-0.36, 1e-9), (2.0, -3.0), (1e-30, 1e-31), (-9.0, -1e-9), (1e300, 1e300)] {
                let z = Complex64::new(z.0, z.1);
                let (w, _) = lambert_w(k.into(), z);
                assert!((w + w.ln() - z.ln()).re.abs() <= 1e-12, "W_{k}({z}) = {w}");
            }
        }
    }

    #[test]
    fn what_has_no_value_is_not_a_number() {
        let c = Complex64::new;
        assert_eq!(lambert_w(c(0.0, 0.0), c(0.0, 0.0)), (c(0.0, 0.0), c(1.0, 0.0)));
        for (k, z) in [(c(1.0, 0.0), c(0.0, 0.0)), (c(0.5, 0.0), c(1.0, 0.0)), (c(0.0, 0.0), c(f64::INFINITY, 0.0))] {
            assert!(!lambert_w(k, z).0.is_finite());
        }
    }
}
