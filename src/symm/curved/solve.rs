//! Symm's equation on a boundary of analytic edges, solved to a tolerance.

use super::super::options::{Progress, SolveOptions};
use super::super::order::Order;
use super::super::panel::Panel;
use super::super::problem::{Problem, Source};
use super::super::rule::Rules;
use super::super::solve::{Adapted, Effort, adapt};
use super::super::system::System;
use super::boundary::{CurvedBoundary, ROUND_DIGITS};
use super::discretisation::CurvedDiscretisation;
use super::solution::CurvedSolution;
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
    let digits = digits_for(&options);
    let boundary = Arc::new(CurvedBoundary::new(outline, digits));
    check(&boundary)?;
    let center = center * boundary.unit;
    let panels = boundary.initial_panels(&[center]);
    let rules = Rules::new(Order::new(degree_for(&options, panels.len())?, digits));
    solve_on(&boundary, panels, rules, center, &options, progress)
}

/// Solves problems, stated for a unit (plane units × unit = units used), on the same panels, refining until the estimate meets the
/// tolerance for each. `bounded` tells whether the first outline is around the region; the others are around holes.
///
/// # Errors
/// As [`solve_curved`]; [`Error::Cusp`] for corners of angle 0 or 2π.
pub fn solve_curved_problems(
    outlines: &[&CurvedOutline],
    bounded: bool,
    problems: &dyn Fn(f64) -> Vec<Problem>,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Adapted<CurvedDiscretisation>> {
    let options = within_limits(options)?;
    for (k, outline) in outlines.iter().enumerate() {
        check_tips(outline).map_err(|error| match k.checked_sub(usize::from(bounded)) {
            Some(hole) => Error::InHole { hole, error: Box::new(error) },
            None => error,
        })?;
    }
    let digits = digits_for(&options);
    let boundary = Arc::new(CurvedBoundary::of(outlines, bounded, digits));
    check(&boundary)?;
    let problems = problems(boundary.unit);
    let singular: Vec<Complex64> = problems.iter().flat_map(|problem| problem.source.singularities()).collect();
    let panels = boundary.initial_panels(&singular);
    let mut rules = Rules::new(Order::new(degree_for(&options, panels.len())?, digits));
    let discretisation = CurvedDiscretisation::seeing(&boundary, panels, &mut rules, progress)?;
    let system = Arc::new(System::new(discretisation, progress)?);
    adapt(system, rules, problems, None, (&options, Effort::Whole), progress)
}

/// Corners of angle 0 are solved for without holes alone.
fn check_tips(outline: &CurvedOutline) -> Result<()> {
    match (0..outline.edges().len()).find(|&edge| outline.alpha(edge) == 0.0) {
        Some(edge) => Err(Error::Cusp { edge, at: outline.edges()[edge].from() }),
        None => Ok(()),
    }
}

fn check(boundary: &CurvedBoundary) -> Result<()> {
    let Some(edge) = boundary.halted() else { return Ok(()) };
    let reason = format!("edge {edge} stands still at an end: all but one of its control points are one there");
    Err(Error::InvalidOutline { reason })
}

/// Digits of quadrature.
fn digits_for(options: &SolveOptions) -> f64 {
    (ROUND_DIGITS - options.tolerance.log10()).min(MOST_DIGITS)
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
    let discretisation = &previous.discretisation;
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
    let problem = Problem { source: Source::log(center), charges: vec![1.0] };
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
    options.allowed(best, panels, 4, "at least four for each panel, of which a corner needs two or more")
}
