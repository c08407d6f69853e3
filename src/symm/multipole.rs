//! Multipole expansions Q log(z − b) + Σ aₖ/(z − b)ᵏ of clusters, scaled by the clusters' radii so that no size overflows.

use super::clusters::Cluster;
use crate::plane::Complex64;

/// Adds a child's expansion to its parent's: aₗ += Σₖ C(l−1, k−1) aₖ d^(l−k) − Q dˡ/l, d = child − parent.
pub fn shift_multipole(child: &Cluster, from: &[Complex64], parent: &Cluster, to: &mut [Complex64]) {
    let shift = (child.center - parent.center) / parent.radius;
    let shrink = child.radius / parent.radius;
    to[0] += from[0];
    let mut scaled: Vec<Complex64> = Vec::with_capacity(from.len());
    let mut power = 1.0;
    for a in &from[1..] {
        power *= shrink;
        scaled.push(a * power);
    }
    let mut shift_power = Complex64::ONE;
    for l in 1..from.len() {
        shift_power *= shift;
        // C(l−1, k−1) d^(l−k) by the ratio of neighbours.
        let mut factor = Complex64::ONE;
        let mut sum = -from[0] * shift_power / l as f64;
        for k in (1..=l).rev() {
            sum += scaled[k - 1] * factor;
            factor *= shift * ((k - 1) as f64 / (l - k + 1) as f64);
        }
        to[l] += sum;
    }
}

/// Σ cₖ tᵏ as a series in u, t = shift + shrink·u: a Taylor series in a circle within the first, by repeated synthetic division.
#[must_use]
pub fn shift_series(mut series: Vec<Complex64>, shift: Complex64, shrink: f64) -> Vec<Complex64> {
    let mut power = 1.0;
    for l in 0..series.len() {
        for k in (l..series.len() - 1).rev() {
            let above = series[k + 1];
            series[k] += above * shift;
        }
        series[l] *= power;
        power *= shrink;
    }
    series
}

/// Row r, column c of `rows` × `columns`: C(r + c, c).
#[must_use]
pub fn binomials(rows: usize, columns: usize) -> Vec<f64> {
    let mut table = Vec::with_capacity(rows * columns);
    for r in 0..rows {
        let mut value = 1.0;
        for c in 0..columns {
            table.push(value);
            value *= (r + c + 1) as f64 / (c + 1) as f64;
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shifted_expansion_is_the_same_field() {
        let cluster =
            |re: f64, radius: f64| Cluster { panels: 0..1, center: Complex64::new(re, 0.1), radius, children: None };
        let (child, parent) = (cluster(0.2, 0.25), cluster(0.0, 0.5));
        let own: Vec<Complex64> =
            (0..40).map(|k| Complex64::new(1.0, 0.3 * f64::from(k)) / f64::from(1 + k * k)).collect();
        let mut shifted = vec![Complex64::ZERO; 40];
        shift_multipole(&child, &own, &parent, &mut shifted);
        let field = |cluster: &Cluster, terms: &[Complex64], z: Complex64| {
            let place = cluster.radius / (z - cluster.center);
            let series = terms[1..].iter().rev().fold(Complex64::ZERO, |sum, a| (sum + a) * place);
            terms[0] * (z - cluster.center).ln() + series
        };
        for turn in 0..8 {
            let z = parent.center + Complex64::from_polar(1.5, f64::from(turn) * 0.7);
            let apart = field(&child, &own, z) - field(&parent, &shifted, z);
            assert!(apart.norm() < 1e-13, "{z}: {apart}");
        }
    }
}
