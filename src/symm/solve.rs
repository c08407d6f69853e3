//! Symm's equation solved to a tolerance: panels are halved where the equation does not hold yet.

use super::center::moved_measure;
use super::discretisation::Discretisation;
use super::options::{Progress, SolveOptions, Stop};
use super::order::Order;
use super::panel::{Boundary, Panel, halved_towards, initial_panels};
use super::problem::Problem;
use super::refinement::Refinable;
use super::rule::Rules;
use super::solution::{ERROR_PER_RESIDUAL, estimate_of, finish};
use super::system::{System, SystemEquations, SystemSolution};
use crate::Result;
use crate::plane::{Complex64, Domain, Region};
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
/// Below this, a residual is taken for rounding if refining left more than a share of the estimate.
const STAGNATION_BELOW: f64 = 1e-10;
/// That share.
const STAGNATION_SHARE: f64 = 0.9;
/// A trial is given up where a round leaves more than this share of the estimate (measured: where it can be met, a round leaves a
/// fifth).
const TRIAL_SHARE: f64 = 0.5;
/// While panels are still being halved, the systems are solved to this share of the acceptable residual, less where thin walls
/// make it weigh more.
const ROUGH_SHARE: f64 = 0.05;
/// Corner panels reach this far, measured in the clearance of their corner.
const KAPPA: f64 = 1.0;
/// Panels are no longer than this times their distance from the center: there the density is Poisson's kernel, whatever the
/// region.
const FACING: f64 = 1.0;

/// How long a solve goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effort {
    /// As long as anything helps.
    Whole,
    /// As long as every round helps a lot: what was taken for known may not fit.
    Trial,
}

/// Solves Symm's equation for `region`, refining until the error estimate meets the tolerance.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`], and [`Error::NegativeMass`] if the discretisation failed.
pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Solution> {
    options.validate()?;
    let boundary = Arc::new(Boundary::new(region.polygon()));
    let center = region.center() * boundary.unit;
    let panels = halved_towards(center, FACING, &boundary, initial_panels(&boundary, KAPPA));
    let mut rules = Rules::new(order_for(options, panels.len())?);
    let discretisation = Discretisation::new(boundary, panels, &mut rules);
    let system = Arc::new(System::new(discretisation, progress)?);
    seen_from(center, system, rules, None, (options, Effort::Whole), progress)
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
    let boundary = &discretisation.boundary;
    let center = center * boundary.unit;
    let mut rules = Rules::new(discretisation.order.clone());
    let facing = halved_towards(center, FACING, boundary, discretisation.panels.clone());
    if facing.len() == discretisation.panels.len() {
        let guess = moved_measure(previous, center);
        return seen_from(center, previous.system(progress)?, rules, Some(guess), (options, Effort::Whole), progress);
    }
    // Much nearer to the boundary: residuals would halve panels once a round.
    let discretisation = Discretisation::new(Arc::clone(boundary), facing, &mut rules);
    let system = Arc::new(System::new(discretisation, progress)?);
    seen_from(center, system, rules, None, (options, Effort::Whole), progress)
}

