//! Bessel functions of the first kind and whole order.

use super::arithmetic::{UNDEFINED, ValueAndSlope, divide};
use crate::plane::Complex64;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Largest order.
pub const LARGEST_ORDER: f64 = 500.0;

/// Hankel's expansion is used from this modulus on, for orders 0 and 1 and for all n with n² < 2|z|.
const FAR: f64 = 25.0;

/// J_n(z) and its derivative (J_{n−1}(z) − J_{n+1}(z))/2; NaN where n is not a whole number or too large.
///
/// The error is about 1e-15 for small orders and 2e-14 at 200, relative to the local size e^{|Im z|}/√|z|.
pub fn bessel_j(order: Complex64, z: Complex64) -> ValueAndSlope {
    let n = order.re;
    if !z.is_finite() || order.im != 0.0 || n.trunc() != n || n.abs() > LARGEST_ORDER {
        return UNDEFINED;
    }
    // DLMF 10.4.1 and 10.11.1: J_{−n} = (−1)ⁿ J_n, and the same for J_n(−z), whose derivative turns once more.
    let left = z.re < 0.0;
    let odd = n % 2.0 != 0.0;
    let n = n.abs() as u32;
    let (value, slope) = right(n, if left { -z } else { z });
    let turned = |v: Complex64, turn: bool| if turn { -v } else { v };
    let below = odd && order.re < 0.0;
    (turned(value, below != (left && odd)), turned(slope, below != (left && !odd)))
}

/// n ≥ 0 and Re z ≥ 0.
fn right(n: u32, z: Complex64) -> ValueAndSlope {
    let (size, order) = (z.norm(), f64::from(n));
    if size * size <= 4.0 * (order + 1.0) {
        return power_series(n, z);
    }
    let orders = if size > FAR && (order + 1.0) * (order + 1.0) < 2.0 * size {
        [order - 1.0, order, order + 1.0].map(|order| hankel(order, z))
    } else if size > FAR.max(order) && order * order * z.im.abs() < size * size {
        forward(n, z)
    } else {
        backward(n, z)
    };
    let [below, value, above] = orders;
    (value, 0.5 * (below - above))
}

/// DLMF 10.2.2, for |z|² ≤ 4(n + 1), where its terms fall from the first.
fn power_series(n: u32, z: Complex64) -> ValueAndSlope {
    let (half, order) = (0.5 * z, f64::from(n));
    let square = -half * half;
    let (mut term, mut sum, mut weighted) = (Complex64::ONE, Complex64::ONE, Complex64::new(order, 0.0));
    for k in 1..40 {
        let k = f64::from(k);
        term = term * square / (k * (order + k));
        sum += term;
        weighted += term * (order + 2.0 * k);
        if term.norm_sqr() < 1e-36 {
            break;
        }
    }
    if n == 0 {
        return (sum, -power_series(1, z).0);
    }
    // (z/2)^{n−1}/n!, of which J_n is z/2 times Σ, and J_n' half of Σ (n + 2k).
    let factor = (1..n).fold(Complex64::new(1.0 / order, 0.0), |product, j| product * half / f64::from(j));
    (factor * half * sum, factor * weighted * 0.5)
}

/// Hankel's expansion, DLMF 10.17.3 with J = (H⁽¹⁾ + H⁽²⁾)/2.
fn hankel(order: f64, z: Complex64) -> Complex64 {
    let inverse = divide(Complex64::new(0.125, 0.0), z);
    let (mut even, mut odd, mut term) = (Complex64::ONE, Complex64::ZERO, Complex64::ONE);
    for k in 1..60 {
        let step = 2.0 * f64::from(k) - 1.0;
        let next = term * inverse * ((4.0 * order * order - step * step) / f64::from(k));
        // Terms −2, −4, … and 1, −3, …: signs turn every two.
        if next.norm_sqr() > term.norm_sqr() {
            break;
        }
        term = next;
        let signed = if (k / 2) % 2 == 0 { term } else { -term };
        if k % 2 == 0 {
            even += signed
        } else {
            odd += signed
        }
        if term.norm_sqr() < 1e-36 {
            break;
        }
    }
    // cos and sin of z − nπ/2 − π/4, over e^{|Im z|}, the quarter turns being exact.
    let (sin, cos) = z.re.sin_cos();
    let size = z.im.abs();
    let (grown, decayed) = (1.0, (-2.0 * size).exp());
    let (sinh, cosh) = (0.5 * (grown - decayed) * z.im.signum(), 0.5 * (grown + decayed));
    let (sin, cos) = (Complex64::new(sin * cosh, cos * sinh), Complex64::new(cos * cosh, -sin * sinh));
    let (plus, minus) = ((cos + sin) * FRAC_1_SQRT_2, (sin - cos) * FRAC_1_SQRT_2);
    let (cos, sin) = match order.rem_euclid(4.0) {
        0.0 => (plus, minus),
        1.0 => (minus, -plus),
        2.0 => (-plus, -minus),
        _ => (-minus, plus),
    };
    grow((cos * even - sin * odd) * divide((2.0 / PI).sqrt().into(), super::exponential::sqrt(z).0), size)
}

