//! A closed chain of analytic edges.

use super::edge_pieces::EdgePieces;
use super::horn::CutHorns;
use super::polygon::ON_BOUNDARY;
use super::{BoundaryPoint, Complex64, Edge, Polygon};
use crate::{Error, Result};
use std::f64::consts::PI;

/// Edges that each start where the last one ends, around a region on their left.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvedOutline {
    edges: Vec<Edge>,
    /// Interior angle where each edge starts, divided by π, in [0, 2).
    alpha: Vec<f64>,
    size: f64,
    thickness: f64,
    /// Of the chain without the tips of its horns.
    pieces: EdgePieces,
    horns: Option<CutHorns>,
}

/// Ends that are apart less than this share of the outline's size are one point.
const JOINED: f64 = 1e-9;
/// By how much more than vertices points of curves are rounded.
const ROUNDING: f64 = 4.0;

impl CurvedOutline {
    /// A chain of edges around a region, in either orientation; one that runs clockwise is turned around.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::InvalidOutline`] for gaps between edges and edges of no length; [`Error::Cusp`] for interior
    /// angles of 2π; [`Error::SelfIntersecting`] if edges cross or touch themselves or others.
    pub fn new(edges: &[Edge]) -> Result<Self> {
        let n = edges.len();
        if n == 0 {
            return Err(wrong("it has no edges".to_string()));
        }
        let edges: &[Edge] = &edges.iter().map(straightened).collect::<Vec<_>>();
        if let Some(k) = edges.iter().position(Edge::overlaps_itself) {
            return Err(wrong(format!("edge {k} is an arc of more than a full turn")));
        }
        let corners: Vec<(Complex64, Complex64)> = edges.iter().map(Edge::bounds).collect();
        if corners.iter().any(|(low, high)| !low.is_finite() || !high.is_finite()) {
            return Err(Error::NotFinite { what: "The outline".to_string() });
        }
        let low = corners.iter().fold(corners[0].0, |a, (b, _)| Complex64::new(a.re.min(b.re), a.im.min(b.im)));
        let high = corners.iter().fold(corners[0].1, |a, (_, b)| Complex64::new(a.re.max(b.re), a.im.max(b.im)));
        let size = (high.re - low.re).max(high.im - low.im);
        for (k, edge) in edges.iter().enumerate() {
            if (edge.to() - edges[(k + 1) % n].from()).norm() > JOINED * size {
                return Err(wrong(format!("edge {k} does not end where the next one starts")));
            }
            if !edge.start_direction().is_finite() || !edge.end_direction().is_finite() {
                return Err(wrong(format!("edge {k} has no length")));
            }
        }
        let horns = CutHorns::thin(edges, size)?;
        let (pieces, clockwise) = match &horns {
            Some(horns) => EdgePieces::new(horns.edges(), size).map_err(|error| horns.named(error))?,
            None => EdgePieces::new(edges, size)?,
        };
        let turned = || edges.iter().rev().map(Edge::reversed).collect::<Vec<_>>();
        if clockwise && horns.is_some() {
            return Self::new(&turned());
        }
        let edges = if clockwise { turned() } else { edges.to_vec() };
        let mut alpha: Vec<f64> = (0..n).map(|k| 1.0 - turn_before(&edges, k) / PI).collect();
        if let Some(horns) = &horns {
            for (cut, corner) in horns.cuts() {
                // The horn must be the region's, not that of what is outside.
                if turn_before(horns.edges(), cut) < 0.0 {
                    return Err(Error::Cusp { edge: corner, at: edges[corner].from() });
                }
                alpha[corner] = 0.0;
            }
        }
        let thickness = thickness_of(pieces.polygon(), size);
        Ok(Self { edges, alpha, size, thickness, pieces, horns })
    }

    /// The edges, counter-clockwise.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Interior angle where edge `k` starts, divided by π.
    #[must_use]
    pub fn alpha(&self, k: usize) -> f64 {
        self.alpha[k]
    }

