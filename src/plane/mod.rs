//! The plane: complex points, frames (pixels ↔ plane), polygons, regions, and domains with holes.

mod affine;
pub(crate) mod chains;
mod contour;
mod curved_outline;
mod domain;
mod edge;
mod edge_pieces;
mod edge_tree;
mod elliptic_arc;
pub(crate) mod fourier;
mod frame;
mod horn;
mod inner_point;
mod json_points;
mod lie;
mod outline_text;
mod polygon;
mod region;
mod smooth_curve;
mod smooth_pieces;
mod sorting;
mod spline;
mod stored_edges;
mod svg_file;
pub(crate) mod svg_path;

pub(crate) use contour::Contour;
pub use contour::Curve;
pub use curved_outline::CurvedOutline;
pub use domain::Domain;
pub(crate) use domain::DomainPoint;
pub use edge::Edge;
pub(crate) use edge_pieces::distance_to_segment;
pub(crate) use edge_tree::EdgeTree;
pub use elliptic_arc::{ArcTo, EllipticArc};
pub use frame::Frame;
pub(crate) use horn::CutHorns;
pub(crate) use inner_point::inner_point;
pub(crate) use lie::Lie;
pub use num_complex::Complex64;
pub use outline_text::{Shape, parse_outline, parse_path, parse_path_with_holes, parse_shape, path_data};
pub(crate) use polygon::ON_BOUNDARY;
pub use polygon::{BoundaryPoint, Polygon};
pub use region::Region;
pub use smooth_curve::SmoothCurve;
pub use smooth_pieces::smooth_edges;
pub(crate) use sorting::{sort_by, sort_by_number};
pub use spline::spline;

/// The image of what has none.
pub(crate) const NOWHERE: Complex64 = Complex64::new(f64::NAN, f64::NAN);
