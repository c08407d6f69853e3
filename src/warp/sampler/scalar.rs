//! The sampler kernels in plain Rust, a pixel at a time: what native builds run, and what the simd kernels are held to.

use super::fold::Fold;
use super::input::{Kind, Pyramid, ROTATED_GRID, Row};
use crate::warp::light::{FULL, Tables};
use crate::warp::pyramid::Level;
use crate::warp::texel::{ByteTexel, LightTexel};
use crate::warp::texture::Texture;

/// A sum of weighted texels.
type Sum = [f32; 4];

/// A kind of texels: premultiplied numbers.
pub(super) trait Texel: Kind {
    fn channels(self) -> Sum;

    /// A premultiplied sum → a pixel with straight alpha.
    fn pixel(sum: Sum, tables: &Tables) -> [u8; 4];
}

impl Texel for ByteTexel {
    fn channels(self) -> Sum {
        self.map(f32::from)
    }

    fn pixel(sum: Sum, _: &Tables) -> [u8; 4] {
        let byte = |value: f32| (value + 0.5) as u8;
        let [r, g, b, alpha] = sum;
        match byte(alpha) {
            0 => [0; 4],
            255 => [byte(r), byte(g), byte(b), 255],
            coverage => {
                let [r, g, b] = [r, g, b].map(|value| byte(255.0 * value / alpha));
                [r, g, b, coverage]
            }
        }
    }
}

impl Texel for LightTexel {
    fn channels(self) -> Sum {
        self.map(f32::from)
    }

    fn pixel(sum: Sum, tables: &Tables) -> [u8; 4] {
        let [r, g, b, alpha] = sum.map(|value| (value + 0.5) as i32);
        let byte = |value: i32| tables.encode[value.clamp(0, i32::from(FULL)) as usize];
        match (alpha + 64) >> 7 {
            0 => [0; 4],
            255 => [byte(r), byte(g), byte(b), 255],
            coverage => {
                let [r, g, b] = [r, g, b].map(|value| byte((value * i32::from(FULL) + alpha / 2) / alpha));
                [r, g, b, coverage as u8]
            }
        }
    }
}

pub(super) fn nearest(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<ByteTexel>::of(texture);
    let level = &pyramid.levels[0];
    each_pixel(pyramid, row, line, |u, v, _| {
        let cell = |t: f32, size: usize| {
            let size = size as f32;
            (fold.apply(t, size).floor().clamp(-1.0, size) as i32 + 1) as usize
        };
        let (column, row) = (cell(u, level.width), cell(v, level.height));
        if fold.is_framed() && (is_border(column, level.width) || is_border(row, level.height)) {
            return [0.0; 4];
        }
        pyramid.texels[level.offset + row * level.stride + column].channels()
    });
}

pub(super) fn bilinear(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<ByteTexel>::of(texture);
    let base = &pyramid.levels[0];
    each_pixel(pyramid, row, line, |u, v, _| {
        let (u, v) = (fold.apply(u, base.width as f32), fold.apply(v, base.height as f32));
        let mut sum = [0.0; 4];
        add_bilinear(&mut sum, pyramid.texels, base, fold, [u, v], 1.0);
        sum
    });
}

pub(super) fn trilinear(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<ByteTexel>::of(texture);
    each_pixel(pyramid, row, line, |u, v, pixel| {
        let mut sum = [0.0; 4];
        add_trilinear(&mut sum, pyramid, fold, [u, v], row.level[pixel], 1.0);
        sum
    });
}

pub(super) fn best<T: Texel, const PLAIN: bool>(texture: &Texture, fold: Fold, row: Row<'_>, line: &mut [u8]) {
    let pyramid = &Pyramid::<T>::of(texture);
    each_pixel(pyramid, row, line, |u, v, pixel| {
        let [ux, vx, uy, vy] = row.jacobian.map(|plane| plane[pixel]);
        let mut sum = [0.0; 4];
        for [x, y] in ROTATED_GRID {
            let (u, v) = (u + x * ux + y * uy, v + x * vx + y * vy);
            add_trilinear(&mut sum, pyramid, fold, [u, v], row.level[pixel] - 1.0, 0.25);
        }
        sum
    });
}

/// Writes the pixel made of `sample(u, v, column)` wherever the row shows something, and nothing elsewhere.
fn each_pixel<T: Texel>(
    pyramid: &Pyramid<'_, T>,
    row: Row<'_>,
    line: &mut [u8],
    sample: impl Fn(f32, f32, usize) -> Sum,
) {
    for (column, pixel) in line.as_chunks_mut().0.iter_mut().enumerate() {
        let (u, v) = (row.u[column], row.v[column]);
        let hidden = u.is_nan() || v.is_nan();
        *pixel = if hidden { [0; 4] } else { T::pixel(sample(u, v, column), pyramid.tables) };
    }
}

/// Adds `weight` times the texture at (u, v), blended between the two levels around `level`.
fn add_trilinear<T: Texel>(
    sum: &mut Sum,
    pyramid: &Pyramid<'_, T>,
    fold: Fold,
    [u, v]: [f32; 2],
    level: f32,
    weight: f32,
) {
    let levels = pyramid.levels;
    let (u, v) = (fold.apply(u, levels[0].width as f32), fold.apply(v, levels[0].height as f32));
    let level = level.max(0.0).min((levels.len() - 1) as f32);
    let (lower, share) = (level as usize, level.fract());
    add_bilinear(sum, pyramid.texels, &levels[lower], fold, [u, v], weight * (1.0 - share));
    if share > 0.0 {
        add_bilinear(sum, pyramid.texels, &levels[lower + 1], fold, [u, v], weight * share);
    }
}

/// Adds `weight` times the level at (u, v), which are texels of level 0.
fn add_bilinear<T: Texel>(sum: &mut Sum, texels: &[T], level: &Level, fold: Fold, [u, v]: [f32; 2], weight: f32) {
    let (column, x) = cell(u * level.scale[0], level.width);
    let (row, y) = cell(v * level.scale[1], level.height);
    let start = level.offset + row * level.stride + column;
    let (x, y) = (shares(fold, column, x, level.width), shares(fold, row, y, level.height));
    let weights = [x[0] * y[0], x[1] * y[0], x[0] * y[1], x[1] * y[1]];
    for (tap, share) in [0, 1, level.stride, level.stride + 1].into_iter().zip(weights) {
        for (channel, value) in sum.iter_mut().zip(texels[start + tap].channels()) {
            *channel += weight * share * value;
        }
    }
}

/// The weights of the texel `before` a point and of the next one, which lies the share `t` nearer than that.
fn shares(fold: Fold, before: usize, t: f32, size: usize) -> [f32; 2] {
    let weight = |at: usize, share: f32| if fold.is_framed() && is_border(at, size) { 0.0 } else { share };
    [weight(before, 1.0 - t), weight(before + 1, t)]
}

/// Whether a texel of a level (the border's included) is the border's.
fn is_border(at: usize, size: usize) -> bool {
    at == 0 || at > size
}

/// The texel (the border's included) before the point `t`, and the share of the next one.
fn cell(t: f32, size: usize) -> (usize, f32) {
    let size = size as f32;
    let t = (t - 0.5).clamp(-1.0, size);
    let before = t.floor().min(size - 1.0);
    ((before as i32 + 1) as usize, t - before)
}
