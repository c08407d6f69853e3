//! Symm's equation solved to a tolerance: panels are halved where the equation does not hold yet.
//!
//! Log f_h/f is analytic in the region, and on the boundary its real part is c minus the equation's residual r. By the
//! maximum principle |r| bounds the error of log|f|, and its conjugate function the error of arg f: the residual at points
//! that were not collocated is therefore an error estimate, up to a modest factor.

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::lu::{Lu, dot};
use super::panel::{Boundary, Panel, initial_panels};
use super::rule::{Order, Rules};
use crate::plane::{Complex64, Region};
use crate::{Error, Result};
use std::rc::Rc;

/// What a solve should reach, and what it may spend.
#[derive(Clone, Debug, PartialEq)]
pub struct SolveOptions {
    /// Largest acceptable error of the map (the disk has radius 1), from 1e-14 to 0.1.
    pub tolerance: f64,
    /// Largest number of unknowns.
    pub max_unknowns: usize,
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self { tolerance: 1e-8, max_unknowns: 6000 }
    }
}

/// Told the stage and the fraction done of a long computation; returns false to cancel it.
pub type Progress<'a> = &'a mut dyn FnMut(&'static str, f64) -> bool;

/// Why a solve ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(serde::Serialize, tsify::Tsify), serde(rename_all = "kebab-case"))]
pub enum Stop {
    /// The error estimate is below the tolerance.
    Tolerance,
    /// The next refinement would need more than `max_unknowns`.
    MaxUnknowns,
    /// Refining no longer helped: rounding, or a region at the limit of double precision.
    Stagnation,
}

/// A solved equation, with its evidence.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The panels it lives on.
    pub discretisation: Discretisation,
    /// Mass of harmonic measure at each node.
    pub masses: Vec<f64>,
    /// θ along the boundary.
    pub correspondence: BoundaryCorrespondence,
    /// Largest violation of the equation at points that were not collocated, or |c| if that is larger.
    pub residual: f64,
    /// Estimate of the largest error of the map.
    pub error_estimate: f64,
    /// Why the solve ended.
    pub stop: Stop,
}

/// The map's error is at most about twice the residual (measured); twice that is the estimate.
const ERROR_PER_RESIDUAL: f64 = 4.0;
/// Rounding alone makes errors of this size.
const ROUNDING: f64 = 1e-14;
/// Panels whose own residual is above this share of the acceptable one are halved.
const REFINE_SHARE: f64 = 0.3;
/// Corner panels reach this far, measured in the clearance of their corner.
const KAPPA: f64 = 1.0;

/// Solves Symm's equation for `region`, refining until the error estimate meets the tolerance.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`], and [`Error::NegativeMass`] if the discretisation failed.
pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Solution> {
    if !(1e-14..=0.1).contains(&options.tolerance) {
        return Err(Error::InvalidOption {
            name: "tolerance",
            expected: "between 1e-14 and 0.1",
            value: options.tolerance,
        });
    }
    let boundary = Rc::new(Boundary::new(region.polygon()));
    let center = region.center() * boundary.unit;
    let mut rules = Rules::new(order_for(options.tolerance));
    let mut panels = initial_panels(&boundary, KAPPA);
    let mut previous_residual = f64::INFINITY;
    loop {
        let discretisation = Discretisation::new(Rc::clone(&boundary), panels, &mut rules);
        let (mut solution, residuals) = solve_on(discretisation, center, progress)?;
        let acceptable = options.tolerance / ERROR_PER_RESIDUAL;
        panels = refine(&solution.discretisation.panels, &residuals, REFINE_SHARE * acceptable);
        let stop = if solution.error_estimate <= options.tolerance {
            Some(Stop::Tolerance)
        } else if solution.residual > 0.5 * previous_residual && solution.residual < 1e-10 {
            Some(Stop::Stagnation)
        } else if panels.len() * rules.order.p() > options.max_unknowns {
            Some(Stop::MaxUnknowns)
        } else {
            None
        };
        if let Some(stop) = stop {
            solution.stop = stop;
            let mass = solution.correspondence.smallest_mass();
            if mass < -solution.error_estimate || !solution.residual.is_finite() {
                return Err(Error::NegativeMass { mass, estimate: solution.error_estimate });
            }
            return Ok(solution);
        }
        previous_residual = solution.residual;
    }
}

/// Unknowns a panel and digits of quadrature that reach a tolerance with the least work (measured).
fn order_for(tolerance: f64) -> Order {
    let digits = -tolerance.log10();
    let p = match digits {
        d if d < 4.5 => 4,
        d if d < 6.5 => 6,
        d if d < 7.5 => 7,
        d if d < 9.5 => 8,
        d if d < 11.5 => 12,
        _ => 16,
    };
    Order::new(p, (digits + 3.0).min(15.5))
}

fn refine(panels: &[Panel], residuals: &[f64], acceptable: f64) -> Vec<Panel> {
    panels
        .iter()
        .zip(residuals)
        .flat_map(|(panel, residual)| if *residual > acceptable { panel.halves().to_vec() } else { vec![*panel] })
        .collect()
}

/// The solution on given panels, and the largest residual on each of them.
fn solve_on(discretisation: Discretisation, center: Complex64, progress: Progress) -> Result<(Solution, Vec<f64>)> {
    let n = discretisation.unknowns();
    let targets = discretisation.collocation_points();
    let mut matrix = vec![0.0; (n + 1) * (n + 1)];
    for (i, (target, row)) in targets.iter().zip(matrix.chunks_exact_mut(n + 1)).enumerate() {
        discretisation.fill_row(*target, 0, &mut row[..n]);
        row[n] = 1.0;
        if i % 64 == 0 && !progress("assemble", i as f64 / n as f64) {
            return Err(Error::Cancelled);
        }
    }
    matrix[n * (n + 1)..][..n].fill(1.0);
    let mut masses = discretisation.log_distances(&targets, center);
    masses.push(1.0);
    Lu::new(n + 1, matrix).solve(&mut masses);
    let c = masses.pop().unwrap_or(f64::NAN);
    let residuals = panel_residuals(&discretisation, &masses, c, center);
    let residual = residuals.iter().fold(c.abs(), |worst, r| worst.max(*r));
    let correspondence = BoundaryCorrespondence::new(&discretisation, &masses);
    let error_estimate = ERROR_PER_RESIDUAL * residual + ROUNDING;
    Ok((
        Solution { discretisation, masses, correspondence, residual, error_estimate, stop: Stop::Tolerance },
        residuals,
    ))
}

/// Largest violation of the equation on each panel, at its check points.
fn panel_residuals(discretisation: &Discretisation, masses: &[f64], c: f64, center: Complex64) -> Vec<f64> {
    let checks = discretisation.check_points();
    let log_distances = discretisation.log_distances(&checks, center);
    let mut row = vec![0.0; masses.len()];
    let mut residual_at = |(check, log_distance): (&_, &f64)| {
        discretisation.fill_row(*check, 0, &mut row);
        (dot(&row, masses) + c - log_distance).abs()
    };
    let residuals: Vec<f64> = checks.iter().zip(&log_distances).map(&mut residual_at).collect();
    residuals.chunks_exact(checks.len() / discretisation.panels.len()).map(largest).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a, b| if *b > a || b.is_nan() { *b } else { a })
}
