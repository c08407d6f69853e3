//! Textures and warps: from a map and a picture to pixels.
//!
//! A [`Texture`] is a mip pyramid, built once. Everything that can move a picture implements [`Warp`]; whatever it is,
//! it only says which point of the texture each pixel shows and how large its footprint is there, and one set of
//! samplers turns that into colours:
//! ```text
//! PlaneMap, pulled back ─► blocks, subdivided ─────────┐
//! PlaneMap, pushed forward ─► mesh of the texture ─┐   ▼
//! TriangleMesh ────────────────────────────────────┴► footprints ─► sampler (nearest … best) ─► RGBA
//! ```

mod crop;
mod foveated;
mod joint;
mod light;
mod mesh;
mod node;
mod options;
mod outline;
mod overlay;
mod palette;
mod patch;
mod prepared;
mod pull_back;
mod push_forward;
mod pyramid;
mod raster;
pub mod recovery;
mod refine;
mod render;
mod sampler;
mod source_mesh;
mod strip;
mod texel;
mod texture;
mod union;

pub use foveated::FoveatedTexture;
pub use light::Light;
pub use mesh::TriangleMesh;
pub use options::{Direction, Quality, WarpOptions};
pub use overlay::{Overlay, Stroke};
pub use prepared::PreparedWarp;
pub use texture::{Texture, Wrap};

use crate::Result;
use crate::map::PlaneMap;
use prepared::Reach;
use strip::Strip;

/// What can move a picture.
pub trait Warp {
    /// Draws `texture` as the map shows it into `out`: RGBA bytes with straight alpha, 4 · columns · rows of them for
    /// the rows of the view that the options name. Every byte of `out` is written.
    ///
    /// # Errors
    /// [`crate::Error::WrongLength`] if `out` does not fit, [`crate::Error::InvalidRows`], and those of the map.
    fn warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()>;

    /// What [`Warp::warp_into`] finds out before it looks at a texel: for pictures that change under a map and a view that
    /// do not. It is good for all textures of the size and wrap mode of `texture`.
    ///
    /// # Errors
    /// [`crate::Error::InvalidRows`], and those of the map.
    fn prepare(&self, texture: &Texture, options: &WarpOptions) -> Result<PreparedWarp>;

    /// [`Warp::warp_into`], into a new vector.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    fn warp(&self, texture: &Texture, options: &WarpOptions) -> Result<Vec<u8>> {
        let mut out = vec![0; options.output_len()?];
        self.warp_into(texture, options, &mut out)?;
        Ok(out)
    }
}

impl<M: PlaneMap + ?Sized> Warp for M {
    fn warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        render::render(texture, options, out, |each| strips(self, texture, options, each))
    }

    fn prepare(&self, texture: &Texture, options: &WarpOptions) -> Result<PreparedWarp> {
        PreparedWarp::record(texture, options, Reach::of(texture), |each| strips(self, texture, options, each))
    }
}

/// Hands on the strips of a map's warp.
fn strips<M: PlaneMap + ?Sized>(
    map: &M,
    texture: &Texture,
    options: &WarpOptions,
    each: &mut dyn FnMut(&Strip),
) -> Result<()> {
    match options.direction {
        Direction::PullBack => pull_back::pull_back(map, texture, options, each),
        Direction::PushForward => match map.inverse() {
            Some(inverse) => pull_back::pull_back(&*inverse, texture, options, each),
            None => push_forward::push_forward(map, texture, options, each),
        },
    }
}
