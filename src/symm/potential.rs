//! ∫ log(z − y) dμ(y): the logarithmic potential of a solved density, anywhere in the region.

use super::discretisation::Discretisation;
use super::panel::{Boundary, Panel};
use crate::plane::Complex64;
use std::f64::consts::{PI, TAU};
use std::sync::OnceLock;

/// The potential of given node masses.
#[derive(Clone, Debug)]
pub struct LogPotential {
    /// Node masses.
    masses: Vec<f64>,
    /// What every quadrature needs of them, panel by panel; made when first asked for.
    charges: OnceLock<Vec<Vec<f64>>>,
}

impl LogPotential {
    /// The potential of node masses; they are scaled to total mass 1.
    #[must_use]
    pub fn new(masses: &[f64]) -> Self {
        let total: f64 = masses.iter().sum();
        Self { masses: masses.iter().map(|mass| mass / total).collect(), charges: OnceLock::new() }
    }

    /// From node masses as they are.
    #[must_use]
    pub fn of(masses: Vec<f64>) -> Self {
        Self { masses, charges: OnceLock::new() }
    }

    /// The node masses.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    fn charges(&self, discretisation: &Discretisation) -> &[Vec<f64>] {
        self.charges.get_or_init(|| {
            let panels = self.masses.chunks_exact(discretisation.order.p());
            discretisation.rules.iter().zip(panels).map(|(rule, masses)| rule.charges(masses)).collect()
        })
    }

    /// The potential at `z` (scaled units), with arg(z − y) continuous along the boundary and principal at vertex 0:
    /// the continuous branch that the paper's appendix 2 warns about. A panel lies on a straight edge, so its own
    /// arguments are continuous, and one multiple of 2π puts it on the branch.
    #[must_use]
    pub fn at(&self, discretisation: &Discretisation, z: Complex64) -> Complex64 {
        let charges = self.charges(discretisation);
        let p = discretisation.order.p();
        let arguments = arguments_at_middles(&discretisation.boundary, z, None);
        let mut sum = Complex64::ZERO;
        for (q, panel) in discretisation.panels.iter().enumerate() {
            let local = discretisation.local_of(q, z);
            let own = discretisation.rules[q].potential(&discretisation.order, local, panel.length().ln(), &charges[q]);
            sum += own + turned(panel, arguments[panel.edge], local, &self.masses[q * p..][..p]);
        }
        sum
    }

    /// [`LogPotential::at`] and its derivative. Of a point on edge `on`, what they are on the region's side of it.
    #[must_use]
    pub fn with_slope(
        &self,
        discretisation: &Discretisation,
        z: Complex64,
        on: Option<usize>,
    ) -> (Complex64, Complex64) {
        let charges = self.charges(discretisation);
        let p = discretisation.order.p();
        let arguments = arguments_at_middles(&discretisation.boundary, z, on);
        let (mut sum, mut slope) = (Complex64::ZERO, Complex64::ZERO);
        for (q, panel) in discretisation.panels.iter().enumerate() {
            let mut local = discretisation.local_of(q, z);
            if on == Some(panel.edge) {
                local.im = if panel.outgoing { 0.0 } else { -0.0 };
            }
            let (rule, order) = (&discretisation.rules[q], &discretisation.order);
            let (own, by_local) = rule.potential_with_slope(order, local, panel.length().ln(), &charges[q]);
            sum += own + turned(panel, arguments[panel.edge], local, &self.masses[q * p..][..p]);
            slope += by_local * panel.direction.conj() / panel.length();
        }
        (sum, slope)
    }

    /// f(z) for the region's map with `center` ↦ 0 and vertex 0 ↦ 1 (scaled units).
    ///
    /// With arg(z − y) principal at vertex 0, vertex 0 goes to angle 0: the mean of arg((y − z₀)/f(y)) over the circle is
    /// −arg f'(z₀), hence arg f'(z₀) = π − ∫ arg(y − z₀) dμ.
    #[must_use]
    pub fn map(&self, discretisation: &Discretisation, center: Complex64, z: Complex64) -> Complex64 {
        (z - center) * (-self.at(discretisation, z)).exp()
    }
}

/// What puts a panel's principal logarithms on the branch: its own arguments are continuous, and `argument` is that of its
/// edge's middle.
fn turned(panel: &Panel, argument: f64, local: Complex64, masses: &[f64]) -> Complex64 {
    let turn = panel.direction.arg();
    let turns = ((argument - turn - (local - 0.5).arg()) / TAU).round();
    Complex64::new(0.0, (turn + TAU * turns) * masses.iter().sum::<f64>())
}

/// About arg(z − y) for the middle y of each edge: continuous along each component, principal at its first vertex, and each edge
/// turning by less than π, or by π if `z` is on it and the region to the left.
fn arguments_at_middles(boundary: &Boundary, z: Complex64, on: Option<usize>) -> Vec<f64> {
    let mut middles = Vec::with_capacity(boundary.len());
    for range in &boundary.loops {
        let mut previous = z - boundary.vertices[range.start];
        let mut argument = previous.arg();
        for edge in range.clone() {
            let next = z - boundary.vertices[boundary.next(edge)];
            let turn = if on == Some(edge) { PI } else { (next * previous.conj()).arg() };
            let after = argument + turn;
            middles.push(0.5 * (argument + after));
            (argument, previous) = (after, next);
        }
    }
    middles
}
