//! Symm's linear system, ready to be solved for any right-hand side.

use super::discretisation::Discretisation;
use super::fast_multipole::FastInfluence;
use super::gmres::gmres;
use super::influence::{DenseInfluence, Influence};
use super::known::Known;
use super::lu::Lu;
use super::options::Progress;
use super::panelled::Panelled;
use super::problem::Problem;
use super::refinement::{Refinable, Refinement};
use super::rule::Rules;
use super::two_level::{self, TwoLevel};
use crate::Result;
use std::fmt;
use std::ops::{Deref, Range};
use std::sync::{Arc, OnceLock};

/// Panels with their equations.
pub struct System<D = Discretisation> {
    /// The panels.
    pub discretisation: Arc<D>,
    equations: SystemEquations,
}

/// The matrix and its (approximate) inverse: one constant and one total mass a component border it.
pub struct SystemEquations {
    discretisation: Arc<dyn Panelled>,
    /// The unknowns of each component.
    components: Vec<Range<usize>>,
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

    fn bytes(&self) -> usize {
        match self {
            Self::Dense(dense) => dense.bytes(),
            Self::Fast(fast) => fast.bytes(),
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

impl<D: Panelled + 'static> System<D> {
    /// Assembles and factors what the size asks for.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn new(discretisation: impl Into<Arc<D>>, progress: Progress) -> Result<Self> {
        Self::after(None, discretisation.into(), progress)
    }

    /// The system in `kept`; if there is none, it is assembled and kept there.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn kept_in(kept: &OnceLock<Arc<Self>>, discretisation: &Arc<D>, progress: Progress) -> Result<Arc<Self>> {
        if let Some(system) = kept.get() {
            return Ok(Arc::clone(system));
        }
        let system = Arc::new(Self::new(Arc::clone(discretisation), progress)?);
        // If another thread was first, its is the same.
        Ok(Arc::clone(kept.get_or_init(|| system)))
    }

    fn after(before: Option<Before>, discretisation: Arc<D>, progress: Progress) -> Result<Self> {
        let equations = SystemEquations::new(Arc::<D>::clone(&discretisation), before, progress)?;
        Ok(Self { discretisation, equations })
    }

    /// The same equations, with a known measure on panels that are not among those solved for.
    #[must_use]
    pub fn with_known(self, known: &Arc<Known>) -> Self {
        Self { equations: self.equations.with_known(known), ..self }
    }

    /// The system of refined panels, which takes over what concerns panels that were kept.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn refined(self: Arc<Self>, mut refinement: Refinement, rules: &mut Rules, progress: Progress) -> Result<Self>
    where
        D: Refinable,
    {
        let known = self.equations.given.as_ref().map(|given| Arc::clone(&given.known));
        let discretisation = self.discretisation.refined(&mut refinement, rules, progress)?;
        // What is not needed any more makes room for what comes, unless somebody else holds the system.
        let (equations, checks, inverse) = match Arc::try_unwrap(self) {
            Ok(old) => (old.equations.equations, old.equations.check_equations, old.equations.inverse),
            Err(shared) => {
                let old = &shared.equations;
                (Arc::clone(&old.equations), Arc::clone(&old.check_equations), Arc::clone(&old.inverse))
            }
        };
        let before = Before { refinement, equations, checks, inverse };
        let refined = Self::after(Some(before), Arc::new(discretisation), progress)?;
        Ok(match known {
            Some(known) => refined.with_known(&known),
            None => refined,
        })
    }
}

impl<D> Deref for System<D> {
    type Target = SystemEquations;

    fn deref(&self) -> &SystemEquations {
        &self.equations
    }
}

impl SystemEquations {
    fn new(discretisation: Arc<dyn Panelled>, before: Option<Before>, progress: Progress) -> Result<Self> {
        let Assembled { equations, checks, inverse } = assemble(discretisation.as_ref(), before, progress)?;
        Ok(Self {
            components: discretisation.unknowns_of_components(),
            discretisation,
            equations: Arc::new(equations),
            check_equations: Arc::new(checks),
            inverse: Arc::new(inverse),
            given: None,
        })
    }

