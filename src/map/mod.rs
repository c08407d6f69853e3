//! The algebra of maps of the plane, each with its derivative: what a warp pulls a picture back through.
//!
//! Which maps there are, this module does not know: they stand above it, side by side.

pub(crate) mod compose;
mod inverse;
mod jet;
mod moebius;
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
mod parallel;
mod plane_map;

pub use compose::Compose;
pub use inverse::{Inverse, InvertibleMap};
pub use jet::Jet;
pub use moebius::Moebius;
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
pub use parallel::par_points;
pub use plane_map::PlaneMap;
pub(crate) use plane_map::pointwise;
