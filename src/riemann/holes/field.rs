//! The analytic function that a problem gives, in plane units.

use super::cells::Cells;
use crate::plane::{BoundaryPoint, Complex64, Domain, DomainPoint};
use crate::symm::field::Field;
use crate::symm::smooth_field::SmoothField;
use std::sync::Arc;

/// The function B of a problem on its closed domain.
#[derive(Clone, Debug)]
pub struct DomainField {
    domain: Arc<Domain>,
    origin: Complex64,
    unit: f64,
    kind: Kind,
    cells: Arc<Cells>,
}

/// What it was solved on.
#[derive(Clone, Debug)]
pub enum Kind {
    /// Panels.
    Polygons(Field),
    /// Nodes of smooth curves.
    Smooth(SmoothField),
}

impl DomainField {
    pub(super) fn new(domain: Arc<Domain>, origin: Complex64, unit: f64, kind: Kind) -> Self {
        let source = match &kind {
            Kind::Polygons(field) => field.source,
            Kind::Smooth(field) => field.source,
        };
        let singular = source.singularities().into_iter().map(|z| z / unit + origin).collect();
        let cells = Arc::new(Cells::new(&domain, singular));
        Self { domain, origin, unit, kind, cells }
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
        }
    }

    /// (B, B') at a point; `None` outside the closed domain. B' is by plane units.
    #[must_use]
    pub fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        if let Some(point) = self.domain.on_boundary(z) {
            return Some(self.on_boundary(point));
        }
        self.domain.contains(z).then(|| self.directly(z))
    }

    /// [`DomainField::at`] by power series where they serve: the same up to rounding, but for the branch of B.
    #[must_use]
    pub fn fast(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        self.cells.at(&self.domain, z, &|z| self.directly(z)).or_else(|| self.at(z))
    }

    /// (B, B') at a point inside.
    fn directly(&self, z: Complex64) -> (Complex64, Complex64) {
        let scaled = (z - self.origin) * self.unit;
        let (value, slope) = match &self.kind {
            Kind::Smooth(field) => field.at(scaled),
            Kind::Polygons(field) => {
                let (edge, t) = self.oriented(self.domain.nearest(z));
                field.at(scaled, (edge, t))
            }
        };
        (value, slope * self.unit)
    }

    /// (B, B') at a point of the boundary.
    #[must_use]
    pub(crate) fn on_boundary(&self, point: DomainPoint) -> (Complex64, Complex64) {
        let (value, slope) = match &self.kind {
            Kind::Smooth(field) => {
                let contour = &self.domain.contours()[point.component];
                let t = contour.smooth().map_or(f64::NAN, |curve| curve.parameter(point.place));
                field.on_curve_with_slope(point.component, t)
            }
            Kind::Polygons(field) => {
                let (edge, t) = self.oriented(point);
                field.on_edge(edge, t)
            }
        };
        (value, slope * self.unit)
    }

    /// The singular part of the density at a vertex of a component, or the density there if the curve is smooth, up to a factor
    /// that the boundary alone decides.
    #[must_use]
    pub fn strength(&self, component: usize, vertex: usize) -> f64 {
        let place = BoundaryPoint { edge: vertex, t: 0.0, point: Complex64::ZERO };
        match &self.kind {
            Kind::Smooth(field) => {
                let contour = &self.domain.contours()[component];
                field.density(component, contour.smooth().map_or(f64::NAN, |curve| curve.parameter(place)))
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
