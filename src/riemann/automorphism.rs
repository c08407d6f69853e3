//! Automorphisms of the disk that keep 1 in its place: how the maps of one region for two centers are related.

use super::near_one::{exp_m1, ln_1p};
use super::rounding::{is_on_circle, onto_disk};
use crate::plane::Complex64;
use std::f64::consts::{PI, TAU};

/// w → c (w − a)/(1 − ā w) with c = (1 − ā)/(1 − a): disk → disk, a ↦ 0 and 1 ↦ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Automorphism {
    a: Complex64,
    turn: Complex64,
}

impl Automorphism {
    /// The one that takes `a` to 0; |a| < 1.
    pub fn new(a: Complex64) -> Self {
        let turn = (1.0 - a.conj()) / (1.0 - a);
        Self { a, turn: turn / turn.norm() }
    }

    /// What goes to 0.
    pub fn zero(&self) -> Complex64 {
        self.a
    }

    /// The inverse: it takes the image of 0 to 0.
    pub fn inverse(&self) -> Self {
        Self { a: -self.turn * self.a, turn: self.turn.conj() }
    }

    /// The image of a point of the closed disk; what is on the circle stays there.
    pub fn apply(&self, w: Complex64) -> Complex64 {
        let image = self.turn * (w - self.a) / (1.0 - self.a.conj() * w);
        if is_on_circle(w) { onto_disk(image / image.norm()) } else { image }
    }

    /// The derivative there.
    pub fn slope(&self, w: Complex64) -> Complex64 {
        let root = 1.0 - self.a.conj() * w;
        self.turn * (1.0 - self.a.norm_sqr()) / (root * root)
    }

    /// The largest size of the derivative on the disk.
    pub fn stretch(&self) -> f64 {
        (1.0 + self.a.norm()) / (1.0 - self.a.norm())
    }

    /// Point of the circle → its image, both as shares of the way round from 1, which whole turns may be added to.
    ///
    /// With q = 1 − āe^{iθ}, c (e^{iθ} − a)/(1 − āe^{iθ}) = e^{iθ} (q̄(θ)/q(θ)) / (q̄(0)/q(0)).
    pub fn share(&self, share: f64) -> f64 {
        let turns = share.floor();
        let theta = TAU * (share - turns);
        let step = exp_m1(Complex64::new(0.0, theta));
        let ratio = 1.0 - self.a.conj() * step / (1.0 - self.a.conj());
        turns + (theta / TAU - ratio.arg() / PI).clamp(0.0, 1.0)
    }

    /// −i log(w/w₀) → −i log(v/v₀) for the images v, v₀ of w and of a point w₀ of the circle, as exact relatively.
    pub fn angle_from(&self, origin: Complex64, angle: Complex64) -> Complex64 {
        let step = origin * exp_m1(Complex64::I * angle);
        let (from_zero, root) = (origin - self.a, 1.0 - self.a.conj() * origin);
        let moved = step * (1.0 - self.a.norm_sqr()) / (from_zero * (root - self.a.conj() * step));
        -Complex64::I * ln_1p(moved)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ZEROS: [Complex64; 4] = [
        Complex64::new(0.0, 0.0),
        Complex64::new(0.3, -0.4),
        Complex64::new(-0.05, 0.97),
        Complex64::new(0.999, 0.001),
    ];

    #[test]
    fn the_zero_goes_to_0_and_1_stays() {
        for a in ZEROS {
            let map = Automorphism::new(a);
            assert!(map.apply(a).norm() < 1e-15 && (map.apply(Complex64::ONE) - 1.0).norm() < 1e-15);
            for w in [Complex64::new(0.2, 0.5), Complex64::cis(2.0), Complex64::new(-0.7, -0.1)] {
                let image = map.apply(w);
                assert!((map.inverse().apply(image) - w).norm() < 1e-15 * map.stretch(), "{a}: {w}");
                let product = map.inverse().slope(image) * map.slope(w);
                assert!((product - 1.0).norm() < 1e-12, "{a}: {product}");
                assert!(map.slope(w).norm() <= map.stretch() * (1.0 + 1e-12));
            }
            let h = 1e-6;
            let w = Complex64::new(-0.3, 0.2);
            let difference = (map.apply(w + h) - map.apply(w - h)) / (2.0 * h);
            assert!((map.slope(w) - difference).norm() < 1e-8, "{a}");
        }
    }

    #[test]
    fn shares_of_the_circle_go_round_once() {
        for a in ZEROS {
            let map = Automorphism::new(a);
            let mut last = 0.0;
            for k in 0..=1000 {
                let share = f64::from(k) / 1000.0;
                let image = map.share(share);
                assert!(image >= last && image <= 1.0, "{a}: {share} goes to {image}");
                let apart = Complex64::cis(TAU * image) - map.apply(Complex64::cis(TAU * share));
                assert!(apart.norm() < 1e-15 * map.stretch() + 2e-15, "{a}: {apart}");
                assert!((map.inverse().share(image) - share).abs() < 1e-15 * map.stretch() + 1e-15, "{a}: {share}");
                last = image;
            }
            assert_eq!((map.share(0.0), map.share(3.0)), (0.0, 3.0));
            // Beside 1 with the relative accuracy that a share has.
            let tiny = 1e-250;
            let ratio = map.share(tiny) / tiny / map.slope(Complex64::ONE).norm();
            assert!((ratio - 1.0).abs() < 1e-12, "{a}: {ratio}");
        }
    }

    #[test]
    fn angles_beside_a_point_are_exact_relatively() {
        for a in ZEROS {
            let map = Automorphism::new(a);
            let origin = Complex64::cis(2.5);
            let image = map.apply(origin);
            for angle in [Complex64::new(0.3, 0.2), Complex64::new(-1e-3, 1e-3), Complex64::new(1e-200, 2e-200)] {
                let moved = map.angle_from(origin, angle);
                let back = map.inverse().angle_from(image, moved);
                assert!((back - angle).norm() < 1e-12 * angle.norm(), "{a}: {angle} came back as {back}");
                let expected = -Complex64::I * (map.apply(origin * (Complex64::I * angle).exp()) / image).ln();
                assert!((moved - expected).norm() < 1e-12, "{a}: {moved} is not {expected}");
            }
        }
    }
}
