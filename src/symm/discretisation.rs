//! Symm's equation on panels: unknowns, collocation points, matrix rows.

use super::options::Progress;
use super::order::Order;
use super::panel::{Boundary, Panel};
use super::panelled::Panelled;
use super::problem::{Source, Target};
use super::refinement::{Refinable, Refinement};
use super::rule::{PanelRule, Rules};
use super::thin_walls::ThinWalls;
use crate::Result;
use crate::plane::Complex64;
use std::ops::Range;
use std::sync::Arc;

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

    /// The target in the coordinates of panel `q`, where the panel is [0, 1].
    #[must_use]
    pub fn local(&self, q: usize, target: &Target) -> Complex64 {
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
}

impl Panelled for Discretisation {
    fn order(&self) -> &Order {
        &self.order
    }

    fn panel_count(&self) -> usize {
        self.panels.len()
    }

    fn panel(&self, q: usize) -> &Panel {
        &self.panels[q]
    }

    fn rule(&self, q: usize) -> &PanelRule {
        &self.rules[q]
    }

    fn components(&self) -> &[Range<usize>] {
        &self.components
    }

    fn is_bounded(&self) -> bool {
        self.boundary.bounded
    }

    fn walls(&self) -> &ThinWalls {
        &self.walls
    }

    fn length(&self, q: usize) -> f64 {
        self.panels[q].length()
    }

    fn vertex(&self, q: usize) -> Complex64 {
        self.boundary.vertices[self.panels[q].corner]
    }

    fn offset(&self, q: usize, s: f64) -> Complex64 {
        self.panels[q].direction * s
    }

    fn extent(&self, q: usize) -> Vec<f64> {
        vec![self.panels[q].start, self.panels[q].end]
    }

    /// Close to the ends of panels, where the equation holds worst.
    fn check_taus(&self) -> Vec<f64> {
        let end = 0.01 * (self.order.panel.nodes[0] + 1.0);
        vec![end, 1.0 - end]
    }

    fn values(&self, source: &Source, targets: &[Target]) -> Vec<f64> {
        source.values(&self.boundary, targets)
    }

    fn fill_row(&self, target: &Target, first: usize, row: &mut [f64]) {
        row.fill(0.0);
        for (k, entries) in row.chunks_exact_mut(self.order.p()).enumerate() {
            let q = first + k;
            let log_scale = self.panels[q].length().ln();
            self.rules[q].add_row(&self.order, self.local(q, target), log_scale, entries);
        }
    }
}

impl Refinable for Discretisation {
    fn refinement(&self, residuals: &[f64], acceptable: f64) -> Refinement {
        Refinement::new(self, residuals, acceptable)
    }

    fn refined(&self, refinement: &mut Refinement, rules: &mut Rules, _: Progress) -> Result<Self> {
        Ok(Self::new(Arc::clone(&self.boundary), refinement.panels.clone(), rules))
    }
}
