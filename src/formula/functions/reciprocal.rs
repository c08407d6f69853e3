//! Secant, cosecant, cotangent, their hyperbolic kin and the inverses of all six.

use super::arithmetic::{ValueAndSlope, divide};
use super::circular::{cos, cosh, sin, sinh, tan, tanh};
use super::inverse::{acos, acosh, asin, asinh, atan, atanh};
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

/// arcsec z = arccos(1/z).
pub fn asec(z: Complex64) -> ValueAndSlope {
    of_reciprocal(acos, z)
}

/// arccsc z = arcsin(1/z).
pub fn acsc(z: Complex64) -> ValueAndSlope {
    of_reciprocal(asin, z)
}

/// arccot z = arctan(1/z): odd, with its cut between −i and i.
pub fn acot(z: Complex64) -> ValueAndSlope {
    of_reciprocal(atan, z)
}

/// arsech z = arcosh(1/z).
pub fn asech(z: Complex64) -> ValueAndSlope {
    of_reciprocal(acosh, z)
}

/// arcsch z = arsinh(1/z).
pub fn acsch(z: Complex64) -> ValueAndSlope {
    of_reciprocal(asinh, z)
}

/// arcoth z = artanh(1/z).
pub fn acoth(z: Complex64) -> ValueAndSlope {
    of_reciprocal(atanh, z)
}
