//! Jacobi's elliptic functions sn, cn and dn of modulus k.

use super::arithmetic::{ValueAndSlope, divide, times_i, times_minus_i};
use super::circular::sin;
use super::exponential::{exp_value, sqrt};
use crate::plane::Complex64;
use std::f64::consts::PI;

/// Terms of the theta series: the nome is at most e^{−π√3/2} = 0.066.
const TERMS: i32 = 5;

/// One of the three.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Jacobi {
    Sn,
    Cn,
    Dn,
}

/// The functions of one modulus, ready for any z.
pub struct Modulus {
    parameter: Complex64,
    /// z is multiplied by k, and sn(z, k) = sn(kz, 1/k)/k, cn(z, k) = dn(kz, 1/k): DLMF 22.17.
    reciprocal: Option<Complex64>,
    /// z is multiplied by −i, and k' takes the place of k: DLMF 22.6 (iv).
    imaginary: bool,
    theta: Theta,
}

/// The theta functions of a modulus with |k| ≤ 1 and Re k² ≤ ½.
struct Theta {
    nome: Complex64,
    /// Half the first period over π/2, and the ratio of the periods, iK'/K.
    scale: Complex64,
    ratio: Option<Complex64>,
    /// θ₂/(2q^{1/4}), θ₃ and θ₄ at 0.
    constants: [Complex64; 3],
}

impl Modulus {
    /// Any k is brought to a small nome by the six transformations of the modulus.
    pub fn new(k: Complex64) -> Self {
        let (parameter, complement) = (k * k, (1.0 - k) * (1.0 + k));
        let (mut m, mut rest) = (parameter, complement);
        let reciprocal = (m.norm_sqr() > 1.0).then_some(k);
        if reciprocal.is_some() {
            (m, rest) = (divide(Complex64::ONE, m), -divide(rest, m));
        }
        let imaginary = m.re > 0.5;
        if imaginary {
            (m, rest) = (rest, m);
        }
        Self { parameter, reciprocal, imaginary, theta: Theta::new(m, rest) }
    }

    /// One of the functions and its derivative: DLMF 22.13.1 to 22.13.3.
    pub fn eval(&self, function: Jacobi, z: Complex64) -> ValueAndSlope {
        let [sn, cn, dn] = self.all(z);
        match function {
            Jacobi::Sn => (sn, cn * dn),
            Jacobi::Cn => (cn, -sn * dn),
            Jacobi::Dn => (dn, -self.parameter * sn * cn),
        }
    }

    fn all(&self, z: Complex64) -> [Complex64; 3] {
        let z = self.reciprocal.map_or(z, |k| k * z);
        let [sn, cn, dn] = if self.imaginary {
            let [sn, cn, dn] = self.theta.all(times_minus_i(z));
            [times_i(divide(sn, cn)), divide(Complex64::ONE, cn), divide(dn, cn)]
        } else {
            self.theta.all(z)
        };
        self.reciprocal.map_or([sn, cn, dn], |k| [divide(sn, k), dn, cn])
    }
}

impl Theta {
    /// m = k² and 1 − m.
    fn new(m: Complex64, rest: Complex64) -> Self {
        // K = π/(2M(1, k')) and K' = π/(2M(1, k)): DLMF 22.20.6.
        let (mean, other) = (arithmetic_geometric_mean(sqrt(rest).0), arithmetic_geometric_mean(sqrt(m).0));
        let ratio = (m != Complex64::ZERO).then(|| times_i(divide(mean, other)));
        let nome = ratio.map_or(Complex64::ZERO, |ratio| exp_value(times_i(ratio) * PI));
        let mut constants = [Complex64::ONE; 3];
        for n in (1..TERMS).rev() {
            let square = nome.powi(n * n);
            constants[0] += nome.powi(n * n + n);
            constants[1] += 2.0 * square;
            constants[2] += if n % 2 == 0 { 2.0 * square } else { -2.0 * square };
        }
        Self { nome, scale: divide(Complex64::ONE, mean), ratio, constants }
    }

