//! Another center far from the first, on panels that are fine only where it looks.

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::options::{Progress, SolveOptions};
use super::panel::{Boundary, Panel};
use super::potential::LogPotential;
use super::rule::Rules;
use super::solution::Solution;
use super::solve::seen_from;
use super::system::System;
use crate::Result;
use crate::plane::Complex64;
use std::f64::consts::TAU;
use std::sync::Arc;

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
}

impl From<&Solution> for Measure {
    fn from(solution: &Solution) -> Self {
        Self {
            discretisation: solution.discretisation().clone(),
            center: solution.center,
            masses: solution.masses.clone(),
            correspondence: solution.correspondence.clone(),
            potential: solution.potential.clone(),
        }
    }
}

impl Measure {
    /// Measure from vertex 0 to the point of `edge` at the given distances from its ends.
    #[must_use]
    pub fn on_edge(&self, (edge, from_start, from_end): (usize, f64, f64)) -> f64 {
        self.correspondence.measure_on_edge(&self.discretisation, edge, from_start, from_end)
    }

    /// Measure from vertex 0 → the edge and the share of it where that is reached.
    #[must_use]
    pub fn locate(&self, measure: f64) -> (usize, f64) {
        let (q, tau) = self.correspondence.locate(&self.discretisation, measure);
        let panel = &self.discretisation.panels[q];
        let share = panel.distance_at(tau) / self.discretisation.boundary.lengths[panel.edge];
        (panel.edge, if panel.outgoing { share } else { 1.0 - share })
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

    /// About the measure of each panel seen from `center`: Poisson's kernel at its middle times its own.
    fn seen_from(&self, center: Complex64) -> Vec<f64> {
        let w = self.map(center);
        let p = self.discretisation.order.p();
        let seen = |(q, masses): (usize, &[f64])| {
            let middle = Complex64::cis(TAU * self.correspondence.measure(&self.discretisation, q, 0.5));
            masses.iter().sum::<f64>() * (1.0 - w.norm_sqr()) / (middle - w).norm_sqr()
        };
        self.masses.chunks_exact(p).enumerate().map(seen).collect()
    }
}

/// Panels of less measure than this share of the tolerance are as coarse as they were at first.
const NEGLIGIBLE: f64 = 1e-3;

/// The region for `center` (scaled units) on panels as fine as a `near` center needed them where `center` sees them, and as
/// coarse as the `first` elsewhere; refined where it needs more. The work does not grow along a chain of centers.
///
/// # Errors
/// As [`solve`](super::solve::solve).
pub fn solve_far(
    first: &Measure,
    near: &Measure,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Solution> {
    let seen = near.seen_from(center);
    let fine: Vec<(Panel, f64)> = near.discretisation.panels.iter().copied().zip(seen).collect();
    let least = NEGLIGIBLE * options.tolerance;
    let boundary = Arc::clone(&first.discretisation.boundary);
    let panels = coarsened(&first.discretisation.panels, &fine, &|mass| mass.abs() > least);
    let panels = panels.into_iter().flat_map(|panel| halved(&boundary, panel, center)).collect();
    let mut rules = Rules::new(first.discretisation.order.clone());
    let system = Arc::new(System::new(Discretisation::new(boundary, panels, &mut rules), progress)?);
    seen_from(center, system, rules, None, options, progress)
}

/// Panels are halved at once until they are no longer than this times their distance from the center (measured: more of
/// them would be halved by their residuals anyway).
const LONGEST: f64 = 0.5;

/// The panel in halves that are short against their distance from `center`, in boundary order.
fn halved(boundary: &Boundary, panel: Panel, center: Complex64) -> Vec<Panel> {
    let mut open = vec![panel];
    let mut done = Vec::new();
    while let Some(panel) = open.pop() {
        let local = (center - boundary.vertices[panel.corner]) * panel.direction.conj();
        let away = local - local.re.clamp(panel.start, panel.end);
        if panel.length() <= LONGEST * away.norm() {
            done.push(panel);
        } else {
            let [before, after] = panel.halves();
            open.extend([after, before]);
        }
    }
    done
}

/// `coarse` panels in the halves that hold what counts of the `fine` panels into which they were halved, and their masses. All
/// in boundary order.
fn coarsened(coarse: &[Panel], fine: &[(Panel, f64)], counts: &dyn Fn(f64) -> bool) -> Vec<Panel> {
    let mut panels = Vec::with_capacity(2 * coarse.len());
    let mut rest = fine;
    for &whole in coarse {
        let parts = rest.split_at(parts_within(whole, rest));
        rest = parts.1;
        coarsen(whole, parts.0, counts, &mut panels);
    }
    panels
}

fn coarsen(whole: Panel, parts: &[(Panel, f64)], counts: &dyn Fn(f64) -> bool, panels: &mut Vec<Panel>) {
    if parts.len() < 2 || !parts.iter().any(|(_, mass)| counts(*mass)) {
        return panels.push(whole);
    }
    let [before, after] = whole.halves();
    let (first, second) = parts.split_at(parts_within(before, parts));
    coarsen(before, first, counts, panels);
    coarsen(after, second, counts, panels);
}

/// How many of the first panels lie within `whole`.
fn parts_within(whole: Panel, parts: &[(Panel, f64)]) -> usize {
    let within = |(part, _): &(Panel, f64)| {
        part.edge == whole.edge && part.outgoing == whole.outgoing && part.start >= whole.start && part.end <= whole.end
    };
    parts.iter().take_while(|part| within(part)).count()
}

#[cfg(test)]
mod tests {
    use super::super::panel::initial_panels;
    use super::*;
    use crate::plane::{Curve, Region};

    #[test]
    fn panels_that_count_stay_fine_and_others_become_coarse() {
        let vertices = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
        let region = Region::new(&vertices, Curve::Polygon, Complex64::new(0.5, 0.5), vertices[0]).unwrap();
        let boundary = Boundary::new(region.polygon());
        let coarse = initial_panels(&boundary, 1.0);
        let fine: Vec<Panel> =
            coarse.iter().flat_map(|panel| panel.halves()).flat_map(|panel| panel.halves()).collect();
        let fine: Vec<_> =
            fine.into_iter().enumerate().map(|(q, panel)| (panel, if q == 5 { 1.0 } else { 0.0 })).collect();
        let panels = coarsened(&coarse, &fine, &|mass| mass > 0.5);
        assert_eq!(panels.len(), coarse.len() + 2);
        assert_eq!(panels[0], coarse[0]);
        assert_eq!(panels[1..3], [fine[4].0, fine[5].0]);
        assert_eq!(panels[3], coarse[1].halves()[1]);
        assert_eq!(panels[4..], coarse[2..]);
    }
}
