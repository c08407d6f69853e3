//! Disk → region, for one chart: a quadtree of Taylor polynomials of the inverse, and of arcs where Newton's method on a
//! patch's series takes over.

use super::atlas::{Atlas, MAX_COEFFICIENTS};
use super::quadtree::{MAX_LEVEL, Quadtree, Square, Step};
use super::region_side::{Cells, RegionSide};
use super::{Accuracy, Leaf};
use crate::plane::Complex64;
use std::f64::consts::{SQRT_2, TAU};
use std::rc::Rc;

/// The inverse of one chart's map, or the chart to ask instead.
#[derive(Clone, Debug)]
pub struct DiskSide {
    tree: Quadtree,
    cells: Cells,
}

/// Where a point of the disk comes from.
pub enum Source {
    /// The point of the region, and dz/dw if it was asked for.
    Point(Complex64, Complex64),
    /// Another chart knows better.
    Chart(usize),
    /// Outside the disk.
    Nowhere,
}

/// A cell's radius, as a share of the distance to the circle, at which its polynomial is tried.
const SHARE_OF_CIRCLE: f64 = 0.6;
/// Samples on a cell's circle.
const SAMPLES: usize = 32;
/// Another chart takes over where it stretches by this much more; well beyond the middle between two centers.
const TAKE_OVER: f64 = 40.0;
/// More squares are not split; what is left is Newton's method on the nearest patch.
const MAX_SQUARES: usize = 400_000;

/// Radius of a series of which only the first two coefficients count.
const SMALL: f64 = 1e-12;

/// Pairs (w, z) that are known.
type Seeds = Rc<Vec<(Complex64, Complex64)>>;

impl DiskSide {
    /// Builds the inverse of a chart's map.
    #[must_use]
    pub fn new(atlas: &Atlas, region: &mut RegionSide, chart: usize, size: f64, accuracy: Accuracy) -> Self {
        let mut tree = Quadtree::new(Complex64::ZERO, 1.01);
        let seeds: Vec<(Complex64, Complex64)> = region
            .cells
            .centers()
            .map(|(z, w, own)| (atlas.link(chart, own).apply(w), z))
            .filter(|(w, _)| w.norm_sqr() < 1.0)
            .collect();
        let start = seeds.iter().copied().min_by(|a, b| a.0.norm_sqr().total_cmp(&b.0.norm_sqr()));
        let noise = accuracy.solve_error;
        let turns = std::array::from_fn(|k| Complex64::cis(TAU * k as f64 / SAMPLES as f64));
        let mut builder =
            Builder { atlas, region, chart, accuracy, size, cells: Cells::default(), turns, squares: 0, noise };
        let nowhere = (Complex64::ZERO, Complex64::ZERO);
        let data = (Rc::new(seeds), start.unwrap_or(nowhere));
        tree.grow(tree.root(), data, &mut |square, data| builder.decide(square, &data));
        tree.finish();
        Self { tree, cells: builder.cells }
    }

    /// w → z, for w in the closed disk, up to rounding.
    #[inline]
    #[must_use]
    pub fn at(&self, region: &RegionSide, w: Complex64) -> Source {
        let leaf = self.tree.find(w).map_or(Leaf::Outside, Leaf::from);
        match leaf {
            Leaf::Cell(index) => Source::Point(self.cells.value(index, w).1, Complex64::ZERO),
            Leaf::Patch(index) => {
                let patch = &region.patches.list[index as usize];
                Source::Point(patch.zone.point(patch.straightened(w)), Complex64::ZERO)
            }
            Leaf::Outside => Source::Nowhere,
            Leaf::Other(chart) => Source::Chart(chart as usize),
        }
    }

    /// w → (z, dz/dw).
    #[must_use]
    pub fn with_slope(&self, region: &RegionSide, w: Complex64) -> Source {
        let leaf = self.tree.find(w).map_or(Leaf::Outside, Leaf::from);
        match leaf {
            Leaf::Cell(index) => {
                let (_, z, slope) = self.cells.value_and_slope(index, w);
                Source::Point(z, slope)
            }
            Leaf::Patch(index) => {
                let patch = &region.patches.list[index as usize];
                let tau = patch.straightened(w);
                Source::Point(patch.zone.point(tau), patch.inverse_slope(tau, w))
            }
            _ => self.at(region, w),
        }
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.tree.bytes() + self.cells.bytes()
    }
}

