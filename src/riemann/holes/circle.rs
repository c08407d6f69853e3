//! Circles that bound a disk with round holes.

use crate::plane::Complex64;

/// A round hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its center.
    pub center: Complex64,
    /// Its radius.
    pub radius: f64,
}

impl Circle {
    /// What 1/w makes of it; 0 must lie outside.
    #[must_use]
    pub(super) fn inverted(self) -> Self {
        let power = self.center.norm_sqr() - self.radius * self.radius;
        Self { center: self.center.conj() / power, radius: self.radius / power }
    }

    /// The point of the circle nearest to another.
    #[must_use]
    pub(super) fn nearest(self, z: Complex64) -> Complex64 {
        let away = z - self.center;
        self.center + away * (self.radius / away.norm())
    }
}

/// The unit circle.
pub(super) const UNIT: Circle = Circle { center: Complex64::ZERO, radius: 1.0 };
