//! The polygon back from its prevertices: a check of θ at the vertices that knows nothing of Symm.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Lengths of the sides, up to a common factor, of the polygon with prevertices e^{iθ_k} and interior angles α_k π:
/// side k = ∫ ∏ |2 sin((θ − θ_j)/2)|^(α_j − 1) dθ from θ_k to the next.
///
/// Double-exponential quadrature, with distances to the two ends carried separately so that nothing cancels there; good to
/// rounding for α ≥ 0.1.
pub fn side_lengths(theta: &[f64], alpha: &[f64]) -> Vec<f64> {
    let n = theta.len();
    let side = |k: usize| {
        let next = (k + 1) % n;
        let gap = (theta[next] - theta[k]).rem_euclid(TAU);
        let log_integrand = |behind: f64, ahead: f64| -> f64 {
            let apart = |j: usize| match j {
                j if j == k => behind,
                j if j == next => ahead,
                j => theta[k] + behind - theta[j],
            };
            (0..n).map(|j| (alpha[j] - 1.0) * (2.0 * (0.5 * apart(j)).sin().abs()).ln()).sum()
        };
        let step = 1.0 / 64.0;
        let mut sum = 0.0;
        for i in -330..=330 {
            let x = f64::from(i) * step;
            let q = FRAC_PI_2 * x.sinh();
            // Shares of the gap behind and ahead, both exact near 0.
            let (behind, ahead) = (gap / (1.0 + (-2.0 * q).exp()), gap / (1.0 + (2.0 * q).exp()));
            sum += step * PI * x.cosh() * (log_integrand(behind, ahead) + behind.ln() + (ahead / gap).ln()).exp();
        }
        sum
    };
    (0..n).map(side).collect()
}
