//! Maps of regions with any number of holes onto regions with slits.

use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::canonical::{Canonical, Form, prepared};
use super::field::DomainField;
use super::peak::peak;
use super::solved::{Scale, Solved};
use crate::plane::{Complex64, Domain};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::problem::{Problem, Source};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// Which region with slits a domain is mapped onto.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlitKind {
    /// The unit disk with circular slits: the outer boundary goes to the circle, the center to 0, `toward` to 1.
    Disk,
    /// A ring with circular slits: the outer boundary goes to the unit circle, this hole to the inner one, `toward` to 1.
    Annulus {
        /// The hole, counted from 0.
        hole: usize,
    },
    /// The plane with parallel slits at this angle to the real axis. The center goes to infinity, f(z) = 1/(z − center) + 0 +
    /// …; of the outside of bodies it is infinity itself, f(z) = z + 0 + ….
    Parallel {
        /// In radians, counter-clockwise.
        angle: f64,
    },
    /// The plane with slits on rays from 0: the center goes to 0, `pole` to infinity, `toward` to 1.
    Radial {
        /// A point inside.
        pole: Complex64,
    },
}

/// A slit: what a component of the boundary goes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slit {
    /// Its ends.
    pub ends: [Complex64; 2],
}

/// The conformal map of a domain onto a region with slits (Koebe's canonical regions), one solve each.
///
/// ```
/// use conformal_warp::{Complex64, Curve, Domain, SlitKind, SlitMap, SolveOptions};
/// let at = |x: f64, y: f64, half: f64| {
///     [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(a, b)| Complex64::new(x + a, y + b)).to_vec()
/// };
/// let windows = Domain::new(&at(0.0, 0.0, 3.0), &[at(-1.5, 0.0, 0.5), at(1.5, 0.0, 0.5)], Curve::Polygon)?;
/// let map = SlitMap::solve(&windows.with_center(Complex64::ZERO)?, SlitKind::Disk, &SolveOptions::default(), &mut |_, _| true)?;
/// let [a, b] = [map.slits()[0].ends[0], map.slits()[1].ends[0]];
/// assert!((a.norm() - b.norm()).abs() < 1e-7, "equal by symmetry");
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct SlitMap {
    map: Canonical,
    kind: SlitKind,
    slits: Vec<Slit>,
    evidence: Evidence,
}

impl SlitMap {
    /// Solves for the map of `kind`.
    ///
    /// # Errors
    /// [`Error::WrongRegion`] for a domain that has not what the kind needs; [`Error::CenterOutside`] for a pole outside;
    /// [`Error::InvalidOption`], [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn solve(domain: &Domain, kind: SlitKind, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let problem = problem_of(domain, kind)?;
        let solved = Solved::solve(domain, &|scale| vec![problem(scale)], options, progress)?;
        let field = solved.field(&[1.0]);
        let form = form_of(&field, solved.scale(), kind);
        let strip = strip_of(&field, kind);
        let map = Canonical::new(field, form, strip);
        let keys = slits(&map, kind);
        let end = |key: Complex64| if form.exponential { key.exp() } else { key };
        let slits = keys.iter().map(|ends| Slit { ends: ends.map(end) }).collect();
        let map = map.around(keys);
        Ok(Self { map, kind, slits, evidence: solved.evidence })
    }

    /// The domain.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.map.domain()
    }

    /// The kind.
    #[must_use]
    pub fn kind(&self) -> SlitKind {
        self.kind
    }

    /// What each component of the boundary goes to: the outer one first, if it becomes a slit, then the holes that do.
    #[must_use]
    pub fn slits(&self) -> &[Slit] {
        &self.slits
    }

    /// Domain → region with slits. NaN outside the closed domain.
    #[must_use]
    pub fn to_slits(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Region with slits → domain. Of a point on a slit, one of the two boundary points that go there.
    #[must_use]
    pub fn from_slits(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.place(w))
    }

    /// f' of the map domain → region with slits, per plane unit.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }

    fn place(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        match self.kind {
            SlitKind::Disk | SlitKind::Annulus { .. } => {
                let (low, high) = strip_of(self.map.field(), self.kind);
                self.map.within(w, low, high)
            }
            SlitKind::Parallel { .. } | SlitKind::Radial { .. } => self.map.inverse(w),
        }
    }
}

