//! The map of a region with holes onto a disk with round holes.

use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::canonical::Canonical;
use super::circle::Circle;
use super::circle_search::matching;
use super::inverse_tree::Pair;
use super::round_picture::RoundPicture;
use super::slit_shapes::SlitShapes;
use crate::plane::{Complex64, Domain, DomainPoint, sort_by_number};
use crate::symm::options::{Progress, SolveOptions, Stop};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// What the region is solved to, at best.
const FINEST: f64 = 3e-13;
/// The region is first solved to this share of the tolerance.
const FIRST_SHARE: f64 = 0.1;
/// The estimate is so many times what was measured.
const SAFETY: f64 = 4.0;
/// Places on each edge at which the map is checked,
const CHECKS: usize = 4;
/// followed from the first by steps halved so often,
const MOST_HALVES: u32 = 7;
/// itself found from a few of these on the circle.
const STARTS: u32 = 256;
const CANDIDATES: usize = 4;
/// Pictures are not expected to agree better than this.
const LEAST_ERROR: f64 = 1e-13;
/// Images of the boundary may lie outside of what the other picture has there by this many times what is known of either's error.
const SLACK: f64 = 30.0;
/// Points as near to a circle as this lie on it.
const ON_CIRCLE: f64 = 1e-12;

/// The conformal map of a region with any number of holes onto the unit disk with round holes: the outer boundary goes to the unit
/// circle, the center to 0, `toward` to 1 (P. Koebe's circular domains).
///
/// Both the region and the disk with round holes are seen through the mean of their maps onto parallel slits, which has no slits
/// and determines the domain up to conformal maps. The circles are those for which both pictures agree.
///
/// ```
/// use conformal_warp::{CircleMap, Complex64, Curve, Domain, SolveOptions};
/// let square = |x: f64, half: f64| {
///     [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(a, b)| Complex64::new(x + a, b)).to_vec()
/// };
/// let windows = Domain::new(&square(0.0, 3.0), &[square(-1.5, 0.5), square(1.5, 0.5)], Curve::Polygon)?;
/// let map = CircleMap::solve(&windows.with_center(Complex64::ZERO)?, &SolveOptions::default(), &mut |_, _| true)?;
/// let [a, b] = [map.circles()[0], map.circles()[1]];
/// assert!((a.radius - b.radius).abs() < 1e-7, "equal by symmetry");
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CircleMap {
    map: Joined,
    evidence: Evidence,
}

#[derive(Clone, Debug)]
struct Joined {
    region: Canonical,
    /// The same of the disk with round holes.
    round: RoundPicture,
    /// The rotation that follows.
    turn: Complex64,
    /// So far from the circles images of the boundary may lie.
    slack: f64,
    circles: Vec<Circle>,
}

impl CircleMap {
    /// Solves for the map.
    ///
    /// # Errors
    /// [`Error::WrongRegion`] unless the domain has an outer boundary and a center; [`Error::InvalidOption`],
    /// [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn solve(domain: &Domain, options: &SolveOptions, progress: Progress) -> Result<Self> {
        options.validate()?;
        let mut inner = (FIRST_SHARE * options.tolerance).max(FINEST);
        let mut pictures = Pictures::solve(domain, inner, options, progress)?;
        while pictures.evidence.error_estimate > options.tolerance && pictures.could_be_better(inner) {
            inner = (0.3 * inner * options.tolerance / pictures.evidence.error_estimate).max(FINEST);
            pictures = Pictures::solve(domain, inner, options, progress)?;
        }
        let mut evidence = pictures.evidence;
        if evidence.error_estimate.is_nan() || evidence.error_estimate > 1.0 {
            return Err(Error::Inaccurate { estimate: evidence.error_estimate });
        }
        if evidence.error_estimate <= options.tolerance {
            evidence.stop = Stop::Tolerance;
        } else if evidence.stop == Stop::Tolerance {
            evidence.stop = Stop::Stagnation;
        }
        let toward = domain.toward().unwrap_or(domain.contours()[0].polygon().vertices()[0]);
        let there = domain.nearest(toward);
        let turn = pictures.image(there).map_or(Complex64::ONE, |there| there.z.conj() / there.z.norm());
        let Pictures { region, round, error, .. } = pictures;
        let turned = |circle: Circle| Circle { center: circle.center * turn, ..circle };
        let circles = (1..domain.contours().len()).map(|component| turned(round.circle(component))).collect();
        let slack = SLACK * evidence.error_estimate;
        let map = Joined { region: region.reaching(SLACK * error), round, turn, slack, circles };
        Ok(Self { map, evidence })
    }

    /// The region.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.map.region.domain()
    }

    /// The round holes, in the order of the region's.
    #[must_use]
    pub fn circles(&self) -> &[Circle] {
        &self.map.circles
    }

    /// Region → disk with round holes. NaN outside the closed region.
    #[must_use]
    pub fn to_circles(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Disk with round holes → region, the inverse of [`CircleMap::to_circles`]. NaN outside the closed disk and in the holes.
    #[must_use]
    pub fn from_circles(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.map.place(w))
    }

    /// f' of the map region → disk with round holes, per plane unit. NaN outside the closed region; infinite at a re-entrant
    /// vertex.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }

    /// Builds the evaluator now, both ways, instead of at its first use. `progress` as in solving.
    ///
    /// # Errors
    /// [`Error::Cancelled`]. What was finished by then is kept, and the map is as usable as before.
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        self.map.region.prepare(progress)?;
        self.map.round.prepare(progress)
    }
}

