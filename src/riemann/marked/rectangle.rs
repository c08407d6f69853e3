//! The map of a region with four marked boundary points onto a rectangle.

use super::super::RiemannMap;
use super::super::atlas::DiskPoint;
use super::super::both_ways::{Pointwise, places, two_ways};
use super::super::evidence::{Evidence, evidence_methods};
use super::elliptic::{Modulus, mean};
use super::map::{Gap, MarkedMap, Seen, Target};
use super::marks::Marks;
use super::points::{evidence_of, marked_points};
use crate::plane::{Complex64, Region};
use crate::symm::options::{Progress, SolveOptions};
use crate::{Error, Result};
use std::f64::consts::PI;

/// The conformal map of a region onto the rectangle 0 < Re w < `aspect`, 0 < Im w < 1 that takes four points of the boundary,
/// counter-clockwise, to its corners 0, `aspect`, `aspect` + i and i.
///
/// The disk of the region's Riemann map is taken to the half plane, the four points to ±1 and ±1/k, and that to the rectangle by
/// the elliptic integral of the first kind. k comes from chords of the circle, each measured in the chart where it is largest, so
/// that long quadrilaterals lose nothing: k ≈ 4 exp(−π/2 · aspect).
///
/// ```
/// use conformal_warp::{Complex64, Curve, RectangleMap, Region, SolveOptions};
/// let vertices = [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let trapezoid = Region::new(&vertices, Curve::Polygon, Complex64::new(0.5, 0.5), vertices[0])?;
/// let map = RectangleMap::solve(&trapezoid, vertices, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((map.aspect() * 1.279_261_571_171 - 1.0).abs() < 1e-7);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RectangleMap {
    map: MarkedMap<Rectangle>,
    corners: [Complex64; 4],
    pub(super) evidence: Evidence,
}

impl RectangleMap {
    /// Solves for the map. Corners are snapped to the boundary.
    ///
    /// # Errors
    /// As [`RiemannMap::solve`] and [`RectangleMap::of`].
    pub fn solve(region: &Region, corners: [Complex64; 4], options: &SolveOptions, progress: Progress) -> Result<Self> {
        Self::of(&RiemannMap::solve(region, options, progress)?, corners)
    }

    /// The map of a region that was already solved: other corners cost nothing more.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::InvalidMap`] unless the corners are four points counter-clockwise; [`Error::Crowded`] for
    /// sides that double precision cannot tell from points; [`Error::Inaccurate`].
    pub fn of(map: &RiemannMap, corners: [Complex64; 4]) -> Result<Self> {
        let places = marked_points(map.region(), "A rectangle map", &corners)?;
        let solved = map.solved();
        let mut marks = Marks::new(solved, &places);
        let (x, y) = (cross_ratio(&marks, [3, 0, 1, 2]), cross_ratio(&marks, [0, 1, 2, 3]));
        // Long in x: the sides from the last corner to the first and from the second to the third are short.
        let lies = x <= y;
        let order = if lies { [3, 0, 1, 2] } else { [0, 1, 2, 3] };
        let ratio = x.min(y);
        let k = ratio / (1.0 + (1.0 + ratio).sqrt()).powi(2);
        if k.is_nan() || k <= 0.0 {
            return Err(Error::Crowded { at: places[order[0]].point });
        }
        let [a, b, c, d] = order;
        for roles in [[a, b, c], [d, c, b]] {
            let middle = middle_of_side(&marks, k, roles);
            marks.add(solved, middle, None);
        }
        let target = Rectangle::new(&marks, order, k, lies);
        let evidence = evidence_of(map, sensitivity(&marks))?;
        let corners = places.map(|place| place.point);
        Ok(Self { map: MarkedMap::new(map, marks, target), corners, evidence })
    }

    /// The map region → disk that it goes through.
    #[must_use]
    pub fn disk(&self) -> &RiemannMap {
        self.map.disk()
    }

    /// The four boundary points that go to the corners.
    #[must_use]
    pub fn corners(&self) -> [Complex64; 4] {
        self.corners
    }

    /// Width over height of the rectangle: the conformal modulus of the quadrilateral, the extremal distance between its side
    /// from the last corner to the first and the opposite one.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        self.map.target().aspect
    }

    /// Region → rectangle. NaN outside the closed region.
    #[must_use]
    pub fn to_rectangle(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points)
    }

    /// Rectangle → region, the inverse of [`RectangleMap::to_rectangle`]. NaN outside the closed rectangle.
    #[must_use]
    pub fn from_rectangle(&self, points: &[Complex64]) -> Vec<Complex64> {
        places(points, |w| self.map.inverse(w))
    }

    /// f' of the map region → rectangle, per plane unit. NaN outside the closed region.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points)
    }
}

