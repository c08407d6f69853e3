//! Symm's equation on a boundary of analytic edges, solved to a tolerance.

use super::curved_boundary::CurvedBoundary;
use super::curved_solution::CurvedSolution;
use super::curved_system::{CurvedDiscretisation, CurvedOutcome, CurvedSystem};
use super::options::{Progress, SolveOptions, Stop};
use super::order::Order;
use super::panel::Panel;
use super::rule::Rules;
use super::solution::ERROR_PER_RESIDUAL;
use crate::plane::{Complex64, CurvedOutline};
use crate::{Error, Result};
use std::sync::Arc;

/// Rounding alone makes errors of this size in the map.
const ROUNDING: f64 = 2e-14;
/// Rounding in the equations.
const NOISE: f64 = 1e-15;
/// Panels whose own residual is above this share of the acceptable one are halved.
const REFINE_SHARE: f64 = 0.3;
/// What is left of an estimate when refining no longer helps.
const STAGNATION: f64 = 0.9;
/// A residual is taken for rounding below this.
const STAGNATION_BELOW: f64 = 1e-10;
/// Unknowns that can be factored.
const MOST_UNKNOWNS: usize = 5000;
/// Rounds after which refining is given up.
const MOST_ROUNDS: usize = 60;

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
    options.validate()?;
    let boundary = Arc::new(CurvedBoundary::new(outline));
    if let Some(edge) = boundary.halted() {
        let reason = format!("edge {edge} stands still at an end: all but one of its control points are one there");
        return Err(Error::InvalidOutline { reason });
    }
    let center = center * boundary.unit;
    let mut panels = boundary.initial_panels(center);
    let most = options.max_unknowns.min(MOST_UNKNOWNS);
    let order = order_for(options.tolerance, most, panels.len())?;
    let p = order.p();
    let mut rules = Rules::new(order);
    let mut previous = f64::INFINITY;
    for round in 0.. {
        let discretisation = CurvedDiscretisation::new(Arc::clone(&boundary), &panels, &mut rules);
        let system = match CurvedSystem::new(&discretisation, progress)? {
            Ok(system) => system,
            Err(blind) if round < MOST_ROUNDS => {
                panels = halved(&panels, &blind);
                continue;
            }
            Err(_) => return Err(Error::Inaccurate { estimate: f64::INFINITY }),
        };
        let outcome = system.measure(&boundary, center);
        let residual = residual_of(&outcome);
        let from_residual = ERROR_PER_RESIDUAL * residual + discretisation.walls.error(&outcome.residuals);
        let estimate = from_residual + ROUNDING + NOISE * system.noise_amplification();
        let marked = too_coarse(&discretisation, &outcome, options.tolerance);
        let refined = boundary.balanced(halved(&panels, &marked));
        let stop = if estimate <= options.tolerance {
            Stop::Tolerance
        } else if refined.len() == panels.len()
            || round >= MOST_ROUNDS
            || residual > STAGNATION * previous && residual < STAGNATION_BELOW
        {
            Stop::Stagnation
        } else if refined.len() * p > most || residual.is_nan() {
            Stop::MaxUnknowns
        } else {
            previous = residual;
            panels = refined;
            continue;
        };
        return CurvedSolution::new(discretisation, center, outcome.masses, residual, estimate, stop).checked();
    }
    Err(Error::Inaccurate { estimate: f64::INFINITY })
}

fn residual_of(outcome: &CurvedOutcome) -> f64 {
    let worse = |worst: f64, r: &f64| if *r > worst || r.is_nan() { *r } else { worst };
    outcome.residuals.iter().fold(outcome.constant_error, worse)
}

/// The panels whose residuals are above the acceptable one, or if there are none, above a smaller share of it.
fn too_coarse(discretisation: &CurvedDiscretisation, outcome: &CurvedOutcome, tolerance: f64) -> Vec<bool> {
    let acceptable = REFINE_SHARE * tolerance / ERROR_PER_RESIDUAL;
    for share in [1.0, 0.3, 0.1] {
        let wild = |(q, r): (usize, &f64)| {
            discretisation.panels[q].panel.can_be_halved() && r * discretisation.walls.weight(q) > share * acceptable
        };
        let marked: Vec<bool> = outcome.residuals.iter().enumerate().map(wild).collect();
        if marked.contains(&true) {
            return marked;
        }
    }
    vec![false; outcome.residuals.len()]
}

fn halved(panels: &[Panel], marked: &[bool]) -> Vec<Panel> {
    let halves = |(panel, split): (&Panel, &bool)| if *split { panel.halves().to_vec() } else { vec![*panel] };
    panels.iter().zip(marked).flat_map(halves).collect()
}

/// Unknowns a panel and digits of quadrature for a tolerance.
fn order_for(tolerance: f64, most: usize, panels: usize) -> Result<Order> {
    let digits = -tolerance.log10();
    let best = match digits {
        d if d < 4.5 => 6,
        d if d < 7.5 => 10,
        d if d < 9.5 => 12,
        _ => 16,
    };
    let p = best.min(most / panels);
    if p < 4 {
        return Err(Error::InvalidOption {
            name: "max_unknowns",
            expected: "at least four for each panel, of which a corner needs two or more",
            value: most as f64,
        });
    }
    Ok(Order::new(p, (digits + 3.0).min(15.5)))
}
