//! The map of a region with a marked boundary point onto the half plane.

use super::super::RiemannMap;
use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::map::{Gap, MarkedMap, Seen, Target};
use super::marks::Marks;
use super::points::{evidence_of, marked_points};
use crate::Result;
use crate::plane::{Complex64, Region};
use crate::symm::options::{Progress, SolveOptions};

/// The conformal map of a region onto the upper half plane that takes a point of the boundary to ∞ and the center to i.
///
/// ```
/// use conformal_warp::{Complex64, Curve, HalfPlaneMap, Region, SolveOptions};
/// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let region = Region::new(&square, Curve::Polygon, Complex64::ZERO, square[0])?;
/// let map = HalfPlaneMap::solve(&region, square[0], &SolveOptions::default(), &mut |_, _| true)?;
/// // The corners of a square see its center at right angles.
/// assert!((map.to_half_plane(&[square[1]])[0] + 1.0).norm() < 1e-7);
/// assert!(map.to_half_plane(&[square[2]])[0].norm() < 1e-7);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct HalfPlaneMap {
    map: MarkedMap<HalfPlane>,
    pole: Complex64,
    evidence: Evidence,
}

impl HalfPlaneMap {
    /// Solves for the map. The point that goes to ∞ is snapped to the boundary.
    ///
    /// # Errors
    /// As [`RiemannMap::solve`] and [`HalfPlaneMap::of`].
    pub fn solve(region: &Region, pole: Complex64, options: &SolveOptions, progress: Progress) -> Result<Self> {
        Self::of(&RiemannMap::solve(region, options, progress)?, pole)
    }

    /// The map of a region that was already solved.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Inaccurate`](crate::Error::Inaccurate).
    pub fn of(map: &RiemannMap, pole: Complex64) -> Result<Self> {
        let [place] = marked_points(map.region(), "A map onto the half plane", &[pole])?;
        let marks = Marks::new(map.solved(), &[place]);
        let evidence = evidence_of(map, 2.0)?;
        let target = HalfPlane::new(&marks);
        Ok(Self { map: MarkedMap::new(map, marks, target), pole: place.point, evidence })
    }

    /// The map region → disk that it goes through.
    #[must_use]
    pub fn disk(&self) -> &RiemannMap {
        self.map.disk()
    }

    /// The boundary point that goes to ∞.
    #[must_use]
    pub fn pole(&self) -> Complex64 {
        self.pole
    }

    /// Region → half plane. NaN outside the closed region, infinite at the pole.
    #[must_use]
    pub fn to_half_plane(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Half plane → region, the inverse of [`HalfPlaneMap::to_half_plane`]. NaN below the real axis.
    #[must_use]
    pub fn from_half_plane(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.map.inverse(w))
    }

    /// f' of the map region → half plane, per plane unit. NaN outside the closed region.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }
}

evidence_methods!(
    HalfPlaneMap,
    "of images w, in units of 1 + |w|². A pole that is a vertex keeps the relative accuracy of distances from it."
);
two_ways!(HalfPlaneMap, map.inverse);

/// The half plane: u = αi(p + w)/(p − w) + β.
#[derive(Clone, Debug)]
struct HalfPlane {
    /// Of each chart.
    charts: Vec<Factors>,
}

#[derive(Clone, Copy, Debug)]
struct Factors {
    alpha: f64,
    beta: f64,
}

impl HalfPlane {
    fn new(marks: &Marks) -> Self {
        let factors = |chart: usize| {
            // The chart's center goes to β + αi.
            let (root, link) = (marks.root(chart, 0), marks.to_first(chart));
            let back = 2.0 * marks.at(0, 0) * root * link.root(Complex64::ZERO) / marks.at(chart, 0);
            Factors { alpha: root.norm_sqr(), beta: -back.im }
        };
        Self { charts: (0..marks.charts()).map(factors).collect() }
    }
}

/// How far below the axis a point still belongs to the half plane, relative to its size.
const ON_AXIS: f64 = 1e-14;

impl Target for HalfPlane {
    type Key = Complex64;

    fn image(&self, marks: &Marks, seen: &Seen) -> (Complex64, Complex64) {
        let Factors { alpha, beta } = self.charts[seen.chart];
        let (p, less) = (marks.at(seen.chart, 0), seen.less(marks, 0));
        if less == Complex64::ZERO {
            return (Complex64::new(f64::INFINITY, 0.0), Complex64::new(f64::INFINITY, 0.0));
        }
        let own = -Complex64::i() * (p + seen.w) / less;
        (
            Complex64::new(alpha * own.re + beta, (alpha * own.im).max(0.0)),
            2.0 * Complex64::i() * alpha * p / (less * less),
        )
    }

    fn key(&self, image: Complex64) -> Option<(Complex64, bool)> {
        let room = ON_AXIS * image.norm();
        if image.is_nan() || image.im < -room {
            return None;
        }
        Some((Complex64::new(image.re, image.im.max(0.0)), image.im <= room))
    }

    fn in_chart(&self, marks: &Marks, key: &Complex64, chart: usize) -> Complex64 {
        let Factors { alpha, beta } = self.charts[chart];
        let own = (key - beta) / alpha;
        if !own.is_finite() {
            return marks.at(chart, 0);
        }
        marks.at(chart, 0) * (own - Complex64::i()) / (own + Complex64::i())
    }

    fn slope(&self, key: &Complex64, chart: usize) -> f64 {
        let Factors { alpha, beta } = self.charts[chart];
        alpha * ((key - beta) / alpha + Complex64::i()).norm_sqr()
    }

    fn beside(&self, marks: &Marks, key: &Complex64) -> Option<Gap> {
        let home = marks.list()[0].home;
        let Factors { alpha, beta } = self.charts[home];
        let own = (key - beta) / alpha;
        Some((0, -2.0 * Complex64::i() * marks.at(home, 0) / (own + Complex64::i())))
    }
}
