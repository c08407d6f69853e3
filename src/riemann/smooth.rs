//! A solved smooth curve: Symm's equation at equally spaced nodes, evaluated by Cauchy's formula.

use super::atlas::DiskPoint;
use super::rounding::{ON_BOUNDARY, is_on_circle, is_outside_disk};
use super::solved_region::SolvedRegion;
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Region, SmoothCurve};
use crate::symm::options::{Progress, SolveOptions, Stop};
use crate::symm::smooth::{SmoothSolution, solve_smooth};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A smooth curve's solution; nothing more is built.
#[derive(Debug)]
pub(super) struct SolvedCurve {
    region: Region,
    solution: SmoothSolution,
}

impl SolvedCurve {
    /// Solves Symm's equation for the `curve` that bounds `region`.
    ///
    /// # Errors
    /// As [`solve_smooth`].
    pub fn solve(
        region: &Region,
        curve: &Arc<SmoothCurve>,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Self> {
        Ok(Self { region: region.clone(), solution: solve_smooth(curve, region.center(), options, progress)? })
    }

    /// The image of a point that is on the boundary, up to rounding.
    fn on_circle(&self, z: Complex64) -> Option<Complex64> {
        let nearest = self.region.nearest(z);
        let near = (nearest.point - z).norm() <= ON_BOUNDARY * self.region.polygon().size();
        near.then(|| Complex64::cis(TAU * self.measure_at(nearest)))
    }
}

impl SolvedRegion for SolvedCurve {
    fn residual(&self) -> f64 {
        self.solution.residual
    }

    fn error_estimate(&self) -> f64 {
        self.solution.error_estimate
    }

    fn stop(&self) -> Stop {
        self.solution.stop
    }

    fn unknowns(&self) -> usize {
        self.solution.unknowns()
    }

    fn conformal_radius(&self) -> f64 {
        self.solution.conformal_radius()
    }

    fn with_center(&self, center: Complex64, options: &SolveOptions, _: Progress) -> Result<Arc<dyn SolvedRegion>> {
        let solution = self.solution.system.solve(center, options.tolerance);
        Ok(Arc::new(Self { region: self.region.clone(), solution }))
    }

    fn vertex_measures(&self) -> Vec<f64> {
        let count = self.solution.curve().points().len();
        (0..count).map(|k| self.solution.measure(TAU * k as f64 / count as f64)).collect()
    }

    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        self.solution.measure(self.solution.curve().parameter(point))
    }

    fn boundary_point(&self, measure: f64) -> BoundaryPoint {
        self.solution.curve().place(self.solution.parameter(measure))
    }

    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.to_disk_with_slope(z).map(|(point, _)| point)
    }

    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        if !self.region.contains(z) {
            return None;
        }
        let (w, slope) = self.solution.to_disk(z);
        Some((DiskPoint::flat(self.on_circle(z).unwrap_or(w)), slope))
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
        Some(self.solution.from_disk(point.w))
    }

    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        let z = self.from_disk(point)?;
        Some((z, self.solution.to_disk(z).1.inv()))
    }
}
