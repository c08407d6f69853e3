//! The map of a polygon as a function, both ways.

use super::super::rounding::{is_outside_disk, onto_disk};
use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::disk_point::DiskPoint;
use super::disk_side::{DiskSide, Source};
use super::inverse_cell::{Inverter, Pair};
use super::patch::Patch;
use super::position::Position;
use super::region_side::{Found, RegionSide};
use crate::Result;
use crate::plane::Complex64;
use crate::symm::options::{Progress, SolveOptions, unless_cancelled};
use crate::symm::solution::Solution;
use std::fmt;
use std::sync::OnceLock;

/// The maps region ↔ disk of a polygon's solution, with vertex 0 ↦ 1, in scaled units.
///
/// Everything is built when it is first asked for, and whether it is asked for depends on the point alone: what the first
/// chart tells apart it always answers, alone; where it crowds the region together, all charts are solved.
pub struct Expansions {
    near: Charted,
    far: OnceLock<Charted>,
    accuracy: Accuracy,
}

/// Both ways by some charts.
struct Charted {
    atlas: Atlas,
    region: RegionSide,
    /// One a chart.
    disks: Vec<OnceLock<DiskSide>>,
    accuracy: Accuracy,
}

/// A point of the region, the derivative in the chart that knew it, and that chart.
type Known = (Complex64, Complex64, usize);

impl Charted {
    fn new(atlas: Atlas, region: RegionSide, accuracy: Accuracy) -> Self {
        let disks = vec![OnceLock::new(); atlas.charts.len()];
        Self { atlas, region, disks, accuracy }
    }

    #[inline]
    fn disk(&self, chart: usize) -> &DiskSide {
        self.disks[chart].get_or_init(|| self.build_disk(chart, &mut |_, _| true))
    }

    /// Of no use once `progress` has returned false.
    fn build_disk(&self, chart: usize, progress: Progress) -> DiskSide {
        DiskSide::new(&self.atlas, &self.region, chart, self.accuracy, progress)
    }

    /// Builds the way back for all charts.
    fn prepare(&self, progress: Progress) -> Result<()> {
        let count = self.disks.len() as f64;
        for (chart, disk) in self.disks.iter().enumerate().filter(|(_, disk)| disk.get().is_none()) {
            let mut part = |stage, fraction| progress(stage, (chart as f64 + fraction) / count);
            let built = unless_cancelled(&mut part, |progress| self.build_disk(chart, progress))?;
            // If another thread was first, its are the same.
            let _ = disk.set(built);
        }
        Ok(())
    }