impl Joined {
    /// w → (z, dz/dw).
    fn place(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        let unturned = w * self.turn.conj();
        let outside = self.round.outside(unturned);
        // Written so that NaN is outside.
        if !unturned.is_finite() || outside.is_some_and(|(by, _)| by > ON_CIRCLE) {
            return None;
        }
        let (v, slope) = self.round.at(unturned);
        let is_on_circle = self.round.is_beside(unturned, ON_CIRCLE);
        let inside = if is_on_circle { None } else { self.region.inverse(v) };
        let is_beside = || is_on_circle || self.round.is_beside(unturned, self.slack);
        let found = inside.or_else(|| if is_beside() { self.region.inverse_on_boundary(v) } else { None });
        found.map(|(z, back)| (z, back * slope * self.turn.conj()))
    }
}

impl Pointwise for Joined {
    fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let (v, slope) = self.region.at(z)?;
        let (mut w, back) = self.round.inverse(v, self.slack)?;
        if let Some((_, nearest)) = self.round.outside(w) {
            w = nearest;
        } else if self.round.is_beside(w, self.slack)
            && let Some(point) = self.region.domain().on_boundary(z)
        {
            w = self.round.circle(point.component).nearest(w);
        }
        Some((w * self.turn, slope * back * self.turn))
    }
}

/// The region's picture, and that of the disk with round holes.
struct Pictures {
    region: Canonical,
    round: RoundPicture,
    /// They may differ by this.
    error: f64,
    /// The estimate is of w.
    evidence: Evidence,
}

impl Pictures {
    fn solve(domain: &Domain, tolerance: f64, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let options = SolveOptions { tolerance, ..options.clone() };
        let region = SlitShapes::solve(domain, &options, progress)?;
        let (circles, shapes, left) = matching(&region.circles, tolerance, progress)?;
        let error = region.evidence.error_estimate + shapes.error + left;
        let round = RoundPicture::new(shapes, circles.iter().map(|circle| circle.inverted()).collect());
        let mut pictures = Self { region: region.map, round, error, evidence: region.evidence };
        let (mismatch, stretch) = pictures.checked();
        pictures.evidence.error_estimate = SAFETY * (stretch * error + mismatch);
        Ok(pictures)
    }

    /// Whether solving to less than this may help.
    fn could_be_better(&self, tolerance: f64) -> bool {
        tolerance > FINEST && self.evidence.stop == Stop::Tolerance
    }

    fn value(&self, point: DomainPoint) -> Complex64 {
        self.region.value_on_boundary(point)
    }

    /// How far a point lies from the circle of a component.
    fn off(&self, pair: &Pair, component: usize) -> f64 {
        let circle = self.round.circle(component);
        ((pair.z - circle.center).norm() - circle.radius).abs()
    }

    /// What a point of the boundary goes to, up to errors.
    fn image(&self, point: DomainPoint) -> Option<Pair> {
        let (v, circle) = (self.value(point), self.round.circle(point.component));
        let start = |k: u32| circle.center + circle.radius * Complex64::cis(TAU * f64::from(k) / f64::from(STARTS));
        let mut starts: Vec<_> = (0..STARTS).map(start).map(|w| (w, (self.round.at(w).0 - v).norm())).collect();
        sort_by_number(&mut starts, |start| start.1);
        let found = starts.iter().take(CANDIDATES).filter_map(|(w, _)| self.round.newton(v, *w));
        found.min_by(|a, b| self.off(a, point.component).total_cmp(&self.off(b, point.component)))
    }

    /// What the place on a component goes to behind so many edges, from what another one, not far away, does.
    fn followed(&self, component: usize, (from, known): (f64, Pair), to: f64, halves: u32) -> Option<Pair> {
        let point = self.region.domain().place_along(component, to);
        let v = self.value(point);
        let found = self.round.newton(v, known.guess(v));
        let is_good = |pair: &Pair| self.off(pair, component) <= SLACK * self.error.max(LEAST_ERROR) * stretch(pair);
        if halves == 0 || found.as_ref().is_some_and(is_good) {
            return found;
        }
        let middle = 0.5 * (from + to);
        let between = self.followed(component, (from, known), middle, halves - 1)?;
        self.followed(component, (middle, between), to, halves - 1)
    }

    /// The largest distance from the circles of images of places on the boundary, and the largest stretch there; NaN if one is not
    /// found.
    fn checked(&self) -> (f64, f64) {
        let mut worst = (0.0, 1.0);
        for (component, contour) in self.region.domain().contours().iter().enumerate() {
            let place = |k: usize| (k as f64 + 0.37) / (CHECKS * contour.detail()) as f64;
            let mut last = self.image(self.region.domain().place_along(component, place(0)));
            for k in 0..contour.edge_count() * contour.detail() * CHECKS {
                let from = place(k.saturating_sub(1));
                last = last.and_then(|known| self.followed(component, (from, known), place(k), MOST_HALVES));
                let (miss, stretch) =
                    last.map_or((f64::NAN, f64::NAN), |pair| (self.off(&pair, component), stretch(&pair)));
                worst = (larger(worst.0, miss), larger(worst.1, stretch));
            }
        }
        worst
    }
}

/// By how much errors of 1/v are larger in w.
fn stretch(pair: &Pair) -> f64 {
    pair.slope.norm() * pair.key.norm_sqr()
}

/// The larger; NaN if one is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

evidence_methods!(CircleMap, "of w.");
two_ways!(CircleMap, map.place);
