//! Symm's linear system, ready to be solved for any right-hand side.

use super::discretisation::{Discretisation, Target};
use super::fast_multipole::FastInfluence;
use super::gmres::gmres;
use super::influence::{DenseInfluence, Influence};
use super::known::Known;
use super::lu::Lu;
use super::options::Progress;
use super::problem::{Problem, Source};
use super::refinement::Refinement;
use super::rule::Rules;
use super::two_level::TwoLevel;
use crate::Result;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// The matrix and its (approximate) inverse: one constant and one total mass a component border it.
pub struct System {
    /// The panels.
    pub discretisation: Arc<Discretisation>,
    /// The unknowns of each component.
    components: Vec<Range<usize>>,
    targets: Vec<Target>,
    checks: Vec<Target>,
    equations: Arc<Equations>,
    check_equations: Arc<Equations>,
    inverse: Arc<Inverse>,
    /// Of the panels that are not solved for.
    given: Option<Given>,
}

/// A measure that is known already, as the equations see it.
struct Given {
    known: Arc<Known>,
    at_targets: Vec<f64>,
    at_checks: Vec<f64>,
}

enum Equations {
    Dense(DenseInfluence),
    Fast(FastInfluence),
}

impl Equations {
    fn apply(&self, masses: &[f64], potentials: &mut [f64]) {
        match self {
            Self::Dense(dense) => dense.apply(masses, potentials),
            Self::Fast(fast) => fast.apply(masses, potentials),
        }
    }
}

enum Inverse {
    /// A factorisation of the whole matrix.
    Exact(Lu),
    /// A preconditioner.
    TwoLevel(TwoLevel),
}

/// What one right-hand side gave.
#[derive(Clone, Debug)]
pub struct SystemSolution {
    /// Mass at each node.
    pub masses: Vec<f64>,
    /// The constant cⱼ of each component.
    pub constants: Vec<f64>,
    /// |c| of an outer boundary, which would be 0 but for errors.
    pub constant_error: f64,
    /// Largest violation of the equation on each panel, at its check points.
    pub residuals: Vec<f64>,
}

impl SystemSolution {
    /// The largest violation of the equation, or the constant's error if that is larger.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.residuals.iter().fold(self.constant_error, |worst, r| if *r > worst || r.is_nan() { *r } else { worst })
    }
}

/// Up to so many unknowns a factorisation beats iterating (measured).
const FACTOR_UP_TO: usize = 500;
/// Up to so many, storing every entry beats expansions (measured).
const DENSE_UP_TO: usize = 2000;
/// Iterations after which something is wrong; 4 to 40 are usual.
const MOST_ITERATIONS: usize = 200;

