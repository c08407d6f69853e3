//! Jacobi's sn and its inverse for a real modulus that is small, by Landen's transformation.

use super::super::near_one::ln_1p;
use crate::plane::Complex64;
use std::f64::consts::FRAC_PI_2;

/// The functions of one modulus 0 ≤ k ≤ ½ or so: sn takes the rectangle with corners ±K and ±K + iK' to the upper half plane,
/// its corners to ±1 and ±1/k.
#[derive(Clone, Debug)]
pub struct Modulus {
    /// k.
    pub k: f64,
    /// K.
    pub quarter: f64,
    /// K'.
    pub height: f64,
    /// Moduli that fall quadratically, the last being 0 up to rounding.
    ladder: Vec<f64>,
    /// K/(π/2).
    scale: f64,
}

/// What is smaller than this is nothing beside 1.
const NEGLIGIBLE: f64 = 1e-17;
/// Nearer to a corner than this, sn is counted from there.
const NEAR: f64 = 0.5;

/// ζ = the inverse of sn at u, and dζ/du.
pub type Integral = (Complex64, Complex64);

impl Modulus {
    /// The functions of modulus `k`.
    #[must_use]
    pub fn new(k: f64) -> Self {
        let mut ladder = Vec::new();
        let mut next = k;
        while next > NEGLIGIBLE {
            next = (next / (1.0 + ((1.0 - next) * (1.0 + next)).sqrt())).powi(2);
            ladder.push(next);
        }
        let scale = ladder.iter().map(|k| 1.0 + k).product::<f64>();
        Self { k, quarter: FRAC_PI_2 * scale, height: FRAC_PI_2 / mean(k), ladder, scale }
    }

    /// sn ζ, |Im ζ| ≤ K'/2.
    #[must_use]
    pub fn sn(&self, zeta: Complex64) -> Complex64 {
        let sine = (zeta / self.scale).sin();
        self.ladder.iter().rev().fold(sine, |s, k| (1.0 + k) * s / (1.0 + *k * s * s))
    }

    /// 1 − sn(K − x) = 1 − cn x/dn x, with the relative accuracy that x has.
    #[must_use]
    pub fn one_minus_sn(&self, x: Complex64) -> Complex64 {
        let square = self.sn(x).powi(2);
        let (k, rest) = (self.k * self.k, (1.0 - self.k) * (1.0 + self.k));
        let part = rest * square / (1.0 - k * square);
        part / (1.0 + (1.0 - part).sqrt())
    }

    /// ∫ du/√((1 − u²)(1 − k²u²)) from 0 to u in a closed half plane, |u| ≤ 1/√k: the upper one if `side` is 1, the lower one if
    /// it is −1. `minus` is 1 − u and `plus` 1 + u.
    #[must_use]
    pub fn integral(&self, u: Complex64, minus: Complex64, plus: Complex64, side: f64) -> Integral {
        // Beyond ±1 on the real axis the root is that of the half plane.
        let mut root = (minus * plus).sqrt();
        if root.re.abs() <= root.im.abs() * 1e-8 && root.im * u.re * side > 0.0 {
            root = -root;
        }
        let rest = ((1.0 - self.k * u) * (1.0 + self.k * u)).sqrt();
        let slope = (root * rest).inv();
        // sn(K − ζ) = cn ζ/dn ζ.
        let zeta = if minus.norm() < NEAR {
            self.quarter - self.inverse(root / rest)
        } else if plus.norm() < NEAR {
            self.inverse(root / rest) - self.quarter
        } else if side < 0.0 {
            // The cuts belong to the half plane.
            self.inverse(u.conj()).conj()
        } else {
            self.inverse(u)
        };
        (zeta, slope)
    }

    /// The inverse of sn, in the half plane that u lies in; the cuts beyond ±1 belong to the upper one.
    fn inverse(&self, u: Complex64) -> Complex64 {
        let step = |s: Complex64, k: &f64| 2.0 * s / ((1.0 + k) + ((1.0 + k).powi(2) - 4.0 * *k * s * s).sqrt());
        asin(self.ladder.iter().fold(u, step)) * self.scale
    }
}

