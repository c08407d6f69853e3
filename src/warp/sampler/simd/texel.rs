//! The two kinds of texels as the kernels load them, and their sums as they become pixels.

use super::vectors::{ROUNDER, Sums};
use crate::warp::light::{FULL, Tables};
use crate::warp::sampler::input::Kind;
use crate::warp::texel::{ByteTexel, LightTexel};
use core::arch::wasm32::*;

pub trait Texel: Kind {
    /// Loads a texel and its neighbour on the right, from an upper and a lower row → for the left column and the right
    /// one, eight 16-bit numbers: each channel's upper and lower texel.
    ///
    /// # Safety
    /// Two texels can be read at both places.
    #[expect(unsafe_code, reason = "the caller knows the borders of the level, and a check a tap costs a third")]
    unsafe fn columns(upper: *const Self, lower: *const Self) -> [v128; 2];

    /// Premultiplied sums of weight 2^`bits` → bytes of four pixels with straight alpha.
    fn pixels(sums: Sums, bits: u32, tables: &Tables) -> v128;
}

impl Texel for ByteTexel {
    #[inline(always)]
    #[expect(unsafe_code, reason = "as the trait says")]
    unsafe fn columns(upper: *const Self, lower: *const Self) -> [v128; 2] {
        let [upper, lower] = unsafe { [v128_load64_zero(upper.cast()), v128_load64_zero(lower.cast())] };
        let both = i8x16_shuffle::<0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23>(upper, lower);
        [u16x8_extend_low_u8x16(both), u16x8_extend_high_u8x16(both)]
    }

    #[inline(always)]
    fn pixels(sums: Sums, bits: u32, _: &Tables) -> v128 {
        let half = i32x4_splat(1 << (bits - 1));
        let premultiplied = packed(sums.map(|sum| i32x4_add(sum, half)), bits);
        if is_opaque(premultiplied) { premultiplied } else { straightened(sums, premultiplied) }
    }
}

/// The alpha byte of a pixel.
const ALPHA: u32 = 0xff00_0000;

/// Whether all of four pixels have full alpha.
#[inline(always)]
fn is_opaque(pixels: v128) -> bool {
    i32x4_all_true(u32x4_ge(pixels, u32x4_splat(ALPHA)))
}

/// The bytes that begin at bit `first` of four times four numbers.
///
/// They are shifted to where they do not overlap, and then sorted: fewer steps than narrowing twice.
#[inline(always)]
fn packed([a, b, c, d]: Sums, first: u32) -> v128 {
    let placed = |numbers: v128, bit: u32| {
        let shifted = if bit < first { u32x4_shr(numbers, first - bit) } else { i32x4_shl(numbers, bit - first) };
        v128_and(shifted, u32x4_splat(0xff << bit))
    };
    let columns = v128_or(v128_or(placed(a, 0), placed(b, 8)), v128_or(placed(c, 16), placed(d, 24)));
    i8x16_shuffle::<0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15>(columns, columns)
}

/// Four premultiplied texels → the same with straight alpha.
#[inline(always)]
pub fn straightened_bytes(texels: v128) -> v128 {
    if is_opaque(texels) {
        return texels;
    }
    let [low, high] = [u16x8_extend_low_u8x16(texels), u16x8_extend_high_u8x16(texels)];
    let wide = |half: v128| [u32x4_extend_low_u16x8(half), u32x4_extend_high_u16x8(half)];
    let ([a, b], [c, d]) = (wide(low), wide(high));
    straightened([a, b, c, d], texels)
}

