//! The simd kernels against their scalar twins.

use super::*;
use crate::warp::Light;
use crate::warp::texel::{ByteTexel, LightTexel};
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

fn compare_with(texture: &Texture, fold: Fold, strip: &Strip, what: &str, twins: [Kernel; 2]) {
    for row in 0..strip.rows {
        let mut lines = [vec![7; 4 * 61], vec![9; 4 * 61]];
        for (line, kernel) in lines.iter_mut().zip(twins) {
            kernel(texture, fold, Row::of(strip, row, 0, 64), line);
        }
        let difference = largest_difference(&lines[0], &lines[1]);
        let texture = (fold, texture.light(), texture.size());
        assert!(difference <= 1.0, "{what}, {texture:?}: {difference} levels apart");
    }
}

fn compare(fold: Fold, texture: &Texture, random: &mut Random) {
    let mut strip = |quality| random.strip(quality, texture.size());
    let strips = [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best].map(&mut strip);
    compare_with(texture, fold, &strips[0], "nearest", [scalar::nearest, simd::nearest]);
    compare_with(texture, fold, &strips[1], "bilinear", [scalar::bilinear, simd::bilinear]);
    compare_with(texture, fold, &strips[2], "trilinear", [scalar::trilinear, simd::trilinear]);
    let bytes: [Kernel; 2] = [scalar::best::<ByteTexel, false>, best::<ByteTexel>(fold)];
    compare_with(texture, fold, &strips[3], "best, bytes", bytes);
    let light: [Kernel; 2] = [scalar::best::<LightTexel, false>, best::<LightTexel>(fold)];
    compare_with(texture, fold, &strips[3], "best, light", light);
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
            compare(Fold::Unchanged, &texture(Wrap::Transparent), &mut random);
            compare(Fold::Framed, &texture(Wrap::Repeat), &mut random);
            compare(Fold::Clamped, &texture(Wrap::Clamp), &mut random);
            compare(Fold::Repeated, &texture(Wrap::Repeat), &mut random);
            compare(Fold::Mirrored, &texture(Wrap::Mirror), &mut random);
        }
    }
}
