//! An eye that looks at a picture: perspective and fixation.

use super::FieldPoint;
use crate::map::{Inverse, InvertibleMap, Jet, Moebius, PlaneMap, pointwise};
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};

/// Picture → visual field: the field coordinate s of what is seen at a point of a picture while another is fixated.
///
/// The picture was taken by a pinhole camera that looks at its middle. The eye turns from there to the fixation point by
/// the shortest rotation (Listing's law), which in stereographic coordinates is a Möbius map.
///
/// Perspective is not conformal away from the middle: |ds/dp| differs along and across by 1/cos E.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaze {
    middle: Complex64,
    /// Distance from eye to picture, in plane units.
    distance: f64,
    /// Camera's field coordinate → the turned eye's, and back.
    turn: Moebius,
    back: Moebius,
}

impl Gaze {
    /// A picture in its `frame` that spans `field_of_view` degrees from its left edge to its right one, seen while the eye
    /// looks at the point `fixation` of the plane.
    ///
    /// ```
    /// use conformal_warp::{Complex64, FieldPoint, Frame, Gaze};
    /// let picture = Frame::new(Complex64::new(0.0, 0.0), 2.0, [640, 480])?;
    /// let gaze = Gaze::new(&picture, 60.0, Complex64::new(0.0, 0.0))?;
    /// let edge = gaze.direction(Complex64::new(1.0, 0.0));
    /// assert!((edge.eccentricity - 30.0).abs() < 1e-12);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidOption`] unless 0 < `field_of_view` < 180; [`Error::NotFinite`] for the fixation point.
    pub fn new(frame: &Frame, field_of_view: f64, fixation: Complex64) -> Result<Self> {
        if field_of_view.is_nan() || field_of_view <= 0.0 || field_of_view >= 180.0 {
            let expected = "more than 0 and less than 180 degrees";
            return Err(Error::InvalidOption { name: "field_of_view", expected, value: field_of_view });
        }
        if !fixation.is_finite() {
            return Err(Error::NotFinite { what: "The fixation point".into() });
        }
        let middle = frame.center();
        let distance = 0.5 * frame.width() / (0.5 * field_of_view.to_radians()).tan();
        let ahead = stereographic((fixation - middle) / distance).value;
        let turn = Moebius::new(Complex64::ONE, -ahead, ahead.conj(), Complex64::ONE)?;
        Ok(Self { middle, distance, turn, back: turn.inverse() })
    }

    /// The direction in which a point of the picture is seen.
    #[must_use]
    pub fn direction(&self, point: Complex64) -> FieldPoint {
        FieldPoint::from_coordinate(self.to_field(point).value)
    }

    fn to_field(self, point: Complex64) -> Jet {
        let q = (point - self.middle) / self.distance;
        let s = stereographic(q);
        let turned = Jet::analytic(self.turn.apply(s.value), self.turn.derivative(s.value));
        let scaled = Jet { dz: s.dz / self.distance, dzbar: s.dzbar / self.distance, ..s };
        turned.after(&scaled)
    }

    /// What lies beside or behind the camera is not in the picture's plane.
    fn to_picture(self, s: Complex64) -> Option<Jet> {
        let seen = self.back.apply(s);
        if seen.is_nan() || seen.norm_sqr() >= 1.0 {
            return None;
        }
        let q = gnomonic(seen);
        let scale = self.distance;
        let plane = Jet { value: self.middle + q.value * scale, dz: q.dz * scale, dzbar: q.dzbar * scale };
        Some(plane.after(&Jet::analytic(seen, self.back.derivative(s))))
    }
}

/// tan E·e^{iθ} → tan(E/2)·e^{iθ}.
fn stereographic(q: Complex64) -> Jet {
    let h = 1f64.hypot(q.norm());
    let value = q / (1.0 + h);
    Jet { value, dz: (0.5 / h).into(), dzbar: -value * value * (0.5 / h) }
}

