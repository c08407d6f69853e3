//! How near to its boundary a point is on it, in a region and in the disk.

use crate::plane::Complex64;

/// In units of the disk, or of the region's size: nearer to the boundary than this is on it.
pub(super) const ON_BOUNDARY: f64 = 4.0 * f64::EPSILON;
/// |w|² of points on the circle differs from 1 by no more.
const ON_CIRCLE: f64 = 2.0 * ON_BOUNDARY;

/// Whether `w` is on the circle, up to rounding.
#[inline]
pub(super) fn is_on_circle(w: Complex64) -> bool {
    (w.norm_sqr() - 1.0).abs() <= ON_CIRCLE
}

/// Whether `w` lies outside the closed disk by more than rounding; NaN does.
#[inline]
pub(super) fn is_outside_disk(w: Complex64) -> bool {
    let square = w.norm_sqr();
    square.is_nan() || square > 1.0 + ON_CIRCLE
}
