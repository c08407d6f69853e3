//! Points of a flow where fluid turns, or wells up.

use crate::plane::{Complex64, Domain};
use crate::symm::problem::{Problem, Source};
use crate::{Error, Result};

/// Points of a flow where fluid turns, or wells up: strictly inside the fluid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlowPoints {
    /// Vortices: their places, and ∮ u·dl around each alone, counter-clockwise.
    pub vortices: Vec<(Complex64, f64)>,
    /// Sources: their places, and how much fluid wells up in each, a unit of time and depth; what is less than 0 drains away. Within
    /// an outer boundary all together must be 0.
    pub sources: Vec<(Complex64, f64)>,
}

impl FlowPoints {
    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.vortices.is_empty() && self.sources.is_empty()
    }

    /// Their places, and κ where W has κ/2π · log(z − a).
    pub(super) fn residues(&self) -> Vec<(Complex64, Complex64)> {
        let mut residues = Vec::new();
        for (list, unit) in [(&self.vortices, -Complex64::i()), (&self.sources, Complex64::ONE)] {
            residues.extend(list.iter().map(|(at, amount)| (*at, unit * amount)));
        }
        residues
    }

    /// What can be asked for in a domain.
    ///
    /// # Errors
    /// [`Error::InvalidOption`], [`Error::NotFinite`], [`Error::PointOutside`].
    pub(super) fn check(&self, domain: &Domain) -> Result<()> {
        for (name, what, list) in [("vortices", "Vortex", &self.vortices), ("sources", "Source", &self.sources)] {
            for (index, &(at, amount)) in list.iter().enumerate() {
                if !at.is_finite() {
                    return Err(Error::NotFinite { what: format!("{what} {index}") });
                }
                if !amount.is_finite() {
                    let expected = "of finite circulations and strengths";
                    return Err(Error::InvalidOption { name, expected, value: amount });
                }
                if domain.lie(at) != Some(None) {
                    return Err(Error::PointOutside { what, index, at });
                }
            }
        }
        let (total, size) = self.sources.iter().fold((0.0, 0.0), |(sum, size), (_, m)| (sum + m, size + m.abs()));
        if domain.is_bounded() && f64::abs(total) > 1e-12 * size {
            let expected = "such that their strengths add up to 0 within an outer boundary";
            return Err(Error::InvalidOption { name: "sources", expected, value: total });
        }
        Ok(())
    }

    /// Problems, and their weights times 2π, whose sum has these points; `scaled` takes plane units to scaled ones.
    pub(super) fn problems(
        &self,
        domain: &Domain,
        scaled: &dyn Fn(Complex64) -> Complex64,
    ) -> (Vec<Problem>, Vec<f64>) {
        // No more may well up within a wall than drains away: sources there have the first for their sink.
        let first = self.sources.first().filter(|_| domain.is_bounded());
        let sources = &self.sources[usize::from(first.is_some())..];
        let (mut problems, mut weights) = (Vec::new(), Vec::new());
        for (list, factor) in [(&self.vortices[..], Complex64::ONE), (sources, Complex64::i())] {
            for (at, amount) in list {
                let mut logs = vec![(scaled(*at), factor)];
                if let Some((sink, _)) = first.filter(|_| factor.im != 0.0) {
                    logs.push((scaled(*sink), -factor));
                }
                let mut charges = vec![0.0; domain.contours().len()];
                if domain.is_bounded() {
                    // With them L − G vanishes outside.
                    charges[0] = factor.re;
                }
                problems.push(Problem { source: Source::logs(logs), charges });
                weights.push(*amount);
            }
        }
        (problems, weights)
    }
}
