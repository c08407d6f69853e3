//! Where a point lies with respect to a closed curve.

use super::BoundaryPoint;

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Lie {
    /// On the curve, up to rounding.
    On(BoundaryPoint),
    /// In what it goes around.
    Inside,
    /// Beyond.
    Outside,
}