impl System {
    /// Assembles and factors what the size asks for.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn new(discretisation: impl Into<Arc<Discretisation>>, progress: Progress) -> Result<Self> {
        let discretisation = discretisation.into();
        let targets = discretisation.collocation_points();
        let checks = discretisation.check_points();
        let n = discretisation.unknowns();
        let components: Vec<_> = discretisation.unknowns_of_components().collect();
        let digits = discretisation.order.digits;
        let (equations, check_equations, inverse) = if n <= DENSE_UP_TO {
            let equations = DenseInfluence::new(&discretisation, &targets, progress)?;
            let inverse = if n <= FACTOR_UP_TO {
                Inverse::Exact(Lu::new(n + components.len(), equations.bordered(&components)))
            } else {
                Inverse::TwoLevel(TwoLevel::new(&discretisation, progress)?)
            };
            let checks = DenseInfluence::new(&discretisation, &checks, progress)?;
            (Equations::Dense(equations), Equations::Dense(checks), inverse)
        } else {
            (
                Equations::Fast(FastInfluence::new(&discretisation, &targets, digits, progress)?),
                Equations::Fast(FastInfluence::new(&discretisation, &checks, digits, progress)?),
                Inverse::TwoLevel(TwoLevel::new(&discretisation, progress)?),
            )
        };
        let (equations, check_equations) = (Arc::new(equations), Arc::new(check_equations));
        let inverse = Arc::new(inverse);
        Ok(Self { discretisation, components, targets, checks, equations, check_equations, inverse, given: None })
    }

    /// The same equations, with a known measure on panels that are not among those solved for.
    #[must_use]
    pub fn with_known(self, known: &Arc<Known>) -> Self {
        let at_targets = known.potentials(&self.discretisation, &self.targets);
        let at_checks = known.potentials(&self.discretisation, &self.checks);
        Self { given: Some(Given { known: Arc::clone(known), at_targets, at_checks }), ..self }
    }

    /// The system of refined panels; a large one takes over what concerns panels that were kept.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn refined(self: Arc<Self>, refinement: Refinement, rules: &mut Rules, progress: Progress) -> Result<Self> {
        let known = self.given.as_ref().map(|given| Arc::clone(&given.known));
        let refined = self.refined_equations(refinement, rules, progress)?;
        Ok(match known {
            Some(known) => refined.with_known(&known),
            None => refined,
        })
    }

    fn refined_equations(
        self: Arc<Self>,
        refinement: Refinement,
        rules: &mut Rules,
        progress: Progress,
    ) -> Result<Self> {
        let boundary = Arc::clone(&self.discretisation.boundary);
        let discretisation = Discretisation::new(boundary, refinement.panels.clone(), rules);
        // What is not needed any more makes room for what comes, unless somebody else holds the system.
        let (equations, check_equations, inverse) = match Arc::try_unwrap(self) {
            Ok(old) => (old.equations, old.check_equations, old.inverse),
            Err(old) => (Arc::clone(&old.equations), Arc::clone(&old.check_equations), Arc::clone(&old.inverse)),
        };
        let two_level = match inverse.as_ref() {
            Inverse::TwoLevel(two_level) => two_level.refined(&refinement, &discretisation, progress)?,
            Inverse::Exact(_) => None,
        };
        drop(inverse);
        let (Equations::Fast(fast), Equations::Fast(fast_checks), Some(two_level)) =
            (equations.as_ref(), check_equations.as_ref(), two_level)
        else {
            drop((equations, check_equations));
            return Self::new(discretisation, progress);
        };
        let targets = discretisation.collocation_points();
        let refined = fast.refined(&refinement, &discretisation, &targets, progress)?;
        drop(equations);
        let checks = discretisation.check_points();
        let refined_checks = fast_checks.refined(&refinement, &discretisation, &checks, progress)?;
        Ok(Self {
            components: discretisation.unknowns_of_components().collect(),
            discretisation: Arc::new(discretisation),
            targets,
            checks,
            equations: Arc::new(Equations::Fast(refined)),
            check_equations: Arc::new(Equations::Fast(refined_checks)),
            inverse: Arc::new(Inverse::TwoLevel(two_level)),
            given: None,
        })
    }

    /// Solves a problem until the equations hold to `tolerance` in the mean, from `guess` if there is one.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn solve(
        &self,
        problem: &Problem,
        tolerance: f64,
        guess: Option<Vec<f64>>,
        progress: Progress,
    ) -> Result<SystemSolution> {
        let mut rhs = problem.source.values(&self.discretisation.boundary, &self.targets);
        rhs.extend_from_slice(&problem.charges);
        if let Some(Given { known, at_targets, .. }) = &self.given {
            // One component, whose charge is the measure of the whole.
            rhs.iter_mut().zip(at_targets.iter().chain([&known.mass])).for_each(|(r, given)| *r -= given);
        }
        let n = self.discretisation.unknowns();
        let mut x = guess.unwrap_or_else(|| vec![0.0; n]);
        x.resize(n + self.components.len(), 0.0);
        self.iterate(&rhs, &mut x, tolerance.max(ROUNDING_PER_ENTRY), progress)?;
        let constants = x.split_off(n);
        Ok(self.examined(problem, x, constants))
    }

    /// Takes `masses` for the solution with the constants 0, and says how well they fit.
    #[must_use]
    pub fn check(&self, problem: &Problem, masses: Vec<f64>) -> SystemSolution {
        self.examined(problem, masses, vec![0.0; self.components.len()])
    }

    fn examined(&self, problem: &Problem, masses: Vec<f64>, constants: Vec<f64>) -> SystemSolution {
        let residuals = self.residuals(problem, &masses, &constants);
        // The branch of vortices may differ from that at infinity.
        let is_zero = self.discretisation.boundary.bounded && !matches!(problem.source, Source::Vortices(..));
        let constant_error = if is_zero { constants[0].abs() } else { 0.0 };
        SystemSolution { masses, constants, constant_error, residuals }
    }

    /// How much noise of size 1 in the equations moves the measure of a part of the boundary: what rounding is multiplied
    /// by. Thin slots make it large, since between their walls opposite masses hardly show in the potential.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn noise_amplification(&self, progress: Progress) -> Result<f64> {
        let n = self.discretisation.unknowns();
        // Signs by a multiplicative hash, half of each node and half of its edge: the same at every call.
        let sign = |i: usize| if (i + 1).wrapping_mul(0x9e37_79b9) >> 16 & 1 == 0 { 1.0 } else { -1.0 };
        let edge = |i: usize| self.discretisation.panels[i / self.discretisation.order.p()].edge;
        let mut noise: Vec<f64> = (0..n).map(|i| 0.5 * (sign(i) + sign(edge(i)))).collect();
        noise.resize(n + self.components.len(), 0.0);
        let mut x = vec![0.0; n + self.components.len()];
        self.iterate(&noise, &mut x, 0.05, progress)?;
        let mut measure = 0.0;
        let mut range = (0.0, 0.0);
        for mass in &x[..n] {
            measure += mass;
            range = (f64::min(range.0, measure), f64::max(range.1, measure));
        }
        Ok(range.1 - range.0)
    }

    /// Improves `x` until the equations hold to `tolerance` in the mean.
    fn iterate(&self, rhs: &[f64], x: &mut [f64], tolerance: f64, progress: Progress) -> Result<()> {
        let n = self.discretisation.unknowns();
        let apply = |x: &[f64], y: &mut [f64]| {
            self.equations.apply(&x[..n], &mut y[..n]);
            for (j, own) in self.components.iter().enumerate() {
                y[own.clone()].iter_mut().for_each(|value| *value += x[n + j]);
                y[n + j] = x[own.clone()].iter().sum();
            }
        };
        let precondition = |r: &[f64], z: &mut [f64]| match self.inverse.as_ref() {
            Inverse::Exact(lu) => {
                z.copy_from_slice(r);
                lu.solve(z);
            }
            Inverse::TwoLevel(two_level) => two_level.apply(r, z),
        };
        gmres(apply, precondition, rhs, x, tolerance * (n as f64).sqrt(), MOST_ITERATIONS, progress)?;
        Ok(())
    }

    fn residuals(&self, problem: &Problem, masses: &[f64], constants: &[f64]) -> Vec<f64> {
        let mut potentials = vec![0.0; self.checks.len()];
        self.check_equations.apply(masses, &mut potentials);
        if let Some(given) = &self.given {
            potentials.iter_mut().zip(&given.at_checks).for_each(|(u, known)| *u += known);
        }
        let values = problem.source.values(&self.discretisation.boundary, &self.checks);
        let per_panel = self.checks.len() / self.discretisation.panels.len();
        let mut residuals = Vec::with_capacity(self.discretisation.panels.len());
        for (panels, &c) in self.discretisation.components.iter().zip(constants) {
            for q in panels.clone() {
                let checks = q * per_panel..(q + 1) * per_panel;
                let misses = checks.map(|i| (potentials[i] + c - values[i]).abs());
                residuals.push(misses.fold(0.0, |worst, r| if r > worst || r.is_nan() { r } else { worst }));
            }
        }
        residuals
    }
}

/// No iteration gets an equation below this.
const ROUNDING_PER_ENTRY: f64 = 2e-16;

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("System").field("unknowns", &self.discretisation.unknowns()).finish_non_exhaustive()
    }
}
