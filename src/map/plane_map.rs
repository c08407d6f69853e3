//! Maps of the plane.

use super::jet::Jet;
use crate::plane::Complex64;

/// A map plane → plane, evaluated over blocks of points.
///
/// This is all that a warp knows of a map.
pub trait PlaneMap {
    /// Writes the jet of the map at `points[k]` to `jets[k]`; [`Jet::UNDEFINED`] outside the domain.
    /// The two slices have the same length.
    /// The jet of a point depends on nothing but that point.
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]);

    /// The inverse map, if the map has one that can be evaluated: a push-forward is its pull-back.
    ///
    /// Every [`InvertibleMap`](super::InvertibleMap) says so here, and so do maps that are made of such.
    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        None
    }

    /// The jet at one point.
    fn jet(&self, point: Complex64) -> Jet {
        let mut jet = [Jet::UNDEFINED];
        self.jets(&[point], &mut jet);
        jet[0]
    }
}

/// Writes `f(point)` for every point, and [`Jet::UNDEFINED`] where it is none: the loop of maps that go point by point.
pub(crate) fn pointwise(points: &[Complex64], jets: &mut [Jet], f: impl Fn(Complex64) -> Option<Jet>) {
    for (&point, jet) in points.iter().zip(jets) {
        *jet = f(point).unwrap_or(Jet::UNDEFINED);
    }
}

impl<M: PlaneMap + ?Sized> PlaneMap for &M {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        (**self).jets(points, jets);
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        (**self).inverse_map()
    }
}

impl<M: PlaneMap + ?Sized> PlaneMap for Box<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        (**self).jets(points, jets);
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        (**self).inverse_map()
    }
}
