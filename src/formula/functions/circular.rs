//! Circular and hyperbolic functions.

use super::arithmetic::{ValueAndSlope, divide, times_i, times_minus_i};
use crate::plane::Complex64;

/// (sinh x, cosh x) of a real number from one exponential, accurate for small x too.
fn sinh_cosh(x: f64) -> (f64, f64) {
    let size = x.abs();
    let (sinh, cosh) = if size < 22.0 {
        let m = size.exp_m1();
        let ratio = m / (m + 1.0);
        (0.5 * (m + ratio), 1.0 + 0.5 * m * ratio)
    } else {
        let half = (0.5 * size).exp();
        let large = 0.5 * half * half;
        (large, large)
    };
    (sinh.copysign(x), cosh)
}

/// sin z and its derivative cos z.
pub fn sin(z: Complex64) -> ValueAndSlope {
    let (sin, cos) = z.re.sin_cos();
    let (sinh, cosh) = sinh_cosh(z.im);
    (Complex64::new(sin * cosh, cos * sinh), Complex64::new(cos * cosh, -sin * sinh))
}

/// sin z / z and its derivative (cos z − sin z / z)/z; 1 and 0 at 0.
pub fn sinc(z: Complex64) -> ValueAndSlope {
    if z.norm_sqr() > 1.0 {
        let (sin, cos) = sin(z);
        let value = divide(sin, z);
        return (value, divide(cos - value, z));
    }
    // Σ (−z²)ᵏ/(2k + 1)!, whose terms fall below rounding by k = 10, and its derivative term by term.
    let square = -z * z;
    let (mut value, mut slope) = (Complex64::ZERO, Complex64::ZERO);
    for k in (1..=10).rev() {
        let k = f64::from(k);
        value = (value * square) / ((2.0 * k + 2.0) * (2.0 * k + 3.0)) + 1.0;
        slope = (slope * square) / ((2.0 * k + 2.0) * (2.0 * k + 3.0)) + k;
    }
    (value * square / 6.0 + 1.0, -2.0 * z * slope / 6.0)
}

/// ⌊x⌋ + i⌊y⌋, and 0.
pub fn floor(z: Complex64) -> ValueAndSlope {
    (Complex64::new(z.re.floor(), z.im.floor()), Complex64::ZERO)
}

/// cos z and its derivative −sin z.
pub fn cos(z: Complex64) -> ValueAndSlope {
    let (sin, cos) = sin(z);
    (cos, -sin)
}

/// sinh z and its derivative cosh z.
pub fn sinh(z: Complex64) -> ValueAndSlope {
    let (sin, cos) = z.im.sin_cos();
    let (sinh, cosh) = sinh_cosh(z.re);
    (Complex64::new(sinh * cos, cosh * sin), Complex64::new(cosh * cos, sinh * sin))
}

/// cosh z and its derivative sinh z.
pub fn cosh(z: Complex64) -> ValueAndSlope {
    let (sinh, cosh) = sinh(z);
    (cosh, sinh)
}

/// tan z and its derivative 1/cos² z.
pub fn tan(z: Complex64) -> ValueAndSlope {
    let (value, slope) = tanh(times_i(z));
    (times_minus_i(value), slope)
}

/// tanh z and its derivative 1/cosh² z, which is not computed as 1 − tanh²: that is 0 by x = 19.
pub fn tanh(z: Complex64) -> ValueAndSlope {
    let (x, y) = (z.re, z.im);
    if x.abs() > 350.0 {
        // cosh² would overflow; e^{−2|x|} is all that is left of the distance to ±1.
        let decay = 4.0 * (-2.0 * x.abs()).exp();
        let (sin, cos) = (2.0 * y).sin_cos();
        let side = 1f64.copysign(x);
        return (Complex64::new(side, 0.5 * sin * decay), Complex64::new(cos * decay, -side * sin * decay));
    }
    let (sinh, cosh) = sinh_cosh(x);
    let (sin, cos) = y.sin_cos();
    // |cosh z|² = sinh²x + cos²y, a sum of squares.
    let norm = sinh * sinh + cos * cos;
    let value = Complex64::new(sinh * cosh / norm, sin * cos / norm);
    let conjugate = Complex64::new(cosh * cos, -sinh * sin) / norm;
    (value, conjugate * conjugate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tan_far_from_the_axis_is_i_and_not_nan() {
        for y in [20.0, 300.0, 360.0, 1e3, 1e300] {
            for sign in [1.0, -1.0] {
                let (value, slope) = tan(Complex64::new(0.7, sign * y));
                assert!((value - Complex64::new(0.0, sign)).norm() < 1e-16, "tan(0.7 + {}i) = {value}", sign * y);
                assert!(slope.norm() <= 4.1 * (-2.0 * y).exp() && slope.is_finite());
            }
        }
    }

    #[test]
    fn the_far_formula_continues_the_near_one() {
        for (x, y) in [(350.0, 0.3), (350.0, 2.0), (350.0, -1.0), (350.0, 4.0)] {
            for sign in [1.0, -1.0] {
                let (near, far) = (Complex64::new(sign * x, y), Complex64::new(sign * (x + 1e-9), y));
                let ((v0, s0), (v1, s1)) = (tanh(near), tanh(far));
                assert!((v0.im - v1.im).abs() < 1e-8 * v0.im.abs(), "{v0} and {v1} at {near}");
                assert!((s0 - s1).norm() < 1e-8 * s0.norm(), "{s0} and {s1} at {near}");
            }
        }
    }
}
