//! The nearest texel, four pixels at a time.

use super::texel::straightened_bytes;
use super::vectors::{Axes, ROUNDER, each_four, is_inner};
use crate::warp::sampler::fold::Fold;
use crate::warp::sampler::input::{Pyramid, Row};
use crate::warp::texel::ByteTexel;
use crate::warp::texture::Texture;
use core::arch::wasm32::*;

pub fn nearest(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<ByteTexel>::of(texture);
    let (axes, level) = (Axes::of(pyramid, fold), pyramid.levels[0]);
    let (width, height, stride) = (level.width as f32, level.height as f32, i32x4_splat(level.stride as i32));
    each_four(row, line, |u, v, _| {
        let (u, v) = axes.folded(u, v);
        let (column, row) = (cell(u, width), cell(v, height));
        let index = i32x4_add(i32x4_mul(row, stride), column);
        let texel = |index: i32| {
            let index = level.offset + index as usize;
            debug_assert!(index < pyramid.texels.len());
            #[expect(unsafe_code, reason = "`cell` keeps to the level and its border")]
            u32::from_le_bytes(unsafe { *pyramid.texels.get_unchecked(index) })
        };
        let texels = u32x4(
            texel(i32x4_extract_lane::<0>(index)),
            texel(i32x4_extract_lane::<1>(index)),
            texel(i32x4_extract_lane::<2>(index)),
            texel(i32x4_extract_lane::<3>(index)),
        );
        let texels = if fold.is_framed() {
            let inner = v128_and(is_inner(column, level.width as i32), is_inner(row, level.height as i32));
            v128_and(texels, inner)
        } else {
            texels
        };
        straightened_bytes(texels)
    });
}

/// The texel (the border's included) in which each of four points of level 0 lies.
#[inline(always)]
fn cell(t: v128, size: f32) -> v128 {
    // The comparing maximum comes first: it turns NaN into −1.
    let t = f32x4_pmin(f32x4_pmax(f32x4_splat(-1.0), t), f32x4_splat(size));
    let bits = f32x4_add(f32x4_floor(t), f32x4_splat(ROUNDER + 1.0));
    i32x4_sub(bits, i32x4_splat(ROUNDER.to_bits() as i32))
}
