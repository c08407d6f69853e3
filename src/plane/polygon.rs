//! Simple polygons, counter-clockwise.

use super::{Complex64, edge_tree::EdgeTree};
use crate::{Error, Result};
use robust::{Coord, orient2d};

/// A simple polygon with finite, distinct, counter-clockwise vertices. Collinear vertices are kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    vertices: Vec<Complex64>,
    /// What the predicates are asked relative to: 0, or where the polygon is if that is far away.
    origin: Complex64,
    /// (`vertices` − `origin`) × `unit`: within the unit square, so that predicates neither overflow nor underflow.
    scaled: Vec<Complex64>,
    /// A power of two, so that scaling by it is exact.
    unit: f64,
    /// Over the scaled edges.
    tree: EdgeTree,
}

/// A point of the boundary: `vertices[edge] + t·(vertices[edge + 1] − vertices[edge])`, t in [0, 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundaryPoint {
    /// The edge it lies on.
    pub edge: usize,
    /// The share of the edge before it.
    pub t: f64,
    /// The point itself.
    pub point: Complex64,
}

impl Polygon {
    /// Checks that the vertices make a simple polygon and puts them in counter-clockwise order, the first one first.
    /// A repeated vertex (also the last one repeating the first) is dropped.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooFewVertices`], [`Error::SelfIntersecting`].
    pub fn new(vertices: &[Complex64]) -> Result<Self> {
        if let Some(index) = vertices.iter().position(|v| !v.is_finite()) {
            return Err(Error::NotFinite { what: format!("Boundary point {index}") });
        }
        let origin = origin_of(vertices);
        let reach = |v: &Complex64| (v.re - origin.re).abs().max((v.im - origin.im).abs());
        let unit = power_of_two_below(1.0 / vertices.iter().map(reach).fold(0.0, f64::max));
        let mut scaled: Vec<Complex64> = Vec::with_capacity(vertices.len());
        let mut kept: Vec<Complex64> = Vec::with_capacity(vertices.len());
        for &v in vertices {
            let at = (v - origin) * unit;
            if scaled.last().is_none_or(|&last| !same_point(last, at)) {
                scaled.push(at);
                kept.push(v);
            }
        }
        while scaled.len() > 1 && same_point(scaled[0], scaled[scaled.len() - 1]) {
            scaled.pop();
            kept.pop();
        }
        if scaled.len() < 3 {
            return Err(Error::TooFewVertices { found: scaled.len() });
        }
        let mut tree = EdgeTree::new(&scaled);
        if let Some((first, second, at)) = first_crossing(&scaled, &tree) {
            return Err(Error::SelfIntersecting { first, second, at: at / unit + origin });
        }
        if signed_area(&scaled) < 0.0 {
            scaled[1..].reverse();
            kept[1..].reverse();
            tree = EdgeTree::new(&scaled);
        }
        Ok(Self { vertices: kept, origin, scaled, unit, tree })
    }

    /// The same polygon, `by` plane units away; that should be no farther from 0 than this one, so that nothing is rounded.
    pub(crate) fn moved(&self, by: Complex64) -> Self {
        Self { vertices: self.vertices.iter().map(|v| v + by).collect(), origin: self.origin + by, ..self.clone() }
    }

    /// The same polygon clockwise, as the boundary of a hole: the region lies to the left. Everything that does not ask for an
    /// orientation answers as before, edges being counted in the new order.
    pub(crate) fn clockwise(&self) -> Self {
        let mut reversed = self.clone();
        reversed.vertices[1..].reverse();
        reversed.scaled[1..].reverse();
        reversed.tree = EdgeTree::new(&reversed.scaled);
        reversed
    }

    /// The first edge that meets an edge of another polygon, that edge, and a point of both.
    pub(crate) fn meets(&self, other: &Self) -> Option<(usize, usize, Complex64)> {
        let scaled = |z: Complex64| (z - self.origin) * self.unit;
        (0..other.len()).find_map(|second| {
            let (c, d) = other.edge(second);
            let (c, d) = (scaled(c), scaled(d));
            let mut met: Option<usize> = None;
            self.tree.for_each_near(c, d, |first| {
                let (a, b) = self.scaled_edge(first);
                if met.is_none_or(|met| first < met) && segments_meet(a, b, c, d) {
                    met = Some(first);
                }
            });
            let first = met?;
            let (a, b) = self.scaled_edge(first);
            Some((first, second, meeting_point(a, b, c, d) / self.unit + self.origin))
        })
    }

    /// What coordinates are best given relative to: 0, unless the polygon is small against its distance from there.
    pub(crate) fn origin(&self) -> Complex64 {
        self.origin
    }

    /// The vertices, counter-clockwise.
    #[must_use]
    pub fn vertices(&self) -> &[Complex64] {
        &self.vertices
    }