/// Solves problems for `domain`, all on the same panels, refining until the estimate meets the tolerance for each. `problems`
/// is given the scaled boundary.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`].
pub fn solve_problems(
    domain: &Domain,
    problems: &dyn Fn(&Boundary) -> Vec<Problem>,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Adapted> {
    options.validate()?;
    let boundary = Arc::new(Boundary::of(domain.oriented_polygons(), domain.is_bounded()));
    let problems = problems(&boundary);
    let mut panels = initial_panels(&boundary, KAPPA);
    for problem in &problems {
        for singular in problem.source.singularities() {
            panels = halved_towards(singular, FACING, &boundary, panels);
        }
    }
    let mut rules = Rules::new(order_for(options, panels.len())?);
    let system = Arc::new(System::new(Discretisation::new(boundary, panels, &mut rules), progress)?);
    adapt(system, rules, problems, None, (options, Effort::Whole), progress)
}

/// Harmonic measure seen from `center`, refined until the estimate meets the tolerance.
pub(super) fn seen_from(
    center: Complex64,
    system: Arc<System>,
    rules: Rules,
    guess: Option<Vec<f64>>,
    ask: (&SolveOptions, Effort),
    progress: Progress,
) -> Result<Solution> {
    let problem = Problem::measure(&system.discretisation.boundary, center);
    let guesses = guess.map(|guess| vec![guess]);
    let Adapted { system, mut outcomes, error_estimate, stop, .. } =
        adapt(system, rules, vec![problem], guesses, ask, progress)?;
    finish(system, center, outcomes.swap_remove(0), error_estimate, stop)
}

/// Problems solved together, on panels fine enough for all of them.
#[derive(Debug)]
pub struct Adapted<D = Discretisation> {
    /// The system of the last round.
    pub system: Arc<System<D>>,
    /// What was solved for.
    pub problems: Vec<Problem>,
    /// The solution of each.
    pub outcomes: Vec<SystemSolution>,
    /// Estimate of the largest error of any.
    pub error_estimate: f64,
    /// Why the solve ended.
    pub stop: Stop,
}

/// Solves, and halves panels and solves again until the estimate meets the tolerance.
pub(super) fn adapt<D: Refinable + 'static>(
    mut system: Arc<System<D>>,
    mut rules: Rules,
    problems: Vec<Problem>,
    mut guesses: Option<Vec<Vec<f64>>>,
    (options, effort): (&SolveOptions, Effort),
    progress: Progress,
) -> Result<Adapted<D>> {
    let acceptable = options.tolerance / ERROR_PER_RESIDUAL;
    let mut previous_estimate = f64::INFINITY;
    loop {
        let weight = system.discretisation.walls().largest_weight();
        let fine = ITERATION_SHARE * acceptable / (0.01 * weight).max(1.0);
        let rough = fine.max(ROUGH_SHARE * acceptable / weight);
        let mut outcomes = solve_all(&system, &problems, rough, guesses.take(), progress)?;
        let refinement_of = |outcomes: &[SystemSolution]| {
            system.discretisation.refinement(&largest_residuals(outcomes), REFINE_SHARE * acceptable)
        };
        let estimate_of = |outcomes: &[SystemSolution]| {
            let estimates = outcomes.iter().map(|outcome| estimate_of(system.discretisation.as_ref(), outcome));
            estimates.fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
        };
        let mut refinement = refinement_of(&outcomes);
        let ends = |outcomes: &[SystemSolution], panels: &[Panel]| {
            let estimate = estimate_of(outcomes);
            let residual = outcomes.iter().map(SystemSolution::residual).fold(0.0, f64::max);
            estimate <= options.tolerance
                || panels.len() == system.discretisation.panel_count()
                || panels.len() * rules.order.p() > options.max_unknowns
                || estimate > STAGNATION_SHARE * previous_estimate && residual < STAGNATION_BELOW
                || estimate > TRIAL_SHARE * previous_estimate && effort == Effort::Trial
        };
        if ends(&outcomes, &refinement.panels) {
            let guesses = outcomes.into_iter().map(|outcome| outcome.masses).collect();
            outcomes = solve_all(&system, &problems, fine, Some(guesses), progress)?;
            refinement = refinement_of(&outcomes);
        }
        let from_residual = estimate_of(&outcomes);
        let from_noise =
            if from_residual < CHECK_ROUNDING_BELOW { NOISE * system.noise_amplification(progress)? } else { 0.0 };
        let error_estimate = from_residual + from_noise;
        let stop = if error_estimate <= options.tolerance {
            Some(Stop::Tolerance)
        } else if !ends(&outcomes, &refinement.panels) && from_noise <= from_residual {
            None
        } else if refinement.panels.len() * rules.order.p() > options.max_unknowns {
            Some(Stop::MaxUnknowns)
        } else {
            Some(Stop::Stagnation)
        };
        if let Some(stop) = stop {
            return Ok(Adapted { system, problems, outcomes, error_estimate, stop });
        }
        previous_estimate = from_residual;
        let carried = |outcome: &SystemSolution| refinement.carried(system.discretisation.as_ref(), &outcome.masses);
        guesses = Some(outcomes.iter().map(carried).collect());
        system = Arc::new(system.refined(refinement, &mut rules, progress)?);
    }
}

fn solve_all(
    system: &SystemEquations,
    problems: &[Problem],
    tolerance: f64,
    guesses: Option<Vec<Vec<f64>>>,
    progress: Progress,
) -> Result<Vec<SystemSolution>> {
    let mut guesses = guesses.into_iter().flatten();
    problems.iter().map(|problem| system.solve(problem, tolerance, guesses.next(), progress)).collect()
}

/// The largest residual of any solution on each panel.
fn largest_residuals(outcomes: &[SystemSolution]) -> Vec<f64> {
    let mut largest = outcomes[0].residuals.clone();
    for outcome in &outcomes[1..] {
        for (worst, r) in largest.iter_mut().zip(&outcome.residuals) {
            if r > worst || r.is_nan() {
                *worst = *r;
            }
        }
    }
    largest
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
        d if d < 7.5 => 8,
        // A higher degree saves halvings and second rounds; among many panels it costs more than it saves.
        d if d < 8.5 && panels <= 400 => 10,
        d if d < 8.5 => 8,
        d if d < 11.5 => 12,
        _ => 16,
    };
    let expected = "at least two for each panel, of which a vertex needs two or more";
    Ok(Order::new(options.allowed(best, panels, 2, expected)?, (digits + 3.0).min(15.5)))
}
