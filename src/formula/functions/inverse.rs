//! Inverse circular and hyperbolic functions, after Kahan.

use super::arithmetic::{ValueAndSlope, divide, times_i, times_minus_i, without_signed_zeros};
use super::exponential::sqrt_c99;
use crate::plane::Complex64;
use std::f64::consts::{FRAC_PI_2, LN_2};

/// From here on, 1 ± z is z to the last digit, and products of roots would overflow.
const HUGE: f64 = 1e150;

/// arcsin z, −π/2 ≤ Re ≤ π/2.
pub fn asin(z: Complex64) -> ValueAndSlope {
    let z = without_signed_zeros(z);
    let (minus, plus) = roots(z);
    let slope = divide(Complex64::ONE, minus * plus);
    (asin_c99(z, minus, plus), slope)
}

/// √(1 − z) and √(1 + z). With C99 roots their product is continuous where √(1 − z²) would jump.
fn roots(z: Complex64) -> (Complex64, Complex64) {
    (sqrt_c99(Complex64::new(1.0 - z.re, -z.im)), sqrt_c99(Complex64::new(1.0 + z.re, z.im)))
}

pub(super) fn asin_c99(z: Complex64, minus: Complex64, plus: Complex64) -> Complex64 {
    if z.norm() > HUGE {
        return Complex64::new(z.re.atan2(z.im.abs()), (LN_2 + log_huge(z)).copysign(z.im));
    }
    let re = z.re.atan2((minus * plus).re);
    Complex64::new(re, (minus.conj() * plus).im.asinh())
}

/// log|z| where |z| may be beyond the largest number.
fn log_huge(z: Complex64) -> f64 {
    LN_2 + (0.5 * z.re).hypot(0.5 * z.im).ln()
}

/// arccos z, 0 ≤ Re ≤ π.
pub fn acos(z: Complex64) -> ValueAndSlope {
    let z = without_signed_zeros(z);
    acos_of_roots(z, roots(z))
}

/// arccos z from √(1 − z) and √(1 + z), which may be better known than z tells.
pub(super) fn acos_of_roots(z: Complex64, (minus, plus): (Complex64, Complex64)) -> ValueAndSlope {
    let slope = -divide(Complex64::ONE, minus * plus);
    if z.norm() > HUGE {
        return (Complex64::new(z.im.abs().atan2(z.re), (LN_2 + log_huge(z)).copysign(-z.im)), slope);
    }
    let re = 2.0 * minus.re.atan2(plus.re);
    (Complex64::new(re, (plus.conj() * minus).im.asinh()), slope)
}

/// arsinh z, −π/2 ≤ Im ≤ π/2.
pub fn asinh(z: Complex64) -> ValueAndSlope {
    let turned = times_i(without_signed_zeros(z));
    let (minus, plus) = roots(turned);
    let slope = divide(Complex64::ONE, minus * plus);
    (times_minus_i(asin_c99(turned, minus, plus)), slope)
}

/// arcosh z, Re ≥ 0, −π < Im ≤ π.
pub fn acosh(z: Complex64) -> ValueAndSlope {
    let z = without_signed_zeros(z);
    let minus = sqrt_c99(Complex64::new(z.re - 1.0, z.im));
    let plus = sqrt_c99(Complex64::new(z.re + 1.0, z.im));
    acosh_of_roots(z, (minus, plus))
}

/// arcosh z from √(z − 1) and √(z + 1), which may be better known than z tells.
pub(super) fn acosh_of_roots(z: Complex64, (minus, plus): (Complex64, Complex64)) -> ValueAndSlope {
    let slope = divide(Complex64::ONE, minus * plus);
    if z.norm() > HUGE {
        return (Complex64::new(LN_2 + log_huge(z), z.im.atan2(z.re)), slope);
    }
    let re = (minus.conj() * plus).re.asinh();
    (Complex64::new(re, 2.0 * minus.im.atan2(plus.re)), slope)
}

/// arctan z, −π/2 ≤ Re ≤ π/2.
pub fn atan(z: Complex64) -> ValueAndSlope {
    let z = without_signed_zeros(z);
    let value = times_minus_i(atanh_c99(times_i(z)));
    // 1 + z² as a product: no cancellation near ±i.
    let (x, y) = (z.re, z.im);
    (value, reciprocal_of_product(Complex64::new(x, y - 1.0), Complex64::new(x, y + 1.0)))
}

