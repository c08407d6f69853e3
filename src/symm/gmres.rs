//! GMRES (Saad & Schultz 1986), preconditioned from the right so that its residual is the true one.

use super::options::Progress;
use super::rows::dot;
use crate::{Error, Result};

/// How an iteration ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Convergence {
    /// Products with the matrix, apart from the first residual.
    pub iterations: usize,
    /// Euclidean norm of the residual, by the recurrence.
    pub residual: f64,
}

/// Improves `x` until |b − A·x| ≤ `tolerance`, for at most `limit` iterations.
/// `apply(x, y)` writes A·x into y, `precondition(r, z)` an approximation of A⁻¹·r into z.
///
/// # Errors
/// [`Error::Cancelled`].
pub fn gmres(
    mut apply: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&[f64], &mut [f64]),
    b: &[f64],
    x: &mut [f64],
    tolerance: f64,
    limit: usize,
    progress: Progress,
) -> Result<Convergence> {
    let n = b.len();
    let mut w = vec![0.0; n];
    apply(x, &mut w);
    let first: Vec<f64> = b.iter().zip(&w).map(|(b, w)| b - w).collect();
    let mut norm = dot(&first, &first).sqrt();
    let rhs_norm = dot(b, b).sqrt();
    let mut basis = vec![first];
    let mut corrections: Vec<Vec<f64>> = Vec::new();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut rotations: Vec<(f64, f64)> = Vec::new();
    let mut rhs = vec![norm];
    while norm > tolerance && columns.len() < limit {
        let k = columns.len();
        // Residuals fall geometrically: the fraction done is the share of the digits.
        let done = (norm / rhs_norm).ln() / (tolerance / rhs_norm).ln();
        if !progress("solve", if done.is_finite() { done.clamp(0.0, 1.0) } else { 0.0 }) {
            return Err(Error::Cancelled);
        }
        let scale = if k == 0 { norm } else { 1.0 };
        basis[k].iter_mut().for_each(|v| *v /= scale);
        let mut z = vec![0.0; n];
        precondition(&basis[k], &mut z);
        apply(&z, &mut w);
        corrections.push(z);
        // Arnoldi by modified Gram–Schmidt.
        let mut column = Vec::with_capacity(k + 2);
        for v in &basis {
            let h = dot(v, &w);
            w.iter_mut().zip(v).for_each(|(w, v)| *w -= h * v);
            column.push(h);
        }
        let height = dot(&w, &w).sqrt();
        for (i, &(c, s)) in rotations.iter().enumerate() {
            (column[i], column[i + 1]) = (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
        }
        let radius = column[k].hypot(height);
        if radius == 0.0 {
            corrections.pop();
            break;
        }
        let (c, s) = (column[k] / radius, height / radius);
        column[k] = radius;
        rotations.push((c, s));
        rhs.push(-s * rhs[k]);
        rhs[k] *= c;
        norm = rhs[k + 1].abs();
        columns.push(column);
        if height == 0.0 {
            break;
        }
        basis.push(w.iter().map(|w| w / height).collect());
    }
    // Back substitution in the triangle that the rotations made.
    let m = columns.len();
    let mut y = rhs[..m].to_vec();
    for i in (0..m).rev() {
        for j in i + 1..m {
            y[i] -= columns[j][i] * y[j];
        }
        y[i] /= columns[i][i];
    }
    for (y, z) in y.iter().zip(&corrections) {
        x.iter_mut().zip(z).for_each(|(x, z)| *x += y * z);
    }
    Ok(Convergence { iterations: m, residual: norm })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_with_and_without_preconditioner() {
        let n = 40;
        let entry = |i: usize, j: usize| if i == j { 3.0 + i as f64 } else { 1.0 / (1.0 + i.abs_diff(j) as f64) };
        let apply = |x: &[f64], y: &mut [f64]| {
            for i in 0..n {
                y[i] = (0..n).map(|j| entry(i, j) * x[j]).sum();
            }
        };
        let exact: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let mut b = vec![0.0; n];
        apply(&exact, &mut b);
        let jacobi =
            |r: &[f64], z: &mut [f64]| z.iter_mut().zip(r).enumerate().for_each(|(i, (z, r))| *z = r / entry(i, i));
        let mut plain = vec![0.0; n];
        let slow = gmres(apply, |r, z| z.copy_from_slice(r), &b, &mut plain, 1e-12, 100, &mut |_, _| true).unwrap();
        let mut helped = vec![0.0; n];
        let fast = gmres(apply, jacobi, &b, &mut helped, 1e-12, 100, &mut |_, _| true).unwrap();
        for x in [plain, helped] {
            assert!(x.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-11));
        }
        assert!(fast.iterations < slow.iterations, "{fast:?} {slow:?}");
    }
}
