//! Samplers: footprints of a strip → RGBA bytes.
//!
//! Quality, wrap mode and light are chosen once an image; below that everything is one loop over a piece of a row.

mod fold;
mod input;
#[cfg_attr(target_feature = "simd128", allow(dead_code, reason = "what the simd kernels are tested against"))]
mod scalar;
#[cfg(target_feature = "simd128")]
mod simd;

use super::light::Light;
use super::options::{Quality, Wrap};
use super::strip::Strip;
use super::texel::{ByteTexel, LightTexel};
use super::texture::Texture;
use crate::Result;
use fold::{Clamped, Fold, Framed, Mirrored, Repeated, Unchanged};

pub(super) use input::{Kernel, Row};

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

/// What draws rows of such a texture; of what lies in its frame, if `framed`.
///
/// # Errors
/// [`crate::Error::OutOfMemory`] if there is no memory for the texture's light, which the best quality samples.
pub(super) fn kernel(texture: &Texture, framed: bool, quality: Quality) -> Result<Kernel> {
    Ok(match (quality, texture.light()) {
        (Quality::Best, Light::Linear) => {
            texture.make_light()?;
            kernel_of::<LightTexel>(texture.wrap(), framed, quality)
        }
        _ => kernel_of::<ByteTexel>(texture.wrap(), framed, quality),
    })
}

fn kernel_of<T: Texel>(wrap: Wrap, framed: bool, quality: Quality) -> Kernel {
    match wrap {
        // Its border shows nothing as it is.
        Wrap::Transparent => folded::<Unchanged, T>(quality),
        _ if framed => folded::<Framed, T>(quality),
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

#[cfg(not(target_feature = "simd128"))]
use scalar as kernels;
/// The fastest kernels of this build.
#[cfg(target_feature = "simd128")]
use simd as kernels;

use kernels::Texel;

#[cfg(all(test, target_feature = "simd128"))]
mod twins;
