//! The sampler kernels with simd128: four pixels at a time, without branches on what they show.
//!
//! Coordinates, cells and weights are computed for four samples at once; then each sample's taps are two loads a level,
//! for one load holds the two neighbours in a row. `i32x4_dot` multiplies the four taps of each channel with weights
//! that sum to 2¹⁴ and adds them up. Held to the scalar kernels by a test, to one level.

mod levels;
mod nearest;
mod taps;
mod texel;
mod vectors;

use super::fold::Fold;
use super::input::{Pyramid, ROTATED_GRID, Row};
use crate::warp::texel::ByteTexel;
use crate::warp::texture::Texture;
use core::arch::wasm32::*;
use levels::Between;
use taps::{ONE, Taps, WEIGHT_BITS};
pub(super) use texel::Texel;
use vectors::{Axes, each_four, four, plus};

pub(super) use nearest::nearest;

pub(super) fn bilinear(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<ByteTexel>::of(texture);
    let (axes, base) = (Axes::of(pyramid, fold), pyramid.levels[0]);
    each_four(row, line, |u, v, _| {
        let (u, v) = axes.folded(u, v);
        let taps = Taps::new(&base, u, v);
        let sums = taps.sums(pyramid.texels, fold, taps.weights(f32x4_splat(ONE)).completed());
        ByteTexel::pixels(sums, WEIGHT_BITS, pyramid.tables)
    });
}

pub(super) fn trilinear(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<ByteTexel>::of(texture);
    let axes = Axes::of(pyramid, fold);
    each_four(row, line, |u, v, at| {
        let (u, v) = axes.folded(u, v);
        let between = Between::new(pyramid, four(row.level, at));
        ByteTexel::pixels(between.sums(pyramid, fold, u, v), WEIGHT_BITS, pyramid.tables)
    });
}

/// If `PLAIN`, the fold is known to be [`Fold::Unchanged`]: eight of them a pixel are worth a kernel of their own.
pub(super) fn best<T: Texel, const PLAIN: bool>(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let fold = if PLAIN { Fold::Unchanged } else { fold };
    let pyramid = &Pyramid::<T>::of(texture);
    let axes = Axes::of(pyramid, fold);
    each_four(row, line, |u, v, at| {
        let [ux, vx, uy, vy] = row.jacobian.map(|plane| four(plane, at));
        let between = Between::new(pyramid, f32x4_sub(four(row.level, at), f32x4_splat(1.0)));
        let mut sums = [i32x4_splat(0); 4];
        for [x, y] in ROTATED_GRID {
            let moved = |t: v128, tx: v128, ty: v128| {
                let across = f32x4_mul(tx, f32x4_splat(x));
                f32x4_add(t, f32x4_add(across, f32x4_mul(ty, f32x4_splat(y))))
            };
            let (u, v) = axes.folded(moved(u, ux, uy), moved(v, vx, vy));
            sums = plus(sums, between.sums(pyramid, fold, u, v));
        }
        // Four samples: two bits more. Full light then takes 31 bits, and just fits.
        T::pixels(sums, WEIGHT_BITS + 2, pyramid.tables)
    });
}
