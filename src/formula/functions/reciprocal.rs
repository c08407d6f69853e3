//! Secant, cosecant, cotangent, their hyperbolic kin and the inverses of all six.

use super::arithmetic::{ValueAndSlope, divide, times_minus_i, without_signed_zeros};
use super::circular::{cos, cosh, sin, sinh, tan, tanh};
use super::exponential::sqrt_c99;
use super::inverse::{
    acos, acos_of_roots, acosh, acosh_of_roots, asin, asin_c99, atanh, quarter_log_of_ratio, reciprocal_of_product,
};
use crate::plane::Complex64;

fn reciprocal(z: Complex64) -> Complex64 {
    divide(Complex64::ONE, z)
}

/// sec z = 1/cos z and its derivative sec z tan z.
pub fn sec(z: Complex64) -> ValueAndSlope {
    let value = reciprocal(cos(z).0);
    (value, value * tan(z).0)
}

/// csc z = 1/sin z and its derivative −csc z cot z.
pub fn csc(z: Complex64) -> ValueAndSlope {
    let value = reciprocal(sin(z).0);
    (value, -divide(value, tan(z).0))
}

/// cot z = 1/tan z and its derivative −csc² z.
pub fn cot(z: Complex64) -> ValueAndSlope {
    let csc = reciprocal(sin(z).0);
    (reciprocal(tan(z).0), -csc * csc)
}

/// sech z = 1/cosh z and its derivative −sech z tanh z.
pub fn sech(z: Complex64) -> ValueAndSlope {
    let value = reciprocal(cosh(z).0);
    (value, -value * tanh(z).0)
}

/// csch z = 1/sinh z and its derivative −csch z coth z.
pub fn csch(z: Complex64) -> ValueAndSlope {
    let value = reciprocal(sinh(z).0);
    (value, -divide(value, tanh(z).0))
}

/// coth z = 1/tanh z and its derivative −csch² z.
pub fn coth(z: Complex64) -> ValueAndSlope {
    let csch = reciprocal(sinh(z).0);
    (reciprocal(tanh(z).0), -csch * csch)
}

/// f(1/z) and its derivative −f'(1/z)/z².
fn of_reciprocal(f: impl Fn(Complex64) -> ValueAndSlope, z: Complex64) -> ValueAndSlope {
    let inverse = reciprocal(z);
    let (value, slope) = f(inverse);
    (value, -(slope * inverse) * inverse)
}

/// √(1 − 1/z) and √(1 + 1/z), without the rounding of 1/z, which is all that is left of them near ±1.
fn roots_of_reciprocal(z: Complex64) -> (Complex64, Complex64) {
    let root = |numerator: Complex64| sqrt_c99(without_signed_zeros(divide(numerator, z)));
    (root(z - 1.0), root(z + 1.0))
}

/// Whether z is so near the unit circle that 1/z should not be rounded before more is done with it.
fn is_near_circle(z: Complex64) -> bool {
    (0.25..4.0).contains(&z.norm_sqr())
}

/// arcsec z = arccos(1/z).
pub fn asec(z: Complex64) -> ValueAndSlope {
    of_reciprocal(
        |inverse| if is_near_circle(z) { acos_of_roots(inverse, c99_roots(z, inverse)) } else { acos(inverse) },
        z,
    )
}

/// The two roots of [`roots_of_reciprocal`], on the sides of their cuts that C99 has for 1/z with positive zeros.
fn c99_roots(z: Complex64, inverse: Complex64) -> (Complex64, Complex64) {
    let (minus, plus) = roots_of_reciprocal(z);
    // The imaginary part of 1 − 1/z is that of −1/z: −0 where 1/z is real.
    let minus = if inverse.im == 0.0 && minus.re == 0.0 { Complex64::new(0.0, -minus.im.abs()) } else { minus };
    (minus, plus)
}

/// arccsc z = arcsin(1/z).
pub fn acsc(z: Complex64) -> ValueAndSlope {
    of_reciprocal(
        |inverse| {
            if !is_near_circle(z) {
                return asin(inverse);
            }
            let (minus, plus) = c99_roots(z, inverse);
            (asin_c99(inverse, minus, plus), divide(Complex64::ONE, minus * plus))
        },
        z,
    )
}

/// arccot z = arctan(1/z): odd, with its cut between −i and i.
pub fn acot(z: Complex64) -> ValueAndSlope {
    let (value, slope) = acoth(times_minus_i(without_signed_zeros(z)));
    (times_minus_i(value), -slope)
}

/// arsech z = arcosh(1/z).
pub fn asech(z: Complex64) -> ValueAndSlope {
    let roots = |inverse: Complex64| {
        let root = |numerator: Complex64| sqrt_c99(without_signed_zeros(divide(numerator, z)));
        acosh_of_roots(inverse, (root(1.0 - z), root(1.0 + z)))
    };
    of_reciprocal(|inverse| if is_near_circle(z) { roots(inverse) } else { acosh(inverse) }, z)
}

/// arcsch z = arsinh(1/z).
pub fn acsch(z: Complex64) -> ValueAndSlope {
    // arsinh w = −i arcsin(iw), and i/z = 1/(−iz).
    let (value, slope) = acsc(times_minus_i(without_signed_zeros(z)));
    (times_minus_i(value), -slope)
}

/// arcoth z = artanh(1/z).
pub fn acoth(z: Complex64) -> ValueAndSlope {
    if !is_near_circle(z) {
        return (atanh(reciprocal(z)).0, reciprocal_of_product(1.0 - z, 1.0 + z));
    }
    let z = without_signed_zeros(z);
    if z.re < 0.0 {
        let (value, slope) = acoth(-z);
        // On the cut, the side of positive zeros is the same for both.
        let im = if z.im == 0.0 && z.re > -1.0 { value.im } else { -value.im };
        return (Complex64::new(-value.re, im), slope);
    }
    let (x, y) = (z.re, z.im);
    let across = if y == 0.0 { 0.0 } else { -2.0 * y };
    let im = 0.5 * across.atan2((x - 1.0) * (x + 1.0) + y * y);
    (Complex64::new(quarter_log_of_ratio(x, y), im), reciprocal_of_product(1.0 - z, 1.0 + z))
}
