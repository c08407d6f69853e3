//! Symm's equation on smooth curves, iterated: what they differ from circles by is smooth.

use super::gmres::gmres;
use super::rows::dot;
use crate::plane::Complex64;
use crate::plane::fourier::{sum_of_waves, transform};
use std::ops::Range;

/// The bordered matrix, and how to iterate with it.
#[derive(Debug)]
pub struct CircleIteration {
    /// The nodes of each curve.
    loops: Vec<Range<usize>>,
    /// Row-major; after the nodes, the constant and the total mass of each curve.
    matrix: Vec<f64>,
    /// The potential on each curve of a mass 1 spread evenly over it.
    own_potentials: Vec<f64>,
}

/// Iterations after which rounding is all that is left, or the curve is not resolved: 10 to 60 are usual.
const MOST_ITERATIONS: usize = 150;
/// Residuals are brought down to this share of what is given.
const ACCURACY: f64 = 2e-15;

impl CircleIteration {
    /// Of a bordered matrix in row-major order.
    #[must_use]
    pub fn new(loops: Vec<Range<usize>>, matrix: Vec<f64>) -> Self {
        let size = loops.last().map_or(0, |last| last.end) + loops.len();
        let mean = |own: &Range<usize>| {
            let rows = own.clone().map(|i| matrix[i * size..][own.clone()].iter().sum::<f64>());
            rows.sum::<f64>() / (own.len() * own.len()) as f64
        };
        let own_potentials = loops.iter().map(mean).collect();
        Self { loops, matrix, own_potentials }
    }

    /// Masses and constants for potentials at the nodes and charges.
    #[must_use]
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; b.len()];
        let apply = |x: &[f64], y: &mut [f64]| {
            self.matrix.chunks_exact(x.len()).zip(y).for_each(|(row, value)| *value = dot(row, x));
        };
        let tolerance = ACCURACY * dot(b, b).sqrt();
        // Short and never cancelled: what it leaves shows in the residuals. A second pass mends what rounding left in the first.
        for _ in 0..2 {
            let _ = gmres(apply, |r, z| self.on_circles(r, z), b, &mut x, tolerance, MOST_ITERATIONS, &mut |_, _| true);
        }
        x
    }

    /// The solution if every curve were a circle, far from all others: there the wave e^{ikt} of masses at n nodes has the potential
    /// −n/(2|k|) times itself.
    fn on_circles(&self, r: &[f64], z: &mut [f64]) {
        let nodes = r.len() - self.loops.len();
        for (curve, (own, potential)) in self.loops.iter().zip(&self.own_potentials).enumerate() {
            let n = own.len();
            let values: Vec<Complex64> = r[own.clone()].iter().map(|r| Complex64::from(*r)).collect();
            let mut waves = transform(&values);
            let (mean, charge) = (waves[0].re / n as f64, r[nodes + curve]);
            waves[0] = Complex64::from(charge);
            for (k, wave) in waves.iter_mut().enumerate().skip(1) {
                *wave *= -2.0 * k.min(n - k) as f64 / n as f64;
            }
            let masses = sum_of_waves(&waves);
            z[own.clone()].iter_mut().zip(masses).for_each(|(z, mass)| *z = mass.re / n as f64);
            z[nodes + curve] = mean - charge * potential;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::lu::Lu;
    use super::*;
    use std::f64::consts::TAU;

    /// Two curves: what waves do on circles, and a smooth part.
    #[test]
    fn agrees_with_a_factorisation() {
        let (loops, n) = (vec![0..64, 64..160], 160);
        let size = n + 2;
        let mut matrix = vec![0.0; size * size];
        for (curve, own) in loops.iter().enumerate() {
            let count = own.len() as f64;
            for i in own.clone() {
                for j in 0..n {
                    let angle = TAU * (i as f64 - j as f64) / count;
                    let waves = (1..own.len() / 2).map(|k| (angle * k as f64).cos() / k as f64).sum::<f64>();
                    let smooth = 0.2 * (TAU * (i + 2 * j) as f64 / count).cos() + 0.3;
                    let own_part = -waves - (angle * 0.5 * count).cos() / count + smooth;
                    matrix[i * size + j] = if own.contains(&j) { own_part } else { 1.0 };
                }
                matrix[i * size + n + curve] = 1.0;
                matrix[(n + curve) * size + i] = 1.0;
            }
        }
        let b: Vec<f64> = (0..size).map(|i| ((i * 37) % 11) as f64 / 11.0).collect();
        let mut exact = b.clone();
        Lu::new(size, matrix.clone()).solve(&mut exact);
        let found = CircleIteration::new(loops, matrix).solve(&b);
        for (found, exact) in found.iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
    }
}
