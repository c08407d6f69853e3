//! The map of a region with two marked boundary points onto a strip.

use super::super::RiemannMap;
use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::map::{Gap, MarkedMap, Seen, Target};
use super::marks::Marks;
use super::points::{evidence_of, marked_points};
use crate::Result;
use crate::plane::{Complex64, Region};
use crate::symm::options::{Progress, SolveOptions};
use std::f64::consts::{FRAC_1_PI, PI};

/// The conformal map of a region onto the strip 0 < Im w < 1 that takes two points of the boundary to its ends, the first to the
/// left and the second to the right, and the center to the imaginary axis.
///
/// πw = log((z' − p)/(z' − q)) + c, z' being the point of the disk: far ends stay apart, since each chart has its own c.
///
/// ```
/// use conformal_warp::{Complex64, Curve, Region, SolveOptions, StripMap};
/// let vertices = [(-9.0, 0.0), (9.0, 0.0), (9.0, 1.0), (-9.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let region = Region::new(&vertices, Curve::Polygon, Complex64::new(0.0, 0.5), vertices[0])?;
/// let ends = [Complex64::new(-9.0, 0.5), Complex64::new(9.0, 0.5)];
/// let map = StripMap::solve(&region, ends, &SolveOptions::default(), &mut |_, _| true)?;
/// // A long rectangle is nearly a strip itself.
/// let z = Complex64::new(5.0, 0.2);
/// assert!((map.to_strip(&[z])[0] - z).norm() < 1e-4);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct StripMap {
    map: MarkedMap<Strip>,
    ends: [Complex64; 2],
    pub(super) evidence: Evidence,
}

impl StripMap {
    /// Solves for the map. The ends are snapped to the boundary.
    ///
    /// # Errors
    /// As [`RiemannMap::solve`] and [`StripMap::of`].
    pub fn solve(region: &Region, ends: [Complex64; 2], options: &SolveOptions, progress: Progress) -> Result<Self> {
        Self::of(&RiemannMap::solve(region, options, progress)?, ends)
    }

    /// The map of a region that was already solved.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::InvalidMap`](crate::Error::InvalidMap) if the ends are one point;
    /// [`Error::Inaccurate`](crate::Error::Inaccurate).
    pub fn of(map: &RiemannMap, ends: [Complex64; 2]) -> Result<Self> {
        let places = marked_points(map.region(), "A strip map", &ends)?;
        let marks = Marks::new(map.solved(), &places);
        let evidence = evidence_of(map, 1.0 + 2.0 * FRAC_1_PI / marks.apart(0, 1))?;
        let target = Strip::new(&marks);
        Ok(Self { map: MarkedMap::new(map, marks, target), ends: places.map(|place| place.point), evidence })
    }

    /// The map region → disk that it goes through.
    #[must_use]
    pub fn disk(&self) -> &RiemannMap {
        self.map.disk()
    }

    /// The boundary points that go to the left and right ends.
    #[must_use]
    pub fn ends(&self) -> [Complex64; 2] {
        self.ends
    }

    /// Region → strip. NaN outside the closed region; the ends go to ∓∞.
    #[must_use]
    pub fn to_strip(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Strip → region, the inverse of [`StripMap::to_strip`]. NaN outside the closed strip.
    #[must_use]
    pub fn from_strip(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.map.inverse(w))
    }

    /// f' of the map region → strip, per plane unit. NaN outside the closed region.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }
}

evidence_methods!(
    StripMap,
    "of images, the strip being 1 wide. Beside an end that is no vertex of the boundary the map itself makes δ/ε of an error δ at the distance ε."
);
two_ways!(StripMap, map.inverse);

/// The strip: πw = log(turn · (z' − p)/(z' − q)) + log.
#[derive(Clone, Debug)]
struct Strip {
    charts: Vec<Factors>,
}

/// Of one chart.
#[derive(Clone, Copy, Debug)]
struct Factors {
    /// |turn| = 1.
    turn: Complex64,
    log: f64,
    /// p − q.
    apart: Complex64,
}

