//! The loops over rows of numbers in which solving spends its time, two numbers at a time where simd128 is: the package is
//! built with an optimisation level that makes no vectors of unrolled code by itself.
//!
//! Both ways add in the same order, so that they give the same bits.

#[cfg(target_feature = "simd128")]
use pair::Pair;
#[cfg(not(target_feature = "simd128"))]
use scalars::Pair;

/// Rows and columns of the register tile.
pub const TILE: usize = 4;

/// `row` += factor · `other`.
#[inline]
pub fn add_scaled(row: &mut [f64], factor: f64, other: &[f64]) {
    if cfg!(not(target_feature = "simd128")) {
        row.iter_mut().zip(other).for_each(|(r, x)| *r += factor * x);
        return;
    }
    let common = row.len().min(other.len());
    let (row4, row_rest) = row[..common].as_chunks_mut::<4>();
    let (other4, other_rest) = other[..common].as_chunks::<4>();
    let factors = Pair::both(factor);
    for (r, x) in row4.iter_mut().zip(other4) {
        let [r0, r1] = Pair::two(r);
        let [x0, x1] = Pair::two(x);
        let sums = [r0.plus(factors.times(x0)), r1.plus(factors.times(x1))];
        Pair::put(sums, r);
    }
    row_rest.iter_mut().zip(other_rest).for_each(|(r, x)| *r += factor * x);
}

/// Σ aᵢbᵢ with eight partial sums.
#[must_use]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a8, a_rest) = a.as_chunks::<8>();
    let (b8, b_rest) = b.as_chunks::<8>();
    let mut sums = [Pair::both(0.0); 4];
    for (x, y) in a8.iter().zip(b8) {
        let (x, y) = (x.as_chunks::<4>().0, y.as_chunks::<4>().0);
        let ([x0, x1], [x2, x3]) = (Pair::two(&x[0]), Pair::two(&x[1]));
        let ([y0, y1], [y2, y3]) = (Pair::two(&y[0]), Pair::two(&y[1]));
        sums[0] = sums[0].plus(x0.times(y0));
        sums[1] = sums[1].plus(x1.times(y1));
        sums[2] = sums[2].plus(x2.times(y2));
        sums[3] = sums[3].plus(x3.times(y3));
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(x, y)| x * y).sum();
    sums.iter().flat_map(|pair| pair.numbers()).sum::<f64>() + rest
}

/// Σ_k left[k] ⊗ right[k].
pub fn tile_product(left: &[[f64; TILE]], right: &[f64]) -> [[f64; TILE]; TILE] {
    let mut sums = [[Pair::both(0.0); 2]; TILE];
    for (l, r) in left.iter().zip(right.as_chunks::<TILE>().0) {
        let [r0, r1] = Pair::two(r);
        for (sum, factor) in sums.iter_mut().zip(l) {
            let factors = Pair::both(*factor);
            *sum = [sum[0].plus(factors.times(r0)), sum[1].plus(factors.times(r1))];
        }
    }
    sums.map(|sum| {
        let mut row = [0.0; TILE];
        Pair::put(sum, &mut row);
        row
    })
}

#[cfg(target_feature = "simd128")]
mod pair {
    use core::arch::wasm32::*;

    #[derive(Clone, Copy)]
    pub struct Pair(v128);

    impl Pair {
        #[inline(always)]
        pub fn both(x: f64) -> Self {
            Self(f64x2_splat(x))
        }

        #[inline(always)]
        pub fn two(numbers: &[f64; 4]) -> [Self; 2] {
            let from = numbers.as_ptr().cast::<v128>();
            #[expect(unsafe_code, reason = "32 bytes are there: their type says so")]
            unsafe {
                [Self(v128_load(from)), Self(v128_load(from.add(1)))]
            }
        }

        #[inline(always)]
        pub fn put([first, second]: [Self; 2], numbers: &mut [f64; 4]) {
            let to = numbers.as_mut_ptr().cast::<v128>();
            #[expect(unsafe_code, reason = "32 bytes are there: their type says so")]
            unsafe {
                v128_store(to, first.0);
                v128_store(to.add(1), second.0);
            }
        }

        #[inline(always)]
        pub fn plus(self, other: Self) -> Self {
            Self(f64x2_add(self.0, other.0))
        }

        #[inline(always)]
        pub fn times(self, other: Self) -> Self {
            Self(f64x2_mul(self.0, other.0))
        }

        #[inline(always)]
        pub fn numbers(self) -> [f64; 2] {
            [f64x2_extract_lane::<0>(self.0), f64x2_extract_lane::<1>(self.0)]
        }
    }
}

#[cfg(not(target_feature = "simd128"))]
mod scalars {
    #[derive(Clone, Copy)]
    pub struct Pair([f64; 2]);

    impl Pair {
        pub fn both(x: f64) -> Self {
            Self([x; 2])
        }

        pub fn two(&[a, b, c, d]: &[f64; 4]) -> [Self; 2] {
            [Self([a, b]), Self([c, d])]
        }

        pub fn put([Self([a, b]), Self([c, d])]: [Self; 2], numbers: &mut [f64; 4]) {
            *numbers = [a, b, c, d];
        }

        pub fn plus(self, other: Self) -> Self {
            Self([self.0[0] + other.0[0], self.0[1] + other.0[1]])
        }

        pub fn times(self, other: Self) -> Self {
            Self([self.0[0] * other.0[0], self.0[1] * other.0[1]])
        }

        pub fn numbers(self) -> [f64; 2] {
            self.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_and_short_rows_are_what_the_formulas_say() {
        for n in 0..20 {
            let a: Vec<f64> = (0..n).map(|k| (k * k) as f64 - 7.0).collect();
            let b: Vec<f64> = (0..n).map(|k| 3.0 - k as f64).collect();
            let product: f64 = (0..n).map(|k| a[k] * b[k]).sum();
            assert_eq!(dot(&a, &b), product);
            let mut row = a.clone();
            add_scaled(&mut row, 0.5, &b);
            assert!((0..n).all(|k| row[k] == a[k] + 0.5 * b[k]));
        }
    }

    #[test]
    fn a_tile_is_a_sum_of_outer_products() {
        let left = [[1.0, 2.0, 3.0, 4.0], [-1.0, 0.0, 1.0, 0.5]];
        let right = [5.0, 6.0, 7.0, 8.0, 2.0, 4.0, 6.0, 8.0];
        let tile = tile_product(&left, &right);
        for i in 0..TILE {
            for j in 0..TILE {
                assert_eq!(tile[i][j], left[0][i] * right[j] + left[1][i] * right[4 + j]);
            }
        }
    }
}