    /// The larger side of the box around it.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The same outline, `by` plane units away.
    #[must_use]
    pub fn moved(&self, by: Complex64) -> Self {
        let edges = self.edges.iter().map(|edge| edge.moved(by)).collect();
        let horns = self.horns.as_ref().map(|horns| horns.moved(by));
        let pieces = self.pieces.moved(by);
        Self { edges, thickness: thickness_of(pieces.polygon(), self.size), pieces, horns, ..self.clone() }
    }

    /// A corner of interior angle 0, if it has one.
    pub(crate) fn tip(&self) -> Option<Complex64> {
        let corner = self.alpha.iter().position(|alpha| *alpha == 0.0)?;
        Some(self.edges[corner].from())
    }

    /// Its horns, corners of interior angle 0, if it has any.
    pub(crate) fn horns(&self) -> Option<&CutHorns> {
        self.horns.as_ref()
    }

    /// A point inside, not near the edges as far as there is such a one.
    pub(crate) fn inner_point(&self) -> Complex64 {
        const DEEPEST: i32 = 24;
        // Where it is thin, left of the middles of its edges.
        let beside = |edge: &Edge| {
            let (middle, along) = (edge.point(0.5), edge.tangent(0.5.into()));
            let left = Complex64::i() * along / along.norm() * self.size;
            (1..DEEPEST).map(move |k| middle + left * 2f64.powi(-k))
        };
        let others: Vec<Complex64> = self.edges.iter().flat_map(beside).collect();
        super::inner_point(self.bounds(), &others, &|z| self.signed_distance(z))
    }

    /// Lower left and upper right corners of the bounding box.
    #[must_use]
    pub fn bounds(&self) -> (Complex64, Complex64) {
        self.pieces.polygon().bounds()
    }

    /// The polygon that it looks like: no farther from it than two millionths of its size.
    #[must_use]
    pub fn polygon(&self) -> &Polygon {
        self.pieces.polygon()
    }

    /// Whether `z` lies inside, or on the edges up to rounding. False for NaN.
    #[must_use]
    pub fn contains(&self, z: Complex64) -> bool {
        self.pieces.contains(z) || self.on_edge(z).is_some()
    }

    /// Whether `z` lies inside, farther from the edges than this.
    #[must_use]
    pub fn is_deeper(&self, z: Complex64, than: f64) -> bool {
        self.pieces.contains(z) && self.pieces.nearest_within(z, than).is_none()
    }

    /// Distance from the edges, positive inside; negative infinity for NaN.
    #[must_use]
    pub fn signed_distance(&self, z: Complex64) -> f64 {
        if !z.is_finite() {
            return f64::NEG_INFINITY;
        }
        let (_, distance) = self.pieces.nearest(z);
        match self.pieces.contains(z) {
            true => distance,
            false if self.in_tip(z).is_some() => 0.0,
            false => -distance,
        }
    }

    /// The point of the edges nearest to `z`: edge and parameter t in [0, 1).
    #[must_use]
    pub fn nearest(&self, z: Complex64) -> BoundaryPoint {
        self.of_outline(self.pieces.nearest(z).0)
    }

    /// A place on the chain that the pieces are of, on the outline.
    fn of_outline(&self, place: BoundaryPoint) -> BoundaryPoint {
        let Some(horns) = &self.horns else { return place };
        let (edge, t) = horns.outer(place.edge, place.t);
        self.place(edge, t)
    }

    /// The point of the edges that `z` is, up to rounding.
    #[must_use]
    pub fn on_edge(&self, z: Complex64) -> Option<BoundaryPoint> {
        if let Some((place, _)) = self.pieces.nearest_within(z, self.thickness) {
            return Some(self.of_outline(place));
        }
        self.in_tip(z).map(|(edge, t)| self.place(edge, t))
    }

    /// The edge and parameter that `z` is where a horn is too thin for pieces.
    fn in_tip(&self, z: Complex64) -> Option<(usize, f64)> {
        self.horns.as_ref()?.in_tip(z, self.thickness)
    }

    /// Points as near to the edges as this are on them, as far as numbers can tell.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// The point of edge `edge` at its parameter `t`.
    #[must_use]
    pub fn place(&self, edge: usize, t: f64) -> BoundaryPoint {
        BoundaryPoint { edge, t, point: self.edges[edge].point(t) }
    }
}

