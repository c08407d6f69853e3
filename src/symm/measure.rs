//! Harmonic measure without the equations that gave it.

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::local_series::LocalSeries;
use super::potential::LogPotential;
use super::solution::Solution;
use crate::plane::Complex64;

/// Harmonic measure seen from a center: what stays of a [`Solution`] when its matrices go.
#[derive(Clone, Debug)]
pub struct Measure {
    /// The panels it lives on.
    pub discretisation: Discretisation,
    /// The center (scaled units).
    pub center: Complex64,
    /// Mass at each node.
    pub masses: Vec<f64>,
    /// θ along the boundary.
    pub correspondence: BoundaryCorrespondence,
    /// log f inside, by direct summation.
    pub potential: LogPotential,
    /// Estimate of the map's error.
    pub estimate: f64,
}

impl From<&Solution> for Measure {
    fn from(solution: &Solution) -> Self {
        Self {
            discretisation: solution.discretisation().clone(),
            center: solution.center,
            masses: solution.masses.clone(),
            correspondence: solution.correspondence.clone(),
            potential: solution.potential.clone(),
            estimate: solution.error_estimate,
        }
    }
}

impl Measure {
    /// The potential as power series.
    #[must_use]
    pub fn series(&self) -> LocalSeries {
        LocalSeries::new(&self.discretisation, &self.masses, &self.correspondence)
    }

    /// Measure from vertex 0 to the point of `edge` at the given distances from its ends.
    #[must_use]
    pub fn on_edge(&self, (edge, from_start, from_end): (usize, f64, f64)) -> f64 {
        self.correspondence.measure_on_edge(&self.discretisation, edge, from_start, from_end)
    }

    /// Measure from vertex 0 → the edge and the share of it where that is reached.
    #[must_use]
    pub fn locate(&self, measure: f64) -> (usize, f64) {
        self.correspondence.locate_on_edge(&self.discretisation, measure)
    }

    /// Region → disk by direct summation (scaled units).
    #[must_use]
    pub fn map(&self, z: Complex64) -> Complex64 {
        self.potential.map(&self.discretisation, self.center, z)
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        // Masses, coefficients of the correspondence, masses of the potential.
        3 * std::mem::size_of_val(&self.masses[..]) + std::mem::size_of_val(&self.discretisation.panels[..])
    }
}
