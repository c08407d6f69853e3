//! One map after another.

use super::inverse::InvertibleMap;
use super::jet::Jet;
use super::plane_map::PlaneMap;
use crate::plane::Complex64;

/// outer ∘ inner: z → outer(inner(z)), with the chain rule.
///
/// ```
/// use conformal_warp::{Complex64, Compose, FormulaMap, Jet, PlaneMap};
/// let map = Compose { outer: FormulaMap::new("z^2")?, inner: FormulaMap::new("z + 1")? };
/// let mut jet = [Jet::UNDEFINED];
/// map.jets(&[Complex64::new(2.0, 0.0)], &mut jet);
/// assert_eq!((jet[0].value.re, jet[0].dz.re), (9.0, 6.0));
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Compose<F, G> {
    /// Applied second.
    pub outer: F,
    /// Applied first.
    pub inner: G,
}

impl<F: PlaneMap, G: PlaneMap> PlaneMap for Compose<F, G> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let (first, second) = (&self.inner, &self.outer);
        chain(points, jets, |z, jets| first.jets(z, jets), |z, jets| second.jets(z, jets));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Compose { outer: self.inner.inverse_map()?, inner: self.outer.inverse_map()? }))
    }
}

impl<F: InvertibleMap, G: InvertibleMap> InvertibleMap for Compose<F, G> {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let (first, second) = (&self.outer, &self.inner);
        chain(points, jets, |z, jets| first.inverse_jets(z, jets), |z, jets| second.inverse_jets(z, jets));
    }
}

/// The jets of `second` after `first`.
pub(crate) fn chain(
    points: &[Complex64],
    jets: &mut [Jet],
    first: impl FnOnce(&[Complex64], &mut [Jet]),
    second: impl FnOnce(&[Complex64], &mut [Jet]),
) {
    first(points, jets);
    let images: Vec<Complex64> = jets.iter().map(|jet| jet.value).collect();
    let mut outer = vec![Jet::UNDEFINED; points.len()];
    second(&images, &mut outer);
    for (jet, outer) in jets.iter_mut().zip(outer) {
        *jet = outer.after(jet);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::FormulaMap;
    use crate::map::Moebius;

    #[test]
    fn the_chain_rule_holds_for_maps_that_are_not_analytic() {
        let points = [Complex64::new(0.3, 0.8), Complex64::new(-1.1, 0.2)];
        let composed = Compose {
            outer: FormulaMap::new("z |z| + conj(z)^2").unwrap(),
            inner: FormulaMap::new("z^2 + 3re(z) - conj(z)").unwrap(),
        };
        let written_out =
            FormulaMap::new("(z^2 + 3re(z) - conj(z)) |z^2 + 3re(z) - conj(z)| + conj(z^2 + 3re(z) - conj(z))^2")
                .unwrap();
        let (mut a, mut b) = ([Jet::UNDEFINED; 2], [Jet::UNDEFINED; 2]);
        composed.jets(&points, &mut a);
        written_out.jets(&points, &mut b);
        for (a, b) in a.iter().zip(&b) {
            assert!((a.value - b.value).norm() < 1e-14, "{a:?} {b:?}");
            assert!((a.dz - b.dz).norm() < 1e-13 && (a.dzbar - b.dzbar).norm() < 1e-13, "{a:?} {b:?}");
        }
    }

    #[test]
    fn outside_the_inner_domain_nothing_is_defined() {
        let composed = Compose { outer: FormulaMap::new("3").unwrap(), inner: FormulaMap::new("1/z").unwrap() };
        let mut jets = [Jet::UNDEFINED; 2];
        composed.jets(&[Complex64::ZERO, Complex64::ONE], &mut jets);
        assert!(jets[0].value.is_nan() && jets[1].value.re == 3.0);
    }

    #[test]
    fn inverts_in_the_other_order() {
        let shift = Moebius::new(1.0.into(), 2.0.into(), 0.0.into(), 1.0.into()).unwrap();
        let map = Compose { outer: Moebius::cayley(), inner: shift };
        let z = Complex64::new(0.4, 0.9);
        let (mut there, mut back) = ([Jet::UNDEFINED], [Jet::UNDEFINED]);
        map.jets(&[z], &mut there);
        map.inverse_jets(&[there[0].value], &mut back);
        assert!((back[0].value - z).norm() < 1e-15 && (back[0].dz * there[0].dz - 1.0).norm() < 1e-15);
    }
}
