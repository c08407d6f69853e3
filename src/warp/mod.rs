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
//! In the order of the computation:
//! - `options` says what is wanted; `buffer` checks and makes room for pixels;
//! - `texture` is the picture: `texel`s in the `pyramid`'s levels, averaged as `light`;
//! - `warping` is what all warps share: footprints go by `strip`s to the `sampler`, or into a `prepared` warp;
//!   `render` is the loop over the strips;
//! - `plane_map` is the warp of a map: `pull_back` asks it for a `node` at the corners of blocks, which `refine`
//!   subdivides until a `coons_patch` fits; `push_forward` meshes the texture's frame (`source_mesh`);
//! - `mesh` is the warp of triangles: `raster` converts them, `outline` and `union` say how much of a pixel they
//!   cover; `joint` draws a joint triangulation;
//! - `parallel`, a feature, draws bands of rows on several threads;
//! - `foveated` stacks textures, made of `crop`s; [`recovery`] goes there and back;
//! - `overlay` draws what explains a map, in colours of the `palette`.

pub(crate) mod buffer;
mod coons_patch;
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
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
mod parallel;
mod plane_map;
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
mod warping;

pub use foveated::FoveatedTexture;
pub use light::Light;
pub use mesh::TriangleMesh;
pub use options::{Direction, Quality, WarpOptions, Wrap};
pub use overlay::{Overlay, Stroke};
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
pub use parallel::ParallelWarp;
pub use prepared::PreparedWarp;
pub use texture::Texture;
pub use warping::Warp;
