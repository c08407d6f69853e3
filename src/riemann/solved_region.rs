//! What [`RiemannMap`](super::RiemannMap) asks of a solved region, whatever its boundary is made of.

use super::atlas::{DiskPoint, Position};
pub(super) use super::evidence::Evidence;
use super::rounding::onto_disk;
use crate::Result;
use crate::map::{Jet, pointwise};
use crate::plane::{BoundaryPoint, Complex64, NOWHERE, Region};
use crate::stored::Writer;
use crate::symm::options::{Progress, SolveOptions};
use std::fmt;
use std::sync::Arc;

/// What was solved, for the center of `region`.
#[derive(Clone, Debug)]
pub(super) struct Root {
    pub region: Region,
    pub options: SolveOptions,
    /// Shared by clones.
    pub solved: Arc<dyn SolvedRegion>,
}

/// A region with its solution of Symm's equation: region ↔ disk with vertex 0 ↦ 1, in plane units, with the evidence.
///
/// A point of the disk is a [`DiskPoint`]: a number in one of the region's charts, of which there is one, the disk itself,
/// unless a kind of region says otherwise.
pub(super) trait SolvedRegion: Send + Sync {
    /// How good the solution is.
    fn evidence(&self) -> Evidence;

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

    /// What this is seen from another center; `None` if it was solved for its own.
    fn root(&self) -> Option<&Root> {
        None
    }

    /// Harmonic measure from vertex 0 to each vertex.
    fn vertex_measures(&self) -> Vec<f64>;

    /// Harmonic measure from vertex 0 to a boundary point.
    fn measure_at(&self, point: BoundaryPoint) -> f64;

    /// Harmonic measure from vertex 0 → boundary point; the inverse of [`SolvedRegion::measure_at`].
    fn boundary_point(&self, measure: f64) -> BoundaryPoint;

    /// Region → disk, beyond the circle by no more than the solve's error; `None` outside the closed region.
    fn to_disk(&self, z: Complex64) -> Option<DiskPoint>;

    /// [`SolvedRegion::to_disk`], with the derivative in the point's chart.
    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)>;

    /// Region → disk by summation over the boundary; `None` outside the closed region.
    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64>;

    /// Disk → region; `None` outside the closed disk.
    fn from_disk(&self, point: DiskPoint) -> Option<Complex64>;

    /// Disk → region, with the derivative by the point's number in its chart.
    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)>;

    /// Beside a vertex, where its own variable serves: the chart, and −i log(w/w₀) with the relative accuracy of the distance from
    /// it, w₀ being the vertex' image in that chart.
    fn beside(&self, _vertex: usize, _z: Complex64) -> Option<(usize, Complex64)> {
        None
    }

    /// The inverse of [`SolvedRegion::beside`]: the place, and its derivative by the value.
    fn from_beside(&self, _vertex: usize, _chart: usize, _angle: Complex64) -> Option<(Complex64, Complex64)> {
        None
    }

    /// The point as a number of the disk.
    fn flat(&self, point: DiskPoint) -> Complex64 {
        point.w
    }

    /// The derivative of [`SolvedRegion::flat`].
    fn flat_slope(&self, _: DiskPoint) -> Complex64 {
        Complex64::ONE
    }

    /// Region → disk turned by `turn`, as numbers; NaN outside the closed region. One dynamic call serves all points here and
    /// in the methods below.
    fn images(&self, points: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        points.iter().map(|&z| self.to_disk(z).map_or(NOWHERE, |point| onto_disk(turn * self.flat(point)))).collect()
    }

    /// Disk turned by `turn` → region; NaN outside the closed disk.
    fn places(&self, images: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let back = turn.conj();
        images.iter().map(|w| self.from_disk(DiskPoint::flat(back * w)).unwrap_or(NOWHERE)).collect()
    }

    /// The derivatives of [`SolvedRegion::images`].
    fn slopes(&self, points: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let slope = |(point, slope): (DiskPoint, Complex64)| turn * slope * self.flat_slope(point);
        points.iter().map(|&z| self.to_disk_with_slope(z).map_or(NOWHERE, slope)).collect()
    }

    /// Writes the jets of [`SolvedRegion::images`].
    fn jets(&self, points: &[Complex64], turn: Complex64, jets: &mut [Jet]) {
        pointwise(points, jets, |z| {
            let (point, slope) = self.to_disk_with_slope(z)?;
            Some(Jet::analytic(onto_disk(turn * self.flat(point)), turn * slope * self.flat_slope(point)))
        });
    }

    /// Writes the jets of [`SolvedRegion::places`].
    fn inverse_jets(&self, images: &[Complex64], turn: Complex64, jets: &mut [Jet]) {
        let back = turn.conj();
        pointwise(images, jets, |w| {
            let (z, slope) = self.from_disk_with_slope(DiskPoint::flat(back * w))?;
            Some(Jet::analytic(z, back * slope))
        });
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

    /// [`SolvedRegion::positions`] as they are seen from where the first of them lies at `first`.
    fn positions_from(&self, first: Position) -> Vec<Position> {
        vec![first]
    }

    /// Builds now what is otherwise built when it is first asked for.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was built by then is kept.
    fn prepare(&self, _: Progress) -> Result<()> {
        Ok(())
    }

    /// Writes the solution, from which and the region, center and options it can be restored.
    fn store(&self, to: &mut Writer);

    /// Bytes of memory that this took so far, about.
    fn bytes(&self) -> usize {
        0
    }
}

/// Of any kind: as a part of the trait it would have every module carry the text of all that a solved region holds.
impl fmt::Debug for dyn SolvedRegion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SolvedRegion").field("evidence", &self.evidence()).finish_non_exhaustive()
    }
}