/// Control points are on a line with the ends that leave it by no more than this share of it.
const COLLINEAR: f64 = 1e-13;

/// The line that a Bézier curve runs along without turning back, if it does: its parameter may stand still on the way, which a line's
/// does not.
fn straightened(edge: &Edge) -> Edge {
    let inner = match edge {
        Edge::Quadratic([a, b, c]) => [a + (b - a) * (2.0 / 3.0), c + (b - c) * (2.0 / 3.0)],
        Edge::Cubic([_, b, c, _]) => [*b, *c],
        Edge::Line { .. } | Edge::Arc(_) => return *edge,
    };
    let way = edge.to() - edge.from();
    // Along the line from 0 to 1, and across it.
    let [p, q] = inner.map(|control| (control - edge.from()) / way);
    let speeds = [p.re, q.re - p.re, 1.0 - q.re];
    let is_straight = p.im.abs() <= COLLINEAR && q.im.abs() <= COLLINEAR;
    let goes_on =
        speeds[0] >= 0.0 && speeds[2] >= 0.0 && speeds[1] >= -(speeds[0] * speeds[2]).sqrt() * (1.0 + COLLINEAR);
    if is_straight && goes_on { Edge::line(edge.from(), edge.to()) } else { *edge }
}

/// How far from a polygon's coordinates, and from the edges that it looks like, rounding may take a point.
fn thickness_of(polygon: &Polygon, size: f64) -> f64 {
    let (low, high) = polygon.bounds();
    let reach = [low.re, low.im, high.re, high.im].into_iter().map(f64::abs).fold(size, f64::max);
    ROUNDING * ON_BOUNDARY * reach
}

fn wrong(reason: String) -> Error {
    Error::InvalidOutline { reason }
}

