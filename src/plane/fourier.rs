//! Discrete Fourier transforms of any length, in O(n log n).

use super::Complex64;
use std::f64::consts::TAU;

/// X_k = Σ_j x_j e^{−2πijk/n}.
#[must_use]
pub(crate) fn transform(x: &[Complex64]) -> Vec<Complex64> {
    let n = x.len();
    if n.is_power_of_two() { radix_2(x.to_vec()) } else { chirp(x) }
}

/// x_j = Σ_k X_k e^{2πijk/n}: n times the inverse of [`transform`].
#[must_use]
pub(crate) fn sum_of_waves(x: &[Complex64]) -> Vec<Complex64> {
    let mut x = transform(x);
    // Frequency −k stands at n − k.
    x[1..].reverse();
    x
}

/// Cooley and Tukey's algorithm for powers of two.
fn radix_2(mut x: Vec<Complex64>) -> Vec<Complex64> {
    let n = x.len();
    if n < 2 {
        return x;
    }
    let shift = usize::BITS - n.trailing_zeros();
    for j in 0..n {
        let k = j.reverse_bits() >> shift;
        if j < k {
            x.swap(j, k);
        }
    }
    let turns: Vec<Complex64> = (0..n / 2).map(|k| Complex64::cis(-TAU * k as f64 / n as f64)).collect();
    let mut half = 1;
    while half < n {
        for block in x.chunks_exact_mut(2 * half) {
            let (even, odd) = block.split_at_mut(half);
            for (k, (a, b)) in even.iter_mut().zip(odd).enumerate() {
                let turned = *b * turns[k * (n / (2 * half))];
                (*a, *b) = (*a + turned, *a - turned);
            }
        }
        half *= 2;
    }
    x
}

/// Bluestein's algorithm: jk = (j² + k² − (k − j)²)/2 makes the sum a convolution, done in a power of two.
fn chirp(x: &[Complex64]) -> Vec<Complex64> {
    let n = x.len();
    let chirp: Vec<Complex64> =
        (0..n).map(|k| Complex64::cis(-TAU * (k * k % (2 * n)) as f64 / (2 * n) as f64)).collect();
    let size = (2 * n - 1).next_power_of_two();
    let mut a = vec![Complex64::ZERO; size];
    let mut b = vec![Complex64::ZERO; size];
    for k in 0..n {
        a[k] = x[k] * chirp[k];
        b[k] = chirp[k].conj();
        b[(size - k) % size] = b[k];
    }
    let (a, b) = (radix_2(a), radix_2(b));
    let product: Vec<Complex64> = a.iter().zip(&b).map(|(a, b)| a * b / size as f64).collect();
    sum_of_waves(&product)[..n].iter().zip(&chirp).map(|(sum, turn)| sum * turn).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_sum_for_every_length() {
        for n in [1, 2, 3, 8, 15, 64, 97, 360] {
            let x: Vec<Complex64> =
                (0..n).map(|j| Complex64::new((j as f64).sin(), (1.7 * j as f64).cos() - 0.2)).collect();
            let direct = |k: usize| -> Complex64 {
                x.iter().enumerate().map(|(j, x)| x * Complex64::cis(-TAU * (j * k % n) as f64 / n as f64)).sum()
            };
            let found = transform(&x);
            for (k, found) in found.iter().enumerate() {
                assert!((found - direct(k)).norm() < 1e-14 * n as f64, "{n} {k}: {found}");
            }
            for (back, x) in sum_of_waves(&found).iter().zip(&x) {
                assert!((back / n as f64 - x).norm() < 1e-14, "{n}: {back} for {x}");
            }
        }
    }
}
