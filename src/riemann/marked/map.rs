//! Maps of a region that marked boundary points make unique: its disk, chart by chart, taken on to another region.

use super::super::RiemannMap;
use super::super::atlas::DiskPoint;
use super::super::both_ways::Pointwise;
use super::super::near_one::{exp_m1, ln_1p};
use super::super::rounding::{is_on_circle, onto_disk};
use super::marks::Marks;
use crate::plane::{Complex64, NOWHERE};

/// A mark, and a point of its home chart less the mark, with the relative accuracy of that distance.
pub type Gap = (usize, Complex64);

/// A point of a chart's disk, and what is known of it beside a mark that is a vertex.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// The chart.
    pub chart: usize,
    /// The point.
    pub w: Complex64,
    /// Beside a mark.
    pub gap: Option<Gap>,
}

impl Seen {
    /// w less a mark.
    #[inline]
    #[must_use]
    pub fn less(&self, marks: &Marks, mark: usize) -> Complex64 {
        match self.gap {
            Some((near, gap)) if near == mark => gap,
            _ => self.w - marks.at(self.chart, mark),
        }
    }
}

/// What a disk with marks is taken to.
pub trait Target {
    /// A point of it, prepared for being sought in every chart.
    type Key;

    /// The image of a point of the disk, and the derivative by the number of its chart.
    fn image(&self, marks: &Marks, seen: &Seen) -> (Complex64, Complex64);

    /// A point of the target; `None` outside. Also whether it is of the boundary.
    fn key(&self, image: Complex64) -> Option<(Self::Key, bool)>;

    /// Where a chart's disk has it.
    fn in_chart(&self, marks: &Marks, key: &Self::Key, chart: usize) -> Complex64;

    /// How much the image moves when the point does in a chart, up to a factor that charts share: the chart in which this is least
    /// tells points apart best. Nothing here may depend on numbers that crowd together.
    fn slope(&self, key: &Self::Key, chart: usize) -> f64;

    /// Where the home chart of a mark has it, if it is beside one.
    fn beside(&self, marks: &Marks, key: &Self::Key) -> Option<Gap>;
}

/// The map region → target.
#[derive(Clone, Debug)]
pub struct MarkedMap<T> {
    map: RiemannMap,
    marks: Marks,
    target: T,
}

/// Distances on the circle below which a vertex' own variable is used.
const BESIDE: f64 = 0.3;
/// Where a derivative is taken for a corner, in units of the region's size.
const OFF_CORNER: f64 = 1e-9;

impl<T: Target> MarkedMap<T> {
    /// A map through a region's disk.
    #[must_use]
    pub fn new(map: &RiemannMap, marks: Marks, target: T) -> Self {
        Self { map: map.clone(), marks, target }
    }

    /// The map region → disk.
    #[must_use]
    pub fn disk(&self) -> &RiemannMap {
        &self.map
    }

    /// The target.
    #[must_use]
    pub fn target(&self) -> &T {
        &self.target
    }

    fn value_and_slope(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let (point, slope) = self.map.solved().to_disk_with_slope(z)?;
        let (value, onward) = self.target.image(&self.marks, &self.seen(z, point));
        Some((value, onward * slope))
    }

    fn seen(&self, z: Complex64, point: DiskPoint) -> Seen {
        let DiskPoint { chart, w } = if is_on_circle(point.w) { point.onto_circle() } else { point };
        for (index, mark) in self.marks.list().iter().enumerate() {
            let Some(vertex) = mark.vertex.filter(|_| mark.home == chart) else { continue };
            let there = self.marks.at(chart, index);
            if (w - there).norm_sqr() < BESIDE * BESIDE
                && let Some((known, angle)) = self.map.solved().beside(vertex, z)
                && known == chart
            {
                let gap = there * exp_m1(Complex64::new(-angle.im, angle.re));
                return Seen { chart, w: there + gap, gap: Some((index, gap)) };
            }
        }
        Seen { chart, w, gap: None }
    }

    /// w → (z, dz/dw); `None` outside the closed target.
    pub fn inverse(&self, image: Complex64) -> Option<(Complex64, Complex64)> {
        let (key, is_boundary) = self.target.key(image)?;
        if let Some((z, slope, seen)) = self.from_beside(&key, is_boundary) {
            return Some((z, slope / self.target.image(&self.marks, &seen).1));
        }
        let slopes = (0..self.marks.charts()).map(|chart| (chart, self.target.slope(&key, chart)));
        let (chart, _) = slopes.filter(|(_, slope)| !slope.is_nan()).min_by(|a, b| a.1.total_cmp(&b.1))?;
        let w = self.target.in_chart(&self.marks, &key, chart);
        let w = if is_boundary { w / w.norm() } else { onto_disk(w) };
        let (z, slope) = self.map.solved().from_disk_with_slope(DiskPoint { chart, w })?;
        Some((z, slope / self.target.image(&self.marks, &Seen { chart, w, gap: None }).1))
    }

    /// The place of a point beside a mark by the variable of the vertex that the mark is, and its derivative by w.
    fn from_beside(&self, key: &T::Key, is_boundary: bool) -> Option<(Complex64, Complex64, Seen)> {
        let (index, gap) = self.target.beside(&self.marks, key).filter(|(_, gap)| gap.norm_sqr() < BESIDE * BESIDE)?;
        let mark = &self.marks.list()[index];
        let there = self.marks.at(mark.home, index);
        let log = ln_1p(gap / there);
        let depth = if is_boundary { 0.0 } else { (-log.re).max(0.0) };
        let (z, slope) = self.map.solved().from_beside(mark.vertex?, mark.home, Complex64::new(log.im, depth))?;
        let w = there + gap;
        Some((z, slope / (Complex64::i() * w), Seen { chart: mark.home, w, gap: Some((index, gap)) }))
    }
}

impl<T: Target> Pointwise for MarkedMap<T> {
    fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let (value, slope) = self.value_and_slope(z)?;
        if !slope.is_nan() {
            return Some((value, slope));
        }
        // At a corner itself: a little beside it.
        let h = OFF_CORNER * self.map.region().polygon().size();
        let near = (0..8).map(|k| z + Complex64::from_polar(h, f64::from(k) * std::f64::consts::FRAC_PI_4));
        let slope = near.filter_map(|z| self.value_and_slope(z)).map(|(_, slope)| slope).find(|slope| !slope.is_nan());
        Some((value, slope.unwrap_or(NOWHERE)))
    }

    fn value(&self, z: Complex64) -> Option<Complex64> {
        self.value_and_slope(z).map(|(w, _)| w)
    }
}
