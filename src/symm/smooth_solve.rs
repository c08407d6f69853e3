//! Problems of several smooth curves, solved to a tolerance: nodes are doubled on the curves that need it.

use super::options::{Progress, SolveOptions, Stop};
use super::problem::Problem;
use super::smooth_field::boundary_values;
use super::smooth_system::{LEAST_NODES, MOST_NODES, ROUNDING_PER_NODE, SmoothOutcome, SmoothSystem};
use super::solution::ERROR_PER_RESIDUAL;
use crate::plane::SmoothCurve;
use crate::{Error, Result};
use std::sync::Arc;

/// Problems solved together, on nodes dense enough for all of them.
#[derive(Debug)]
pub struct SmoothAdapted {
    /// The system of the last round.
    pub system: Arc<SmoothSystem>,
    /// What was solved for.
    pub problems: Vec<Problem>,
    /// The solution of each.
    pub outcomes: Vec<SmoothOutcome>,
    /// Largest violation of any equation halfway between nodes.
    pub residual: f64,
    /// Estimate of the largest error of any.
    pub error_estimate: f64,
    /// Why the solve ended.
    pub stop: Stop,
}

/// Curves whose residual is above this share of the largest get more nodes.
const SHARE: f64 = 0.03;
/// What is left of a residual when doubling the nodes no longer helps.
const STAGNATION: f64 = 0.5;
/// That residual is taken for rounding below this.
const STAGNATION_BELOW: f64 = 1e-10;

/// Solves problems, stated for a unit (plane units × unit = units used), until the estimate meets the tolerance for each.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`], [`Error::TooFewPoints`] if the curves' points leave them open.
pub fn solve_smooth_problems(
    curves: Vec<Arc<SmoothCurve>>,
    problems: &dyn Fn(f64) -> Vec<Problem>,
    options: &SolveOptions,
    progress: Progress,
) -> Result<SmoothAdapted> {
    options.validate()?;
    let most = options.max_unknowns.min(MOST_NODES);
    let mut counts: Vec<usize> = curves.iter().map(|curve| (2 * curve.waves() + 2).max(LEAST_NODES)).collect();
    let mut previous = f64::INFINITY;
    loop {
        let system = Arc::new(SmoothSystem::new(curves.clone(), &counts, progress)?);
        let problems = problems(system.unit);
        let outcomes: Vec<SmoothOutcome> = problems
            .iter()
            .map(|problem| {
                let (nodes, checks) = boundary_values(&system, problem);
                system.solve(nodes, &checks, &problem.charges)
            })
            .collect();
        let worse = |worst: f64, r: f64| if r > worst || r.is_nan() { r } else { worst };
        let residuals: Vec<f64> = (0..curves.len())
            .map(|curve| outcomes.iter().map(|outcome| outcome.residuals[curve]).fold(0.0, worse))
            .collect();
        let residual = residuals.iter().copied().fold(0.0, worse);
        let curve_error = outcomes.iter().map(|outcome| system.curve_error(&outcome.masses)).fold(0.0, worse);
        let from_nodes = ERROR_PER_RESIDUAL * residual + ROUNDING_PER_NODE * system.len() as f64;
        let error_estimate = from_nodes + curve_error;
        let doubled: Vec<usize> = counts
            .iter()
            .zip(&residuals)
            .map(|(count, r)| if *r <= SHARE * residual { *count } else { 2 * count })
            .collect();
        let stop = if error_estimate <= options.tolerance {
            Stop::Tolerance
        } else if from_nodes <= options.tolerance {
            Stop::TooFewPoints
        } else if residual > STAGNATION * previous && residual < STAGNATION_BELOW {
            Stop::Stagnation
        } else if doubled.iter().sum::<usize>() > most || residual.is_nan() {
            Stop::MaxUnknowns
        } else {
            previous = residual;
            counts = doubled;
            continue;
        };
        if error_estimate > 1.0 && curve_error > 0.5 * error_estimate {
            let open = curves.iter().max_by(|a, b| a.uncertainty().total_cmp(&b.uncertainty()));
            if let Some(curve) = open {
                let needed = curve.points_for(curve.uncertainty() * 1e-3 / curve_error);
                return Err(Error::TooFewPoints { given: curve.points().len(), needed });
            }
        }
        return Ok(SmoothAdapted { system, problems, outcomes, residual, error_estimate, stop });
    }
}
