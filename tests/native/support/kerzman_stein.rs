//! The boundary correspondence of a smooth region by Kerzman and Stein's integral equation for the Szegő kernel
//! (N. Kerzman, M. R. Trummer, J. Comput. Appl. Math. 14, 1986): a second method, sharing nothing with Symm's.

use conformal_warp::Complex64;
use std::f64::consts::TAU;

/// f(z(t_j)), t_j = 2πj/n, for the map with f(center) = 0 and f'(center) > 0.
pub fn boundary_values(n: usize, center: Complex64, curve: impl Fn(f64) -> Complex64) -> Vec<Complex64> {
    let t = |j: usize| TAU * j as f64 / n as f64;
    let step = 1e-5;
    // Richardson's extrapolation of central differences: 1e-12.
    let slope = |t: f64| {
        let difference = |h: f64| (curve(t + h) - curve(t - h)) / (2.0 * h);
        (4.0 * difference(20.0 * step) - difference(40.0 * step)) / 3.0
    };
    let z: Vec<_> = (0..n).map(|j| curve(t(j))).collect();
    let dz: Vec<_> = (0..n).map(|j| slope(t(j))).collect();
    let tangent = |j: usize| dz[j] / dz[j].norm();
    // Cauchy's kernel H(w, z) = tangent(z)/(2πi (z − w)).
    let cauchy = |w: Complex64, j: usize| tangent(j) / (Complex64::i() * TAU * (z[j] - w));
    // φ + ∫ kφ = ψ with k = √(|z'(t)||z'(s)|)·(conj H(z_s, z_t) − H(z_t, z_s)), as 2n real equations.
    let mut matrix = vec![0.0; 4 * n * n];
    let mut rhs = vec![0.0; 2 * n];
    for i in 0..n {
        let psi = cauchy(center, i).conj() * dz[i].norm().sqrt();
        (rhs[2 * i], rhs[2 * i + 1]) = (psi.re, psi.im);
        for j in 0..n {
            let k = if i == j {
                Complex64::new(1.0, 0.0)
            } else {
                (cauchy(z[j], i).conj() - cauchy(z[i], j)) * (dz[i].norm() * dz[j].norm()).sqrt() * (TAU / n as f64)
            };
            let at = |row: usize, column: usize| (2 * i + row) * 2 * n + 2 * j + column;
            (matrix[at(0, 0)], matrix[at(0, 1)]) = (k.re, -k.im);
            (matrix[at(1, 0)], matrix[at(1, 1)]) = (k.im, k.re);
        }
    }
    eliminate(matrix, &mut rhs);
    (0..n)
        .map(|j| {
            let phi = Complex64::new(rhs[2 * j], rhs[2 * j + 1]);
            -Complex64::i() * tangent(j) * phi / phi.conj()
        })
        .collect()
}

/// Solves a system given row by row, by Gauss's elimination with the largest pivot of each column; `rhs` becomes the answer.
fn eliminate(mut matrix: Vec<f64>, rhs: &mut [f64]) {
    let n = rhs.len();
    for k in 0..n {
        let size = |row: &usize| matrix[row * n + k].abs();
        let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap();
        let (above, below) = matrix.split_at_mut((k + 1) * n);
        let top = &mut above[k * n..];
        if pivot > k {
            top.swap_with_slice(&mut below[(pivot - k - 1) * n..(pivot - k) * n]);
            rhs.swap(k, pivot);
        }
        for (row, i) in below.chunks_exact_mut(n).zip(k + 1..) {
            let factor = row[k] / top[k];
            row[k..].iter_mut().zip(&top[k..]).for_each(|(a, b)| *a -= factor * b);
            rhs[i] -= factor * rhs[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| matrix[k * n + j] * rhs[j]).sum();
        rhs[k] = (rhs[k] - known) / matrix[k * n + k];
    }
}
