//! A solved equation: masses, θ on the boundary, the map inside, and how good they are.
//!
//! Log f_h/f, the logarithm of the computed map over the exact one, is analytic in the region, and on the boundary its real
//! part is c minus the equation's residual r. By the maximum principle |r| bounds the error of log|f|, and its conjugate
//! function the error of arg f: the residual at points that were not collocated is an error estimate, up to a modest factor.
//! θ on the boundary is read from the masses, which feel the residual outside the region as well: see
//! [`super::thin_walls`].

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::options::{Progress, Stop};
use super::panelled::Panelled;
use super::potential::LogPotential;
use super::system::{System, SystemSolution};
use crate::plane::{BoundaryPoint, Complex64};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// The map's error was measured at 1 to 8 times the residual.
pub(super) const ERROR_PER_RESIDUAL: f64 = 10.0;
/// Rounding alone makes errors of this size in the map.
const ROUNDING: f64 = 1e-14;
/// A larger system, in bytes, is not kept for another center: what far ends need is to have room beside it. Ten thousand vertices at
/// 1e-3 have less.
const MOST_KEPT: usize = 400 << 20;

/// A solved equation, with its evidence.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The panels it lives on.
    discretisation: Arc<Discretisation>,
    /// Ready for another center; of a stored solution and of a very large one, assembled when first asked for.
    system: OnceLock<Arc<System>>,
    /// The center, in the scaled units of the boundary.
    pub center: Complex64,
    /// Mass of harmonic measure at each node.
    pub masses: Vec<f64>,
    /// θ along the boundary.
    pub correspondence: BoundaryCorrespondence,
    /// log f inside, by direct summation.
    pub potential: LogPotential,
    /// Largest violation of the equation at points that were not collocated, or |c| if that is larger.
    pub residual: f64,
    /// Estimate of the largest error of the map.
    pub error_estimate: f64,
    /// Why the solve ended.
    pub stop: Stop,
}

impl Solution {
    /// A solution whose system is not assembled.
    pub(super) fn new(
        discretisation: Arc<Discretisation>,
        center: Complex64,
        masses: Vec<f64>,
        residual: f64,
        error_estimate: f64,
        stop: Stop,
    ) -> Self {
        let correspondence = BoundaryCorrespondence::new(&discretisation, &masses);
        let potential = LogPotential::new(&masses);
        let system = OnceLock::new();
        Self { discretisation, system, center, masses, correspondence, potential, residual, error_estimate, stop }
    }

    /// The panels it lives on.
    #[must_use]
    pub fn discretisation(&self) -> &Discretisation {
        &self.discretisation
    }

    /// The system, ready for another center.
    ///
    /// # Errors
    /// [`Error::Cancelled`], if it must be assembled.
    pub fn system(&self, progress: Progress) -> Result<Arc<System>> {
        System::kept_in(&self.system, &self.discretisation, progress)
    }

    /// Measure from vertex 0 to a boundary point.
    #[must_use]
    pub fn measure_at(&self, point: BoundaryPoint) -> f64 {
        let discretisation = self.discretisation();
        let length = discretisation.boundary.lengths[point.edge];
        let (from_start, from_end) = (point.t * length, (1.0 - point.t) * length);
        self.correspondence.measure_on_edge(discretisation, point.edge, from_start, from_end)
    }

    /// Measure from vertex 0 → the edge and the share of it where that is reached.
    #[must_use]
    pub fn locate(&self, measure: f64) -> (usize, f64) {
        self.correspondence.locate_on_edge(self.discretisation(), measure)
    }

    /// Region → disk (vertex 0 ↦ 1) for a point inside, given the boundary point nearest to it (both in plane units).
    #[must_use]
    pub fn to_disk(&self, nearest: BoundaryPoint, z: Complex64) -> Complex64 {
        let scaled = z * self.discretisation().boundary.unit;
        self.beside_corner(nearest, scaled)
            .unwrap_or_else(|| self.potential.map(self.discretisation(), self.center, scaled))
    }

    /// f very near a corner, where the boundary correspondence continued analytically is more accurate than quadrature.
    fn beside_corner(&self, nearest: BoundaryPoint, scaled: Complex64) -> Option<Complex64> {
        let discretisation = self.discretisation();
        let panels = self.correspondence.panels_of_edge(nearest.edge);
        let q = if nearest.t <= 0.5 { panels.start } else { panels.end - 1 };
        let panel = &discretisation.panels[q];
        let local = discretisation.local_of(q, scaled);
        if local.norm() >= discretisation.rules[q].blind_radius() {
            return None;
        }
        // Measured from an edge that ends at the corner, the region lies clockwise; the branch cut lies outside either way.
        let tau = local.powf(1.0 / panel.exponent);
        let measure = self.correspondence.complex_measure(q, tau);
        Some((Complex64::i() * TAU * measure).exp())
    }
}

/// What the residuals say of the map's error, apart from rounding in the system.
pub(super) fn estimate_of(discretisation: &dyn Panelled, outcome: &SystemSolution) -> f64 {
    ERROR_PER_RESIDUAL * outcome.residual() + discretisation.walls().error(&outcome.residuals) + ROUNDING
}

/// A solution with its evidence, unless its masses show that it is none.
pub(super) fn finish(
    system: Arc<System>,
    center: Complex64,
    outcome: SystemSolution,
    error_estimate: f64,
    stop: Stop,
) -> Result<Solution> {
    let residual = outcome.residual();
    let discretisation = Arc::clone(&system.discretisation);
    let solution = Solution::new(discretisation, center, outcome.masses, residual, error_estimate, stop);
    let (mass, q) = solution.correspondence.smallest_mass();
    if mass < -error_estimate || !(mass + residual).is_finite() {
        let worst = outcome.residuals.iter().position(|r| !r.is_finite()).unwrap_or(q);
        let edge = system.discretisation.panels[worst].edge;
        return Err(Error::NegativeMass { mass, estimate: error_estimate, edge });
    }
    // What is not kept is assembled again for another center.
    Ok(if system.bytes() > MOST_KEPT { solution } else { Solution { system: OnceLock::from(system), ..solution } })
}
