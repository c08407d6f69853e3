//! Half disk → disk: the report's T = H∘G∘F.

use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap, pointwise};
use crate::plane::Complex64;
use crate::{Error, Result};

/// The conformal map of the half disk |s| ≤ 1, Re s ≥ 0 onto the unit disk that takes ω to 0.
///
/// F(s) = (1 + is)/(1 − is) takes the half disk to a quadrant, G(u) = u² that to the upper half plane, H to the disk. Written
/// out, with e^{iφ} for the rotation,
/// ```text
/// T(s) = e^{iφ} (s − ω)(1 + ωs) / ((s + ω̄)(1 − ω̄s))
/// T'(s) = e^{iφ} (ω + ω̄)(1 − |ω|²)(1 + s²) / ((s + ω̄)(1 − ω̄s))²
/// ```
/// which is T by the method of images: zeros at ω and its mirror image in the circle, poles at those of the straight
/// edge's other side. Nothing cancels and nothing is infinite on the half disk; T' is 0 in its corners ±i, where right
/// angles open to straight ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfDiskMap {
    omega: Complex64,
    turn: Complex64,
}

/// Rounding may take a point of the rim this far out.
const RIM: f64 = 1e-12;

impl HalfDiskMap {
    /// The map that takes `omega` to 0 and turns the disk by `angle` radians from where T'(ω) is positive.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless ω lies strictly inside the half disk.
    pub fn new(omega: Complex64, angle: f64) -> Result<Self> {
        let inside = omega.re > 0.0 && omega.norm() < 1.0;
        if !inside || !angle.is_finite() {
            let reason = "the point that goes to 0 does not lie strictly inside the half disk";
            return Err(Error::InvalidMap { what: "A map of the half disk onto the disk", reason });
        }
        let plain = Self { omega, turn: Complex64::ONE };
        let direction = plain.forward(omega).dz;
        Ok(Self { omega, turn: Complex64::cis(angle) * direction.conj() / direction.norm() })
    }

    /// The map with `omega` at 0 and the point `toward` of the half disk (on its rim, say) on the positive real axis.
    ///
    /// # Errors
    /// The errors of [`HalfDiskMap::new`], also if `toward` is `omega` or outside the closed half disk.
    pub fn with_direction(omega: Complex64, toward: Complex64) -> Result<Self> {
        let plain = Self::new(omega, 0.0)?;
        let image = plain.forward(toward).value;
        if !contains(toward) || image == Complex64::ZERO {
            let reason = "the point of its direction is not another point of the half disk";
            return Err(Error::InvalidMap { what: "A map of the half disk onto the disk", reason });
        }
        Ok(Self { omega, turn: plain.turn * image.conj() / image.norm() })
    }

    /// The field coordinate ω, which goes to 0.
    #[must_use]
    pub fn omega(&self) -> Complex64 {
        self.omega
    }

    fn forward(&self, s: Complex64) -> Jet {
        let (omega, bar) = (self.omega, self.omega.conj());
        let denominator = (s + bar) * (1.0 - bar * s);
        let value = self.turn * (s - omega) * (1.0 + omega * s) / denominator;
        // 1 + s² by its factors: exact where it is small.
        let corners = Complex64::new(1.0 - s.im, s.re) * Complex64::new(1.0 + s.im, -s.re);
        let scale = 2.0 * omega.re * (1.0 - omega.norm_sqr());
        Jet::analytic(value, self.turn * scale * corners / (denominator * denominator))
    }

    /// Solves A s² + B s − A = 0, which is T(s) = t cleared of its denominator. The roots are s and −1/s.
    fn backward(&self, t: Complex64) -> Jet {
        let (omega, bar) = (self.omega, self.omega.conj());
        let t = t * self.turn.conj();
        let a = omega + t * bar;
        let b = (1.0 - omega * omega) - t * (1.0 - bar * bar);
        let (low, high) = (b - 2.0 * Complex64::I * a, b + 2.0 * Complex64::I * a);
        let root = low.sqrt() * high.sqrt();
        let (plus, minus) = (b + root, b - root);
        let larger = if plus.norm_sqr() > minus.norm_sqr() { plus } else { minus };
        let small = 2.0 * a / larger;
        // On the round rim both roots are as large, and the half tells which it is.
        let s = if small.re < 0.0 && small.norm_sqr() > 1.0 - 1e-6 { -small.inv() } else { small };
        Jet::analytic(s, self.forward(s).dz.inv())
    }
}

fn contains(s: Complex64) -> bool {
    s.re >= -RIM && s.norm() <= 1.0 + RIM
}

