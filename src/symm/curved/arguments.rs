//! arg(y − z) for y along a boundary of curves.

use super::super::panelled::Panelled;
use crate::plane::Complex64;

/// The argument as seen from one point: continuous along each component, principal where that begins.
#[derive(Clone, Debug)]
pub struct Arguments {
    z: Complex64,
    /// At `STEPS` + 1 places of each panel, from its corner outwards, evenly in the parameter of its arm.
    known: Vec<[f64; STEPS + 1]>,
}

/// Between two of them a panel turns by less than half a turn.
const STEPS: usize = 8;

impl Arguments {
    /// Follows the boundary.
    #[must_use]
    #[inline(never)]
    pub fn new(discretisation: &dyn Panelled, z: Complex64) -> Self {
        let mut known = Vec::with_capacity(discretisation.panel_count());
        for panels in discretisation.components() {
            let mut last: Option<(Complex64, f64)> = None;
            for q in panels.clone() {
                let outgoing = discretisation.panel(q).outgoing;
                let mut own = [0.0; STEPS + 1];
                for k in 0..=STEPS {
                    let place = if outgoing { k } else { STEPS - k };
                    let here = step(discretisation, q, place) - z;
                    let argument = last.map_or(here.arg(), |(there, argument)| argument + (here * there.conj()).arg());
                    own[place] = argument;
                    last = Some((here, argument));
                }
                known.push(own);
            }
        }
        Self { z, known }
    }

    /// At the parameter s of the arm of panel `q`.
    #[must_use]
    #[inline(never)]
    pub fn at(&self, discretisation: &dyn Panelled, q: usize, s: f64) -> f64 {
        let panel = discretisation.panel(q);
        let place = ((s - panel.start) / panel.length() * STEPS as f64).round().clamp(0.0, STEPS as f64) as usize;
        let from = step(discretisation, q, place) - self.z;
        let here = discretisation.point(q, s) - self.z;
        self.known[q][place] + (here * from.conj()).arg()
    }
}

#[inline(never)]
fn step(discretisation: &dyn Panelled, q: usize, place: usize) -> Complex64 {
    let panel = discretisation.panel(q);
    let s = panel.start + panel.length() * (place as f64 / STEPS as f64);
    discretisation.point(q, s)
}
