//! The Riemann map of a region, by Symm's method.

use super::solved::Solved;
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Region};
use crate::symm::correspondence::angle_of_measure;
use crate::symm::solve::{Progress, SolveOptions, Stop};
use std::f64::consts::TAU;

/// The conformal map region → unit disk with `center` ↦ 0 and `toward` ↦ 1.
///
/// f(z) = e^{iφ} (z − z₀) exp(−∫ log(z − y) dμ(y)), μ the harmonic measure seen from z₀ = `center`, which solves
/// ∫ log|x − y| dμ(y) + c = log|x − z₀| on the boundary (Frederick & Schwartz 1988, appendix 2, with g = −∫ log|z − y| dμ).
///
/// ```
/// use conformal_warp::map::{RiemannMap, SolveOptions};
/// use conformal_warp::plane::{Complex64, Curve, Region};
/// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let region = Region::new(&square, Curve::Polygon, Complex64::new(0.0, 0.0), square[0])?;
/// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((map.conformal_radius() - 1.0787052023767587).abs() < map.error_estimate());
/// assert!((map.angles()[1] - std::f64::consts::FRAC_PI_2).abs() < map.error_estimate());
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RiemannMap {
    region: Region,
    options: SolveOptions,
    solution: Solved,
    /// Measure from vertex 0 to `toward`.
    toward_measure: f64,
    angles: Vec<f64>,
}

impl RiemannMap {
    /// Solves for the map of `region`. `progress` hears the stage and the fraction done, and cancels by returning false.
    ///
    /// # Errors
    /// [`Error::InvalidOption`](crate::Error::InvalidOption), [`Error::Cancelled`](crate::Error::Cancelled), and
    /// [`Error::NegativeMass`](crate::Error::NegativeMass) if no trustworthy map was found.
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Self> {
        Ok(Self::new(region.clone(), options, Solved::new(region, options, progress)?))
    }

    /// The map of the same region for another center and direction, from what was solved before: nothing is assembled or
    /// factored, and moving only `toward` is a rotation. [`RiemannMap::error_estimate`] says how well the old panels serve
    /// the new center; a center much nearer to the boundary deserves a solve of its own.
    ///
    /// # Errors
    /// As [`RiemannMap::solve`] and [`Region::new`].
    pub fn with_center(&self, center: Complex64, toward: Complex64, progress: Progress) -> Result<Self> {
        let region = self.region.with_center(center, toward)?;
        let solution = if center == self.region.center() {
            self.solution.clone()
        } else {
            self.solution.with_center(center, &self.options, progress)?
        };
        Ok(Self::new(region, &self.options, solution))
    }

    fn new(region: Region, options: &SolveOptions, solution: Solved) -> Self {
        let options = options.clone();
        let mut map = Self { region, options, solution, toward_measure: 0.0, angles: Vec::new() };
        map.toward_measure = map.solution.measure_at(map.region.toward());
        let measures = map.solution.vertex_measures();
        map.angles = measures.iter().map(|measure| angle_of_measure(measure - map.toward_measure)).collect();
        map
    }

    /// The region it maps.
    #[must_use]
    pub fn region(&self) -> &Region {
        &self.region
    }

    /// Angle of each boundary vertex on the circle, in [0, 2π); `toward` is at 0.
    #[must_use]
    pub fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// Boundary of the region → angle on the circle, in [0, 2π).
    #[must_use]
    pub fn boundary_angle(&self, point: BoundaryPoint) -> f64 {
        angle_of_measure(self.solution.measure_at(point) - self.toward_measure)
    }

    /// Angle on the circle → boundary of the region; the inverse of [`RiemannMap::boundary_angle`].
    #[must_use]
    pub fn boundary_point(&self, angle: f64) -> BoundaryPoint {
        self.solution.boundary_point(&self.region, angle / TAU + self.toward_measure)
    }

    /// Region → disk, by direct summation over the boundary: accurate to the solve, about 10 µs a point.
    /// NaN outside the closed region; boundary points go to the circle.
    #[must_use]
    pub fn to_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        let turn = Complex64::cis(-TAU * self.toward_measure);
        let undefined = Complex64::new(f64::NAN, f64::NAN);
        let image = |&z: &Complex64| {
            if self.region.contains(z) { self.solution.to_disk(&self.region, z) * turn } else { undefined }
        };
        points.iter().map(image).collect()
    }

    /// |f'(center)|⁻¹, in plane units: exp ∫ log|y − z₀| dμ(y).
    #[must_use]
    pub fn conformal_radius(&self) -> f64 {
        self.solution.conformal_radius()
    }

    /// Largest violation of the boundary condition log|f| = 0 at points where it was not imposed.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.solution.residual()
    }

    /// Estimate of the largest error of the map anywhere in the region, in units of the disk.
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        self.solution.error_estimate()
    }

    /// Number of unknowns of the last system solved.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.solution.unknowns()
    }

    /// Why the solve ended: with the tolerance met, or short of it.
    #[must_use]
    pub fn stop(&self) -> Stop {
        self.solution.stop()
    }
}