/// Divides the colours of four pixels by their alpha. `premultiplied`: what they are before that, as bytes.
#[inline(always)]
fn straightened(sums: Sums, premultiplied: v128) -> v128 {
    let [a, b, c, d] = sums;
    let alphas = i32x4_shuffle::<0, 1, 4, 5>(i32x4_shuffle::<3, 7, 3, 7>(a, b), i32x4_shuffle::<3, 7, 3, 7>(c, d));
    let factors = f32x4_div(f32x4_splat(255.0), f32x4_convert_i32x4(alphas));
    // Nothing is without colour: 0/0 gives whatever it likes, and is not seen.
    let straight = |sum: v128, factor: v128| {
        let colors = f32x4_mul(f32x4_convert_i32x4(sum), factor);
        let colors = f32x4_pmax(f32x4_splat(0.0), f32x4_pmin(f32x4_splat(255.0), colors));
        f32x4_add(colors, f32x4_splat(ROUNDER))
    };
    let colors = [
        straight(a, i32x4_shuffle::<0, 0, 0, 0>(factors, factors)),
        straight(b, i32x4_shuffle::<1, 1, 1, 1>(factors, factors)),
        straight(c, i32x4_shuffle::<2, 2, 2, 2>(factors, factors)),
        straight(d, i32x4_shuffle::<3, 3, 3, 3>(factors, factors)),
    ];
    let alpha = u32x4_splat(ALPHA);
    let seen = i32x4_ne(v128_and(premultiplied, alpha), i32x4_splat(0));
    v128_bitselect(premultiplied, v128_and(packed(colors, 0), seen), alpha)
}

impl Texel for LightTexel {
    #[inline(always)]
    #[expect(unsafe_code, reason = "as the trait says")]
    unsafe fn columns(upper: *const Self, lower: *const Self) -> [v128; 2] {
        let [upper, lower] = unsafe { [v128_load(upper.cast()), v128_load(lower.cast())] };
        [
            i16x8_shuffle::<0, 8, 1, 9, 2, 10, 3, 11>(upper, lower),
            i16x8_shuffle::<4, 12, 5, 13, 6, 14, 7, 15>(upper, lower),
        ]
    }

    #[inline(always)]
    fn pixels(sums: Sums, bits: u32, tables: &Tables) -> v128 {
        let half = i32x4_splat(1 << (bits - 1));
        // A weight may be rounded below 0, and with it a sum.
        let [a, b, c, d] = sums.map(|sum| i32x4_max(i32x4_shr(i32x4_add(sum, half), bits), i32x4_splat(0)));
        let halves = |a: v128, b: v128| i16x8_shuffle::<0, 2, 4, 6, 8, 10, 12, 14>(a, b);
        let pairs = [halves(a, b), halves(c, d)];
        let alphas = v128_and(pairs[0], pairs[1]);
        let opaque = i16x8_extract_lane::<3>(alphas) == FULL && i16x8_extract_lane::<7>(alphas) == FULL;
        let [[a, b], [c, d]] = pairs.map(|pair| [u64x2_extract_lane::<0>(pair), u64x2_extract_lane::<1>(pair)]);
        let [a, b, c, d] = if opaque {
            [a, b, c, d].map(|light| opaque_pixel(light, tables))
        } else {
            [a, b, c, d].map(|light| any_pixel(light, tables))
        };
        u32x4(a, b, c, d)
    }
}

/// Four 16-bit channels of a pixel with full alpha → its bytes.
#[inline(always)]
fn opaque_pixel(light: u64, tables: &Tables) -> u32 {
    let byte = |shift: u32| u32::from(tables.encode[usize::from((light >> shift) as u16 & 0x7fff)]);
    byte(0) | byte(16) << 8 | byte(32) << 16 | ALPHA
}

/// Four 16-bit channels of a pixel that may be partly transparent → its bytes.
#[inline(never)]
fn any_pixel(light: u64, tables: &Tables) -> u32 {
    let [r, g, b, alpha] = [0, 16, 32, 48].map(|shift| u32::from((light >> shift) as u16));
    let coverage = (alpha + 64) >> 7;
    if coverage == 0 {
        return 0;
    }
    let full = FULL as u32;
    let byte = |value: u32| u32::from(tables.encode[((value * full + alpha / 2) / alpha).min(full) as usize]);
    byte(r) | byte(g) << 8 | byte(b) << 16 | coverage << 24
}
