//! From the panels of one round to those of the next: some are halved, the others are kept.

use super::options::Progress;
use super::panel::Panel;
use super::panelled::Panelled;
use super::rule::Rules;

/// Panels, and where they come from.
#[derive(Clone, Debug)]
pub struct Refinement {
    /// The panels of the next round.
    pub panels: Vec<Panel>,
    /// The old panel that each is, or is a half of.
    origins: Vec<usize>,
    kept: Vec<bool>,
}

/// Shares of the acceptable residual that are tried until there is something to halve.
const SHARES: [f64; 3] = [1.0, 0.3, 0.1];

impl Refinement {
    /// Halves the panels whose residuals, weighted by the walls behind them, are above the acceptable one, or if there are
    /// none, above a smaller share of it.
    #[must_use]
    pub fn new(discretisation: &dyn Panelled, residuals: &[f64], acceptable: f64) -> Self {
        let weighted: Vec<f64> =
            residuals.iter().enumerate().map(|(q, residual)| residual * discretisation.walls().weight(q)).collect();
        let count = discretisation.panel_count();
        let halve = |q: usize, bound: f64| weighted[q] > bound && discretisation.panel(q).can_be_halved();
        let bounds = SHARES.map(|share| share * acceptable);
        let any = |bound: &f64| (0..count).any(|q| halve(q, *bound));
        let bound = bounds.into_iter().find(any).unwrap_or(f64::INFINITY);
        let mut refinement = Self { panels: Vec::new(), origins: Vec::new(), kept: Vec::new() };
        for q in 0..count {
            let panel = discretisation.panel(q);
            if halve(q, bound) {
                panel.halves().into_iter().for_each(|half| refinement.push(half, q, false));
            } else {
                refinement.push(*panel, q, true);
            }
        }
        refinement
    }

    fn push(&mut self, panel: Panel, origin: usize, kept: bool) {
        self.panels.push(panel);
        self.origins.push(origin);
        self.kept.push(kept);
    }

    /// The same with more of its panels halved: `panels` are those in halves, as often as needed, in the same order.
    pub fn go_on_to(&mut self, panels: Vec<Panel>) {
        let mut old = 0;
        let mut next = Self { panels: Vec::new(), origins: Vec::new(), kept: Vec::new() };
        for panel in panels {
            while !panel.is_within(&self.panels[old]) {
                old += 1;
            }
            next.push(panel, self.origins[old], self.kept[old] && panel == self.panels[old]);
        }
        *self = next;
    }

    /// The old index of panel `q` if it was kept.
    #[must_use]
    pub fn kept(&self, q: usize) -> Option<usize> {
        self.kept[q].then_some(self.origins[q])
    }

    /// The first panel that comes from old panel `q` or one after it.
    #[must_use]
    pub fn first_from(&self, q: usize) -> usize {
        self.origins.partition_point(|&origin| origin < q)
    }

    /// Masses on the old panels' nodes → the same measure on the new ones'.
    #[must_use]
    pub fn carried(&self, from: &dyn Panelled, masses: &[f64]) -> Vec<f64> {
        let gauss = &from.order().panel;
        let p = gauss.len();
        let mut carried = Vec::with_capacity(self.panels.len() * p);
        let mut basis = vec![0.0; p];
        for (q, half) in self.panels.iter().enumerate() {
            let panel = from.panel(self.origins[q]);
            let masses = &masses[self.origins[q] * p..][..p];
            if self.kept[q] {
                carried.extend_from_slice(masses);
                continue;
            }
            for (t, w) in gauss.nodes.iter().zip(&gauss.weights) {
                let s = half.distance_at(0.5 * (t + 1.0));
                gauss.lagrange(2.0 * panel.tau_at(s) - 1.0, &mut basis);
                let density: f64 =
                    basis.iter().zip(masses).zip(&gauss.weights).map(|((b, mass), w)| b * mass / w).sum();
                // From dμ/dτ of the panel to that of the half.
                carried.push(w * density * panel.slope_at(s) / half.slope_at(s));
            }
        }
        carried
    }
}

/// Panels that can be halved where the equation does not hold yet.
pub trait Refinable: Panelled + Sized {
    /// The panels to halve, for residuals (one a panel) beside an acceptable one.
    fn refinement(&self, residuals: &[f64], acceptable: f64) -> Refinement;

    /// The refined panels; if they need more halving to be seen well, that goes into the refinement.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    fn refined(&self, refinement: &mut Refinement, rules: &mut Rules, progress: Progress) -> crate::Result<Self>;
}

#[cfg(test)]
mod tests {
    use super::super::discretisation::Discretisation;
    use super::super::order::Order;
    use super::super::panel::{Boundary, initial_panels};
    use super::super::rule::Rules;
    use super::*;
    use crate::plane::{Complex64, Polygon};
    use std::sync::Arc;

    #[test]
    fn halves_carry_the_mass_of_their_panel() {
        let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
        let polygon = Polygon::new(&corners.map(|(x, y)| Complex64::new(x, y))).unwrap();
        let boundary = Arc::new(Boundary::new(&polygon));
        let panels = initial_panels(&boundary, 1.0);
        let from = Discretisation::new(boundary, panels, &mut Rules::new(Order::new(6, 10.0)));
        let masses: Vec<f64> = (0..from.unknowns()).map(|j| 1.0 + f64::from((j % 7) as u8)).collect();
        let residuals: Vec<f64> = (0..from.panels.len()).map(|q| f64::from((q % 2) as u8)).collect();
        let refinement = Refinement::new(&from, &residuals, 0.5);
        let carried = refinement.carried(&from, &masses);
        for q in 0..from.panels.len() {
            let old: f64 = masses[6 * q..][..6].iter().sum();
            let range = 6 * refinement.first_from(q)..6 * refinement.first_from(q + 1);
            let new: f64 = carried[range].iter().sum();
            // The half at the far end sees the corner's power only through its own polynomial.
            assert!((new - old).abs() < 1e-2 * old, "panel {q}: {old} became {new}");
        }
    }
}
