//! Which points of the two copies belong together.

use super::side::{Side, UnitDisk};
use crate::plane::{BoundaryPoint, Complex64};
use crate::riemann::{RegionMap, RiemannMap};

/// A map from one copy to the other, both ways.
///
/// The mesh needs no more than a homeomorphism: that the maps are conformal makes it good, not valid.
pub(super) trait Correspondence {
    /// Source and target.
    fn copies(&self) -> [&dyn Side; 2];
    /// Source → target; NaN outside.
    fn forward(&self, points: &[Complex64]) -> Vec<Complex64>;
    /// Target → source; NaN outside.
    fn backward(&self, points: &[Complex64]) -> Vec<Complex64>;
    /// Source's boundary → target's.
    fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint;
    /// Target's boundary → source's.
    fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint;
    /// Disk → source; NaN outside the disk.
    fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64>;
    /// |derivative| of source → target at nodes of both; not finite where it is singular or unknown.
    fn magnification(&self, source: &[Complex64], target: &[Complex64]) -> Vec<f64>;
}

/// Region → region, exactly.
impl Correspondence for RegionMap {
    fn copies(&self) -> [&dyn Side; 2] {
        [self.source(), self.target()]
    }

    fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.forward(points)
    }

    fn backward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.inverse(points)
    }

    fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.boundary_forward(point)
    }

    fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.boundary_inverse(point)
    }

    fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.source().from_disk(points)
    }

    fn magnification(&self, source: &[Complex64], target: &[Complex64]) -> Vec<f64> {
        let [source, target] = [self.source().derivative(source), self.target().derivative(target)];
        source.iter().zip(target).map(|(there, back)| there.norm() / back.norm()).collect()
    }
}

/// Region → disk.
pub(super) struct OntoDisk<'a>(pub(super) &'a RiemannMap);

impl Correspondence for OntoDisk<'_> {
    fn copies(&self) -> [&dyn Side; 2] {
        [self.0, &UnitDisk]
    }

    fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.to_disk(points)
    }

    fn backward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.from_disk(points)
    }

    fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
        UnitDisk.at_angle(self.0.angle(point))
    }

    fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.0.at_angle(UnitDisk.angle(point))
    }

    fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.from_disk(points)
    }

    fn magnification(&self, source: &[Complex64], _: &[Complex64]) -> Vec<f64> {
        self.0.derivative(source).into_iter().map(Complex64::norm).collect()
    }
}
