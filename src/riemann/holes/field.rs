//! The analytic function that a problem gives, in plane units.

use super::super::atlas::accuracy::Accuracy;
use super::evaluator::{Evaluator, Found};
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Domain, DomainPoint};
use crate::symm::curved::field::CurvedField;
use crate::symm::field::Field;
use crate::symm::options::{Progress, unless_cancelled};
use crate::symm::smooth_field::SmoothField;
use std::sync::{Arc, OnceLock};

/// The function B of a problem on its closed domain.
#[derive(Clone, Debug)]
pub struct DomainField {
    domain: Arc<Domain>,
    origin: Complex64,
    unit: f64,
    kind: Kind,
    /// Made at its first use.
    evaluator: Arc<OnceLock<Evaluator>>,
    accuracy: Accuracy,
}

/// What it was solved on.
#[derive(Clone, Debug)]
pub enum Kind {
    /// Panels.
    Polygons(Field),
    /// Nodes of smooth curves.
    Smooth(SmoothField),
    /// Panels on curved edges.
    Curved(CurvedField),
}

impl DomainField {
    pub(super) fn new(domain: Arc<Domain>, origin: Complex64, unit: f64, kind: Kind, error_estimate: f64) -> Self {
        let accuracy = Accuracy::beside(error_estimate);
        Self { domain, origin, unit, kind, evaluator: Arc::default(), accuracy }
    }

    /// What its expansions are made for.
    #[must_use]
    pub fn accuracy(&self) -> Accuracy {
        self.accuracy
    }

    /// By how much values that are found in different ways differ from each other where edges are curved: within the error of the
    /// solve, but farther than rounding.
    #[must_use]
    pub fn coherence(&self) -> Option<f64> {
        matches!(self.kind, Kind::Curved(_)).then_some(self.accuracy.solve_error)
    }

