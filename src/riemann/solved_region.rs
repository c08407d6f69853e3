//! What [`RiemannMap`](super::RiemannMap) asks of a solved region, whatever its boundary is made of.

use super::atlas::{DiskPoint, Position};
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64};
use crate::symm::options::{Progress, SolveOptions, Stop};
use std::fmt::Debug;
use std::sync::Arc;

/// A region with its solution of Symm's equation: region ↔ disk with vertex 0 ↦ 1, in plane units, with the evidence.
///
/// A point of the disk is a [`DiskPoint`]: a number in one of the region's charts, of which there is one, the disk itself,
/// unless a kind of region says otherwise.
pub(super) trait SolvedRegion: Debug + Send + Sync {
    /// Largest violation of the boundary condition log|f| = 0 where it was not imposed.
    fn residual(&self) -> f64;

    /// Estimate of the largest error of the map, in units of the disk.
    fn error_estimate(&self) -> f64;

    /// Why the solve ended.
    fn stop(&self) -> Stop;

    /// Number of unknowns of the last system solved.
    fn unknowns(&self) -> usize;

    /// |f'(center)|⁻¹.
    fn conformal_radius(&self) -> f64;

    /// The same boundary solved for another center, with what was assembled and factored before.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled), [`Error::NegativeMass`](crate::Error::NegativeMass).
    fn with_center(
        &self,
        center: Complex64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Arc<dyn SolvedRegion>>;

    /// Harmonic measure from vertex 0 to each vertex.
    fn vertex_measures(&self) -> Vec<f64>;

    /// Harmonic measure from vertex 0 to a boundary point.
    fn measure_at(&self, point: BoundaryPoint) -> f64;

    /// Harmonic measure from vertex 0 → boundary point; the inverse of [`SolvedRegion::measure_at`].
    fn boundary_point(&self, measure: f64) -> BoundaryPoint;

    /// Region → disk; `None` outside the closed region.
    fn to_disk(&self, z: Complex64) -> Option<DiskPoint>;

    /// Region → disk, with the derivative in the point's chart.
    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)>;

    /// Region → disk by summation over the boundary; `None` outside the closed region.
    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64>;

    /// Disk → region; `None` outside the closed disk.
    fn from_disk(&self, point: DiskPoint) -> Option<Complex64>;

    /// Disk → region, with the derivative by the point's number in its chart.
    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)>;

    /// The point as a number of the disk.
    fn flat(&self, point: DiskPoint) -> Complex64 {
        point.w
    }

    /// The derivative of [`SolvedRegion::flat`].
    fn flat_slope(&self, _: DiskPoint) -> Complex64 {
        Complex64::ONE
    }

    /// A place where parts of the region are crowded together most, if that had to be accepted anywhere.
    fn crowded(&self) -> Option<Complex64> {
        None
    }

    /// Where the charts lie.
    fn positions(&self) -> &[Position] {
        static ONE_POSITION: [Position; 1] = [Position::FIRST];
        &ONE_POSITION
    }

    /// Builds now what is otherwise built when it is first asked for.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was built by then is kept.
    fn prepare(&self, _: Progress) -> Result<()> {
        Ok(())
    }

    /// Bytes of memory that this took so far, about.
    fn bytes(&self) -> usize {
        0
    }
}
