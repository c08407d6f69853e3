//! Regions with holes, and the outside of bodies.

use super::contour::{Contour, Curve};
use super::lie::Lie;
use super::region::Region;
use super::{BoundaryPoint, Complex64, Edge, Polygon};
use crate::{Error, Result};

/// A region with any number of holes, or the unbounded outside of one or more bodies. Validated once here, trusted afterwards.
///
/// Its components are the outer boundary, if there is one, and then the holes.
///
/// ```
/// use conformal_warp::{Complex64, Curve, Domain};
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(x, y)| Complex64::new(x, y));
/// let frame = Domain::new(&square(1.0), &[square(0.5).to_vec()], Curve::Polygon)?;
/// assert!(frame.contains(Complex64::new(0.7, 0.0)));
/// assert!(!frame.contains(Complex64::new(0.2, 0.0)));
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    contours: Vec<Contour>,
    bounded: bool,
    center: Option<Complex64>,
    toward: Option<Complex64>,
}

/// A point of a boundary with several components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DomainPoint {
    /// The component.
    pub component: usize,
    /// The point of it, its edges being counted counter-clockwise.
    pub place: BoundaryPoint,
}

impl Domain {
    /// What lies inside `boundary` and outside every hole, each given in either orientation.
    ///
    /// # Errors
    /// Those of [`Region::new`] for the boundary, and in [`Error::InHole`] for holes; [`Error::HolesMeet`] and [`Error::HoleOutside`].
    pub fn new(boundary: &[Complex64], holes: &[Vec<Complex64>], curve: Curve) -> Result<Self> {
        Self::of(Some(Contour::new(boundary, curve)?), holes.iter().map(|points| Contour::new(points, curve)).collect())
    }

