//! Exact integrals of the logarithmic kernel against Legendre polynomials.

use crate::plane::Complex64;

/// Bernstein parameter ρ of ζ: the sum of semi-axes of the ellipse with foci ±1 through ζ; 1 on the segment.
#[must_use]
pub fn bernstein(zeta: Complex64) -> f64 {
    let axis = semi_axis(zeta);
    axis + (axis * axis - 1.0).max(0.0).sqrt()
}

/// Whether ζ lies outside the ellipse with foci ±1 and the given semi-axis (ρ + 1/ρ)/2.
#[must_use]
pub fn outside_ellipse(zeta: Complex64, axis: f64) -> bool {
    zeta.norm_sqr() >= axis * axis || semi_axis(zeta) >= axis
}

fn semi_axis(zeta: Complex64) -> f64 {
    0.5 * ((zeta - 1.0).norm_sqr().sqrt() + (zeta + 1.0).norm_sqr().sqrt())
}

/// Writes ∫₋₁¹ Pₖ(t) log(ζ − t) dt, k = 0 … n−1, into `moments` (n = its length ≤ 32).
///
/// The logarithm is the principal one. I₀ = (ζ+1)log(ζ+1) − (ζ−1)log(ζ−1) − 2 and
/// Iₖ = 2(Q₍ₖ₊₁₎ − Q₍ₖ₋₁₎)/(2k+1) with Legendre functions of the second kind (from d/dζ Iₖ = 2Qₖ).
pub fn log_moments(zeta: Complex64, moments: &mut [Complex64]) {
    let mut q = [Complex64::ZERO; 40];
    fill_moments(zeta, moments, &mut q);
}

/// [`log_moments`], and their derivatives by ζ, which are ∫ Pₖ(t)/(ζ − t) dt = 2Qₖ.
pub fn log_moments_with_slopes(zeta: Complex64, moments: &mut [Complex64], slopes: &mut [Complex64]) {
    let mut q = [Complex64::ZERO; 40];
    fill_moments(zeta, moments, &mut q);
    slopes.iter_mut().zip(q).for_each(|(slope, q)| *slope = 2.0 * q);
}

fn fill_moments(zeta: Complex64, moments: &mut [Complex64], q: &mut [Complex64; 40]) {
    let n = moments.len();
    let (plus, minus) = (zeta + 1.0, zeta - 1.0);
    let (log_plus, log_minus) = (finite_log(plus), finite_log(minus));
    q[0] = 0.5 * (log_plus - log_minus);
    let rho = bernstein(zeta);
    if rho.powi(2 * n as i32) < 1e3 {
        legendre_q_forward(zeta, &mut q[..=n]);
    } else {
        legendre_q_backward(zeta, rho, &mut q[..=n]);
    }
    for (k, moment) in moments.iter_mut().enumerate() {
        *moment = match k {
            0 => plus * log_plus - minus * log_minus - 2.0,
            _ => (q[k + 1] - q[k - 1]) * (2.0 / (2.0 * k as f64 + 1.0)),
        };
    }
}

/// log z, with a large finite value at 0 (it is only ever multiplied by 0 or differenced there).
fn finite_log(z: Complex64) -> Complex64 {
    if z.norm_sqr() < 1e-300 { Complex64::new(-690.0, 0.0) } else { z.ln() }
}

/// Q₁ … from Q₀ by the three-term recurrence, stable near the segment.
fn legendre_q_forward(zeta: Complex64, q: &mut [Complex64]) {
    q[1] = zeta * q[0] - 1.0;
    for k in 1..q.len() - 1 {
        let c = k as f64;
        q[k + 1] = (zeta * q[k] * (2.0 * c + 1.0) - q[k - 1] * c) / (c + 1.0);
    }
}

/// Q₁ … from Q₀ by Miller's backward recurrence, where Q is the decaying solution: error ρ^(−2·start).
fn legendre_q_backward(zeta: Complex64, rho: f64, q: &mut [Complex64]) {
    let last = q.len() - 1;
    let start = last + (18.5 / rho.ln()).ceil() as usize;
    let (mut above, mut here) = (Complex64::ZERO, Complex64::new(1e-60, 0.0));
    let exact = q[0];
    for k in (1..=start).rev() {
        let c = k as f64;
        let below = (zeta * here * (2.0 * c + 1.0) - above * (c + 1.0)) / c;
        (above, here) = (here, below);
        if k - 1 <= last {
            q[k - 1] = here;
        }
    }
    let scale = exact / q[0];
    for value in q.iter_mut() {
        *value *= scale;
    }
    q[0] = exact;
}

#[cfg(test)]
mod tests {
    use super::super::legendre::{GaussRule, legendre};
    use super::*;

    /// The same integral by brute force: Gauss's rule on dyadic pieces towards the point of the segment nearest to ζ.
    fn by_quadrature(zeta: Complex64, n: usize) -> Vec<Complex64> {
        let rule = GaussRule::new(30);
        let near = zeta.re.clamp(-1.0, 1.0);
        let mut sums = vec![Complex64::ZERO; n];
        let mut p = vec![0.0; n];
        for end in [-1.0, 1.0] {
            let mut outer = end;
            for level in 0..60 {
                let inner = if level == 59 { near } else { near + (end - near) * 0.5f64.powi(level + 1) };
                for (t, w) in rule.nodes.iter().zip(&rule.weights) {
                    let x = 0.5 * (outer + inner) + 0.5 * (outer - inner) * t;
                    legendre(x, &mut p);
                    let log = (zeta - x).ln() * (0.5 * w * (outer - inner).abs());
                    sums.iter_mut().zip(&p).for_each(|(s, p)| *s += log * p);
                }
                outer = inner;
            }
        }
        sums
    }

    #[test]
    fn agrees_with_quadrature_near_and_far() {
        let points =
            [(0.3, 1e-6), (1.0, 1e-3), (-0.999, 0.01), (0.0, 0.1), (1.05, 0.02), (-1.2, 0.4), (0.5, 1.0), (3.0, -2.0)];
        for (re, im) in points {
            let zeta = Complex64::new(re, im);
            for n in [1, 3, 8, 16, 24] {
                let mut moments = vec![Complex64::ZERO; n];
                log_moments(zeta, &mut moments);
                for (k, (a, b)) in moments.iter().zip(by_quadrature(zeta, n)).enumerate() {
                    assert!((a - b).norm() < 2e-13, "ζ = {zeta}, k = {k} of {n}: {a} against {b}");
                }
            }
        }
    }

    #[test]
    fn ends_of_the_segment_are_finite() {
        let mut moments = [Complex64::ZERO; 4];
        log_moments(Complex64::new(1.0, 0.0), &mut moments);
        for (k, m) in moments.iter().enumerate() {
            let exact = if k == 0 { 2.0 * 2f64.ln() - 2.0 } else { -2.0 / (k * (k + 1)) as f64 };
            assert!((m.re - exact).abs() < 1e-12, "k = {k}: {m}");
        }
    }
}
