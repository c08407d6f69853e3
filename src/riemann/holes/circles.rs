//! The map of a region with holes onto a disk with round holes.

use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::canonical::Canonical;
use super::circle::{Circle, UNIT};
use super::slit_shapes::SlitShapes;
use crate::plane::{Complex64, Curve, Domain};
use crate::symm::options::{Progress, SolveOptions, Stop};
use crate::{Error, Result};

/// Steps to find the circles.
const MOST_STEPS: usize = 60;
/// The circles are known to this share of the tolerance.
const SHARE: f64 = 0.05;
/// Before, solves are as good as this share of what is lacking.
const ROUGH: f64 = 1e-3;
/// Steps that do not come nearer end the search.
const PATIENCE: usize = 6;
/// Places on each edge at which the map is checked.
const CHECKS: usize = 4;
/// Images of the boundary may lie outside of what the other picture has there by this many times what is known of either's error.
const SLACK: f64 = 30.0;
/// Images as near to a circle as this may belong to the boundary.
const NEAR_CIRCLE: f64 = 1e-9;

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
    round: Canonical,
    /// The rotation that follows.
    turn: Complex64,
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
        let finer = SolveOptions { tolerance: (0.1 * options.tolerance).max(1e-14), ..options.clone() };
        let region = SlitShapes::solve(domain, &finer, progress)?;
        let (circles, round, left) = matching(&region.circles, &finer, progress)?;
        let mut evidence = region.evidence;
        let slack = SLACK * (evidence.error_estimate + round.evidence.error_estimate + left);
        let [region, round_map] = [region.map, round.map].map(|map| map.reaching(slack));
        let circles = circles.iter().map(|circle| circle.inverted()).collect();
        let mut map = Joined { region, round: round_map, turn: Complex64::ONE, circles };
        let toward = domain.toward().unwrap_or(domain.contours()[0].polygon().vertices()[0]);
        let there = map.value(toward).unwrap_or(Complex64::ONE);
        map.turn = there.conj() / there.norm();
        map.circles.iter_mut().for_each(|circle| circle.center *= map.turn);
        let (mismatch, stretch) = map.checked();
        evidence.error_estimate = stretch * (evidence.error_estimate + round.evidence.error_estimate + left) + mismatch;
        if evidence.error_estimate.is_nan() || evidence.error_estimate > 1.0 {
            return Err(Error::Inaccurate { estimate: evidence.error_estimate });
        }
        if evidence.error_estimate <= options.tolerance {
            evidence.stop = Stop::Tolerance;
        } else if evidence.stop == Stop::Tolerance {
            evidence.stop = Stop::Stagnation;
        }
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
    /// The circle that a component goes to.
    fn circle(&self, component: usize) -> Circle {
        component.checked_sub(1).map_or(UNIT, |hole| self.circles[hole])
    }

    /// The circle that a point may belong to.
    fn near_circle(&self, w: Complex64) -> Option<Circle> {
        let near = |circle: &Circle| ((w - circle.center).norm() - circle.radius).abs() < NEAR_CIRCLE;
        (0..=self.circles.len()).map(|k| self.circle(k)).find(near)
    }

    /// w → (z, dz/dw).
    fn place(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        let unturned = w * self.turn.conj();
        let (v, slope) = self.round.at(unturned)?;
        let on_circle = self.near_circle(w).is_some() && self.round.domain().on_boundary(unturned).is_some();
        let found = if on_circle { self.region.inverse_on_boundary(v) } else { self.region.inverse(v) };
        found.map(|(z, back)| (z, back * slope * self.turn.conj()))
    }

    /// The largest distance, at places on the boundary, between what the two pictures say, and the largest stretch from them to the
    /// disk.
    fn checked(&self) -> (f64, f64) {
        let domain = self.region.domain();
        let mut worst = (0.0, 1.0);
        for (component, contour) in domain.contours().iter().enumerate() {
            for k in 0..contour.polygon().len() * CHECKS {
                let z = domain.point_along(component, (k as f64 + 0.37) / CHECKS as f64);
                let z = domain.nearest(z).place.point;
                let found = self.at(z).and_then(|(w, _)| {
                    let round = self.round.at(w * self.turn.conj())?;
                    Some(((self.region.value(z)? - round.0) / round.1, round.1))
                });
                let (miss, stretch) =
                    found.map_or((f64::NAN, f64::NAN), |(miss, slope)| (miss.norm(), slope.norm().recip()));
                worst = (larger(worst.0, miss), larger(worst.1, stretch));
            }
        }
        worst
    }
}

/// The larger; NaN if one is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

impl Pointwise for Joined {
    fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let (v, slope) = self.region.at(z)?;
        let (mut w, back) = self.round.inverse(v).or_else(|| self.round.inverse_on_boundary(v))?;
        w *= self.turn;
        if self.near_circle(w).is_some()
            && let Some(point) = self.region.domain().on_boundary(z)
        {
            w = self.circle(point.component).nearest(w);
        }
        Some((w, slope * back * self.turn))
    }
}