impl PlaneMap for HalfDiskMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |s| contains(s).then(|| self.forward(s)));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for HalfDiskMap {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |t| (t.norm() <= 1.0 + RIM).then(|| self.backward(t)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn c(re: f64, im: f64) -> Complex64 {
        Complex64::new(re, im)
    }

    /// H(G(F(s))), as the report composes it.
    fn composed(omega: Complex64, s: Complex64) -> Complex64 {
        let half_plane = |s: Complex64| ((1.0 + Complex64::I * s) / (1.0 - Complex64::I * s)).powi(2);
        let (u, u0) = (half_plane(s), half_plane(omega));
        (u - u0) / (u - u0.conj())
    }

    const OMEGAS: [Complex64; 4] =
        [Complex64::new(0.5, 0.0), Complex64::new(0.13, -0.013), Complex64::new(0.02, 0.9), Complex64::new(0.7, 0.69)];

    #[test]
    fn agrees_with_the_composition_of_the_report() {
        for omega in OMEGAS {
            let map = HalfDiskMap::new(omega, 0.0).unwrap();
            let turn = map.turn * (map.turn.inv() * map.jet(c(0.31, 0.2)).value / composed(omega, c(0.31, 0.2)));
            for s in [c(0.1, 0.1), c(0.6, -0.7), c(0.0, 0.4), c(0.96, 0.28), c(0.5, 0.0)] {
                let difference = map.jet(s).value - turn * composed(omega, s);
                assert!(difference.norm() < 1e-13, "ω = {omega}, s = {s}: {difference}");
            }
            let center = map.jet(omega);
            assert_eq!(center.value, Complex64::ZERO);
            assert!(center.dz.re > 0.0 && center.dz.im.abs() < 1e-15 * center.dz.re);
        }
    }

    #[test]
    fn the_rim_goes_to_the_circle() {
        for omega in OMEGAS {
            let map = HalfDiskMap::new(omega, 1.0).unwrap();
            for k in 0..=20 {
                let t = f64::from(k) / 10.0 - 1.0;
                for s in [c(0.0, t), Complex64::cis(0.5 * PI * t)] {
                    assert!((map.jet(s).value.norm() - 1.0).abs() < 1e-13, "ω = {omega}, s = {s}");
                }
            }
            assert!(map.jet(c(-0.01, 0.0)).value.is_nan() && map.jet(c(0.8, 0.8)).value.is_nan());
        }
    }

    #[test]
    fn inverts_to_rounding_corners_included() {
        for omega in OMEGAS {
            let map = HalfDiskMap::with_direction(omega, Complex64::ZERO).unwrap();
            let fovea = map.jet(Complex64::ZERO).value;
            assert!((fovea - 1.0).norm() < 1e-15, "the fovea goes to {fovea}");
            for k in 0..400 {
                let (radius, angle) = (f64::from(k % 20) / 19.0, PI * (f64::from(k / 20) / 19.0 - 0.5));
                let s = Complex64::from_polar(radius, angle);
                let there = map.jet(s);
                let back = map.inverted().jet(there.value);
                // Rounding of T over its slope; in a corner T is quadratic, and its inverse a square root.
                let slope = there.dz.norm();
                let tolerance = 1e-14 + (4e-15 / slope).min(1e-6);
                let error = (back.value - s).norm();
                assert!(error < tolerance, "ω = {omega}: {s} came back as {}, slope {slope:e}", back.value);
                if slope > 1e-3 {
                    assert!((back.dz * there.dz - 1.0).norm() < 1e-10, "{s}: {}", back.dz * there.dz);
                }
            }
        }
    }

    #[test]
    fn derivatives_agree_with_differences() {
        let map = HalfDiskMap::new(c(0.13, -0.4), 0.6).unwrap();
        for s in [c(0.3, 0.2), c(0.9, 0.1), c(0.05, -0.8)] {
            for h in [c(1e-5, 0.0), c(0.0, 1e-5)] {
                let difference = (map.jet(s + h).value - map.jet(s - h).value) / (2.0 * h);
                assert!((difference - map.jet(s).dz).norm() < 1e-8 * map.jet(s).dz.norm(), "{s}");
            }
        }
        for omega in [c(0.0, 0.5), c(-0.1, 0.0), c(1.0, 0.0), c(f64::NAN, 0.0)] {
            assert_eq!(HalfDiskMap::new(omega, 0.0).unwrap_err().code(), "invalid-map");
        }
        assert!(HalfDiskMap::with_direction(c(0.5, 0.0), c(0.5, 0.0)).is_err());
    }
}
