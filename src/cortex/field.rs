//! The visual field: directions as eccentricity and azimuth, as the stereographic coordinate, and in degrees.

use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap, pointwise};
use crate::plane::Complex64;

/// A direction of the visual field, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldPoint {
    /// Angle from the line of sight, 0 … 180.
    pub eccentricity: f64,
    /// Angle around it: 0 to the right, 90 up.
    pub azimuth: f64,
}

impl FieldPoint {
    /// The middle of the blind spot of a right eye: 15° temporal and 1.5° below the line of sight.
    pub const BLIND_SPOT: Self = Self { eccentricity: 15.074_813, azimuth: -5.710_593 };

    /// E·e^{iθ} in degrees → direction.
    #[must_use]
    pub fn from_degrees(z: Complex64) -> Self {
        Self { eccentricity: z.norm(), azimuth: z.arg().to_degrees() }
    }

    /// Direction → stereographic field coordinate tan(E/2)·e^{iθ}.
    ///
    /// ```
    /// use conformal_warp::FieldPoint;
    /// let up = FieldPoint { eccentricity: 90.0, azimuth: 90.0 }.coordinate();
    /// assert!((up.re.abs() < 1e-15) && (up.im - 1.0).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn coordinate(self) -> Complex64 {
        Complex64::from_polar((0.5 * self.eccentricity.to_radians()).tan(), self.azimuth.to_radians())
    }

    /// Stereographic field coordinate → direction.
    #[must_use]
    pub fn from_coordinate(s: Complex64) -> Self {
        Self { eccentricity: 2.0 * s.norm().atan().to_degrees(), azimuth: s.arg().to_degrees() }
    }
}

/// Field coordinate s → E·e^{iθ} with E in degrees: the plane in which the cortical models are written.
///
/// Not conformal away from the fovea: the azimuthal equidistant chart stretches rings by E/sin E.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Degrees;

/// The jet of z = ρe^{iθ} → g(ρ)e^{iθ}, from ρ, g(ρ)/ρ and g'(ρ).
fn radial(z: Complex64, rho: f64, ratio: f64, slope: f64) -> Jet {
    let turn = if rho == 0.0 { Complex64::ONE } else { z / rho };
    Jet { value: z * ratio, dz: (0.5 * (slope + ratio)).into(), dzbar: turn * turn * (0.5 * (slope - ratio)) }
}

/// |z|, many times faster than `hypot`, for the sake of numbers that no field has.
fn modulus(z: Complex64) -> f64 {
    z.norm_sqr().sqrt()
}

impl PlaneMap for Degrees {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |s| {
            let rho = modulus(s);
            let ratio: f64 = if rho < 1e-8 { 2.0 } else { 2.0 * rho.atan() / rho };
            let slope: f64 = 2.0 / (1.0 + rho * rho);
            rho.is_finite().then(|| radial(s, rho, ratio.to_degrees(), slope.to_degrees()))
        });
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for Degrees {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |z| {
            let degree = 1f64.to_radians();
            let rho = modulus(z);
            let half = 0.5 * rho * degree;
            let tangent = half.tan();
            let ratio = if half < 1e-8 { 0.5 } else { 0.5 * tangent / half };
            // 180° is the point opposite to the line of sight, which has no coordinate.
            (half < std::f64::consts::FRAC_PI_2)
                .then(|| radial(z, rho, ratio * degree, 0.5 * degree * (1.0 + tangent * tangent)))
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_blind_spot_is_where_it_should_be() {
        let degrees = Degrees.jet(FieldPoint::BLIND_SPOT.coordinate()).value;
        assert!((degrees - Complex64::new(15.0, -1.5)).norm() < 1e-5, "{degrees}");
        assert_eq!(FieldPoint::from_degrees(Complex64::new(0.0, 2.0)), FieldPoint { eccentricity: 2.0, azimuth: 90.0 });
        let again = FieldPoint::from_coordinate(FieldPoint::BLIND_SPOT.coordinate());
        assert!((again.eccentricity - FieldPoint::BLIND_SPOT.eccentricity).abs() < 1e-13);
        assert!((again.azimuth - FieldPoint::BLIND_SPOT.azimuth).abs() < 1e-13);
    }

    #[test]
    fn degrees_invert_with_their_jacobian() {
        for s in [(0.0, 0.0), (1e-9, 1e-9), (0.3, -0.2), (0.0, 1.0), (5.0, 2.0)].map(|(x, y)| Complex64::new(x, y)) {
            let there = Degrees.jet(s);
            let back = Degrees.inverted().jet(there.value);
            assert!((back.value - s).norm() < 1e-13 * (1.0 + s.norm_sqr()), "{s} came back as {}", back.value);
            let product = back.after(&there);
            assert!(
                (product.dz - 1.0).norm() + product.dzbar.norm() < 1e-12 * (1.0 + s.norm_sqr()),
                "{s}: {product:?}"
            );
            // Across the ray the scale is E/sin E of that along it.
            if s.norm() > 0.1 {
                let e = there.value.norm().to_radians();
                let (along, across) = (there.dz.norm() + signed(&there, s), there.dz.norm() - signed(&there, s));
                assert!((across / along - e / e.sin()).abs() < 1e-12, "{s}");
            }
        }
        assert!(Degrees.inverted().jet(Complex64::new(180.0, 0.0)).value.is_nan());
    }

    /// ∂/∂s̄ along the ray, with its sign.
    fn signed(jet: &Jet, s: Complex64) -> f64 {
        (jet.dzbar * (s.conj() / s.norm()).powi(2)).re
    }
}
