//! A solved polygon: Symm's equation on panels, evaluated through the atlas.

use super::atlas::{DiskPoint, Expansions, Found, Position};
use super::rounding::onto_disk;
use super::solved_region::{Evidence, SolvedRegion};
use crate::plane::{BoundaryPoint, Complex64, NOWHERE, Region};
use crate::stored::{Reader, Writer};
use crate::symm::center::move_center;
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::solution::Solution;
use crate::symm::solve::{solve, solve_again};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// Maps with estimates above this are none.
const WORST_ESTIMATE: f64 = 1.0;
/// What is beside the boundary is this near to it, in units of the region's size.
const BESIDE: f64 = 1e-14;

/// A polygon's solution, and the expansions that are built when many points are asked for.
#[derive(Debug)]
pub(super) struct SolvedPolygon {
    /// Where `region` has its 0.
    origin: Complex64,
    region: Region,
    solution: Solution,
    options: SolveOptions,
    /// The map both ways, in scaled units.
    expansions: OnceLock<Expansions>,
}

impl SolvedPolygon {
    /// Solves Symm's equation for a polygon.
    ///
    /// # Errors
    /// As [`solve`], and [`Error::Inaccurate`].
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let (origin, region) = region.local();
        let solution = solve(&region, options, progress)?;
        Self::new(origin, region, solution, options)
    }

    /// Reads what [`SolvedRegion::store`] wrote.
    ///
    /// # Errors
    /// [`Error::Damaged`], [`Error::Inaccurate`].
    pub fn restore(region: &Region, options: &SolveOptions, from: &mut Reader) -> Result<Self> {
        let (origin, region) = region.local();
        let solution = Solution::restore(&region, from)?;
        Self::new(origin, region, solution, options)
    }

    fn new(origin: Complex64, region: Region, solution: Solution, options: &SolveOptions) -> Result<Self> {
        let estimate = solution.error_estimate;
        if estimate.is_nan() || estimate > WORST_ESTIMATE {
            return Err(Error::Inaccurate { estimate });
        }
        Ok(Self { origin, region, solution, options: options.clone(), expansions: OnceLock::new() })
    }

    /// Plane units × unit = scaled units.
    fn unit(&self) -> f64 {
        self.solution.discretisation().boundary.unit
    }

    /// How near to its boundary points are on it, in scaled units.
    fn thickness(&self) -> f64 {
        self.region.contour().thickness() * self.unit()
    }

    #[inline]
    fn expansions(&self) -> &Expansions {
        self.expansions.get_or_init(|| Expansions::new(&self.solution, self.thickness(), &self.options))
    }

    /// Plane units → scaled units.
    #[inline]
    fn scaled(&self, z: Complex64) -> Complex64 {
        (z - self.origin) * self.unit()
    }

    /// Scaled units → plane units.
    #[inline]
    fn plane(&self, z: Complex64) -> Complex64 {
        z / self.unit() + self.origin
    }

    /// The derivative (scaled units) a little inside of a point of the boundary.
    #[cold]
    fn slope_beside(&self, z: Complex64) -> Complex64 {
        let polygon = self.region.polygon();
        let place = polygon.nearest(z - self.origin);
        let (a, b) = polygon.edge(place.edge);
        let inwards = Complex64::i() * (b - a) / (b - a).norm();
        let beside = place.point + inwards * (BESIDE * polygon.size());
        let found = self.expansions().to_disk_with_slope(beside * self.unit());
        found.image().map_or(NOWHERE, |(_, slope)| slope)
    }

    /// The image of a point beside what expansions know: on the circle, if rounding put it there.
    #[cold]
    fn on_circle(&self, z: Complex64) -> Option<DiskPoint> {
        let place = self.region.on_boundary(z - self.origin)?;
        let known = self.expansions().to_disk(place.point * self.unit()).image();
        let point = known.unwrap_or_else(|| DiskPoint::flat(Complex64::cis(TAU * self.measure_at(place))));
        Some(point.onto_circle())
    }
}

