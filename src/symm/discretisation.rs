//! Symm's equation on panels: unknowns, collocation points, matrix rows.

use super::order::Order;
use super::panel::{Boundary, Panel};
use super::rule::{PanelRule, Rules};
use super::thin_walls::ThinWalls;
use crate::plane::Complex64;
use std::ops::Range;
use std::sync::Arc;

/// A point of the boundary, held as a vertex and an offset from it, so that distances near the vertex keep their digits.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The vertex.
    pub corner: usize,
    /// The point minus the vertex.
    pub offset: Complex64,
}

/// A boundary cut into panels. The unknowns are the masses of harmonic measure at the panels' nodes.
#[derive(Clone, Debug)]
pub struct Discretisation {
    /// The scaled polygon.
    pub boundary: Arc<Boundary>,
    /// Panels in boundary order from vertex 0, component by component.
    pub panels: Vec<Panel>,
    /// The panels of each component.
    pub components: Vec<Range<usize>>,
    /// The rule of each panel.
    pub rules: Vec<Arc<PanelRule>>,
    /// Degrees and distances.
    pub order: Order,
    /// Where the outside is thin.
    pub walls: ThinWalls,
}

impl Discretisation {
    /// Puts rules to panels.
    #[must_use]
    pub fn new(boundary: Arc<Boundary>, panels: Vec<Panel>, rules: &mut Rules) -> Self {
        let walls = ThinWalls::new(&boundary, &panels);
        Self { walls, ..Self::of_known(boundary, panels, rules) }
    }

    /// For masses that are known: nothing is asked of the walls.
    #[must_use]
    pub fn of_known(boundary: Arc<Boundary>, panels: Vec<Panel>, rules: &mut Rules) -> Self {
        let panel_rules = panels.iter().map(|panel| rules.of(panel)).collect();
        let first = |edge: usize| panels.partition_point(|panel| panel.edge < edge);
        let components = boundary.loops.iter().map(|range| first(range.start)..first(range.end)).collect();
        let (order, walls) = (rules.order.clone(), ThinWalls::unseen());
        Self { boundary, panels, components, rules: panel_rules, order, walls }
    }

    /// Number of unknown masses.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.panels.len() * self.order.p()
    }

    /// The unknowns of each component.
    pub fn unknowns_of_components(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        let p = self.order.p();
        self.components.iter().map(move |panels| panels.start * p..panels.end * p)
    }

    /// The point at τ on a panel.
    #[must_use]
    pub fn target(&self, panel: &Panel, tau: f64) -> Target {
        Target { corner: panel.corner, offset: panel.direction * panel.distance_at(tau) }
    }

    /// Every panel's nodes, in the order of the unknowns.
    #[must_use]
    pub fn collocation_points(&self) -> Vec<Target> {
        self.at_each_panel(&self.order.panel.nodes.iter().map(|t| 0.5 * (t + 1.0)).collect::<Vec<_>>())
    }

    /// The nodes of some panels.
    #[must_use]
    pub fn collocation_points_of(&self, panels: &[usize]) -> Vec<Target> {
        let nodes = &self.order.panel.nodes;
        let at = |q: usize| nodes.iter().map(move |t| self.target(&self.panels[q], 0.5 * (t + 1.0)));
        panels.iter().flat_map(|&q| at(q)).collect()
    }

    /// Two points a panel where the equation was not asked to hold, close to its ends, where it holds worst.
    #[must_use]
    pub fn check_points(&self) -> Vec<Target> {
        let end = 0.01 * (self.order.panel.nodes[0] + 1.0);
        self.at_each_panel(&[end, 1.0 - end])
    }

    fn at_each_panel(&self, taus: &[f64]) -> Vec<Target> {
        self.panels.iter().flat_map(|panel| taus.iter().map(|&tau| self.target(panel, tau))).collect()
    }

    /// The target in the coordinates of panel `q`, where the panel is [0, 1].
    #[must_use]
    pub fn local(&self, q: usize, target: Target) -> Complex64 {
        let panel = &self.panels[q];
        let from_corner = self.boundary.vertices[target.corner] - self.boundary.vertices[panel.corner] + target.offset;
        (from_corner * panel.direction.conj() - panel.start) / panel.length()
    }

    /// The point `z` (scaled units) in the coordinates of panel `q`.
    #[must_use]
    pub fn local_of(&self, q: usize, z: Complex64) -> Complex64 {
        let panel = &self.panels[q];
        ((z - self.boundary.vertices[panel.corner]) * panel.direction.conj() - panel.start) / panel.length()
    }

    /// Writes ∫ log|x − y| dμ(y) at `target` for a unit mass at each node of the panels from `first` on into `row`,
    /// whose length is a multiple of p.
    pub fn fill_row(&self, target: Target, first: usize, row: &mut [f64]) {
        row.fill(0.0);
        for (k, entries) in row.chunks_exact_mut(self.order.p()).enumerate() {
            let q = first + k;
            let log_scale = self.panels[q].length().ln();
            self.rules[q].add_row(&self.order, self.local(q, target), log_scale, entries);
        }
    }
}