impl Strip {
    fn new(marks: &Marks) -> Self {
        // Where p and q are far apart, the arc from p to q goes to the positive real axis.
        let best = marks.best(0, 1);
        let half = 0.5 * (marks.at(best, 1) / marks.at(best, 0)).arg();
        let mut turn = -Complex64::cis(half);
        if (turn * marks.at(best, 0) / marks.at(best, 1)).im < 0.0 {
            turn = -turn;
        }
        let ratio = |chart: usize| marks.root(chart, 1) / marks.root(chart, 0);
        let (here, first) = (ratio(best), ratio(0));
        let factors = |chart: usize| {
            let there = ratio(chart);
            let turned = turn * (there / there.norm()) / (here / here.norm());
            Factors {
                turn: turned / turned.norm(),
                log: there.norm().ln() - first.norm().ln(),
                apart: marks.chord_in(chart, 0, 1),
            }
        };
        Self { charts: (0..marks.charts()).map(factors).collect() }
    }
}

/// How far beyond a side a point still belongs to the strip.
const ON_SIDE: f64 = 1e-14;

impl Target for Strip {
    /// πw.
    type Key = Complex64;

    fn image(&self, marks: &Marks, seen: &Seen) -> (Complex64, Complex64) {
        let Factors { turn, log, apart } = self.charts[seen.chart];
        let [a, b] = [0, 1].map(|mark| seen.less(marks, mark));
        if a == Complex64::ZERO || b == Complex64::ZERO {
            let end = if a == Complex64::ZERO { f64::NEG_INFINITY } else { f64::INFINITY };
            return (Complex64::new(end, 0.0), Complex64::new(f64::INFINITY, 0.0));
        }
        let found = (turn * a / b).ln();
        // Rounding may carry the upper side across the cut.
        let angle = if found.im < -0.5 * PI { PI } else { found.im.max(0.0) };
        (Complex64::new((found.re + log) * FRAC_1_PI, angle * FRAC_1_PI), apart / (a * b) * FRAC_1_PI)
    }

    fn key(&self, image: Complex64) -> Option<(Complex64, bool)> {
        let outside = (image.im - 1.0).max(-image.im);
        if outside.is_nan() || outside > ON_SIDE || image.re.is_nan() {
            return None;
        }
        Some((PI * Complex64::new(image.re, image.im.clamp(0.0, 1.0)), outside >= -ON_SIDE))
    }

    fn in_chart(&self, marks: &Marks, key: &Complex64, chart: usize) -> Complex64 {
        let Factors { turn, log, .. } = self.charts[chart];
        let [p, q] = [0, 1].map(|mark| marks.at(chart, mark));
        if key.re <= log {
            let t = (key - log).exp() / turn;
            (p - t * q) / (1.0 - t)
        } else {
            let t = (log - key).exp() * turn;
            (q - t * p) / (1.0 - t)
        }
    }

    fn slope(&self, key: &Complex64, chart: usize) -> f64 {
        let Factors { turn, log, apart } = self.charts[chart];
        // With t = (w − p)/(w − q) or its inverse.
        let t = if key.re <= log { (key - log).exp() / turn } else { (log - key).exp() * turn };
        (1.0 - t).norm_sqr() / (t * apart).norm()
    }

    fn beside(&self, marks: &Marks, key: &Complex64) -> Option<Gap> {
        let mark = [0, 1].into_iter().min_by(|i, j| {
            let ahead = |mark: usize| {
                let towards = key.re - self.charts[marks.list()[mark].home].log;
                if mark == 0 { towards } else { -towards }
            };
            ahead(*i).total_cmp(&ahead(*j))
        })?;
        let Factors { turn, log, apart } = self.charts[marks.list()[mark].home];
        if mark == 0 {
            let t = (key - log).exp() / turn;
            Some((0, t * apart / (1.0 - t)))
        } else {
            let t = (log - key).exp() * turn;
            Some((1, -t * apart / (1.0 - t)))
        }
    }
}