/// The round holes whose picture is the one given, that picture, and by how much it differs.
fn matching(given: &[Circle], options: &SolveOptions, progress: Progress) -> Result<(Vec<Circle>, SlitShapes, f64)> {
    // They are looked for in the plane of 1/w, where the given ones are.
    let mut circles = apart(given);
    let mut search = Search::default();
    let mut best: Option<(Vec<Circle>, SlitShapes, f64)> = None;
    let mut idle = 0;
    for step in 0..MOST_STEPS {
        if !progress("circles", step as f64 / MOST_STEPS as f64) {
            return Err(Error::Cancelled);
        }
        let far = best.as_ref().map_or(1.0, |(.., left)| ROUGH * left);
        let rough = SolveOptions { tolerance: options.tolerance.max(far.min(ROUGH)), ..options.clone() };
        let shapes = SlitShapes::solve(&disk_with(&circles)?, &rough, &mut |_, _| {
            progress("circles", step as f64 / MOST_STEPS as f64)
        })?;
        let lacking: Vec<f64> = numbers(given).iter().zip(numbers(&shapes.circles)).map(|(a, b)| a - b).collect();
        let left = lacking.iter().fold(0.0, |most, x| larger(most, x.abs()));
        let change = search.next(lacking);
        let better = best.as_ref().is_none_or(|(.., least)| left < *least);
        idle = if better { 0 } else { idle + 1 };
        let from = circles.clone();
        if better {
            best = Some((circles, shapes, left));
        }
        if left <= SHARE * options.tolerance && rough.tolerance <= options.tolerance || idle > PATIENCE {
            break;
        }
        circles = search.moved(&from, change);
    }
    best.ok_or(Error::Inaccurate { estimate: f64::INFINITY })
}

/// The unit disk with round holes, by their inverses.
fn disk_with(circles: &[Circle]) -> Result<Domain> {
    let holes: Vec<_> = circles.iter().map(|circle| circle.inverted().points()).collect();
    Domain::new(&UNIT.points(), &holes, Curve::Smooth)?.with_center(Complex64::ZERO)
}

/// What round holes are: center and radius of each.
fn numbers(circles: &[Circle]) -> Vec<f64> {
    circles.iter().flat_map(|circle| [circle.center.re, circle.center.im, circle.radius]).collect()
}

/// Whether their inverses lie in the disk and apart, 0 outside all of them.
fn are_apart(circles: &[Circle]) -> bool {
    let circles: Vec<Circle> = circles.iter().map(|circle| circle.inverted()).collect();
    circles.iter().enumerate().all(|(k, a)| {
        let distance = a.center.norm();
        let clear = |b: &Circle| (a.center - b.center).norm() > a.radius + b.radius;
        a.radius > 0.0 && distance + a.radius < 1.0 && distance > a.radius && circles[..k].iter().all(clear)
    })
}

/// The same centers with smaller radii, if these are too large to begin with.
fn apart(circles: &[Circle]) -> Vec<Circle> {
    let smaller =
        |k: i32| circles.iter().map(|c| Circle { radius: c.radius * 0.8f64.powi(k), ..*c }).collect::<Vec<_>>();
    (0..40).map(smaller).find(|circles| are_apart(circles)).unwrap_or_else(|| smaller(40))
}

/// Broyden's method for what is lacking, the identity being near to the derivative: C. T. Kelley, *Iterative Methods for Linear and
/// Nonlinear Equations* (1995), section 7.3.
#[derive(Default)]
struct Search {
    steps: Vec<Vec<f64>>,
}

impl Search {
    /// The step that follows from what is lacking now.
    fn next(&mut self, mut lacking: Vec<f64>) -> Vec<f64> {
        for pair in self.steps.windows(2) {
            let share = dot(&pair[0], &lacking) / dot(&pair[0], &pair[0]);
            add(&mut lacking, share, &pair[1]);
        }
        if let Some(last) = self.steps.last() {
            let share = 1.0 - dot(last, &lacking) / dot(last, last);
            lacking.iter_mut().for_each(|x| *x /= share);
        }
        lacking
    }

    /// The circles after a step, which is shortened, and what was learnt forgotten, where they would not be apart.
    fn moved(&mut self, circles: &[Circle], mut step: Vec<f64>) -> Vec<Circle> {
        for _ in 0..MOST_STEPS {
            let moved: Vec<Circle> = circles
                .iter()
                .zip(step.chunks_exact(3))
                .map(|(circle, by)| Circle {
                    center: circle.center + Complex64::new(by[0], by[1]),
                    radius: circle.radius + by[2],
                })
                .collect();
            if are_apart(&moved) {
                self.steps.push(step);
                return moved;
            }
            self.steps.clear();
            step.iter_mut().for_each(|x| *x *= 0.5);
        }
        circles.to_vec()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn add(sum: &mut [f64], factor: f64, term: &[f64]) {
    sum.iter_mut().zip(term).for_each(|(sum, x)| *sum += factor * x);
}

evidence_methods!(CircleMap, "of w.");
two_ways!(CircleMap, map.place);
