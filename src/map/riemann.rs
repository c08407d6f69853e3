//! The Riemann map of a region, by Symm's method.

use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Region};
use crate::symm::correspondence::angle_of_measure;
use crate::symm::solve::{Progress, Solution, SolveOptions, Stop, move_center, solve};
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
    solution: Solution,
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
        Ok(Self::new(region.clone(), options, solve(region, options, progress)?))
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
            move_center(&self.solution, center, &self.options, progress)?
        };
        Ok(Self::new(region, &self.options, solution))
    }

    fn new(region: Region, options: &SolveOptions, solution: Solution) -> Self {
        let options = options.clone();
        let mut map = Self { region, options, solution, toward_measure: 0.0, angles: Vec::new() };
        map.toward_measure = map.measure_at(map.region.toward());
        let measures = map.solution.correspondence.vertex_measures();
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
        angle_of_measure(self.measure_at(point) - self.toward_measure)
    }

    /// Angle on the circle → boundary of the region; the inverse of [`RiemannMap::boundary_angle`].
    #[must_use]
    pub fn boundary_point(&self, angle: f64) -> BoundaryPoint {
        let discretisation = self.solution.discretisation();
        let (q, tau) = self.solution.correspondence.locate(discretisation, angle / TAU + self.toward_measure);
        let panel = &discretisation.panels[q];
        let share = panel.distance_at(tau) / discretisation.boundary.lengths[panel.edge];
        let t = if panel.outgoing { share } else { 1.0 - share };
        let (a, b) = self.region.polygon().edge(panel.edge);
        if t >= 1.0 {
            return BoundaryPoint { edge: discretisation.boundary.next(panel.edge), t: 0.0, point: b };
        }
        BoundaryPoint { edge: panel.edge, t, point: a + (b - a) * t }
    }

    /// Region → disk, by direct summation over the boundary: accurate to the solve, about 10 µs a point.
    /// NaN outside the closed region; boundary points go to the circle.
    #[must_use]
    pub fn to_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.point_to_disk(z)).collect()
    }

    /// |f'(center)|⁻¹, in plane units: exp ∫ log|y − z₀| dμ(y).
    #[must_use]
    pub fn conformal_radius(&self) -> f64 {
        let boundary = &self.solution.discretisation().boundary;
        self.solution.potential.at(self.solution.discretisation(), self.region.center() * boundary.unit).re.exp()
            / boundary.unit
    }

    /// Largest violation of the boundary condition log|f| = 0 at points where it was not imposed.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.solution.residual
    }

    /// Estimate of the largest error of the map anywhere in the region, in units of the disk.
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        self.solution.error_estimate
    }

    /// Number of unknowns of the last system solved.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.solution.masses.len()
    }

    /// Why the solve ended: with the tolerance met, or short of it.
    #[must_use]
    pub fn stop(&self) -> Stop {
        self.solution.stop
    }

    /// Measure from vertex 0 to a boundary point.
    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        let discretisation = self.solution.discretisation();
        let length = discretisation.boundary.lengths[point.edge];
        let (from_start, from_end) = (point.t * length, (1.0 - point.t) * length);
        let panels = self.solution.correspondence.panels_of_edge(point.edge);
        let last = panels.end - 1;
        for q in panels {
            let panel = &discretisation.panels[q];
            let s = if panel.outgoing { from_start } else { from_end };
            let within = if panel.outgoing { s <= panel.end } else { s >= panel.start };
            if within || q == last {
                return self.solution.correspondence.measure(discretisation, q, panel.tau_at(s));
            }
        }
        0.0
    }

    fn point_to_disk(&self, z: Complex64) -> Complex64 {
        if !self.region.contains(z) {
            return Complex64::new(f64::NAN, f64::NAN);
        }
        let discretisation = self.solution.discretisation();
        let unit = discretisation.boundary.unit;
        let nearest = self.region.polygon().nearest(z);
        if (nearest.point - z).norm() * unit < 4.0 * f64::EPSILON {
            return Complex64::cis(self.boundary_angle(nearest));
        }
        let turn = Complex64::cis(-TAU * self.toward_measure);
        if let Some(w) = self.beside_corner(z * unit, nearest) {
            return turn * w;
        }
        self.solution.potential.map(discretisation, self.solution.center, z * unit) * turn
    }

    /// f very near a corner, where the boundary correspondence continued analytically is more accurate than quadrature.
    fn beside_corner(&self, scaled: Complex64, nearest: BoundaryPoint) -> Option<Complex64> {
        let discretisation = self.solution.discretisation();
        let panels = self.solution.correspondence.panels_of_edge(nearest.edge);
        let q = if nearest.t <= 0.5 { panels.start } else { panels.end - 1 };
        let panel = &discretisation.panels[q];
        let local = discretisation.local_of(q, scaled);
        if local.norm() >= discretisation.rules[q].blind_radius() {
            return None;
        }
        // Measured from an edge that ends at the corner, the region lies clockwise; the branch cut lies outside either way.
        let tau = local.powf(1.0 / panel.exponent);
        let measure = self.solution.correspondence.complex_measure(discretisation, q, tau);
        Some((Complex64::i() * TAU * measure).exp())
    }
}
