//! A solved boundary of analytic edges: Symm's equation on panels over the edges' parameters, evaluated by summation.

use super::atlas::DiskPoint;
use super::rounding::{is_on_circle, is_outside_disk, onto_disk};
use super::solved_region::{Evidence, SolvedRegion};
use crate::plane::{BoundaryPoint, Complex64, CurvedOutline, Region};
use crate::stored::{Reader, Writer};
use crate::symm::curved_solution::CurvedSolution;
use crate::symm::curved_solve::{solve_curved, solve_curved_again};
use crate::symm::options::{Progress, SolveOptions};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The solution of a region with curved edges; nothing more is built.
#[derive(Debug)]
pub(super) struct SolvedEdges {
    /// Where `region` has its 0.
    origin: Complex64,
    region: Region,
    outline: Arc<CurvedOutline>,
    solution: CurvedSolution,
}

impl SolvedEdges {
    /// Solves Symm's equation for the edges that bound a region; `None` if it is bounded by something else.
    ///
    /// # Errors
    /// As [`solve_curved`].
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Option<Self>> {
        let (origin, region) = region.local();
        let Some(outline) = region.curved().cloned() else { return Ok(None) };
        let solution = solve_curved(&outline, region.center(), options, progress)?;
        Ok(Some(Self { origin, region, outline, solution }))
    }

    /// Reads what [`SolvedRegion::store`] wrote.
    ///
    /// # Errors
    /// As [`CurvedSolution::restore`].
    pub fn restore(region: &Region, from: &mut Reader) -> Result<Self> {
        let (origin, region) = region.local();
        let damaged = Error::Damaged { reason: "its boundary does not consist of edges" };
        let outline = region.curved().cloned().ok_or(damaged)?;
        let solution = CurvedSolution::restore(&outline, region.center(), from)?;
        Ok(Self { origin, region, outline, solution })
    }

    fn unit(&self) -> f64 {
        self.solution.unit()
    }

    /// The point of the outline at edge and parameter, in plane units.
    fn place(&self, (edge, t): (usize, f64)) -> BoundaryPoint {
        let place = self.outline.place(edge, t);
        BoundaryPoint { point: place.point + self.origin, ..place }
    }
}

impl SolvedRegion for SolvedEdges {
    fn evidence(&self) -> Evidence {
        let solution = &self.solution;
        Evidence {
            residual: solution.residual,
            error_estimate: solution.error_estimate,
            stop: solution.stop,
            unknowns: solution.masses.len(),
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
        let solution = solve_curved_again(&self.solution, region.center(), options, progress)?;
        Ok(Arc::new(Self { origin: self.origin, region, outline: Arc::clone(&self.outline), solution }))
    }

    fn vertex_measures(&self) -> Vec<f64> {
        self.solution.vertex_measures()
    }

    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        self.solution.measure_at(point.edge, point.t)
    }

    fn boundary_point(&self, measure: f64) -> BoundaryPoint {
        self.place(self.solution.locate(measure))
    }

    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.to_disk_with_slope(z).map(|(point, _)| point)
    }

    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        let z = z - self.origin;
        let (w, slope) = match self.region.on_boundary(z) {
            Some(place) => self.solution.on_circle(place.edge, place.t),
            None if self.region.contains(z) => self.solution.to_disk(z * self.unit())?,
            None => return None,
        };
        Some((DiskPoint::flat(onto_disk(w)), slope * self.unit()))
    }

    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64> {
        self.to_disk(z).map(|point| point.w)
    }

    fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.from_disk_with_slope(point).map(|(z, _)| z)
    }

    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        if is_outside_disk(point.w) {
            return None;
        }
        if is_on_circle(point.w) {
            let (edge, t) = self.solution.locate(point.w.arg() / TAU);
            let (_, slope) = self.solution.on_circle(edge, t);
            return Some((self.place((edge, t)).point, (slope * self.unit()).inv()));
        }
        let (z, slope) = self.solution.from_disk(point.w)?;
        Some((z / self.unit() + self.origin, (slope * self.unit()).inv()))
    }

    fn crowded(&self) -> Option<Complex64> {
        self.solution.crowded().map(|z| z / self.unit() + self.origin)
    }

    fn store(&self, to: &mut Writer) {
        self.solution.store(to);
    }
}
