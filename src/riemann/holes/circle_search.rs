//! The round holes of a disk whose slit maps show given shapes.

use super::circle::Circle;
use super::round_shapes::RoundShapes;
use crate::plane::Complex64;
use crate::symm::Lu;
use crate::symm::options::Progress;
use crate::{Error, Result};

/// Steps to find the circles.
const MOST_STEPS: usize = 100;
/// The circles are known to this share of the tolerance.
const SHARE: f64 = 0.05;
/// Before, solves are as good as this share of what is lacking.
const ROUGH: f64 = 1e-2;
/// Solves are no better than this.
const ROUNDING: f64 = 2e-15;
/// How often a step is shortened.
const MOST_HALVES: usize = 60;
/// Steps that do not come nearer end the search.
const PATIENCE: usize = 8;

/// Where Broyden's method stays farther away than this, it went astray: slopes are taken by differences.
const ASTRAY: f64 = 1e-2;
/// The differences are of so much, and solves for them as good as this.
const DIFFERENCE: f64 = 1e-4;
const DIFFERENCE_ERROR: f64 = 1e-9;
/// Steps of Newton's method, and how often each is halved.
const NEWTON_STEPS: usize = 20;
const NEWTON_HALVES: i32 = 12;

/// The holes, in the plane of 1/w, where the given ones are too; their shapes; and by how much these differ.
///
/// # Errors
/// [`Error::Cancelled`]; [`Error::Inaccurate`] if there are none.
pub fn matching(given: &[Circle], tolerance: f64, progress: Progress) -> Result<(Vec<Circle>, RoundShapes, f64)> {
    let finest = (SHARE * tolerance).max(ROUNDING);
    let mut found = by_broyden(given, apart(given), Search::default(), finest, progress)?;
    if found.left > ASTRAY {
        let (nearer, slopes) = by_newton(given, found, progress)?;
        found = by_broyden(given, nearer.circles, Search { slopes: Some(slopes), steps: vec![] }, finest, progress)?;
    }
    Ok((found.circles, found.shapes, found.left))
}

/// Circles that were tried.
struct Found {
    circles: Vec<Circle>,
    shapes: RoundShapes,
    /// What the numbers of their shapes lack of those given,
    lacking: Vec<f64>,
    /// and the most of that.
    left: f64,
}

impl Found {
    fn at(
        given: &[Circle],
        circles: Vec<Circle>,
        known: Option<&RoundShapes>,
        error: f64,
        (done, progress): (f64, Progress),
    ) -> Result<Self> {
        let shapes = RoundShapes::solve(&circles, known, error, &mut |_, _| progress("circles", done))?;
        let outer = shapes.outer();
        let found = shapes.circles().into_iter().map(|circle| Circle {
            center: (circle.center - outer.center) / outer.radius,
            radius: circle.radius / outer.radius,
        });
        let found: Vec<Circle> = found.collect();
        let lacking: Vec<f64> = numbers(given).iter().zip(numbers(&found)).map(|(a, b)| a - b).collect();
        let left = lacking.iter().fold(0.0, |most: f64, x| if x.abs() > most || x.is_nan() { x.abs() } else { most });
        Ok(Self { circles, shapes, lacking, left })
    }
}

/// The nearest to what is given that Broyden's method comes to.
fn by_broyden(
    given: &[Circle],
    mut circles: Vec<Circle>,
    mut search: Search,
    finest: f64,
    progress: Progress,
) -> Result<Found> {
    let mut best: Option<Found> = None;
    let mut idle = 0;
    for _ in 0..MOST_STEPS {
        let least = best.as_ref().map_or(1.0, |best| best.left);
        let done = (least.ln() / finest.ln()).clamp(0.0, 1.0);
        let rough = finest.max((ROUGH * least).min(ROUGH));
        let known = best.as_ref().map(|best| &best.shapes);
        let found = Found::at(given, circles, known, rough, (done, progress))?;
        let change = search.next(found.lacking.clone());
        let (left, from) = (found.left, found.circles.clone());
        let better = left < least || best.is_none() && !left.is_nan();
        idle = if better { 0 } else { idle + 1 };
        if better {
            best = Some(found);
        }
        if left <= finest && rough <= finest || idle > PATIENCE {
            break;
        }
        circles = search.moved(&from, change);
    }
    best.ok_or(Error::Inaccurate { estimate: f64::INFINITY })
}