/// artanh z, −π/2 ≤ Im ≤ π/2.
pub fn atanh(z: Complex64) -> ValueAndSlope {
    let z = without_signed_zeros(z);
    (atanh_c99(z), reciprocal_of_product(Complex64::ONE - z, Complex64::ONE + z))
}

pub(super) fn reciprocal_of_product(a: Complex64, b: Complex64) -> Complex64 {
    divide(divide(Complex64::ONE, a), b)
}

fn atanh_c99(z: Complex64) -> Complex64 {
    if z.re < 0.0 || (z.re == 0.0 && z.re.is_sign_negative()) {
        return -atanh_c99(-z);
    }
    let (x, y) = (z.re, z.im);
    if x.max(y.abs()) > HUGE {
        // Re(1/z) without overflow.
        return Complex64::new(divide(Complex64::ONE, z).re, FRAC_PI_2.copysign(y));
    }
    let off = y * y;
    let re = quarter_log_of_ratio(x, y);
    let im = 0.5 * (2.0 * y).atan2((1.0 - x) * (1.0 + x) - off);
    Complex64::new(re, im)
}

/// ½ log |(1 + z)/(1 − z)| for z = x + iy: the real part of artanh z, and of artanh 1/z.
pub(super) fn quarter_log_of_ratio(x: f64, y: f64) -> f64 {
    let gap = (1.0 - x) * (1.0 - x) + y * y;
    // Next to the pole at 1 the squares underflow, and the distance does not.
    if gap < 1e-280 { 0.5 * (LN_2 - (1.0 - x).hypot(y).ln()) } else { 0.25 * (4.0 * x / gap).ln_1p() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_3;

    #[test]
    fn cuts_are_c99_with_positive_zeros() {
        let close = |a: Complex64, re: f64, im: f64| {
            assert!((a - Complex64::new(re, im)).norm() < 1e-15, "{a} is not {re} + {im}i");
        };
        for zero in [0.0, -0.0] {
            let real = |x| Complex64::new(x, zero);
            let imaginary = |y| Complex64::new(zero, y);
            close(asin(real(2.0)).0, FRAC_PI_2, 1.3169578969248166);
            close(asin(real(-2.0)).0, -FRAC_PI_2, 1.3169578969248166);
            close(acos(real(2.0)).0, 0.0, -1.3169578969248166);
            close(acosh(real(-2.0)).0, 1.3169578969248166, std::f64::consts::PI);
            close(acosh(real(0.5)).0, 0.0, FRAC_PI_3);
            close(atanh(real(2.0)).0, 0.5493061443340549, FRAC_PI_2);
            close(atanh(real(-2.0)).0, -0.5493061443340549, FRAC_PI_2);
            close(asinh(imaginary(2.0)).0, 1.3169578969248166, FRAC_PI_2);
            close(asinh(imaginary(-2.0)).0, 1.3169578969248166, -FRAC_PI_2);
            close(atan(imaginary(2.0)).0, FRAC_PI_2, 0.5493061443340549);
            close(atan(imaginary(-2.0)).0, FRAC_PI_2, -0.5493061443340549);
        }
    }

    #[test]
    fn the_huge_formulas_continue_the_others() {
        for angle in [0.1, 1.0, 2.0, 3.0, -0.1, -1.0, -2.0, -3.0] {
            for (name, f) in [("asin", asin as fn(Complex64) -> _), ("acos", acos), ("acosh", acosh), ("asinh", asinh)]
            {
                let below = f(Complex64::from_polar(0.999 * HUGE, angle)).0;
                let above = f(Complex64::from_polar(1.001 * HUGE, angle)).0;
                assert!((below - above).norm() < 3e-3, "{name} jumps from {below} to {above} at {angle}");
                assert!(f(Complex64::from_polar(1.7e308, angle)).0.is_finite());
            }
            let ends = [0.999, 1.001].map(|r| atan(Complex64::from_polar(r * HUGE, angle)).0);
            assert!((ends[0] - ends[1]).norm() < 1e-15, "atan jumps at {angle}");
        }
    }
}
