//! Dense LU factorisation with partial pivoting, blocked so that the inner loop stays in registers.

use super::rows::{TILE, add_scaled, dot, tile_product};

/// P·A = L·U of a square matrix.
#[derive(Clone, Debug)]
pub struct Lu {
    n: usize,
    /// Row-major: U on and above the diagonal, the multipliers of L below it.
    factors: Vec<f64>,
    /// Row k was exchanged with row `pivots[k]`.
    pivots: Vec<u32>,
}

/// Columns factored at a time.
const BLOCK: usize = 48;

impl Lu {
    /// Factors the row-major n × n matrix in `matrix`. A zero pivot leaves infinities, which the caller's residual shows.
    #[must_use]
    pub fn new(n: usize, matrix: Vec<f64>) -> Self {
        let mut lu = Self { n, factors: matrix, pivots: vec![0; n] };
        let mut packed = vec![0.0; BLOCK * n];
        for start in (0..n).step_by(BLOCK) {
            let end = (start + BLOCK).min(n);
            lu.factor_columns(start, end);
            lu.solve_block_row(start, end);
            lu.update_trailing(start, end, &mut packed);
        }
        lu
    }

    /// Eliminates columns `start..end` below the diagonal, exchanging whole rows.
    fn factor_columns(&mut self, start: usize, end: usize) {
        let n = self.n;
        for k in start..end {
            let column = |row: usize| self.factors[row * n + k].abs();
            let pivot = (k..n).fold(k, |best, row| if column(row) > column(best) { row } else { best });
            self.pivots[k] = pivot as u32;
            if pivot != k {
                let (upper, lower) = self.factors.split_at_mut(pivot * n);
                upper[k * n..][..n].swap_with_slice(&mut lower[..n]);
            }
            let (upper, lower) = self.factors.split_at_mut((k + 1) * n);
            let pivot_row = &upper[k * n + k..k * n + end];
            let inverse = 1.0 / pivot_row[0];
            for row in lower.chunks_exact_mut(n) {
                let row = &mut row[k..end];
                row[0] *= inverse;
                let factor = row[0];
                add_scaled(&mut row[1..], -factor, &pivot_row[1..]);
            }
        }
    }

    /// U of the block row: forward substitution with the unit lower triangle just found.
    fn solve_block_row(&mut self, start: usize, end: usize) {
        let n = self.n;
        for k in start..end {
            let (upper, lower) = self.factors.split_at_mut((k + 1) * n);
            let pivot_row = &upper[k * n + end..];
            for row in lower.chunks_exact_mut(n).take(end - k - 1) {
                let factor = row[k];
                add_scaled(&mut row[end..], -factor, pivot_row);
            }
        }
    }

    /// A₂₂ −= L₂₁·U₁₂ in register tiles; U₁₂ is packed tile by tile first.
    fn update_trailing(&mut self, start: usize, end: usize, packed: &mut [f64]) {
        let (n, depth) = (self.n, end - start);
        let tiles = (n - end) / TILE;
        for tile in 0..tiles {
            for k in 0..depth {
                let from = (start + k) * n + end + tile * TILE;
                packed[(tile * depth + k) * TILE..][..TILE].copy_from_slice(&self.factors[from..from + TILE]);
            }
        }
        let (upper, lower) = self.factors.split_at_mut(end * n);
        let remainder = end + tiles * TILE;
        let mut left = [[0.0; TILE]; BLOCK];
        let mut bands = lower.chunks_exact_mut(TILE * n);
        for band in &mut bands {
            for (k, l) in left[..depth].iter_mut().enumerate() {
                *l = std::array::from_fn(|i| band[i * n + start + k]);
            }
            for tile in 0..tiles {
                let product = tile_product(&left[..depth], &packed[tile * depth * TILE..][..depth * TILE]);
                for (i, values) in product.iter().enumerate() {
                    let row = &mut band[i * n + end + tile * TILE..][..TILE];
                    row.iter_mut().zip(values).for_each(|(r, v)| *r -= v);
                }
            }
            for i in 0..TILE {
                subtract_row_product(&mut band[i * n..][..n], upper, start..end, remainder);
            }
        }
        for row in bands.into_remainder().chunks_exact_mut(n) {
            subtract_row_product(row, upper, start..end, end);
        }
    }

    /// Solves A·x = b in place.
    pub fn solve(&self, b: &mut [f64]) {
        let n = self.n;
        for (k, &pivot) in self.pivots.iter().enumerate() {
            b.swap(k, pivot as usize);
        }
        for k in 1..n {
            b[k] -= dot(&self.factors[k * n..][..k], &b[..k]);
        }
        for k in (0..n).rev() {
            let row = &self.factors[k * n..][..n];
            b[k] = (b[k] - dot(&row[k + 1..], &b[k + 1..])) / row[k];
        }
    }
}

/// x of A·x = b, A row-major, for a few unknowns.
#[must_use]
pub fn small_solve(matrix: Vec<f64>, mut b: Vec<f64>) -> Vec<f64> {
    Lu::new(b.len(), matrix).solve(&mut b);
    b
}

/// `row[from..]` −= Σ_k `row[k]` · (row k of `upper`)`[from..]`.
fn subtract_row_product(row: &mut [f64], upper: &[f64], columns: std::ops::Range<usize>, from: usize) {
    let n = row.len();
    if from == n {
        return;
    }
    for k in columns {
        let factor = row[k];
        add_scaled(&mut row[from..], -factor, &upper[k * n + from..][..n - from]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_systems_of_every_size_class() {
        for n in [1, 2, 5, 47, 48, 49, 101, 150] {
            let mut seed = 12345u64;
            let mut random = || {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
            };
            let matrix: Vec<f64> = (0..n * n).map(|_| random()).collect();
            let x: Vec<f64> = (0..n).map(|_| random()).collect();
            let mut b: Vec<f64> = matrix.chunks_exact(n).map(|row| dot(row, &x)).collect();
            Lu::new(n, matrix).solve(&mut b);
            let error = x.iter().zip(&b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(error < 1e-10, "n = {n}: {error:e}");
        }
    }
}
