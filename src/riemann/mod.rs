//! Riemann maps: region ↔ disk by Symm's equation, and region ↔ region through the disk.
//!
//! [`RiemannMap`] asks a `solved_region`, which is a `polygon` that answers through an `atlas` of charts, or a `smooth`
//! curve, or one of them `recentred` by an `automorphism` of the disk; [`RegionMap`] joins two of them, and `marked` takes the disk on to a rectangle, a strip, the half plane.

mod atlas;
mod automorphism;
mod both_ways;
mod cauchy_tree;
mod curved;
mod doubt;
mod evidence;
mod holes;
mod joined;
mod lazy_tree;
mod marked;
mod near_one;
mod polygon;
mod polyline;
mod recentred;
mod region_map;
mod riemann_map;
mod rounding;
mod smooth;
mod solved_region;

pub use atlas::DiskPoint;
pub use holes::{
    AnnulusMap, Circle, CircleMap, Circulation, Conductors, Electrostatics, ExteriorMap, FlowLines, FlowPoints,
    LevelLine, PotentialFlow, RingLines, Slit, SlitKind, SlitMap,
};
pub use joined::{CanonicalMap, JoinedMap};
pub use marked::{ChannelEnds, ChannelFlow, HalfPlaneMap, RectangleMap, StripMap};
pub use region_map::RegionMap;
pub use riemann_map::RiemannMap;
