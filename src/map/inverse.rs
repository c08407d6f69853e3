//! Maps that can be run backwards.

use super::jet::Jet;
use super::plane_map::PlaneMap;
use crate::plane::Complex64;

/// A map that knows its inverse as well.
pub trait InvertibleMap: PlaneMap {
    /// Writes the jet of the inverse map at `points[k]` to `jets[k]`; [`Jet::UNDEFINED`] outside the image.
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]);

    /// The inverse as a map.
    fn inverted(self) -> Inverse<Self>
    where
        Self: Sized,
    {
        Inverse(self)
    }
}

/// The inverse of a map.
///
/// ```
/// use conformal_warp::{Complex64, InvertibleMap, Jet, Moebius, PlaneMap};
/// let from_disk = Moebius::cayley().inverted();
/// let mut jet = [Jet::UNDEFINED];
/// from_disk.jets(&[Complex64::ZERO], &mut jet);
/// assert_eq!(jet[0].value, Complex64::I);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inverse<M>(pub M);

impl<M: InvertibleMap> InvertibleMap for &M {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        (**self).inverse_jets(points, jets);
    }
}

impl<M: InvertibleMap> PlaneMap for Inverse<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.0.inverse_jets(points, jets);
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(&self.0))
    }
}

impl<M: InvertibleMap> InvertibleMap for Inverse<M> {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.0.jets(points, jets);
    }
}
