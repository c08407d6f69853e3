//! The sampler kernels with simd128: four pixels at a time, without branches on what they show.
//!
//! Coordinates, cells and weights are computed for four samples at once; then each sample's taps are two loads a level,
//! for one load holds the two neighbours in a row. `i32x4_dot` multiplies the four taps of each channel with weights
//! that sum to 2¹⁴ and adds them up. Held to the scalar kernels by a test, to one level.

mod levels;
mod nearest;
mod taps;
mod texel;

use super::{Fold, Kind, Pyramid, ROTATED_GRID, Row};
use crate::warp::texture::Texture;
use core::arch::wasm32::*;
use levels::Between;
use taps::{ONE, Taps, WEIGHT_BITS};

pub(super) use nearest::nearest;
pub(super) use texel::Texel;

/// Weighted sums of texels, one vector of four channels for each of four pixels, in units of 1/[`ONE`].
type Sums = [v128; 4];

pub(super) fn bilinear<W: Fold, T: Texel>(texture: &Texture, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<T>::of(texture);
    let (axes, base) = (Axes::of(pyramid), pyramid.levels[0]);
    each_four(row, line, |u, v, _| {
        let (u, v) = axes.folded::<W>(u, v);
        let taps = Taps::new(&base, u, v);
        let sums = taps.sums(pyramid.texels, taps.weights(f32x4_splat(ONE)).completed());
        T::pixels(sums, WEIGHT_BITS, pyramid.tables)
    });
}

pub(super) fn trilinear<W: Fold, T: Texel>(texture: &Texture, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<T>::of(texture);
    let axes = Axes::of(pyramid);
    each_four(row, line, |u, v, at| {
        let (u, v) = axes.folded::<W>(u, v);
        let between = Between::new(pyramid, four(row.level, at));
        T::pixels(between.sums(pyramid, u, v), WEIGHT_BITS, pyramid.tables)
    });
}

pub(super) fn best<W: Fold, T: Texel>(texture: &Texture, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<T>::of(texture);
    let axes = Axes::of(pyramid);
    each_four(row, line, |u, v, at| {
        let [ux, vx, uy, vy] = row.jacobian.map(|plane| four(plane, at));
        let between = Between::new(pyramid, f32x4_sub(four(row.level, at), f32x4_splat(1.0)));
        let mut sums = [i32x4_splat(0); 4];
        for [x, y] in ROTATED_GRID {
            let moved = |t: v128, tx: v128, ty: v128| {
                let across = f32x4_mul(tx, f32x4_splat(x));
                f32x4_add(t, f32x4_add(across, f32x4_mul(ty, f32x4_splat(y))))
            };
            let (u, v) = axes.folded::<W>(moved(u, ux, uy), moved(v, vx, vy));
            sums = plus(sums, between.sums(pyramid, u, v));
        }
        // Four samples: two bits more. Full light then takes 31 bits, and just fits.
        T::pixels(sums, WEIGHT_BITS + 2, pyramid.tables)
    });
}

/// Draws the row: `pixels(u, v, column)` are four pixels' bytes, those that show nothing included.
#[inline(always)]
fn each_four(row: Row<'_>, line: &mut [u8], pixels: impl Fn(v128, v128, usize) -> v128) {
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
fn four(plane: &[f32], at: usize) -> v128 {
    let numbers = &plane[at..at + 4];
    f32x4(numbers[0], numbers[1], numbers[2], numbers[3])
}

/// Writes four pixels, or as many as there is room for.
#[inline(always)]
fn put(bytes: &mut [u8], four: v128) {
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
fn plus(a: Sums, b: Sums) -> Sums {
    [i32x4_add(a[0], b[0]), i32x4_add(a[1], b[1]), i32x4_add(a[2], b[2]), i32x4_add(a[3], b[3])]
}

/// The texture's sizes and their reciprocals, for folding.
struct Axes {
    sizes: [v128; 2],
    reciprocals: [v128; 2],
}

impl Axes {
    #[inline(always)]
    fn of<T>(pyramid: &Pyramid<'_, T>) -> Self {
        let base = &pyramid.levels[0];
        let sizes = [base.width as f32, base.height as f32];
        Self { sizes: sizes.map(|n| f32x4_splat(n)), reciprocals: sizes.map(|n| f32x4_splat(1.0 / n)) }
    }

    #[inline(always)]
    fn folded<W: Fold>(&self, u: v128, v: v128) -> (v128, v128) {
        (W::fold4(u, self.sizes[0], self.reciprocals[0]), W::fold4(v, self.sizes[1], self.reciprocals[1]))
    }
}
