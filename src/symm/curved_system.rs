//! Symm's equation on curved panels: rows, factorisation, residuals.

use super::curved_boundary::{CurvedBoundary, CurvedTarget};
use super::curved_kernel::CurvedPanel;
use super::lu::Lu;
use super::options::Progress;
use super::order::Order;
use super::panel::Panel;
use super::rule::{PanelRule, Rules};
use super::thin_walls::ThinWalls;
use crate::plane::Complex64;
use crate::{Error, Result};
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
    /// Where the outside is thin.
    pub walls: ThinWalls,
}

/// What one center gave.
#[derive(Clone, Debug)]
pub struct CurvedOutcome {
    /// Mass at each node.
    pub masses: Vec<f64>,
    /// |c|, which would be 0 but for errors.
    pub constant_error: f64,
    /// Largest violation of the equation on each panel, at its check points.
    pub residuals: Vec<f64>,
}

/// The equations, factored.
pub struct CurvedSystem {
    matrix: Vec<f64>,
    lu: Lu,
    targets: Vec<CurvedTarget>,
    checks: Vec<CurvedTarget>,
    check_rows: Vec<f64>,
}

/// Improvements of a solution by its residual.
const IMPROVEMENTS: usize = 2;
/// Rows between two reports.
const REPORT_EVERY: usize = 64;

impl CurvedDiscretisation {
    /// Puts rules to panels.
    #[must_use]
    pub fn new(boundary: Arc<CurvedBoundary>, panels: &[Panel], rules: &mut Rules) -> Self {
        let panel_rules: Vec<_> = panels.iter().map(|panel| rules.of(panel)).collect();
        let order = rules.order.clone();
        let walls = ThinWalls::of(panels.iter().map(|panel| {
            let length = boundary.length(panel);
            (panel.edge, length, ThinWalls::reach(length).and_then(|reach| boundary.behind(panel, reach)))
        }));
        let place = |(panel, rule): (&Panel, &Arc<PanelRule>)| CurvedPanel::new(&boundary, panel, rule, &order);
        let panels = panels.iter().zip(&panel_rules).map(place).collect();
        Self { boundary, panels, rules: panel_rules, order, walls }
    }

    /// Number of unknown masses.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.panels.len() * self.order.p()
    }

    /// The boundary at the given τ of every panel.
    #[must_use]
    pub fn targets(&self, taus: &[f64]) -> Vec<CurvedTarget> {
        let at = |curved: &CurvedPanel| {
            let panel = curved.panel;
            let boundary = &self.boundary;
            taus.iter().map(move |tau| boundary.target(&panel, panel.distance_at(*tau))).collect::<Vec<_>>()
        };
        self.panels.iter().flat_map(at).collect()
    }

    /// τ of the unknowns' nodes.
    #[must_use]
    pub fn node_taus(&self) -> Vec<f64> {
        self.order.panel.nodes.iter().map(|t| 0.5 * (t + 1.0)).collect()
    }

    /// Where the equation is checked: close to the ends of panels, where it holds worst, and twice between nodes.
    #[must_use]
    pub fn check_taus(&self) -> [f64; 4] {
        let nodes = &self.order.panel.nodes;
        let end = 0.01 * (nodes[0] + 1.0);
        let inner = 0.25 * (nodes[0] + nodes[1]) + 0.5;
        [end, inner, 1.0 - inner, 1.0 - end]
    }

    /// Fills the row of a target; the panels that do not see it well go to `blind`.
    fn fill_row(&self, target: &CurvedTarget, row: &mut [f64], blind: &mut [bool]) {
        row.fill(0.0);
        for (q, entries) in row.chunks_exact_mut(self.order.p()).enumerate() {
            let panel = &self.panels[q];
            let seen = self.boundary.seen_from(&panel.panel, target);
            if !panel.add_row(&self.rules[q], &self.order, seen, entries) {
                blind[q] = true;
            }
        }
    }
}

