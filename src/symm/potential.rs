//! ∫ log(z − y) dμ(y): the logarithmic potential of a solved density, anywhere in the region.

use super::discretisation::Discretisation;
use crate::plane::Complex64;
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// The potential of given node masses.
#[derive(Clone, Debug)]
pub struct LogPotential {
    /// Node masses, their sum 1.
    masses: Vec<f64>,
    /// What every quadrature needs of them, panel by panel; made when first asked for.
    charges: OnceLock<Vec<Vec<f64>>>,
}

impl LogPotential {
    /// From node masses; they are scaled to total mass 1.
    #[must_use]
    pub fn new(masses: &[f64]) -> Self {
        let total: f64 = masses.iter().sum();
        Self { masses: masses.iter().map(|mass| mass / total).collect(), charges: OnceLock::new() }
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
        let arguments = unwrapped_arguments(&discretisation.boundary.vertices, z);
        let mut sum = Complex64::ZERO;
        for (q, panel) in discretisation.panels.iter().enumerate() {
            let local = discretisation.local_of(q, z);
            let own = discretisation.rules[q].potential(&discretisation.order, local, panel.length().ln(), &charges[q]);
            let middle = 0.5 * (arguments[panel.edge] + arguments[panel.edge + 1]);
            let turn = panel.direction.arg();
            let turns = ((middle - turn - (local - 0.5).arg()) / TAU).round();
            sum += own + Complex64::new(0.0, (turn + TAU * turns) * self.masses[q * p..][..p].iter().sum::<f64>());
        }
        sum
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

/// arg(z − v) for the vertices v, each edge turning by less than π; one more entry closes the curve.
fn unwrapped_arguments(vertices: &[Complex64], z: Complex64) -> Vec<f64> {
    let mut arguments = Vec::with_capacity(vertices.len() + 1);
    let mut previous = z - vertices[0];
    let mut argument = previous.arg();
    arguments.push(argument);
    for k in 1..=vertices.len() {
        let next = z - vertices[k % vertices.len()];
        argument += (next * previous.conj()).arg();
        arguments.push(argument);
        previous = next;
    }
    arguments
}
