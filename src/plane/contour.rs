//! One simple closed curve: a polygon, a smooth curve through the same points, or a chain of curved edges.

use super::lie::Lie;
use super::polygon::ON_BOUNDARY;
use super::{BoundaryPoint, Complex64, CurvedOutline, Edge, Polygon, SmoothCurve};
use crate::{Error, Result};
use std::f64::consts::PI;
use std::sync::Arc;

/// How the boundary points are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curve {
    /// Straight edges join them.
    #[default]
    Polygon,
    /// The trigonometric interpolant joins them: a smooth curve through points that follow it evenly.
    Smooth,
    /// It consists of edges, lines and curves as they were drawn: [`Region::from_edges`](super::Region::from_edges).
    Edges,
}

/// A simple closed curve that knows its inside, and how near to it points count as on it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contour {
    polygon: Polygon,
    shape: Shape,
    /// Points as near to the curve as this are on it, as far as numbers can tell.
    thickness: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Straight,
    Smooth(Arc<SmoothCurve>),
    Curved(Arc<CurvedOutline>),
}

impl Contour {
    /// The curve through `points`, in either orientation.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooFewVertices`] and [`Error::SelfIntersecting`]; [`Error::WrongRegion`] for edges, which
    /// points do not make.
    pub fn new(points: &[Complex64], curve: Curve) -> Result<Self> {
        let (shape, polygon, rounding) = match curve {
            Curve::Polygon => (Shape::Straight, Polygon::new(points)?, 1.0),
            Curve::Smooth => {
                let curve = SmoothCurve::new(points)?;
                let (polygon, rounding) = (Polygon::new(curve.points())?, curve.rounding());
                (Shape::Smooth(Arc::new(curve)), polygon, rounding)
            }
            Curve::Edges => {
                let found = "points alone".to_string();
                return Err(Error::WrongRegion { what: "An outline of edges", needed: "the edges", found });
            }
        };
        let (low, high) = polygon.bounds();
        let reach = [low.re, low.im, high.re, high.im].into_iter().map(f64::abs).fold(polygon.size(), f64::max);
        Ok(Self { polygon, shape, thickness: ON_BOUNDARY * reach * rounding })
    }

    /// The closed chain of edges, in either orientation.
    ///
    /// # Errors
    /// Those of [`CurvedOutline::new`].
    pub fn from_edges(edges: &[Edge]) -> Result<Self> {
        let curved = CurvedOutline::new(edges)?;
        let (polygon, thickness) = (curved.polygon().clone(), curved.thickness());
        Ok(Self { polygon, shape: Shape::Curved(Arc::new(curved)), thickness })
    }

    /// As a polygon, if it is a chain of edges that are all straight.
    pub fn straightened(&self) -> Option<Self> {
        let edges = self.curved()?.edges();
        if !edges.iter().all(|edge| matches!(edge, Edge::Line { .. })) {
            return None;
        }
        let vertices: Vec<Complex64> = edges.iter().map(Edge::from).collect();
        Self::new(&vertices, Curve::Polygon).ok().filter(|contour| contour.polygon.vertices() == vertices)
    }

    /// The same curve, `by` plane units away; that should be no farther from 0 than this one.
    pub fn moved(&self, by: Complex64) -> Self {
        let shape = match &self.shape {
            Shape::Straight => Shape::Straight,
            Shape::Smooth(curve) => Shape::Smooth(Arc::new(curve.moved(by))),
            Shape::Curved(outline) => Shape::Curved(Arc::new(outline.moved(by))),
        };
        Self { polygon: self.polygon.moved(by), shape, thickness: self.thickness }
    }

    /// Points as near to the curve as this are on it, as far as numbers can tell.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// The polygon of its points: the curve itself, unless it is smooth; of edges, the polygon that they look like.
    pub fn polygon(&self) -> &Polygon {
        &self.polygon
    }

    /// The smooth curve, if it is one.
    pub fn smooth(&self) -> Option<&Arc<SmoothCurve>> {
        if let Shape::Smooth(curve) = &self.shape { Some(curve) } else { None }
    }

    /// The chain of edges, if it is one.
    pub fn curved(&self) -> Option<&Arc<CurvedOutline>> {
        if let Shape::Curved(outline) = &self.shape { Some(outline) } else { None }
    }

    /// The polygon that the curve looks like: itself, or fine samples of it.
    pub fn outline(&self) -> &Polygon {
        self.smooth().map_or(&self.polygon, |curve| curve.outline())
    }

    /// How its points are joined.
    pub fn curve(&self) -> Curve {
        match self.shape {
            Shape::Straight => Curve::Polygon,
            Shape::Smooth(_) => Curve::Smooth,
            Shape::Curved(_) => Curve::Edges,
        }
    }

