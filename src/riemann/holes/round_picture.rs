//! A disk with round holes as its slit maps show it, both ways.

use super::super::atlas::accuracy::Accuracy;
use super::barriers::Barriers;
use super::circle::{Circle, UNIT};
use super::inverse_tree::{InverseTree, Inverted, Origin, Pair};
use super::round_shapes::RoundShapes;
use super::seeds::Seeds;
use crate::Result;
use crate::plane::Complex64;
use crate::symm::options::Progress;
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// v = ρ/(M(1/w) − μ), with which the unit circle goes to about itself, and 0 to 0.
#[derive(Clone, Debug)]
pub struct RoundPicture {
    shapes: RoundShapes,
    /// The round holes, in the plane of w.
    circles: Vec<Circle>,
    /// How far beyond the unit circle, and each of them, the picture is known to be one-to-one.
    margins: Vec<f64>,
    /// ρ and μ.
    outer: Circle,
    /// Made at the first use of the way back.
    back: Arc<OnceLock<(Seeds, InverseTree)>>,
}

/// Newton's method ends after so many steps,
const MOST_STEPS: usize = 40;
/// when this is left.
const ROUNDING: f64 = 4e-16;
/// So much may be left.
const REACHED: f64 = 1e-12;
/// How often a step is shortened.
const MOST_TRIALS: usize = 10;
/// Seeds that are tried.
const CANDIDATES: usize = 12;
/// Known pairs on each circle, and along each side of a grid.
const SEEDS: [u32; 2] = [48, 40];
/// Points beyond a circle by this share of what is free there still count.
const SHARE_OF_ROOM: f64 = 0.1;
/// Series of the way back may err by this.
const SERIES_ERROR: f64 = 1e-13;

impl RoundPicture {
    /// Of holes whose inverses' shapes these are.
    #[must_use]
    pub fn new(shapes: RoundShapes, circles: Vec<Circle>) -> Self {
        let outer = shapes.outer();
        let margins = margins(&circles);
        Self { shapes, circles, margins, outer, back: Arc::default() }
    }

    /// The unit circle, and those of the holes.
    #[must_use]
    pub fn circle(&self, component: usize) -> Circle {
        component.checked_sub(1).map_or(UNIT, |hole| self.circles[hole])
    }

    /// How far outside of the closed domain a point lies, and the point of its boundary nearest to it; `None` inside.
    #[must_use]
    pub fn outside(&self, w: Complex64) -> Option<(f64, Complex64)> {
        self.beyond(w).map(|(component, by)| (by, self.circle(component).nearest(w)))
    }

    /// The circle that a point lies beyond, and how far.
    fn beyond(&self, w: Complex64) -> Option<(usize, f64)> {
        let square = w.norm_sqr();
        if square > 1.0 {
            return Some((0, square.sqrt() - 1.0));
        }
        let inside = |circle: &Circle| (w - circle.center).norm_sqr() < circle.radius * circle.radius;
        let hole = self.circles.iter().position(inside)?;
        Some((hole + 1, self.circles[hole].radius - (w - self.circles[hole].center).norm()))
    }

    /// The point, or the nearest of the boundary if it lies too far outside.
    fn inward(&self, w: Complex64) -> Complex64 {
        match self.beyond(w) {
            Some((component, by)) if by > self.margins[component] => self.circle(component).nearest(w),
            _ => w,
        }
    }

    /// Whether it lies as near to a circle as this.
    #[must_use]
    pub fn is_beside(&self, w: Complex64, distance: f64) -> bool {
        let near = |circle: &Circle| ((w - circle.center).norm() - circle.radius).abs() <= distance;
        near(&UNIT) || self.circles.iter().any(near)
    }

    /// (v, dv/dw).
    #[inline]
    #[must_use]
    pub fn at(&self, w: Complex64) -> (Complex64, Complex64) {
        let (rest, slope) = self.shapes.rest(w);
        let below = (1.0 + w * (rest - self.outer.center)).inv();
        (self.outer.radius * w * below, self.outer.radius * (1.0 + slope) * below * below)
    }

