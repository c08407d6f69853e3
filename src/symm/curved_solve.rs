//! Symm's equation on a boundary of analytic edges, solved to a tolerance.

use super::curved_boundary::{CurvedBoundary, ROUND_DIGITS};
use super::curved_discretisation::CurvedDiscretisation;
use super::curved_solution::CurvedSolution;
use super::options::{Progress, SolveOptions};
use super::order::Order;
use super::panel::Panel;
use super::problem::{Problem, Source};
use super::rule::Rules;
use super::solve::{Adapted, Effort, adapt};
use super::system::System;
use crate::plane::{Complex64, CurvedOutline};
use crate::{Error, Result};
use std::sync::Arc;

/// More unknowns make every evaluation wait.
const MOST_UNKNOWNS: usize = 20_000;
/// More digits of quadrature drown in rounding.
const MOST_DIGITS: f64 = 15.5;

/// Solves for `center` (plane units), halving panels until the estimate meets the tolerance.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`]; [`Error::InvalidOutline`] for an edge of which all control points but one
/// are one; [`Error::NegativeMass`] or [`Error::Inaccurate`] if even the most unknowns
/// allowed do not resolve the boundary.
pub fn solve_curved(
    outline: &CurvedOutline,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<CurvedSolution> {
    let options = within_limits(options)?;
    let digits = (ROUND_DIGITS - options.tolerance.log10()).min(MOST_DIGITS);
    let boundary = Arc::new(CurvedBoundary::new(outline, digits));
    if let Some(edge) = boundary.halted() {
        let reason = format!("edge {edge} stands still at an end: all but one of its control points are one there");
        return Err(Error::InvalidOutline { reason });
    }
    let center = center * boundary.unit;
    let panels = boundary.initial_panels(center);
    let rules = Rules::new(Order::new(degree_for(&options, panels.len())?, digits));
    solve_on(&boundary, panels, rules, center, &options, progress)
}

/// The same boundary for another `center` (plane units), refining the panels where they are too coarse for it.
/// `options` should be those of the first solve.
///
/// # Errors
/// As [`solve_curved`].
pub fn solve_curved_again(
    previous: &CurvedSolution,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<CurvedSolution> {
    let options = within_limits(options)?;
    let discretisation = previous.discretisation();
    let center = center * discretisation.boundary.unit;
    let panels: Vec<Panel> = discretisation.panels.iter().map(|curved| curved.panel).collect();
    let rules = Rules::new(discretisation.order.clone());
    let facing = discretisation.boundary.facing(panels, center);
    if facing.len() > discretisation.panels.len() {
        return solve_on(&discretisation.boundary, facing, rules, center, &options, progress);
    }
    seen_from(center, previous.system(progress)?, rules, &options, progress)
}

fn solve_on(
    boundary: &Arc<CurvedBoundary>,
    panels: Vec<Panel>,
    mut rules: Rules,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<CurvedSolution> {
    let discretisation = CurvedDiscretisation::seeing(boundary, panels, &mut rules, progress)?;
    seen_from(center, Arc::new(System::new(discretisation, progress)?), rules, options, progress)
}

fn seen_from(
    center: Complex64,
    system: Arc<System<CurvedDiscretisation>>,
    rules: Rules,
    options: &SolveOptions,
    progress: Progress,
) -> Result<CurvedSolution> {
    let problem = Problem { source: Source::Log(center), charges: vec![1.0] };
    let Adapted { system, mut outcomes, error_estimate, stop, .. } =
        adapt(system, rules, vec![problem], None, (options, Effort::Whole), progress)?;
    let outcome = outcomes.swap_remove(0);
    let residual = outcome.residual();
    let discretisation = Arc::clone(&system.discretisation);
    let solution = CurvedSolution::new(discretisation, center, outcome.masses, residual, error_estimate, stop);
    Ok(solution.checked()?.with_system(system))
}

fn within_limits(options: &SolveOptions) -> Result<SolveOptions> {
    options.validate()?;
    Ok(SolveOptions { max_unknowns: options.max_unknowns.min(MOST_UNKNOWNS), ..options.clone() })
}

/// Unknowns a panel for a tolerance.
fn degree_for(options: &SolveOptions, panels: usize) -> Result<usize> {
    let digits = -options.tolerance.log10();
    let best = match digits {
        d if d < 4.5 => 6,
        d if d < 7.5 => 10,
        d if d < 9.5 => 12,
        _ => 16,
    };
    let p = best.min(options.max_unknowns / panels);
    if p < 4 {
        return Err(Error::InvalidOption {
            name: "max_unknowns",
            expected: "at least four for each panel, of which a corner needs two or more",
            value: options.max_unknowns as f64,
        });
    }
    Ok(p)
}
