//! Closed formulas for the map from visual field to V1.

use super::landmark::Landmark;
use super::outline::polygon;
use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap, pointwise};
use crate::plane::Complex64;
use crate::{Error, Result};
use std::f64::consts::FRAC_PI_2;

/// Visual hemifield → V1, by a formula: z = E·e^{iθ} in degrees, Re z ≥ 0, to millimetres, the fovea going to 0.
///
/// ```text
/// monopole       w = k log((z + a)/a)
/// dipole         w = k log((z + a)/(z + b)) + k log(b/a)
/// wedge-dipole   the dipole of E·e^{iαθ}
/// ```
/// after Balasubramanian, Polimeni and Schwartz (2002). The horizontal meridian goes to the positive real axis. The
/// shear α ≠ 1 of the wedge makes the map not conformal; its Jacobian says by how much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorticalModel {
    k: f64,
    a: f64,
    /// Where the periphery is compressed; infinite for a monopole.
    b: f64,
    shear: f64,
    extent: f64,
}

impl CorticalModel {
    /// The dipole of J. Polimeni, M. Balasubramanian and E. L. Schwartz (Vision Research 46, 2006): k = 15 mm, a = 0.69°, b = 80°.
    pub const POLIMENI_2006: Self = Self { k: 15.0, a: 0.69, b: 80.0, shear: 1.0, extent: 90.0 };

    /// The dipole of M. Schira and others (PLoS Computational Biology 6, 2010): k = 18 mm, a = 1.05°, b = 90°.
    pub const SCHIRA_2010: Self = Self { k: 18.0, a: 1.05, b: 90.0, shear: 1.0, extent: 90.0 };

    /// w = k log((z + a)/a), k in millimetres, a in degrees.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless both are positive.
    pub fn monopole(k: f64, a: f64) -> Result<Self> {
        Self { k, a, b: f64::INFINITY, shear: 1.0, extent: 90.0 }.checked()
    }

    /// w = k log((z + a)/(z + b)) + k log(b/a), k in millimetres, a and b in degrees.
    ///
    /// ```
    /// use conformal_warp::CorticalModel;
    /// let human = CorticalModel::dipole(15.0, 0.69, 80.0)?;
    /// assert_eq!(human, CorticalModel::POLIMENI_2006);
    /// assert!((human.area_within(90.0) / 2253.0 - 1.0).abs() < 0.01); // mm²
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless k > 0 and 0 < a < b.
    pub fn dipole(k: f64, a: f64, b: f64) -> Result<Self> {
        Self { k, a, b, shear: 1.0, extent: 90.0 }.checked()
    }

    /// The dipole after the wedge E·e^{iθ} → E·e^{iαθ}, α = `shear`.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless k > 0, 0 < a < b and 0 < α < 2.
    pub fn wedge_dipole(k: f64, a: f64, b: f64, shear: f64) -> Result<Self> {
        Self { k, a, b, shear, extent: 90.0 }.checked()
    }

    /// The same model of the field up to another eccentricity than 90 degrees.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless it is positive and at most 180.
    pub fn up_to(self, eccentricity: f64) -> Result<Self> {
        Self { extent: eccentricity, ..self }.checked()
    }

    /// The same model with lengths on the cortex multiplied so that the whole has an area of `area` mm².
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless it is positive and finite.
    pub fn with_area(self, area: f64) -> Result<Self> {
        if !area.is_finite() || area <= 0.0 {
            let reason = "its area must be a positive number of square millimetres";
            return Err(Error::InvalidMap { what: "A cortical model", reason });
        }
        Self { k: self.k * (area / self.area_within(self.extent)).sqrt(), ..self }.checked()
    }

    fn checked(self) -> Result<Self> {
        let Self { k, a, b, shear, extent } = self;
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let reason = if !positive(k) || !positive(a) || b.is_nan() || b <= a {
            "it needs k > 0 and 0 < a < b"
        } else if !positive(shear) || shear >= 2.0 {
            "its shear must lie between 0 and 2"
        } else if !positive(extent) || extent > 180.0 {
            "its largest eccentricity must be more than 0 and at most 180 degrees"
        } else if !self.area_within(extent).is_normal() {
            "its area is no number of square millimetres"
        } else {
            return Ok(self);
        };
        Err(Error::InvalidMap { what: "A cortical model", reason })
    }

    /// k in millimetres, a and b in degrees (b infinite for a monopole) and the shear α.
    #[must_use]
    pub fn parameters(&self) -> [f64; 4] {
        [self.k, self.a, self.b, self.shear]
    }

