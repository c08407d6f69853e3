//! Another center for a solved region, on the same panels.

use super::options::{Progress, SolveOptions, Stop};
use super::problem::Problem;
use super::solution::{ERROR_PER_RESIDUAL, Solution, estimate_of, finish};
use crate::Result;
use crate::plane::Complex64;
use std::f64::consts::TAU;

/// The linear system is solved to this share of the acceptable residual: less than for a first solve, since the guess is
/// already good where thin slots would need more.
const MOVE_SHARE: f64 = 0.1;
/// The same region for another `center` (plane units) on the panels that there are: nothing is assembled, factored or
/// refined, and the estimate says how well they serve.
///
/// # Errors
/// [`Error::Cancelled`](crate::Error::Cancelled), [`Error::NegativeMass`](crate::Error::NegativeMass).
pub fn move_center(
    previous: &Solution,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Solution> {
    let system = previous.system(progress)?;
    let center = center * system.discretisation.boundary.unit;
    let problem = Problem::measure(&system.discretisation.boundary, center);
    let mut outcome = system.check(&problem, moved_measure(previous, center));
    if estimate_of(system.discretisation.as_ref(), &outcome) > options.tolerance {
        let tolerance = MOVE_SHARE * options.tolerance / ERROR_PER_RESIDUAL;
        outcome = system.solve(&problem, tolerance, Some(outcome.masses), progress)?;
    }
    let error_estimate = estimate_of(system.discretisation.as_ref(), &outcome);
    let stop = if error_estimate <= options.tolerance { Stop::Tolerance } else { Stop::SamePanels };
    finish(system, center, outcome, error_estimate, stop)
}

/// Harmonic measure seen from `center`, as far as `previous` knows: Poisson's kernel times the measure seen from its own
/// center, dμ₁ = (1 − |w|²)/|e^{iθ} − w|² dμ₀ with w = f₀(center).
pub(super) fn moved_measure(previous: &Solution, center: Complex64) -> Vec<f64> {
    let discretisation = previous.discretisation();
    let w = previous.potential.map(discretisation, previous.center, center);
    let nodes = &discretisation.order.panel.nodes;
    let mut moved = Vec::with_capacity(previous.masses.len());
    for (i, mass) in previous.masses.iter().enumerate() {
        let (q, node) = (i / nodes.len(), i % nodes.len());
        let theta = TAU * previous.correspondence.measure(q, 0.5 * (nodes[node] + 1.0));
        moved.push(mass * (1.0 - w.norm_sqr()) / (Complex64::cis(theta) - w).norm_sqr());
    }
    let total: f64 = moved.iter().sum();
    if !total.is_normal() || total < 0.0 {
        // So far away that `previous` knows nothing there.
        return vec![1.0 / moved.len() as f64; moved.len()];
    }
    moved.iter_mut().for_each(|mass| *mass /= total);
    moved
}
