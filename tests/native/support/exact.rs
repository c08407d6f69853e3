//! Exact answers of conformal maps, from the theory of elliptic functions.

use super::{complex, polygon};
use conformal_warp::{Complex64, Region};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Vertices of [−a, a] × [−1, 1] from the lower left, counter-clockwise.
pub fn rectangle(a: f64) -> Region {
    let vertices = [[-a, -1.0], [a, -1.0], [a, 1.0], [-a, 1.0]].map(complex);
    polygon(&vertices, Complex64::ZERO)
}

/// Harmonic measure of a short side of [−a, a] × [−1, 1] from its middle.
///
/// u = sn(K(z+i)/a) takes the rectangle to the half plane, its middle to i/√k; the right side becomes [1, 1/k], whose
/// angle from there is atan(1/√k) − atan(√k). k' comes from the complementary nome e^(−πa/2), so no digit is lost.
pub fn short_side_measure(a: f64) -> f64 {
    let nome = (-FRAC_PI_2 * a).exp();
    let (theta2, theta3) = thetas(nome);
    let complement = (theta2 / theta3).powi(2);
    let k = (1.0 - complement * complement).sqrt();
    let one_minus_k = complement * complement / (1.0 + k);
    (one_minus_k / (2.0 * k.sqrt())).atan() / PI
}

/// f'(0) of [−a, a] × [−1, 1], real and positive: |u'|/(2 Im u₀) = K(1+k)/(2a) for u as above, 2K/π = θ₃², k = (θ₂/θ₃)².
pub fn rectangle_slope(a: f64) -> f64 {
    let (theta2, theta3) = thetas((-2.0 * PI / a).exp());
    let k = (theta2 / theta3).powi(2);
    FRAC_PI_2 * theta3.powi(2) * (1.0 + k) / (2.0 * a)
}

/// The regular n-gon with circumradius 1, and its conformal radius Γ(1−1/n)/(Γ(1+1/n)Γ(1−2/n)) from tables.
pub fn regular(n: usize) -> Region {
    let vertices: Vec<_> = (0..n).map(|k| Complex64::cis(TAU * k as f64 / n as f64)).collect();
    polygon(&vertices, Complex64::ZERO)
}

/// 1/f'(0) of the ellipse with semi-axes a > b: f'(0) = √k·2K/(πc), nome q = ((a−b)/(a+b))², c² = a² − b².
pub fn ellipse_conformal_radius(a: f64, b: f64) -> f64 {
    // √k = θ₂/θ₃ and 2K/π = θ₃².
    let (theta2, theta3) = thetas(((a - b) / (a + b)).powi(2));
    (a * a - b * b).sqrt() / (theta2 * theta3)
}

/// θ₂(q) and θ₃(q).
fn thetas(q: f64) -> (f64, f64) {
    let theta2: f64 = 2.0 * (0..30).map(|n| q.powf((f64::from(n) + 0.5).powi(2))).sum::<f64>();
    let theta3: f64 = 1.0 + 2.0 * (1..30).map(|n| q.powi(n * n)).sum::<f64>();
    (theta2, theta3)
}

/// The map of the ellipse with semi-axes a > b, 0 ↦ 0, a ↦ 1, and its derivative:
/// √k·sn((2K/π) asin(z/c)) = θ₁(asin(z/c))/θ₄(asin(z/c)).
pub fn ellipse(a: f64, b: f64, z: Complex64) -> (Complex64, Complex64) {
    let q = ((a - b) / (a + b)).powi(2);
    let c = (a * a - b * b).sqrt();
    let v = (z / c).asin();
    let (mut theta1, mut theta4) = (Complex64::ZERO, Complex64::ONE);
    let (mut slope1, mut slope4) = (Complex64::ZERO, Complex64::ZERO);
    for n in 0..40 {
        let sign = if n % 2 == 0 { 2.0 } else { -2.0 };
        let order = f64::from(n);
        let (odd, even) = (2.0 * order + 1.0, 2.0 * order);
        theta1 += (v * odd).sin() * (sign * q.powf((order + 0.5).powi(2)));
        slope1 += (v * odd).cos() * (odd * sign * q.powf((order + 0.5).powi(2)));
        if n > 0 {
            theta4 += (v * even).cos() * (sign * q.powf(order * order));
            slope4 -= (v * even).sin() * (even * sign * q.powf(order * order));
        }
    }
    let slope = (slope1 * theta4 - theta1 * slope4) / (theta4 * theta4);
    // dv/dz.
    (theta1 / theta4, slope / (c * v.cos()))
}
