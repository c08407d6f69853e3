//! Logarithm and exponential beside 1 and 0, where numbers cancel.

use crate::plane::Complex64;

/// log(1 + z) with the relative accuracy of z.
#[must_use]
pub fn ln_1p(z: Complex64) -> Complex64 {
    Complex64::new(0.5 * (2.0 * z.re + z.norm_sqr()).ln_1p(), z.im.atan2(1.0 + z.re))
}

/// eᶻ − 1 with the relative accuracy of z.
#[must_use]
pub fn exp_m1(z: Complex64) -> Complex64 {
    let grown = z.re.exp_m1();
    let (sin, half) = (z.im.sin(), (0.5 * z.im).sin());
    Complex64::new(grown * z.im.cos() - 2.0 * half * half, (grown + 1.0) * sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_and_exponentials_near_1() {
        for z in [Complex64::new(1e-20, -3e-21), Complex64::new(0.1, 0.2), Complex64::new(-0.3, 1.0)] {
            assert!((exp_m1(ln_1p(z)) - z).norm() < 1e-15 * z.norm());
        }
    }
}
