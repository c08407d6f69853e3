//! How near to its boundary a point is on it, in a region and in the disk.

use crate::plane::Complex64;
pub(super) use crate::plane::ON_BOUNDARY;

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

/// The point of the closed disk nearest to `w`.
#[inline]
pub(super) fn onto_disk(w: Complex64) -> Complex64 {
    let square = w.norm_sqr();
    if square > 1.0 { inwards(w / square.sqrt()) } else { w }
}

/// Of a point that is on the circle up to rounding, one that is not beyond it, by either way of computing |w|.
#[cold]
fn inwards(mut w: Complex64) -> Complex64 {
    while w.norm_sqr() > 1.0 || w.norm() > 1.0 {
        w *= 1.0 - 0.5 * f64::EPSILON;
    }
    w
}
