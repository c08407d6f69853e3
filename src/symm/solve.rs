//! Symm's equation solved to a tolerance: panels are halved where the equation does not hold yet.

use super::center::moved_measure;
use super::discretisation::Discretisation;
use super::options::{Progress, SolveOptions, Stop};
use super::order::Order;
use super::panel::{Boundary, Panel, initial_panels};
use super::rule::Rules;
use super::solution::{ERROR_PER_RESIDUAL, estimate_of, finish};
use super::system::System;
use crate::plane::{Complex64, Region};
use crate::{Error, Result};
use std::sync::Arc;

pub use super::solution::Solution;

/// Rounding alone makes errors of this size in the equations.
const NOISE: f64 = 1e-15;
/// Estimates below this are checked against amplified rounding.
const CHECK_ROUNDING_BELOW: f64 = 1e-9;
/// Panels whose own residual is above this share of the acceptable one are halved.
const REFINE_SHARE: f64 = 0.3;
/// The linear systems are solved to this share of it: between the walls of a thin slot the potential hardly sees
/// opposite masses, so what the iteration leaves there weighs a thousand times more in the map.
const ITERATION_SHARE: f64 = 1e-3;
/// Below this, a residual that refining did not halve is taken for rounding.
const STAGNATION_BELOW: f64 = 1e-10;
/// Corner panels reach this far, measured in the clearance of their corner.
const KAPPA: f64 = 1.0;

/// Solves Symm's equation for `region`, refining until the error estimate meets the tolerance.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`], and [`Error::NegativeMass`] if the discretisation failed.
pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Solution> {
    options.validate()?;
    let boundary = Arc::new(Boundary::new(region.polygon()));
    let center = region.center() * boundary.unit;
    let panels = initial_panels(&boundary, KAPPA);
    let mut rules = Rules::new(order_for(options, panels.len())?);
    let discretisation = Discretisation::new(boundary, panels, &mut rules);
    let system = Arc::new(System::new(discretisation, progress)?);
    adapt(system, rules, center, None, options, progress)
}

/// The same region for another `center` (plane units), refining the panels where they are too coarse for it.
/// `options` should be those of the first solve.
///
/// # Errors
/// As [`solve`].
pub fn solve_again(
    previous: &Solution,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Solution> {
    let discretisation = previous.discretisation();
    let center = center * discretisation.boundary.unit;
    let rules = Rules::new(discretisation.order.clone());
    adapt(Arc::clone(&previous.system), rules, center, Some(moved_measure(previous, center)), options, progress)
}

/// Solves, and halves panels and solves again until the estimate meets the tolerance.
fn adapt(
    mut system: Arc<System>,
    mut rules: Rules,
    center: Complex64,
    mut guess: Option<Vec<f64>>,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Solution> {
    let acceptable = options.tolerance / ERROR_PER_RESIDUAL;
    let mut previous_residual = f64::INFINITY;
    loop {
        let outcome = system.solve(center, ITERATION_SHARE * acceptable, guess.take(), progress)?;
        let residual = outcome.residual();
        let from_residual = estimate_of(&outcome);
        let from_noise =
            if from_residual < CHECK_ROUNDING_BELOW { NOISE * system.noise_amplification(progress)? } else { 0.0 };
        let error_estimate = from_residual + from_noise;
        let discretisation = &system.discretisation;
        let panels = refine(&discretisation.panels, &outcome.residuals, REFINE_SHARE * acceptable);
        let at_rounding =
            residual > 0.5 * previous_residual && residual < STAGNATION_BELOW || from_noise > from_residual;
        let stop = if error_estimate <= options.tolerance {
            Some(Stop::Tolerance)
        } else if at_rounding || panels.len() == discretisation.panels.len() {
            Some(Stop::Stagnation)
        } else if panels.len() * rules.order.p() > options.max_unknowns {
            Some(Stop::MaxUnknowns)
        } else {
            None
        };
        if let Some(stop) = stop {
            return finish(system, center, outcome, error_estimate, stop);
        }
        previous_residual = residual;
        let refined = Discretisation::new(Arc::clone(&discretisation.boundary), panels, &mut rules);
        system = Arc::new(System::new(refined, progress)?);
    }
}

/// Unknowns a panel and digits of quadrature that reach a tolerance with the least work (measured), or as many unknowns as
/// are allowed.
fn order_for(options: &SolveOptions, panels: usize) -> Result<Order> {
    let digits = -options.tolerance.log10();
    let best = match digits {
        d if d < 3.5 && panels > 2000 => 2,
        d if d < 3.5 => 3,
        d if d < 4.5 => 4,
        d if d < 6.5 => 6,
        d if d < 9.5 => 8,
        d if d < 11.5 => 12,
        _ => 16,
    };
    let p = best.min(options.max_unknowns / panels);
    if p < 2 {
        return Err(Error::InvalidOption {
            name: "max_unknowns",
            expected: "at least two for each panel, of which a vertex needs two or more",
            value: options.max_unknowns as f64,
        });
    }
    Ok(Order::new(p, (digits + 3.0).min(15.5)))
}

fn refine(panels: &[Panel], residuals: &[f64], acceptable: f64) -> Vec<Panel> {
    panels
        .iter()
        .zip(residuals)
        .flat_map(|(panel, residual)| if *residual > acceptable { panel.halves().to_vec() } else { vec![*panel] })
        .collect()
}
