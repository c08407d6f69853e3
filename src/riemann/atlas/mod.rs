//! The map as a function, both ways, a million points at a time.
//!
//! ```text
//! solution ─► atlas: charts (one for each center), links ─► region side: cells and patches ─► disk side, one a chart
//! ```
//! A cell is a square with a Taylor polynomial; the potential's series comes from multipole expansions. A patch is a zone
//! beside the boundary with one real power series in the variable that straightens the boundary, so that the walls are
//! exact and corners harmless. Where the map of the region's own center crowds everything together, further centers have
//! charts of their own, linked by automorphisms of the disk.
//!
//! A point of the disk is a number in the chart that tells it apart best. Each chart also knows its [`frame`], the place of
//! its center in the hyperbolic plane, in a form that distance does not blur; from the frames of two regions comes the
//! [`passage`] from one's charts to the other's.

mod charts;
mod disk_builder;
mod disk_side;
mod evaluator;
mod fit;
mod frame;
mod inverse_cell;
mod link;
mod one_by_one;
mod passage;
mod patch;
mod power_series;
mod quadtree;
mod region_side;
mod walls;
mod zone;

use crate::plane::Complex64;
use crate::symm::options::SolveOptions;
use crate::symm::solution::Solution;
use charts::Atlas;
use disk_side::{DiskSide, Source};
pub use evaluator::Evaluator;
use frame::Frame;
use one_by_one::Seeds;
pub use passage::{Compass, Passage};
use region_side::RegionSide;
use std::fmt;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How accurate expansions should be.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// Largest error of an expansion: of w in the unit disk, of z relative to the region's size.
    tolerance: f64,
    /// The solve's own.
    solve_error: f64,
}

/// Expansions err by at most this share of the solve.
const SHARE_OF_ERROR: f64 = 0.03;
/// And by no more than this, so that the loosest solve's map is still smooth and goes both ways.
const LARGEST_ERROR: f64 = 1e-3;

impl Accuracy {
    fn of(solution: &Solution) -> Self {
        Self {
            tolerance: (SHARE_OF_ERROR * solution.error_estimate).clamp(1e-13, LARGEST_ERROR),
            solve_error: solution.error_estimate,
        }
    }

    fn digits(self) -> f64 {
        -self.tolerance.log10()
    }

    /// Degree of a patch's series, whose terms fall like 0.4ᵏ.
    fn patch_degree(self) -> usize {
        (2.2 * self.digits()).ceil().max(LEAST_DEGREE) as usize
    }

    /// Most coefficients of a cell's polynomial.
    fn cell_terms(self) -> usize {
        (12 + self.digits() as usize).min(24)
    }

    /// How many coefficients are needed for a tolerance; `None` if there are too few.
    fn terms_needed(self, coefficients: &[Complex64], tolerance: f64) -> Option<usize> {
        let mut count = coefficients.len();
        // What lies beyond the end is about as large as the last two.
        let mut tail = coefficients[count - 1].norm() + coefficients[count - 2].norm();
        if tail.is_nan() || tail > 0.5 * tolerance {
            return None;
        }
        while count > 2 {
            tail += coefficients[count - 1].norm();
            if tail > tolerance {
                break;
            }
            count -= 1;
        }
        Some(count)
    }

    /// How many coefficients say something, if the last ones do not fall any more but are `noise`: where charts and patches
    /// meet, samples jump by a part of the solve's error.
    fn terms_above_noise(self, coefficients: &[Complex64], noise: f64) -> Option<usize> {
        let largest = |part: &[Complex64]| part.iter().map(|c| c.norm()).fold(0.0, f64::max);
        let quarter = coefficients.len() / 4;
        let last = largest(&coefficients[coefficients.len() - quarter..]);
        let before = largest(&coefficients[coefficients.len() - 2 * quarter..coefficients.len() - quarter]);
        if !(last <= noise && last >= FLAT * before) {
            return None;
        }
        let kept = coefficients.iter().rposition(|c| c.norm() > 2.0 * last)?;
        Some((kept + 1).max(2))
    }
}

/// Coefficients of an analytic function fall by more than this over a quarter of them.
const FLAT: f64 = 0.3;

/// Of a patch's series: as many terms as the first guess of its inverse has.
const LEAST_DEGREE: f64 = 6.0;

/// What a leaf of a tree says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Leaf {
    Cell(u32),
    Patch(u32),
    Outside,
    /// On the region's side: sum directly, for this chart. On the disk's: ask this chart.
    Other(u32),
}

impl From<u32> for Leaf {
    #[inline]
    fn from(number: u32) -> Self {
        match number & 3 {
            0 => Self::Cell(number >> 2),
            1 => Self::Patch(number >> 2),
            2 => Self::Other(number >> 2),
            _ => Self::Outside,
        }
    }
}

impl From<Leaf> for u32 {
    fn from(leaf: Leaf) -> Self {
        match leaf {
            Leaf::Cell(index) => index << 2,
            Leaf::Patch(index) => index << 2 | 1,
            Leaf::Other(chart) => chart << 2 | 2,
            Leaf::Outside => 3,
        }
    }
}

/// A point of the closed disk in the chart where it is told apart best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiskPoint {
    chart: usize,
    w: Complex64,
}

impl DiskPoint {
    /// No point.
    pub const NOWHERE: Self = Self { chart: 0, w: Complex64::new(f64::NAN, f64::NAN) };

