//! Points of the disk that keep their places apart.

use crate::plane::{Complex64, NOWHERE};

/// A point of the closed disk in the chart where it is told apart best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiskPoint {
    /// The chart.
    pub(in super::super) chart: usize,
    /// The point of its disk.
    pub(in super::super) w: Complex64,
}

impl DiskPoint {
    /// No point.
    pub const NOWHERE: Self = Self { chart: 0, w: NOWHERE };

    /// The nearest point of the circle.
    pub(in super::super) fn onto_circle(self) -> Self {
        Self { w: self.w / self.w.norm(), ..self }
    }

    /// Another point of the same chart.
    #[inline]
    pub(in super::super) fn map(self, f: impl Fn(Complex64) -> Complex64) -> Self {
        Self { w: f(self.w), ..self }
    }

    /// A point that is given by a number.
    pub(in super::super) fn flat(w: Complex64) -> Self {
        Self { chart: 0, w }
    }
}
