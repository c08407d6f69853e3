//! Solutions as bytes: what the solve found, and nothing that follows from it.
//!
//! Of a polygon's solution these are where its panels end and their masses, of a smooth curve's the masses of its nodes. Rules,
//! correspondence and potential are made anew, by the same steps and so with the same bits; the system is assembled when
//! another center asks for it.

use super::discretisation::Discretisation;
use super::legendre::MAX_NODES;
use super::options::{SolveOptions, Stop};
use super::order::Order;
use super::panel::{Boundary, Panel};
use super::rule::Rules;
use super::smooth::SmoothSolution;
use super::smooth_system::{LEAST_NODES, MOST_NODES, Samples};
use super::solution::Solution;
use crate::plane::{Complex64, Region};
use crate::stored::{Reader, Writer};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Edges are covered by their panels up to this share of their length.
const COVERED: f64 = 1e-9;
/// Digits of quadrature that an order can have.
const DIGITS: std::ops::RangeInclusive<f64> = 1.0..=16.0;
/// Every reason why a solve can have ended, by its number.
const STOPS: [Stop; 5] = [Stop::Tolerance, Stop::MaxUnknowns, Stop::SamePanels, Stop::TooFewPoints, Stop::Stagnation];

const NO_POSSIBLE_WAY: &str = "it is resolved in no possible way";
pub(super) const OF_ANOTHER_REGION: &str = "its measure is not that of its region";

/// So many points are looked at around a region,
const AROUND: usize = 24;
/// this many times farther from the center than its farthest vertex.
const AWAY: f64 = 1.25;
/// The potential may miss there by this share of the solve's estimate,
const MISSES: f64 = 3.0;
/// and by rounding.
const ROUNDING: f64 = 1e-11;

pub(super) fn damaged(reason: &'static str) -> Error {
    Error::Damaged { reason }
}

impl SolveOptions {
    /// Writes them.
    pub(crate) fn store(&self, to: &mut Writer) {
        to.number(self.tolerance);
        to.number(self.max_unknowns as f64);
        to.number(self.max_charts as f64);
    }

    /// Reads what [`SolveOptions::store`] wrote.
    ///
    /// # Errors
    /// [`Error::Damaged`], [`Error::InvalidOption`].
    pub(crate) fn restore(from: &mut Reader) -> Result<Self> {
        let (tolerance, unknowns, charts) = (from.number()?, from.number()?, from.number()?);
        let options = Self { tolerance, max_unknowns: unknowns as usize, max_charts: charts as usize };
        options.validate()?;
        Ok(options)
    }
}

fn store_stop(stop: Stop, to: &mut Writer) {
    to.case(STOPS.iter().position(|known| *known == stop).unwrap_or_default() as u8);
}

fn restore_stop(from: &mut Reader) -> Result<Stop> {
    let number = from.case()?;
    STOPS.get(usize::from(number)).copied().ok_or(damaged("it ended for no known reason"))
}

/// A residual or an estimate.
fn restore_error(from: &mut Reader) -> Result<f64> {
    let error = from.number()?;
    if error >= 0.0 { Ok(error) } else { Err(damaged("an estimate in it is negative")) }
}

/// What a solve on panels says of itself, and how its panels are resolved.
pub(super) struct Header {
    pub stop: Stop,
    pub residual: f64,
    pub error_estimate: f64,
    /// Unknowns a panel.
    pub p: usize,
    /// Digits that the quadrature keeps.
    pub digits: f64,
}

impl Header {
    pub(super) fn store(&self, to: &mut Writer) {
        store_stop(self.stop, to);
        to.number(self.residual);
        to.number(self.error_estimate);
        to.case(self.p as u8);
        to.number(self.digits);
    }

    pub(super) fn restore(from: &mut Reader) -> Result<Self> {
        let stop = restore_stop(from)?;
        let (residual, error_estimate) = (restore_error(from)?, restore_error(from)?);
        let (p, digits) = (usize::from(from.case()?), from.number()?);
        if !(2..=MAX_NODES).contains(&p) || !DIGITS.contains(&digits) {
            return Err(damaged(NO_POSSIBLE_WAY));
        }
        Ok(Self { stop, residual, error_estimate, p, digits })
    }
}

/// Whether a measure attracts so many points of a circle around `center` as all of it there would, but for a miss: what Symm's equation
/// says on the boundary holds outside of it too. Of another region, or another center, that is false.
pub(super) fn is_seen_from(
    (center, radius): (Complex64, f64),
    points: usize,
    miss: f64,
    potential: &dyn Fn(Complex64) -> f64,
) -> bool {
    let at = |k: usize| center + Complex64::from_polar(radius, TAU * k as f64 / points as f64);
    (0..points).all(|k| (potential(at(k)) - radius.ln()).abs() <= miss)
}

