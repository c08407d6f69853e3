//! From which side an outline of the cortex is seen.

use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap};
use crate::plane::Complex64;

/// How an outline of V1 was laid flat.
///
/// V1 is a mirror image of the visual field: seen from outside, with the fovea on the left, the lower field lies above (a left
/// hemisphere's medial side, dorsal up). Outlines of measured brains are such. The closed formulas draw the upper field
/// above, which is the mirror image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OutlineView {
    /// As the formulas draw it: the map is conformal, the upper field on the left as one leaves the fovea.
    #[default]
    Mirrored,
    /// As the surface is seen from outside: the map turns angles round, the lower field is on the left.
    Pial,
}

impl OutlineView {
    /// The field coordinate that the conformal map of such an outline takes for one of the field: itself, or its mirror image
    /// in the horizontal meridian.
    #[must_use]
    pub fn coordinate(self, field: Complex64) -> Complex64 {
        match self {
            Self::Mirrored => field,
            Self::Pial => field.conj(),
        }
    }
}

/// z → f(z̄): a map of the field turned upside down.
#[derive(Clone, Copy, Debug)]
pub(super) struct UpsideDown<M>(pub M);

impl<M: PlaneMap> PlaneMap for UpsideDown<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let turned: Vec<Complex64> = points.iter().map(Complex64::conj).collect();
        self.0.jets(&turned, jets);
        for jet in jets {
            (jet.dz, jet.dzbar) = (jet.dzbar, jet.dz);
        }
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        let inverse = self.0.inverse_map()?;
        Some(Box::new(ThenUpsideDown(inverse)))
    }
}

impl<M: InvertibleMap> InvertibleMap for UpsideDown<M> {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        ThenUpsideDown(Inverse(&self.0)).jets(points, jets);
    }
}

/// The conjugate of f(z).
struct ThenUpsideDown<M>(M);

impl<M: PlaneMap> PlaneMap for ThenUpsideDown<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.0.jets(points, jets);
        for jet in jets {
            *jet = Jet { value: jet.value.conj(), dz: jet.dzbar.conj(), dzbar: jet.dz.conj() };
        }
    }
}
