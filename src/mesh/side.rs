//! One copy of a joint triangulation: its outline, and where the points of that outline lie on the circle.

use crate::plane::{BoundaryPoint, Complex64, Polygon, SmoothCurve};
use crate::riemann::RiemannMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// No map is more accurate than this, some roundings of numbers near 1.
const ROUNDING: f64 = 1e-13;

/// A region that is one copy of a joint triangulation, or the disk itself.
///
/// The mesh needs no more than a homeomorphism: that the maps are conformal makes it good, not valid.
pub(crate) trait Side {
    /// The outline, or `None` for the unit circle.
    fn polygon(&self) -> Option<&Polygon>;
    /// The smooth curve that the boundary is instead of the outline's straight edges, if it is one.
    fn smooth(&self) -> Option<&SmoothCurve> {
        None
    }
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
    fn polygon(&self) -> Option<&Polygon> {
        Some(self.region().polygon())
    }

    fn smooth(&self) -> Option<&SmoothCurve> {
        self.region().smooth().map(Arc::as_ref)
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
    fn polygon(&self) -> Option<&Polygon> {
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

/// An outline measured by length (that of the chords, for a smooth curve), anticlockwise from its `toward` point.
pub(super) struct Outline<'a> {
    polygon: Option<&'a Polygon>,
    smooth: Option<&'a SmoothCurve>,
    /// Length along the polygon before each vertex, counted from vertex 0; the last entry is the whole length.
    starts: Vec<f64>,
    /// Length from vertex 0 to `toward`.
    offset: f64,
}

impl<'a> Outline<'a> {
    pub(super) fn new(side: &'a dyn Side) -> Self {
        let polygon = side.polygon();
        let mut starts = vec![0.0];
        if let Some(polygon) = polygon {
            let mut length = 0.0;
            for k in 0..polygon.len() {
                let (a, b) = polygon.edge(k);
                length += (b - a).norm();
                starts.push(length);
            }
        } else {
            starts.push(TAU);
        }
        let mut outline = Self { polygon, smooth: side.smooth(), starts, offset: 0.0 };
        outline.offset = outline.along(side.toward());
        outline
    }

    pub(super) fn length(&self) -> f64 {
        self.starts[self.starts.len() - 1]
    }

    pub(super) fn is_polygon(&self) -> bool {
        self.polygon.is_some()
    }

    /// The polygon, if the boundary consists of its straight edges.
    pub(super) fn straight(&self) -> Option<&'a Polygon> {
        self.polygon.filter(|_| self.smooth.is_none())
    }

    /// Corners of the outline as boundary points, in order from vertex 0; the circle has none.
    pub(super) fn corners(&self) -> Vec<BoundaryPoint> {
        let vertices = self.polygon.map_or(&[][..], Polygon::vertices);
        vertices.iter().enumerate().map(|(edge, &point)| BoundaryPoint { edge, t: 0.0, point }).collect()
    }

    /// Points that divide each edge evenly into pieces of at most `spacing`, the corners excluded.
    pub(super) fn divisions(&self, spacing: f64) -> Vec<BoundaryPoint> {
        let mut divisions = Vec::new();
        for edge in 0..self.starts.len() - 1 {
            let pieces = ((self.starts[edge + 1] - self.starts[edge]) / spacing).ceil().max(1.0) as usize;
            divisions.extend((1..pieces).map(|k| self.on_edge(edge, k as f64 / pieces as f64)));
        }
        divisions
    }

    /// The point of an edge, `t` in [0, 1).
    pub(super) fn on_edge(&self, edge: usize, t: f64) -> BoundaryPoint {
        let point = match (self.polygon, self.smooth) {
            (Some(polygon), Some(curve)) => curve.point((edge as f64 + t) / polygon.len() as f64 * TAU),
            (Some(polygon), None) => {
                let (a, b) = polygon.edge(edge);
                a + (b - a) * t
            }
            (None, _) => Complex64::cis(t * TAU),
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

    /// The outline's point nearest to one inside the straight edges between corners.
    pub(super) fn nearest(&self, z: Complex64) -> Option<BoundaryPoint> {
        match self.polygon {
            None if z.is_finite() => {
                Some(BoundaryPoint { edge: 0, t: z.arg().rem_euclid(TAU) / TAU, point: z / z.norm() })
            }
            Some(polygon) if polygon.contains(z) => Some(polygon.nearest(z)),
            _ => None,
        }
    }

    /// The outline's point nearest to one outside, or to one that rounding may put outside; for a smooth curve, to any, measured
    /// to its chords.
    pub(super) fn nearest_outside(&self, z: Complex64) -> Option<BoundaryPoint> {
        let polygon = self.polygon.filter(|_| z.is_finite())?;
        let nearest = polygon.nearest(z);
        match self.smooth {
            Some(_) => Some(self.on_edge(nearest.edge, nearest.t)),
            None => (self.depth(z) <= ROUNDING * self.length()).then_some(nearest),
        }
    }

    /// Distance from a point inside to the outline; negative outside, NaN for a point that is not finite.
    pub(super) fn depth(&self, z: Complex64) -> f64 {
        match self.polygon {
            None => 1.0 - z.norm(),
            Some(polygon) if polygon.contains(z) => (polygon.nearest(z).point - z).norm(),
            Some(_) => -1.0,
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
        assert_eq!(outline.divisions(0.5).len(), 3 + 1 + 3 + 1);
    }
}
