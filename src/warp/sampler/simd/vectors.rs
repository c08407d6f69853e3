//! Rows of pixels as vectors: four at a time in, four at a time out.

use crate::warp::sampler::fold::Fold;
use crate::warp::sampler::input::{Pyramid, Row};
use core::arch::wasm32::*;

/// Weighted sums of texels, one vector of four channels for each of four pixels, in units of 1/[`ONE`](super::taps::ONE).
pub type Sums = [v128; 4];

/// Added to a number below 2²², it leaves the nearest integer in the low bits: much cheaper than a conversion.
pub const ROUNDER: f32 = 12_582_912.0;

/// Draws the row: `pixels(u, v, column)` are four pixels' bytes, those that show nothing included.
#[inline(always)]
pub fn each_four(row: Row<'_>, line: &mut [u8], pixels: impl Fn(v128, v128, usize) -> v128) {
    for (group, bytes) in line.chunks_mut(16).enumerate() {
        let at = 4 * group;
        let (u, v) = (four(row.u, at), four(row.v, at));
        let shown = v128_and(f32x4_eq(u, u), f32x4_eq(v, v));
        let four = if v128_any_true(shown) { v128_and(pixels(u, v, at), shown) } else { shown };
        put(bytes, four);
    }
}

/// Numbers `at` to `at + 3`; rows are whole groups of four.
#[inline(always)]
pub fn four(plane: &[f32], at: usize) -> v128 {
    let numbers = &plane[at..at + 4];
    #[expect(unsafe_code, reason = "four numbers are there: the range says so")]
    unsafe {
        v128_load(numbers.as_ptr().cast())
    }
}

/// Writes four pixels, or as many as there is room for.
#[inline(always)]
pub fn put(bytes: &mut [u8], four: v128) {
    if let Ok(bytes) = <&mut [u8; 16]>::try_from(&mut *bytes) {
        #[expect(unsafe_code, reason = "sixteen bytes are there: their type says so")]
        unsafe {
            v128_store(bytes.as_mut_ptr().cast(), four);
        }
    } else {
        let lanes = [u64x2_extract_lane::<0>(four), u64x2_extract_lane::<1>(four)];
        for (bytes, lane) in bytes.chunks_mut(8).zip(lanes) {
            bytes.copy_from_slice(&lane.to_le_bytes()[..bytes.len()]);
        }
    }
}

#[inline(always)]
pub fn plus(a: Sums, b: Sums) -> Sums {
    [i32x4_add(a[0], b[0]), i32x4_add(a[1], b[1]), i32x4_add(a[2], b[2]), i32x4_add(a[3], b[3])]
}

/// Which of four texels along an axis (the border's included) are not the border's: they are 1 to `size`.
#[inline(always)]
pub fn is_inner(at: v128, size: i32) -> v128 {
    v128_and(i32x4_gt(at, i32x4_splat(0)), i32x4_le(at, i32x4_splat(size)))
}

/// The texture's sizes and their reciprocals, for folding.
pub struct Axes {
    fold: Fold,
    sizes: [v128; 2],
    reciprocals: [v128; 2],
}

impl Axes {
    #[inline(always)]
    pub fn of<T>(pyramid: &Pyramid<'_, T>, fold: Fold) -> Self {
        let base = &pyramid.levels[0];
        let sizes = [base.width as f32, base.height as f32];
        Self { fold, sizes: sizes.map(|n| f32x4_splat(n)), reciprocals: sizes.map(|n| f32x4_splat(1.0 / n)) }
    }

    #[inline(always)]
    pub fn folded(&self, u: v128, v: v128) -> (v128, v128) {
        let fold = |t: v128, k: usize| self.fold.apply4(t, self.sizes[k], self.reciprocals[k]);
        (fold(u, 0), fold(v, 1))
    }
}
