//! A solved polygon: Symm's equation on panels, evaluated through the atlas.

use super::atlas::{DiskPoint, Expansions, Position};
use super::rounding::ON_BOUNDARY;
use super::solved_region::SolvedRegion;
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Region};
use crate::symm::center::move_center;
use crate::symm::options::{Progress, SolveOptions, Stop};
use crate::symm::solution::Solution;
use crate::symm::solve::solve;
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// A polygon's solution, and the expansions that are built when many points are asked for.
#[derive(Debug)]
pub(super) struct SolvedPolygon {
    region: Region,
    solution: Solution,
    options: SolveOptions,
    /// In scaled units.
    expansions: OnceLock<Expansions>,
}

impl SolvedPolygon {
    /// Solves Symm's equation for a polygon.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Self> {
        Ok(Self::new(region, solve(region, options, progress)?, options))
    }

    fn new(region: &Region, solution: Solution, options: &SolveOptions) -> Self {
        Self { region: region.clone(), solution, options: options.clone(), expansions: OnceLock::new() }
    }

    /// Plane units × unit = scaled units.
    fn unit(&self) -> f64 {
        self.solution.discretisation().boundary.unit
    }

    #[inline]
    fn expansions(&self) -> &Expansions {
        self.expansions.get_or_init(|| Expansions::new(&self.solution, &self.options))
    }
}

impl SolvedRegion for SolvedPolygon {
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
        self.solution.masses.len()
    }

    fn conformal_radius(&self) -> f64 {
        let solution = &self.solution;
        solution.potential.at(solution.discretisation(), solution.center).re.exp() / self.unit()
    }

    fn with_center(
        &self,
        center: Complex64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Arc<dyn SolvedRegion>> {
        let solution = move_center(&self.solution, center, options, progress)?;
        Ok(Arc::new(Self::new(&self.region, solution, options)))
    }

    fn vertex_measures(&self) -> Vec<f64> {
        self.solution.correspondence.vertex_measures()
    }

    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        self.solution.measure_at(point)
    }

    fn boundary_point(&self, measure: f64) -> BoundaryPoint {
        let (edge, t) = self.solution.locate(measure);
        let polygon = self.region.polygon();
        let (a, b) = polygon.edge(edge);
        if t < 1.0 {
            BoundaryPoint { edge, t, point: a + (b - a) * t }
        } else {
            BoundaryPoint { edge: (edge + 1) % polygon.len(), t: 0.0, point: b }
        }
    }

    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.expansions().to_disk(z * self.unit())
    }

    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        let (point, slope) = self.expansions().to_disk_with_slope(z * self.unit())?;
        Some((point, slope * self.unit()))
    }

    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64> {
        if !self.region.contains(z) {
            return None;
        }
        let nearest = self.region.nearest(z);
        if (nearest.point - z).norm() < ON_BOUNDARY * self.region.polygon().size() {
            return Some(Complex64::cis(TAU * self.measure_at(nearest)));
        }
        Some(self.solution.to_disk(nearest, z))
    }

    fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.expansions().from_disk(point).map(|z| z / self.unit())
    }

    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        let (z, slope) = self.expansions().from_disk_with_slope(point)?;
        Some((z / self.unit(), slope / self.unit()))
    }

    fn flat(&self, point: DiskPoint) -> Complex64 {
        self.expansions().flat(point)
    }

    fn flat_slope(&self, point: DiskPoint) -> Complex64 {
        self.expansions().flat_slope(point)
    }

    fn positions(&self) -> &[Position] {
        self.expansions().positions()
    }

    fn prepare(&self) {
        self.expansions().prepare();
    }

    fn bytes(&self) -> usize {
        self.expansions.get().map_or(0, Expansions::bytes)
    }
}
