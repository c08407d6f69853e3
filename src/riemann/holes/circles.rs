//! The map of a region with holes onto the disk with round holes.

use super::super::evidence::{Evidence, evidence_methods};
use super::canonical::places;
use super::slits::{SlitEnds, SlitKind, SlitMap};
use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap, pointwise};
use crate::plane::{Complex64, Curve, Domain, DomainPoint};
use crate::symm::options::{Progress, SolveOptions};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// A round hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its center.
    pub center: Complex64,
    /// Its radius.
    pub radius: f64,
}

/// The conformal map of a region with holes onto the unit disk with round holes (Koebe's circular domain): the outer boundary
/// goes to the unit circle, the center to 0, `toward` to 1.
///
/// A region and its circular image have one and the same map onto the disk with circular slits. The circles are moved until the
/// slits of their domain are those of the region (Broyden's method on three numbers a hole; each step is one solve with round
/// holes); then the map is one slit map undone after the other. Where a slit ends, a map onto radial slits takes over.
///
/// ```
/// use conformal_warp::{CircleMap, Complex64, Curve, Domain, SolveOptions};
/// let at = |x: f64, y: f64, half: f64| {
///     [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(a, b)| Complex64::new(x + a, y + b)).to_vec()
/// };
/// let windows = Domain::new(&at(0.0, 0.0, 3.0), &[at(-1.5, 0.0, 0.5), at(1.5, 0.0, 0.5)], Curve::Polygon)?;
/// let map = CircleMap::solve(&windows.with_center(Complex64::ZERO)?, &SolveOptions::default(), &mut |_, _| true)?;
/// let [a, b] = [map.circles()[0], map.circles()[1]];
/// assert!((a.radius - b.radius).abs() < 1e-7 && (a.center + b.center).norm() < 1e-7, "equal by symmetry");
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct CircleMap {
    circles: Vec<Circle>,
    /// Region → slits and circular domain → slits: circular slits, then radial ones.
    pairs: [[SlitMap; 2]; 2],
    evidence: Evidence,
}

/// Points of the circles.
const OUTER_POINTS: u32 = 64;
const HOLE_POINTS: u32 = 32;
/// Steps of Broyden's method.
const MOST_STEPS: usize = 80;
/// Halvings of a step that makes circles meet.
const MOST_HALVINGS: usize = 30;
/// Steps without progress that end it.
const PATIENCE: usize = 6;
/// What slits agree to at best.
const ROUNDING: f64 = 2e-15;
/// Slits that differ by more have not been found.
const FOUND: f64 = 1e-2;

impl CircleMap {
    /// Solves for the map. `progress` hears of the region's solves and then the stage "circles".
    ///
    /// # Errors
    /// [`Error::WrongRegion`] unless the domain has an outer boundary, a hole and a center; [`Error::InvalidOption`],
    /// [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn solve(domain: &Domain, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let center = checked(domain)?;
        let region = SlitMap::solve(domain, SlitKind::Disk, options, progress)?;
        let own = SolveOptions { tolerance: (0.1 * options.tolerance).max(1e-14), ..options.clone() };
        let (circles, round, off) = find(&region, &own, progress)?;
        let first = [region, round];
        // Radial slits on both sides: the pole goes where circular slits take it.
        let pole = pole_of(domain, center);
        let (image, _) =
            carry(std::slice::from_ref(&first), 0, pole).ok_or(Error::Inaccurate { estimate: f64::INFINITY })?;
        let second = [
            SlitMap::solve(domain, SlitKind::Radial { pole }, options, progress)?,
            SlitMap::solve(first[1].domain(), SlitKind::Radial { pole: image }, &own, progress)?,
        ];
        let pairs = [first, second];
        let evidence = evidence_of(&pairs, off)?;
        Ok(Self { circles, pairs, evidence })
    }

    /// The region.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.pairs[0][0].domain()
    }

    /// The round holes, in the order of the region's.
    #[must_use]
    pub fn circles(&self) -> &[Circle] {
        &self.circles
    }

    /// Region → disk with round holes. NaN outside the closed region.
    #[must_use]
    pub fn to_circles(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, &|z| carry(&self.pairs, 0, z))
    }

    /// Disk with round holes → region, the inverse of [`CircleMap::to_circles`]. NaN outside, and inside the holes.
    #[must_use]
    pub fn from_circles(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, &|w| carry(&self.pairs, 1, w))
    }

    /// f' of the map region → disk with round holes, per plane unit.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        let nowhere = Complex64::new(f64::NAN, f64::NAN);
        points.iter().map(|&z| carry(&self.pairs, 0, z).map_or(nowhere, |(_, slope)| slope)).collect()
    }
}

