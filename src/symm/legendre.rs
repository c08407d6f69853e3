//! Legendre polynomials and Gauss's rule: how a panel stores its density.

use super::rows::add_scaled;
use crate::plane::Complex64;

/// Writes P₀(x) … P₍ₙ₋₁₎(x) into `values` (n = its length).
pub fn legendre(x: f64, values: &mut [f64]) {
    let (mut previous, mut current) = (0.0, 1.0);
    for (k, value) in values.iter_mut().enumerate() {
        *value = current;
        let k = k as f64;
        (previous, current) = (current, ((2.0 * k + 1.0) * x * current - k * previous) / (k + 1.0));
    }
}

/// Gauss–Legendre nodes and weights on [−1, 1], with the maps between nodal values and Legendre coefficients.
#[derive(Clone, Debug)]
pub struct GaussRule {
    /// Nodes, ascending.
    pub nodes: Vec<f64>,
    /// Weights; their sum is 2.
    pub weights: Vec<f64>,
    /// Row-major n × n: coefficient k = Σ_j `to_coefficients[k·n + j]` · value at node j.
    to_coefficients: Vec<f64>,
}

impl GaussRule {
    /// The rule with `n` nodes: roots of Pₙ by Newton's method from Chebyshev's guess.
    #[must_use]
    pub fn new(n: usize) -> Self {
        let mut p = vec![0.0; n + 1];
        let mut nodes = vec![0.0; n];
        let mut weights = vec![0.0; n];
        for j in 0..n {
            let mut x = -((j as f64 + 0.75) / (n as f64 + 0.5) * std::f64::consts::PI).cos();
            let mut slope = 1.0;
            for _ in 0..8 {
                legendre(x, &mut p);
                slope = n as f64 * (p[n - 1] - x * p[n]) / (1.0 - x * x);
                x -= p[n] / slope;
            }
            nodes[j] = x;
            weights[j] = 2.0 / ((1.0 - x * x) * slope * slope);
        }
        let mut to_coefficients = vec![0.0; n * n];
        for j in 0..n {
            legendre(nodes[j], &mut p[..n]);
            for k in 0..n {
                to_coefficients[k * n + j] = (k as f64 + 0.5) * weights[j] * p[k];
            }
        }
        Self { nodes, weights, to_coefficients }
    }

    /// Number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Row k of the matrix nodal values → Legendre coefficients.
    #[must_use]
    pub fn coefficient_row(&self, k: usize) -> &[f64] {
        &self.to_coefficients[k * self.len()..][..self.len()]
    }

    /// Writes the Lagrange basis of the nodes at `x` into `basis`.
    pub fn lagrange(&self, x: f64, basis: &mut [f64]) {
        let n = self.len();
        let mut p = [0.0; MAX_NODES];
        legendre(x, &mut p[..n]);
        basis.fill(0.0);
        for (value, row) in p.iter().zip(self.to_coefficients.chunks_exact(n)) {
            add_scaled(basis, *value, row);
        }
    }
}

/// More nodes than any rule here needs; sizes stack buffers.
pub const MAX_NODES: usize = 32;

/// m × m matrices that carry masses on the nodes of the inner half [0, ½], and of the outer half [½, 1], to masses on
/// the nodes of [0, 1] with the same first m moments.
#[must_use]
pub fn restrictions(rule: &GaussRule) -> [Vec<f64>; 2] {
    let m = rule.len();
    let mut basis = vec![0.0; m];
    [-0.5, 0.5].map(|shift| {
        let mut matrix = vec![0.0; m * m];
        for from in 0..m {
            rule.lagrange(shift + 0.5 * rule.nodes[from], &mut basis);
            for to in 0..m {
                matrix[to * m + from] = basis[to];
            }
        }
        matrix
    })
}

/// m × m: Legendre coefficients (in t on [−1, 1]) of the density that has the given masses at the nodes.
#[must_use]
pub fn coefficients_of_masses(rule: &GaussRule) -> Vec<f64> {
    let m = rule.len();
    (0..m * m).map(|index| rule.coefficient_row(index / m)[index % m] / rule.weights[index % m]).collect()
}

/// Σ cₖ Pₖ(x) for complex x.
pub(super) fn complex_sum(coefficients: &[f64], x: Complex64) -> Complex64 {
    let (mut before, mut here) = (Complex64::ZERO, Complex64::ONE);
    let mut sum = Complex64::ZERO;
    for (k, c) in coefficients.iter().enumerate() {
        sum += here * *c;
        let k = k as f64;
        (before, here) = (here, (x * here * (2.0 * k + 1.0) - before * k) / (k + 1.0));
    }
    sum
}

/// Σ cₖ ∫ Pₖ from −1 to complex x, by ∫Pₖ = (P₍ₖ₊₁₎ − P₍ₖ₋₁₎)/(2k+1).
pub(super) fn complex_integral(coefficients: &[f64], x: Complex64) -> Complex64 {
    let (mut before, mut here) = (Complex64::ONE, x);
    let mut sum = (x + 1.0) * coefficients[0];
    for (k, c) in coefficients.iter().enumerate().skip(1) {
        let k = k as f64;
        let after = (x * here * (2.0 * k + 1.0) - before * k) / (k + 1.0);
        sum += (after - before) * (c / (2.0 * k + 1.0));
        (before, here) = (here, after);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrates_polynomials_up_to_twice_its_order() {
        for n in [1, 2, 5, 8, 16, 24] {
            let rule = GaussRule::new(n);
            for power in 0..2 * n {
                let sum: f64 = rule.nodes.iter().zip(&rule.weights).map(|(x, w)| w * x.powi(power as i32)).sum();
                let exact = if power % 2 == 0 { 2.0 / (power as f64 + 1.0) } else { 0.0 };
                assert!((sum - exact).abs() < 4e-15, "n = {n}, power {power}: {sum}");
            }
        }
    }

    #[test]
    fn lagrange_basis_reproduces_polynomials() {
        let rule = GaussRule::new(7);
        let mut basis = [0.0; 7];
        for x in [-1.0, -0.3, 0.77, 1.0] {
            rule.lagrange(x, &mut basis);
            let value: f64 = basis.iter().zip(&rule.nodes).map(|(b, t)| b * t.powi(6)).sum();
            assert!((value - x.powi(6)).abs() < 1e-14);
        }
    }
}
