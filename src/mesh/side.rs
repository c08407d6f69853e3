//! One copy of a joint triangulation: its outline, and where the points of that outline lie on the circle.

use crate::plane::{BoundaryPoint, Complex64, Contour, CurvedOutline, Edge, Polygon, SmoothCurve};
use crate::riemann::RiemannMap;
use std::f64::consts::TAU;

/// Edges that turn by less where they meet, as a share of π, meet smoothly.
const SMOOTH: f64 = 1e-9;
/// Edges that turn by less along their way are as good as straight, in radians.
const STRAIGHT: f64 = 1e-6;
/// No map is more accurate than this, some roundings of numbers near 1.
const ROUNDING: f64 = 1e-13;

/// A region that is one copy of a joint triangulation, or the disk itself.
///
/// The mesh needs no more than a homeomorphism: that the maps are conformal makes it good, not valid.
pub(crate) trait Side {
    /// The outline, or `None` for the unit circle.
    fn contour(&self) -> Option<&Contour>;
    /// The point that goes to 0.
    fn center(&self) -> Complex64;
    /// The boundary point that goes to 1.
    fn toward(&self) -> BoundaryPoint;
    /// Boundary → angle on the circle, in [0, 2π], rising from `toward` on.
    fn angle(&self, point: BoundaryPoint) -> f64;
    /// Angle on the circle → boundary.
    fn at_angle(&self, angle: f64) -> BoundaryPoint;
    /// Largest error of the map, in units of the disk.
    fn error(&self) -> f64;
}

impl Side for RiemannMap {
    fn contour(&self) -> Option<&Contour> {
        Some(self.region().contour())
    }

    fn center(&self) -> Complex64 {
        self.region().center()
    }

    fn toward(&self) -> BoundaryPoint {
        self.region().toward()
    }

    fn angle(&self, point: BoundaryPoint) -> f64 {
        self.angle_from_toward(point)
    }

    fn at_angle(&self, angle: f64) -> BoundaryPoint {
        self.boundary_point(angle)
    }

    fn error(&self) -> f64 {
        self.error_estimate().max(ROUNDING)
    }
}

/// The unit disk as a copy: its own image.
pub(crate) struct UnitDisk;

impl Side for UnitDisk {
    fn contour(&self) -> Option<&Contour> {
        None
    }

    fn center(&self) -> Complex64 {
        Complex64::ZERO
    }

    fn toward(&self) -> BoundaryPoint {
        self.at_angle(0.0)
    }

    fn angle(&self, point: BoundaryPoint) -> f64 {
        point.t * TAU
    }

    /// The circle is one closed edge, `t` its share of the full angle.
    fn at_angle(&self, angle: f64) -> BoundaryPoint {
        BoundaryPoint { edge: 0, t: angle / TAU, point: Complex64::cis(angle) }
    }

    fn error(&self) -> f64 {
        ROUNDING
    }
}

/// What an outline consists of.
#[derive(Clone, Copy)]
enum Boundary<'a> {
    Circle,
    Straight(&'a Polygon),
    Smooth(&'a Polygon, &'a SmoothCurve),
    Edges(&'a CurvedOutline),
}

impl<'a> Boundary<'a> {
    fn of(contour: &'a Contour) -> Self {
        match (contour.smooth(), contour.curved()) {
            (Some(curve), _) => Self::Smooth(contour.polygon(), curve),
            (None, Some(outline)) => Self::Edges(outline),
            (None, None) => Self::Straight(contour.polygon()),
        }
    }

    /// Lengths of its edges, of the chords for a smooth curve, and by how much those that are curves turn, in radians; the circle has
    /// one edge.
    fn lengths_and_turns(self) -> Vec<(f64, f64)> {
        match self {
            Self::Circle => vec![(TAU, 0.0)],
            Self::Straight(polygon) | Self::Smooth(polygon, _) => {
                (0..polygon.len()).map(|k| polygon.edge(k)).map(|(a, b)| ((b - a).norm(), 0.0)).collect()
            }
            Self::Edges(outline) => outline.edges().iter().map(length_and_turn).collect(),
        }
    }
}

/// Chords that stand for an edge where its length and its turning are asked for.
const CHORDS: usize = 24;

/// About how long an edge is, and about by how much it turns, in radians.
fn length_and_turn(edge: &Edge) -> (f64, f64) {
    let ends = (0..=CHORDS).map(|k| edge.point(k as f64 / CHORDS as f64)).collect::<Vec<_>>();
    let chords: Vec<_> = ends.windows(2).map(|ends| ends[1] - ends[0]).collect();
    let turns = chords.windows(2).map(|pair| (pair[1] * pair[0].conj()).arg().abs());
    (chords.iter().map(|chord| chord.norm()).sum(), turns.sum())
}

/// An outline measured by length (that of the chords, for a smooth curve; by parameters within an edge that is one), anticlockwise
/// from its `toward` point.
pub(super) struct Outline<'a> {
    boundary: Boundary<'a>,
    /// Length along the outline before each edge, counted from vertex 0; the last entry is the whole length.
    starts: Vec<f64>,
    /// By how much each edge turns along its way, if it is a curve: about, in radians.
    turns: Vec<f64>,
    /// Length from vertex 0 to `toward`.
    offset: f64,
}

