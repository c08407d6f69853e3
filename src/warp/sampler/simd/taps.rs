//! Four bilinear samples of one level: which texels, with which weights.

use super::texel::Texel;
use super::vectors::{ROUNDER, Sums, is_inner};
use crate::warp::pyramid::Level;
use crate::warp::sampler::fold::Fold;
use core::arch::wasm32::*;

/// Weights are integers that sum to this, a power of two that 16 bits hold.
pub const ONE: f32 = (1 << WEIGHT_BITS) as f32;
pub const WEIGHT_BITS: u32 = 14;

/// Four samples of one level: the texel before each, and how far beyond it they lie.
pub struct Taps {
    index: v128,
    stride: usize,
    column: Along,
    row: Along,
    x: v128,
    y: v128,
}

/// The texels (the border's included) before four points on an axis of so many texels.
struct Along {
    before: v128,
    size: usize,
}

/// The weights of four samples' taps: of the tap itself, the one on its right, and the same two a row below.
///
/// Integers, but for [`ROUNDER`] in their upper half.
pub struct Weights([v128; 4]);

impl Taps {
    /// `u` and `v` in texels of level 0.
    #[inline(always)]
    pub fn new(level: &Level, u: v128, v: v128) -> Self {
        let (column, x) = cell(u, level.scale[0], level.width);
        let (row, y) = cell(v, level.scale[1], level.height);
        let index = i32x4_add(i32x4_mul(row, i32x4_splat(level.stride as i32)), column);
        Self {
            index: i32x4_add(index, i32x4_splat(level.offset as i32)),
            stride: level.stride,
            column: Along { before: column, size: level.width },
            row: Along { before: row, size: level.height },
            x,
            y,
        }
    }

    /// Bilinear weights with the sum `share` (0 to [`ONE`]), each rounded.
    #[inline(always)]
    pub fn weights(&self, share: v128) -> Weights {
        let right = f32x4_mul(self.x, share);
        let left = f32x4_sub(share, right);
        let (below_left, below_right) = (f32x4_mul(left, self.y), f32x4_mul(right, self.y));
        let taps = [f32x4_sub(left, below_left), f32x4_sub(right, below_right), below_left, below_right];
        Weights(taps.map(|t| f32x4_add(t, f32x4_splat(ROUNDER))))
    }

    #[inline(always)]
    pub fn sums<T: Texel>(&self, texels: &[T], fold: Fold, weights: Weights) -> Sums {
        let weights = if fold.is_framed() { weights.within(&self.column, &self.row) } else { weights };
        let [left, right] = weights.pairs();
        let sum = |index: i32, left: v128, right: v128| {
            let index = index as usize;
            debug_assert!(index + self.stride + 2 <= texels.len());
            #[expect(
                unsafe_code,
                reason = "`cell` keeps to the level and its border; checked loads are a third slower"
            )]
            let [first, second] = unsafe {
                let upper = texels.as_ptr().add(index);
                T::columns(upper, upper.add(self.stride))
            };
            i32x4_add(i32x4_dot_i16x8(first, left), i32x4_dot_i16x8(second, right))
        };
        macro_rules! lane {
            ($k:literal) => {
                sum(
                    i32x4_extract_lane::<$k>(self.index),
                    i32x4_shuffle::<$k, $k, $k, $k>(left, left),
                    i32x4_shuffle::<$k, $k, $k, $k>(right, right),
                )
            };
        }
        [lane!(0), lane!(1), lane!(2), lane!(3)]
    }
}

impl Along {
    /// Which of the texels before the points, and of those after them, are not the border's.
    #[inline(always)]
    fn inner(&self) -> [v128; 2] {
        let size = self.size as i32;
        [is_inner(self.before, size), is_inner(i32x4_add(self.before, i32x4_splat(1)), size)]
    }
}

impl Weights {
    /// The weights with 0 for taps of the border.
    #[inline(always)]
    fn within(self, column: &Along, row: &Along) -> Self {
        let (Self([a, b, c, d]), [left, right], [upper, lower]) = (self, column.inner(), row.inner());
        let both = |weight: v128, x: v128, y: v128| v128_and(weight, v128_and(x, y));
        Self([both(a, left, upper), both(b, right, upper), both(c, left, lower), both(d, right, lower)])
    }

    /// The first weight changed so that all sum to [`ONE`], whatever rounding did.
    #[inline(always)]
    pub fn completed(self) -> Self {
        self.with_sum(i32x4_splat(ONE as i32))
    }

    /// The first weight changed so that these and the other level's sum to [`ONE`].
    #[inline(always)]
    pub fn completed_beside(self, other: &Self) -> Self {
        let Self([a, b, c, d]) = other;
        let rest = i32x4_add(i32x4_add(*a, *b), i32x4_add(*c, *d));
        self.with_sum(i32x4_sub(i32x4_splat(ONE as i32), rest))
    }

    /// The first weight changed so that all sum to `whole`: in the low 16 bits, where [`ROUNDER`] has none.
    #[inline(always)]
    fn with_sum(self, whole: v128) -> Self {
        let Self([_, b, c, d]) = self;
        Self([i32x4_sub(whole, i32x4_add(b, i32x4_add(c, d))), b, c, d])
    }

    /// Pairs of 16-bit weights, upper and lower tap: the left column's and the right one's.
    #[inline(always)]
    fn pairs(self) -> [v128; 2] {
        let Self([a, b, c, d]) = self;
        let pair = |upper: v128, lower: v128| i16x8_shuffle::<0, 9, 2, 11, 4, 13, 6, 15>(upper, i32x4_shl(lower, 16));
        [pair(a, c), pair(b, d)]
    }
}

/// The texel (the border's included) before each of four points `t` of level 0, and the share of the next one.
#[inline(always)]
fn cell(t: v128, scale: f32, size: usize) -> (v128, v128) {
    let size = size as f32;
    let t = f32x4_sub(f32x4_mul(t, f32x4_splat(scale)), f32x4_splat(0.5));
    // The comparing maximum comes first: it turns NaN into −1.
    let t = f32x4_pmin(f32x4_pmax(f32x4_splat(-1.0), t), f32x4_splat(size.next_down()));
    let before = f32x4_floor(t);
    let bits = f32x4_add(before, f32x4_splat(ROUNDER + 1.0));
    (i32x4_sub(bits, i32x4_splat(ROUNDER.to_bits() as i32)), f32x4_sub(t, before))
}
