//! Maps, fields and flows of regions with holes, and of the outside of bodies.
//!
//! One solve of `solved` gives analytic functions ([`field`]); a map onto a canonical region is one of them, or its exponential
//! (`canonical`), which goes both ways.

mod annulus;
mod canonical;
mod cells;
mod electrostatics;
mod exterior;
mod field;
mod flow;
mod peak;
mod seeds;
mod slits;
mod solved;

pub use annulus::AnnulusMap;
pub use electrostatics::{Conductors, Electrostatics};
pub use exterior::ExteriorMap;
pub use flow::{Circulation, PotentialFlow};
pub use slits::{Slit, SlitKind, SlitMap};
