//! The map of the outside of a body onto the outside of the disk.

use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::canonical::{Canonical, Form, prepared};
use super::solved::Solved;
use crate::plane::{Complex64, Domain};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::problem::Problem;
use crate::{Error, Result};

/// The conformal map of the outside of one body onto the outside of the unit disk, infinity staying where it is.
///
/// f(z) = e^{iφ} exp(∫ log(z − y) σ(y) ds + c), where ∫ log|x − y| σ + c = 0 on the boundary and ∫ σ = 1: Symm's equation of
/// the exterior. f(z) ~ z/capacity far away.
///
/// ```
/// use conformal_warp::{Complex64, Curve, Domain, ExteriorMap, SolveOptions};
/// let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let outside = Domain::exterior(&[square.to_vec()], Curve::Polygon)?;
/// let map = ExteriorMap::solve(&outside, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((map.capacity() - 0.590_170_299_508_048).abs() < 1e-9);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ExteriorMap {
    map: Canonical,
    capacity: f64,
    evidence: Evidence,
}

impl ExteriorMap {
    /// Solves for the map. `toward` goes to 1; without one, directions far away are kept: f' > 0 at infinity.
    ///
    /// # Errors
    /// [`Error::WrongRegion`] unless the domain is the outside of one body; [`Error::InvalidOption`],
    /// [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn solve(domain: &Domain, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let count = domain.holes().len();
        if domain.is_bounded() || count != 1 {
            let found = if domain.is_bounded() { "an outer boundary".to_string() } else { format!("{count} bodies") };
            return Err(Error::WrongRegion { what: "An exterior map", needed: "the outside of one body", found });
        }
        let solved = Solved::solve(domain, &|_| vec![Problem::charged(vec![1.0])], options, progress)?;
        let field = solved.field(&[1.0]);
        let constant = field.constants()[0];
        let angle = domain.toward().map_or(0.0, |toward| field.on_boundary(domain.nearest(toward)).0.im);
        let form =
            Form { factor: Complex64::ONE, shift: Complex64::new(constant, -angle), exponential: true, zero: None };
        let capacity = (-constant).exp() / solved.scale().unit;
        Ok(Self { map: Canonical::new(field, form, (0.0, f64::INFINITY)), capacity, evidence: solved.evidence })
    }

    /// The outside of the body.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.map.domain()
    }

    /// 1/|f'(∞)|: the body's logarithmic capacity, or outer radius, in plane units.
    #[must_use]
    pub fn capacity(&self) -> f64 {
        self.capacity
    }

    /// Outside of the body → outside of the disk. NaN inside the body.
    #[must_use]
    pub fn to_exterior(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Outside of the disk → outside of the body, the inverse of [`ExteriorMap::to_exterior`]. NaN inside the disk.
    #[must_use]
    pub fn from_exterior(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.place(w))
    }

    /// f' of the map body's outside → disk's outside, per plane unit.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }

    fn place(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        self.map.within(w, 0.0, f64::INFINITY)
    }
}

evidence_methods!(ExteriorMap, "of log w anywhere, so of w relative to its size.");
two_ways!(ExteriorMap, place);
prepared!(ExteriorMap);