    /// The point of the curve nearest to `z`.
    pub fn nearest(&self, z: Complex64) -> BoundaryPoint {
        match &self.shape {
            Shape::Straight => self.polygon.nearest(z),
            Shape::Smooth(curve) => curve.place(curve.nearest_parameter(z)),
            Shape::Curved(outline) => outline.nearest(z),
        }
    }

    /// The point of the curve nearest to `z`; the end of an edge, if it is that up to rounding.
    pub fn nearest_or_end(&self, z: Complex64) -> BoundaryPoint {
        let place = self.nearest(z);
        let ends = self.edge_count();
        let end = |edge: usize| BoundaryPoint { edge, t: 0.0, point: self.end(edge) };
        let mut near = [place.edge, (place.edge + 1) % ends].into_iter().map(end);
        near.find(|end| (end.point - place.point).norm() <= self.thickness).unwrap_or(place)
    }

    /// Number of its edges; of a smooth curve, of its points.
    pub fn edge_count(&self) -> usize {
        self.curved().map_or(self.polygon.len(), |outline| outline.edges().len())
    }

    /// About how many places on each edge see as much as one on an edge of a polygon.
    pub fn detail(&self) -> usize {
        const PLACES: usize = 8;
        if self.curved().is_some() { PLACES } else { 1 }
    }

    /// The point behind a share of an edge, or behind that of its parameter.
    #[inline(never)]
    pub fn point(&self, place: BoundaryPoint) -> Complex64 {
        match &self.shape {
            Shape::Smooth(curve) => curve.point(curve.parameter(place)),
            Shape::Curved(outline) => outline.edges()[place.edge].point(place.t),
            Shape::Straight => {
                let (a, b) = self.polygon.edge(place.edge);
                a + (b - a) * place.t
            }
        }
    }

    /// The angle by which the boundary turns to the left where an edge starts; `None` if it is a smooth curve.
    #[inline(never)]
    pub fn turn(&self, edge: usize) -> Option<f64> {
        if self.smooth().is_some() {
            return None;
        }
        if let Some(outline) = self.curved() {
            return Some((1.0 - outline.alpha(edge)) * PI);
        }
        let before = self.polygon.edge((edge + self.polygon.len() - 1) % self.polygon.len());
        let after = self.polygon.edge(edge);
        Some(((after.1 - after.0) * (before.1 - before.0).conj()).arg())
    }

    /// Where an edge starts.
    pub fn end(&self, edge: usize) -> Complex64 {
        self.curved().map_or_else(|| self.polygon.vertices()[edge], |outline| outline.edges()[edge].from())
    }

    /// The point of the curve that `z` is, up to rounding.
    pub fn on_curve(&self, z: Complex64) -> Option<BoundaryPoint> {
        match &self.shape {
            Shape::Straight => self.polygon.nearest_within(z, self.thickness),
            Shape::Smooth(_) => Some(self.nearest(z)).filter(|place| (place.point - z).norm() <= self.thickness),
            Shape::Curved(outline) => outline.on_edge(z),
        }
    }

    /// Where `z` lies: what [`Contour::on_curve`] and [`Contour::contains`] say, in one look.
    pub fn lie(&self, z: Complex64) -> Lie {
        match &self.shape {
            Shape::Smooth(curve) => curve.lie(z, self.thickness),
            _ => match self.on_curve(z) {
                Some(place) => Lie::On(place),
                None if self.contains(z) => Lie::Inside,
                None => Lie::Outside,
            },
        }
    }

    /// Whether `z` lies inside or on the curve, up to rounding.
    pub fn contains(&self, z: Complex64) -> bool {
        match &self.shape {
            Shape::Straight => self.polygon.contains(z) || self.polygon.nearest_within(z, self.thickness).is_some(),
            Shape::Smooth(curve) => curve.signed_distance(z) >= -self.thickness,
            Shape::Curved(outline) => outline.contains(z),
        }
    }

    /// Whether `z` lies inside and clearly not on the curve.
    pub fn contains_strictly(&self, z: Complex64) -> bool {
        match &self.shape {
            Shape::Straight => self.polygon.contains_strictly(z),
            Shape::Smooth(curve) => curve.signed_distance(z) > 1e-12 * self.polygon.size(),
            Shape::Curved(outline) => outline.is_deeper(z, self.thickness),
        }
    }

    /// Whether `z` lies inside, and not on the curve up to rounding.
    pub fn encloses(&self, z: Complex64) -> bool {
        match &self.shape {
            Shape::Straight => {
                self.polygon.contains_strictly(z) && self.polygon.nearest_within(z, self.thickness).is_none()
            }
            Shape::Smooth(curve) => curve.signed_distance(z) > self.thickness,
            Shape::Curved(outline) => outline.is_deeper(z, self.thickness),
        }
    }
}
