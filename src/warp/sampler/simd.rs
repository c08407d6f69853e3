//! The sampler kernels with simd128: four pixels at a time, without branches on what they show.
//!
//! Coordinates, cells and weights are computed for four samples at once; then each sample's taps are two loads a level,
//! for a load of 16 bytes holds the two neighbours in a row. `i32x4_dot` multiplies the four taps of each channel
//! with weights that sum to 2¹⁴ and adds them up. Held to the scalar kernels by a test, to one level.

use super::{Fold, ROTATED_GRID, Row};
use crate::warp::light::{FULL, Tables};
use crate::warp::pyramid::{Level, Texel};
use crate::warp::texture::Texture;
use core::arch::wasm32::*;

/// Weights are integers that sum to this, a power of two that 16 bits hold.
const ONE: f32 = (1 << WEIGHT_BITS) as f32;
const WEIGHT_BITS: u32 = 14;

/// Weighted sums of texels, one vector of four channels for each of four pixels, in units of 1/[`ONE`].
type Sums = [v128; 4];

pub(super) fn bilinear<W: Fold>(texture: &Texture, row: Row<'_>, line: &mut [u8]) {
    let (texels, axes) = (texture.texels(), Axes::of(texture));
    let whole = f32x4_splat(ONE);
    each_four(texture, row, line, |u, v, _| {
        let (u, v) = axes.folded::<W>(u, v);
        let taps = Taps::new(&texture.levels()[0], u, v);
        (taps.sums(texels, taps.weights(whole).completed()), WEIGHT_BITS)
    });
}

pub(super) fn trilinear<W: Fold>(texture: &Texture, row: Row<'_>, line: &mut [u8]) {
    let axes = Axes::of(texture);
    each_four(texture, row, line, |u, v, at| {
        let (u, v) = axes.folded::<W>(u, v);
        let between = Between::new(texture, four(row.level, at));
        (between.sums(texture, u, v), WEIGHT_BITS)
    });
}

pub(super) fn best<W: Fold>(texture: &Texture, row: Row<'_>, line: &mut [u8]) {
    let axes = Axes::of(texture);
    each_four(texture, row, line, |u, v, at| {
        let [ux, vx, uy, vy] = row.jacobian.map(|plane| four(plane, at));
        let between = Between::new(texture, f32x4_sub(four(row.level, at), f32x4_splat(1.0)));
        let mut sums = [i32x4_splat(0); 4];
        for [x, y] in ROTATED_GRID {
            let moved = |t: v128, tx: v128, ty: v128| {
                let across = f32x4_mul(tx, f32x4_splat(x));
                f32x4_add(t, f32x4_add(across, f32x4_mul(ty, f32x4_splat(y))))
            };
            let (u, v) = axes.folded::<W>(moved(u, ux, uy), moved(v, vx, vy));
            sums = plus(sums, between.sums(texture, u, v));
        }
        // Four samples: two bits more. Full light then takes 31 bits, and just fits.
        (sums, WEIGHT_BITS + 2)
    });
}

/// Draws the row from `sums(u, v, column)`, the sums of four pixels and the bits of their unit.
#[inline(always)]
fn each_four(texture: &Texture, row: Row<'_>, line: &mut [u8], sums: impl Fn(v128, v128, usize) -> (Sums, u32)) {
    let tables = texture.light().tables();
    for (group, pixels) in line.chunks_mut(16).enumerate() {
        let at = 4 * group;
        let (u, v) = (four(row.u, at), four(row.v, at));
        let shown = v128_and(f32x4_eq(u, u), f32x4_eq(v, v));
        if !v128_any_true(shown) {
            pixels.fill(0);
            continue;
        }
        let (sums, bits) = sums(u, v, at);
        let half = i32x4_splat(1 << (bits - 1));
        let rounded = sums.map(|sum| i32x4_shr(i32x4_add(sum, half), bits));
        let mut packed = encoded(rounded, tables);
        if !i32x4_all_true(shown) {
            packed = v128_and(packed, shown);
        }
        put(pixels, packed);
    }
}

