//! The measure of a part of the boundary that is known, while the rest is solved for.

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::local_series::LocalSeries;
use crate::plane::Complex64;

/// Masses that are given, and their potential.
#[derive(Debug)]
pub struct Known {
    /// Their sum.
    pub mass: f64,
    /// Of the same masses scaled to 1; `None` if there are none.
    series: Option<LocalSeries>,
}

impl Known {
    /// From node masses of panels that are not solved for.
    #[must_use]
    pub fn new(discretisation: &Discretisation, masses: &[f64]) -> Self {
        let mass: f64 = masses.iter().sum();
        let series = (mass > 0.0).then(|| {
            let correspondence = BoundaryCorrespondence::new(discretisation, masses);
            LocalSeries::new(discretisation, masses, &correspondence)
        });
        Self { mass, series }
    }

    /// ∫ log|x − y| dμ(y) at points of the boundary that lie on other panels.
    #[must_use]
    pub fn potentials(&self, points: &[Complex64]) -> Vec<f64> {
        let Some(series) = &self.series else { return vec![0.0; points.len()] };
        let mut value = [Complex64::ZERO];
        let at = |point: &Complex64| {
            series.expand(*point, 0.0, &mut value);
            self.mass * value[0].re
        };
        points.iter().map(at).collect()
    }
}
