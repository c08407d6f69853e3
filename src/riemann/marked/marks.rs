//! Boundary points of a solved region as all its charts see them.

use super::super::atlas::{DiskPoint, Link};
use super::super::solved_region::SolvedRegion;
use crate::plane::{BoundaryPoint, Complex64};

/// Marked boundary points, known in every chart: where the circle has them, and how the chart's way to the first one stretches
/// there. Chords between them never cancel: each is measured in the chart that tells its ends apart best.
#[derive(Clone, Debug)]
pub struct Marks {
    /// Chart → first chart.
    to_first: Vec<Link>,
    marks: Vec<Mark>,
}

/// A marked point.
#[derive(Clone, Debug)]
pub struct Mark {
    /// The chart that knows it best.
    pub home: usize,
    /// The vertex it is, if it is one.
    pub vertex: Option<usize>,
    /// By charts: the point of the circle, and the root of the first chart's link there ([`Link::root`]).
    seen: Vec<(Complex64, Complex64)>,
}

impl Marks {
    /// Marks boundary points.
    #[must_use]
    pub fn new(solved: &dyn SolvedRegion, points: &[BoundaryPoint]) -> Self {
        let positions = solved.positions();
        let to_first = positions.iter().map(|position| position.link_to(&positions[0])).collect();
        let mut marks = Self { to_first, marks: Vec::new() };
        for place in points {
            let known = solved.to_disk(place.point).unwrap_or(DiskPoint::NOWHERE);
            let vertex = (place.t == 0.0).then_some(place.edge);
            marks.add(solved, known.onto_circle(), vertex);
        }
        marks
    }

    /// Marks a point more.
    pub fn add(&mut self, solved: &dyn SolvedRegion, point: DiskPoint, vertex: Option<usize>) {
        let positions = solved.positions();
        let home = point.chart;
        let first = self.to_first[home].root(point.w);
        let seen = |chart: usize| {
            let link = positions[home].link_to(&positions[chart]);
            let moved = link.apply(point.w);
            let (w, root) = (moved / moved.norm(), first / link.root(point.w));
            // Links are matrices up to a sign; the sign is that of this chart's own link, seen from where nothing cancels.
            let own = &self.to_first[chart];
            let reference = if root.norm() >= 1.0 {
                own.root(w)
            } else {
                let there = self.to_first[home].apply(point.w);
                own.inverse().root(there / there.norm()).inv()
            };
            (w, if (root * reference.conj()).re < 0.0 { -root } else { root })
        };
        let seen = (0..positions.len()).map(seen).collect();
        self.marks.push(Mark { home, vertex, seen });
    }

    /// How many charts there are.
    #[must_use]
    pub fn charts(&self) -> usize {
        self.to_first.len()
    }

    /// The marks.
    #[must_use]
    pub fn list(&self) -> &[Mark] {
        &self.marks
    }

    /// Where a chart's circle has a mark.
    #[inline]
    #[must_use]
    pub fn at(&self, chart: usize, mark: usize) -> Complex64 {
        self.marks[mark].seen[chart].0
    }

    /// 1/√ of the derivative of chart → first chart at a mark.
    #[inline]
    #[must_use]
    pub fn root(&self, chart: usize, mark: usize) -> Complex64 {
        self.marks[mark].seen[chart].1
    }

    /// Chart → first chart.
    #[must_use]
    pub fn to_first(&self, chart: usize) -> &Link {
        &self.to_first[chart]
    }

    /// The chart that tells two marks apart best.
    #[must_use]
    pub fn best(&self, i: usize, j: usize) -> usize {
        let apart = |chart: &usize| (self.at(*chart, i) - self.at(*chart, j)).norm();
        (0..self.charts()).max_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(0)
    }

    /// How far apart two marks are at best.
    #[must_use]
    pub fn apart(&self, i: usize, j: usize) -> f64 {
        let best = self.best(i, j);
        (self.at(best, i) - self.at(best, j)).norm()
    }

    /// Mark i − mark j in the first chart.
    #[must_use]
    pub fn chord(&self, i: usize, j: usize) -> Complex64 {
        let best = self.best(i, j);
        // g(a) − g(b) = (a − b)/(root(a) root(b)).
        (self.at(best, i) - self.at(best, j)) / self.root(best, i) / self.root(best, j)
    }

    /// Mark i − mark j in a chart.
    #[must_use]
    pub fn chord_in(&self, chart: usize, i: usize, j: usize) -> Complex64 {
        self.chord(i, j) * self.root(chart, i) * self.root(chart, j)
    }
}