/// v e^x, in halves, so that e^x alone does not overflow.
fn grow(v: Complex64, x: f64) -> Complex64 {
    let half = (0.5 * x).exp();
    v * half * half
}

/// J_{n+1} = (2n/z) J_n − J_{n−1} from orders 0 and 1, which is stable while n < |z| near the real axis.
fn forward(n: u32, z: Complex64) -> [Complex64; 3] {
    let [mut below, mut value] = [hankel(0.0, z), hankel(1.0, z)];
    let double = divide(Complex64::new(2.0, 0.0), z);
    let mut above = double * value - below;
    for k in 2..=n {
        (below, value) = (value, above);
        above = double * value * f64::from(k) - below;
    }
    if n == 0 { [-value, below, value] } else { [below, value, above] }
}

/// Miller's algorithm: the recurrence downwards from an order where J vanishes, scaled by e^{∓iz} = J₀ + 2Σ (∓i)ᵏ J_k
/// (DLMF 10.12.2), whose terms are no larger than their sum.
fn backward(n: u32, z: Complex64) -> [Complex64; 3] {
    let size = z.norm();
    let start = (size + 12.0 * size.cbrt() + 20.0).max(f64::from(n) + 30.0 + (8.0 * f64::from(n)).sqrt()) as u32;
    let double = divide(Complex64::new(2.0, 0.0), z);
    let upper = z.im > 0.0;
    let (mut above, mut value) = (Complex64::ZERO, Complex64::new(1e-250, 0.0));
    let (mut sum, mut found) = (Complex64::ZERO, [Complex64::ZERO; 3]);
    for k in (0..=start).rev() {
        // `value` is a multiple of J_k.
        if k + 1 >= n && k <= n + 1 {
            found[(k + 1 - n) as usize] = value;
        }
        let quarter = if upper { (4 - k % 4) % 4 } else { k % 4 };
        let weight = if k == 0 { 1.0 } else { 2.0 };
        let turned = match quarter {
            0 => value,
            1 => Complex64::new(-value.im, value.re),
            2 => -value,
            _ => Complex64::new(value.im, -value.re),
        };
        sum += weight * turned;
        if k > 0 {
            (above, value) = (value, double * value * f64::from(k) - above);
            if value.norm_sqr() > 1e200 {
                (above, value, sum) = (above * 1e-150, value * 1e-150, sum * 1e-150);
                found = found.map(|v| v * 1e-150);
            }
        }
    }
    if n == 0 {
        found[0] = -found[2];
    }
    // e^{−iz} above the real axis, e^{iz} below, both of size e^{|Im z|}.
    let (sin, cos) = z.re.sin_cos();
    let turn = divide(Complex64::new(cos, if upper { -sin } else { sin }), sum);
    found.map(|v| grow(v * turn, z.im.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_are_joined_by_their_recurrence() {
        for n in [-7.0, 0.0, 3.0, 40.0, 300.0] {
            for (x, y) in
                [(0.01, 0.1), (-3.0, 2.0), (24.0, -3.0), (80.0, 60.0), (-900.0, 5.0), (2e4, 300.0), (1e6, 0.0)]
            {
                let z = Complex64::new(x, y);
                let [below, value, above] = [n - 1.0, n, n + 1.0].map(|n: f64| bessel_j(n.into(), z).0);
                let size = below.norm() + above.norm() + value.norm();
                assert!(
                    (below + above - value * (2.0 * n) / z).norm() <= 1e-12 * size.max(1e-290),
                    "J_{n}({z}) = {value}"
                );
            }
        }
    }

    #[test]
    fn what_has_no_value_is_not_a_number() {
        let c = Complex64::new;
        assert_eq!(bessel_j(c(0.0, 0.0), c(0.0, 0.0)), (Complex64::ONE, c(-0.0, -0.0)));
        assert_eq!(bessel_j(c(1.0, 0.0), c(0.0, 0.0)).1, c(0.5, 0.0));
        for (n, z) in [(c(0.5, 0.0), 1.0), (c(1e9, 0.0), 1.0), (c(1.0, 1.0), 1.0), (c(0.0, 0.0), f64::INFINITY)] {
            assert!(!bessel_j(n, z.into()).0.is_finite());
        }
    }
}