/// The angle, from −π to π, by which the outline turns to the left where edge `k` starts.
fn turn_before(edges: &[Edge], k: usize) -> f64 {
    let before = &edges[(k + edges.len() - 1) % edges.len()];
    (edges[k].start_direction() * before.end_direction().conj()).arg()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_disk() -> [Edge; 2] {
        let one = Complex64::ONE;
        [Edge::line(-one, one), Edge::circular(Complex64::ZERO, 1.0, 0.0, PI)]
    }

    #[test]
    fn corners_of_a_half_disk_are_right_angles_either_way_around() {
        for edges in [half_disk(), half_disk().map(|edge| edge.reversed())] {
            let edges = if edges[0].from().re < 0.0 { edges } else { [edges[0], edges[1]] };
            let outline = CurvedOutline::new(&edges).unwrap();
            for k in 0..2 {
                assert!((outline.alpha(k) - 0.5).abs() < 1e-15);
            }
            assert_eq!(outline.size(), 2.0);
        }
    }

    /// A cubic letter "D" with a bow, an elliptic arc and a quadratic.
    fn bow() -> [Edge; 4] {
        let at = Complex64::new;
        let arc = crate::plane::ArcTo { radii: (2.0, 1.0), rotation: 0.3, large: false, counterclockwise: true };
        [
            Edge::Cubic([at(0.0, 0.0), at(1.0, -2.0), at(2.0, 1.5), at(3.0, 0.0)]),
            Edge::arc_to(at(3.0, 0.0), at(2.0, 2.0), arc),
            Edge::Quadratic([at(2.0, 2.0), at(1.0, 1.0), at(0.0, 2.0)]),
            Edge::line(at(0.0, 2.0), at(0.0, 0.0)),
        ]
    }

    #[test]
    fn sides_are_told_apart_and_feet_found_to_rounding() {
        let outline = CurvedOutline::new(&bow()).unwrap();
        for (k, edge) in outline.edges().iter().enumerate() {
            for t in [1e-6, 0.01, 0.3, 0.5, 0.77, 0.999] {
                let z = edge.point(t);
                let along = edge.tangent(t.into());
                let normal = Complex64::i() * along / along.norm();
                for depth in [1e-14, 1e-9, 1e-7] {
                    for side in [1.0, -1.0] {
                        let found = outline.signed_distance(z + normal * (side * depth));
                        assert!((found - side * depth).abs() < 2e-15, "{k} {t} {depth}: {found}");
                    }
                    let foot = outline.nearest(z + normal * depth);
                    let miss = (foot.point - z).norm().max((foot.t - t).abs() * along.norm());
                    assert!(foot.edge == k && miss < 3e-15 + 1e-8 * depth, "{k} {t} {depth}: {miss}");
                }
                assert!(outline.contains(z) && outline.on_edge(z).is_some());
                assert_eq!(outline.place(k, t).point, z);
            }
        }
        let nan = Complex64::new(f64::NAN, 0.0);
        assert!(!outline.contains(nan) && outline.signed_distance(nan) < 0.0);
    }

    #[test]
    fn nearest_points_are_nearest_of_many() {
        let outline = CurvedOutline::new(&bow()).unwrap();
        let samples: Vec<Complex64> =
            outline.edges().iter().flat_map(|edge| (0..4000).map(|j| edge.point(f64::from(j) / 4000.0))).collect();
        for k in 0..200 {
            let (x, y) = (f64::from(k % 20) * 0.25 - 1.0, f64::from(k / 20) * 0.4 - 1.0);
            let z = Complex64::new(x + 0.013, y + 0.007);
            let least = samples.iter().map(|sample| (sample - z).norm()).fold(f64::INFINITY, f64::min);
            let found = (outline.nearest(z).point - z).norm();
            assert!(found <= least + 1e-15 && found > least - 1e-3, "{z}: {found} {least}");
            // Far from the edges the polygon decides likewise.
            if found > 1e-4 {
                assert_eq!(outline.contains(z), outline.polygon().contains(z), "{z}");
            }
        }
    }

    #[test]
    fn edges_that_cross_are_named_either_way_around() {
        let at = Complex64::new;
        // A cubic with a loop, closed by a line; and an arc that two lines cross.
        let loops = [
            Edge::Cubic([at(0.0, 0.0), at(4.0, 3.0), at(-3.0, 3.0), at(1.0, 0.0)]),
            Edge::line(at(1.0, 0.0), at(0.0, 0.0)),
        ];
        let crossed = [
            Edge::circular(at(0.0, 0.0), 1.0, 0.0, PI),
            Edge::line(at(-1.0, 0.0), at(-1.0, -1.0)),
            Edge::line(at(-1.0, -1.0), at(0.0, 1.001)),
            Edge::line(at(0.0, 1.001), at(1.0, 0.0)),
        ];
        for (edges, pair) in [(&loops[..], (0, 0)), (&crossed[..], (0, 3))] {
            let n = edges.len();
            let Err(Error::SelfIntersecting { first, second, .. }) = CurvedOutline::new(edges) else {
                panic!("{edges:?} is accepted")
            };
            assert_eq!((first, second), pair);
            let back: Vec<Edge> = edges.iter().rev().map(Edge::reversed).collect();
            let Err(Error::SelfIntersecting { first, second, .. }) = CurvedOutline::new(&back) else {
                panic!("{back:?} is accepted")
            };
            assert!(n - 1 - second == pair.0 && n - 1 - first <= pair.1);
        }
    }

    #[test]
    fn edges_nearly_touch_without_crossing() {
        let at = Complex64::new;
        // A bridge over a bump, as near as 1e-9.
        for gap in [1e-3, 1e-6, 1e-9] {
            let edges = [
                Edge::circular(at(0.0, 0.0), 1.0, PI, -PI),
                Edge::line(at(1.0, 0.0), at(2.0, 0.0)),
                Edge::line(at(2.0, 0.0), at(2.0, 1.0 + gap)),
                Edge::line(at(2.0, 1.0 + gap), at(-2.0, 1.0 + gap)),
                Edge::line(at(-2.0, 1.0 + gap), at(-2.0, 0.0)),
                Edge::line(at(-2.0, 0.0), at(-1.0, 0.0)),
            ];
            let outline = CurvedOutline::new(&edges).unwrap();
            let middle = outline.signed_distance(at(0.0, 1.0 + 0.5 * gap));
            assert!((middle - 0.5 * gap).abs() < 1e-15, "{gap}: {middle}");
            let mut through = edges;
            through[0] = Edge::circular(at(0.0, 2.0 * gap), 1.0, PI, -PI);
            assert!(CurvedOutline::new(&through).is_err(), "{gap}");
        }
    }

    #[test]
    fn curves_that_run_along_a_line_are_lines_unless_they_turn_back() {
        let at = Complex64::new;
        let [a, b] = [at(1.0, 2.0), at(4.0, 3.0)];
        let mix = |t: f64| a + (b - a) * t;
        let lines = [
            Edge::Cubic([a, a, a, b]),
            Edge::Cubic([a, b, b, b]),
            // Its parameter stands still in the middle.
            Edge::Cubic([a, b, a, b]),
            Edge::Cubic([a, mix(0.2), mix(0.9), b]),
            Edge::Quadratic([a, a, b]),
            Edge::Quadratic([a, mix(0.7), b]),
        ];
        assert!(lines.iter().all(|edge| straightened(edge) == Edge::line(a, b)));
        let curves = [
            Edge::Cubic([a, mix(1.2), mix(-0.2), b]),
            Edge::Quadratic([a, mix(1.1), b]),
            Edge::Cubic([a, mix(0.3) + at(0.0, 1e-9), mix(0.6), b]),
            Edge::Cubic([a, b, b, a]),
        ];
        assert!(curves.iter().all(|edge| straightened(edge) == *edge));
    }

    #[test]
    fn one_edge_alone_can_close() {
        let circle = CurvedOutline::new(&[Edge::circular(Complex64::ONE, 1.0, 0.5, 2.0 * PI)]).unwrap();
        assert!((circle.alpha(0) - 1.0).abs() < 1e-15);
        assert!((circle.signed_distance(Complex64::new(1.5, 0.0)) - 0.5).abs() < 1e-15);
        let twice = CurvedOutline::new(&[Edge::circular(Complex64::ONE, 1.0, 0.5, 4.0 * PI)]).unwrap_err();
        assert_eq!(twice.code(), "invalid-outline");
        // Twice the same half circle, forth and back, is nothing but a cusp.
        let arc = Edge::circular(Complex64::ZERO, 1.0, 0.0, PI);
        assert_eq!(CurvedOutline::new(&[arc, arc.reversed()]).unwrap_err().code(), "cusp");
    }

    #[test]
    fn gaps_are_refused_and_horns_of_what_is_outside() {
        let [line, arc] = half_disk();
        let gap = [line, arc.moved(Complex64::new(0.0, 0.1))];
        assert!(CurvedOutline::new(&gap).is_err());
        let inner = Edge::circular(Complex64::new(0.5, 0.0), 0.5, PI, -PI);
        let small = Edge::circular(Complex64::new(-0.5, 0.0), 0.5, PI, -PI);
        // Three half circles: the horns of the arbelos are its own, those of what is below it are not.
        let arbelos = [small, inner, arc];
        let outline = CurvedOutline::new(&arbelos).unwrap();
        assert_eq!((0..3).map(|k| outline.alpha(k)).collect::<Vec<_>>(), [0.0; 3]);
        let at = Complex64::new;
        for tip in [at(-1.0, 0.0), at(0.0, 0.0), at(1.0, 0.0)] {
            assert!(
                outline.contains(tip)
                    && outline.on_edge(tip).is_some()
                    && (outline.nearest(tip).point - tip).norm() < 1e-15
            );
            assert!(outline.signed_distance(tip) == 0.0 && !outline.contains(tip - at(0.0, 1e-9)));
        }
        // In the tips, and beside them.
        for depth in [1e-7, 1e-6, 1e-4, 0.1] {
            assert!(outline.contains(at(0.0, depth)), "{depth}");
            assert!(!outline.contains(at(3.0 * depth * depth, depth)), "{depth}");
        }
        let below = [
            small,
            inner,
            Edge::line(at(1.0, 0.0), at(1.0, -1.0)),
            Edge::line(at(1.0, -1.0), at(-1.0, -1.0)),
            Edge::line(at(-1.0, -1.0), at(-1.0, 0.0)),
        ];
        let error = CurvedOutline::new(&below).unwrap_err();
        assert!(error.to_string().contains("cusp"), "{error}");
    }
}
