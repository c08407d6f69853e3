//! A map's value and derivatives at a point.

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
