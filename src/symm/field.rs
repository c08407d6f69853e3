//! A solved problem as an analytic function: B = L − G, in the closed region, for polygons.

use super::correspondence::BoundaryCorrespondence;
use super::local_series::LocalSeries;
use super::panel::Boundary;
use super::panelled::Panelled;
use super::potential::LogPotential;
use super::problem::Source;
use super::system::System;
use crate::plane::Complex64;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// The function B of a [`Problem`](super::problem::Problem), in scaled units.
#[derive(Clone, Debug)]
pub struct Field {
    system: Arc<System>,
    /// G.
    pub source: Source,
    /// cⱼ.
    pub constants: Vec<f64>,
    correspondence: BoundaryCorrespondence,
    /// On component j, Im B is this − 2π × the measure from vertex 0 of all.
    phases: Vec<f64>,
    potential: LogPotential,
    /// The arguments at the vertices of the logarithms whose arguments g takes.
    turning: Vec<Vec<f64>>,
}

impl Field {
    /// From the masses and constants that solve a problem.
    #[must_use]
    pub fn new(system: &Arc<System>, source: Source, masses: Vec<f64>, constants: Vec<f64>) -> Self {
        let correspondence = BoundaryCorrespondence::signed(&system.discretisation, &masses);
        let potential = LogPotential::of(masses);
        let boundary = &system.discretisation.boundary;
        let turning = source.turning().map(|(a, _)| boundary.arguments(a)).collect();
        let (system, phases) = (Arc::clone(system), Vec::new());
        let mut field = Self { system, source, constants, correspondence, phases, potential, turning };
        field.phases =
            field.system.discretisation.components.iter().map(|panels| field.phase(panels.clone())).collect();
        field
    }

    /// From the value at the middle of a component's longest panel.
    fn phase(&self, panels: std::ops::Range<usize>) -> f64 {
        let discretisation = &self.system.discretisation;
        let length = |q: &usize| discretisation.panels[*q].length();
        let Some(q) = panels.max_by(|a, b| length(a).total_cmp(&length(b))) else { return f64::NAN };
        let panel = &discretisation.panels[q];
        let z = discretisation.boundary.vertices[panel.corner] + panel.direction * panel.distance_at(0.5);
        let (value, _) = self.directly(z, Some(panel.edge));
        value.im + TAU * self.correspondence.measure(q, 0.5)
    }

    fn directly(&self, z: Complex64, on: Option<usize>) -> (Complex64, Complex64) {
        let (log, slope) = self.potential.with_slope(&self.system.discretisation, z, on);
        let (source, source_slope) = self.source.at(z);
        (log - source, slope - source_slope)
    }

    /// The scaled boundary.
    #[must_use]
    pub fn boundary(&self) -> &Arc<Boundary> {
        &self.system.discretisation.boundary
    }

