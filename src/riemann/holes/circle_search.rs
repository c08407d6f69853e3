//! The round holes of a disk whose slit maps show given shapes.

use super::circle::Circle;
use super::round_shapes::RoundShapes;
use crate::plane::Complex64;
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

/// The holes, in the plane of 1/w, where the given ones are too; their shapes; and by how much these differ.
///
/// # Errors
/// [`Error::Cancelled`]; [`Error::Inaccurate`] if there are none.
pub fn matching(given: &[Circle], tolerance: f64, progress: Progress) -> Result<(Vec<Circle>, RoundShapes, f64)> {
    let mut circles = apart(given);
    let mut search = Search::default();
    let mut best: Option<(Vec<Circle>, RoundShapes, f64)> = None;
    let finest = (SHARE * tolerance).max(ROUNDING);
    let mut idle = 0;
    for _ in 0..MOST_STEPS {
        let least = best.as_ref().map_or(1.0, |(.., left)| *left);
        let done = (least.ln() / finest.ln()).clamp(0.0, 1.0);
        let rough = finest.max((ROUGH * least).min(ROUGH));
        let known = best.as_ref().map(|(_, shapes, _)| shapes);
        let shapes = RoundShapes::solve(&circles, known, rough, &mut |_, _| progress("circles", done))?;
        let outer = shapes.outer();
        let found = shapes.circles().into_iter().map(|circle| Circle {
            center: (circle.center - outer.center) / outer.radius,
            radius: circle.radius / outer.radius,
        });
        let found: Vec<Circle> = found.collect();
        let lacking: Vec<f64> = numbers(given).iter().zip(numbers(&found)).map(|(a, b)| a - b).collect();
        let left = lacking.iter().fold(0.0, |most: f64, x| if x.abs() > most || x.is_nan() { x.abs() } else { most });
        let change = search.next(lacking);
        let better = left < least || best.is_none() && !left.is_nan();
        idle = if better { 0 } else { idle + 1 };
        let from = circles.clone();
        if better {
            best = Some((circles, shapes, left));
        }
        if left <= finest && rough <= finest || idle > PATIENCE {
            break;
        }
        circles = search.moved(&from, change);
    }
    best.ok_or(Error::Inaccurate { estimate: f64::INFINITY })
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
        for _ in 0..MOST_HALVES {
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