/// Writes four pixels, or as many as there is room for.
#[inline(always)]
fn put(pixels: &mut [u8], four: v128) {
    let halves = [u64x2_extract_lane::<0>(four), u64x2_extract_lane::<1>(four)];
    if pixels.len() == 16 {
        pixels[..8].copy_from_slice(&halves[0].to_le_bytes());
        pixels[8..].copy_from_slice(&halves[1].to_le_bytes());
    } else {
        for (chunk, half) in pixels.chunks_mut(8).zip(halves) {
            chunk.copy_from_slice(&half.to_le_bytes()[..chunk.len()]);
        }
    }
}

#[inline(always)]
fn plus(a: Sums, b: Sums) -> Sums {
    [i32x4_add(a[0], b[0]), i32x4_add(a[1], b[1]), i32x4_add(a[2], b[2]), i32x4_add(a[3], b[3])]
}

/// Numbers `at` to `at + 3`; rows are whole groups of four.
#[inline(always)]
fn four(plane: &[f32], at: usize) -> v128 {
    let numbers = &plane[at..at + 4];
    f32x4(numbers[0], numbers[1], numbers[2], numbers[3])
}

/// The texture's sizes and their reciprocals, for folding.
struct Axes {
    sizes: [v128; 2],
    reciprocals: [v128; 2],
}

impl Axes {
    fn of(texture: &Texture) -> Self {
        let sizes = texture.size().map(|n| n as f32);
        Self { sizes: sizes.map(|n| f32x4_splat(n)), reciprocals: sizes.map(|n| f32x4_splat(1.0 / n)) }
    }

    #[inline(always)]
    fn folded<W: Fold>(&self, u: v128, v: v128) -> (v128, v128) {
        (W::fold4(u, self.sizes[0], self.reciprocals[0]), W::fold4(v, self.sizes[1], self.reciprocals[1]))
    }
}

/// The two levels that each of four samples lies between.
struct Between {
    /// The finer level.
    lower: v128,
    /// The weight of the coarser one, times [`ONE`].
    share: v128,
    /// The finer level, if it is the same for all four.
    common: Option<usize>,
    magnified: bool,
}

impl Between {
    #[inline(always)]
    fn new(texture: &Texture, level: v128) -> Self {
        let last = (texture.levels().len() - 1) as f32;
        // The comparing maximum comes first: it turns NaN into 0.
        let level = f32x4_pmin(f32x4_pmax(f32x4_splat(0.0), level), f32x4_splat(last));
        let lower = f32x4_floor(level);
        let share = f32x4_mul(f32x4_sub(level, lower), f32x4_splat(ONE));
        let first = f32x4_extract_lane::<0>(lower);
        let common = i32x4_all_true(f32x4_eq(lower, f32x4_splat(first))).then_some(first as usize);
        Self { lower, share, common, magnified: !v128_any_true(f32x4_gt(share, f32x4_splat(0.0))) }
    }

    #[inline(always)]
    fn sums(&self, texture: &Texture, u: v128, v: v128) -> Sums {
        match self.common {
            Some(lower) if self.magnified => {
                let taps = Taps::new(&texture.levels()[lower], u, v);
                taps.sums(texture.texels(), taps.weights(f32x4_splat(ONE)).completed())
            }
            Some(lower) => between(texture, u, v, lower, self.share),
            None => each_between(texture, u, v, self.lower, self.share),
        }
    }
}

/// Four samples between the levels `lower` and `lower` + 1.
#[inline(always)]
fn between(texture: &Texture, u: v128, v: v128, lower: usize, share: v128) -> Sums {
    let levels = &texture.levels()[lower..lower + 2];
    let (fine, coarse) = (Taps::new(&levels[0], u, v), Taps::new(&levels[1], u, v));
    let coarse_weights = coarse.weights(share);
    let fine_weights = fine.weights(f32x4_sub(f32x4_splat(ONE), share)).completed_beside(&coarse_weights);
    plus(fine.sums(texture.texels(), fine_weights), coarse.sums(texture.texels(), coarse_weights))
}