    /// The first vertex of each component, and ∫ σ over it.
    pub fn charges(&self) -> impl Iterator<Item = (Complex64, f64)> + '_ {
        let discretisation = &self.system.discretisation;
        let components = discretisation.unknowns_of_components().into_iter().zip(&discretisation.boundary.loops);
        components.map(|(own, vertices)| {
            (discretisation.boundary.vertices[vertices.start], self.potential.masses()[own].iter().sum())
        })
    }

    /// L, ready to be expanded anywhere.
    #[must_use]
    pub fn series(&self) -> LocalSeries {
        LocalSeries::signed(&self.system.discretisation, self.potential.masses(), &self.correspondence)
    }

    /// (B, B') at a point of the region, given the edge nearest to it and the share of the edge before the nearest point.
    #[must_use]
    pub fn at(&self, z: Complex64, (edge, t): (usize, f64)) -> (Complex64, Complex64) {
        self.beside_corner(z, edge, t).unwrap_or_else(|| self.directly(z, None))
    }

    /// Very near a corner, where the boundary's polynomial continued is more accurate than quadrature.
    fn beside_corner(&self, z: Complex64, edge: usize, t: f64) -> Option<(Complex64, Complex64)> {
        let discretisation = &self.system.discretisation;
        let panels = self.correspondence.panels_of_edge(edge);
        let q = if t <= 0.5 { panels.start } else { panels.end - 1 };
        let panel = &discretisation.panels[q];
        let local = discretisation.local_of(q, z);
        let size = local.norm();
        if size >= discretisation.rules[q].blind_radius() {
            return None;
        }
        // The region lies counter-clockwise of an edge that leaves the corner; the middle of the outside is the cut.
        let cut = PI * (1.0 - 0.5 * discretisation.boundary.alpha[panel.corner]);
        let angle = local.arg();
        let angle = match panel.outgoing {
            true if angle < -cut => angle + TAU,
            false if angle > cut => angle - TAU,
            _ => angle,
        };
        let tau = Complex64::from_polar(size.powf(1.0 / panel.exponent), angle / panel.exponent);
        let value = self.on_panel(q, tau) + self.turn(panel.edge, z);
        // dτ/dz = τ/(a · (z − corner)).
        let by_tau = self.correspondence.complex_density(q, tau) * if panel.outgoing { 1.0 } else { -1.0 };
        let from_corner = z - discretisation.boundary.vertices[panel.corner];
        let slope = Complex64::new(0.0, -TAU) * by_tau * tau / (from_corner * panel.exponent);
        Some((value, slope))
    }

    fn on_panel(&self, q: usize, tau: Complex64) -> Complex64 {
        let discretisation = &self.system.discretisation;
        let component = discretisation.boundary.loop_of(discretisation.panels[q].edge);
        let measure = self.correspondence.complex_measure(q, tau);
        Complex64::new(-self.constants[component], self.phases[component]) - Complex64::new(0.0, TAU) * measure
    }

    /// (B, B') at a point of an edge, on the region's side: the share `t` of the edge before it. The slope is infinite or 0 at
    /// corners.
    #[must_use]
    pub fn on_edge(&self, edge: usize, t: f64) -> (Complex64, Complex64) {
        let length = self.boundary().lengths[edge];
        self.on_edge_between(edge, t * length, (1.0 - t) * length)
    }

    /// [`Field::on_edge`] at these distances (scaled units) from the ends of the edge.
    #[must_use]
    pub fn on_edge_between(&self, edge: usize, along: f64, rest: f64) -> (Complex64, Complex64) {
        let discretisation = &self.system.discretisation;
        let (q, tau) = self.correspondence.place_on_edge(discretisation, edge, along, rest);
        let panel = &discretisation.panels[q];
        // dμ/ds along the boundary.
        let density = self.correspondence.density(q, tau) * panel.slope_at(if panel.outgoing { along } else { rest });
        let direction = discretisation.boundary.directions[edge];
        (self.on_panel(q, tau.into()), Complex64::new(0.0, -TAU * density) / direction)
    }

    /// What takes B from [`Field::on_edge`] to the arguments of [`Field::at`], at a point that sees an edge's start.
    #[must_use]
    pub fn turn(&self, edge: usize, z: Complex64) -> f64 {
        let start = self.boundary().vertices[edge];
        let along = |k: usize, a: Complex64| self.turning[k][edge] + ((z - a) * (start - a).conj()).arg();
        self.source.turn(z, &along)
    }

    /// The edge after `edge`, the region to the left.
    #[must_use]
    pub fn next(&self, edge: usize) -> usize {
        self.system.discretisation.boundary.next(edge)
    }

    /// Of the density at a corner, σ = k s^(1/α − 1) + …: the factor k, on the edge that leaves it (scaled units).
    #[must_use]
    pub fn strength(&self, vertex: usize) -> f64 {
        let discretisation = &self.system.discretisation;
        let q = self.correspondence.panels_of_edge(vertex).start;
        let panel = &discretisation.panels[q];
        // dμ/dτ at τ = 0 times dτ/ds, s = h τᵃ.
        self.correspondence.density(q, 0.0) / (panel.exponent * panel.length().powf(1.0 / panel.exponent))
    }
}