/// The arithmetic-geometric mean of 1 and b > 0.
#[must_use]
pub fn mean(mut b: f64) -> f64 {
    let mut a = 1.0;
    // Quadratic, after as many halvings of the ratio as its exponent has digits.
    for _ in 0..20 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        if (a - b).abs() <= f64::EPSILON * a {
            break;
        }
    }
    a
}

/// asin with relative accuracy, its cuts beyond ±1 belonging to the upper half plane.
fn asin(z: Complex64) -> Complex64 {
    if z.im < 0.0 {
        return asin(z.conj()).conj();
    }
    let mut root = ((1.0 - z) * (1.0 + z)).sqrt();
    if z.im == 0.0 && root.re == 0.0 && root.im * z.re > 0.0 {
        root = -root;
    }
    // i log(√(1 − z²) − iz), no part of which cancels in the upper half plane.
    let turned = Complex64::new(z.im, -z.re);
    let log = if z.norm_sqr() < 0.25 { ln_1p(turned - z * z / (1.0 + root)) } else { (root + turned).ln() };
    Complex64::new(-log.im, log.re)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_middles_of_the_rectangle() {
        for k in [3.0 - 8f64.sqrt(), 0.05, 1e-6, 1e-40] {
            let m = Modulus::new(k);
            let at = |u: Complex64, side: f64| m.integral(u, 1.0 - u, 1.0 + u, side).0;
            assert!((at(Complex64::ONE, 1.0) - m.quarter).norm() < 1e-15);
            assert!((at(-Complex64::ONE, 1.0) + m.quarter).norm() < 1e-15);
            let middle = at(Complex64::new(1.0 / k.sqrt(), 0.0), 1.0);
            assert!((middle - Complex64::new(m.quarter, 0.5 * m.height)).norm() < 1e-13 * m.height, "{middle}");
            let middle = at(Complex64::new(0.0, 1.0 / k.sqrt()), 1.0);
            assert!((middle - Complex64::new(0.0, 0.5 * m.height)).norm() < 1e-13 * m.height, "{middle}");
        }
        // A square: K' = 2K.
        let square = Modulus::new(3.0 - 8f64.sqrt());
        assert!((square.height / square.quarter - 2.0).abs() < 1e-15);
        // K'/K of k = 1e-40 is (2/π) log(4/k).
        let long = Modulus::new(1e-40);
        assert!((long.height - 4e40f64.ln()).abs() < 1e-13);
    }

    #[test]
    fn there_and_back_with_the_accuracy_that_corners_need() {
        for k in [3.0 - 8f64.sqrt(), 0.01, 1e-12] {
            let m = Modulus::new(k);
            for side in [1.0, -1.0] {
                // Not at −K itself, where the derivative is infinite.
                for j in 1..200 {
                    let share = |a: f64| (f64::from(j) * a).fract();
                    let zeta =
                        Complex64::new(m.quarter * (2.0 * share(0.618) - 1.0), side * 0.5 * m.height * share(0.7548));
                    let u = m.sn(zeta);
                    let (back, slope) = m.integral(u, 1.0 - u, 1.0 + u, side);
                    assert!((back - zeta).norm() < 1e-12 * (1.0 + zeta.norm()), "{k} {zeta} {u} {back}");
                    let h = Complex64::new(1e-6, 0.0);
                    let difference = (m.sn(zeta + h) - m.sn(zeta - h)) / (2.0 * h);
                    assert!((difference * slope - 1.0).norm() < 1e-5, "{k} {zeta}: {difference} {slope}");
                }
                for size in [1e-3, 1e-9, 1e-60] {
                    let x = Complex64::new(size, -side * 0.7 * size);
                    let gap = m.one_minus_sn(x);
                    let zeta = m.integral(1.0 - gap, gap, 2.0 - gap, side).0;
                    // K − ζ is x, which a number near K cannot say: its square is what is told apart.
                    assert!((m.quarter - x - zeta).norm() < 1e-15, "{size} {side} {zeta}");
                }
            }
        }
    }

    #[test]
    fn arcsines_and_means() {
        assert!((asin(Complex64::new(0.6, -0.3)).sin() - Complex64::new(0.6, -0.3)).norm() < 1e-15);
        assert!((mean(1.0) - 1.0).abs() < 1e-15 && (mean(0.5f64.sqrt()) - 0.847_213_084_793_979_1).abs() < 1e-15);
    }
}
