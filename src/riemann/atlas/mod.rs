//! The map as a function, both ways, a million points at a time.
//!
//! ```text
//! solution ─► atlas: charts (one for each center), links ─► region side: cells and patches ─► disk side, one a chart
//! ```
//! A cell is a square with a Taylor polynomial; the potential's series comes from multipole expansions. A patch is a zone
//! beside the boundary with one real power series in the variable that straightens the boundary, so that the walls are
//! exact and corners harmless. Where the map of the region's own center crowds everything together, further centers have
//! charts of their own, linked by automorphisms of the disk.
//!
//! A point of the disk is a number in the chart that tells it apart best. Each chart also knows its [`position`], the place of
//! its center in the hyperbolic plane, in a form that distance does not blur; from the positions of two regions comes the
//! [`passage`] from one's charts to the other's.
//!
//! In the order of the computation:
//! - [`accuracy`] says what is wanted; [`power_series`] and [`fit`] are the arithmetic;
//! - [`walls`] measures distances to the boundary, [`zone`] divides what lies beside it;
//! - [`charts`] maps the region for several centers, with a [`link`] between any two and the [`position`] of each;
//! - [`region_side`] goes region → disk: a [`quadtree`] whose [`leaf`] is one of its [`cells`] or one of its [`patches`]
//!   (each a [`patch`], from an [`arc_sampler`]), as [`region_builder`] decides;
//! - [`disk_side`] goes disk → region: [`disk_builder`] cuts a chart's disk into the cells of [`inverse_cell`];
//! - [`expansions`] is all of it for one region, its points are [`disk_point`]s; [`passage`] goes on to another region.

pub(super) mod accuracy;
pub(super) mod arc_sampler;
pub(super) mod cells;
mod charts;
mod disk_builder;
mod disk_point;
mod disk_side;
mod expansions;
pub(super) mod fit;
mod inverse_cell;
pub(super) mod leaf;
mod link;
mod passage;
mod patch;
mod patches;
mod position;
pub(super) mod power_series;
pub(super) mod quadtree;
mod region_builder;
mod region_side;
pub(super) mod walls;
pub(super) mod zone;

pub use disk_point::DiskPoint;
pub use expansions::Expansions;
pub use link::Link;
pub use passage::{Compass, Passage};
pub use position::Position;
pub use region_side::Found;