/// Four samples whose levels differ, one at a time. Few groups are cut by the line where the level changes.
#[cold]
#[inline(never)]
fn each_between(texture: &Texture, u: v128, v: v128, lower: v128, share: v128) -> Sums {
    let ([u, v], [lower, share]) = ([u, v].map(lanes), [lower, share].map(lanes));
    let last = texture.levels().len() - 2;
    std::array::from_fn(|k| {
        // A sample on the last level lies wholly there.
        let (lower, share) = if lower[k] as usize > last { (last, ONE) } else { (lower[k] as usize, share[k]) };
        between(texture, f32x4_splat(u[k]), f32x4_splat(v[k]), lower, f32x4_splat(share))[0]
    })
}

fn lanes(v: v128) -> [f32; 4] {
    [f32x4_extract_lane::<0>(v), f32x4_extract_lane::<1>(v), f32x4_extract_lane::<2>(v), f32x4_extract_lane::<3>(v)]
}

/// Four samples of one level: the texel before each, and how far beyond it they lie.
struct Taps {
    index: v128,
    stride: usize,
    x: v128,
    y: v128,
}

/// The weights of four samples' taps: of the tap itself, the one on its right, and the same two a row below.
///
/// Integers, but for [`ROUNDER`] in their upper half.
struct Weights([v128; 4]);

/// Added to a number below 2²², it leaves the nearest integer in the low bits: much cheaper than a conversion.
const ROUNDER: f32 = 12_582_912.0;

impl Taps {
    #[inline(always)]
    fn new(level: &Level, u: v128, v: v128) -> Self {
        let (column, x) = cell(u, level.scale[0], level.width);
        let (row, y) = cell(v, level.scale[1], level.height);
        let index = i32x4_add(i32x4_mul(row, i32x4_splat(level.stride as i32)), column);
        Self { index: i32x4_add(index, i32x4_splat(level.offset as i32)), stride: level.stride, x, y }
    }

    /// Bilinear weights with the sum `share` (0 to [`ONE`]), each rounded.
    #[inline(always)]
    fn weights(&self, share: v128) -> Weights {
        let right = f32x4_mul(self.x, share);
        let left = f32x4_sub(share, right);
        let (below_left, below_right) = (f32x4_mul(left, self.y), f32x4_mul(right, self.y));
        let taps = [f32x4_sub(left, below_left), f32x4_sub(right, below_right), below_left, below_right];
        Weights(taps.map(|t| f32x4_add(t, f32x4_splat(ROUNDER))))
    }