    /// Asks charts until one knows the point.
    fn follow(
        &self,
        DiskPoint { mut chart, mut w }: DiskPoint,
        ask: impl Fn(usize, Complex64) -> Source,
    ) -> Option<Known> {
        for _ in 0..self.disks.len() {
            match ask(chart, w) {
                Source::Point(z, slope) => return Some((z, slope, chart)),
                Source::Walk(seed) => return Some(self.walk(chart, seed, w)),
                Source::Nowhere | Source::Crowded => break,
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
    fn walk(&self, chart: usize, seed: Pair, w: Complex64) -> Known {
        let (z, slope) = Inverter::new(&self.atlas, &self.region, chart, self.accuracy).point(seed, w);
        (z, slope, chart)
    }

    /// What all charts share with the first.
    fn shared_bytes(&self) -> usize {
        self.atlas.bytes() + self.region.bytes()
    }

    fn squares(&self) -> usize {
        self.region.squares() + self.disks.iter().filter_map(OnceLock::get).map(DiskSide::squares).sum::<usize>()
    }

    /// Bytes of memory, about.
    fn bytes(&self) -> usize {
        self.atlas.bytes()
            + self.region.bytes()
            + self.disks.iter().filter_map(OnceLock::get).map(DiskSide::bytes).sum::<usize>()
    }
}

impl Expansions {
    /// Builds the way to the disk of the first chart. Points as near to the boundary as `thickness` (scaled units) are on it.
    #[must_use]
    pub fn new(solution: &Solution, thickness: f64, options: &SolveOptions) -> Self {
        Self::build(solution, thickness, options, &mut |_, _| true)
    }

    /// [`Expansions::new`], unless `progress` cancels: then nothing is left of it.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn reporting(solution: &Solution, thickness: f64, options: &SolveOptions, progress: Progress) -> Result<Self> {
        unless_cancelled(progress, |progress| Self::build(solution, thickness, options, progress))
    }

    /// Of no use once `progress` has returned false.
    fn build(solution: &Solution, thickness: f64, options: &SolveOptions, progress: Progress) -> Self {
        let accuracy = Accuracy::of(solution);
        let atlas = Atlas::new(solution, thickness, options);
        let region = RegionSide::near(&solution.discretisation().boundary, &atlas, accuracy, progress);
        Self { near: Charted::new(atlas, region, accuracy), far: OnceLock::new(), accuracy }
    }

    /// All charts; those of the near side alone if they are all.
    fn far(&self) -> &Charted {
        if self.near.region.is_whole() {
            return &self.near;
        }
        self.far.get_or_init(|| self.build_far(&mut |_, _| true))
    }

    /// Of no use once `progress` has returned false.
    fn build_far(&self, progress: Progress) -> Charted {
        let mut atlas = self.near.atlas.clone();
        let region = self.near.region.with_far(&mut atlas, self.accuracy, progress);
        Charted::new(atlas, region, self.accuracy)
    }

    /// Builds everything, for all charts.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        self.near.prepare(progress)?;
        if self.near.region.is_whole() {
            return Ok(());
        }
        if self.far.get().is_none() {
            let built = unless_cancelled(progress, |progress| self.build_far(progress))?;
            // If another thread was first, its are the same.
            let _ = self.far.set(built);
        }
        self.far().prepare(progress)
    }

    /// Region → disk.
    #[inline]
    #[must_use]
    pub fn to_disk(&self, z: Complex64) -> Found<DiskPoint> {
        let found = match self.near.region.at(&self.near.atlas, z) {
            Found::Crowded => self.to_disk_far(z),
            near => near,
        };
        found.map(|(chart, w)| DiskPoint { chart, w })
    }

    /// Region → disk, where a cell of the first chart holds the point: most of a region.
    #[inline]
    #[must_use]
    pub fn to_disk_by_cell(&self, z: Complex64) -> Option<Complex64> {
        self.near.region.by_cell(z)
    }

    /// The derivative of [`Expansions::to_disk_by_cell`].
    #[inline]
    #[must_use]
    pub fn slope_by_cell(&self, z: Complex64) -> Option<Complex64> {
        self.near.region.slope_by_cell(z)
    }

    #[cold]
    fn to_disk_far(&self, z: Complex64) -> Found<(usize, Complex64)> {
        let far = self.far();
        far.region.at(&far.atlas, z)
    }

    /// Region → disk, with the derivative in the point's chart.
    #[inline]
    #[must_use]
    pub fn to_disk_with_slope(&self, z: Complex64) -> Found<(DiskPoint, Complex64)> {
        let found = match self.near.region.with_slope(&self.near.atlas, z) {
            Found::Crowded => self.to_disk_far_with_slope(z),
            near => near,
        };
        found.map(|(chart, w, slope)| (DiskPoint { chart, w }, slope))
    }

    #[cold]
    fn to_disk_far_with_slope(&self, z: Complex64) -> Found<(usize, Complex64, Complex64)> {
        let far = self.far();
        far.region.with_slope(&far.atlas, z)
    }

    /// Beside a vertex, where its own variable serves: the chart, and −i log(w/w₀) with the relative accuracy of the distance from
    /// it, w₀ being the vertex' image.
    #[must_use]
    pub fn beside(&self, vertex: usize, z: Complex64) -> Option<(usize, Complex64)> {
        let patch = self.patch_at(z)?;
        Some((patch.chart, patch.beside(vertex, z)?))
    }

    /// The inverse of [`Expansions::beside`] for a vertex that lies at `z` and a chart: the place, and its derivative by −i log w.
    #[must_use]
    pub fn from_beside(
        &self,
        (vertex, z): (usize, Complex64),
        chart: usize,
        angle: Complex64,
    ) -> Option<(Complex64, Complex64)> {
        self.patch_at(z).filter(|patch| patch.chart == chart)?.from_beside(vertex, angle)
    }

    fn patch_at(&self, z: Complex64) -> Option<&Patch> {
        self.near.region.patch_at(z).or_else(|| self.far().region.patch_at(z))
    }

    /// d(flat point)/d(point in its chart).
    #[inline]
    #[must_use]
    pub fn flat_slope(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 { Complex64::ONE } else { self.far().atlas.link(0, point.chart).slope(point.w) }
    }

    /// The point of the closed disk as a number.
    #[inline]
    #[must_use]
    pub fn flat(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 { point.w } else { onto_disk(self.far().atlas.link(0, point.chart).apply(point.w)) }
    }

    /// Disk → region; `None` outside the closed disk.
    #[inline]
    #[must_use]
    pub fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.source(point, |side, w| side.at(w)).map(|(z, _, _)| z)
    }

    /// Disk → region, where a cell of the first chart holds the point: most of the disk.
    #[inline]
    #[must_use]
    pub fn from_disk_by_cell(&self, w: Complex64) -> Option<Complex64> {
        if w.norm_sqr() <= 1.0 { self.near.disk(0).by_cell(w) } else { None }
    }

    /// Disk → region, with the derivative by the point's number in its chart.
    #[inline]
    #[must_use]
    pub fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        let (z, slope, chart) = self.source(point, |side, w| side.with_slope(w))?;
        if chart == point.chart {
            return Some((z, slope));
        }
        Some((z, slope * self.far().atlas.link(chart, point.chart).slope(point.w)))
    }

    /// Where a point of the disk comes from.
    #[inline]
    fn source(&self, point: DiskPoint, ask: impl Fn(&DiskSide, Complex64) -> Source) -> Option<Known> {
        if is_outside_disk(point.w) {
            return None;
        }
        let point = point.map(onto_disk);
        if point.chart == 0
            && let Source::Point(z, slope) = ask(self.near.disk(0), point.w)
        {
            return Some((z, slope, 0));
        }
        let all = self.far();
        all.follow(point, |chart, w| ask(all.disk(chart), w))
    }

    /// A place where parts of the region are crowded together most, if that had to be accepted anywhere.
    #[must_use]
    pub fn crowded(&self) -> Option<Complex64> {
        self.far().region.crowded()
    }

    /// The charts seen from the first.
    #[must_use]
    pub fn positions(&self) -> &[Position] {
        &self.far().atlas.positions
    }

    /// The charts seen from where the first of them lies at `first`.
    #[must_use]
    pub fn positions_from(&self, first: Position) -> Vec<Position> {
        self.far().atlas.positions_from(first)
    }

    /// Number of centers that have a chart so far.
    fn charts(&self) -> usize {
        self.far.get().unwrap_or(&self.near).atlas.charts.len()
    }

    /// Squares that were looked at so far, of the region and of the disks: the work of building.
    fn squares(&self) -> usize {
        self.near.squares() + self.far.get().map_or(0, Charted::squares)
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.near.bytes() + self.far.get().map_or(0, |far| far.bytes() - self.near.shared_bytes())
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