    /// Number of vertices, and of edges.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a polygon has at least 3 vertices")]
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The ends of edge `k`: vertex k and its successor.
    #[must_use]
    pub fn edge(&self, k: usize) -> (Complex64, Complex64) {
        (self.vertices[k], self.vertices[(k + 1) % self.len()])
    }

    /// Area enclosed, in square plane units.
    #[must_use]
    pub fn area(&self) -> f64 {
        signed_area(&self.scaled) / self.unit / self.unit
    }

    /// Lower left and upper right corners of the bounding box.
    #[must_use]
    pub fn bounds(&self) -> (Complex64, Complex64) {
        let first = self.vertices[0];
        self.vertices.iter().fold((first, first), |(low, high), v| {
            (Complex64::new(low.re.min(v.re), low.im.min(v.im)), Complex64::new(high.re.max(v.re), high.im.max(v.im)))
        })
    }

    /// The larger side of the bounding box, in plane units.
    #[must_use]
    pub fn size(&self) -> f64 {
        let (low, high) = self.bounds();
        (high.re - low.re).max(high.im - low.im)
    }

    /// Whether `z` lies inside; points of the boundary count as inside. False for NaN.
    #[must_use]
    pub fn contains(&self, z: Complex64) -> bool {
        matches!(self.side(z), Some(Side::Inside | Side::On))
    }

    /// Whether `z` lies inside and not on the boundary.
    #[must_use]
    pub fn contains_strictly(&self, z: Complex64) -> bool {
        self.side(z) == Some(Side::Inside)
    }

    /// The point of the boundary nearest to `z`.
    #[must_use]
    pub fn nearest(&self, z: Complex64) -> BoundaryPoint {
        let z = (z - self.origin) * self.unit;
        let (_, edge) = self.tree.nearest(z, f64::INFINITY, |k| (z - self.foot(z, k).1).norm_sqr());
        self.point_below(z, edge.unwrap_or(0))
    }

    /// The point of the boundary nearest to `z`, if it is nearer than `limit`.
    #[must_use]
    pub fn nearest_within(&self, z: Complex64, limit: f64) -> Option<BoundaryPoint> {
        let z = (z - self.origin) * self.unit;
        let bound = (limit * self.unit).powi(2);
        let (_, edge) = self.tree.nearest(z, bound, |k| (z - self.foot(z, k).1).norm_sqr());
        edge.map(|edge| self.point_below(z, edge))
    }

    /// The point of an edge nearest to `z` (scaled).
    fn point_below(&self, z: Complex64, edge: usize) -> BoundaryPoint {
        let (t, foot) = self.foot(z, edge);
        if t == 1.0 {
            let edge = (edge + 1) % self.len();
            return BoundaryPoint { edge, t: 0.0, point: self.vertices[edge] };
        }
        BoundaryPoint { edge, t, point: if t == 0.0 { self.vertices[edge] } else { foot / self.unit + self.origin } }
    }

    /// Distance (plane units) from vertex `k` to the nearest edge that does not end there, or the length of the shorter edge
    /// that does, if that is less.
    #[must_use]
    pub fn clearance(&self, k: usize) -> f64 {
        let n = self.len();
        let (z, before) = (self.scaled[k], (k + n - 1) % n);
        let adjacent = (self.scaled[(k + 1) % n] - z).norm_sqr().min((self.scaled[before] - z).norm_sqr());
        let distance = |j: usize| {
            if j == k || j == before { f64::INFINITY } else { (z - self.foot(z, j).1).norm_sqr() }
        };
        self.tree.nearest(z, adjacent, distance).0.sqrt() / self.unit
    }

    /// The nearest edge that lies in the direction of the unit vector `toward` as seen from `z`, give or take 60°, and its
    /// distance; of edges nearer than `reach`.
    #[must_use]
    pub(crate) fn facing(&self, z: Complex64, toward: Complex64, reach: f64) -> Option<(usize, f64)> {
        let (z, reach) = (z * self.unit, reach * self.unit);
        let distance_sqr = |k: usize| {
            let away = self.foot(z, k).1 - z;
            let square = away.norm_sqr();
            if (away * toward.conj()).re >= 0.5 * square.sqrt() && square > 0.0 { square } else { f64::INFINITY }
        };
        let (square, edge) = self.tree.nearest(z, reach * reach, distance_sqr);
        Some((edge?, square.sqrt() / self.unit))
    }

    /// The point of edge `k` nearest to `z` (both scaled), and its share of the edge.
    fn foot(&self, z: Complex64, k: usize) -> (f64, Complex64) {
        let (a, b) = self.scaled_edge(k);
        let t = (((z - a) * (b - a).conj()).re / (b - a).norm_sqr()).clamp(0.0, 1.0);
        (t, a + (b - a) * t)
    }