/// tan(E/2)·e^{iθ} → tan E·e^{iθ}, E < 90°.
fn gnomonic(s: Complex64) -> Jet {
    let gap = 1.0 - s.norm_sqr();
    let scale = 2.0 / (gap * gap);
    Jet { value: 2.0 * s / gap, dz: scale.into(), dzbar: s * s * scale }
}

impl PlaneMap for Gaze {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |point| point.is_finite().then(|| self.to_field(point)));
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for Gaze {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        pointwise(points, jets, |s| self.to_picture(s));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_4;

    fn gaze(fixation: Complex64) -> Gaze {
        let frame = Frame::new(Complex64::new(3.0, 1.0), 4.0, [400, 300]).unwrap();
        Gaze::new(&frame, 80.0, fixation).unwrap()
    }

    /// The angle between two points of the picture, by vectors.
    fn angle(gaze: &Gaze, a: Complex64, b: Complex64) -> f64 {
        let ray = |p: Complex64| [p.re - 3.0, p.im - 1.0, gaze.distance];
        let (a, b) = (ray(a), ray(b));
        let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        (dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()).acos().to_degrees()
    }

    #[test]
    fn eccentricity_is_the_angle_from_the_fixation_point() {
        for fixation in [(3.0, 1.0), (4.5, 0.2), (1.0, 2.5)].map(|(x, y)| Complex64::new(x, y)) {
            let gaze = gaze(fixation);
            assert!(gaze.to_field(fixation).value.norm() < 1e-15);
            for point in [(3.0, 1.0), (1.1, 0.0), (4.9, 2.4), (3.0, -0.4)].map(|(x, y)| Complex64::new(x, y)) {
                let expected = angle(&gaze, fixation, point);
                let seen = gaze.direction(point).eccentricity;
                assert!((seen - expected).abs() < 1e-6, "{point} from {fixation}: {seen} is not {expected}");
            }
        }
    }

    #[test]
    fn the_turn_keeps_the_direction_towards_the_middle() {
        // Listing's law: no torsion about the line through the middle and the fixation point.
        let fixation = Complex64::new(3.0, 1.0) + Complex64::from_polar(1.2, FRAC_PI_4);
        let seen = gaze(fixation).direction(Complex64::new(3.0, 1.0));
        assert!((seen.azimuth - (-135.0)).abs() < 1e-10, "{seen:?}");
    }

    #[test]
    fn inverts_with_its_jacobian() {
        let gaze = gaze(Complex64::new(4.0, 0.3));
        for point in [(3.0, 1.0), (4.0, 0.3), (1.1, 0.0), (4.9, 2.4)].map(|(x, y)| Complex64::new(x, y)) {
            let there = gaze.jet(point);
            let back = gaze.inverted().jet(there.value);
            assert!((back.value - point).norm() < 1e-13);
            let product = back.after(&there);
            assert!((product.dz - 1.0).norm() + product.dzbar.norm() < 1e-12, "{point}: {product:?}");
            let h = 1e-5;
            let [dx, dy] = [Complex64::new(h, 0.0), Complex64::new(0.0, h)]
                .map(|step| (gaze.jet(point + step).value - gaze.jet(point - step).value) / (2.0 * h));
            assert!((0.5 * (dx - Complex64::I * dy) - there.dz).norm() < 1e-9);
            assert!((0.5 * (dx + Complex64::I * dy) - there.dzbar).norm() < 1e-9);
        }
        assert!(gaze.inverted().jet(Complex64::new(-3.0, 0.0)).value.is_nan());
    }

    #[test]
    fn unusable_views_are_refused() {
        let frame = Frame::new(Complex64::ZERO, 4.0, [4, 3]).unwrap();
        for degrees in [0.0, 180.0, f64::NAN, -3.0] {
            assert_eq!(Gaze::new(&frame, degrees, Complex64::ZERO).unwrap_err().code(), "invalid-option");
        }
        assert_eq!(Gaze::new(&frame, 50.0, Complex64::new(f64::NAN, 0.0)).unwrap_err().code(), "not-finite");
    }
}