    /// The largest eccentricity, in degrees.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Cortical magnification along the horizontal meridian, in mm per degree: k/(E + a) − k/(E + b).
    #[must_use]
    pub fn magnification(&self, eccentricity: f64) -> f64 {
        self.slope(eccentricity.into()).re
    }

    /// Area in mm² of what lies within an eccentricity, in degrees.
    #[must_use]
    pub fn area_within(&self, eccentricity: f64) -> f64 {
        // Polygons of n edges err by n⁻², which the second one removes.
        let rim = self.rim(eccentricity);
        let area = |n: usize| {
            let points = rim.iter().flat_map(|arc| (0..n).map(move |k| arc(k as f64 / n as f64)));
            twice_area(&points.collect::<Vec<_>>()) / 2.0
        };
        let (coarse, fine) = (area(400), area(800));
        fine + (fine - coarse) / 3.0
    }

    /// The image of the hemifield's rim as a polygon of so many vertices (6 at least), counter-clockwise in millimetres
    /// from the fovea, all edges equally close to the curve.
    #[must_use]
    pub fn outline(&self, vertices: usize) -> Vec<Complex64> {
        let [below, around, above] = self.rim(self.extent);
        polygon(&[&below, &around, &above], vertices.max(6))
    }

    /// The landmark by which the outline's conformal map is this model, but for its scale of eccentricity: its half disk,
    /// scaled so that its corners go to the outline's, has `field` (a field coordinate, strictly inside the half disk) at
    /// the model's place. For a model that is not conformal, its direction there is that of the horizontal step.
    ///
    /// ```
    /// use conformal_warp::{CorticalModel, FieldPoint};
    /// let dipole = CorticalModel::POLIMENI_2006;
    /// let spot = dipole.landmark(FieldPoint::BLIND_SPOT.coordinate());
    /// assert!(spot.cortex.re > 30.0 && spot.cortex.im < 0.0); // millimetres from the fovea, below the horizontal meridian
    /// ```
    #[must_use]
    pub fn landmark(&self, field: Complex64) -> Landmark {
        let jet = self.forward(self.extent * field);
        Landmark { field, cortex: jet.value, direction: (jet.dz + jet.dzbar).arg() }
    }

    /// The images of the lower vertical meridian, the periphery and the upper vertical meridian, from the fovea and back.
    fn rim(&self, eccentricity: f64) -> [Box<dyn Fn(f64) -> Complex64 + '_>; 3] {
        // Even steps of log(E + a), which is how the cortex counts.
        let steps = (1.0 + eccentricity / self.a).ln();
        let meridian = move |t: f64| (self.a * (steps * t).exp_m1()).min(eccentricity);
        let image = |z: Complex64| self.forward(z).value;
        [
            Box::new(move |t| image(Complex64::new(0.0, -meridian(t)))),
            Box::new(move |t| image(Complex64::from_polar(eccentricity, FRAC_PI_2 * (2.0 * t - 1.0)))),
            Box::new(move |t| image(Complex64::new(0.0, meridian(1.0 - t)))),
        ]
    }

    fn forward(&self, z: Complex64) -> Jet {
        let wedge = self.wedge(z, self.shear);
        let v = wedge.value;
        let value = self.k * ((v + self.a).ln() - self.a.ln() - self.far(v).ln());
        Jet::analytic(value, self.slope(v)).after(&wedge)
    }

    /// (v + b)/b, which is 1 for a monopole.
    fn far(&self, v: Complex64) -> Complex64 {
        1.0 + v / self.b
    }

    /// dw/dv = k/(v + a) − k/(v + b), as one fraction: the terms cancel far out.
    fn slope(&self, v: Complex64) -> Complex64 {
        self.k * (1.0 - self.a / self.b) / ((v + self.a) * self.far(v))
    }

    /// E·e^{iθ} → E·e^{iαθ}.
    fn wedge(&self, z: Complex64, shear: f64) -> Jet {
        if shear == 1.0 {
            return Jet::analytic(z, Complex64::ONE);
        }
        let angle = z.arg();
        let turned = Complex64::cis((shear - 1.0) * angle);
        let dz = turned * (0.5 * (1.0 + shear));
        let dzbar = turned * Complex64::cis(2.0 * angle) * (0.5 * (1.0 - shear));
        Jet { value: z * turned, dz, dzbar }
    }

