//! Joint triangulations: the same connectivity on two point sets, affine in between.
//!
//! The paper's second method (section 3): sample a region, map the samples, triangulate, and carry the picture triangle
//! by triangle. In the order of the computation:
//! - `options` says how densely; `side` is one copy and its outline, `correspondence` which points belong together;
//! - `ring` refines the boundary, with `net` over crowded nodes; `scan` samples the interior;
//! - `connect` makes triangles (`triangles` is what can be said of them) of a `draft`'s nodes, `flip` mends edges;
//! - `density` adds nodes until the affine pieces are as near to the map as asked, measured at points of `probe`;
//! - `repair` adds nodes until no triangle is flipped, and where double precision has no room, `pocket` connects anew
//!   (`compatible`);
//! - `locate` is the paper's way from region to region;
//! - `joint` is the mesh and `quality` its measures, `build` makes it, `validate` proves it, `export` writes it.

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
mod probe;
mod quality;
mod repair;
mod ring;
mod scan;
mod side;
#[cfg(test)]
mod star;
mod triangles;
mod validate;

pub use joint::{JointTriangulation, MeshEvidence, MeshStop};
pub use options::{Density, MeshOptions, Route};