impl CurvedSystem {
    /// Assembles and factors the equations; `Err` inside tells the panels that are too much bent for targets near them.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(
        discretisation: &CurvedDiscretisation,
        progress: Progress,
    ) -> Result<std::result::Result<Self, Vec<bool>>> {
        let n = discretisation.unknowns();
        let targets = discretisation.targets(&discretisation.node_taus());
        let checks = discretisation.targets(&discretisation.check_taus());
        let mut blind = vec![false; discretisation.panels.len()];
        let mut matrix = vec![0.0; (n + 1) * (n + 1)];
        let mut check_rows = vec![0.0; checks.len() * n];
        let steps = (targets.len() + checks.len()) as f64;
        for (i, target) in targets.iter().enumerate() {
            if i % REPORT_EVERY == 0 && !progress("assembling", i as f64 / steps) {
                return Err(Error::Cancelled);
            }
            let row = &mut matrix[i * (n + 1)..][..=n];
            discretisation.fill_row(target, &mut row[..n], &mut blind);
            row[n] = 1.0;
        }
        matrix[n * (n + 1)..][..n].fill(1.0);
        for (i, target) in checks.iter().enumerate() {
            if i % REPORT_EVERY == 0 && !progress("assembling", (targets.len() + i) as f64 / steps) {
                return Err(Error::Cancelled);
            }
            discretisation.fill_row(target, &mut check_rows[i * n..][..n], &mut blind);
        }
        if blind.contains(&true) {
            return Ok(Err(blind));
        }
        if !progress("factoring", 0.0) {
            return Err(Error::Cancelled);
        }
        let lu = Lu::new(n + 1, matrix.clone());
        Ok(Ok(Self { matrix, lu, targets, checks, check_rows }))
    }

    fn size(&self) -> usize {
        self.targets.len() + 1
    }

    fn solve(&self, rhs: &[f64]) -> Vec<f64> {
        let n = self.size();
        let mut x = rhs.to_vec();
        self.lu.solve(&mut x);
        for _ in 0..IMPROVEMENTS {
            let rows = self.matrix.chunks_exact(n).zip(rhs);
            let mut rest: Vec<f64> = rows.map(|(row, b)| b - super::lu::dot(row, &x)).collect();
            self.lu.solve(&mut rest);
            x.iter_mut().zip(&rest).for_each(|(x, step)| *x += step);
        }
        x
    }

    /// Harmonic measure seen from `center` (scaled units).
    #[must_use]
    pub fn measure(&self, boundary: &CurvedBoundary, center: Complex64) -> CurvedOutcome {
        let value = |target: &CurvedTarget| {
            let corner = boundary.vertices[boundary.arms[target.arm].corner];
            (corner - center + target.offset).norm().ln()
        };
        let mut rhs: Vec<f64> = self.targets.iter().map(value).collect();
        rhs.push(1.0);
        let mut masses = self.solve(&rhs);
        let constant = masses.pop().unwrap_or(f64::NAN);
        let n = masses.len();
        let misses: Vec<f64> = self
            .checks
            .iter()
            .zip(self.check_rows.chunks_exact(n))
            .map(|(target, row)| (super::lu::dot(row, &masses) + constant - value(target)).abs())
            .collect();
        let worst =
            |misses: &[f64]| misses.iter().fold(0.0, |worst, r| if *r > worst || r.is_nan() { *r } else { worst });
        CurvedOutcome { masses, constant_error: constant.abs(), residuals: misses.chunks_exact(4).map(worst).collect() }
    }

    /// How much noise of size 1 in the equations moves the measure of a part of the boundary.
    #[must_use]
    pub fn noise_amplification(&self) -> f64 {
        // Signs by a multiplicative hash: the same at every call.
        let sign = |i: usize| if (i + 1).wrapping_mul(0x9e37_79b9) >> 16 & 1 == 0 { 1.0 } else { -1.0 };
        let arm = |i: usize| self.targets[i].arm;
        let mut noise: Vec<f64> = (0..self.targets.len()).map(|i| 0.5 * (sign(i) + sign(arm(i)))).collect();
        noise.push(0.0);
        let x = self.solve(&noise);
        let (mut measure, mut low, mut high) = (0.0, 0.0, 0.0);
        for mass in &x[..x.len() - 1] {
            measure += mass;
            (low, high) = (f64::min(low, measure), f64::max(high, measure));
        }
        high - low
    }
}