    #[inline(always)]
    fn sums(&self, texels: &[Texel], weights: Weights) -> Sums {
        // Pairs of 16-bit weights, upper and lower texel: the left column's and the right one's.
        let Weights([a, b, c, d]) = weights;
        let low = i32x4_splat(0xffff);
        let left = v128_or(v128_and(a, low), i32x4_shl(c, 16));
        let right = v128_or(v128_and(b, low), i32x4_shl(d, 16));
        let sum = |index: i32, left: v128, right: v128| {
            let (upper, lower) = (pair(texels, index as usize), pair(texels, index as usize + self.stride));
            let first = i16x8_shuffle::<0, 8, 1, 9, 2, 10, 3, 11>(upper, lower);
            let second = i16x8_shuffle::<4, 12, 5, 13, 6, 14, 7, 15>(upper, lower);
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

impl Weights {
    /// The first weight changed so that all sum to [`ONE`], whatever rounding did.
    #[inline(always)]
    fn completed(self) -> Self {
        self.with_sum(i32x4_splat(ONE as i32))
    }

    /// The first weight changed so that these and the other level's sum to [`ONE`].
    #[inline(always)]
    fn completed_beside(self, other: &Self) -> Self {
        let Self([a, b, c, d]) = other;
        let rest = i32x4_add(i32x4_add(*a, *b), i32x4_add(*c, *d));
        self.with_sum(i32x4_sub(i32x4_splat(ONE as i32), rest))
    }

    /// In the low 16 bits, where [`ROUNDER`] has none.
    #[inline(always)]
    fn with_sum(self, whole: v128) -> Self {
        let Self([_, b, c, d]) = self;
        Self([i32x4_sub(whole, i32x4_add(b, i32x4_add(c, d))), b, c, d])
    }
}

/// The texel (the border's included) before each of four points `t` of level 0, and the share of the next one.
#[inline(always)]
fn cell(t: v128, scale: f32, size: usize) -> (v128, v128) {
    let size = size as f32;
    let t = f32x4_sub(f32x4_mul(t, f32x4_splat(scale)), f32x4_splat(0.5));
    // The comparing maximum comes first: it turns NaN into −1.
    let t = f32x4_pmin(f32x4_pmax(f32x4_splat(-1.0), t), f32x4_splat(size));
    let before = f32x4_pmin(f32x4_floor(t), f32x4_splat(size - 1.0));
    let bits = f32x4_add(before, f32x4_splat(ROUNDER + 1.0));
    (i32x4_sub(bits, i32x4_splat(ROUNDER.to_bits() as i32)), f32x4_sub(t, before))
}

/// Texels `index` and `index` + 1.
#[inline(always)]
fn pair(texels: &[Texel], index: usize) -> v128 {
    debug_assert!(index + 2 <= texels.len());
    #[expect(unsafe_code, reason = "`cell` keeps to the level and its border; a checked load is a third slower")]
    unsafe {
        v128_load(texels.as_ptr().add(index).cast())
    }
}

/// Premultiplied sums (about 0..=[`FULL`] in each lane) of four pixels → RGBA bytes.
#[inline(always)]
fn encoded(pixels: Sums, tables: &Tables) -> v128 {
    let [a, b, c, d] = pixels;
    // A weight may be rounded below 0, and with it a sum.
    let limited = |pair: v128| i16x8_max(i16x8_min(pair, i16x8_splat(FULL)), i16x8_splat(0));
    let pairs = [limited(i16x8_narrow_i32x4(a, b)), limited(i16x8_narrow_i32x4(c, d))];
    let both = i16x8_min(pairs[0], pairs[1]);
    let opaque = i16x8_extract_lane::<3>(both) == FULL && i16x8_extract_lane::<7>(both) == FULL;
    let [[a, b], [c, d]] = pairs.map(|pair| [u64x2_extract_lane::<0>(pair), u64x2_extract_lane::<1>(pair)]);
    let [a, b, c, d] = if opaque {
        [a, b, c, d].map(|pixel| opaque_pixel(pixel, tables))
    } else {
        [a, b, c, d].map(|pixel| any_pixel(pixel, tables))
    };
    u32x4(a, b, c, d)
}

/// Four 16-bit channels of a pixel with full alpha → its bytes.
#[inline(always)]
fn opaque_pixel(channels: u64, tables: &Tables) -> u32 {
    let byte = |shift: u32| u32::from(tables.encode[usize::from((channels >> shift) as u16 & 0x7fff)]);
    byte(0) | byte(16) << 8 | byte(32) << 16 | 0xff00_0000
}

/// Four 16-bit channels of a pixel that may be partly transparent → its bytes.
#[cold]
#[inline(never)]
fn any_pixel(channels: u64, tables: &Tables) -> u32 {
    let [r, g, b, alpha] = [0, 16, 32, 48].map(|shift| u32::from((channels >> shift) as u16));
    let coverage = (alpha + 64) >> 7;
    if coverage == 0 {
        return 0;
    }
    let full = FULL as u32;
    let byte = |value: u32| u32::from(tables.encode[((value * full + alpha / 2) / alpha).min(full) as usize]);
    byte(r) | byte(g) << 8 | byte(b) << 16 | coverage << 24
}
