//! Solutions on curved edges as bytes: panels and masses; everything else follows from the region.

use super::super::order::Order;
use super::super::panel::Panel;
use super::super::rule::Rules;
use super::super::stored::{Header, OF_ANOTHER_REGION, damaged};
use super::boundary::CurvedBoundary;
use super::discretisation::CurvedDiscretisation;
use super::solution::CurvedSolution;
use crate::Result;
use crate::plane::{Complex64, CurvedOutline};
use crate::stored::{Reader, Writer};
use std::sync::Arc;

impl CurvedSolution {
    /// Writes what [`CurvedSolution::restore`] needs beside the region.
    pub(crate) fn store(&self, to: &mut Writer) {
        let Self { residual, error_estimate, stop, .. } = *self;
        let discretisation = &self.discretisation;
        let (p, digits) = (discretisation.order.p(), discretisation.order.digits);
        Header { stop, residual, error_estimate, p, digits }.store(to);
        for arm in
            discretisation.panels.chunk_by(|a, b| CurvedBoundary::arm_of(&a.panel) == CurvedBoundary::arm_of(&b.panel))
        {
            to.count(arm.len());
            arm.iter().for_each(|curved| to.number(curved.panel.end));
        }
        to.numbers(&self.masses);
    }

    /// Reads the solution of Symm's equation for the edges around a region.
    ///
    /// # Errors
    /// [`Error::Damaged`](crate::Error::Damaged), [`Error::NegativeMass`](crate::Error::NegativeMass).
    pub(crate) fn restore(outline: &CurvedOutline, center: Complex64, from: &mut Reader) -> Result<Self> {
        let Header { stop, residual, error_estimate, p, digits } = Header::restore(from)?;
        let boundary = Arc::new(CurvedBoundary::new(outline, digits));
        let mut panels = Vec::new();
        for arm in 0..boundary.arms.len() {
            restore_panels(&boundary, arm, p, from, &mut panels)?;
        }
        let masses = from.numbers(panels.len() * p)?;
        let center = center * boundary.unit;
        let discretisation = CurvedDiscretisation::new(boundary, &panels, &mut Rules::new(Order::new(p, digits)));
        let solution = Self::new(Arc::new(discretisation), center, masses, residual, error_estimate, stop).checked()?;
        if solution.is_seen_from_center() { Ok(solution) } else { Err(damaged(OF_ANOTHER_REGION)) }
    }
}

/// Reads the panels of an arm, in boundary order, from where each of them ends.
fn restore_panels(
    boundary: &CurvedBoundary,
    arm: usize,
    p: usize,
    from: &mut Reader,
    panels: &mut Vec<Panel>,
) -> Result<()> {
    let count = from.count(size_of::<f64>() * (p + 1))?;
    let mut ends = from.numbers(count)?;
    let arm = &boundary.arms[arm];
    if !arm.outgoing {
        ends.reverse();
    }
    let covers =
        ends.first().is_some_and(|end| *end > 0.0) && ends.last() == Some(&0.5) && ends.is_sorted_by(|a, b| a < b);
    if !covers {
        return Err(damaged("its panels do not cover the boundary"));
    }
    let mut start = 0.0;
    let mut own: Vec<Panel> = Vec::with_capacity(count);
    for end in ends {
        own.push(boundary.panel(arm, start, end));
        start = end;
    }
    if !arm.outgoing {
        own.reverse();
    }
    panels.extend(own);
    Ok(())
}
