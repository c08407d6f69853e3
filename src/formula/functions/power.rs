//! Powers z^a.

use super::arithmetic::{ValueAndSlope, divide, without_signed_zeros};
use super::exponential::{exp_value, log_modulus, log_value, sqrt};
use crate::plane::Complex64;

/// Whole exponents up to this size are multiplied out; each product costs half a unit in the last place.
pub const LARGEST_MULTIPLIED_EXPONENT: f64 = 64.0;

/// The principal value of z^a = exp(a log z). 0^a is 0 for Re a > 0, and z^0 is 1.
pub fn pow(z: Complex64, a: Complex64) -> Complex64 {
    if a.im == 0.0 { pow_real(z, a.re) } else { pow_general(z, a) }
}

/// z^a for one a, with its derivative a·z^(a−1).
pub fn pow_with_slope(z: Complex64, a: Complex64) -> ValueAndSlope {
    let value = pow(z, a);
    let slope = if a == Complex64::ZERO {
        Complex64::ZERO
    } else if z == Complex64::ZERO || !value.is_normal() {
        a * pow(z, a - 1.0)
    } else {
        a * divide(value, z)
    };
    (value, slope)
}

fn pow_real(z: Complex64, a: f64) -> Complex64 {
    if a.trunc() == a && a.abs() <= LARGEST_MULTIPLIED_EXPONENT {
        return pow_whole(z, a);
    }
    if z == Complex64::ZERO {
        return pow_zero(a);
    }
    if a == 0.5 {
        return sqrt(z).0;
    }
    let z = without_signed_zeros(z);
    let (sin, cos) = (a * z.im.atan2(z.re)).sin_cos();
    let modulus = modulus_pow(z, a);
    Complex64::new(modulus * cos, modulus * sin)
}

/// |z|^a; near |z| = 1 the modulus itself has lost what the logarithm still knows.
fn modulus_pow(z: Complex64, a: f64) -> f64 {
    let log = log_modulus(z);
    if log.abs() < 0.5 { (a * log).exp() } else { z.re.hypot(z.im).powf(a) }
}

fn pow_zero(a: f64) -> Complex64 {
    if a > 0.0 { Complex64::ZERO } else { Complex64::new(f64::INFINITY, 0.0) }
}

/// Repeated squaring.
fn pow_whole(z: Complex64, n: f64) -> Complex64 {
    let mut left = n.abs() as u32;
    let (mut square, mut product) = (z, Complex64::ONE);
    while left > 0 {
        if left & 1 == 1 {
            product *= square;
        }
        left >>= 1;
        if left > 0 {
            square *= square;
        }
    }
    if n < 0.0 { divide(Complex64::ONE, product) } else { product }
}

fn pow_general(z: Complex64, a: Complex64) -> Complex64 {
    if z == Complex64::ZERO { pow_zero(a.re) } else { exp_value(a * log_value(z)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_powers_are_products() {
        let z = Complex64::new(3.0, -2.0);
        assert_eq!(pow(z, Complex64::new(3.0, 0.0)), z * z * z);
        assert_eq!(pow(z, Complex64::ZERO), Complex64::ONE);
        assert_eq!(pow(Complex64::new(0.0, 2.0), Complex64::new(-2.0, 0.0)), Complex64::new(-0.25, 0.0));
    }

    #[test]
    fn powers_of_zero() {
        let c = Complex64::new;
        assert_eq!(pow(Complex64::ZERO, c(0.3, 0.0)), Complex64::ZERO);
        assert_eq!(pow(Complex64::ZERO, c(0.3, 2.0)), Complex64::ZERO);
        assert!(pow(Complex64::ZERO, c(-1.5, 0.0)).re.is_infinite());
        assert_eq!(pow_with_slope(Complex64::ZERO, c(2.0, 0.0)), (Complex64::ZERO, Complex64::ZERO));
        assert_eq!(pow_with_slope(Complex64::ZERO, c(1.0, 0.0)).1, Complex64::ONE);
        assert_eq!(pow_with_slope(Complex64::ZERO, Complex64::ZERO), (Complex64::ONE, Complex64::ZERO));
    }
}
