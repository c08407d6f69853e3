//! Möbius maps z → (az + b)/(cz + d).

use super::inverse::{Inverse, InvertibleMap};
use super::jet::Jet;
use super::plane_map::{PlaneMap, pointwise};
use crate::plane::Complex64;
use crate::{Error, Result};

/// A Möbius map: sphere → sphere, one to one, circles to circles.
///
/// A point with an infinite part stands for ∞.
///
/// ```
/// use conformal_warp::{Complex64, Moebius};
/// let cayley = Moebius::cayley();
/// assert_eq!(cayley.apply(Complex64::I), Complex64::ZERO);
/// assert_eq!(cayley.inverse().apply(Complex64::ZERO), Complex64::I);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moebius {
    a: Complex64,
    b: Complex64,
    c: Complex64,
    d: Complex64,
}

/// A point for ∞.
const INFINITY: Complex64 = Complex64::new(f64::INFINITY, 0.0);

fn is_infinite(z: Complex64) -> bool {
    z.re.is_infinite() || z.im.is_infinite()
}

impl Moebius {
    /// z → z.
    pub const IDENTITY: Self = Self { a: Complex64::ONE, b: Complex64::ZERO, c: Complex64::ZERO, d: Complex64::ONE };

    /// z → (az + b)/(cz + d).
    ///
    /// # Errors
    /// [`Error::InvalidMap`] if a coefficient is not finite or ad = bc, which would make it constant.
    pub fn new(a: Complex64, b: Complex64, c: Complex64, d: Complex64) -> Result<Self> {
        let largest = [a, b, c, d].iter().map(|x| x.norm()).fold(0.0, f64::max);
        let invalid = |reason| Err(Error::InvalidMap { what: "A Möbius map", reason });
        if ![a, b, c, d].iter().all(|x| x.is_finite()) || !largest.is_finite() {
            return invalid("a coefficient is not a finite number");
        }
        if largest == 0.0 {
            return invalid("all coefficients are 0");
        }
        let map = Self { a: a / largest, b: b / largest, c: c / largest, d: d / largest };
        // Rounding leaves this much of a determinant that should be 0.
        if map.determinant().norm() <= 4.0 * f64::EPSILON * ((map.a * map.d).norm() + (map.b * map.c).norm()) {
            return invalid("ad − bc is 0, so every point would go to the same one");
        }
        Ok(map)
    }

    /// The map that takes `from[k]` to `to[k]`, k = 0, 1, 2; the points may include ∞.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] if two points of a triple coincide.
    pub fn from_points(from: [Complex64; 3], to: [Complex64; 3]) -> Result<Self> {
        Ok(Self::to_standard(to)?.inverse().after(&Self::to_standard(from)?))
    }

    /// The map that takes the three points to 0, 1, ∞: the cross-ratio.
    fn to_standard([p, q, r]: [Complex64; 3]) -> Result<Self> {
        let (one, zero) = (Complex64::ONE, Complex64::ZERO);
        match [p, q, r].map(is_infinite) {
            [false, false, false] => Self::new(q - r, p * (r - q), q - p, r * (p - q)),
            [true, false, false] => Self::new(zero, q - r, one, -r),
            [false, true, false] => Self::new(one, -p, one, -r),
            [false, false, true] => Self::new(one, -p, zero, q - p),
            _ => Err(Error::InvalidMap { what: "A Möbius map from three points", reason: "two of them are infinite" }),
        }
    }

    /// Unit disk → unit disk: `center` goes to 0 and the result is turned by `angle` radians.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless |center| < 1.
    pub fn disk_automorphism(center: Complex64, angle: f64) -> Result<Self> {
        if center.norm().is_nan() || center.norm() >= 1.0 {
            let reason = "the point that goes to 0 does not lie inside the disk";
            return Err(Error::InvalidMap { what: "An automorphism of the disk", reason });
        }
        let turn = Complex64::cis(angle);
        Self::new(turn, -turn * center, -center.conj(), Complex64::ONE)
    }

    /// Upper half plane → unit disk: `center` goes to 0 and the result is turned by `angle` radians.
    ///
    /// # Errors
    /// [`Error::InvalidMap`] unless Im center > 0.
    pub fn half_plane_to_disk(center: Complex64, angle: f64) -> Result<Self> {
        if center.im.is_nan() || center.im <= 0.0 {
            let reason = "the point that goes to 0 does not lie in the upper half plane";
            return Err(Error::InvalidMap { what: "A map of the half plane onto the disk", reason });
        }
        let turn = Complex64::cis(angle);
        Self::new(turn, -turn * center, Complex64::ONE, -center.conj())
    }

    /// Cayley's map (z − i)/(z + i): upper half plane → unit disk, i to 0, ∞ to 1.
    #[must_use]
    pub fn cayley() -> Self {
        Self { a: Complex64::ONE, b: -Complex64::I, c: Complex64::ONE, d: Complex64::I }
    }

    /// [a, b, c, d], up to a common factor.
    #[must_use]
    pub fn coefficients(&self) -> [Complex64; 4] {
        [self.a, self.b, self.c, self.d]
    }