    /// Bytes of memory that its entries take, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.equations.bytes() + self.check_equations.bytes()
    }

    fn with_known(self, known: &Arc<Known>) -> Self {
        let at = |taus: Vec<f64>| known.potentials(&self.discretisation.points(&taus));
        let (at_targets, at_checks) = (at(self.discretisation.node_taus()), at(self.discretisation.check_taus()));
        Self { given: Some(Given { known: Arc::clone(known), at_targets, at_checks }), ..self }
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
        let nodes = self.discretisation.targets(&self.discretisation.node_taus());
        let mut rhs = self.discretisation.values(&problem.source, &nodes);
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
        // The branch of arguments may differ from that at infinity.
        let is_zero = self.discretisation.is_bounded() && problem.source.turning().next().is_none();
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
        let p = self.discretisation.order().p();
        let edge = |i: usize| self.discretisation.panel(i / p).edge;
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
        let checks = self.discretisation.targets(&self.discretisation.check_taus());
        let mut potentials = vec![0.0; checks.len()];
        self.check_equations.apply(masses, &mut potentials);
        if let Some(given) = &self.given {
            potentials.iter_mut().zip(&given.at_checks).for_each(|(u, known)| *u += known);
        }
        let values = self.discretisation.values(&problem.source, &checks);
        let panels = self.discretisation.panel_count();
        let per_panel = checks.len() / panels;
        let mut residuals = Vec::with_capacity(panels);
        for (panels, &c) in self.discretisation.components().iter().zip(constants) {
            for q in panels.clone() {
                let checks = q * per_panel..(q + 1) * per_panel;
                let misses = checks.map(|i| (potentials[i] + c - values[i]).abs());
                residuals.push(misses.fold(0.0, |worst, r| if r > worst || r.is_nan() { r } else { worst }));
            }
        }
        residuals
    }
}

/// What was assembled for the panels before.
struct Before {
    refinement: Refinement,
    equations: Arc<Equations>,
    checks: Arc<Equations>,
    inverse: Arc<Inverse>,
}

struct Assembled {
    equations: Equations,
    checks: Equations,
    inverse: Inverse,
}

/// Equations and inverse as the size asks for; what concerns panels that were kept is taken over.
fn assemble(discretisation: &dyn Panelled, before: Option<Before>, progress: Progress) -> Result<Assembled> {
    let n = discretisation.unknowns();
    let (nodes, checks) = (discretisation.node_taus(), discretisation.check_taus());
    let (refinement, [old_equations, old_checks], old_inverse) = match before {
        Some(old) => (Some(old.refinement), [Some(old.equations), Some(old.checks)], Some(old.inverse)),
        None => (None, [None, None], None),
    };
    if n <= DENSE_UP_TO {
        let dense = |old: Option<Arc<Equations>>, taus: &[f64], progress: Progress| {
            let old = match (old.as_deref(), &refinement) {
                (Some(Equations::Dense(old)), Some(refinement)) => Some((old, refinement)),
                _ => None,
            };
            DenseInfluence::new(discretisation, taus, old, progress)
        };
        let equations = dense(old_equations, &nodes, progress)?;
        let inverse = if n <= FACTOR_UP_TO {
            let components = discretisation.unknowns_of_components();
            Inverse::Exact(Lu::new(n + components.len(), equations.bordered(&components)))
        } else {
            Inverse::TwoLevel(TwoLevel::new(
                discretisation,
                &|members| equations.block(members, nodes.len()),
                progress,
            )?)
        };
        let checks = dense(old_checks, &checks, progress)?;
        return Ok(Assembled { equations: Equations::Dense(equations), checks: Equations::Dense(checks), inverse });
    }
    let local = |members: &[usize]| two_level::local_matrix(discretisation, members);
    let refined = match (old_inverse.as_deref(), old_equations.as_deref(), &refinement) {
        (Some(Inverse::TwoLevel(old)), Some(Equations::Fast(_)), Some(refinement)) => {
            old.refined(refinement, discretisation, &local, progress)?
        }
        _ => None,
    };
    drop(old_inverse);
    let inverse = Inverse::TwoLevel(refined.map_or_else(|| TwoLevel::new(discretisation, &local, progress), Ok)?);
    let fast = |old: Option<Arc<Equations>>, taus: &[f64], progress: Progress| match (old.as_deref(), &refinement) {
        (Some(Equations::Fast(old)), Some(refinement)) => old.refined(refinement, discretisation, taus, progress),
        _ => FastInfluence::new(discretisation, taus, discretisation.order().digits, progress),
    };
    let equations = Equations::Fast(fast(old_equations, &nodes, progress)?);
    let checks = Equations::Fast(fast(old_checks, &checks, progress)?);
    Ok(Assembled { equations, checks, inverse })
}

/// No iteration gets an equation below this.
const ROUNDING_PER_ENTRY: f64 = 2e-16;

impl<D> fmt::Debug for System<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("System").field("unknowns", &self.equations.discretisation.unknowns()).finish_non_exhaustive()
    }
}
