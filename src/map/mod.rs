//! The algebra of maps of the plane, each with its derivative: what a warp pulls a picture back through.
//!
//! Which maps there are, this module does not know: they stand above it, side by side.

pub(crate) mod compose;
mod inverse;
mod moebius;

pub use compose::Compose;
pub use inverse::{Inverse, InvertibleMap};
pub use moebius::Moebius;

use crate::plane::Complex64;

/// A map's value at a point and its first derivatives there.
///
/// `f(z + h) ≈ value + dz·h + dzbar·h̄` (the Wirtinger derivatives): a conformal map has `dzbar` = 0, and `dz` = f'.
/// Where the map is not defined, everything is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// f(z).
    pub value: Complex64,
    /// ∂f/∂z; f'(z) where the map is analytic.
    pub dz: Complex64,
    /// ∂f/∂z̄; 0 where the map is analytic.
    pub dzbar: Complex64,
}

impl Jet {
    /// The jet of a point where the map has no value.
    pub const UNDEFINED: Self = {
        let nan = Complex64::new(f64::NAN, f64::NAN);
        Self { value: nan, dz: nan, dzbar: nan }
    };

    /// The jet of an analytic map.
    #[must_use]
    pub fn analytic(value: Complex64, derivative: Complex64) -> Self {
        Self { value, dz: derivative, dzbar: Complex64::ZERO }
    }

    /// The jet of a composition: `self` is the jet of the outer map, at the value of the `inner` one. Undefined where
    /// the inner map is.
    #[must_use]
    pub fn after(&self, inner: &Self) -> Self {
        if inner.value.is_nan() {
            return Self::UNDEFINED;
        }
        Self {
            value: self.value,
            dz: self.dz * inner.dz + self.dzbar * inner.dzbar.conj(),
            dzbar: self.dz * inner.dzbar + self.dzbar * inner.dz.conj(),
        }
    }

    /// The larger singular value of the Jacobian: how much the map stretches at most. |f'| for a conformal map.
    #[must_use]
    pub fn stretch(&self) -> f64 {
        self.dz.norm() + self.dzbar.norm()
    }
}

/// A map plane → plane, evaluated over blocks of points.
///
/// This is all that a warp knows of a map.
pub trait PlaneMap {
    /// Writes the jet of the map at `points[k]` to `jets[k]`; [`Jet::UNDEFINED`] outside the domain.
    /// The two slices have the same length.
    /// The jet of a point depends on nothing but that point.
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]);

    /// The inverse map, if it can be evaluated as readily as the map: a push-forward then is its pull-back.
    fn inverse(&self) -> Option<Box<dyn PlaneMap + '_>> {
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

    fn inverse(&self) -> Option<Box<dyn PlaneMap + '_>> {
        (**self).inverse()
    }
}
