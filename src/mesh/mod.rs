//! Joint triangulations: the same connectivity on two point sets, affine in between.
//!
//! The paper's second method (section 3): sample a region, map the samples, triangulate, and carry the picture triangle
//! by triangle. Each step is a file: [`MeshOptions`] say how densely, `scan` samples the interior, `ring` refines the
//! boundary, `correspondence` says where a point goes, `connect` makes triangles, `density` grades them to an error,
//! `repair` refines until none is flipped (`flip`, and where double precision has no room, `pocket` and `compatible`),
//! `validate` proves it.

mod build;
mod compatible;
mod connect;
mod correspondence;
mod density;
mod draft;
mod export;
mod flip;
mod joint;
mod locate;
mod net;
mod options;
mod pocket;
mod quality;
mod repair;
mod ring;
mod scan;
mod side;
#[cfg(test)]
mod star;
mod validate;

pub use joint::{Evidence, JointTriangulation};
pub use options::{Density, MeshOptions, Route};
