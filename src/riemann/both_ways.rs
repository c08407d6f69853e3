//! What maps share that are known point by point, with the derivative, both ways.

use crate::map::{Jet, pointwise};
use crate::plane::{Complex64, NOWHERE};

/// A map known point by point.
pub(super) trait Pointwise {
    /// (f, f') at a point; `None` outside.
    fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)>;

    /// f alone.
    fn value(&self, z: Complex64) -> Option<Complex64> {
        self.at(z).map(|(w, _)| w)
    }

    /// f at points; NaN outside.
    fn images(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.value(z).unwrap_or(NOWHERE)).collect()
    }

    /// f' at points; NaN outside.
    fn slopes(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.at(z).map_or(NOWHERE, |(_, slope)| slope)).collect()
    }

    /// Writes the jets of f.
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |z| self.at(z).map(|(w, slope)| Jet::analytic(w, slope)));
    }
}

/// The places of images, by the way back; NaN where there is none.
pub(super) fn places(
    images: &[Complex64],
    way_back: impl Fn(Complex64) -> Option<(Complex64, Complex64)>,
) -> Vec<Complex64> {
    images.iter().map(|&w| way_back(w).map_or(NOWHERE, |(z, _)| z)).collect()
}

/// Makes a class with a [`Pointwise`] map in `map` a map that goes both ways: w → (z, dz/dw) by its method, or its map's.
macro_rules! two_ways {
    ($class:ident, $($way_back:ident).+) => {
        impl $crate::map::PlaneMap for $class {
            fn jets(&self, points: &[$crate::plane::Complex64], jets: &mut [$crate::map::Jet]) {
                $crate::riemann::both_ways::Pointwise::jets(&self.map, points, jets);
            }

            fn inverse_map(&self) -> Option<Box<dyn $crate::map::PlaneMap + '_>> {
                Some(Box::new($crate::map::Inverse(self)))
            }
        }

        impl $crate::map::InvertibleMap for $class {
            fn inverse_jets(&self, points: &[$crate::plane::Complex64], jets: &mut [$crate::map::Jet]) {
                let jet = |(z, slope)| $crate::map::Jet::analytic(z, slope);
                $crate::map::pointwise(points, jets, |w| self.$($way_back).+(w).map(jet));
            }
        }
    };
}
pub(super) use two_ways;
