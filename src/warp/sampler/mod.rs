//! Samplers: footprints of a strip → RGBA bytes.
//!
//! Quality, wrap mode and light are chosen once an image; below that everything is one loop over a piece of a row.

mod fold;
#[cfg_attr(target_feature = "simd128", allow(dead_code, reason = "what the simd kernels are tested against"))]
mod scalar;
#[cfg(target_feature = "simd128")]
mod simd;

use super::light::{Light, Tables};
use super::options::Quality;
use super::pyramid::Level;
use super::strip::Strip;
use super::texel::{ByteTexel, LightTexel};
use super::texture::{Texture, Wrap};
use crate::Result;
use fold::{Clamped, Fold, Mirrored, Repeated, Unchanged};

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
    /// Columns `start..end` of the strip's row `row`; a quantity that the strip does not hold is empty.
    fn of(strip: &'a Strip, row: usize, start: usize, end: usize) -> Self {
        let first = strip.start(row);
        let part = |plane: &'a Vec<f32>| plane.get(first + start..first + end).unwrap_or_default();
        let [a, b, c, d] = &strip.jacobian;
        Self { u: part(&strip.u), v: part(&strip.v), level: part(&strip.level), jacobian: [a, b, c, d].map(part) }
    }
}

/// Columns that are drawn from top to bottom before the next ones: what neighbours show is still in the cache then.
const COLUMNS: usize = 64;

/// Draws every row of the strip: `out` holds `strip.rows` rows of 4 · `strip.width` bytes.
pub(super) fn sample(draw: Kernel, texture: &Texture, strip: &Strip, out: &mut [u8]) {
    for start in (0..strip.width).step_by(COLUMNS) {
        let end = strip.width.min(start + COLUMNS);
        for (row, line) in out.chunks_exact_mut(4 * strip.width).enumerate() {
            let footprints = Row::of(strip, row, start, end.next_multiple_of(4));
            draw(texture, footprints, &mut line[4 * start..4 * end]);
        }
    }
}

/// What draws rows of such a texture.
///
/// # Errors
/// [`crate::Error::TextureTooLarge`] if there is no memory for the texture's light, which the best quality samples.
pub(super) fn kernel(texture: &Texture, quality: Quality) -> Result<Kernel> {
    Ok(match (quality, texture.light()) {
        (Quality::Best, Light::Linear) => {
            texture.make_light()?;
            kernel_of::<LightTexel>(texture.wrap(), quality)
        }
        _ => kernel_of::<ByteTexel>(texture.wrap(), quality),
    })
}

fn kernel_of<T: Texel>(wrap: Wrap, quality: Quality) -> Kernel {
    match wrap {
        Wrap::Transparent => folded::<Unchanged, T>(quality),
        Wrap::Clamp => folded::<Clamped, T>(quality),
        Wrap::Repeat => folded::<Repeated, T>(quality),
        Wrap::Mirror => folded::<Mirrored, T>(quality),
    }
}

fn folded<W: Fold, T: Texel>(quality: Quality) -> Kernel {
    match quality {
        Quality::Nearest => kernels::nearest::<W>,
        Quality::Bilinear => kernels::bilinear::<W, T>,
        Quality::Trilinear => kernels::trilinear::<W, T>,
        Quality::Best => kernels::best::<W, T>,
    }
}

/// A pyramid of one kind of texels.
struct Pyramid<'a, T> {
    texels: &'a [T],
    levels: &'a [Level],
    tables: &'static Tables,
}

impl<'a, T: Kind> Pyramid<'a, T> {
    fn of(texture: &'a Texture) -> Self {
        Self { texels: T::texels(texture), levels: texture.levels(), tables: texture.light().tables() }
    }
}

/// A kind of texels that textures have.
trait Kind: Copy {
    fn texels(texture: &Texture) -> &[Self];
}

impl Kind for ByteTexel {
    fn texels(texture: &Texture) -> &[Self] {
        texture.texels()
    }
}

impl Kind for LightTexel {
    fn texels(texture: &Texture) -> &[Self] {
        texture.light_texels()
    }
}

#[cfg(not(target_feature = "simd128"))]
use scalar as kernels;
/// The fastest kernels of this build.
#[cfg(target_feature = "simd128")]
use simd as kernels;

use kernels::Texel;

#[cfg(all(test, target_feature = "simd128"))]
mod twins;