evidence_methods!(
    RectangleMap,
    "of the aspect, relative to it, and of images, the rectangle's shorter side being 1. Beside a corner that is no vertex of the boundary the map itself makes √δ of an error δ."
);
two_ways!(RectangleMap, map.inverse);

/// |ab||cd|/(|bc||da|) of four marks: 0 if ab and cd are short.
fn cross_ratio(marks: &Marks, [a, b, c, d]: [usize; 4]) -> f64 {
    let chord = |i: usize, j: usize| marks.chord(i, j).norm();
    (chord(a, b) / chord(b, c)) * (chord(c, d) / chord(d, a))
}

/// The point that goes to the middle of side ab, for marks that go to −1, 1, 1/k.
fn middle_of_side(marks: &Marks, k: f64, [a, b, c]: [usize; 3]) -> DiskPoint {
    let chart = marks.best(a, b);
    let [p, q, r] = [a, b, c].map(|mark| marks.at(chart, mark));
    // (u + 1)/(u − 1) is −1 there.
    let ratio = -(1.0 - k) / (1.0 + k) * (r - p) / (r - q);
    DiskPoint { chart, w: (p - ratio * q) / (1.0 - ratio) }.onto_circle()
}

/// By how much the aspect and images move, at most, when points of the circle do.
fn sensitivity(marks: &Marks) -> f64 {
    let sides = [(0, 1), (1, 2), (2, 3), (3, 0)];
    1.0 + sides.into_iter().map(|(i, j)| 2.0 / PI / marks.apart(i, j)).sum::<f64>()
}

/// The rectangle, and what takes the charts' disks there.
///
/// u = κ(w − O)/(w − P) takes the disk to the upper half plane, marks A, B, C, D to −1, 1, 1/k, −1/k, O and P being the middles of
/// the short sides AB and CD; v = 1/(ku) serves the half that u does not.
#[derive(Clone, Debug)]
struct Rectangle {
    aspect: f64,
    /// Whether it is longer in x than in y.
    lies: bool,
    /// The marks A, B, C and D.
    order: [usize; 4],
    modulus: Modulus,
    charts: Vec<Factors>,
    /// Of A to D, each in its home chart.
    gaps: [GapFactors; 4],
}

/// Of one chart: κ and O − P.
#[derive(Clone, Copy, Debug)]
struct Factors {
    kappa: Complex64,
    apart: Complex64,
}

/// 1 ∓ u = η(w − mark)/(w − other), for the mark at ±1 of u (or of v).
#[derive(Clone, Copy, Debug)]
struct GapFactors {
    eta: Complex64,
    /// mark − other.
    from_other: Complex64,
}

/// The marks O and P.
const MIDDLES: [usize; 2] = [4, 5];
/// How far beyond a side a point still belongs to the rectangle, in units of its shorter side and of its size.
const ON_SIDE: f64 = 1e-14;
/// Distance from a corner, in K, where sn is counted from it.
const NEAR_CORNER: f64 = 0.5;

/// A point of the rectangle: u or v.
#[derive(Clone, Copy, Debug)]
struct Half {
    value: Complex64,
    is_far: bool,
    /// Beside A, B, C or D: which, and 1 ∓ value.
    corner: Option<(usize, Complex64)>,
}

impl Rectangle {
    fn new(marks: &Marks, order: [usize; 4], k: f64, lies: bool) -> Self {
        let modulus = Modulus::new(k);
        let [o, p] = MIDDLES;
        let b = order[1];
        let first = marks.chord(b, p) / marks.chord(b, o);
        let factors = |chart: usize| Factors {
            kappa: first * marks.root(chart, p) / marks.root(chart, o),
            apart: marks.chord_in(chart, o, p),
        };
        let gaps = std::array::from_fn(|j| {
            let (mark, [own, other]) = (order[j], if j < 2 { [o, p] } else { [p, o] });
            let home = marks.list()[mark].home;
            let eta = marks.chord_in(home, own, other) / marks.chord_in(home, own, mark);
            GapFactors { eta, from_other: marks.chord_in(home, mark, other) }
        });
        // K'/(2K), by the means.
        let ratio = mean(((1.0 - k) * (1.0 + k)).sqrt()) / (2.0 * mean(k));
        let aspect = if lies { ratio } else { 1.0 / ratio };
        Self { aspect, lies, order, modulus, charts: (0..marks.charts()).map(factors).collect(), gaps }
    }

    /// ζ → the rectangle, up to a shift.
    fn turn(&self) -> Complex64 {
        if self.lies {
            Complex64::new(0.0, -0.5 / self.modulus.quarter)
        } else {
            Complex64::new(1.0 / self.modulus.height, 0.0)
        }
    }

