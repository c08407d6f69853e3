//! Least squares for power series with real coefficients on half a disk.

use crate::plane::Complex64;

/// Finds Σ cₖ τᵏ, k = 1 … n, real c, from its values on the diameter and on the arc of the upper half of the unit disk.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Where values on the diameter are wanted.
    pub diameter: Vec<f64>,
    /// Where values on the arc are wanted, from right to left.
    pub arc: Vec<Complex64>,
    /// What samples on the arc should err by at most.
    pub accuracy: f64,
    /// Row-major: coefficients from values on the diameter, then real and imaginary parts of those on the arc.
    solve: Vec<f64>,
}

/// The arc ends this far (radians) above the diameter, where the map would be expensive to compute.
const ARC_START: f64 = 0.5;

impl Fit {
    /// Prepares fits of degree n from samples of some accuracy.
    #[must_use]
    pub fn new(degree: usize, accuracy: f64) -> Self {
        let on_diameter = degree + 4;
        let chebyshev = |j: usize| ((j as f64 + 0.5) / on_diameter as f64 * std::f64::consts::PI).cos();
        let diameter: Vec<f64> = (0..on_diameter).map(chebyshev).collect();
        let step = (std::f64::consts::PI - 2.0 * ARC_START) / (degree - 1) as f64;
        let arc: Vec<Complex64> = (0..degree).map(|j| Complex64::cis(ARC_START + step * j as f64)).collect();
        let mut rows: Vec<Vec<f64>> =
            diameter.iter().map(|x| (1..=degree as i32).map(|k| x.powi(k)).collect()).collect();
        let part = |of: fn(Complex64) -> f64| {
            let row = move |t: &Complex64| (1..=degree as u32).map(|k| of(t.powu(k))).collect::<Vec<f64>>();
            arc.iter().map(row).collect::<Vec<_>>()
        };
        rows.extend(part(|z| z.re));
        rows.extend(part(|z| z.im));
        let solve = pseudo_inverse(&rows, degree);
        Self { diameter, arc, accuracy, solve }
    }

    /// The coefficients c₁ … cₙ.
    #[must_use]
    pub fn coefficients(&self, on_diameter: &[f64], on_arc: &[Complex64]) -> Vec<f64> {
        let values: Vec<f64> =
            on_diameter.iter().copied().chain(on_arc.iter().map(|z| z.re)).chain(on_arc.iter().map(|z| z.im)).collect();
        self.solve.chunks_exact(values.len()).map(|row| row.iter().zip(&values).map(|(a, b)| a * b).sum()).collect()
    }
}

/// (AᵀA)⁻¹Aᵀ, row-major. The condition number of A is about 10, so that the normal equations lose one digit.
fn pseudo_inverse(rows: &[Vec<f64>], n: usize) -> Vec<f64> {
    // Cholesky: AᵀA = LLᵀ.
    let mut l = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let product: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
            let known: f64 = (0..j).map(|k| l[i * n + k] * l[j * n + k]).sum();
            l[i * n + j] = if i == j { (product - known).sqrt() } else { (product - known) / l[j * n + j] };
        }
    }
    let mut inverse = vec![0.0; n * rows.len()];
    for (column, row) in rows.iter().enumerate() {
        let mut x = row.clone();
        for i in 0..n {
            let known: f64 = (0..i).map(|k| l[i * n + k] * x[k]).sum();
            x[i] = (x[i] - known) / l[i * n + i];
        }
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|k| l[k * n + i] * x[k]).sum();
            x[i] = (x[i] - known) / l[i * n + i];
        }
        for i in 0..n {
            inverse[i * rows.len() + column] = x[i];
        }
    }
    inverse
}

#[cfg(test)]
mod tests {
    use super::super::power_series::real_value;
    use super::*;

    #[test]
    fn reproduces_functions_with_singularities_outside() {
        let fit = Fit::new(24, 1e-12);
        let f = |t: Complex64| (1.0 - 0.4 * t).powf(0.4) - 1.0 + (1.0 + 0.1 * t * t).ln();
        let on_diameter: Vec<f64> = fit.diameter.iter().map(|&x| f(Complex64::new(x, 0.0)).re).collect();
        let on_arc: Vec<Complex64> = fit.arc.iter().map(|&t| f(t)).collect();
        let c = fit.coefficients(&on_diameter, &on_arc);
        for t in [Complex64::new(0.2, 0.3), Complex64::from_polar(1.0, 0.2), Complex64::new(-1.0, 0.0)] {
            assert!((real_value(&c, t) - f(t)).norm() < 1e-11, "{t}");
        }
    }
}
