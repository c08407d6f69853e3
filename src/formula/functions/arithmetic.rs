//! Complex arithmetic that neither overflows on the way nor loses zeros.

use crate::plane::Complex64;

/// A function's value and its derivative at a point.
pub type ValueAndSlope = (Complex64, Complex64);

/// Where a function has no value.
pub const UNDEFINED: ValueAndSlope = (Complex64::new(f64::NAN, f64::NAN), Complex64::new(f64::NAN, f64::NAN));

/// i·z, exactly.
pub fn times_i(z: Complex64) -> Complex64 {
    Complex64::new(-z.im, z.re)
}

/// −i·z, exactly.
pub fn times_minus_i(z: Complex64) -> Complex64 {
    Complex64::new(z.im, -z.re)
}

/// Replaces −0 by +0 in both parts.
pub fn without_signed_zeros(z: Complex64) -> Complex64 {
    Complex64::new(z.re + 0.0, z.im + 0.0)
}

/// The product of two numbers below 1e150 and its rounding error: T. J. Dekker, *A floating-point technique for extending
/// the available precision* (1971).
pub fn product_in_two(a: f64, b: f64) -> (f64, f64) {
    let halves = |x: f64| {
        let scaled = 134_217_729.0 * x;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
    let product = a * b;
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
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