    /// sn, cn and dn as quotients of theta functions: DLMF 22.2.4 to 22.2.6.
    fn all(&self, z: Complex64) -> [Complex64; 3] {
        // ζ = πz/(2K), less whole numbers of half periods π and πτ.
        let mut zeta = divide(z, self.scale);
        let mut signs = [1.0; 3];
        if let Some(ratio) = self.ratio {
            let up = (zeta.im / (PI * ratio.im)).round();
            zeta -= ratio * (PI * up);
            if up % 2.0 != 0.0 {
                signs = [1.0, -1.0, -1.0];
            }
        }
        let across = (zeta.re / PI).round();
        zeta.re -= PI * across;
        if across % 2.0 != 0.0 {
            signs = [-signs[0], -signs[1], signs[2]];
        }
        let [first, second, third, fourth] = self.series(zeta);
        let [two, three, four] = self.constants;
        [
            signs[0] * divide(three * first, two * fourth),
            signs[1] * divide(four * second, two * fourth),
            signs[2] * divide(four * third, three * fourth),
        ]
    }

    /// θ₁ and θ₂ over 2q^{1/4}, θ₃ and θ₄: DLMF 20.2.1 to 20.2.4.
    fn series(&self, zeta: Complex64) -> [Complex64; 4] {
        let (sine, cosine) = sin(zeta);
        // sin and cos of nζ, n = 1, 2, …: each from the one before.
        let (mut s, mut c) = (sine, cosine);
        let mut theta = [sine, cosine, Complex64::ONE, Complex64::ONE];
        for n in 1..TERMS {
            (s, c) = (s * cosine + c * sine, c * cosine - s * sine);
            // Now of 2nζ.
            let even = 2.0 * self.nome.powi(n * n) * c;
            theta[2] += even;
            theta[3] += if n % 2 == 0 { even } else { -even };
            (s, c) = (s * cosine + c * sine, c * cosine - s * sine);
            let odd = self.nome.powi(n * n + n);
            theta[0] += if n % 2 == 0 { odd * s } else { -odd * s };
            theta[1] += odd * c;
        }
        theta
    }
}

/// M(1, b), Re b ≥ 0; steps square the distance.
fn arithmetic_geometric_mean(mut b: Complex64) -> Complex64 {
    let mut a = Complex64::ONE;
    for _ in 0..40 {
        let next = 0.5 * (a + b);
        // The root on the side of the mean.
        let root = sqrt(a).0 * sqrt(b).0;
        b = if (root * next.conj()).re < 0.0 { -root } else { root };
        a = next;
        if (a - b).norm_sqr() <= 1e-32 * a.norm_sqr() {
            break;
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_of_the_modulus_are_elementary() {
        let z = Complex64::new(0.7, -0.4);
        let flat = Modulus::new(Complex64::ZERO);
        assert!((flat.eval(Jacobi::Sn, z).0 - z.sin()).norm() < 1e-15);
        assert_eq!(flat.eval(Jacobi::Dn, z).0, Complex64::ONE);
        let steep = Modulus::new(-Complex64::ONE);
        assert!((steep.eval(Jacobi::Sn, z).0 - z.tanh()).norm() < 1e-15);
        assert!((steep.eval(Jacobi::Dn, z).0 - z.cosh().inv()).norm() < 1e-15);
    }

    #[test]
    fn squares_add_up_for_every_modulus() {
        for k in [(0.3, 0.0), (0.999, 0.0), (0.0, 2.0), (1.5, 0.0), (-4.0, 3.0), (1e-9, 0.0), (1.0, 1e-9), (1e4, 1.0)] {
            let (k, z) = (Complex64::new(k.0, k.1), Complex64::new(0.3, 0.2));
            let [sn, cn, dn] = Modulus::new(k).all(z);
            assert!((sn * sn + cn * cn - 1.0).norm() < 1e-13 * (1.0 + cn.norm_sqr()), "k = {k}");
            let product = k * k * sn * sn;
            assert!((product + dn * dn - 1.0).norm() < 1e-13 * (1.0 + product.norm()), "k = {k}");
        }
    }
}
