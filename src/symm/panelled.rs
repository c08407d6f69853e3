//! What the equations ask of a boundary cut into panels, straight or curved.

use super::order::Order;
use super::panel::Panel;
use super::problem::{Source, Target};
use super::rule::PanelRule;
use super::thin_walls::ThinWalls;
use crate::plane::Complex64;
use std::ops::Range;

/// A boundary cut into panels. The unknowns are the masses at the panels' nodes.
pub trait Panelled: Send + Sync {
    /// Degrees and distances.
    fn order(&self) -> &Order;
    /// Panels in boundary order from vertex 0, component by component.
    fn panel_count(&self) -> usize;
    /// One of them.
    fn panel(&self, q: usize) -> &Panel;
    /// How its masses act.
    fn rule(&self, q: usize) -> &PanelRule;
    /// The panels of each component.
    fn components(&self) -> &[Range<usize>];
    /// Whether the first component is around the region.
    fn is_bounded(&self) -> bool;
    /// Where the outside is thin.
    fn walls(&self) -> &ThinWalls;
    /// Length of a panel (scaled units).
    fn length(&self, q: usize) -> f64;
    /// The vertex from which a panel is measured.
    fn vertex(&self, q: usize) -> Complex64;
    /// The point of a panel at `s`, less that vertex: so that distances near the vertex keep their digits.
    fn offset(&self, q: usize, s: f64) -> Complex64;
    /// Places s of a panel around all of which a disk holds it.
    fn extent(&self, q: usize) -> Vec<f64>;
    /// τ of every panel where the equation was not asked to hold, but is checked.
    fn check_taus(&self) -> Vec<f64>;
    /// g of a right-hand side.
    fn values(&self, source: &Source, targets: &[Target]) -> Vec<f64>;
    /// Writes ∫ log|x − y| dμ(y) at `target` for a unit mass at each node of the panels from `first` on into `row`, whose
    /// length is a multiple of p.
    fn fill_row(&self, target: &Target, first: usize, row: &mut [f64]);

    /// Number of unknown masses.
    fn unknowns(&self) -> usize {
        self.panel_count() * self.order().p()
    }

    /// The unknowns of each component.
    fn unknowns_of_components(&self) -> Vec<Range<usize>> {
        let p = self.order().p();
        self.components().iter().map(|panels| panels.start * p..panels.end * p).collect()
    }

    /// τ of the nodes.
    fn node_taus(&self) -> Vec<f64> {
        self.order().panel.nodes.iter().map(|t| 0.5 * (t + 1.0)).collect()
    }

    /// The boundary at τ of a panel.
    fn target(&self, q: usize, tau: f64) -> Target {
        let panel = self.panel(q);
        let s = panel.distance_at(tau);
        Target { panel: q, s, corner: panel.corner, offset: self.offset(q, s) }
    }

    /// The boundary at `s` of a panel.
    fn point(&self, q: usize, s: f64) -> Complex64 {
        self.vertex(q) + self.offset(q, s)
    }

    /// The boundary at the given τ of every panel.
    fn targets(&self, taus: &[f64]) -> Vec<Target> {
        (0..self.panel_count()).flat_map(|q| taus.iter().map(move |tau| self.target(q, *tau))).collect()
    }

    /// The same as points (scaled units).
    fn points(&self, taus: &[f64]) -> Vec<Complex64> {
        self.targets(taus).iter().map(|target| self.vertex(target.panel) + target.offset).collect()
    }
}