impl<'a> Outline<'a> {
    pub(super) fn new(side: &'a dyn Side) -> Self {
        let boundary = side.contour().map_or(Boundary::Circle, Boundary::of);
        let (mut starts, mut turns) = (vec![0.0], Vec::new());
        let mut length = 0.0;
        for (edge, turn) in boundary.lengths_and_turns() {
            length += edge;
            starts.push(length);
            turns.push(turn);
        }
        let mut outline = Self { boundary, starts, turns, offset: 0.0 };
        outline.offset = outline.along(side.toward());
        outline
    }

    pub(super) fn length(&self) -> f64 {
        self.starts[self.starts.len() - 1]
    }

    pub(super) fn is_circle(&self) -> bool {
        matches!(self.boundary, Boundary::Circle)
    }

    /// The polygon, if the boundary consists of its straight edges.
    pub(super) fn straight(&self) -> Option<&'a Polygon> {
        if let Boundary::Straight(polygon) = self.boundary { Some(polygon) } else { None }
    }

    /// Points where its edges meet as boundary points, in order from vertex 0; the circle has none.
    pub(super) fn corners(&self) -> Vec<BoundaryPoint> {
        let edges = if self.is_circle() { 0 } else { self.starts.len() - 1 };
        (0..edges).map(|edge| self.on_edge(edge, 0.0)).collect()
    }

    /// Whether the map may be singular there: at a point where edges meet, unless they do so smoothly.
    pub(super) fn is_corner(&self, place: BoundaryPoint) -> bool {
        let angled = match self.boundary {
            Boundary::Straight(_) => true,
            Boundary::Edges(outline) => (outline.alpha(place.edge) - 1.0).abs() > SMOOTH,
            Boundary::Circle | Boundary::Smooth(..) => false,
        };
        angled && place.t == 0.0
    }

    /// The straight edges that a point lies on: two at most.
    pub(super) fn straight_edges(&self, place: BoundaryPoint) -> [Option<usize>; 2] {
        let before = (place.edge + self.starts.len() - 2) % (self.starts.len() - 1);
        let is_straight = |edge: usize| match self.boundary {
            Boundary::Straight(_) => true,
            Boundary::Edges(outline) => matches!(outline.edges()[edge], Edge::Line { .. }),
            Boundary::Circle | Boundary::Smooth(..) => false,
        };
        [place.edge, if place.t == 0.0 { before } else { place.edge }].map(|edge| is_straight(edge).then_some(edge))
    }

    /// Points that divide each edge evenly into pieces of at most `spacing` that turn by `turn` at most, in radians; the corners
    /// excluded. With the length of such a piece of an edge that turns, and infinity otherwise: without them, it is no curve.
    pub(super) fn divisions(&self, spacing: f64, turn: f64) -> Vec<(BoundaryPoint, f64)> {
        let mut divisions = Vec::new();
        for (edge, &turns) in self.turns.iter().enumerate() {
            let length = self.starts[edge + 1] - self.starts[edge];
            let pieces = (length / spacing).max(turns / turn).ceil().max(1.0) as usize;
            let step = if turns > STRAIGHT { length / pieces as f64 } else { f64::INFINITY };
            divisions.extend((1..pieces).map(|k| (self.on_edge(edge, k as f64 / pieces as f64), step)));
        }
        divisions
    }

    /// The point of an edge, `t` in [0, 1).
    pub(super) fn on_edge(&self, edge: usize, t: f64) -> BoundaryPoint {
        let point = match self.boundary {
            Boundary::Circle => Complex64::cis(t * TAU),
            Boundary::Straight(polygon) => {
                let (a, b) = polygon.edge(edge);
                a + (b - a) * t
            }
            Boundary::Smooth(polygon, curve) => curve.point((edge as f64 + t) / polygon.len() as f64 * TAU),
            Boundary::Edges(outline) => return outline.place(edge, t),
        };
        BoundaryPoint { edge, t, point }
    }

    /// Length from `toward` to the point, in [0, length).
    pub(super) fn distance(&self, point: BoundaryPoint) -> f64 {
        let s = self.along(point) - self.offset;
        if s < 0.0 { s + self.length() } else { s }
    }

    /// The point that lies `s` past `toward`.
    pub(super) fn at_distance(&self, s: f64) -> BoundaryPoint {
        let s = (s + self.offset) % self.length();
        let edge = self.starts.partition_point(|&start| start <= s).clamp(1, self.starts.len() - 1) - 1;
        let length = self.starts[edge + 1] - self.starts[edge];
        self.on_edge(edge, ((s - self.starts[edge]) / length).clamp(0.0, 1.0 - f64::EPSILON))
    }

    /// The outline's point nearest to one inside; for a smooth curve, inside its chords and nearest on them.
    pub(super) fn nearest(&self, z: Complex64) -> Option<BoundaryPoint> {
        match self.boundary {
            Boundary::Circle if z.is_finite() => {
                Some(BoundaryPoint { edge: 0, t: z.arg().rem_euclid(TAU) / TAU, point: z / z.norm() })
            }
            Boundary::Straight(polygon) | Boundary::Smooth(polygon, _) if polygon.contains(z) => {
                Some(polygon.nearest(z))
            }
            Boundary::Edges(outline) if outline.contains(z) => Some(outline.nearest(z)),
            _ => None,
        }
    }

    /// The outline's point nearest to one outside, or to one that rounding may put outside; for a curve, to any, measured
    /// to the chords of a smooth one.
    pub(super) fn nearest_outside(&self, z: Complex64) -> Option<BoundaryPoint> {
        match self.boundary {
            Boundary::Straight(polygon) if z.is_finite() => {
                (self.depth(z) <= ROUNDING * self.length()).then(|| polygon.nearest(z))
            }
            Boundary::Smooth(polygon, _) if z.is_finite() => {
                let nearest = polygon.nearest(z);
                Some(self.on_edge(nearest.edge, nearest.t))
            }
            Boundary::Edges(outline) if z.is_finite() => Some(outline.nearest(z)),
            _ => None,
        }
    }

    /// Distance from a point inside to the outline; negative outside, NaN for a point that is not finite.
    pub(super) fn depth(&self, z: Complex64) -> f64 {
        match self.boundary {
            Boundary::Circle => 1.0 - z.norm(),
            Boundary::Straight(polygon) | Boundary::Smooth(polygon, _) if polygon.contains(z) => {
                (polygon.nearest(z).point - z).norm()
            }
            Boundary::Edges(outline) => outline.signed_distance(z),
            Boundary::Straight(_) | Boundary::Smooth(..) => -1.0,
        }
    }

    fn along(&self, point: BoundaryPoint) -> f64 {
        let start = self.starts[point.edge];
        start + point.t * (self.starts[point.edge + 1] - start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_points_are_inverse() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
        let side = super::super::star::Star::new(&corners, Complex64::new(1.0, 0.5), Complex64::new(2.0, 0.25));
        let outline = Outline::new(&side);
        assert_eq!(outline.length(), 6.0);
        assert_eq!(outline.distance(outline.corners()[2]), 0.75);
        for s in [0.0, 0.1, 0.75, 3.0, 5.9] {
            assert!((outline.distance(outline.at_distance(s)) - s).abs() < 1e-12);
        }
        assert_eq!(outline.divisions(0.5, 1.0).len(), 3 + 1 + 3 + 1);
    }
}