struct Builder<'a> {
    atlas: &'a Atlas,
    region: &'a mut RegionSide,
    chart: usize,
    accuracy: Accuracy,
    size: f64,
    squares: usize,
    /// By how much neighbouring expansions may differ, in the disk.
    noise: f64,
    cells: Cells,
    /// Roots of unity.
    turns: [Complex64; SAMPLES],
}

/// Whether other charts serve a square better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Taken {
    Not,
    /// A part of it.
    Partly,
    /// All of it, this one best.
    Whole(usize),
}

type Known = (Seeds, (Complex64, Complex64));

impl Builder<'_> {
    fn decide(&mut self, square: Square, (seeds, start): &Known) -> Step<Known> {
        let radius = square.half * SQRT_2;
        let distance = square.center.norm();
        self.squares += 1;
        if distance - radius > 1.0 {
            return Step::Leaf(Leaf::Outside.into());
        }
        match self.other_chart(square, radius) {
            Taken::Whole(chart) => return Step::Leaf(Leaf::Other(chart as u32).into()),
            Taken::Partly if square.level < MAX_LEVEL => return self.split(square, seeds, *start),
            _ => {}
        }
        if radius <= SHARE_OF_CIRCLE * (1.0 - distance) {
            if let Some(leaf) = self.taylor(square.center, radius, seeds, *start) {
                return Step::Leaf(leaf.into());
            }
        } else if distance > 0.5
            && let Some(index) = self.arc(square)
        {
            return Step::Leaf(Leaf::Patch(index).into());
        }
        if square.level == MAX_LEVEL || self.squares > MAX_SQUARES {
            return match self.nearest_patch(square.center) {
                Some(index) if distance > 0.5 => Step::Leaf(Leaf::Patch(index).into()),
                _ => Step::Leaf(Leaf::Outside.into()),
            };
        }
        self.split(square, seeds, *start)
    }

    fn split(&self, square: Square, seeds: &Seeds, start: (Complex64, Complex64)) -> Step<Known> {
        let reach = 1.5 * square.half;
        let near = |w: &Complex64| {
            let d = w - square.center;
            d.re.abs() <= reach && d.im.abs() <= reach
        };
        let kept: Vec<_> = seeds.iter().copied().filter(|(w, _)| near(w)).collect();
        let closest = nearest_seed(&kept, square.center).unwrap_or(start);
        Step::Split((Rc::new(kept), closest))
    }

    /// Whether another chart should be asked for this square.
    fn other_chart(&self, square: Square, radius: f64) -> Taken {
        let center = square.center / square.center.norm().max(1.0);
        let mut best = (TAKE_OVER, Taken::Not);
        for to in (0..self.atlas.charts.len()).filter(|&to| to != self.chart) {
            let (least, most) = self.atlas.link(to, self.chart).stretch_within(center, radius);
            if least > best.0 {
                best = (least, Taken::Whole(to));
            } else if most > TAKE_OVER.max(4.0 * least) && best.1 == Taken::Not {
                best.1 = Taken::Partly;
            }
        }
        best.1
    }

    fn taylor(&mut self, center: Complex64, radius: f64, seeds: &Seeds, start: (Complex64, Complex64)) -> Option<Leaf> {
        let seed = nearest_seed(seeds, center).unwrap_or(start);
        let (mut z, slope) = self.walk(seed, center)?;
        let middle = z;
        z += slope * radius;
        let mut samples = [Complex64::ZERO; SAMPLES];
        for (k, sample) in samples.iter_mut().enumerate() {
            let direction = self.turns[k];
            let w = center + direction * radius;
            let (exact, slope) = match self.newton(w, z) {
                Some(found) => found,
                None => self.walk((center, middle), w)?,
            };
            *sample = exact;
            z = exact + slope * direction * (self.turns[1] - 1.0) * radius;
        }
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        let coefficients = &mut coefficients[..self.accuracy.cell_terms().min(SAMPLES / 2 + 4)];
        for (k, coefficient) in coefficients.iter_mut().enumerate() {
            let turn = |j: usize| self.turns[(j * k) % SAMPLES].conj();
            let sum: Complex64 = samples.iter().enumerate().map(|(j, z)| (z - middle) * turn(j)).sum();
            *coefficient = sum / SAMPLES as f64;
        }
        coefficients[0] += middle;
        let tolerance = self.accuracy.tolerance * self.size;
        let noise = self.noise * slope.norm();
        let count = self
            .accuracy
            .terms_needed(coefficients, tolerance)
            .or_else(|| self.accuracy.terms_above_noise(coefficients, noise))?;
        Some(Leaf::Cell(self.cells.add(center, radius, self.chart, &coefficients[..count])))
    }

    /// From a known pair to the point over `w`, in steps over which the inverse is nearly linear.
    fn walk(&self, (mut at, mut z): (Complex64, Complex64), w: Complex64) -> Option<(Complex64, Complex64)> {
        let mut slope = self.forward(z)?.1.inv();
        for _ in 0..200 {
            let room = 0.3 * (1.0 - at.norm_sqr()).min(1.0);
            let step = w - at;
            let length = step.norm();
            let next = if length <= room { w } else { at + step * (room / length) };
            (z, slope) = self.newton(next, z + (next - at) * slope)?;
            at = next;
            if next == w {
                return Some((z, slope));
            }
        }
        None
    }

    /// Newton's method for f(z) = w; returns z and dz/dw.
    fn newton(&self, w: Complex64, mut z: Complex64) -> Option<(Complex64, Complex64)> {
        let mut last = f64::INFINITY;
        for _ in 0..20 {
            let (value, slope) = self.forward(z)?;
            let inverse = slope.inv();
            let step = (w - value) * inverse;
            let size = step.norm();
            z += step;
            // Quadratic convergence: the next step would be below rounding. Or rounding is all there is, or two expansions
            // that meet here differ by more.
            let converged = size <= 1e-9 * self.size && size < 1e-4 * last;
            let stagnates = size >= 0.5 * last && size <= (1e-12 * self.size).max(self.noise * inverse.norm());
            if converged || stagnates || size <= 1e-15 * self.size {
                return Some((z, inverse));
            }
            if size > 4.0 * last {
                return None;
            }
            last = size;
        }
        None
    }

    fn forward(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let (own, w, slope) = self.region.with_slope(self.atlas, z)?;
        if own == self.chart {
            return Some((w, slope));
        }
        // The link is only as exact as two solves; this chart's own series is smooth beyond its home.
        let mut coefficients = [Complex64::ZERO; 2];
        self.atlas.charts[self.chart].expand(z, SMALL, &mut coefficients);
        Some((coefficients[0], coefficients[1] / SMALL))
    }

    /// The patch whose middle is nearest along the circle.
    fn nearest_patch(&mut self, w: Complex64) -> Option<u32> {
        self.candidates(w).first().map(|&zone| self.region.patches.get(self.atlas, self.chart, zone))
    }

    /// A patch whose zone holds all that the square shows of the region.
    fn arc(&mut self, square: Square) -> Option<u32> {
        for zone in self.candidates(square.center) {
            let index = self.region.patches.get(self.atlas, self.chart, zone);
            let patch = &self.region.patches.list[index as usize];
            let holds = |(x, y): (f64, f64)| {
                let w = square.center + Complex64::new(x, y) * square.half;
                let size = w.norm();
                let w = if size > 1.0 { w / size } else { w };
                let tau = patch.straightened(w);
                tau.norm_sqr() <= 1.0 && tau.im >= 0.0 && patch.leads_to(tau, w)
            };
            let spots = [-1.0, -0.5, 0.0, 0.5, 1.0];
            if spots.into_iter().all(|y| spots.into_iter().all(|x| holds((x, y)))) {
                return Some(index);
            }
        }
        None
    }

    /// Zones near an angle on the circle, nearest first.
    fn candidates(&self, w: Complex64) -> Vec<usize> {
        let zones = &self.atlas.charts[self.chart].zones;
        let measure = (w.arg() / TAU).rem_euclid(1.0);
        let after = zones.measures.partition_point(|m| *m <= measure);
        let count = zones.list.len();
        let mut near: Vec<usize> = (0..4).map(|k| (after + count + k - 2) % count).collect();
        let away = |zone: usize| {
            let d = zones.measures[zone] - measure;
            (d - d.round()).abs()
        };
        near.sort_by(|&a, &b| away(a).total_cmp(&away(b)));
        near.dedup();
        near
    }
}

fn nearest_seed(seeds: &[(Complex64, Complex64)], w: Complex64) -> Option<(Complex64, Complex64)> {
    seeds.iter().copied().min_by(|a, b| (a.0 - w).norm_sqr().total_cmp(&(b.0 - w).norm_sqr()))
}
