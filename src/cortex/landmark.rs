//! What fixes the map of an outline.

use crate::plane::Complex64;

/// What is known of the correspondence field → cortex: a point's place, and a direction there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landmark {
    /// The landmark's field coordinate, strictly inside the right hemifield.
    pub field: Complex64,
    /// Its place on the cortex, in the outline's units: the outline's map takes it to 0.
    pub cortex: Complex64,
    /// Which way the cortex runs there as one moves away from the fovea, parallel to the horizontal meridian: radians,
    /// counter-clockwise from the cortex plane's x axis.
    pub direction: f64,
}
