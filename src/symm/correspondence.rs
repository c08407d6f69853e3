//! The boundary correspondence: boundary of the region ↔ angle on the circle.

use super::discretisation::Discretisation;
use super::panel_measure::{PanelMeasure, Part};
use std::f64::consts::TAU;
use std::ops::Deref;

/// Harmonic measure along the boundary, seen from one center: on every panel a polynomial in its corner variable.
///
/// θ(s) = 2π μ([vertex 0, s]), up to the rotation that puts `toward` at angle 0.
#[derive(Clone, Debug)]
pub struct BoundaryCorrespondence {
    along: PanelMeasure,
    /// First panel of each edge; one more entry at the end.
    edge_starts: Vec<usize>,
}

impl Deref for BoundaryCorrespondence {
    type Target = PanelMeasure;

    fn deref(&self) -> &PanelMeasure {
        &self.along
    }
}

impl BoundaryCorrespondence {
    /// The correspondence of the node masses that solve Symm's equation; they are scaled to total mass 1.
    #[must_use]
    pub fn new(discretisation: &Discretisation, masses: &[f64]) -> Self {
        // Where the measure is below rounding its sign is noise: angles must not run backwards there.
        Self::with(discretisation, masses, masses.iter().sum(), &|mass| mass.max(0.0))
    }

    /// From masses of any sign, as they are.
    #[must_use]
    pub fn signed(discretisation: &Discretisation, masses: &[f64]) -> Self {
        Self::with(discretisation, masses, 1.0, &|mass| mass)
    }

    fn with(discretisation: &Discretisation, masses: &[f64], total: f64, grows: &dyn Fn(f64) -> f64) -> Self {
        let gauss = &discretisation.order.panel;
        let parts = masses.chunks_exact(gauss.len()).map(|own| Part {
            density: own.iter().zip(&gauss.weights).map(|(mass, w)| 2.0 * mass / (w * total)).collect(),
            mass: own.iter().sum::<f64>() / total,
        });
        let outgoing = discretisation.panels.iter().map(|panel| panel.outgoing).collect();
        let along = PanelMeasure::new(gauss, outgoing, parts, grows);
        let edges = discretisation.boundary.len();
        let mut edge_starts = vec![0; edges + 1];
        for panel in &discretisation.panels {
            edge_starts[panel.edge + 1] += 1;
        }
        for edge in 0..edges {
            edge_starts[edge + 1] += edge_starts[edge];
        }
        Self { along, edge_starts }
    }

    /// Measure from vertex 0 to each vertex.
    #[must_use]
    pub fn vertex_measures(&self) -> Vec<f64> {
        self.edge_starts[..self.edge_starts.len() - 1].iter().map(|&q| self.starts[q]).collect()
    }

    /// Panels of an edge, in boundary order.
    #[must_use]
    pub fn panels_of_edge(&self, edge: usize) -> std::ops::Range<usize> {
        self.edge_starts[edge]..self.edge_starts[edge + 1]
    }

    /// Measure from vertex 0 to the point of `edge` at the given distances (scaled units) from its ends. Both are asked for
    /// because panels are measured from the nearer corner.
    #[must_use]
    pub fn measure_on_edge(&self, discretisation: &Discretisation, edge: usize, from_start: f64, from_end: f64) -> f64 {
        let (q, tau) = self.place_on_edge(discretisation, edge, from_start, from_end);
        self.measure(q, tau)
    }

    /// The panel of such a point, and its τ there.
    #[must_use]
    pub fn place_on_edge(
        &self,
        discretisation: &Discretisation,
        edge: usize,
        from_start: f64,
        from_end: f64,
    ) -> (usize, f64) {
        let panels = self.panels_of_edge(edge);
        let distance = |q: usize| if discretisation.panels[q].outgoing { from_start } else { from_end };
        let reached = |q: &usize| {
            let panel = &discretisation.panels[*q];
            if panel.outgoing { distance(*q) <= panel.end } else { distance(*q) >= panel.start }
        };
        let q = panels.clone().find(reached).unwrap_or(panels.end - 1);
        (q, discretisation.panels[q].tau_at(distance(q)))
    }

    /// Measure from vertex 0 → the edge and the share of it where that is reached; the inverse of
    /// [`BoundaryCorrespondence::measure_on_edge`].
    #[must_use]
    pub fn locate_on_edge(&self, discretisation: &Discretisation, measure: f64) -> (usize, f64) {
        let measure = measure.rem_euclid(1.0);
        let q = self.panel_of(measure);
        let tau = self.tau_of(q, measure, self.guess_of(q, measure));
        let panel = &discretisation.panels[q];
        let share = panel.distance_at(tau) / discretisation.boundary.lengths[panel.edge];
        (panel.edge, if panel.outgoing { share } else { 1.0 - share })
    }
}

/// Measure → angle in [0, 2π).
#[must_use]
pub fn angle_of_measure(measure: f64) -> f64 {
    let share = measure.rem_euclid(1.0);
    if share == 1.0 { 0.0 } else { TAU * share }
}
