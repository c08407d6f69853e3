//! A simply connected region with the point and direction that make its Riemann map unique.

use super::contour::{Contour, Curve};
use super::{BoundaryPoint, Complex64, Polygon, SmoothCurve};
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
        let contour = Contour::new(boundary, curve)?;
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
        Ok(Self { center, toward: self.nearest(toward), ..self.clone() })
    }

    /// What coordinates should be given relative to, so that a region far from 0 keeps its digits; and the region there.
    pub(crate) fn local(&self) -> (Complex64, Self) {
        let origin = self.polygon().origin();
        let toward = BoundaryPoint { point: self.toward.point - origin, ..self.toward };
        (origin, Self { contour: self.contour.moved(-origin), center: self.center - origin, toward })
    }

    /// Writes what [`Region::restore`] reads.
    pub(crate) fn store(&self, to: &mut Writer) {
        to.case(u8::from(self.curve() == Curve::Smooth));
        to.points(self.smooth().map_or(self.boundary(), |curve| curve.points()));
        to.point(self.center);
        to.count(self.toward.edge);
        to.number(self.toward.t);
        to.point(self.toward.point);
    }

    /// The same region to the bit, as [`Region::store`] wrote it, checked as a new one is.
    ///
    /// # Errors
    /// [`Error::Damaged`], and those of [`Region::new`].
    pub(crate) fn restore(from: &mut Reader) -> Result<Self> {
        let curve = if from.case()? == 0 { Curve::Polygon } else { Curve::Smooth };
        let boundary = from.points()?;
        let center = from.point()?;
        let toward = BoundaryPoint { edge: from.index(boundary.len())?, t: from.number()?, point: from.point()? };
        let region = Self::new(&boundary, curve, center, toward.point)?;
        let is_whole = region.polygon().len() == boundary.len() && region.boundary() == boundary;
        let is_there = (0.0..=1.0).contains(&toward.t) && region.on_boundary(toward.point).is_some();
        if is_whole && is_there {
            Ok(Self { toward, ..region })
        } else {
            Err(Error::Damaged { reason: "its boundary is not as a region has it" })
        }
    }

    /// The boundary points in plane units, counter-clockwise.
    #[must_use]
    pub fn boundary(&self) -> &[Complex64] {
        self.polygon().vertices()
    }

    /// The polygon of the boundary points: the boundary itself, unless the curve is smooth.
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

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Complex64; 3] = [Complex64::new(0.0, 0.0), Complex64::new(4.0, 0.0), Complex64::new(0.0, 4.0)];

    #[test]
    fn toward_is_snapped_to_the_boundary() {
        let region =
            Region::new(&TRIANGLE, Curve::Polygon, Complex64::new(1.0, 1.0), Complex64::new(1.0, -2.0)).unwrap();
        assert_eq!(region.toward().point, Complex64::new(1.0, 0.0));
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
}