    /// Makes now what [`DomainField::fast`] makes at its first use.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        if self.evaluator.get().is_none() {
            let built = unless_cancelled(progress, |progress| self.build(progress))?;
            // If another thread was first, its are the same.
            let _ = self.evaluator.set(built);
        }
        self.evaluator().fill(progress)
    }

    fn build(&self, progress: Progress) -> Evaluator {
        match &self.kind {
            Kind::Polygons(field) => {
                let thickness = self.domain.contours().iter().map(|contour| contour.thickness()).fold(0.0, f64::max);
                Evaluator::of_polygons(field, thickness * self.unit, self.accuracy, progress)
            }
            Kind::Smooth(field) => Evaluator::of_curves(field, &self.domain, (self.origin, self.unit)),
            Kind::Curved(field) => {
                Evaluator::of_edges(field, &self.domain, (self.origin, self.unit), self.accuracy.solve_error)
            }
        }
    }

    /// The domain.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// cⱼ = −Re B on each component.
    #[must_use]
    pub fn constants(&self) -> &[f64] {
        match &self.kind {
            Kind::Polygons(field) => &field.constants,
            Kind::Smooth(field) => &field.constants,
            Kind::Curved(field) => &field.constants,
        }
    }

    /// Where in the domain B is singular.
    #[must_use]
    pub fn singularities(&self) -> Vec<Complex64> {
        let source = match &self.kind {
            Kind::Polygons(field) => &field.source,
            Kind::Smooth(field) => &field.source,
            Kind::Curved(field) => &field.source,
        };
        source.singularities().into_iter().map(|a| a / self.unit + self.origin).collect()
    }

    /// (B, B') at a point; `None` outside the closed domain. B' is by plane units.
    #[must_use]
    pub fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        Some(match self.domain.lie(z)? {
            Some(point) => {
                let (value, slope) = self.on_boundary(point);
                (value + self.turn(point), slope)
            }
            None => self.directly(z),
        })
    }

    /// [`DomainField::at`] by power series where they serve: the same within the accuracy of the solve, but for the branch of B.
    #[inline]
    #[must_use]
    pub fn fast(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        if !z.is_finite() {
            return None;
        }
        match self.evaluator().at((z - self.origin) * self.unit) {
            Found::Known(value, slope) => Some((value, slope * self.unit)),
            Found::Outside => None,
            Found::Unknown => self.at(z),
        }
    }

    /// [`DomainField::fast`] on the branch of [`DomainField::at`].
    #[must_use]
    pub fn branched(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        if !z.is_finite() {
            return None;
        }
        let scaled = (z - self.origin) * self.unit;
        match self.evaluator().at(scaled) {
            Found::Known(value, slope) => Some((value + self.evaluator().branch(scaled), slope * self.unit)),
            Found::Outside => None,
            Found::Unknown => self.at(z),
        }
    }

    /// By how much that branch jumps on the straight way between two points: 0 unless it crosses a cut, which run to the left.
    #[must_use]
    pub fn jump(&self, from: Complex64, to: Complex64) -> Complex64 {
        let scaled = |z: Complex64| (z - self.origin) * self.unit;
        self.evaluator().jump(scaled(from), scaled(to))
    }

    #[inline]
    fn evaluator(&self) -> &Evaluator {
        self.evaluator.get_or_init(|| self.build(&mut |_, _| true))
    }

    /// (B, B') at a point inside.
    fn directly(&self, z: Complex64) -> (Complex64, Complex64) {
        let scaled = (z - self.origin) * self.unit;
        let (value, slope) = match &self.kind {
            Kind::Smooth(field) => field.at(scaled),
            Kind::Curved(field) => self.evaluator().beside(scaled).unwrap_or_else(|| field.at(scaled)),
            Kind::Polygons(field) => {
                let (edge, t) = self.oriented(self.domain.nearest(z));
                field.at(scaled, (edge, t))
            }
        };
        (value, slope * self.unit)
    }

    /// What Re B at a point of the boundary is on the branch of direct summation, less the one number that it is on the component.
    #[inline(never)]
    fn turn(&self, point: DomainPoint) -> f64 {
        match &self.kind {
            Kind::Smooth(field) => {
                let contour = &self.domain.contours()[point.component];
                field.turn(point.component, contour.smooth().map_or(f64::NAN, |curve| curve.parameter(point.place)))
            }
            Kind::Curved(field) => field.turn(point.component, point.place.edge, point.place.t),
            Kind::Polygons(field) => {
                let z = (self.domain.contours()[point.component].point(point.place) - self.origin) * self.unit;
                field.turn(self.oriented(point).0, z)
            }
        }
    }

    /// (B, B') at a point of the boundary, B continuous along its component.
    #[must_use]
    pub(crate) fn on_boundary(&self, point: DomainPoint) -> (Complex64, Complex64) {
        let (value, slope) = match &self.kind {
            Kind::Smooth(field) => {
                let contour = &self.domain.contours()[point.component];
                let t = contour.smooth().map_or(f64::NAN, |curve| curve.parameter(point.place));
                field.on_curve_with_slope(point.component, t)
            }
            Kind::Curved(field) => field.on_edge(point.component, point.place.edge, point.place.t),
            Kind::Polygons(field) => {
                let (edge, t) = self.oriented(point);
                field.on_edge(edge, t)
            }
        };
        (value, slope * self.unit)
    }

    /// The singular part of the density at a vertex of a component, or the density there if the curve is smooth, up to a factor
    /// that the boundary and another field, of which that is not 0, decide.
    #[must_use]
    #[inline(never)]
    pub fn strength(&self, other: &Self, component: usize, vertex: usize) -> f64 {
        let place = BoundaryPoint { edge: vertex, t: 0.0, point: Complex64::ZERO };
        match &self.kind {
            Kind::Smooth(field) => {
                let contour = &self.domain.contours()[component];
                field.density(component, contour.smooth().map_or(f64::NAN, |curve| curve.parameter(place)))
            }
            Kind::Curved(field) => {
                let Kind::Curved(other) = &other.kind else { return f64::NAN };
                field.strength(other, component, vertex)
            }
            Kind::Polygons(field) => {
                // The oriented edge that ends at the vertex, and the one after it.
                let (before, _) = self.oriented(DomainPoint { component, place });
                field.strength(if self.domain.is_bounded() && component == 0 { before } else { field.next(before) })
            }
        }
    }

    /// The edge of the oriented boundary, and the share of it before the point: holes run clockwise there.
    fn oriented(&self, point: DomainPoint) -> (usize, f64) {
        let contours = self.domain.contours();
        let start: usize = contours[..point.component].iter().map(|contour| contour.polygon().len()).sum();
        let place = point.place;
        if self.domain.is_bounded() && point.component == 0 {
            return (place.edge, place.t);
        }
        (start + contours[point.component].polygon().len() - 1 - place.edge, 1.0 - place.t)
    }
}
