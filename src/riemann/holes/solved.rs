//! Problems solved on a domain, whatever its boundary is made of.

use super::super::evidence::Evidence;
use super::field::DomainField;
use crate::plane::{Complex64, CurvedOutline, Domain, SmoothCurve};
use crate::symm::curved::discretisation::CurvedDiscretisation;
use crate::symm::curved::field::CurvedField;
use crate::symm::curved::solve::solve_curved_problems;
use crate::symm::field::Field;
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::panelled::Panelled;
use crate::symm::problem::{Problem, Source};
use crate::symm::smooth_field::SmoothField;
use crate::symm::smooth_solve::{SmoothAdapted, solve_smooth_problems};
use crate::symm::solve::{Adapted, solve_problems};
use crate::{Error, Result};
use std::sync::Arc;

/// The coordinates that problems are stated in: (z − origin) × unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Where they have their 0.
    pub origin: Complex64,
    /// A power of two.
    pub unit: f64,
}

impl Scale {
    /// Plane units → scaled units.
    #[must_use]
    pub fn scaled(self, z: Complex64) -> Complex64 {
        (z - self.origin) * self.unit
    }
}

/// Solutions of several problems on one domain.
#[derive(Debug)]
pub struct Solved {
    domain: Arc<Domain>,
    scale: Scale,
    solutions: Solutions,
    /// What the solve says of itself.
    pub evidence: Evidence,
}

#[derive(Debug)]
enum Solutions {
    Polygons(Adapted),
    Smooth(SmoothAdapted),
    /// With a point inside each component.
    Curved(Adapted<CurvedDiscretisation>, Vec<Complex64>),
}

fn evidence_of<D: Panelled>(adapted: &Adapted<D>) -> Evidence {
    let residuals = adapted.outcomes.iter().map(|outcome| outcome.residual());
    Evidence {
        residual: residuals.fold(0.0, f64::max),
        error_estimate: adapted.error_estimate,
        unknowns: adapted.system.discretisation.unknowns(),
        stop: adapted.stop,
    }
}

/// Estimates above this are none.
const WORST_ESTIMATE: f64 = 1.0;

impl Solved {
    /// Solves the problems that `problems` states, given the scale.
    ///
    /// # Errors
    /// [`Error::InvalidOption`], [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn solve(
        domain: &Domain,
        problems: &dyn Fn(Scale) -> Vec<Problem>,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Self> {
        let (origin, local) = domain.local();
        let curves: Option<Vec<Arc<SmoothCurve>>> =
            local.contours().iter().map(|contour| contour.smooth().cloned()).collect();
        let at = |unit: f64| problems(Scale { origin, unit });
        let chains: Option<Vec<&CurvedOutline>> =
            local.contours().iter().map(|contour| contour.curved().map(AsRef::as_ref)).collect();
        let (solutions, unit, evidence) = match (curves, chains) {
            (_, Some(outlines)) => {
                let adapted = solve_curved_problems(&outlines, local.is_bounded(), &at, options, progress)?;
                let unit = adapted.system.discretisation.boundary.unit;
                let evidence = evidence_of(&adapted);
                let inner_points = outlines.iter().map(|outline| outline.inner_point() * unit).collect();
                (Solutions::Curved(adapted, inner_points), unit, evidence)
            }
            (Some(curves), _) => {
                let adapted = solve_smooth_problems(curves, &at, options, progress)?;
                let evidence = Evidence {
                    residual: adapted.residual,
                    error_estimate: adapted.error_estimate,
                    unknowns: adapted.system.len(),
                    stop: adapted.stop,
                };
                let unit = adapted.system.unit;
                (Solutions::Smooth(adapted), unit, evidence)
            }
            (None, None) => {
                let adapted = solve_problems(&local, &|boundary| at(boundary.unit), options, progress)?;
                let evidence = evidence_of(&adapted);
                let unit = adapted.system.discretisation.boundary.unit;
                (Solutions::Polygons(adapted), unit, evidence)
            }
        };
        let estimate = evidence.error_estimate;
        if estimate.is_nan() || estimate > WORST_ESTIMATE {
            return Err(Error::Inaccurate { estimate });
        }
        Ok(Self { domain: Arc::new(domain.clone()), scale: Scale { origin, unit }, solutions, evidence })
    }

    /// The domain.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// The coordinates of the problems.
    #[must_use]
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// The constants cⱼ of problem `k`.
    #[must_use]
    pub fn constants(&self, k: usize) -> &[f64] {
        match &self.solutions {
            Solutions::Polygons(adapted) => &adapted.outcomes[k].constants,
            Solutions::Smooth(adapted) => &adapted.outcomes[k].constants,
            Solutions::Curved(adapted, _) => &adapted.outcomes[k].constants,
        }
    }

    /// The function B of a sum of problems, each with its weight.
    #[must_use]
    pub fn field(&self, weights: &[f64]) -> DomainField {
        let problems = match &self.solutions {
            Solutions::Polygons(adapted) => &adapted.problems,
            Solutions::Smooth(adapted) => &adapted.problems,
            Solutions::Curved(adapted, _) => &adapted.problems,
        };
        let used = problems.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
        let source = used.fold(Source::default(), |sum, (problem, weight)| sum.and(&problem.source, *weight));
        let sum = |part: &dyn Fn(usize) -> Vec<f64>| {
            let mut sum = part(0).iter().map(|x| x * weights[0]).collect::<Vec<f64>>();
            for (k, weight) in weights.iter().enumerate().skip(1) {
                sum.iter_mut().zip(part(k)).for_each(|(s, x)| *s += weight * x);
            }
            sum
        };
        let constants = sum(&|k| self.constants(k).to_vec());
        let field = match &self.solutions {
            Solutions::Polygons(adapted) => {
                let masses = sum(&|k| adapted.outcomes[k].masses.clone());
                super::field::Kind::Polygons(Field::new(&adapted.system, source, masses, constants))
            }
            Solutions::Smooth(adapted) => {
                let masses = sum(&|k| adapted.outcomes[k].masses.clone());
                let charges = sum(&|k| adapted.problems[k].charges.clone());
                let bounded = self.domain.is_bounded();
                let field = SmoothField::new(&adapted.system, bounded, source, charges, &masses, constants);
                super::field::Kind::Smooth(field)
            }
            Solutions::Curved(adapted, inner_points) => {
                let masses = sum(&|k| adapted.outcomes[k].masses.clone());
                let problem = Problem { source, charges: sum(&|k| adapted.problems[k].charges.clone()) };
                let discretisation = &adapted.system.discretisation;
                super::field::Kind::Curved(CurvedField::new(discretisation, problem, &masses, constants, inner_points))
            }
        };
        let Scale { origin, unit } = self.scale;
        DomainField::new(Arc::clone(&self.domain), origin, unit, field, self.evidence.error_estimate)
    }
}
