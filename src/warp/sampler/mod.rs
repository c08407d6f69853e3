//! Samplers: footprints of a strip → RGBA bytes.
//!
//! The quality and the wrap mode are chosen once an image; below that everything is one loop a row.

#[cfg_attr(target_feature = "simd128", allow(dead_code, reason = "what the simd kernels are tested against"))]
mod scalar;
#[cfg(target_feature = "simd128")]
mod simd;

use super::options::Quality;
use super::strip::Strip;
use super::texture::{Texture, Wrap};
#[cfg(target_feature = "simd128")]
use core::arch::wasm32::{f32x4_add, f32x4_floor, f32x4_mul, f32x4_pmax, f32x4_pmin, f32x4_splat, f32x4_sub, v128};

/// The `best` quality's samples in a pixel, as offsets from its centre: a rotated grid, so that near-horizontal and
/// near-vertical edges pass four different distances. Four boxes of half the pixel's side around them have the second
/// moment of the pixel itself (a² + b² = ⅛): measured, that is 1 to 3 dB better than the usual ⅛ and ⅜.
const ROTATED_GRID: [[f32; 2]; 4] = {
    let (a, b) = (0.111_803_4, 0.335_410_2);
    [[a, b], [-a, -b], [b, -a], [-b, a]]
};

/// The footprints of pixels that lie beside each other: a row of a strip, or a part of one. Whole groups of four; the last ones
/// may be none.
#[derive(Clone, Copy)]
pub(super) struct Row<'a> {
    pub u: &'a [f32],
    pub v: &'a [f32],
    pub level: &'a [f32],
    pub jacobian: [&'a [f32]; 4],
}

