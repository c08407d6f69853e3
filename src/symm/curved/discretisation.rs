//! Symm's equation on curved panels: unknowns, places, matrix rows.

use super::super::options::Progress;
use super::super::order::Order;
use super::super::panel::{Panel, halved};
use super::super::panelled::Panelled;
use super::super::problem::{Source, Target};
use super::super::refinement::{Refinable, Refinement};
use super::super::rule::{PanelRule, Rules};
use super::super::thin_walls::ThinWalls;
use super::arguments::Arguments;
use super::boundary::CurvedBoundary;
use super::kernel::CurvedPanel;
use crate::plane::Complex64;
use crate::{Error, Result};
use std::ops::Range;
use std::sync::Arc;

/// A boundary of curves cut into panels; the unknowns are the masses of harmonic measure at their nodes.
#[derive(Clone, Debug)]
pub struct CurvedDiscretisation {
    /// The scaled boundary.
    pub boundary: Arc<CurvedBoundary>,
    /// In boundary order from vertex 0.
    pub panels: Vec<CurvedPanel>,
    /// The rule of each panel.
    pub rules: Vec<Arc<PanelRule>>,
    /// Degrees and distances.
    pub order: Order,
    walls: ThinWalls,
    /// The panels of each component.
    components: Vec<Range<usize>>,
}

/// Times that panels are halved because targets near them do not find their parameter.
const MOST_HALVINGS: usize = 60;
/// Targets between two reports.
const REPORT_EVERY: usize = 256;

impl CurvedDiscretisation {
    /// Puts rules to panels.
    #[must_use]
    pub fn new(boundary: Arc<CurvedBoundary>, panels: &[Panel], rules: &mut Rules) -> Self {
        let components = boundary.components(panels);
        let panel_rules: Vec<_> = panels.iter().map(|panel| rules.of(panel)).collect();
        let order = rules.order.clone();
        let walls = ThinWalls::of(panels.iter().map(|panel| {
            let length = boundary.length(panel);
            (panel.edge, length, ThinWalls::reach(length).and_then(|reach| boundary.behind(panel, reach)))
        }));
        let place = |(panel, rule): (&Panel, &Arc<PanelRule>)| CurvedPanel::new(&boundary, panel, rule, &order);
        let panels: Vec<CurvedPanel> = panels.iter().zip(&panel_rules).map(place).collect();
        Self { boundary, panels, rules: panel_rules, order, walls, components }
    }

    /// The same, panels being halved until all nodes and checks that lie near one find their parameter there.
    ///
    /// # Errors
    /// [`Error::Cancelled`]; [`Error::Inaccurate`] if no halving helps.
    pub fn seeing(
        boundary: &Arc<CurvedBoundary>,
        mut panels: Vec<Panel>,
        rules: &mut Rules,
        progress: Progress,
    ) -> Result<Self> {
        for _ in 0..MOST_HALVINGS {
            let discretisation = Self::new(Arc::clone(boundary), &panels, rules);
            let blind = discretisation.blind(progress)?;
            if !blind.contains(&true) {
                return Ok(discretisation);
            }
            panels = halved(&panels, &blind);
        }
        Err(Error::Inaccurate { estimate: f64::INFINITY })
    }

    /// The panels that some target near them does not find its parameter on.
    fn blind(&self, progress: Progress) -> Result<Vec<bool>> {
        let mut blind = vec![false; self.panels.len()];
        let taus = [self.node_taus(), self.check_taus()].concat();
        let targets = self.targets(&taus);
        for (i, target) in targets.iter().enumerate() {
            if i % REPORT_EVERY == 0 && !progress("assemble", i as f64 / targets.len() as f64) {
                return Err(Error::Cancelled);
            }
            for (q, panel) in self.panels.iter().enumerate() {
                let (known, step) = self.boundary.seen_from(&panel.panel, self.panel(target.panel), target);
                if panel.see(&self.rules[q], &self.order, known, step).is_none() {
                    blind[q] = true;
                }
            }
        }
        Ok(blind)
    }
}

impl Panelled for CurvedDiscretisation {
    fn order(&self) -> &Order {
        &self.order
    }

    fn panel_count(&self) -> usize {
        self.panels.len()
    }

    fn panel(&self, q: usize) -> &Panel {
        &self.panels[q].panel
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
        self.boundary.length(self.panel(q))
    }

    fn vertex(&self, q: usize) -> Complex64 {
        self.boundary.vertices[self.panel(q).corner]
    }

    fn offset(&self, q: usize, s: f64) -> Complex64 {
        self.boundary.arm(self.panel(q)).curve.from_start(s.into())
    }

    fn extent(&self, q: usize) -> Vec<f64> {
        let panel = self.panel(q);
        [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| panel.start + share * panel.length()).to_vec()
    }

    /// Close to the ends of panels, where the equation holds worst, and twice between nodes.
    fn check_taus(&self) -> Vec<f64> {
        let nodes = &self.order.panel.nodes;
        let end = 0.01 * (nodes[0] + 1.0);
        let inner = 0.25 * (nodes[0] + nodes[1]) + 0.5;
        vec![end, inner, 1.0 - inner, 1.0 - end]
    }

    fn values(&self, source: &Source, targets: &[Target]) -> Vec<f64> {
        let level = |target: &Target| source.level_at(self.vertex(target.panel), target.offset);
        let mut values: Vec<f64> = targets.iter().map(level).collect();
        for (a, factor) in source.turning() {
            let arguments = Arguments::new(self, a);
            let turned = |target: &Target| factor * arguments.at(self, target.panel, target.s);
            values.iter_mut().zip(targets).for_each(|(value, target)| *value += turned(target));
        }
        values
    }

    fn fill_row(&self, target: &Target, first: usize, row: &mut [f64]) {
        row.fill(0.0);
        let from = self.panel(target.panel);
        for (k, entries) in row.chunks_exact_mut(self.order.p()).enumerate() {
            let q = first + k;
            let panel = &self.panels[q];
            let seen = self.boundary.seen_from(&panel.panel, from, target);
            if !panel.add_row(&self.rules[q], &self.order, seen, entries) {
                // No residual is below this.
                entries.fill(f64::NAN);
            }
        }
    }
}

impl Refinable for CurvedDiscretisation {
    fn refinement(&self, residuals: &[f64], acceptable: f64) -> Refinement {
        let mut refinement = Refinement::new(self, residuals, acceptable);
        refinement.go_on_to(self.boundary.balanced(refinement.panels.clone()));
        refinement
    }

    fn refined(&self, refinement: &mut Refinement, rules: &mut Rules, progress: Progress) -> Result<Self> {
        let refined = Self::seeing(&self.boundary, refinement.panels.clone(), rules, progress)?;
        refinement.go_on_to(refined.panels.iter().map(|curved| curved.panel).collect());
        Ok(refined)
    }
}
