//! A solved smooth curve: Symm's equation at equally spaced nodes, evaluated by Cauchy's formula.

use super::atlas::DiskPoint;
use super::rounding::{is_on_circle, is_outside_disk, onto_disk};
use super::solved_region::{Evidence, SolvedRegion};
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Lie, Region};
use crate::stored::{Reader, Writer};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::smooth::{SmoothSolution, solve_smooth};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A smooth curve's solution; nothing more is built.
#[derive(Debug)]
pub(super) struct SolvedCurve {
    /// Where `region` has its 0.
    origin: Complex64,
    region: Region,
    solution: SmoothSolution,
}

impl SolvedCurve {
    /// Solves Symm's equation for the smooth curve that bounds a region; `None` if it is bounded by something else.
    ///
    /// # Errors
    /// As [`solve_smooth`].
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Option<Self>> {
        let (origin, region) = region.local();
        let Some(curve) = region.smooth() else { return Ok(None) };
        let solution = solve_smooth(curve, region.center(), options, progress)?;
        Ok(Some(Self { origin, region, solution }))
    }

    /// Reads what [`SolvedRegion::store`] wrote.
    ///
    /// # Errors
    /// As [`SmoothSolution::restore`].
    pub fn restore(region: &Region, from: &mut Reader) -> Result<Self> {
        let (origin, region) = region.local();
        let solution = SmoothSolution::restore(&region, from)?;
        Ok(Self { origin, region, solution })
    }
}

impl SolvedRegion for SolvedCurve {
    fn evidence(&self) -> Evidence {
        let solution = &self.solution;
        Evidence {
            residual: solution.residual,
            error_estimate: solution.error_estimate,
            stop: solution.stop,
            unknowns: solution.unknowns(),
        }
    }

    fn conformal_radius(&self) -> f64 {
        self.solution.conformal_radius()
    }

    fn with_center(
        &self,
        center: Complex64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Arc<dyn SolvedRegion>> {
        let region = self.region.with_center(center - self.origin, self.region.toward().point)?;
        let mut solution = self.solution.moved(region.center(), options.tolerance, progress)?;
        if let (Some(curve), true) = (region.smooth(), solution.needs_nodes(options.tolerance)) {
            solution = solve_smooth(curve, region.center(), options, progress)?;
        }
        Ok(Arc::new(Self { origin: self.origin, region, solution: solution.checked()? }))
    }

    fn vertex_measures(&self) -> Vec<f64> {
        let count = self.solution.curve().points().len();
        (0..count).map(|k| self.solution.measure(TAU * k as f64 / count as f64)).collect()
    }

    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        self.solution.measure(self.solution.curve().parameter(point))
    }

    fn boundary_point(&self, measure: f64) -> BoundaryPoint {
        let place = self.solution.curve().place(self.solution.parameter(measure));
        BoundaryPoint { point: place.point + self.origin, ..place }
    }

    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.to_disk_with_slope(z).map(|(point, _)| point)
    }

    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        let z = z - self.origin;
        let (w, slope) = match self.region.contour().lie(z) {
            Lie::On(place) => self.solution.on_circle(self.solution.curve().parameter(place)),
            Lie::Inside => self.solution.to_disk(z),
            Lie::Outside => return None,
        };
        Some((DiskPoint::flat(onto_disk(w)), slope))
    }

    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64> {
        self.to_disk(z).map(|point| point.w)
    }

    fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        if is_outside_disk(point.w) {
            return None;
        }
        if is_on_circle(point.w) {
            return Some(self.boundary_point(point.w.arg() / TAU).point);
        }
        Some(self.solution.from_disk(point.w) + self.origin)
    }

    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        if is_on_circle(point.w) {
            let t = self.solution.parameter(point.w.arg() / TAU);
            let place = self.solution.curve().place(t);
            return Some((place.point + self.origin, self.solution.on_circle(t).1.inv()));
        }
        let z = self.from_disk(point)?;
        Some((z, self.solution.to_disk(z - self.origin).1.inv()))
    }

    fn store(&self, to: &mut Writer) {
        self.solution.store(to);
    }
}