evidence_methods!(CircleMap, "of w anywhere in the region, the disk having radius 1.");

impl PlaneMap for CircleMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |z| carry(&self.pairs, 0, z).map(|(w, slope)| Jet::analytic(w, slope)));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for CircleMap {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |w| carry(&self.pairs, 1, w).map(|(z, slope)| Jet::analytic(z, slope)));
    }
}

/// The center of a domain that can be mapped.
fn checked(domain: &Domain) -> Result<Complex64> {
    let wrong = |needed, found: &str| {
        Err(Error::WrongRegion { what: "A map onto round holes", needed, found: found.to_string() })
    };
    if !domain.is_bounded() {
        return wrong("an outer boundary", "none");
    }
    if domain.holes().is_empty() {
        return wrong("a hole", "none");
    }
    domain.center().map_or_else(|| wrong("a center", "none"), Ok)
}

/// What tells one domain with circular slits from another: of each slit log radius, angle of the middle, log half width.
fn slit_numbers(map: &SlitMap) -> Vec<f64> {
    let numbers = |ends: &SlitEnds| {
        let [a, b] = ends.keys;
        [0.5 * (a.re + b.re), 0.5 * (a.im + b.im), (0.5 * (a.im - b.im).abs()).ln()]
    };
    map.ends().iter().flat_map(numbers).collect()
}

/// target − found, angles on the nearest branch.
fn missing(target: &[f64], found: &[f64]) -> Vec<f64> {
    let miss = |(k, (target, found)): (usize, (&f64, &f64))| {
        let miss = target - found;
        if k % 3 == 1 { miss - TAU * (miss / TAU).round() } else { miss }
    };
    target.iter().zip(found).enumerate().map(miss).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a, b| if b.is_nan() { f64::NAN } else { f64::max(a, b.abs()) })
}

/// Circles from log |center|, arg center, log radius.
fn circles_of(numbers: &[f64]) -> Vec<Circle> {
    let circle = |n: &[f64]| Circle { center: Complex64::from_polar(n[0].exp(), n[1]), radius: n[2].exp() };
    numbers.chunks_exact(3).map(circle).collect()
}

fn round_domain(circles: &[Circle]) -> Result<Domain> {
    let points = |circle: &Circle, count: u32| -> Vec<Complex64> {
        let angle = |k: u32| TAU * f64::from(k) / f64::from(count);
        (0..count).map(|k| circle.center + Complex64::from_polar(circle.radius, angle(k))).collect()
    };
    let outer = points(&Circle { center: Complex64::ZERO, radius: 1.0 }, OUTER_POINTS);
    let holes: Vec<_> = circles.iter().map(|circle| points(circle, HOLE_POINTS)).collect();
    Domain::new(&outer, &holes, Curve::Smooth)?.with_center(Complex64::ZERO)?.with_toward(Complex64::ONE)
}