    fn backward(&self, w: Complex64) -> Jet {
        // e^{w/k} = (v + a)b / ((v + b)a)
        let u = (w / self.k).exp();
        let v = self.a * (u - 1.0) / (1.0 - u * (self.a / self.b));
        // A sheared angle may leave the half circle, where the wedge has no inverse.
        let beyond = || v.arg().abs() / self.shear > std::f64::consts::PI;
        if !v.is_finite() || (self.shear < 1.0 && beyond()) {
            return Jet::UNDEFINED;
        }
        self.wedge(v, 1.0 / self.shear).after(&Jet::analytic(v, self.slope(v).inv()))
    }

    /// Whether the hemifield has that point, its rim included.
    fn contains(&self, z: Complex64) -> bool {
        z.re >= -1e-9 * self.extent && z.norm() <= (1.0 + 1e-9) * self.extent
    }
}

impl PlaneMap for CorticalModel {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |z| self.contains(z).then(|| self.forward(z)));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for CorticalModel {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |w| {
            // Beyond half a turn the exponential has come round again.
            let first_sheet = (w.im / self.k).abs() <= std::f64::consts::PI;
            let there = self.backward(w);
            (first_sheet && self.contains(there.value)).then_some(there)
        });
    }
}

/// Twice the area of a polygon, positive if it is counter-clockwise.
pub(super) fn twice_area(polygon: &[Complex64]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(a, b)| a.re * b.im - a.im * b.re).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn models() -> [CorticalModel; 4] {
        [
            CorticalModel::monopole(12.0, 0.8).unwrap(),
            CorticalModel::POLIMENI_2006,
            CorticalModel::SCHIRA_2010,
            CorticalModel::wedge_dipole(14.0, 0.7, 85.0, 0.9).unwrap(),
        ]
    }

    fn field() -> impl Iterator<Item = Complex64> {
        (0..200).map(|k| {
            let (radius, angle) = (0.02 * f64::from(k / 10 + 1).powf(2.8), f64::from(k % 10) / 4.6 - 1.0);
            Complex64::from_polar(radius.min(90.0), angle * FRAC_PI_2)
        })
    }

    #[test]
    fn areas_are_the_published_ones() {
        let dipole = CorticalModel::POLIMENI_2006;
        let whole = dipole.area_within(90.0);
        assert!((whole / 2253.0 - 1.0).abs() < 0.01, "{whole} mm²");
        let central = dipole.area_within(15.0) / whole;
        assert!((central / 0.70 - 1.0).abs() < 0.01, "{central} of it within 15°");
        // Macaque and human means of the areas measured, by k alone.
        for (area, k) in [(1343.0, 11.6), (2643.0, 16.25)] {
            let scaled = dipole.with_area(area).unwrap();
            assert!((scaled.parameters()[0] / k - 1.0).abs() < 0.01, "{:?}", scaled.parameters());
            assert!((scaled.area_within(90.0) / area - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn what_cannot_be_is_refused_for_its_own_reason() {
        let model = CorticalModel::POLIMENI_2006;
        for area in [-3.0, 0.0, f64::NAN, f64::INFINITY] {
            let refused = model.with_area(area).unwrap_err().to_string();
            assert!(refused.contains("area") && !refused.contains('k'), "{refused}");
        }
        for extent in [200.0, 180.1, -1.0, f64::NAN] {
            let refused = model.up_to(extent).unwrap_err().to_string();
            assert!(refused.contains("eccentricity") && refused.contains("180"), "{refused}");
        }
        assert!(model.up_to(180.0).is_ok());
    }

    #[test]
    fn the_outline_and_the_jacobian_enclose_the_same_area() {
        for model in models() {
            // ∫∫ det J r dr dθ by the midpoint rule, r + a evenly in its logarithm.
            let ([_, a, ..], n) = (model.parameters(), 400);
            let steps = (1.0 + 40.0 / a).ln() / f64::from(n);
            let mut sum = 0.0;
            for i in 0..n {
                let radius = a * (steps * (f64::from(i) + 0.5)).exp_m1();
                for j in 0..n {
                    let angle = std::f64::consts::PI * ((f64::from(j) + 0.5) / f64::from(n) - 0.5);
                    let jet = model.jet(Complex64::from_polar(radius, angle));
                    let determinant = jet.dz.norm_sqr() - jet.dzbar.norm_sqr();
                    sum += determinant * radius * (radius + a) * steps * std::f64::consts::PI / f64::from(n);
                }
            }
            let area = model.area_within(40.0);
            assert!((sum / area - 1.0).abs() < 1e-4, "{model:?}: {sum} and {area}");
        }
    }

    #[test]
    fn inverts_with_its_derivative() {
        for model in models() {
            for z in field() {
                let there = model.jet(z);
                let back = model.inverted().jet(there.value);
                assert!((back.value - z).norm() < 1e-12 * (1.0 + z.norm()), "{model:?} at {z}: {}", back.value);
                let product = back.after(&there);
                assert!((product.dz - 1.0).norm() + product.dzbar.norm() < 1e-12, "{model:?} at {z}: {product:?}");
            }
        }
    }

    #[test]
    fn derivatives_are_those_of_the_formula() {
        let dipole = CorticalModel::POLIMENI_2006;
        for z in field() {
            let expected = 15.0 / (z + 0.69) - 15.0 / (z + 80.0);
            assert!((dipole.jet(z).dz - expected).norm() < 1e-12 * expected.norm());
            let published = 15.0 * ((z + 0.69) / (z + 80.0)).ln() + 15.0 * (80f64 / 0.69).ln();
            assert!((dipole.jet(z).value - published).norm() < 1e-12 * 15.0);
        }
        assert!((dipole.magnification(10.0) - (15.0 / 10.69 - 15.0 / 90.0)).abs() < 1e-12);
    }

    /// Along a ray and along a ring of the field, where the formulas are written out: dw/dr = e^{iαθ}·dw/dv and
    /// dw/dθ = iαv·dw/dv with v = r·e^{iαθ}.
    #[test]
    fn every_model_has_its_own_derivatives_along_rays_and_rings() {
        for model in models() {
            let [k, a, b, shear] = model.parameters();
            for z in field() {
                let v = Complex64::from_polar(z.norm(), shear * z.arg());
                let slope = k / (v + a) - if b.is_finite() { k / (v + b) } else { Complex64::ZERO };
                let jet = model.jet(z);
                let ray = Complex64::cis(z.arg());
                let [along_ray, along_ring] =
                    [ray, Complex64::I * z].map(|step| jet.dz * step + jet.dzbar * step.conj());
                let error = (along_ray - Complex64::cis(shear * z.arg()) * slope).norm();
                assert!(error < 1e-12 * slope.norm(), "{model:?} at {z}: {error:e}");
                let error = (along_ring - Complex64::I * shear * v * slope).norm();
                assert!(error < 1e-12 * (z.norm() * slope).norm(), "{model:?} at {z}: {error:e}");
                let [across, along] = [jet.dzbar.norm(), jet.dz.norm()];
                assert_eq!(across > 1e-12 * along, shear != 1.0, "only the wedge is not conformal: {model:?} at {z}");
            }
        }
        // And the formula's differences follow them.
        let wedge = models()[3];
        let (r, theta) = (7.0, 0.8);
        let [ahead, behind] = [1e-5, -1e-5].map(|h| wedge.jet(Complex64::from_polar(r, theta + h)).value);
        let (z, jet) = (Complex64::from_polar(r, theta), wedge.jet(Complex64::from_polar(r, theta)));
        let predicted = jet.dz * (Complex64::I * z) + jet.dzbar * (Complex64::I * z).conj();
        assert!(((ahead - behind) / 2e-5 - predicted).norm() < 1e-8 * predicted.norm());
    }

    #[test]
    fn only_the_hemifield_is_defined() {
        let dipole = CorticalModel::SCHIRA_2010;
        for z in [Complex64::new(-0.1, 3.0), Complex64::new(91.0, 0.0), Complex64::new(f64::NAN, 0.0)] {
            assert!(dipole.jet(z).value.is_nan(), "{z}");
        }
        let far = dipole.jet(Complex64::new(90.0, 0.0)).value;
        assert!(dipole.inverted().jet(far + 0.1).value.is_nan() && !dipole.inverted().jet(far - 0.1).value.is_nan());
        assert!(dipole.inverted().jet(Complex64::new(1.0, 2.0 * 18.0 * std::f64::consts::PI)).value.is_nan());
        for bad in [
            CorticalModel::dipole(15.0, 80.0, 0.69),
            CorticalModel::monopole(0.0, 1.0),
            CorticalModel::wedge_dipole(15.0, 0.7, 80.0, 2.5),
            CorticalModel::POLIMENI_2006.up_to(f64::NAN),
        ] {
            assert_eq!(bad.unwrap_err().code(), "invalid-map");
        }
    }
}
