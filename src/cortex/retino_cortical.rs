//! Visual hemifield → V1 of any outline: the report's three steps in one map.

use super::half_disk::HalfDiskMap;
use super::landmark::Landmark;
use crate::map::compose::chain;
use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap};
use crate::plane::Complex64;
use crate::{Error, Result};

/// Right hemifield → left V1: stereographic half disk → disk → outline.
///
/// `M` is the conformal map outline → disk, Symm's for an outline that was measured; the inverse of it is the last step.
/// Two data make the map unique, as in the report: a landmark of the field (the blind spot) with its place on the cortex,
/// and the direction that the horizontal meridian has there.
#[derive(Clone, Debug)]
pub struct RetinoCorticalMap<M> {
    half_disk: HalfDiskMap,
    outline: M,
    landmark: Landmark,
}

impl<M: PlaneMap> RetinoCorticalMap<M> {
    /// The map that the landmark fixes.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] if the landmark lies outside the half disk, or the outline's map does not take its cortical
    /// place to 0.
    pub fn new(outline: M, landmark: Landmark) -> Result<Self> {
        let mut center = [Jet::UNDEFINED];
        outline.jets(&[landmark.cortex], &mut center);
        let [Jet { value, dz, .. }] = center;
        if value.norm().is_nan() || value.norm() > 1e-6 {
            let reason = "the map of the outline does not take the landmark's place to the disk's center";
            return Err(Error::InvalidMap { what: "A retino-cortical map", reason });
        }
        // dw/ds = T'(ω) / f'(w) must have the direction asked for.
        let half_disk = HalfDiskMap::new(landmark.field, landmark.direction + dz.arg())?;
        Ok(Self { half_disk, outline, landmark })
    }

    /// The correspondence asked for.
    #[must_use]
    pub fn landmark(&self) -> Landmark {
        self.landmark
    }

    /// How far the map misses the correspondence asked for: where the landmark lies, in the outline's units, and the direction
    /// of the meridian there, in radians. Nothing but rounding and the error of the outline's map.
    #[must_use]
    pub fn landmark_error(&self) -> [f64; 2]
    where
        M: InvertibleMap,
    {
        let Landmark { field, cortex, direction } = self.landmark;
        let found = self.jet(field);
        [(found.value - cortex).norm(), (found.dz * Complex64::cis(-direction)).arg().abs()]
    }

    /// The half disk's map: field coordinate → disk.
    #[must_use]
    pub fn half_disk(&self) -> &HalfDiskMap {
        &self.half_disk
    }

    /// The map of the outline: cortex → disk.
    #[must_use]
    pub fn outline(&self) -> &M {
        &self.outline
    }
}

impl<M: InvertibleMap> PlaneMap for RetinoCorticalMap<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let (first, second) = (&self.half_disk, &self.outline);
        chain(points, jets, |z, jets| first.jets(z, jets), |z, jets| second.inverse_jets(z, jets));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl<M: InvertibleMap> InvertibleMap for RetinoCorticalMap<M> {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let (first, second) = (&self.outline, &self.half_disk);
        chain(points, jets, |z, jets| first.jets(z, jets), |z, jets| second.inverse_jets(z, jets));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cortex::{CorticalModel, FieldPoint};
    use crate::map::{Compose, Inverse, Moebius};

    /// Cortex → disk where the answer is known: a dipole of the half disk, the unit of length in the field being 90°.
    type Exact = Compose<HalfDiskMap, Compose<Moebius, Inverse<CorticalModel>>>;

    fn exact(omega: Complex64) -> (Exact, impl PlaneMap) {
        let shrink = Moebius::new(Complex64::ONE, Complex64::ZERO, Complex64::ZERO, 90.0.into()).unwrap();
        let dipole = CorticalModel::POLIMENI_2006;
        let truth = Compose { outer: dipole, inner: shrink.inverse() };
        let half_disk = HalfDiskMap::new(omega, 2.2).unwrap();
        (Compose { outer: half_disk, inner: Compose { outer: shrink, inner: dipole.inverted() } }, truth)
    }

    #[test]
    fn the_landmark_fixes_the_map() {
        let field = FieldPoint::BLIND_SPOT.coordinate();
        let (outline, truth) = exact(field);
        let map = RetinoCorticalMap::new(outline, CorticalModel::POLIMENI_2006.landmark(field)).unwrap();
        for s in [field, Complex64::new(0.02, 0.01), Complex64::new(0.3, -0.8), Complex64::new(0.9, 0.1)] {
            let (found, expected) = (map.jet(s), truth.jet(s));
            assert!(
                (found.value - expected.value).norm() < 1e-11,
                "{s} goes to {}, not {}",
                found.value,
                expected.value
            );
            assert!((found.dz - expected.dz).norm() < 1e-10 * expected.dz.norm(), "{s}: {} {}", found.dz, expected.dz);
            let back = (&map).inverted().jet(found.value);
            assert!((back.value - s).norm() < 1e-12 && (back.dz * found.dz - 1.0).norm() < 1e-10);
        }
    }

    #[test]
    fn another_direction_turns_the_cortex_about_the_landmark() {
        let field = Complex64::new(0.2, 0.1);
        let (outline, truth) = exact(field);
        let cortex = truth.jet(field).value;
        for direction in [0.0, 1.0, -2.5] {
            let map = RetinoCorticalMap::new(outline.clone(), Landmark { field, cortex, direction }).unwrap();
            let found = map.jet(field);
            assert!((found.value - cortex).norm() < 1e-12);
            assert!((found.dz * Complex64::cis(-direction)).arg().abs() < 1e-12);
            assert!(map.landmark_error().iter().all(|&error| error < 1e-12));
        }
    }

    #[test]
    fn a_landmark_that_does_not_fit_is_refused() {
        let field = Complex64::new(0.2, 0.1);
        let (outline, truth) = exact(field);
        let cortex = truth.jet(field).value;
        for (field, cortex) in [(field, cortex + 1.0), (Complex64::new(-0.1, 0.0), cortex)] {
            let landmark = Landmark { field, cortex, direction: 0.0 };
            assert_eq!(RetinoCorticalMap::new(outline.clone(), landmark).unwrap_err().code(), "invalid-map");
        }
    }
}
