//! Complex functions of a complex variable, each with its derivative.
//!
//! `num_complex` has most of them, but by their textbook formulas, which lose every digit where a picture has interesting
//! places (`log` near 1, `asin` far out, `tanh` past 355 is NaN) and give no derivative. Here they follow W. Kahan,
//! *Branch cuts for complex elementary functions* (1987): a few units in the last place of the result's modulus.
//!
//! # Branches
//! Principal values and cuts are those of C99 and mpmath:
//!
//! | function | cut | function | cut |
//! |---|---|---|---|
//! | log, sqrt, z^a | (−∞, 0] | asin, acos, atanh | (−∞, −1], [1, ∞) |
//! | acosh | (−∞, 1] | asinh, atan | (−i∞, −i], [i, i∞) |
//!
//! On a cut the value is C99's for positive zeros. The sign of a zero is ignored, so that `sqrt(-1)` and
//! `sqrt(-(1))` are both i.

mod circular;
mod exponential;
mod gamma;
mod inverse;
mod power;
mod reciprocal;

pub use circular::{cos, cosh, sin, sinh, tan, tanh};
pub use exponential::{cis_pi, exp, log, sqrt};
pub use gamma::gamma;
pub use inverse::{acos, acosh, asin, asinh, atan, atanh};
pub use power::{LARGEST_MULTIPLIED_EXPONENT, pow, pow_with_slope};
pub use reciprocal::{acot, acoth, acsc, acsch, asec, asech, cot, coth, csc, csch, sec, sech};

use crate::plane::Complex64;

/// A function's value and its derivative at a point.
pub type ValueAndSlope = (Complex64, Complex64);

/// i·z, exactly.
fn times_i(z: Complex64) -> Complex64 {
    Complex64::new(-z.im, z.re)
}

/// −i·z, exactly.
fn times_minus_i(z: Complex64) -> Complex64 {
    Complex64::new(z.im, -z.re)
}

/// Replaces −0 by +0 in both parts.
fn without_signed_zeros(z: Complex64) -> Complex64 {
    Complex64::new(z.re + 0.0, z.im + 0.0)
}

/// a / b, scaled so that nothing overflows on the way. x / 0 is infinite and x / ∞ is 0, as on the Riemann sphere.
pub fn divide(a: Complex64, b: Complex64) -> Complex64 {
    let largest = b.re.abs().max(b.im.abs());
    if largest == 0.0 {
        return if a == Complex64::ZERO { a / 0.0 } else { Complex64::new(infinite(a.re), infinite(a.im)) };
    }
    if largest.is_infinite() {
        return if a.is_finite() { Complex64::ZERO } else { Complex64::new(f64::NAN, f64::NAN) };
    }
    let scale = reciprocal_power_of_two(largest);
    let (c, d) = (b.re * scale, b.im * scale);
    let norm = c * c + d * d;
    Complex64::new((a.re * c + a.im * d) / norm * scale, (a.im * c - a.re * d) / norm * scale)
}

/// x / 0, a zero part staying 0.
fn infinite(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x * f64::INFINITY }
}

/// The power of two that brings a positive finite `x` near 1: exact to multiply by, and never 0 or infinite.
fn reciprocal_power_of_two(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    f64::from_bits((2046 - exponent.clamp(1, 2045)) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn division_neither_overflows_nor_loses_the_sphere() {
        let c = Complex64::new;
        assert_eq!(divide(c(1e300, 1e300), c(1e300, 1e300)), c(1.0, 0.0));
        assert_eq!(divide(c(3e-310, 0.0), c(1e-310, 0.0)).re.round(), 3.0);
        assert_eq!(divide(c(4.0, 2.0), c(1.0, 1.0)), c(3.0, -1.0));
        assert!(divide(c(1.0, 0.0), Complex64::ZERO).re.is_infinite());
        assert_eq!(divide(c(1.0, 5.0), c(f64::INFINITY, f64::NAN)), Complex64::ZERO);
        assert!(divide(Complex64::ZERO, Complex64::ZERO).is_nan());
    }
}