/// Between what log|w| lies; of parallel slits, Re w.
fn strip_of(field: &DomainField, kind: SlitKind) -> (f64, f64) {
    let constants = field.constants();
    match kind {
        SlitKind::Disk => (f64::NEG_INFINITY, 0.0),
        SlitKind::Annulus { hole } => (constants[0] - constants[hole + 1], 0.0),
        SlitKind::Parallel { .. } | SlitKind::Radial { .. } => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

/// What a domain must have for a kind, and the problem to be solved.
fn problem_of(domain: &Domain, kind: SlitKind) -> Result<Box<dyn Fn(Scale) -> Problem>> {
    let wrong = |needed, found: String| Err(Error::WrongRegion { what: "A slit map of this kind", needed, found });
    let (count, holes) = (domain.contours().len(), domain.holes().len());
    let mut charges = vec![0.0; count];
    match kind {
        SlitKind::Disk | SlitKind::Annulus { .. } if !domain.is_bounded() => {
            wrong("an outer boundary", "none".to_string())
        }
        SlitKind::Disk => {
            let Some(center) = domain.center() else { return wrong("a center", "none".to_string()) };
            charges[0] = 1.0;
            Ok(Box::new(move |scale| Problem { source: Source::log(scale.scaled(center)), charges: charges.clone() }))
        }
        SlitKind::Annulus { hole } => {
            if hole >= holes {
                return wrong("the hole that is named, counted from 0", format!("{holes} holes"));
            }
            (charges[0], charges[hole + 1]) = (-1.0, 1.0);
            Ok(Box::new(move |_| Problem::charged(charges.clone())))
        }
        SlitKind::Parallel { angle } => {
            let factor = Complex64::new(0.0, 1.0) * Complex64::cis(-angle);
            if !domain.is_bounded() {
                return Ok(Box::new(move |_| Problem { source: Source::stream(factor), charges: charges.clone() }));
            }
            let Some(center) = domain.center() else { return wrong("a center", "none".to_string()) };
            Ok(Box::new(move |scale| Problem {
                source: Source::pole(scale.scaled(center), factor),
                charges: charges.clone(),
            }))
        }
        SlitKind::Radial { pole } => {
            let Some(center) = domain.center() else { return wrong("a center", "none".to_string()) };
            if !pole.is_finite() {
                return Err(Error::NotFinite { what: "The pole".to_string() });
            }
            if pole == center {
                return wrong("a pole that is not the center", "one point for both".to_string());
            }
            domain.clone().with_center(pole)?;
            Ok(Box::new(move |scale| Problem {
                source: Source::vortices(scale.scaled(center), scale.scaled(pole)),
                charges: charges.clone(),
            }))
        }
    }
}

/// The map as a function of B.
fn form_of(field: &DomainField, scale: Scale, kind: SlitKind) -> Form {
    let domain = field.domain();
    let toward = domain.toward().unwrap_or(domain.contours()[0].polygon().vertices()[0]);
    let there = field.on_boundary(domain.nearest(toward)).0;
    match kind {
        SlitKind::Disk => {
            let shift = Complex64::new(-field.constants()[0], there.im);
            Form { factor: -Complex64::ONE, shift, exponential: true, zero: domain.center() }
        }
        SlitKind::Annulus { .. } => {
            let shift = Complex64::new(field.constants()[0], -there.im);
            Form { factor: Complex64::ONE, shift, exponential: true, zero: None }
        }
        SlitKind::Radial { .. } => {
            let factor = Complex64::i();
            Form { factor, shift: -factor * there, exponential: true, zero: domain.center() }
        }
        SlitKind::Parallel { angle } => {
            let turn = Complex64::i() * Complex64::cis(angle);
            if !domain.is_bounded() {
                let factor = turn / scale.unit;
                // L vanishes at infinity: what is lacking is the origin of the scaled units.
                return Form { factor, shift: scale.origin, exponential: false, zero: None };
            }
            let factor = turn * scale.unit;
            let center = domain.center().unwrap_or(scale.origin);
            let shift = -regular_part(field, factor, center);
            Form { factor, shift, exponential: false, zero: None }
        }
    }
}

/// The value at `center` of factor·B − 1/(z − center): its mean over a circle.
fn regular_part(field: &DomainField, factor: Complex64, center: Complex64) -> Complex64 {
    const POINTS: u32 = 16;
    let radius = 0.1 * (field.domain().nearest(center).place.point - center).norm();
    let turns = (0..POINTS).map(|k| Complex64::from_polar(radius, TAU * f64::from(k) / f64::from(POINTS)));
    let parts = turns.filter_map(|turn| Some(factor * field.at(center + turn)?.0 - turn.inv()));
    parts.sum::<Complex64>() / f64::from(POINTS)
}

/// The keys of the ends of the slits that components go to.
fn slits(map: &Canonical, kind: SlitKind) -> Vec<[Complex64; 2]> {
    let is_slit = |component: usize| match kind {
        SlitKind::Disk => component > 0,
        SlitKind::Annulus { hole } => component > 0 && component != hole + 1,
        SlitKind::Parallel { .. } | SlitKind::Radial { .. } => true,
    };
    let count = map.domain().contours().len();
    (0..count).filter(|&component| is_slit(component)).map(|component| slit(map, component)).collect()
}

/// Im B goes up and down once around a slit: its ends are the extremes.
fn slit(map: &Canonical, component: usize) -> [Complex64; 2] {
    let point = |place: f64| map.domain().place_along(component, place);
    let contour = &map.domain().contours()[component];
    let extreme = |sign: f64| {
        const SAMPLES: usize = 16;
        let samples = SAMPLES * contour.detail();
        let places = (0..contour.edge_count() * samples).map(|k| k as f64 / samples as f64);
        let value = |place: f64| sign * map.field().on_boundary(point(place)).0.im;
        let best = places.max_by(|a, b| value(*a).total_cmp(&value(*b))).unwrap_or(0.0);
        map.key_on_boundary(point(peak(&value, best - 1.0 / samples as f64, best + 1.0 / samples as f64))).0
    };
    [extreme(1.0), extreme(-1.0)]
}

evidence_methods!(SlitMap, "of log w; of parallel slits, of w in units of the domain's size or its inverse.");
two_ways!(SlitMap, place);
prepared!(SlitMap);