/// The circles whose domain has the region's slits, its slit map, and by how much their slits differ at the end.
fn find(region: &SlitMap, options: &SolveOptions, progress: Progress) -> Result<(Vec<Circle>, SlitMap, f64)> {
    let target = slit_numbers(region);
    let goal = ROUNDING.max(0.01 * region.error_estimate());
    // A small hole's slit is four radii long.
    let first = |n: &[f64]| {
        let half = (0.5 * n[2].exp()).min(0.8);
        [n[0], n[1], half.ln() + n[0]]
    };
    let mut numbers: Vec<f64> = target.chunks_exact(3).flat_map(first).collect();
    let size = numbers.len();
    // The inverse of the derivative of slits by circles, first taken to be 1.
    let mut inverse: Vec<f64> = (0..size * size).map(|k| f64::from(u8::from(k % (size + 1) == 0))).collect();
    let mut best: Option<(Vec<f64>, SlitMap, f64)> = None;
    let mut step = vec![0.0; size];
    let mut before: Option<Vec<f64>> = None;
    let mut idle = 0;
    let mut started = 1.0;
    for _ in 0..MOST_STEPS {
        let mut halvings = 0;
        let (tried, round) = loop {
            let tried: Vec<f64> = numbers.iter().zip(&step).map(|(a, b)| a + b).collect();
            match round_domain(&circles_of(&tried)) {
                Ok(domain) => {
                    let done = best.as_ref().map_or(0.0, |(_, _, off)| (off / started).ln() / (goal / started).ln());
                    let mut go_on = |_: &'static str, _: f64| progress("circles", done.clamp(0.0, 1.0));
                    match SlitMap::solve(&domain, SlitKind::Disk, options, &mut go_on) {
                        Ok(round) => break (tried, round),
                        Err(Error::Cancelled) => return Err(Error::Cancelled),
                        Err(error) if halvings >= MOST_HALVINGS => return Err(error),
                        Err(_) => {}
                    }
                }
                Err(error) if halvings >= MOST_HALVINGS => return Err(error),
                Err(_) => {}
            }
            halvings += 1;
            if before.is_none() {
                // The first circles meet: smaller ones do not.
                numbers.chunks_exact_mut(3).for_each(|n| n[2] -= 0.5);
            }
            step.iter_mut().for_each(|s| *s *= 0.5);
        };
        let miss = missing(&target, &slit_numbers(&round));
        let off = largest(&miss);
        if let Some(before) = &before {
            broyden(&mut inverse, &step, before, &miss);
        }
        let is_better = best.as_ref().is_none_or(|(_, _, least)| off < *least);
        if is_better {
            if best.is_none() {
                started = off.max(2.0 * goal);
            }
            best = Some((tried.clone(), round, off));
            idle = 0;
        } else {
            idle += 1;
        }
        if off <= goal || idle >= PATIENCE {
            break;
        }
        numbers = tried;
        step = (0..size).map(|i| (0..size).map(|j| inverse[i * size + j] * miss[j]).sum()).collect();
        // No step beyond what the slits can be trusted to tell.
        let longest = largest(&step);
        if longest > 0.5 {
            step.iter_mut().for_each(|s| *s *= 0.5 / longest);
        }
        before = Some(miss);
    }
    match best {
        Some((numbers, round, off)) if off < FOUND => Ok((circles_of(&numbers), round, off)),
        best => Err(Error::Inaccurate { estimate: best.map_or(f64::NAN, |(_, _, off)| off) }),
    }
}

/// Broyden's good update of the inverse derivative, after a step that changed what is missing from `before` to `after`.
fn broyden(inverse: &mut [f64], step: &[f64], before: &[f64], after: &[f64]) {
    let size = step.len();
    let change: Vec<f64> = before.iter().zip(after).map(|(a, b)| a - b).collect();
    let predicted: Vec<f64> =
        (0..size).map(|i| (0..size).map(|j| inverse[i * size + j] * change[j]).sum::<f64>()).collect();
    let along: Vec<f64> = (0..size).map(|j| (0..size).map(|i| step[i] * inverse[i * size + j]).sum::<f64>()).collect();
    let scale: f64 = step.iter().zip(&predicted).map(|(a, b)| a * b).sum();
    let length: f64 = step.iter().map(|s| s * s).sum();
    if scale.abs() <= 1e-3 * length {
        return;
    }
    for i in 0..size {
        for j in 0..size {
            inverse[i * size + j] += (step[i] - predicted[i]) * along[j] / scale;
        }
    }
}

