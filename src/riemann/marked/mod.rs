//! Maps that marked boundary points make unique: onto a rectangle, a strip, the half plane.
//!
//! A `map` takes the charts of a solved region's disk on to its target, which is a `rectangle`, a `strip` or a `half_plane`, with
//! the `marks` known in every chart; `elliptic` has the functions of rectangles. What flows through a `channel` runs straight there.

mod channel;
mod elliptic;
mod half_plane;
mod map;
mod marks;
mod points;
mod rectangle;
mod strip;

pub use channel::{ChannelEnds, ChannelFlow};
pub use half_plane::HalfPlaneMap;
pub use rectangle::RectangleMap;
pub use strip::StripMap;
