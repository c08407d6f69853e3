//! One simple closed curve: a polygon, or a smooth curve through the same points.

use super::polygon::ON_BOUNDARY;
use super::{BoundaryPoint, Complex64, Polygon, SmoothCurve};
use crate::Result;
use std::sync::Arc;

/// How the boundary points are joined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(serde::Deserialize, tsify::Tsify), serde(rename_all = "lowercase"))]
pub enum Curve {
    /// Straight edges join them.
    #[default]
    Polygon,
    /// The trigonometric interpolant joins them: a smooth curve through points that follow it evenly.
    Smooth,
}

/// A simple closed curve that knows its inside, and how near to it points count as on it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contour {
    polygon: Polygon,
    smooth: Option<Arc<SmoothCurve>>,
    /// Points as near to the curve as this are on it, as far as numbers can tell.
    thickness: f64,
}

impl Contour {
    /// The curve through `points`, in either orientation.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::TooFewVertices`](crate::Error::TooFewVertices) and
    /// [`Error::SelfIntersecting`](crate::Error::SelfIntersecting).
    pub fn new(points: &[Complex64], curve: Curve) -> Result<Self> {
        let smooth = match curve {
            Curve::Polygon => None,
            Curve::Smooth => Some(Arc::new(SmoothCurve::new(points)?)),
        };
        let polygon = Polygon::new(smooth.as_ref().map_or(points, |curve| curve.points()))?;
        let (low, high) = polygon.bounds();
        let reach = [low.re, low.im, high.re, high.im].into_iter().map(f64::abs).fold(polygon.size(), f64::max);
        let thickness = ON_BOUNDARY * reach * smooth.as_ref().map_or(1.0, |curve| curve.rounding());
        Ok(Self { polygon, smooth, thickness })
    }

    /// The same curve, `by` plane units away; that should be no farther from 0 than this one.
    pub fn moved(&self, by: Complex64) -> Self {
        Self {
            polygon: self.polygon.moved(by),
            smooth: self.smooth.as_ref().map(|curve| Arc::new(curve.moved(by))),
            thickness: self.thickness,
        }
    }

    /// Points as near to the curve as this are on it, as far as numbers can tell.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// The polygon of its points: the curve itself, unless it is smooth.
    pub fn polygon(&self) -> &Polygon {
        &self.polygon
    }

    /// The smooth curve, if it is one.
    pub fn smooth(&self) -> Option<&Arc<SmoothCurve>> {
        self.smooth.as_ref()
    }

    /// The polygon that the curve looks like: itself, or fine samples of it.
    pub fn outline(&self) -> &Polygon {
        self.smooth.as_ref().map_or(&self.polygon, |curve| curve.outline())
    }

    /// How its points are joined.
    pub fn curve(&self) -> Curve {
        if self.smooth.is_some() { Curve::Smooth } else { Curve::Polygon }
    }

    /// The point of the curve nearest to `z`.
    pub fn nearest(&self, z: Complex64) -> BoundaryPoint {
        match &self.smooth {
            None => self.polygon.nearest(z),
            Some(curve) => curve.place(curve.nearest_parameter(z)),
        }
    }

    /// The point of the curve that `z` is, up to rounding.
    pub fn on_curve(&self, z: Complex64) -> Option<BoundaryPoint> {
        match &self.smooth {
            None => self.polygon.nearest_within(z, self.thickness),
            Some(_) => Some(self.nearest(z)).filter(|place| (place.point - z).norm() <= self.thickness),
        }
    }

    /// Whether `z` lies inside or on the curve, up to rounding.
    pub fn contains(&self, z: Complex64) -> bool {
        match &self.smooth {
            None => self.polygon.contains(z) || self.polygon.nearest_within(z, self.thickness).is_some(),
            Some(curve) => curve.signed_distance(z) >= -self.thickness,
        }
    }

    /// Whether `z` lies inside and clearly not on the curve.
    pub fn contains_strictly(&self, z: Complex64) -> bool {
        match &self.smooth {
            None => self.polygon.contains_strictly(z),
            Some(curve) => curve.signed_distance(z) > 1e-12 * self.polygon.size(),
        }
    }

    /// Whether `z` lies inside, and not on the curve up to rounding.
    pub fn encloses(&self, z: Complex64) -> bool {
        match &self.smooth {
            None => self.polygon.contains_strictly(z) && self.polygon.nearest_within(z, self.thickness).is_none(),
            Some(curve) => curve.signed_distance(z) > self.thickness,
        }
    }
}