/// Nearer by Newton's method, with the last slopes; steps that come no nearer are shortened.
fn by_newton(given: &[Circle], mut best: Found, progress: Progress) -> Result<(Found, Lu)> {
    let mut steps = 0;
    loop {
        let slopes = slopes(given, &best, progress)?;
        let mut step = best.lacking.clone();
        slopes.solve(&mut step);
        let mut nearer = None;
        for halves in 0..NEWTON_HALVES {
            let circles = plus(&best.circles, &step, 0.5f64.powi(halves));
            if !are_apart(&circles) {
                continue;
            }
            let rough = ROUGH * best.left.min(1.0);
            let found = Found::at(given, circles, Some(&best.shapes), rough, (0.0, progress))?;
            if found.left < best.left {
                nearer = Some(found);
                break;
            }
        }
        steps += 1;
        match nearer {
            Some(found) if found.left > ASTRAY && steps < NEWTON_STEPS => best = found,
            nearer => return Ok((nearer.unwrap_or(best), slopes)),
        }
    }
}

/// The derivative of the shapes' numbers by those of the circles, by differences.
fn slopes(given: &[Circle], at: &Found, progress: Progress) -> Result<Lu> {
    let n = at.lacking.len();
    let mut shapes =
        |circles: Vec<Circle>| Found::at(given, circles, Some(&at.shapes), DIFFERENCE_ERROR, (0.0, progress));
    let here = shapes(at.circles.clone())?;
    let mut matrix = vec![0.0; n * n];
    for k in 0..n {
        let by = DIFFERENCE * at.circles[k / 3].radius;
        let mut step = vec![0.0; n];
        step[k] = by;
        let there = shapes(plus(&at.circles, &step, 1.0))?;
        for (i, (here, there)) in here.lacking.iter().zip(&there.lacking).enumerate() {
            matrix[i * n + k] = (here - there) / by;
        }
    }
    Ok(Lu::new(n, matrix))
}

/// Circles with a share of a step added to their numbers.
fn plus(circles: &[Circle], step: &[f64], share: f64) -> Vec<Circle> {
    let moved = |(circle, by): (&Circle, &[f64])| Circle {
        center: circle.center + share * Complex64::new(by[0], by[1]),
        radius: circle.radius + share * by[2],
    };
    circles.iter().zip(step.chunks_exact(3)).map(moved).collect()
}

/// What round holes are: center and radius of each.
fn numbers(circles: &[Circle]) -> Vec<f64> {
    circles.iter().flat_map(|circle| [circle.center.re, circle.center.im, circle.radius]).collect()
}

/// Whether they lie outside of the unit circle, and apart.
fn are_apart(circles: &[Circle]) -> bool {
    circles.iter().enumerate().all(|(k, a)| {
        let clear = |b: &Circle| (a.center - b.center).norm() > a.radius + b.radius;
        a.radius > 0.0 && a.center.norm() - a.radius > 1.0 && circles[..k].iter().all(clear)
    })
}

/// Circles near the given ones that are apart: smaller, and no nearer to the unit circle than their own size, which shapes of a
/// disk with large holes may be.
fn apart(circles: &[Circle]) -> Vec<Circle> {
    let smaller = |k: i32| {
        let moved = |c: &Circle| {
            let radius = c.radius * 0.8f64.powi(k);
            Circle { radius, center: c.center * ((1.0 + 2.0 * radius) / c.center.norm()).max(1.0) }
        };
        circles.iter().map(moved).collect::<Vec<_>>()
    };
    (0..40).map(smaller).find(|circles| are_apart(circles)).unwrap_or_else(|| smaller(40))
}

/// Broyden's method for what is lacking, the identity being near to the derivative where that is not known: C. T. Kelley,
/// *Iterative Methods for Linear and Nonlinear Equations* (1995), section 7.3.
#[derive(Default)]
struct Search {
    /// The derivative to start from.
    slopes: Option<Lu>,
    steps: Vec<Vec<f64>>,
}

impl Search {
    /// The step that follows from what is lacking now.
    fn next(&mut self, mut lacking: Vec<f64>) -> Vec<f64> {
        if let Some(slopes) = &self.slopes {
            slopes.solve(&mut lacking);
        }
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
        for _ in 0..MOST_HALVES {
            let moved = plus(circles, &step, 1.0);
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
