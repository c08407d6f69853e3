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
use fold::Fold;
use input::Kernel;

pub(super) use input::Row;

/// Columns that are drawn from top to bottom before the next ones: what neighbours show is still in the cache then.
const COLUMNS: usize = 64;

/// How a picture's rows are drawn.
#[derive(Clone, Copy)]
pub(super) struct Sampler {
    draw: Kernel,
    fold: Fold,
}

impl Sampler {
    /// What draws rows of such a texture; of what lies in its frame, if `framed`.
    ///
    /// # Errors
    /// [`crate::Error::OutOfMemory`] if there is no memory for the texture's light, which the best quality samples.
    pub fn new(texture: &Texture, framed: bool, quality: Quality) -> Result<Self> {
        let fold = match texture.wrap() {
            // Its border shows nothing as it is.
            Wrap::Transparent => Fold::Unchanged,
            _ if framed => Fold::Framed,
            Wrap::Clamp => Fold::Clamped,
            Wrap::Repeat => Fold::Repeated,
            Wrap::Mirror => Fold::Mirrored,
        };
        let draw = match (quality, texture.light()) {
            (Quality::Nearest, _) => kernels::nearest,
            (Quality::Bilinear, _) => kernels::bilinear,
            (Quality::Trilinear, _) => kernels::trilinear,
            (Quality::Best, Light::Plain) => best::<ByteTexel>(fold),
            (Quality::Best, Light::Linear) => {
                texture.make_light()?;
                best::<LightTexel>(fold)
            }
        };
        Ok(Self { draw, fold })
    }

    /// Draws a row's pixels, as many as the bytes are for.
    #[inline]
    pub fn row(self, texture: &Texture, row: Row<'_>, line: &mut [u8]) {
        (self.draw)(texture, self.fold, row, line);
    }

    /// Draws every row of the strip: `out` holds `strip.rows` rows of 4 · `strip.width` bytes.
    pub fn strip(self, texture: &Texture, strip: &Strip, out: &mut [u8]) {
        for start in (0..strip.width).step_by(COLUMNS) {
            let end = strip.width.min(start + COLUMNS);
            for (row, line) in out.chunks_exact_mut(4 * strip.width).enumerate() {
                let footprints = Row::of(strip, row, start, end.next_multiple_of(4));
                self.row(texture, footprints, &mut line[4 * start..4 * end]);
            }
        }
    }
}

fn best<T: kernels::Texel>(fold: Fold) -> Kernel {
    if fold == Fold::Unchanged { kernels::best::<T, true> } else { kernels::best::<T, false> }
}

#[cfg(not(target_feature = "simd128"))]
use scalar as kernels;
/// The fastest kernels of this build.
#[cfg(target_feature = "simd128")]
use simd as kernels;

#[cfg(all(test, target_feature = "simd128"))]
mod twins;
