//! A test double: star-shaped regions, mapped to the disk along rays. Not conformal, but one-to-one and exact.

use super::correspondence::Correspondence;
use super::side::{Side, UnitDisk};
use crate::plane::{BoundaryPoint, Complex64, Contour, Curve};
use std::f64::consts::TAU;

/// A polygon whose boundary every ray from `center` meets once.
pub(crate) struct Star {
    contour: Contour,
    center: Complex64,
    toward: BoundaryPoint,
}

impl Star {
    pub(crate) fn new(corners: &[Complex64], center: Complex64, toward: Complex64) -> Self {
        let contour = Contour::new(corners, Curve::Polygon).unwrap();
        let toward = contour.nearest(toward);
        Self { contour, center, toward }
    }

    fn turn(&self) -> f64 {
        (self.toward.point - self.center).arg()
    }
}

impl Side for Star {
    fn contour(&self) -> Option<&Contour> {
        Some(&self.contour)
    }

    fn center(&self) -> Complex64 {
        self.center
    }

    fn toward(&self) -> BoundaryPoint {
        self.toward
    }

    fn angle(&self, point: BoundaryPoint) -> f64 {
        let angle = ((point.point - self.center).arg() - self.turn()).rem_euclid(TAU);
        if angle >= TAU { 0.0 } else { angle }
    }

    fn at_angle(&self, angle: f64) -> BoundaryPoint {
        let ray = Complex64::cis(angle + self.turn());
        let cross = |u: Complex64, v: Complex64| u.re * v.im - u.im * v.re;
        let hit = |edge: usize| {
            let (a, b) = self.contour.polygon().edge(edge);
            let (p, q) = (cross(ray, a - self.center), cross(ray, b - self.center));
            let t = (p / (p - q)).clamp(0.0, 1.0 - f64::EPSILON);
            let point = a + (b - a) * t;
            let ahead = ((point - self.center) * ray.conj()).re > 0.0;
            (p <= 0.0 && q > 0.0 && ahead).then_some(BoundaryPoint { edge, t, point })
        };
        (0..self.contour.polygon().len()).find_map(hit).unwrap()
    }

    fn error(&self) -> f64 {
        1e-13
    }
}

impl Star {
    fn to_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        let turn = Complex64::cis(-self.turn());
        let ratio = |z: Complex64| {
            let d = z - self.center;
            let wall = self.at_angle(d.arg() - self.turn()).point - self.center;
            d * turn / wall.norm()
        };
        points.iter().map(|&z| if z == self.center { Complex64::ZERO } else { ratio(z) }).collect()
    }

    fn to_region(&self, points: &[Complex64]) -> Vec<Complex64> {
        let reach = |w: Complex64| self.center + (self.at_angle(w.arg()).point - self.center) * w.norm();
        points.iter().map(|&w| reach(w)).collect()
    }
}

/// The two maps of stars, one after the other.
pub(super) struct Stars<'a>(pub(super) &'a Star, pub(super) &'a Star);

impl Correspondence for Stars<'_> {
    fn copies(&self) -> [&dyn Side; 2] {
        [self.0, self.1]
    }

    fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.1.to_region(&self.0.to_disk(points))
    }

    fn backward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.to_region(&self.1.to_disk(points))
    }

    fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.1.at_angle(self.0.angle(point))
    }

    fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.0.at_angle(self.1.angle(point))
    }

    fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.to_region(points)
    }

    fn magnification(&self, source: &[Complex64], _: &[Complex64]) -> Vec<f64> {
        vec![f64::NAN; source.len()] // they stretch differently in every direction
    }
}

/// One of them onto the disk.
pub(super) struct StarOntoDisk<'a>(pub(super) &'a Star);

impl Correspondence for StarOntoDisk<'_> {
    fn copies(&self) -> [&dyn Side; 2] {
        [self.0, &UnitDisk]
    }

    fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.to_disk(points)
    }

    fn backward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.to_region(points)
    }

    fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
        UnitDisk.at_angle(self.0.angle(point))
    }

    fn boundary_backward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.0.at_angle(UnitDisk.angle(point))
    }

    fn undo_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.0.to_region(points)
    }

    fn magnification(&self, source: &[Complex64], _: &[Complex64]) -> Vec<f64> {
        vec![f64::NAN; source.len()]
    }
}
