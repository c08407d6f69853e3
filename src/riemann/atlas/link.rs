//! Automorphisms of the unit disk as matrices: how the maps of one region for two centers are related.

use crate::plane::Complex64;

/// w → (a w + b)/(b̄ w + ā) with |a|² − |b|² = 1: disk → disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    a: Complex64,
    b: Complex64,
}

impl Link {
    /// w → w.
    pub const IDENTITY: Self = Self { a: Complex64::ONE, b: Complex64::ZERO };

    /// w → e^{iφ}(w − p)/(1 − p̄ w), with φ such that 0 goes to `image` (or as near as its size allows).
    #[must_use]
    pub fn new(p: Complex64, image: Complex64) -> Self {
        let half_turn = (-image / p).arg() * 0.5;
        let a = Complex64::cis(half_turn) / (1.0 - p.norm_sqr()).sqrt();
        Self { a, b: -a * p }
    }

    /// w → (a w + b)/(b̄ w + ā).
    #[must_use]
    pub fn from_matrix(a: Complex64, b: Complex64) -> Self {
        Self { a, b }
    }

    /// By how much it moves 0: |a|, cosh of half the hyperbolic distance.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.a.norm()
    }

    /// b̄ w + ā: the derivative at w is its square's inverse, and the image of a chord from w to v is the chord over
    /// `root(w) root(v)`.
    #[inline]
    #[must_use]
    pub fn root(&self, w: Complex64) -> Complex64 {
        self.b.conj() * w + self.a.conj()
    }

    /// The image of a point of the closed disk.
    #[inline]
    #[must_use]
    pub fn apply(&self, w: Complex64) -> Complex64 {
        (self.a * w + self.b) / self.root(w)
    }

    /// Its derivative there.
    #[inline]
    #[must_use]
    pub fn slope(&self, w: Complex64) -> Complex64 {
        self.root(w).powi(-2)
    }

    /// The size of the derivative.
    #[must_use]
    pub fn stretch(&self, w: Complex64) -> f64 {
        1.0 / self.root(w).norm_sqr()
    }

    /// The least and the largest size of the derivative in the disk around `center`.
    #[must_use]
    pub fn stretch_within(&self, center: Complex64, radius: f64) -> (f64, f64) {
        let (distance, reach) = (self.root(center).norm(), self.b.norm() * radius);
        ((distance + reach).powi(-2), (distance - reach).max(0.0).powi(-2))
    }

    /// The inverse.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { a: self.a.conj(), b: -self.b }
    }

    /// self ∘ first.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self { a: self.a * first.a + self.b * first.b.conj(), b: self.a * first.b + self.b * first.a.conj() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn takes_its_center_to_0_and_0_to_its_image() {
        let (p, image) = (Complex64::new(0.6, -0.3), Complex64::from_polar(0.45f64.sqrt(), 2.0));
        let link = Link::new(p, image);
        assert!(link.apply(p).norm() < 1e-15 && (link.apply(Complex64::ZERO) - image).norm() < 1e-15);
        let w = Complex64::new(-0.2, 0.5);
        assert!((link.inverse().apply(link.apply(w)) - w).norm() < 1e-15);
        assert!((link.after(&link).apply(w) - link.apply(link.apply(w))).norm() < 1e-15);
        let h = 1e-6;
        let difference = (link.apply(w + h) - link.apply(w - h)) / (2.0 * h);
        assert!((link.slope(w) - difference).norm() < 1e-8);
        let (least, most) = link.stretch_within(w, 0.1);
        assert!(least < link.stretch(w + 0.05) && link.stretch(w + 0.05) < most);
        assert!((link.stretch(w) - link.slope(w).norm()).abs() < 1e-14);
    }
}