/// A point inside, far from the boundary and from the center.
fn pole_of(domain: &Domain, center: Complex64) -> Complex64 {
    const GRID: u32 = 24;
    let (low, high) = domain.contours()[0].polygon().bounds();
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(GRID);
    let points = (0..GRID * GRID)
        .map(|k| low + Complex64::new((high.re - low.re) * at(k % GRID), (high.im - low.im) * at(k / GRID)));
    let room = |z: &Complex64| (domain.nearest(*z).place.point - z).norm().min(0.5 * (z - center).norm());
    let best = points.filter(|z| domain.contains(*z)).max_by(|a, b| room(a).total_cmp(&room(b)));
    // Between the center and the wall, if no grid point lies inside.
    best.unwrap_or_else(|| 0.5 * (center + domain.nearest(center).place.point))
}

/// Slits that agree to this are those of one point.
const SAME: f64 = 1e-12;
/// This near to a wall, in units of the domain's size, a point is taken to be on it.
const AT_WALL: f64 = 1e-13;
/// Nearer than this it may be confused with a point on the other side of the slit.
const BESIDE_WALL: f64 = 1e-9;
/// What is accepted of points elsewhere, if rounding leaves nothing better.
const NEARLY: f64 = 1e-10;

/// From side `from` of the pairs to the other: (image, derivative); `None` outside the closed domain.
fn carry(pairs: &[[SlitMap; 2]], from: usize, z: Complex64) -> Option<(Complex64, Complex64)> {
    let domain = pairs[0][from].domain();
    if !domain.contains(z) {
        return None;
    }
    let nearest = domain.nearest(z);
    let size = domain.contours()[0].polygon().size();
    let off = (nearest.place.point - z).norm();
    if off <= AT_WALL * size {
        return carry_wall(pairs, from, nearest);
    }
    let [here, there] = [from, 1 - from].map(|side| pairs[0][side].canonical());
    if here.form().zero == Some(z) {
        let zero = there.form().zero?;
        return Some((zero, here.at(z)?.1 / there.at(zero)?.1));
    }
    let mut known: Vec<(usize, Complex64, Complex64)> = pairs
        .iter()
        .enumerate()
        .filter_map(|(k, pair)| pair[from].canonical().key(z).map(|(key, slope)| (k, key, slope)))
        .filter(|(_, key, slope)| key.is_finite() && slope.is_finite())
        .collect();
    // The slits that tell it apart best come first.
    known.sort_by(|a, b| b.2.norm().total_cmp(&a.2.norm()));
    let seek = |reached: f64| {
        known.iter().find_map(|(k, key, slope)| {
            let there = pairs[*k][1 - from].canonical();
            let w = there.seek(*key, reached)?;
            Some((w, slope / there.key(w)?.1))
        })
    };
    // What a wall's other side can pass for must lie at the wall.
    seek(SAME).or_else(|| if off <= BESIDE_WALL * size { carry_wall(pairs, from, nearest) } else { seek(NEARLY) })
}

/// [`carry`] for a point of the boundary.
fn carry_wall(pairs: &[[SlitMap; 2]], from: usize, point: DomainPoint) -> Option<(Complex64, Complex64)> {
    let DomainPoint { component, place } = point;
    if component == 0 {
        let [here, there] = [&pairs[0][from], &pairs[0][1 - from]];
        let (key, slope) = here.canonical().key_on_boundary(point);
        let w = Complex64::cis(key.im);
        let (z, back) = there.place(w)?;
        return Some((z, slope * w * back));
    }
    let known = pairs.iter().filter_map(|pair| {
        let there = &pair[1 - from];
        let along = across(&pair[from], there, component, place.edge as f64 + place.t)?;
        let image = there.domain().place_along(component, along);
        let slope = pair[from].canonical().key_on_boundary(point).1;
        Some((image, slope, there.canonical().key_on_boundary(image).1))
    });
    // The slits that tell images apart best.
    let (image, slope, there) = known.max_by(|a, b| a.2.norm().total_cmp(&b.2.norm()))?;
    Some((point_of(pairs[0][1 - from].domain(), image), slope / there))
}