    /// The inverse map, with the same coefficients: nothing is computed.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { a: self.d, b: -self.b, c: -self.c, d: self.a }
    }

    /// self ∘ first: z → self(first(z)), as one map.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        let product = Self {
            a: self.a * first.a + self.b * first.c,
            b: self.a * first.b + self.b * first.d,
            c: self.c * first.a + self.d * first.c,
            d: self.c * first.b + self.d * first.d,
        };
        let largest = product.coefficients().iter().map(|x| x.norm()).fold(0.0, f64::max);
        let [a, b, c, d] = product.coefficients().map(|x| x / largest);
        Self { a, b, c, d }
    }

    /// The image of a point; ∞ and the pole included.
    #[must_use]
    pub fn apply(&self, z: Complex64) -> Complex64 {
        if is_infinite(z) {
            return if self.c == Complex64::ZERO { INFINITY } else { self.a / self.c };
        }
        let denominator = self.c * z + self.d;
        if denominator == Complex64::ZERO { INFINITY } else { (self.a * z + self.b) / denominator }
    }

    /// The derivative (ad − bc)/(cz + d)² at a finite point.
    #[must_use]
    pub fn derivative(&self, z: Complex64) -> Complex64 {
        let denominator = self.c * z + self.d;
        self.determinant() / denominator / denominator
    }

    fn determinant(&self) -> Complex64 {
        self.a * self.d - self.b * self.c
    }
}

impl PlaneMap for Moebius {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |z| {
            let value = self.apply(z);
            value.is_finite().then(|| Jet::analytic(value, self.derivative(z)))
        });
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for Moebius {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.inverse().jets(points, jets);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn c(re: f64, im: f64) -> Complex64 {
        Complex64::new(re, im)
    }

    #[track_caller]
    fn assert_close(a: Complex64, b: Complex64) {
        assert!((a - b).norm() <= 1e-14 * (1.0 + b.norm()), "{a} is not {b}");
    }

    #[test]
    fn three_points_go_where_they_should() {
        let from = [c(1.0, 2.0), c(-3.0, 0.5), c(0.0, -1.0)];
        let to = [c(0.2, 0.0), c(4.0, 4.0), c(-1.0, 7.0)];
        for (from, to) in [
            (from, to),
            ([INFINITY, from[1], from[2]], to),
            ([from[0], INFINITY, from[2]], to),
            ([from[0], from[1], INFINITY], [to[0], INFINITY, to[2]]),
        ] {
            let map = Moebius::from_points(from, to).unwrap();
            for (p, q) in from.into_iter().zip(to) {
                if is_infinite(q) {
                    assert!(map.apply(p).norm() > 1e14, "{p} goes to {}", map.apply(p));
                } else {
                    assert_close(map.apply(p), q);
                    assert!(is_infinite(p) || (map.inverse().apply(q) - p).norm() < 1e-13);
                }
            }
        }
    }

    #[test]
    fn degenerate_maps_are_refused() {
        let one = Complex64::ONE;
        for bad in [
            Moebius::new(one, one * 2.0, one * 0.1, one * 0.2),
            Moebius::new(one, one, c(f64::NAN, 0.0), one),
            Moebius::new(Complex64::ZERO, Complex64::ZERO, Complex64::ZERO, Complex64::ZERO),
            Moebius::from_points([one, one, Complex64::ZERO], [one, Complex64::I, Complex64::ZERO]),
            Moebius::from_points([INFINITY, one, INFINITY], [one, Complex64::I, Complex64::ZERO]),
            Moebius::disk_automorphism(one, 0.0),
            Moebius::half_plane_to_disk(-Complex64::I, 0.0),
        ] {
            assert_eq!(bad.unwrap_err().code(), "invalid-map");
        }
    }

    #[test]
    fn automorphisms_keep_the_circle_and_cayley_the_line() {
        let turn = Moebius::disk_automorphism(c(0.3, -0.6), 1.2).unwrap();
        assert_close(turn.apply(c(0.3, -0.6)), Complex64::ZERO);
        for k in 0..7 {
            let angle = 0.9 * f64::from(k);
            assert!((turn.apply(Complex64::cis(angle)).norm() - 1.0).abs() < 1e-14);
            assert!((Moebius::cayley().apply(c(3.0 * angle, 0.0)).norm() - 1.0).abs() < 1e-14);
        }
        let centred = Moebius::half_plane_to_disk(c(2.0, 0.5), 0.0).unwrap();
        assert_eq!(centred.apply(c(2.0, 0.5)), Complex64::ZERO);
        assert_eq!(Moebius::half_plane_to_disk(Complex64::I, 0.0).unwrap(), Moebius::cayley());
    }

    #[test]
    fn products_and_derivatives_agree_with_composition() {
        let f = Moebius::new(c(1.0, 2.0), c(0.0, 1.0), c(0.5, -1.0), c(3.0, 0.0)).unwrap();
        let g = Moebius::disk_automorphism(c(0.1, 0.2), 0.7).unwrap();
        let z = c(0.4, -0.3);
        assert_close(f.after(&g).apply(z), f.apply(g.apply(z)));
        assert_close(f.after(&g).derivative(z), f.derivative(g.apply(z)) * g.derivative(z));
        assert_close(f.inverse().after(&f).apply(z), z);
        let mut jets = [Jet::UNDEFINED; 2];
        let pole = f.inverse().apply(INFINITY);
        Moebius::cayley().jets(&[z, -Complex64::I], &mut jets);
        assert_close(jets[0].dz, 2.0 * Complex64::I / ((z + Complex64::I) * (z + Complex64::I)));
        assert!(jets[1].value.is_nan() && f.apply(pole).norm() > 1e14);
    }
}