impl SolvedRegion for SolvedPolygon {
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
        let solution = &self.solution;
        solution.potential.at(solution.discretisation(), solution.center).re.exp() / self.unit()
    }

    fn with_center(
        &self,
        center: Complex64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Arc<dyn SolvedRegion>> {
        let center = center - self.origin;
        let solution = match move_center(&self.solution, center, options, progress) {
            Ok(moved) if moved.error_estimate <= options.tolerance => moved,
            Err(Error::Cancelled) => return Err(Error::Cancelled),
            // The panels are too coarse for this center.
            moved => match (moved, solve_again(&self.solution, center, options, progress)) {
                (Ok(moved), Ok(again)) if moved.error_estimate < again.error_estimate => moved,
                (_, again) => again?,
            },
        };
        let region = self.region.with_center(center, self.region.toward().point)?;
        Ok(Arc::new(Self::new(self.origin, region, solution, options)?))
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
            BoundaryPoint { edge, t, point: a + (b - a) * t + self.origin }
        } else {
            BoundaryPoint { edge: (edge + 1) % polygon.len(), t: 0.0, point: b + self.origin }
        }
    }

    #[inline]
    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        match self.expansions().to_disk(self.scaled(z)) {
            Found::Beside => self.on_circle(z),
            found => found.image(),
        }
    }

    #[inline]
    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        let (point, slope) = match self.expansions().to_disk_with_slope(self.scaled(z)) {
            Found::Beside => (self.on_circle(z)?, self.slope_beside(z)),
            found => found.image()?,
        };
        Some((point, slope * self.unit()))
    }

    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64> {
        let z = z - self.origin;
        if let Some(place) = self.region.on_boundary(z) {
            return Some(onto_disk(Complex64::cis(TAU * self.measure_at(place))));
        }
        self.region.contains(z).then(|| onto_disk(self.solution.to_disk(self.region.nearest(z), z)))
    }

    fn images(&self, points: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let (expansions, origin, unit) = (self.expansions(), self.origin, self.unit());
        let image = |&z: &Complex64| match expansions.to_disk_by_cell((z - origin) * unit) {
            Some(w) => onto_disk(turn * w),
            None => self.to_disk(z).map_or(NOWHERE, |point| onto_disk(turn * self.flat(point))),
        };
        points.iter().map(image).collect()
    }

    fn slopes(&self, points: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let (expansions, origin, unit) = (self.expansions(), self.origin, self.unit());
        let in_plane = turn * unit;
        let slope = |&z: &Complex64| match expansions.slope_by_cell((z - origin) * unit) {
            Some(slope) => in_plane * slope,
            None => {
                let slope = |(point, slope): (DiskPoint, Complex64)| turn * slope * self.flat_slope(point);
                self.to_disk_with_slope(z).map_or(NOWHERE, slope)
            }
        };
        points.iter().map(slope).collect()
    }

    fn places(&self, images: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let (expansions, origin, back) = (self.expansions(), self.origin, turn.conj());
        // The unit is a power of two.
        let size = self.unit().recip();
        let place = |w: &Complex64| match expansions.from_disk_by_cell(back * w) {
            Some(z) => z * size + origin,
            None => self.from_disk(DiskPoint::flat(back * w)).unwrap_or(NOWHERE),
        };
        images.iter().map(place).collect()
    }

    #[inline]
    fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.expansions().from_disk(point).map(|z| self.plane(z))
    }

    #[inline]
    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        let (z, slope) = self.expansions().from_disk_with_slope(point)?;
        Some((self.plane(z), slope / self.unit()))
    }

    fn beside(&self, vertex: usize, z: Complex64) -> Option<(usize, Complex64)> {
        self.expansions().beside(vertex, self.scaled(z))
    }

    fn from_beside(&self, vertex: usize, chart: usize, angle: Complex64) -> Option<(Complex64, Complex64)> {
        let there = self.region.polygon().vertices()[vertex] * self.unit();
        let (z, slope) = self.expansions().from_beside((vertex, there), chart, angle)?;
        Some((self.plane(z), slope / self.unit()))
    }

    #[inline]
    fn flat(&self, point: DiskPoint) -> Complex64 {
        self.expansions().flat(point)
    }

    #[inline]
    fn flat_slope(&self, point: DiskPoint) -> Complex64 {
        self.expansions().flat_slope(point)
    }

    fn crowded(&self) -> Option<Complex64> {
        self.expansions().crowded().map(|z| self.plane(z))
    }

    fn positions(&self) -> &[Position] {
        self.expansions().positions()
    }

    fn positions_from(&self, first: Position) -> Vec<Position> {
        self.expansions().positions_from(first)
    }

    fn prepare(&self, progress: Progress) -> Result<()> {
        if self.expansions.get().is_none() {
            let built = Expansions::reporting(&self.solution, self.thickness(), &self.options, progress)?;
            // If another thread was first, its are the same.
            let _ = self.expansions.set(built);
        }
        self.expansions().prepare(progress)
    }

    fn store(&self, to: &mut Writer) {
        self.solution.store(to);
    }

    fn bytes(&self) -> usize {
        self.expansions.get().map_or(0, Expansions::bytes)
    }
}