    fn scaled_edge(&self, k: usize) -> (Complex64, Complex64) {
        (self.scaled[k], self.scaled[(k + 1) % self.len()])
    }

    /// The side of the boundary that `z` is on, by the crossing number; `None` for a point that is not finite.
    fn side(&self, z: Complex64) -> Option<Side> {
        let z = (z - self.origin) * self.unit;
        if !z.is_finite() {
            return None;
        }
        let (mut inside, mut on_boundary) = (false, false);
        self.tree.for_each_on_ray(z, |k| {
            let (a, b) = self.scaled_edge(k);
            on_boundary |= lies_on(z, a, b);
            if (a.im <= z.im) != (b.im <= z.im) && (orient2d(coord(a), coord(b), coord(z)) > 0.0) == (b.im > a.im) {
                inside = !inside;
            }
        });
        Some(if on_boundary {
            Side::On
        } else if inside {
            Side::Inside
        } else {
            Side::Outside
        })
    }
}

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Inside,
    On,
    Outside,
}

fn coord(z: Complex64) -> Coord<f64> {
    Coord { x: z.re, y: z.im }
}

/// The largest power of two that is at most `x` (1 where `x` is not a positive finite number).
fn power_of_two_below(x: f64) -> f64 {
    if x.is_normal() && x > 0.0 { f64::from_bits(x.to_bits() & 0x7ff0_0000_0000_0000) } else { 1.0 }
}

/// This share of the region's size, or of its distance from 0 if that is larger: nearer to the boundary than this is on it.
pub(crate) const ON_BOUNDARY: f64 = 4.0 * f64::EPSILON;
/// A polygon farther from 0 than this many times its size is looked at from its middle.
const FAR: f64 = 4.0;

/// What coordinates of points are best given relative to: in each coordinate 0, unless all points are far from it; then
/// differences are exact.
pub(super) fn origin_of(points: &[Complex64]) -> Complex64 {
    let middle = |coordinate: fn(&Complex64) -> f64| {
        let (low, high) = points
            .iter()
            .map(coordinate)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (x.min(low), x.max(high)));
        let middle = 0.5 * low + 0.5 * high;
        if middle.abs() > FAR * (high - low) { middle } else { 0.0 }
    };
    Complex64::new(middle(|z| z.re), middle(|z| z.im))
}

/// Equal up to rounding of coordinates of size 1.
fn same_point(a: Complex64, b: Complex64) -> bool {
    (a - b).norm_sqr() <= (4.0 * f64::EPSILON) * (4.0 * f64::EPSILON)
}

fn signed_area(vertices: &[Complex64]) -> f64 {
    let origin = vertices[0];
    let mut twice = 0.0;
    for pair in vertices[1..].windows(2) {
        let (a, b) = (pair[0] - origin, pair[1] - origin);
        twice += a.re * b.im - a.im * b.re;
    }
    0.5 * twice
}

/// Whether `p` lies on the closed segment ab.
fn lies_on(p: Complex64, a: Complex64, b: Complex64) -> bool {
    let within = |p: f64, a: f64, b: f64| p >= a.min(b) && p <= a.max(b);
    within(p.re, a.re, b.re) && within(p.im, a.im, b.im) && orient2d(coord(a), coord(b), coord(p)) == 0.0
}

/// Whether the closed segments ab and cd share a point.
fn segments_meet(a: Complex64, b: Complex64, c: Complex64, d: Complex64) -> bool {
    let [a1, b1, c1, d1] = [a, b, c, d].map(coord);
    let (abc, abd) = (orient2d(a1, b1, c1), orient2d(a1, b1, d1));
    let (cda, cdb) = (orient2d(c1, d1, a1), orient2d(c1, d1, b1));
    let opposite = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
    (opposite(abc, abd) && opposite(cda, cdb))
        || lies_on(a, c, d)
        || lies_on(b, c, d)
        || lies_on(c, a, b)
        || lies_on(d, a, b)
}

/// The first two edges, in boundary order, that share more than the vertex between them, and a point of both.
fn first_crossing(vertices: &[Complex64], tree: &EdgeTree) -> Option<(usize, usize, Complex64)> {
    let n = vertices.len();
    let ends = |k: usize| (vertices[k], vertices[(k + 1) % n]);
    (0..n).find_map(|first| {
        let (a, b) = ends(first);
        let mut met = None;
        tree.for_each_near(a, b, |second| {
            if second <= first || met.is_some_and(|met| met < second) {
                return;
            }
            let (c, d) = ends(second);
            let meet = if first + 1 == second {
                folds_back(a, b, d)
            } else if (second + 1) % n == first {
                folds_back(c, a, b)
            } else {
                segments_meet(a, b, c, d)
            };
            if meet {
                met = Some(second);
            }
        });
        met.map(|second| {
            let (c, d) = ends(second);
            (first, second, meeting_point(a, b, c, d))
        })
    })
}

