//! Symm's equation solved to a tolerance: panels are halved where the equation does not hold yet.
//!
//! Log f_h/f is analytic in the region, and on the boundary its real part is c minus the equation's residual r. By the
//! maximum principle |r| bounds the error of log|f|, and its conjugate function the error of arg f: the residual at points
//! that were not collocated is therefore an error estimate, up to a modest factor.

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;

use super::panel::{Boundary, Panel, initial_panels};
use super::potential::LogPotential;
use super::rule::{Order, Rules};
use super::system::{System, SystemSolution};
use crate::plane::{BoundaryPoint, Complex64, Region};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::Arc;

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
        Self { tolerance: 1e-8, max_unknowns: 150_000 }
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
    /// The panels of an earlier solve were to be kept, and are too coarse for this center.
    SamePanels,
    /// Refining no longer helped: rounding, or a region at the limit of double precision.
    Stagnation,
}

/// A solved equation, with its evidence.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The system, ready for another center.
    pub system: Arc<System>,
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
    /// The panels it lives on.
    #[must_use]
    pub fn discretisation(&self) -> &Discretisation {
        &self.system.discretisation
    }

    /// Measure from vertex 0 to a boundary point.
    #[must_use]
    pub fn measure_at(&self, point: BoundaryPoint) -> f64 {
        let discretisation = self.discretisation();
        let length = discretisation.boundary.lengths[point.edge];
        let (from_start, from_end) = (point.t * length, (1.0 - point.t) * length);
        let panels = self.correspondence.panels_of_edge(point.edge);
        let last = panels.end - 1;
        for q in panels {
            let panel = &discretisation.panels[q];
            let s = if panel.outgoing { from_start } else { from_end };
            let within = if panel.outgoing { s <= panel.end } else { s >= panel.start };
            if within || q == last {
                return self.correspondence.measure(discretisation, q, panel.tau_at(s));
            }
        }
        0.0
    }

    /// Measure from vertex 0 → the edge and the share of it where that is reached.
    #[must_use]
    pub fn locate(&self, measure: f64) -> (usize, f64) {
        let discretisation = self.discretisation();
        let (q, tau) = self.correspondence.locate(discretisation, measure);
        let panel = &discretisation.panels[q];
        let share = panel.distance_at(tau) / discretisation.boundary.lengths[panel.edge];
        (panel.edge, if panel.outgoing { share } else { 1.0 - share })
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
        let measure = self.correspondence.complex_measure(discretisation, q, tau);
        Some((Complex64::i() * TAU * measure).exp())
    }
}

/// The map's error was measured at 1 to 8 times the residual.
const ERROR_PER_RESIDUAL: f64 = 10.0;
/// Rounding alone makes errors of this size in the map,
const ROUNDING: f64 = 1e-14;
/// and of this size in the equations.
const NOISE: f64 = 1e-15;
/// Estimates below this are checked against amplified rounding.
const CHECK_ROUNDING_BELOW: f64 = 1e-9;
/// Panels whose own residual is above this share of the acceptable one are halved.
const REFINE_SHARE: f64 = 0.3;
/// The linear systems are solved to this share of it: between the walls of a thin slot the potential hardly sees
/// opposite masses, so what the iteration leaves there weighs a thousand times more in the map.
const ITERATION_SHARE: f64 = 1e-3;
/// And to this one when only the center has moved: the guess is good where slots would be slow.
const MOVE_SHARE: f64 = 0.1;
/// Below this, a residual that refining did not halve is taken for rounding.
const STAGNATION_BELOW: f64 = 1e-10;
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

/// The same region for another `center` (plane units) on the panels that there are: nothing is assembled, factored or
/// refined, and the estimate says how well they serve.
///
/// # Errors
/// [`Error::Cancelled`], [`Error::NegativeMass`].
pub fn move_center(
    previous: &Solution,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Solution> {
    let system = Arc::clone(&previous.system);
    let center = center * system.discretisation.boundary.unit;
    let mut outcome = system.check(center, moved_measure(previous, center));
    if estimate_of(&outcome) > options.tolerance {
        let tolerance = MOVE_SHARE * options.tolerance / ERROR_PER_RESIDUAL;
        outcome = system.solve(center, tolerance, Some(outcome.masses), progress)?;
    }
    let error_estimate = estimate_of(&outcome);
    let stop = if error_estimate <= options.tolerance { Stop::Tolerance } else { Stop::SamePanels };
    finish(system, center, outcome, error_estimate, stop)
}

/// Harmonic measure seen from `center`, as far as `previous` knows: Poisson's kernel times the measure seen from its own
/// center, dμ₁ = (1 − |w|²)/|e^{iθ} − w|² dμ₀ with w = f₀(center).
fn moved_measure(previous: &Solution, center: Complex64) -> Vec<f64> {
    let discretisation = previous.discretisation();
    let w = previous.potential.map(discretisation, previous.center, center);
    let nodes = &discretisation.order.panel.nodes;
    let mut moved = Vec::with_capacity(previous.masses.len());
    for (i, mass) in previous.masses.iter().enumerate() {
        let (q, node) = (i / nodes.len(), i % nodes.len());
        let theta = TAU * previous.correspondence.measure(discretisation, q, 0.5 * (nodes[node] + 1.0));
        moved.push(mass * (1.0 - w.norm_sqr()) / (Complex64::cis(theta) - w).norm_sqr());
    }
    let total: f64 = moved.iter().sum();
    moved.iter_mut().for_each(|mass| *mass /= total);
    moved
}

/// What the residuals say of the map's error, apart from rounding in the system.
fn estimate_of(outcome: &SystemSolution) -> f64 {
    ERROR_PER_RESIDUAL * outcome.residual() + ROUNDING
}

/// A solution with its evidence, unless its masses show that it is none.
fn finish(
    system: Arc<System>,
    center: Complex64,
    outcome: SystemSolution,
    error_estimate: f64,
    stop: Stop,
) -> Result<Solution> {
    let residual = outcome.residual();
    let masses = outcome.masses;
    let correspondence = BoundaryCorrespondence::new(&system.discretisation, &masses);
    let mass = correspondence.smallest_mass();
    if mass < -error_estimate || !residual.is_finite() {
        return Err(Error::NegativeMass { mass, estimate: error_estimate });
    }
    let potential = LogPotential::new(&masses);
    Ok(Solution { system, center, masses, correspondence, potential, residual, error_estimate, stop })
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
            name: "maxUnknowns",
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
