//! The other hemisphere.

use crate::map::{InvertibleMap, Jet, PlaneMap};
use crate::plane::Complex64;

/// A map between two reflections in the vertical axis, w = −conj(f(−conj(z))): left hemifield → right hemisphere, if f is
/// right hemifield → left hemisphere. Conformal where f is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirrored<M>(pub M);

fn reflect(z: Complex64) -> Complex64 {
    Complex64::new(-z.re, z.im)
}

fn between_reflections(points: &[Complex64], jets: &mut [Jet], f: impl FnOnce(&[Complex64], &mut [Jet])) {
    let reflected: Vec<Complex64> = points.iter().copied().map(reflect).collect();
    f(&reflected, jets);
    for jet in jets {
        *jet = Jet { value: reflect(jet.value), dz: jet.dz.conj(), dzbar: jet.dzbar.conj() };
    }
}

impl<M: PlaneMap> PlaneMap for Mirrored<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        between_reflections(points, jets, |points, jets| self.0.jets(points, jets));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Mirrored(self.0.inverse_map()?)))
    }
}

impl<M: InvertibleMap> InvertibleMap for Mirrored<M> {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        between_reflections(points, jets, |points, jets| self.0.inverse_jets(points, jets));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::FormulaMap;

    #[test]
    fn jets_are_those_of_the_written_out_map() {
        let mirrored = Mirrored(FormulaMap::new("i z^2 + 3z + conj(z)^3").unwrap());
        let written = FormulaMap::new("-conj(i conj(z)^2 - 3conj(z) - z^3)").unwrap();
        let points = [Complex64::new(0.3, 0.7), Complex64::new(-2.0, 0.1)];
        let (mut a, mut b) = ([Jet::UNDEFINED; 2], [Jet::UNDEFINED; 2]);
        mirrored.jets(&points, &mut a);
        written.jets(&points, &mut b);
        for (a, b) in a.iter().zip(&b) {
            assert!(
                (a.value - b.value).norm() + (a.dz - b.dz).norm() + (a.dzbar - b.dzbar).norm() < 1e-13,
                "{a:?} {b:?}"
            );
        }
    }
}
