//! The map of a region with one hole onto a ring.

use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::super::polyline::polyline;
use super::canonical::{Canonical, Form, prepared};
use super::level_lines::LevelLine;
use super::solved::Solved;
use crate::plane::{Complex64, Domain};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::problem::Problem;
use crate::{Error, Result};
use std::f64::consts::TAU;

/// The conformal map of a region with one hole onto the ring 1 > |w| > ρ, the outer boundary going to |w| = 1 and `toward` to 1.
///
/// f(z) = e^{iφ} exp(∫ log(z − y) σ(y) ds), where ∫ log|x − y| σ + cⱼ = 0 on the boundary's two components, with total charge −1
/// on the outer one and 1 on the hole; log ρ = −c₁. G. T. Symm, *Conformal mapping of doubly-connected domains*, Numer. Math. 13
/// (1969).
///
/// ```
/// use conformal_warp::{AnnulusMap, Complex64, Curve, Domain, SolveOptions};
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(x, y)| Complex64::new(x, y));
/// let frame = Domain::new(&square(1.0), &[square(0.5).to_vec()], Curve::Polygon)?;
/// let map = AnnulusMap::solve(&frame, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((map.inner_radius() - 0.541_210_760_957_991).abs() < 1e-9);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct AnnulusMap {
    map: Canonical,
    log_inner_radius: f64,
    evidence: Evidence,
}

/// Lines of a ring.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RingLines {
    /// |w| is constant.
    Circles,
    /// arg w is constant, in radians.
    Rays,
}

impl AnnulusMap {
    /// Solves for the map. Without a `toward` the first boundary point goes to 1.
    ///
    /// # Errors
    /// [`Error::WrongRegion`] unless the domain has an outer boundary and one hole; [`Error::InvalidOption`],
    /// [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn solve(domain: &Domain, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let Some(boundary) = domain.boundary().filter(|_| domain.holes().len() == 1) else {
            let count = domain.holes().len();
            let found = if domain.is_bounded() { format!("{count} holes") } else { "no outer boundary".to_string() };
            return Err(Error::WrongRegion { what: "An annulus map", needed: "a region with one hole", found });
        };
        let problem = |_| vec![Problem::charged(vec![-1.0, 1.0])];
        let solved = Solved::solve(domain, &problem, options, progress)?;
        let field = solved.field(&[1.0]);
        // The outer constant would be 0 but for errors.
        let [outer, inner] = [0, 1].map(|k| field.constants()[k]);
        let toward = domain.toward().unwrap_or(boundary[0]);
        let angle = field.on_boundary(domain.nearest(toward)).0.im;
        let form = Form { factor: Complex64::ONE, shift: Complex64::new(outer, -angle), exponential: true, zero: None };
        Ok(Self {
            map: Canonical::new(field, form, (outer - inner, 0.0)),
            log_inner_radius: outer - inner,
            evidence: solved.evidence,
        })
    }

    /// The region.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.map.domain()
    }

    /// ρ: the radius of the ring's inner circle, the outer one having radius 1.
    #[must_use]
    pub fn inner_radius(&self) -> f64 {
        self.log_inner_radius.exp()
    }

    /// 1/ρ: the ratio of the ring's radii, outer to inner.
    #[must_use]
    pub fn modulus(&self) -> f64 {
        (-self.log_inner_radius).exp()
    }

    /// 2π/log(1/ρ): the capacity of the condenser whose plates are the hole and the outer boundary, in units of ε₀ a length.
    #[must_use]
    pub fn capacity(&self) -> f64 {
        -TAU / self.log_inner_radius
    }

    /// Region → ring. NaN outside the closed region.
    #[must_use]
    pub fn to_annulus(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Ring → region, the inverse of [`AnnulusMap::to_annulus`]. NaN outside the closed ring.
    #[must_use]
    pub fn from_annulus(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.place(w))
    }

    /// Lines of the region that go to circles of these radii, or rays at these angles, of the ring. A circle that does not lie in
    /// the ring has none.
    #[must_use]
    pub fn level_lines(&self, what: RingLines, levels: &[f64]) -> Vec<LevelLine> {
        let line = |&level: &f64| {
            let closed = what == RingLines::Circles;
            if closed && level <= 0.0 {
                return None;
            }
            let at = |t: f64| match what {
                RingLines::Circles => self.place(Complex64::from_polar(level, TAU * t)),
                RingLines::Rays => self.place(Complex64::from_polar((self.log_inner_radius * t).exp(), level)),
            };
            let points = polyline(64, &|t| at(t).map(|(z, _)| z))?;
            Some(LevelLine { level, points: if closed { points[1..].to_vec() } else { points }, closed })
        };
        levels.iter().filter_map(line).collect()
    }

    /// f' of the map region → ring, per plane unit. NaN outside the closed region; infinite at a re-entrant vertex.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }

    fn place(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        self.map.within(w, self.log_inner_radius, 0.0)
    }
}

evidence_methods!(AnnulusMap, "of log w anywhere in the region, so of w relative to its size.");
two_ways!(AnnulusMap, place);
prepared!(AnnulusMap);