    /// The nearest point of the circle.
    pub(super) fn onto_circle(self) -> Self {
        Self { w: self.w / self.w.norm(), ..self }
    }

    /// A point that is given by a number.
    pub(super) fn flat(w: Complex64) -> Self {
        Self { chart: 0, w }
    }
}

/// The maps region ↔ disk of a polygon's solution, with vertex 0 ↦ 1, in scaled units.
pub struct Expansions {
    atlas: Atlas,
    region: RegionSide,
    /// One a chart, built when it is first asked.
    disks: Vec<OnceLock<DiskSide>>,
    /// One a chart, for as long as few points are asked for.
    seeds: Vec<OnceLock<Seeds>>,
    asked: AtomicUsize,
    accuracy: Accuracy,
}

impl Expansions {
    /// Builds the way to the disk; the way back is built chart by chart, where it is first asked for.
    #[must_use]
    pub fn new(solution: &Solution, options: &SolveOptions) -> Self {
        let boundary = &solution.discretisation().boundary;
        let accuracy = Accuracy::of(solution);
        let mut atlas = Atlas::new(solution, options);
        let region = RegionSide::new(boundary, &mut atlas, accuracy);
        let disks = vec![OnceLock::new(); atlas.charts.len()];
        let seeds = vec![OnceLock::new(); atlas.charts.len()];
        Self { atlas, region, disks, seeds, asked: AtomicUsize::new(0), accuracy }
    }

    /// Builds the way back for all charts.
    pub fn prepare(&self) {
        for chart in 0..self.disks.len() {
            self.disk(chart);
        }
    }

    #[inline]
    fn disk(&self, chart: usize) -> &DiskSide {
        self.disks[chart].get_or_init(|| DiskSide::new(&self.atlas, &self.region, chart, self.accuracy))
    }

    /// Disk → region by one chart. Few points are inverted one by one; who asks for many gets a tree.
    #[inline]
    fn ask(&self, chart: usize, w: Complex64) -> Source {
        match self.disks[chart].get() {
            Some(disk) => disk.at(w),
            None => self.ask_one(chart, w).unwrap_or_else(|| self.disk(chart).at(w)),
        }
    }

    #[cold]
    fn ask_one(&self, chart: usize, w: Complex64) -> Option<Source> {
        if self.asked.fetch_add(1, Ordering::Relaxed) >= FEW {
            return None;
        }
        let seeds = self.seeds[chart].get_or_init(|| Seeds::new(&self.atlas, &self.region, chart));
        seeds.at(&self.atlas, &self.region, chart, self.accuracy, w)
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

    /// The point as a number.
    #[inline]
    #[must_use]
    pub fn flat(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 { point.w } else { onto_disk(self.atlas.link(0, point.chart).apply(point.w)) }
    }

    /// Disk → region; `None` outside the closed disk.
    #[inline]
    #[must_use]
    pub fn to_region(&self, point: DiskPoint) -> Option<Complex64> {
        self.follow(point, |chart, w| self.ask(chart, w)).map(|(z, _, _)| z)
    }

    /// Disk → region, with the derivative by the point's number in its chart.
    #[inline]
    #[must_use]
    pub fn to_region_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        let (z, slope, chart) = self.follow(point, |chart, w| self.disk(chart).with_slope(w))?;
        if chart == point.chart {
            return Some((z, slope));
        }
        Some((z, slope * self.atlas.link(chart, point.chart).slope(point.w)))
    }

    /// The charts seen from the first.
    #[must_use]
    pub fn frames(&self) -> &[Frame] {
        &self.atlas.frames
    }

    /// Asks charts until one knows the point: it, the derivative in the chart that knew, and that chart.
    #[inline]
    fn follow(
        &self,
        DiskPoint { mut chart, mut w }: DiskPoint,
        ask: impl Fn(usize, Complex64) -> Source,
    ) -> Option<(Complex64, Complex64, usize)> {
        if w.is_nan() || w.norm_sqr() > BEYOND_CIRCLE {
            return None;
        }
        for _ in 0..=self.disks.len() {
            match ask(chart, w) {
                Source::Point(z, slope) => return Some((z, slope, chart)),
                Source::Nowhere => return None,
                Source::Chart(next) => {
                    // Rounding may have put it outside, and what is far away from the next center becomes large there.
                    w = onto_disk(self.atlas.link(next, chart).apply(w));
                    chart = next;
                }
            }
        }
        None
    }

    /// Number of centers that have a chart.
    #[must_use]
    pub fn charts(&self) -> usize {
        self.disks.len()
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.atlas.bytes()
            + self.region.bytes()
            + self.disks.iter().filter_map(OnceLock::get).map(DiskSide::bytes).sum::<usize>()
    }
}

/// So many points cost about as much one by one as through an easy region's tree.
const FEW: usize = 10_000;
/// |w|² of points that are on the circle up to rounding.
const BEYOND_CIRCLE: f64 = 1.0 + 8.0 * f64::EPSILON;

/// The point of the closed disk nearest to `w`.
fn onto_disk(w: Complex64) -> Complex64 {
    let square = w.norm_sqr();
    if square > 1.0 { w / square.sqrt() } else { w }
}

impl fmt::Debug for Expansions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Expansions")
            .field("charts", &self.charts())
            .field("bytes", &self.bytes())
            .finish_non_exhaustive()
    }
}
