//! Riemann maps: region ↔ disk by Symm's equation, and region ↔ region through the disk.
//!
//! [`RiemannMap`] solves (`solved`) and answers both ways, at many points, through its `atlas` of charts; [`RegionMap`]
//! joins two of them.

mod atlas;
mod region_map;
mod riemann_map;
mod solved;

pub use atlas::DiskPoint;
pub use region_map::RegionMap;
pub use riemann_map::RiemannMap;
