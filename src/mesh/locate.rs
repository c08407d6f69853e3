//! The paper's way back from the disk: find the triangle, apply its affine map.

use super::correspondence::Correspondence;
use super::ring::Room;
use super::scan::{self, CLEARANCE};
use super::side::{Outline, Side};
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, NOWHERE};
use crate::riemann::RegionMap;
use spade::{DelaunayTriangulation, HasPosition, Point2, PositionInTriangulation, Triangulation};

/// A sample of the region: its image in the disk, where it is looked for, and where it came from.
#[derive(Clone, Copy, Debug)]
struct Sample {
    disk: Point2<f64>,
    region: Complex64,
}

impl HasPosition for Sample {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.disk
    }
}

type Samples = DelaunayTriangulation<Sample>;

/// A map between regions whose second half, disk → target, is piecewise affine over a triangulation of the images of the
/// target's samples. Boundaries correspond exactly.
pub(super) struct Located<'a> {
    exact: &'a RegionMap,
    samples: Samples,
}

impl<'a> Located<'a> {
    /// The paper's samples of the target: a grid over its interior, and its boundary points, `spacing` apart.
    pub(super) fn sampled(exact: &'a RegionMap, spacing: f64) -> Result<Self> {
        let map = exact.target();
        let inner = scan::fill(map.region().polygon(), map.region().center(), spacing, CLEARANCE * spacing)?;
        let outline = Outline::new(map);
        let divisions = outline.divisions(spacing, Room::LEAST.turn).into_iter().map(|(point, _)| point);
        let boundary: Vec<_> = outline.corners().into_iter().chain(divisions).collect();
        let images = map.to_disk(&inner).into_iter().zip(inner);
        let edge = boundary.iter().map(|&p| (Complex64::cis(map.boundary_angle(p)), p.point));
        let flush = |x: f64| if x.abs() < 1e-40 { 0.0 } else { x };
        let samples: Vec<_> = images
            .chain(edge)
            .filter(|(w, _)| w.is_finite())
            .map(|(w, region)| Sample { disk: Point2::new(flush(w.re), flush(w.im)), region })
            .collect();
        Ok(Self { exact, samples: Samples::bulk_load(samples).unwrap_or_default() })
    }

    /// The affine map of the triangle around w; NaN outside the triangulation, or where its triangle is flipped.
    fn at(&self, w: Complex64) -> Complex64 {
        if !w.is_finite() {
            return NOWHERE;
        }
        let face = match self.samples.locate(Point2::new(w.re, w.im)) {
            PositionInTriangulation::OnVertex(vertex) => return self.samples.vertex(vertex).data().region,
            PositionInTriangulation::OnFace(face) => face,
            PositionInTriangulation::OnEdge(edge) => {
                let edge = self.samples.directed_edge(edge);
                match edge.face().as_inner().or(edge.rev().face().as_inner()) {
                    Some(face) => face.fix(),
                    None => return NOWHERE,
                }
            }
            _ => return NOWHERE,
        };
        let corners = self.samples.face(face).vertices().map(|v| *v.data());
        let [a, b, c] = corners.map(|s| Complex64::new(s.disk.x, s.disk.y));
        let cross = |u: Complex64, v: Complex64| (u.conj() * v).im;
        let area = cross(b - a, c - a);
        let (s, t) = (cross(w - a, c - a) / area, cross(b - a, w - a) / area);
        let [a, b, c] = corners.map(|s| s.region);
        if cross(b - a, c - a) > 0.0 { a + (b - a) * s + (c - a) * t } else { NOWHERE }
    }
}

impl Correspondence for Located<'_> {
    fn copies(&self) -> [&dyn Side; 2] {
        self.exact.copies()
    }

    fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.exact.source().to_disk(points).into_iter().map(|w| self.at(w)).collect()
    }

    fn backward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.exact.inverse(points)
    }

    fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.exact.boundary_forward(point)
    }

    fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.exact.boundary_inverse(point)
    }

    fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.exact.source().from_disk(points)
    }

    fn magnification(&self, source: &[Complex64], target: &[Complex64]) -> Vec<f64> {
        self.exact.magnification(source, target)
    }
}