    /// The corners that A, B, C and D go to.
    fn corners(&self) -> [Complex64; 4] {
        let a = self.aspect;
        let all = [(0.0, 0.0), (a, 0.0), (a, 1.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
        self.order.map(|mark| all[mark])
    }

    /// 1 ∓ (u or v) at a point beside corner `j`.
    fn gap(&self, j: usize, gap: Complex64) -> Complex64 {
        let GapFactors { eta, from_other, .. } = self.gaps[j];
        eta * gap / (gap + from_other)
    }
}

impl Target for Rectangle {
    type Key = Half;

    fn image(&self, marks: &Marks, seen: &Seen) -> (Complex64, Complex64) {
        let Factors { kappa, apart } = self.charts[seen.chart];
        let [o, p] = MIDDLES.map(|mark| seen.less(marks, mark));
        let Modulus { k, quarter, height, .. } = self.modulus;
        let u = kappa * o / p;
        // Also at P, where u is none.
        let is_far = u.is_nan() || u.norm_sqr() * k > 1.0;
        let (value, slope, side) = if is_far {
            let v = p / (o * kappa * k);
            (Complex64::new(v.re, v.im.min(0.0)), -apart / (o * o * kappa * k), -1.0)
        } else {
            (Complex64::new(u.re, u.im.max(0.0)), kappa * apart / (p * p), 1.0)
        };
        let (mut minus, mut plus) = (1.0 - value, 1.0 + value);
        if let Some((mark, gap)) = seen.gap
            && let Some(j) = self.order.iter().position(|other| *other == mark)
            && is_far == (j >= 2)
        {
            // −1 is where A and D go.
            *if j == 0 || j == 3 { &mut plus } else { &mut minus } = self.gap(j, gap);
        }
        let (zeta, onward) = self.modulus.integral(value, minus, plus, side);
        let zeta = if is_far { zeta + Complex64::new(0.0, height) } else { zeta };
        let turn = self.turn();
        let w = turn * (zeta + if self.lies { -quarter } else { quarter });
        (Complex64::new(w.re.clamp(0.0, self.aspect), w.im.clamp(0.0, 1.0)), turn * onward * slope)
    }

    fn key(&self, image: Complex64) -> Option<(Half, bool)> {
        let far = Complex64::new(self.aspect, 1.0);
        let room = ON_SIDE * (self.aspect + self.aspect.min(1.0));
        let (beyond, before) = (image - far, -image);
        let outside = beyond.re.max(beyond.im).max(before.re).max(before.im);
        if outside.is_nan() || outside > room || image.is_nan() {
            return None;
        }
        let image = Complex64::new(image.re.clamp(0.0, far.re), image.im.clamp(0.0, far.im));
        let is_boundary = outside >= -room;
        let quarter = self.modulus.quarter;
        // Counted from the nearest corner, in ζ.
        let from = self.corners().map(|corner| (image - corner) / self.turn());
        let j = (0..4).min_by(|i, j| from[*i].norm().total_cmp(&from[*j].norm()))?;
        // B and C lie at K, A and D at −K.
        let sign = if j == 1 || j == 2 { 1.0 } else { -1.0 };
        let x = -sign * from[j];
        let real = |z: Complex64| if is_boundary { Complex64::new(z.re, 0.0) } else { z };
        let half = if x.norm() < NEAR_CORNER * quarter {
            let gap = real(self.modulus.one_minus_sn(x));
            Half { value: sign * (1.0 - gap), is_far: j >= 2, corner: Some((j, gap)) }
        } else {
            Half { value: real(self.modulus.sn(from[j] + sign * quarter)), is_far: j >= 2, corner: None }
        };
        Some((half, is_boundary))
    }

    fn in_chart(&self, marks: &Marks, key: &Half, chart: usize) -> Complex64 {
        let kappa = self.charts[chart].kappa;
        let [o, p] = MIDDLES.map(|mark| marks.at(chart, mark));
        if key.is_far {
            let t = key.value * self.modulus.k * kappa;
            (p - t * o) / (1.0 - t)
        } else {
            let t = key.value / kappa;
            (o - t * p) / (1.0 - t)
        }
    }

    fn slope(&self, key: &Half, chart: usize) -> f64 {
        let Factors { kappa, apart } = self.charts[chart];
        // |du/dw| or |k dv/dw|: w − P is (O − P)/(1 − t) where u = κt.
        let (t, factor) =
            if key.is_far { (key.value * self.modulus.k * kappa, kappa.inv()) } else { (key.value / kappa, kappa) };
        (factor / apart).norm() * (1.0 - t).norm_sqr()
    }

    fn beside(&self, _: &Marks, key: &Half) -> Option<Gap> {
        let (j, gap) = key.corner?;
        let GapFactors { eta, from_other, .. } = self.gaps[j];
        Some((self.order[j], gap * from_other / (eta - gap)))
    }
}
