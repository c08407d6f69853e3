//! A simply connected region with the point and direction that make its Riemann map unique.

use super::contour::{Contour, Curve};
use super::stored_edges;
use super::{BoundaryPoint, Complex64, CurvedOutline, Edge, Polygon, SmoothCurve};
use crate::stored::{Reader, Writer};
use crate::{Error, Result};
use std::sync::Arc;

/// A region bounded by a simple closed curve, a `center` inside it and a `toward` point on its boundary.
///
/// Its Riemann map takes `center` to 0 and `toward` to 1. Validated once here, trusted afterwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    contour: Contour,
    center: Complex64,
    toward: BoundaryPoint,
}

/// What boundaries are stored as; what is neither straight nor made of edges was always read as smooth.
const STRAIGHT: u8 = 0;
const SMOOTH: u8 = 1;
const EDGES: u8 = 2;

impl Region {
    /// A region from its boundary points, in either orientation. `toward` is snapped to the nearest boundary point.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Curve, Region};
    /// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
    /// let region = Region::new(&square, Curve::Polygon, Complex64::new(0.0, 0.0), Complex64::new(1.0, 0.0))?;
    /// assert_eq!(region.toward().edge, 1);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooFewVertices`] and [`Error::SelfIntersecting`] for the boundary;
    /// [`Error::CenterOutside`] unless `center` is strictly inside.
    pub fn new(boundary: &[Complex64], curve: Curve, center: Complex64, toward: Complex64) -> Result<Self> {
        Self::within(Contour::new(boundary, curve)?, center, toward)
    }