    /// The same of closed chains of edges, lines and curves as they were drawn.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Domain, Edge};
    /// use std::f64::consts::TAU;
    /// let circle = |radius: f64| [Edge::circular(Complex64::ZERO, radius, 0.0, TAU)];
    /// let ring = Domain::from_edges(&circle(2.0), &[circle(1.0).to_vec()])?;
    /// assert!(ring.contains(Complex64::from_polar(1.0 + 1e-14, 1.0)));
    /// assert!(!ring.contains(Complex64::from_polar(1.0 - 1e-14, 1.0)));
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Region::from_edges`] for the boundary, and in [`Error::InHole`] for holes; [`Error::HolesMeet`] and
    /// [`Error::HoleOutside`].
    pub fn from_edges(boundary: &[Edge], holes: &[Vec<Edge>]) -> Result<Self> {
        let holes = holes.iter().map(|edges| Contour::from_edges(edges)).collect();
        Ok(Self::of(Some(Contour::from_edges(boundary)?), holes)?.straightened())
    }

    /// What lies outside every one of some bodies.
    ///
    /// # Errors
    /// As [`Domain::new`]; [`Error::WrongRegion`] without a body.
    pub fn exterior(bodies: &[Vec<Complex64>], curve: Curve) -> Result<Self> {
        Self::of(None, bodies.iter().map(|points| Contour::new(points, curve)).collect())
    }

    /// The same of closed chains of edges.
    ///
    /// # Errors
    /// As [`Domain::from_edges`]; [`Error::WrongRegion`] without a body.
    pub fn exterior_of_edges(bodies: &[Vec<Edge>]) -> Result<Self> {
        let bodies = bodies.iter().map(|edges| Contour::from_edges(edges)).collect();
        Ok(Self::of(None, bodies)?.straightened())
    }

    fn of(outer: Option<Contour>, holes: Vec<Result<Contour>>) -> Result<Self> {
        let bounded = outer.is_some();
        if !bounded && holes.is_empty() {
            let found = "none".to_string();
            return Err(Error::WrongRegion { what: "The outside of bodies", needed: "at least one body", found });
        }
        let mut contours: Vec<Contour> = outer.into_iter().collect();
        for (hole, contour) in holes.into_iter().enumerate() {
            let named = |error| Error::InHole { hole, error: Box::new(error) };
            contours.push(contour.map_err(named)?);
        }
        let domain = Self { contours, bounded, center: None, toward: None };
        domain.check()?;
        Ok(domain)
    }

    /// The same domain bounded by polygons, if all of its edges are straight: these are faster.
    fn straightened(self) -> Self {
        let straight: Option<Vec<Contour>> = self.contours.iter().map(Contour::straightened).collect();
        match straight {
            Some(contours) => Self { contours, ..self },
            None => self,
        }
    }

    /// Holes must not meet anything, and lie where holes can be.
    #[inline(never)]
    fn check(&self) -> Result<()> {
        let hole = |component: usize| if self.bounded { component.checked_sub(1) } else { Some(component) };
        for second in 0..self.contours.len() {
            for first in second + 1..self.contours.len() {
                let [one, other] = [first, second].map(|k| self.contours[k].outline());
                if let Some((_, _, at)) = one.meets(other) {
                    return Err(Error::HolesMeet { first: hole(first), second: hole(second), at });
                }
                let (starts_in, holds) = (other.contains(one.vertices()[0]), one.contains(other.vertices()[0]));
                match (hole(first), hole(second)) {
                    (Some(hole), None) if !starts_in => return Err(Error::HoleOutside { hole, inside: None }),
                    (Some(hole), Some(inside)) if starts_in => {
                        return Err(Error::HoleOutside { hole, inside: Some(inside) });
                    }
                    (Some(inside), Some(hole)) if holds => {
                        return Err(Error::HoleOutside { hole, inside: Some(inside) });
                    }
                    _ => {}
                }
            }
        }
        Ok(())
    }

    /// The same domain with a point inside that maps take to 0, or to infinity.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::CenterOutside`].
    pub fn with_center(mut self, center: Complex64) -> Result<Self> {
        if !center.is_finite() {
            return Err(Error::NotFinite { what: "The center".to_string() });
        }
        if !self.contains_strictly(center) {
            return Err(Error::CenterOutside { center });
        }
        self.center = Some(center);
        Ok(self)
    }

    /// The same domain with a point of the boundary that gives maps their direction; the nearest point of the first component
    /// is taken.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn with_toward(mut self, toward: Complex64) -> Result<Self> {
        if !toward.is_finite() {
            return Err(Error::NotFinite { what: "The point toward".to_string() });
        }
        self.toward = Some(self.contours[0].nearest(toward).point);
        Ok(self)
    }

    /// Whether it has an outer boundary.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.bounded
    }

    /// The boundary points of the outer boundary, counter-clockwise; none if it is unbounded.
    #[must_use]
    pub fn boundary(&self) -> Option<&[Complex64]> {
        self.bounded.then(|| self.contours[0].polygon().vertices())
    }

    /// The boundary points of every hole, counter-clockwise.
    #[must_use]
    pub fn holes(&self) -> Vec<&[Complex64]> {
        self.contours[usize::from(self.bounded)..].iter().map(|hole| hole.polygon().vertices()).collect()
    }

    /// How the boundary points are joined.
    #[must_use]
    pub fn curve(&self) -> Curve {
        self.contours[0].curve()
    }

    /// The point inside that was given.
    #[must_use]
    pub fn center(&self) -> Option<Complex64> {
        self.center
    }

    /// The boundary point that was given.
    #[must_use]
    pub fn toward(&self) -> Option<Complex64> {
        self.toward
    }

    /// Whether `z` lies in the closed domain, to which belongs what is on the boundary up to rounding. False for NaN.
    #[must_use]
    pub fn contains(&self, z: Complex64) -> bool {
        let holes = &self.contours[usize::from(self.bounded)..];
        z.is_finite() && (!self.bounded || self.contours[0].contains(z)) && !holes.iter().any(|hole| hole.encloses(z))
    }

    fn contains_strictly(&self, z: Complex64) -> bool {
        let holes = &self.contours[usize::from(self.bounded)..];
        (!self.bounded || self.contours[0].contains_strictly(z)) && !holes.iter().any(|hole| hole.contains(z))
    }

    /// The outer boundary, if there is one, and the holes.
    pub(crate) fn contours(&self) -> &[Contour] {
        &self.contours
    }

    /// The point of the boundary that `z` is, up to rounding.
    pub(crate) fn on_boundary(&self, z: Complex64) -> Option<DomainPoint> {
        let on = |(component, contour): (usize, &Contour)| Some(DomainPoint { component, place: contour.on_curve(z)? });
        self.contours.iter().enumerate().find_map(on)
    }

    /// What [`Domain::on_boundary`] and [`Domain::contains`] say, in one look: `None` outside, and inside the point of the boundary
    /// that `z` is, if it is one.
    pub(crate) fn lie(&self, z: Complex64) -> Option<Option<DomainPoint>> {
        let mut is_inside = z.is_finite();
        for (component, contour) in self.contours.iter().enumerate() {
            match contour.lie(z) {
                Lie::On(place) => return Some(Some(DomainPoint { component, place })),
                Lie::Inside => is_inside &= self.bounded && component == 0,
                Lie::Outside => is_inside &= !(self.bounded && component == 0),
            }
        }
        is_inside.then_some(None)
    }

    /// The point of the boundary nearest to `z`.
    pub(crate) fn nearest(&self, z: Complex64) -> DomainPoint {
        let places = self.contours.iter().map(|contour| contour.nearest(z));
        let points = places.enumerate().map(|(component, place)| DomainPoint { component, place });
        let distance = |point: &DomainPoint| (point.place.point - z).norm_sqr();
        points
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(DomainPoint { component: 0, place: BoundaryPoint { edge: 0, t: 0.0, point: z } })
    }

    /// The place on a component where so many of its edges, counter-clockwise and around as often as that takes, lie behind.
    pub(crate) fn place_along(&self, component: usize, edges: f64) -> DomainPoint {
        let count = self.contours[component].edge_count();
        let place = edges.rem_euclid(count as f64);
        let edge = (place as usize).min(count - 1);
        DomainPoint { component, place: BoundaryPoint { edge, t: place - edge as f64, point: Complex64::ZERO } }
    }

    /// The point there.
    pub(crate) fn point_along(&self, component: usize, edges: f64) -> Complex64 {
        self.contours[component].point(self.place_along(component, edges).place)
    }

    /// The polygons of its components, the region to the left of each.
    pub(crate) fn oriented_polygons(&self) -> Vec<Polygon> {
        let outer = |k: usize| self.bounded && k == 0;
        let polygon = |(k, contour): (usize, &Contour)| {
            if outer(k) { contour.polygon().clone() } else { contour.polygon().clockwise() }
        };
        self.contours.iter().enumerate().map(polygon).collect()
    }

    /// What coordinates should be given relative to, so that a domain far from 0 keeps its digits; and the domain there.
    pub(crate) fn local(&self) -> (Complex64, Self) {
        let points: Vec<Complex64> =
            self.contours.iter().flat_map(|contour| contour.polygon().vertices()).copied().collect();
        let origin = super::polygon::origin_of(&points);
        let moved = |z: Option<Complex64>| z.map(|z| z - origin);
        let contours = self.contours.iter().map(|contour| contour.moved(-origin)).collect();
        let local = Self { contours, bounded: self.bounded, center: moved(self.center), toward: moved(self.toward) };
        (origin, local)
    }
}