/// The place on a slit's component of one domain that goes to the same side of the slit as a place in the other.
fn across(here: &SlitMap, there: &SlitMap, component: usize, place: f64) -> Option<f64> {
    let ends = |map: &SlitMap| map.ends().iter().find(|ends| ends.component == component).copied();
    let (own, other) = (ends(here)?, ends(there)?);
    let edges = |map: &SlitMap| map.domain().contours()[component].polygon().len() as f64;
    // Counter-clockwise from the end where Im B is largest to the other it falls.
    let ahead = |from: f64, to: f64, count: f64| (to - from).rem_euclid(count);
    let falls = ahead(own.places[0], place, edges(here)) <= ahead(own.places[0], own.places[1], edges(here));
    let key = here.canonical().key_on_boundary(here.domain().place_along(component, place)).0;
    let value = |place: f64| {
        let point = there.domain().place_along(component, place);
        there.canonical().field().on_boundary(point).0.im
    };
    let form = there.canonical().form();
    let [top, bottom] = other.places.map(value);
    // Im B, on the branch that the slit has.
    let period = if form.factor.re == 0.0 { f64::INFINITY } else { TAU };
    let mut target = ((key - form.shift) / form.factor).im;
    if period.is_finite() {
        target -= period * ((target - 0.5 * (top + bottom)) / period).round();
    }
    let target = target.clamp(bottom, top);
    let count = edges(there);
    let [mut high, mut low] = if falls {
        [other.places[0], other.places[0] + ahead(other.places[0], other.places[1], count)]
    } else {
        [other.places[1] + ahead(other.places[1], other.places[0], count), other.places[1]]
    };
    for _ in 0..80 {
        let middle = 0.5 * (high + low);
        if value(middle) > target {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(0.5 * (high + low))
}

fn point_of(domain: &Domain, point: DomainPoint) -> Complex64 {
    let (contour, place) = (&domain.contours()[point.component], point.place);
    match contour.smooth() {
        Some(curve) => curve.point(curve.parameter(place)),
        None => {
            let (a, b) = contour.polygon().edge(place.edge);
            a + (b - a) * place.t
        }
    }
}

/// What errors of the slits come to on the circles, where the better of the two maps is taken.
fn evidence_of(pairs: &[[SlitMap; 2]; 2], off: f64) -> Result<Evidence> {
    const SAMPLES: u32 = 4;
    let errors =
        pairs.each_ref().map(|pair| pair[0].error_estimate() + pair[1].error_estimate() + 4.0 * off + ROUNDING);
    let round = pairs[0][1].domain();
    let mut worst: f64 = 0.0;
    for (component, contour) in round.contours().iter().enumerate() {
        for k in 0..contour.polygon().len() as u32 * SAMPLES {
            let point = round.place_along(component, f64::from(k) / f64::from(SAMPLES));
            let moved = |k: usize| errors[k] / pairs[k][1].canonical().key_on_boundary(point).1.norm();
            // The outer boundary goes by circular slits alone.
            let least = if component == 0 { moved(0) } else { moved(0).min(moved(1)) };
            if least.is_nan() || least > worst {
                worst = least;
            }
        }
    }
    if worst.is_nan() || worst > 1.0 {
        return Err(Error::Inaccurate { estimate: worst });
    }
    let [region, round] = [&pairs[0][0], &pairs[0][1]];
    Ok(Evidence {
        residual: region.residual().max(round.residual()).max(off),
        error_estimate: worst,
        unknowns: region.unknowns(),
        stop: region.stop(),
    })
}