impl Solution {
    /// Writes what [`Solution::restore`] needs beside the region.
    pub(crate) fn store(&self, to: &mut Writer) {
        let Self { residual, error_estimate, stop, .. } = *self;
        let discretisation = self.discretisation();
        let (p, digits) = (discretisation.order.p(), discretisation.order.digits);
        Header { stop, residual, error_estimate, p, digits }.store(to);
        for panels in discretisation.panels.chunk_by(|a, b| a.edge == b.edge) {
            let outgoing = panels.iter().take_while(|panel| panel.outgoing).count();
            to.count(outgoing);
            to.count(panels.len() - outgoing);
            panels.iter().for_each(|panel| to.number(panel.end));
        }
        to.numbers(&self.masses);
    }

    /// Reads the solution of Symm's equation for the polygon around `region`.
    ///
    /// # Errors
    /// [`Error::Damaged`].
    pub(crate) fn restore(region: &Region, from: &mut Reader) -> Result<Self> {
        let Header { stop, residual, error_estimate, p, digits } = Header::restore(from)?;
        let boundary = Boundary::new(region.polygon());
        let mut panels = Vec::new();
        for edge in 0..boundary.len() {
            restore_panels(&boundary, edge, p, from, &mut panels)?;
        }
        let masses = from.numbers(panels.len() * p)?;
        let center = region.center() * boundary.unit;
        let mut rules = Rules::new(Order::new(p, digits));
        let discretisation = Arc::new(Discretisation::new(Arc::new(boundary), panels, &mut rules));
        let solution = Self::new(discretisation, center, masses, residual, error_estimate, stop);
        let (least, _) = solution.correspondence.smallest_mass();
        if least < -error_estimate {
            return Err(damaged("its measure is negative somewhere"));
        }
        if !solution.is_seen_from_center() {
            return Err(damaged(OF_ANOTHER_REGION));
        }
        Ok(solution)
    }

    fn is_seen_from_center(&self) -> bool {
        let Self { center, error_estimate, .. } = *self;
        let vertices = &self.discretisation().boundary.vertices;
        let radius = AWAY * vertices.iter().map(|v| (v - center).norm()).fold(0.0, f64::max);
        let potential = |z| self.potential.at(self.discretisation(), z).re;
        is_seen_from((center, radius), AROUND, MISSES * error_estimate + ROUNDING, &potential)
    }
}

/// Reads the panels of an edge, from where each of them ends.
fn restore_panels(
    boundary: &Boundary,
    edge: usize,
    p: usize,
    from: &mut Reader,
    panels: &mut Vec<Panel>,
) -> Result<()> {
    let each = size_of::<f64>() * (p + 1);
    let (outgoing, incoming) = (from.count(each)?, from.count(each)?);
    let ends = from.numbers(outgoing + incoming)?;
    let (first, second) = ends.split_at(outgoing);
    let rises = |a: &f64, b: &f64| a < b;
    let middle = 0.5 * boundary.lengths[edge];
    let reaches = |end: Option<&f64>| end.is_some_and(|end| (end - middle).abs() <= COVERED * middle);
    let covers = reaches(first.last())
        && reaches(second.first())
        && [first.first(), second.last()].into_iter().flatten().all(|end| *end > 0.0)
        && first.is_sorted_by(rises)
        && second.is_sorted_by(|a, b| rises(b, a));
    if !covers {
        return Err(damaged("its panels do not cover the boundary"));
    }
    let panel = |corner: usize, start: f64, end: f64| {
        let outgoing = corner == edge;
        let direction = if outgoing { boundary.directions[edge] } else { -boundary.directions[edge] };
        let exponent = if start == 0.0 { boundary.exponent(corner) } else { 1.0 };
        Panel { edge, corner, direction, outgoing, start, end, exponent }
    };
    let starts = |k: usize| if k == 0 { 0.0 } else { first[k - 1] };
    panels.extend(first.iter().enumerate().map(|(k, end)| panel(edge, starts(k), *end)));
    let starts = |k: usize| second.get(k + 1).copied().unwrap_or(0.0);
    panels.extend(second.iter().enumerate().map(|(k, end)| panel(boundary.next(edge), starts(k), *end)));
    Ok(())
}

impl SmoothSolution {
    /// Writes what [`SmoothSolution::restore`] needs beside the region.
    pub(crate) fn store(&self, to: &mut Writer) {
        store_stop(self.stop, to);
        to.number(self.residual);
        to.count(self.masses().len());
        to.numbers(self.masses());
    }

    /// Reads the solution of Symm's equation for the smooth curve around `region`.
    ///
    /// # Errors
    /// [`Error::Damaged`], and those of [`SmoothSolution::checked`].
    pub(crate) fn restore(region: &Region, from: &mut Reader) -> Result<Self> {
        let curve = region.smooth().ok_or(damaged("its curve is not smooth"))?;
        let stop = restore_stop(from)?;
        let residual = restore_error(from)?;
        let nodes = from.count(size_of::<f64>())?;
        if !(LEAST_NODES..=MOST_NODES).contains(&nodes) {
            return Err(damaged(NO_POSSIBLE_WAY));
        }
        let masses = from.numbers(nodes)?;
        let samples = Arc::new(Samples::new(vec![Arc::clone(curve)], &[nodes]));
        let center = region.center() * samples.unit;
        let mut solution = Self::of_masses(samples, center, masses, residual);
        solution.stop = stop;
        solution.checked()
    }
}