/// Whether the edges ab and bc, which share b, overlap.
fn folds_back(a: Complex64, b: Complex64, c: Complex64) -> bool {
    orient2d(coord(a), coord(b), coord(c)) == 0.0 && ((a - b) * (c - b).conj()).re > 0.0
}

/// A point that the segments ab and cd, which meet, have in common: the middle of it, if that is a segment.
fn meeting_point(a: Complex64, b: Complex64, c: Complex64, d: Complex64) -> Complex64 {
    let on = |p: Complex64| [(a, b), (c, d)].iter().all(|&(from, to)| lies_on(p, from, to));
    let common: Vec<Complex64> = [a, b, c, d].into_iter().filter(|&p| on(p)).collect();
    if let Some(&one) = common.first() {
        let far = common.iter().max_by(|p, q| (*p - one).norm_sqr().total_cmp(&(*q - one).norm_sqr()));
        return far.map_or(one, |far| 0.5 * (one + far));
    }
    let cross = |u: Complex64, v: Complex64| u.re * v.im - u.im * v.re;
    let t = cross(c - a, d - c) / cross(b - a, d - c);
    a + (b - a) * t.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(xy: &[(f64, f64)]) -> Vec<Complex64> {
        xy.iter().map(|&(x, y)| Complex64::new(x, y)).collect()
    }

    const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

    #[test]
    fn clockwise_input_is_reversed_and_repeats_are_dropped() {
        let square =
            Polygon::new(&points(&[(0.0, 0.0), (0.0, 1.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)])).unwrap();
        assert_eq!(square.vertices(), points(&SQUARE));
        assert_eq!(square.area(), 1.0);
    }

    #[test]
    fn crossings_touches_and_folds_are_refused() {
        let bad: [&[(f64, f64)]; 4] = [
            &[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)],
            &[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 0.0), (0.0, 2.0)],
            &[(0.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0)],
            &[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)],
        ];
        for xy in bad {
            assert_eq!(Polygon::new(&points(xy)).unwrap_err().code(), "self-intersecting", "{xy:?}");
        }
        assert_eq!(Polygon::new(&points(&SQUARE[..2])).unwrap_err(), Error::TooFewVertices { found: 2 });
        assert_eq!(Polygon::new(&points(&[(0.0, f64::NAN)])).unwrap_err().code(), "not-finite");
    }

    #[test]
    fn contains_knows_the_boundary() {
        for scale in [1e-150, 1e-3, 1.0, 1e150] {
            let v: Vec<_> = points(&SQUARE).iter().map(|v| v * scale).collect();
            let square = Polygon::new(&v).unwrap();
            let at = |x: f64, y: f64| Complex64::new(x, y) * scale;
            assert!(square.contains_strictly(at(0.5, 0.5)));
            assert!(square.contains(at(1.0, 0.25)) && !square.contains_strictly(at(1.0, 0.25)));
            assert!(square.contains(at(0.0, 0.0)) && square.contains(at(0.5, 1.0)));
            assert!(!square.contains(at(1.0 + 1e-9, 0.5)) && !square.contains(at(0.5, f64::NAN)));
        }
    }

    #[test]
    fn nearest_point_names_its_edge() {
        let square = Polygon::new(&points(&SQUARE)).unwrap();
        let on = square.nearest(Complex64::new(0.25, -3.0));
        assert_eq!((on.edge, on.t, on.point), (0, 0.25, Complex64::new(0.25, 0.0)));
        let corner = square.nearest(Complex64::new(2.0, -1.0));
        assert_eq!((corner.edge, corner.t, corner.point), (1, 0.0, Complex64::new(1.0, 0.0)));
    }

    #[test]
    fn the_place_of_a_crossing_is_on_both_edges() {
        let overlap: [&[(f64, f64)]; 2] = [
            &[(10.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0), (0.0, 0.0), (12.0, 0.0)],
            &[(0.0, 0.0), (8.0, 0.0), (8.0, 5.0), (6.0, 5.0), (6.0, 0.0), (3.0, 0.0), (3.0, 5.0), (0.0, 5.0)],
        ];
        for (xy, range) in overlap.into_iter().zip([10.0..=12.0, 3.0..=6.0]) {
            let Error::SelfIntersecting { at, .. } = Polygon::new(&points(xy)).unwrap_err() else { panic!("{xy:?}") };
            assert!(range.contains(&at.re) && at.im == 0.0, "{at}");
        }
        let crossed = Polygon::new(&points(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)])).unwrap_err();
        assert_eq!(crossed, Error::SelfIntersecting { first: 0, second: 2, at: Complex64::new(0.5, 0.5) });
    }
}