/// A region without holes.
impl From<&Region> for Domain {
    fn from(region: &Region) -> Self {
        Self {
            contours: vec![region.contour().clone()],
            bounded: true,
            center: Some(region.center()),
            toward: Some(region.toward().point),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, half: f64) -> Vec<Complex64> {
        [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(a, b)| Complex64::new(x + a, y + b)).to_vec()
    }

    fn domain(holes: &[Vec<Complex64>]) -> Result<Domain> {
        Domain::new(&square(0.0, 0.0, 2.0), holes, Curve::Polygon)
    }

    #[test]
    fn holes_that_meet_something_are_named() {
        let meet = |first, second| move |error| matches!(error, Error::HolesMeet { first: f, second: s, .. } if f == first && s == second);
        let small = square(0.0, 0.0, 0.5);
        assert!(meet(Some(1), None)(domain(&[small.clone(), square(1.5, 0.0, 1.0)]).unwrap_err()));
        assert!(meet(Some(0), None)(domain(&[square(1.0, 0.0, 1.0)]).unwrap_err()), "touches from within");
        assert!(meet(Some(1), Some(0))(domain(&[small.clone(), square(1.0, 0.0, 0.5)]).unwrap_err()), "touch");
        assert_eq!(domain(&[square(5.0, 0.0, 1.0)]).unwrap_err(), Error::HoleOutside { hole: 0, inside: None });
        assert_eq!(domain(&[square(0.0, 0.0, 3.0)]).unwrap_err(), Error::HoleOutside { hole: 0, inside: None });
        for holes in [[square(0.0, 0.0, 1.0), small.clone()], [small.clone(), square(0.0, 0.0, 1.0)]] {
            let inner = if holes[0] == small { 0 } else { 1 };
            assert_eq!(domain(&holes).unwrap_err(), Error::HoleOutside { hole: inner, inside: Some(1 - inner) });
        }
        let text = domain(&[square(5.0, 0.0, 1.0)]).unwrap_err().to_string();
        assert!(text.starts_with("Hole 0 (counted from 0) lies outside the boundary"), "{text}");
    }

    #[test]
    fn what_is_wrong_with_a_hole_names_it() {
        let mut lost = square(-1.0, 0.0, 0.5);
        lost[2].im = f64::NAN;
        let bow = [0, 2, 1, 3].map(|k| square(-1.0, 0.0, 0.5)[k]).to_vec();
        for (wrong, code, words) in [
            (lost, "not-finite", "Boundary point 2 is not a finite point."),
            (bow, "self-intersecting", "The boundary crosses"),
            (vec![Complex64::ZERO; 5], "too-few-vertices", "A region needs at least 3"),
        ] {
            let error = domain(&[square(1.0, 0.0, 0.5), wrong]).unwrap_err();
            assert_eq!(error.code(), code);
            assert!(error.to_string().starts_with(&format!("Hole 1 (counted from 0): {words}")), "{error}");
        }
    }

    #[test]
    fn closed_domains_hold_their_boundary_and_not_their_holes() {
        for curve in [Curve::Polygon, Curve::Smooth] {
            let circle = |radius: f64| {
                (0..40).map(|j| Complex64::from_polar(radius, std::f64::consts::TAU * f64::from(j) / 40.0)).collect()
            };
            let outer: Vec<Complex64> = circle(2.0);
            let ring = Domain::new(&outer, &[circle(1.0)], curve).unwrap();
            for (z, inside) in [(1.5, true), (1.0, true), (2.0, true), (0.9, false), (0.0, false), (2.1, false)] {
                assert_eq!(ring.contains(Complex64::new(z, 0.0)), inside, "{z} {curve:?}");
            }
            let outside = Domain::exterior(&[circle(1.0)], curve).unwrap();
            assert!(outside.contains(Complex64::new(1e9, 0.0)) && !outside.contains(Complex64::new(0.5, 0.0)));
            assert!(!ring.contains(Complex64::new(f64::NAN, 0.0)) && !outside.contains(Complex64::new(0.0, f64::NAN)));
            assert_eq!(ring.clone().with_center(Complex64::ZERO).unwrap_err().code(), "center-outside");
            assert!(ring.with_center(Complex64::new(1.5, 0.0)).is_ok());
        }
    }
}
