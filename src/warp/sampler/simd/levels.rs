//! Four samples between two levels of the pyramid.

use super::taps::{ONE, Taps};
use super::texel::Texel;
use super::vectors::{Sums, plus};
use crate::warp::sampler::fold::Fold;
use crate::warp::sampler::input::Pyramid;
use core::arch::wasm32::*;

/// The two levels that each of four samples lies between.
pub struct Between {
    /// The finer level.
    lower: v128,
    /// The weight of the coarser one, times [`ONE`].
    share: v128,
    /// The finer level, if it is the same for all four.
    common: Option<usize>,
    /// Whether all four lie on the finer level.
    on_lower: bool,
}

impl Between {
    #[inline(always)]
    pub fn new<T>(pyramid: &Pyramid<'_, T>, level: v128) -> Self {
        let last = (pyramid.levels.len() - 1) as f32;
        // The comparing maximum comes first: it turns NaN into 0.
        let level = f32x4_pmin(f32x4_pmax(f32x4_splat(0.0), level), f32x4_splat(last));
        let lower = f32x4_floor(level);
        let share = f32x4_mul(f32x4_sub(level, lower), f32x4_splat(ONE));
        let first = f32x4_extract_lane::<0>(lower);
        let common = i32x4_all_true(f32x4_eq(lower, f32x4_splat(first))).then_some(first as usize);
        Self { lower, share, common, on_lower: !v128_any_true(f32x4_gt(share, f32x4_splat(0.0))) }
    }

    #[inline(always)]
    pub fn sums<T: Texel>(&self, pyramid: &Pyramid<'_, T>, fold: Fold, u: v128, v: v128) -> Sums {
        match self.common {
            Some(lower) if self.on_lower => {
                let taps = Taps::new(&pyramid.levels[lower], u, v);
                taps.sums(pyramid.texels, fold, taps.weights(f32x4_splat(ONE)).completed())
            }
            Some(lower) => between(pyramid, fold, u, v, lower, self.share),
            None => each_between(pyramid, fold, u, v, self.lower, self.share),
        }
    }
}

/// Four samples between the levels `lower` and `lower` + 1.
#[inline(always)]
fn between<T: Texel>(pyramid: &Pyramid<'_, T>, fold: Fold, u: v128, v: v128, lower: usize, share: v128) -> Sums {
    let levels = &pyramid.levels[lower..lower + 2];
    let (fine, coarse) = (Taps::new(&levels[0], u, v), Taps::new(&levels[1], u, v));
    let coarse_weights = coarse.weights(share);
    let fine_weights = fine.weights(f32x4_sub(f32x4_splat(ONE), share)).completed_beside(&coarse_weights);
    plus(fine.sums(pyramid.texels, fold, fine_weights), coarse.sums(pyramid.texels, fold, coarse_weights))
}

/// Four samples whose levels differ, one at a time. Few groups are cut by the line where the level changes.
#[cold]
#[inline(never)]
fn each_between<T: Texel>(pyramid: &Pyramid<'_, T>, fold: Fold, u: v128, v: v128, lower: v128, share: v128) -> Sums {
    let ([u, v], [lower, share]) = ([u, v].map(lanes), [lower, share].map(lanes));
    let last = pyramid.levels.len() - 2;
    std::array::from_fn(|k| {
        // A sample on the last level lies wholly there.
        let (lower, share) = if lower[k] as usize > last { (last, ONE) } else { (lower[k] as usize, share[k]) };
        between(pyramid, fold, f32x4_splat(u[k]), f32x4_splat(v[k]), lower, f32x4_splat(share))[0]
    })
}

fn lanes(v: v128) -> [f32; 4] {
    [f32x4_extract_lane::<0>(v), f32x4_extract_lane::<1>(v), f32x4_extract_lane::<2>(v), f32x4_extract_lane::<3>(v)]
}
