//! The map of a polygon as a function, both ways.

use super::super::rounding::{is_outside_disk, onto_disk};
use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::disk_point::DiskPoint;
use super::disk_side::{DiskSide, Source};
use super::inverse_cell::{Inverter, Pair};
use super::position::Position;
use super::region_side::RegionSide;
use crate::plane::Complex64;
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::solution::Solution;
use crate::{Error, Result};
use std::fmt;
use std::sync::OnceLock;

/// The maps region ↔ disk of a polygon's solution, with vertex 0 ↦ 1, in scaled units.
pub struct Expansions {
    atlas: Atlas,
    region: RegionSide,
    /// One a chart, built when it is first asked.
    disks: Vec<OnceLock<DiskSide>>,
    accuracy: Accuracy,
}

impl Expansions {
    /// Builds the way to the disk; the way back is built chart by chart, where it is first asked for.
    #[must_use]
    pub fn new(solution: &Solution, options: &SolveOptions) -> Self {
        Self::build(solution, options, &mut |_, _| true)
    }

    /// [`Expansions::new`], unless `progress` cancels: then nothing is left of it.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn reporting(solution: &Solution, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let mut cancelled = false;
        let built = Self::build(solution, options, &mut |stage, fraction| {
            cancelled = cancelled || !progress(stage, fraction);
            !cancelled
        });
        if cancelled { Err(Error::Cancelled) } else { Ok(built) }
    }

    /// Of no use once `progress` has returned false.
    fn build(solution: &Solution, options: &SolveOptions, progress: Progress) -> Self {
        let boundary = &solution.discretisation().boundary;
        let accuracy = Accuracy::of(solution);
        let mut atlas = Atlas::new(solution, options);
        let region = RegionSide::new(boundary, &mut atlas, accuracy, progress);
        let disks = vec![OnceLock::new(); atlas.charts.len()];
        Self { atlas, region, disks, accuracy }
    }

    /// Builds the way back for all charts.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        for chart in 0..self.disks.len() {
            if !progress("expand", chart as f64 / self.disks.len() as f64) {
                return Err(Error::Cancelled);
            }
            self.disk(chart);
        }
        Ok(())
    }

    #[inline]
    fn disk(&self, chart: usize) -> &DiskSide {
        self.disks[chart].get_or_init(|| DiskSide::new(&self.atlas, &self.region, chart, self.accuracy))
    }

    /// Region → disk; `None` outside the closed region.
    #[inline]
    #[must_use]
    pub fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.region.at(&self.atlas, z).map(|(chart, w)| DiskPoint { chart, w })
    }

    /// Region → disk, with the derivative in the point's chart.
    #[inline]
    #[must_use]
    pub fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        self.region.with_slope(&self.atlas, z).map(|(chart, w, slope)| (DiskPoint { chart, w }, slope))
    }

    /// d(flat point)/d(point in its chart).
    #[inline]
    #[must_use]
    pub fn flat_slope(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 { Complex64::ONE } else { self.atlas.link(0, point.chart).slope(point.w) }
    }

    /// The point of the closed disk as a number.
    #[inline]
    #[must_use]
    pub fn flat(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 { point.w } else { onto_disk(self.atlas.link(0, point.chart).apply(point.w)) }
    }

    /// Disk → region; `None` outside the closed disk.
    #[inline]
    #[must_use]
    pub fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.follow(point, |chart, w| self.disk(chart).at(w)).map(|(z, _, _)| z)
    }

    /// Disk → region, with the derivative by the point's number in its chart.
    #[inline]
    #[must_use]
    pub fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        let (z, slope, chart) = self.follow(point, |chart, w| self.disk(chart).with_slope(w))?;
        if chart == point.chart {
            return Some((z, slope));
        }
        Some((z, slope * self.atlas.link(chart, point.chart).slope(point.w)))
    }

    /// A place where parts of the region are crowded together most, if that had to be accepted anywhere.
    #[must_use]
    pub fn crowded(&self) -> Option<Complex64> {
        self.region.crowded
    }

    /// The charts seen from the first.
    #[must_use]
    pub fn positions(&self) -> &[Position] {
        &self.atlas.positions
    }

    /// Asks charts until one knows the point: it, the derivative in the chart that knew, and that chart.
    #[inline]
    fn follow(
        &self,
        DiskPoint { mut chart, mut w }: DiskPoint,
        ask: impl Fn(usize, Complex64) -> Source,
    ) -> Option<(Complex64, Complex64, usize)> {
        if is_outside_disk(w) {
            return None;
        }
        w = onto_disk(w);
        for _ in 0..self.disks.len() {
            match ask(chart, w) {
                Source::Point(z, slope) => return Some((z, slope, chart)),
                Source::Walk(seed) => return Some(self.walk(chart, seed, w)),
                Source::Nowhere => break,
                Source::Chart(next) => {
                    // Rounding may have put it outside, and what is far away from the next center becomes large there.
                    w = onto_disk(self.atlas.link(next, chart).apply(w));
                    chart = next;
                }
            }
        }
        Some(self.walk(chart, (Complex64::ZERO, self.atlas.charts[chart].center()), w))
    }

    /// Newton's method, for the few places that no expansion reaches.
    #[cold]
    fn walk(&self, chart: usize, seed: Pair, w: Complex64) -> (Complex64, Complex64, usize) {
        let (z, slope) = Inverter::new(&self.atlas, &self.region, chart, self.accuracy).point(seed, w);
        (z, slope, chart)
    }

    /// Number of centers that have a chart.
    #[must_use]
    pub fn charts(&self) -> usize {
        self.disks.len()
    }

    /// Squares that were looked at so far, of the region and of the disks: the work of building.
    fn squares(&self) -> usize {
        self.region.squares() + self.disks.iter().filter_map(OnceLock::get).map(DiskSide::squares).sum::<usize>()
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.atlas.bytes()
            + self.region.bytes()
            + self.disks.iter().filter_map(OnceLock::get).map(DiskSide::bytes).sum::<usize>()
    }
}

impl fmt::Debug for Expansions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Expansions")
            .field("charts", &self.charts())
            .field("squares", &self.squares())
            .field("bytes", &self.bytes())
            .finish_non_exhaustive()
    }
}
