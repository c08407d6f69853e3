//! The boundary correspondence: boundary of the region ↔ angle on the circle.

use super::discretisation::Discretisation;
use super::legendre::{MAX_NODES, complex_integral, complex_sum, legendre};
use crate::plane::Complex64;
use std::f64::consts::TAU;

/// Harmonic measure along the boundary, seen from one center: on every panel a polynomial in its corner variable.
///
/// θ(s) = 2π μ([vertex 0, s]), up to the rotation that puts `toward` at angle 0.
#[derive(Clone, Debug)]
pub struct BoundaryCorrespondence {
    /// Unknowns a panel.
    p: usize,
    /// Legendre coefficients of dμ/dτ on [0, 1], p a panel.
    coefficients: Vec<f64>,
    /// Measure from vertex 0 to where each panel begins in boundary order; one more entry at the end.
    starts: Vec<f64>,
    /// First panel of each edge; one more entry at the end.
    edge_starts: Vec<usize>,
    /// And its panel.
    smallest_mass: (f64, usize),
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
        let order = &discretisation.order;
        let p = order.p();
        let mut coefficients = Vec::with_capacity(masses.len());
        let mut starts = vec![0.0];
        let mut smallest_mass = (f64::INFINITY, 0);
        for (q, masses) in masses.chunks_exact(p).enumerate() {
            let density: Vec<f64> =
                masses.iter().zip(&order.panel.weights).map(|(mass, w)| 2.0 * mass / (w * total)).collect();
            for k in 0..p {
                coefficients.push(order.panel.coefficient_row(k).iter().zip(&density).map(|(t, g)| t * g).sum());
            }
            let mass = masses.iter().sum::<f64>() / total;
            if mass < smallest_mass.0 || mass.is_nan() {
                smallest_mass = (mass, q);
            }
            starts.push(starts[starts.len() - 1] + grows(mass));
        }
        let edges = discretisation.boundary.len();
        let mut edge_starts = vec![0; edges + 1];
        for panel in &discretisation.panels {
            edge_starts[panel.edge + 1] += 1;
        }
        for edge in 0..edges {
            edge_starts[edge + 1] += edge_starts[edge];
        }
        Self { p, coefficients, starts, edge_starts, smallest_mass }
    }

    /// Legendre coefficients of dμ/dτ on panel `q`.
    #[must_use]
    pub fn coefficients(&self, q: usize) -> &[f64] {
        &self.coefficients[q * self.p..][..self.p]
    }

    /// The smallest mass of a panel, negative or NaN if the discretisation failed, and that panel.
    #[must_use]
    pub fn smallest_mass(&self) -> (f64, usize) {
        self.smallest_mass
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

    /// Measure from vertex 0 to the point at τ of panel `q`.
    #[must_use]
    pub fn measure(&self, discretisation: &Discretisation, q: usize, tau: f64) -> f64 {
        self.complex_measure(discretisation, q, Complex64::new(tau, 0.0)).re
    }

    /// Measure from vertex 0 to the point of `edge` at the given distances (scaled units) from its ends. Both are asked for
    /// because panels are measured from the nearer corner.
    #[must_use]
    pub fn measure_on_edge(&self, discretisation: &Discretisation, edge: usize, from_start: f64, from_end: f64) -> f64 {
        let (q, tau) = self.place_on_edge(discretisation, edge, from_start, from_end);
        self.measure(discretisation, q, tau)
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

    /// The same as [`BoundaryCorrespondence::measure`], continued analytically to complex τ: 2π times it is −i log f beside the boundary.
    #[must_use]
    pub fn complex_measure(&self, discretisation: &Discretisation, q: usize, tau: Complex64) -> Complex64 {
        let within = self.mass_up_to(q, tau);
        if discretisation.panels[q].outgoing { self.starts[q] + within } else { self.starts[q + 1] - within }
    }

    /// ∫₀^τ dμ on panel `q`.
    fn mass_up_to(&self, q: usize, tau: Complex64) -> Complex64 {
        0.5 * complex_integral(self.coefficients(q), 2.0 * tau - 1.0)
    }

    /// dμ/dτ on panel `q`, continued to complex τ.
    #[must_use]
    pub fn complex_density(&self, q: usize, tau: Complex64) -> Complex64 {
        complex_sum(self.coefficients(q), 2.0 * tau - 1.0)
    }

    /// Measure from vertex 0 → the edge and the share of it where that is reached; the inverse of
    /// [`BoundaryCorrespondence::measure_on_edge`].
    #[must_use]
    pub fn locate_on_edge(&self, discretisation: &Discretisation, measure: f64) -> (usize, f64) {
        let (q, tau) = self.locate(discretisation, measure);
        let panel = &discretisation.panels[q];
        let share = panel.distance_at(tau) / discretisation.boundary.lengths[panel.edge];
        (panel.edge, if panel.outgoing { share } else { 1.0 - share })
    }

    /// Measure → the panel and τ where it is reached; the inverse of [`BoundaryCorrespondence::measure`].
    #[must_use]
    pub fn locate(&self, discretisation: &Discretisation, measure: f64) -> (usize, f64) {
        let measure = measure.rem_euclid(1.0);
        let q = (self.starts.partition_point(|&start| start <= measure).max(1) - 1).min(self.starts.len() - 2);
        if self.starts[q + 1] == self.starts[q] {
            // Nothing of it is seen.
            return (q, 0.5);
        }
        let (mut low, mut high) = (0.0, 1.0);
        let outgoing = discretisation.panels[q].outgoing;
        let mut tau = (measure - self.starts[q]) / (self.starts[q + 1] - self.starts[q]);
        if !outgoing {
            tau = 1.0 - tau;
        }
        // Newton's method, kept inside the bracket by bisection.
        for _ in 0..80 {
            let miss = self.measure(discretisation, q, tau) - measure;
            if (miss > 0.0) == outgoing {
                high = tau;
            } else {
                low = tau;
            }
            let density = self.density(q, tau) * if outgoing { 1.0 } else { -1.0 };
            let newton = tau - miss / density;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - tau).abs() <= 2.0 * f64::EPSILON * tau.abs() {
                return (q, next);
            }
            tau = next;
        }
        (q, tau)
    }

    /// dμ/dτ at τ of panel `q`.
    #[must_use]
    pub fn density(&self, q: usize, tau: f64) -> f64 {
        let mut p = [0.0; MAX_NODES];
        let p = &mut p[..self.p];
        legendre(2.0 * tau - 1.0, p);
        p.iter().zip(self.coefficients(q)).map(|(p, c)| p * c).sum()
    }
}

/// Measure → angle in [0, 2π).
#[must_use]
pub fn angle_of_measure(measure: f64) -> f64 {
    let share = measure.rem_euclid(1.0);
    if share == 1.0 { 0.0 } else { TAU * share }
}
