//! What all warps share.

use super::buffer;
use super::options::WarpOptions;
use super::prepared::PreparedWarp;
use super::render::render;
use super::strip::Strip;
use super::texture::Texture;
use crate::Result;

/// What can move a picture: every [`PlaneMap`](crate::PlaneMap), and meshes.
pub trait Warp {
    /// Hands on, strip by strip, the point of such a texture that each pixel of the view's rows shows, and its footprint
    /// there. It looks at no texel.
    ///
    /// # Errors
    /// [`Error::InvalidRows`](crate::Error::InvalidRows), and those of the map.
    #[doc(hidden)]
    fn footprints(&self, texture: &Texture, options: &WarpOptions, each: &mut dyn FnMut(&Strip)) -> Result<()>;

    /// Whether the texture ends at its frame, whatever its wrap mode. (Else the footprints end where the texture does.)
    #[doc(hidden)]
    fn is_framed(&self, options: &WarpOptions) -> bool {
        let _ = options;
        false
    }

    /// Draws `texture` as the map shows it into `out`: RGBA bytes with straight alpha, 4 · columns · rows of them for
    /// the rows of the view that the options name. Every byte of `out` is written.
    ///
    /// # Errors
    /// [`Error::WrongLength`](crate::Error::WrongLength) if `out` does not fit,
    /// [`Error::InvalidRows`](crate::Error::InvalidRows), and those of the map.
    fn warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        render(texture, self.is_framed(options), options, out, |each| self.footprints(texture, options, each))
    }

    /// What [`Warp::warp_into`] finds out before it looks at a texel: for pictures that change under a map and a view that
    /// do not. It is good for all textures of the size and wrap mode of `texture`.
    ///
    /// # Errors
    /// [`Error::InvalidRows`](crate::Error::InvalidRows), and those of the map.
    fn prepare(&self, texture: &Texture, options: &WarpOptions) -> Result<PreparedWarp> {
        PreparedWarp::record(texture, self.is_framed(options), options, |each| self.footprints(texture, options, each))
    }

    /// [`Warp::warp_into`], into a new vector.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    fn warp(&self, texture: &Texture, options: &WarpOptions) -> Result<Vec<u8>> {
        let mut out = buffer::blank(options.output_size()?)?;
        self.warp_into(texture, options, &mut out)?;
        Ok(out)
    }
}
