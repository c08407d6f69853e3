//! Disk → region by Newton's method, from where the paper's triangles put a point.

use super::locate::Located;
use super::side::Side;
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Polygon, SmoothCurve};

/// A region whose map is inverted point by point.
pub(super) struct Inverted<'a> {
    side: &'a dyn Side,
    located: Located<'a>,
}

/// Iterations; five are usual.
const MOST_STEPS: usize = 30;
/// A step that does not help is halved at most so often.
const MOST_HALVINGS: usize = 12;

impl<'a> Inverted<'a> {
    /// `spacing` is that of the samples that make the triangles.
    pub(super) fn new(side: &'a dyn Side, spacing: f64) -> Result<Self> {
        Ok(Self { side, located: Located::sampled(side, spacing)? })
    }

    /// Secant steps towards f(z) = w, the first slope from a difference; halved where they leave the region.
    fn solve(&self, w: Complex64) -> Complex64 {
        let image = |z: Complex64| self.side.to_disk(&[z])[0];
        // Beside the circle there is no triangle: start a little further in.
        let inwards = (0..12).map(|k| self.located.at(w * (1.0 - 1e-4 * f64::from((1 << k) - 1))));
        let Some((mut z, mut off)) = inwards.map(|z| (z, image(z) - w)).find(|(_, off)| off.norm().is_finite()) else {
            return Complex64::new(f64::NAN, f64::NAN);
        };
        let depth = self.side.polygon().map_or(1.0, |polygon| (polygon.nearest(z).point - z).norm());
        let mut slope = (image(z + 1e-3 * depth) - w - off) / (1e-3 * depth);
        for _ in 0..MOST_STEPS {
            if off.norm() < self.side.error() {
                break;
            }
            let mut step = off / slope;
            let better = (0..MOST_HALVINGS).find_map(|_| {
                let next = image(z - step) - w;
                let helps = next.norm() < off.norm();
                if !helps {
                    step *= 0.5;
                }
                helps.then_some(next)
            });
            let Some(next) = better else { break };
            slope = (off - next) / step;
            (z, off) = (z - step, next);
        }
        let near = off.norm() < (100.0 * self.side.error()).max(0.1 * (1.0 - w.norm()));
        if near { z } else { Complex64::new(f64::NAN, f64::NAN) }
    }
}

impl Side for Inverted<'_> {
    fn polygon(&self) -> Option<&Polygon> {
        self.side.polygon()
    }

    fn smooth(&self) -> Option<&SmoothCurve> {
        self.side.smooth()
    }

    fn center(&self) -> Complex64 {
        self.side.center()
    }

    fn toward(&self) -> BoundaryPoint {
        self.side.toward()
    }

    fn angle(&self, point: BoundaryPoint) -> f64 {
        self.side.angle(point)
    }

    fn at_angle(&self, angle: f64) -> BoundaryPoint {
        self.side.at_angle(angle)
    }

    fn error(&self) -> f64 {
        self.side.error()
    }

    fn to_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.side.to_disk(points)
    }

    fn to_region(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&w| self.solve(w)).collect()
    }
}
