//! The paper's way back from the disk: find the triangle, apply its affine map.

use super::build::CLEARANCE;
use super::scan;
use super::side::{Outline, Side};
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Polygon, SmoothCurve};
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

/// A region whose inverse map is piecewise affine over a triangulation of its samples' images in the disk.
pub(super) struct Located<'a> {
    side: &'a dyn Side,
    samples: Samples,
}

impl<'a> Located<'a> {
    /// `points` are samples of the region, its boundary's included.
    fn new(side: &'a dyn Side, inner: &[Complex64], boundary: &[BoundaryPoint]) -> Result<Self> {
        let images = side.to_disk(inner).into_iter().zip(inner.iter().copied());
        let edge = boundary.iter().map(|&p| (Complex64::cis(side.angle(p)), p.point));
        let flush = |x: f64| if x.abs() < 1e-40 { 0.0 } else { x };
        let samples: Vec<_> = images
            .chain(edge)
            .filter(|(w, _)| w.is_finite())
            .map(|(w, region)| Sample { disk: Point2::new(flush(w.re), flush(w.im)), region })
            .collect();
        let samples = Samples::bulk_load(samples).unwrap_or_default();
        Ok(Self { side, samples })
    }

    /// The paper's samples of a region: a grid over its interior, and its boundary points, `spacing` apart.
    pub(super) fn sampled(side: &'a dyn Side, spacing: f64) -> Result<Self> {
        let Some(polygon) = side.polygon() else { return Self::new(side, &[], &[]) };
        let inner = scan::fill(polygon, side.center(), spacing, CLEARANCE * spacing)?;
        let outline = Outline::new(side);
        let boundary = [outline.corners(), outline.divisions(spacing)].concat();
        Self::new(side, &inner, &boundary)
    }

    /// The affine map of the triangle around w; NaN outside the triangulation, or where its triangle is flipped.
    fn at(&self, w: Complex64) -> Complex64 {
        let undefined = Complex64::new(f64::NAN, f64::NAN);
        if !w.is_finite() {
            return undefined;
        }
        let face = match self.samples.locate(Point2::new(w.re, w.im)) {
            PositionInTriangulation::OnVertex(vertex) => return self.samples.vertex(vertex).data().region,
            PositionInTriangulation::OnFace(face) => face,
            PositionInTriangulation::OnEdge(edge) => {
                let edge = self.samples.directed_edge(edge);
                match edge.face().as_inner().or(edge.rev().face().as_inner()) {
                    Some(face) => face.fix(),
                    None => return undefined,
                }
            }
            _ => return undefined,
        };
        let corners = self.samples.face(face).vertices().map(|v| *v.data());
        let [a, b, c] = corners.map(|s| Complex64::new(s.disk.x, s.disk.y));
        let cross = |u: Complex64, v: Complex64| (u.conj() * v).im;
        let area = cross(b - a, c - a);
        let (s, t) = (cross(w - a, c - a) / area, cross(b - a, w - a) / area);
        let [a, b, c] = corners.map(|s| s.region);
        if cross(b - a, c - a) > 0.0 { a + (b - a) * s + (c - a) * t } else { undefined }
    }
}

impl Side for Located<'_> {
    fn polygon(&self) -> Option<&Polygon> {
        self.side.polygon()
    }

    fn smooth(&self) -> Option<&SmoothCurve> {
        self.side.smooth()
    }

    fn center(&self) -> Complex64 {
        self.side.center()
    }

    fn toward(&self) -> BoundaryPoint {
        self.side.toward()
    }

    fn angle(&self, point: BoundaryPoint) -> f64 {
        self.side.angle(point)
    }

    fn at_angle(&self, angle: f64) -> BoundaryPoint {
        self.side.at_angle(angle)
    }

    fn error(&self) -> f64 {
        self.side.error()
    }

    fn to_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.side.to_disk(points)
    }

    fn to_region(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&w| self.at(w)).collect()
    }
}
