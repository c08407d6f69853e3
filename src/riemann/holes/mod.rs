//! Maps, fields and flows of regions with holes, and of the outside of bodies.
//!
//! One solve of `solved` gives analytic functions ([`field`]); a map onto a canonical region is one of them, or its exponential
//! (`canonical`), which goes both ways.

mod annulus;
mod barriers;
mod canonical;
mod circle;
mod circle_search;
mod circles;
mod curve_squares;
mod cuts;
mod edge_squares;
mod electrostatics;
mod evaluator;
mod exterior;
mod far_series;
mod field;
mod flow;
mod flow_points;
mod inside;
mod inverse_tree;
mod level_lines;
mod peak;
mod polygon_squares;
mod round_picture;
mod round_shapes;
mod seeds;
mod slit_shapes;
mod slits;
mod solved;
mod wall_patch;

pub use annulus::{AnnulusMap, RingLines};
pub use circle::Circle;
pub use circles::CircleMap;
pub use electrostatics::{Conductors, Electrostatics};
pub use exterior::ExteriorMap;
pub use flow::{Circulation, FlowLines, PotentialFlow};
pub use flow_points::FlowPoints;
pub use level_lines::LevelLine;
pub use slits::{Slit, SlitKind, SlitMap};