/// Draws a row's pixels from a texture, as many as the bytes are for.
pub(super) type Kernel = fn(&Texture, Row<'_>, &mut [u8]);

impl<'a> Row<'a> {
    /// Row `row` of the strip; a quantity that the strip does not hold is empty.
    fn of(strip: &'a Strip, row: usize) -> Self {
        let (start, end) = (strip.start(row), strip.start(row + 1));
        let part = |plane: &'a Vec<f32>| plane.get(start..end).unwrap_or_default();
        let [a, b, c, d] = &strip.jacobian;
        Self { u: part(&strip.u), v: part(&strip.v), level: part(&strip.level), jacobian: [a, b, c, d].map(part) }
    }
}

/// Draws every row of the strip: `out` holds `strip.rows` rows of 4 · `strip.width` bytes.
pub(super) fn sample(texture: &Texture, quality: Quality, strip: &Strip, out: &mut [u8]) {
    let draw = kernel(texture.wrap(), quality);
    for (row, line) in out.chunks_exact_mut(4 * strip.width).enumerate() {
        draw(texture, Row::of(strip, row), line);
    }
}

/// What draws rows of such a texture.
pub(super) fn kernel(wrap: Wrap, quality: Quality) -> Kernel {
    match wrap {
        Wrap::Transparent => kernel_of::<Unchanged>(quality),
        Wrap::Clamp => kernel_of::<Clamped>(quality),
        Wrap::Repeat => kernel_of::<Repeated>(quality),
        Wrap::Mirror => kernel_of::<Mirrored>(quality),
    }
}

#[cfg(not(target_feature = "simd128"))]
use scalar as kernels;
/// The fastest kernels of this build.
#[cfg(target_feature = "simd128")]
use simd as kernels;

fn kernel_of<W: Fold>(quality: Quality) -> Kernel {
    match quality {
        Quality::Nearest => scalar::nearest::<W>,
        Quality::Bilinear => kernels::bilinear::<W>,
        Quality::Trilinear => kernels::trilinear::<W>,
        Quality::Best => kernels::best::<W>,
    }
}

/// A wrap mode as a fold of the texture's axis: any coordinate → one that lies in 0..=`size`, or beyond the edge
/// where there is nothing.
trait Fold {
    fn fold(t: f32, size: f32) -> f32;

    /// Four at once; `reciprocal` = 1 / `size`.
    #[cfg(target_feature = "simd128")]
    fn fold4(t: v128, size: v128, reciprocal: v128) -> v128;
}

struct Unchanged;
struct Clamped;
struct Repeated;
struct Mirrored;

impl Fold for Unchanged {
    fn fold(t: f32, _: f32) -> f32 {
        t
    }

    #[cfg(target_feature = "simd128")]
    fn fold4(t: v128, _: v128, _: v128) -> v128 {
        t
    }
}

impl Fold for Clamped {
    fn fold(t: f32, size: f32) -> f32 {
        t.clamp(0.0, size)
    }

    #[cfg(target_feature = "simd128")]
    fn fold4(t: v128, size: v128, _: v128) -> v128 {
        f32x4_pmin(f32x4_pmax(f32x4_splat(0.0), t), size)
    }
}

impl Fold for Repeated {
    fn fold(t: f32, size: f32) -> f32 {
        t - size * (t / size).floor()
    }

    #[cfg(target_feature = "simd128")]
    fn fold4(t: v128, size: v128, reciprocal: v128) -> v128 {
        f32x4_sub(t, f32x4_mul(size, f32x4_floor(f32x4_mul(t, reciprocal))))
    }
}

impl Fold for Mirrored {
    fn fold(t: f32, size: f32) -> f32 {
        let t = Repeated::fold(t, 2.0 * size);
        t.min(2.0 * size - t)
    }

    #[cfg(target_feature = "simd128")]
    fn fold4(t: v128, size: v128, reciprocal: v128) -> v128 {
        let period = f32x4_add(size, size);
        let t = Repeated::fold4(t, period, f32x4_mul(reciprocal, f32x4_splat(0.5)));
        f32x4_pmin(t, f32x4_sub(period, t))
    }
}

#[cfg(all(test, target_feature = "simd128"))]
mod tests {
    use super::*;
    use crate::warp::Light;
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Numbers in [0, 1), the same every time.
    struct Random(u32);

    impl Random {
        fn next(&mut self) -> f32 {
            self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (self.0 >> 8) as f32 / (1 << 24) as f32
        }

        /// Pixels of black, white and colours between, opaque but for `veiled` of them.
        fn picture(&mut self, [width, height]: [usize; 2], veiled: f32) -> Vec<u8> {
            let mut byte = || (self.next() * 340.0 - 40.0).clamp(0.0, 255.0) as u8;
            let mut rgba: Vec<u8> = (0..4 * width * height).map(|_| byte()).collect();
            for pixel in rgba.as_chunks_mut::<4>().0 {
                if self.next() >= veiled {
                    pixel[3] = 255;
                }
            }
            rgba
        }

        /// A strip of footprints all over the texture and beyond it, some of them nowhere.
        fn strip(&mut self, quality: Quality, [width, height]: [usize; 2]) -> Strip {
            let mut strip = Strip::new(61, quality);
            strip.reset(0, 7);
            for k in 0..strip.start(7) {
                let smooth = k / 61 % 2 == 0;
                strip.u[k] = (3.0 * self.next() - 1.0) * width as f32;
                strip.v[k] = (3.0 * self.next() - 1.0) * height as f32;
                if self.next() < 0.02 {
                    strip.u[k] = f32::NAN;
                }
                if strip.has_levels() {
                    strip.level[k] = if smooth { 1.5 + 0.01 * self.next() } else { 12.0 * self.next() - 2.0 };
                }
                if strip.has_jacobian() {
                    strip.jacobian.iter_mut().for_each(|plane| plane[k] = 4.0 * self.next() - 2.0);
                }
            }
            strip
        }
    }

    /// The largest difference of what is seen: of colours as far as alpha lets them through, and of alpha.
    fn largest_difference(a: &[u8], b: &[u8]) -> f32 {
        let pixels = a.as_chunks::<4>().0.iter().zip(b.as_chunks::<4>().0);
        let seen = |pixel: &[u8; 4], channel: usize| match channel {
            3 => f32::from(pixel[3]),
            _ => f32::from(pixel[channel]) * f32::from(pixel[3]) / 255.0,
        };
        pixels.flat_map(|(p, q)| (0..4).map(move |c| (seen(p, c) - seen(q, c)).abs())).fold(0.0, f32::max)
    }

    fn compare<W: Fold>(texture: &Texture, random: &mut Random) {
        let twins: [(Quality, Kernel, Kernel); 3] = [
            (Quality::Bilinear, scalar::bilinear::<W>, simd::bilinear::<W>),
            (Quality::Trilinear, scalar::trilinear::<W>, simd::trilinear::<W>),
            (Quality::Best, scalar::best::<W>, simd::best::<W>),
        ];
        for (quality, scalar, simd) in twins {
            let strip = random.strip(quality, texture.size());
            for row in 0..strip.rows {
                let mut lines = [vec![7; 4 * 61], vec![9; 4 * 61]];
                scalar(texture, Row::of(&strip, row), &mut lines[0]);
                simd(texture, Row::of(&strip, row), &mut lines[1]);
                let difference = largest_difference(&lines[0], &lines[1]);
                let what = (quality, texture.wrap(), texture.light(), texture.size());
                assert!(difference <= 1.0, "{what:?}: {difference} levels apart");
            }
        }
    }

    #[wasm_bindgen_test]
    fn simd_and_scalar_kernels_are_at_most_one_level_apart() {
        let mut random = Random(1);
        for size in [[64, 64], [37, 5], [1, 90], [1, 1]] {
            for (light, veiled) in [(Light::Linear, 0.0), (Light::Plain, 0.0), (Light::Linear, 0.5)] {
                let picture = random.picture(size, veiled);
                let texture = |wrap| {
                    let built = Texture::new(&picture, size[0], size[1], wrap, light);
                    built.unwrap_or_else(|error| panic!("{error}"))
                };
                compare::<Unchanged>(&texture(Wrap::Transparent), &mut random);
                compare::<Clamped>(&texture(Wrap::Clamp), &mut random);
                compare::<Repeated>(&texture(Wrap::Repeat), &mut random);
                compare::<Mirrored>(&texture(Wrap::Mirror), &mut random);
            }
        }
    }
}
