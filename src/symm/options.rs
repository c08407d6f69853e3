//! What a solve should reach and may spend, how it reports, and why it ended.

use crate::{Error, Result};

/// What a solve should reach, and what it may spend.
#[derive(Clone, Debug, PartialEq)]
pub struct SolveOptions {
    /// Largest acceptable error of the map (the disk has radius 1), from 1e-14 to 0.1.
    pub tolerance: f64,
    /// Largest number of unknowns.
    pub max_unknowns: usize,
    /// Most centers, 1 to 64, whose maps are solved and linked so that the far ends of long regions stay apart. With 1
    /// nothing more is solved, and what lies beyond the reach of one center is crowded together.
    pub max_charts: usize,
}

/// More centers than any region needs that double precision can describe.
const MOST_CHARTS: usize = 64;

impl Default for SolveOptions {
    fn default() -> Self {
        Self { tolerance: 1e-8, max_unknowns: 150_000, max_charts: MOST_CHARTS }
    }
}

impl SolveOptions {
    /// Whether the tolerance and the number of centers are ones that can be asked for.
    ///
    /// # Errors
    /// [`Error::InvalidOption`].
    pub fn validate(&self) -> Result<()> {
        if !(1e-14..=0.1).contains(&self.tolerance) {
            return Err(Error::InvalidOption {
                name: "tolerance",
                expected: "between 1e-14 and 0.1",
                value: self.tolerance,
            });
        }
        if !(1..=MOST_CHARTS).contains(&self.max_charts) {
            let value = self.max_charts as f64;
            return Err(Error::InvalidOption { name: "max_charts", expected: "from 1 to 64", value });
        }
        Ok(())
    }

    /// The `best` number of unknowns for each of some panels, or as many as are allowed.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for fewer than the `least`; `expected` says how many these are.
    pub(super) fn allowed(&self, best: usize, panels: usize, least: usize, expected: &'static str) -> Result<usize> {
        let each = best.min(self.max_unknowns / panels);
        if each < least {
            return Err(Error::InvalidOption { name: "max_unknowns", expected, value: self.max_unknowns as f64 });
        }
        Ok(each)
    }
}

/// Told the stage and the fraction done of a long computation; returns false to cancel it.
pub type Progress<'a> = &'a mut dyn FnMut(&'static str, f64) -> bool;

/// What `build` makes, unless `progress` cancels.
///
/// # Errors
/// [`Error::Cancelled`].
pub(crate) fn unless_cancelled<T>(progress: Progress, build: impl FnOnce(Progress) -> T) -> Result<T> {
    let mut cancelled = false;
    let built = build(&mut |stage, fraction| {
        cancelled = cancelled || !progress(stage, fraction);
        !cancelled
    });
    if cancelled { Err(Error::Cancelled) } else { Ok(built) }
}

/// Why a solve ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The error estimate is below the tolerance.
    Tolerance,
    /// The next refinement would need more than `max_unknowns`.
    MaxUnknowns,
    /// The panels of an earlier solve were to be kept, and are too coarse for this center.
    SamePanels,
    /// A smooth curve is not determined to the tolerance by the points that it goes through: more of them are needed, or the
    /// outline has corners.
    TooFewPoints,
    /// Refining no longer helped: rounding, or a region at the limit of double precision.
    Stagnation,
}