    /// v → (w, dw/dv); w may lie so far outside of the closed domain.
    #[must_use]
    pub fn inverse(&self, v: Complex64, slack: f64) -> Option<(Complex64, Complex64)> {
        if !v.is_finite() {
            return None;
        }
        if v == Complex64::ZERO {
            return Some((v, self.at(v).1.inv()));
        }
        let (seeds, tree) = self.back();
        let near = self.inverting(seeds, |inverted| match tree.at(v, inverted) {
            Origin::Known(w, slope) => Some((w, slope)),
            Origin::Near(pair) => self.newton(v, pair.guess(v)).map(|pair| (pair.z, pair.slope)),
            Origin::Unknown => None,
        });
        let is_inside = |w: Complex64| self.beyond(w).is_none_or(|(_, by)| by <= slack);
        near.filter(|(w, _)| is_inside(*w)).or_else(|| {
            let found = seeds.near(v, CANDIDATES).into_iter().filter_map(|(_, w)| self.newton(v, w));
            found.map(|pair| (pair.z, pair.slope)).find(|(w, _)| is_inside(*w))
        })
    }

    /// Makes the way back now.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was made by then is kept.
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        let (seeds, tree) = self.back();
        self.inverting(seeds, |inverted| tree.fill(inverted, progress))
    }

    fn back(&self) -> &(Seeds, InverseTree) {
        self.back.get_or_init(|| {
            let [around, side] = SEEDS;
            let turn = |k: u32| Complex64::cis(TAU * f64::from(k) / f64::from(around));
            let circles = (0..=self.circles.len()).map(|k| self.circle(k));
            let on_circles = circles.flat_map(|c| (0..around).map(move |k| c.center + turn(k) * c.radius));
            let along = |k: u32| (f64::from(2 * k + 1)) / f64::from(side) - 1.0;
            let grid = (0..side * side).map(|k| Complex64::new(along(k % side), along(k / side)));
            let points = on_circles.chain(grid.filter(|w| self.outside(*w).is_none()));
            let seeds = Seeds::of(points.map(|w| (self.at(w).0, w)).collect(), false);
            let tree = InverseTree::new(&seeds);
            (seeds, tree)
        })
    }

    fn inverting<T>(&self, seeds: &Seeds, what: impl FnOnce(&Inverted) -> T) -> T {
        let strip = (f64::NEG_INFINITY, f64::INFINITY);
        let newton = |v: Complex64, w: Complex64| self.newton(v, w);
        let (barriers, accuracy) = (&Barriers::default(), Accuracy::beside(SERIES_ERROR));
        what(&Inverted { seeds, barriers, strip, newton: &newton, accuracy, size: 1.0 })
    }

    /// Newton's method from a point not too far away.
    #[must_use]
    pub fn newton(&self, v: Complex64, w: Complex64) -> Option<Pair> {
        let mut w = self.inward(w);
        let (found, mut slope) = self.at(w);
        let mut miss = v - found;
        for _ in 0..MOST_STEPS {
            if miss.norm() <= ROUNDING * v.norm() {
                break;
            }
            let mut step = miss / slope;
            let mut moved = None;
            for _ in 0..if miss.norm() < REACHED { 1 } else { MOST_TRIALS } {
                let next = self.inward(w + step);
                let (found, slope) = self.at(next);
                if (v - found).norm() < miss.norm() {
                    moved = Some((next, v - found, slope));
                    break;
                }
                step *= 0.3;
            }
            let Some(next) = moved else { break };
            (w, miss, slope) = next;
        }
        (miss.norm() <= REACHED).then(|| Pair { key: v, z: w, slope: slope.inv() })
    }
}

/// A share of the way to other circles, and of their radii.
fn margins(circles: &[Circle]) -> Vec<f64> {
    let to_unit = |circle: &Circle| 1.0 - circle.center.norm() - circle.radius;
    let unit = circles.iter().map(to_unit).fold(1.0, f64::min);
    let hole = |(k, circle): (usize, &Circle)| {
        let others = circles.iter().enumerate().filter(|(j, _)| *j != k);
        let apart = |(_, other): (usize, &Circle)| (circle.center - other.center).norm() - circle.radius - other.radius;
        others.map(apart).fold(circle.radius.min(to_unit(circle)), f64::min)
    };
    [unit].into_iter().chain(circles.iter().enumerate().map(hole)).map(|room| SHARE_OF_ROOM * room).collect()
}
