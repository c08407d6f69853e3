//! From the disk of one region to that of another, chart to chart.

use super::super::rounding::is_on_circle;
use super::disk_point::DiskPoint;
use super::link::Link;
use super::position::{Angle, Position};
use crate::plane::Complex64;

/// A region's charts seen from its first, and the direction of its `toward`.
#[derive(Clone, Debug)]
pub struct Compass<'a> {
    pub positions: &'a [Position],
    pub toward: Angle,
}

/// Takes points of one region's disk to another's, 0 to 0 and `toward` to `toward`, without losing them among numbers that
/// crowd together: each chart goes to the nearest chart of the other region.
#[derive(Clone, Debug)]
pub struct Passage {
    /// For each chart the other region's, and the way there.
    ways: Vec<(usize, Link)>,
}

impl Passage {
    #[must_use]
    pub fn new(from: &Compass, to: &Compass) -> Self {
        let turn = to.toward.minus(&from.toward);
        let way = |position: &Position| {
            let ways = to.positions.iter().map(|other| position.passage(other, &turn)).enumerate();
            ways.min_by(|(_, p), (_, q)| p.length().total_cmp(&q.length())).unwrap_or((0, Link::IDENTITY))
        };
        Self { ways: from.positions.iter().map(way).collect() }
    }

    /// The point in the other region's disk, and the derivative on the way.
    #[inline]
    #[must_use]
    pub fn carry(&self, point: DiskPoint) -> (DiskPoint, Complex64) {
        let (chart, link) = &self.ways[point.chart];
        let mut w = link.apply(point.w);
        // What lies on the circle stays there, and rounding puts nothing beyond it.
        let square = w.norm_sqr();
        if square > 1.0 || is_on_circle(point.w) {
            w /= square.sqrt();
        }
        (DiskPoint { chart: *chart, w }, link.slope(point.w))
    }
}