    /// A region from the edges of its boundary, lines and curves: a closed chain in either orientation. Edges meet in corners
    /// where their directions differ, smoothly where they do not. `toward` is snapped to the nearest boundary point.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Edge, Region};
    /// use std::f64::consts::PI;
    /// // The upper half of the unit disk.
    /// let edges = [Edge::line(-Complex64::ONE, Complex64::ONE), Edge::circular(Complex64::ZERO, 1.0, 0.0, PI)];
    /// let region = Region::from_edges(&edges, Complex64::new(0.0, 0.5), Complex64::ONE)?;
    /// assert!(region.contains(Complex64::from_polar(1.0 - 1e-14, 1.0)));
    /// assert!(!region.contains(Complex64::from_polar(1.0 + 1e-14, 1.0)));
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::InvalidOutline`] for gaps and edges without length, [`Error::Cusp`] and
    /// [`Error::SelfIntersecting`] for the boundary; [`Error::CenterOutside`] unless `center` is strictly inside.
    pub fn from_edges(edges: &[Edge], center: Complex64, toward: Complex64) -> Result<Self> {
        Self::within(Contour::from_edges(edges)?, center, toward)
    }

    fn within(contour: Contour, center: Complex64, toward: Complex64) -> Result<Self> {
        let toward_0 = BoundaryPoint { edge: 0, t: 0.0, point: contour.polygon().vertices()[0] };
        Self { contour, center, toward: toward_0 }.with_center(center, toward)
    }

    /// The same boundary with another center and direction.
    ///
    /// # Errors
    /// As [`Region::new`].
    pub fn with_center(&self, center: Complex64, toward: Complex64) -> Result<Self> {
        for (what, point) in [("The center", center), ("The point toward", toward)] {
            if !point.is_finite() {
                return Err(Error::NotFinite { what: what.to_string() });
            }
        }
        if !self.contour.contains_strictly(center) {
            return Err(Error::CenterOutside { center });
        }
        Ok(Self { center, toward: self.contour.nearest_or_end(toward), ..self.clone() })
    }

    /// The same region as a polygon, if it is bounded by edges that are all straight: a polygon's map is faster, and has charts.
    pub(crate) fn straightened(&self) -> Option<Self> {
        Some(Self { contour: self.contour.straightened()?, ..self.clone() })
    }

    /// What coordinates should be given relative to, so that a region far from 0 keeps its digits; and the region there.
    pub(crate) fn local(&self) -> (Complex64, Self) {
        let origin = self.polygon().origin();
        let toward = BoundaryPoint { point: self.toward.point - origin, ..self.toward };
        (origin, Self { contour: self.contour.moved(-origin), center: self.center - origin, toward })
    }

    /// Writes what [`Region::restore`] reads.
    pub(crate) fn store(&self, to: &mut Writer) {
        match (self.curved(), self.smooth()) {
            (Some(outline), _) => {
                to.case(EDGES);
                stored_edges::store(outline.edges(), to);
            }
            (None, Some(curve)) => {
                to.case(SMOOTH);
                to.points(curve.points());
            }
            (None, None) => {
                to.case(STRAIGHT);
                to.points(self.boundary());
            }
        }
        self.store_points(to);
    }

    /// Writes center and `toward` alone.
    pub(crate) fn store_points(&self, to: &mut Writer) {
        to.point(self.center);
        to.count(self.toward.edge);
        to.number(self.toward.t);
        to.point(self.toward.point);
    }

    /// This with the center and `toward` that [`Region::store_points`] wrote.
    ///
    /// # Errors
    /// As [`Region::restore`].
    pub(crate) fn restore_points(&self, from: &mut Reader) -> Result<Self> {
        let edges = self.curved().map_or(self.boundary().len(), |outline| outline.edges().len());
        let (center, toward) = restore_points(from, edges)?;
        self.with_center(center, toward.point)?.restored(toward, true)
    }

    /// The same region to the bit, as [`Region::store`] wrote it, checked as a new one is.
    ///
    /// # Errors
    /// [`Error::Damaged`], and those of [`Region::new`].
    pub(crate) fn restore(from: &mut Reader) -> Result<Self> {
        let case = from.case()?;
        if case == EDGES {
            let edges = stored_edges::restore(from)?;
            let (center, toward) = restore_points(from, edges.len())?;
            let region = Self::from_edges(&edges, center, toward.point)?;
            let is_whole = region.curved().is_some_and(|outline| outline.edges() == edges);
            return region.restored(toward, is_whole);
        }
        let curve = if case == STRAIGHT { Curve::Polygon } else { Curve::Smooth };
        let boundary = from.points()?;
        let (center, toward) = restore_points(from, boundary.len())?;
        let region = Self::new(&boundary, curve, center, toward.point)?;
        let is_whole = region.polygon().len() == boundary.len() && region.boundary() == boundary;
        region.restored(toward, is_whole)
    }

    fn restored(self, toward: BoundaryPoint, is_whole: bool) -> Result<Self> {
        if is_whole && (0.0..=1.0).contains(&toward.t) && self.on_boundary(toward.point).is_some() {
            Ok(Self { toward, ..self })
        } else {
            Err(Error::Damaged { reason: "its boundary is not as a region has it" })
        }
    }

    /// The boundary points in plane units, counter-clockwise; of edges, those of the polygon that they look like.
    #[must_use]
    pub fn boundary(&self) -> &[Complex64] {
        self.polygon().vertices()
    }

    /// The polygon of the boundary points: the boundary itself, unless the curve is smooth. Of edges, a polygon that leaves them
    /// by two millionths of their size at most.
    #[must_use]
    pub fn polygon(&self) -> &Polygon {
        self.contour.polygon()
    }

    /// How the boundary points are joined.
    #[must_use]
    pub fn curve(&self) -> Curve {
        self.contour.curve()
    }

    /// The smooth curve through the boundary points, if that is the boundary.
    #[must_use]
    pub fn smooth(&self) -> Option<&Arc<SmoothCurve>> {
        self.contour.smooth()
    }

    /// The chain of edges, if that is the boundary: boundary points count its edges, and its edges' parameters.
    #[must_use]
    pub fn curved(&self) -> Option<&Arc<CurvedOutline>> {
        self.contour.curved()
    }

    /// The boundary itself.
    pub(crate) fn contour(&self) -> &Contour {
        &self.contour
    }

    /// The boundary point nearest to `z`.
    #[must_use]
    pub fn nearest(&self, z: Complex64) -> BoundaryPoint {
        self.contour.nearest(z)
    }

    /// The boundary point that `z` is, up to rounding.
    #[must_use]
    pub fn on_boundary(&self, z: Complex64) -> Option<BoundaryPoint> {
        self.contour.on_curve(z)
    }

    /// The point that goes to 0.
    #[must_use]
    pub fn center(&self) -> Complex64 {
        self.center
    }

    /// The boundary point that goes to 1.
    #[must_use]
    pub fn toward(&self) -> BoundaryPoint {
        self.toward
    }

    /// Whether `z` lies in the closed region, to which belongs what is on the boundary up to rounding.
    #[must_use]
    pub fn contains(&self, z: Complex64) -> bool {
        self.contour.contains(z)
    }
}

/// The center and the point toward, on a boundary of so many edges.
fn restore_points(from: &mut Reader, edges: usize) -> Result<(Complex64, BoundaryPoint)> {
    let center = from.point()?;
    let toward = BoundaryPoint { edge: from.index(edges)?, t: from.number()?, point: from.point()? };
    Ok((center, toward))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stored::{Kind, read, written};

    const TRIANGLE: [Complex64; 3] = [Complex64::new(0.0, 0.0), Complex64::new(4.0, 0.0), Complex64::new(0.0, 4.0)];

    #[test]
    fn toward_is_snapped_to_the_boundary() {
        let region =
            Region::new(&TRIANGLE, Curve::Polygon, Complex64::new(1.0, 1.0), Complex64::new(1.0, -2.0)).unwrap();
        assert_eq!(region.toward().point, Complex64::new(1.0, 0.0));
    }

    #[test]
    fn toward_is_a_corner_if_it_is_one_up_to_rounding() {
        let lens = crate::plane::parse_path("M 1 0 A 2 2 0 0 1 -1 0 A 2 2 0 0 1 1 0 Z").unwrap();
        for end in [Complex64::new(1.0, -1e-17), Complex64::new(1.0, 1e-17), Complex64::new(1.0 - 1e-16, 0.0)] {
            let region = Region::from_edges(&lens, Complex64::ZERO, end).unwrap();
            assert_eq!(region.toward(), BoundaryPoint { edge: 0, t: 0.0, point: Complex64::ONE });
            let corner = Complex64::new(4.0, 0.0);
            let region = Region::new(&TRIANGLE, Curve::Polygon, Complex64::ONE + Complex64::i(), 4.0 * end).unwrap();
            assert_eq!(region.toward(), BoundaryPoint { edge: 1, t: 0.0, point: corner });
        }
    }

    #[test]
    fn center_must_be_strictly_inside() {
        for center in [Complex64::new(-1.0, 1.0), Complex64::new(2.0, 2.0), Complex64::new(0.0, 0.0)] {
            let error = Region::new(&TRIANGLE, Curve::Polygon, center, Complex64::new(0.0, 0.0)).unwrap_err();
            assert_eq!(error, Error::CenterOutside { center });
        }
        let nan = Complex64::new(f64::NAN, 0.0);
        assert_eq!(Region::new(&TRIANGLE, Curve::Polygon, nan, TRIANGLE[0]).unwrap_err().code(), "not-finite");
    }

    #[test]
    fn regions_of_edges_are_stored_to_the_bit() {
        let at = Complex64::new;
        let arc = crate::plane::ArcTo { radii: (2.0, 1.0), rotation: 0.3, large: false, counterclockwise: true };
        let edges = [
            Edge::Cubic([at(0.0, 0.0), at(1.0, -2.0), at(2.0, 1.5), at(3.0, 0.0)]),
            Edge::arc_to(at(3.0, 0.0), at(2.0, 2.0), arc),
            Edge::Quadratic([at(2.0, 2.0), at(1.0, 1.0), at(0.0, 2.0)]),
            Edge::line(at(0.0, 2.0), at(0.0, 0.0)),
        ];
        let backwards: Vec<Edge> = edges.iter().rev().map(Edge::reversed).collect();
        for edges in [&edges[..], &backwards] {
            let region = Region::from_edges(edges, at(1.0, 0.5), at(3.3, 1.0)).unwrap();
            assert_eq!((region.curve(), region.curved().unwrap().edges().len()), (Curve::Edges, 4));
            assert!(region.contains(region.toward().point));
            let bytes = written(Kind::Riemann, |to| region.store(to));
            assert!(read(Kind::Riemann, &bytes, Region::restore).unwrap() == region);
        }
        let outside = Region::from_edges(&edges, at(1.0, 1.9), at(0.0, 0.0)).unwrap_err();
        assert_eq!(outside, Error::CenterOutside { center: at(1.0, 1.9) });
        assert_eq!(Region::new(&TRIANGLE, Curve::Edges, TRIANGLE[0], TRIANGLE[0]).unwrap_err().code(), "wrong-region");
    }
}
