//! How the disk is cut into cells and arcs for the inverse of one chart's map.

use super::accuracy::Accuracy;
use super::cells::Cells;
use super::charts::{Atlas, Taken};
use super::inverse_cell::{Inverter, Pair};
use super::leaf::Leaf;
use super::patch::Patch;
use super::patches::Patches;
use super::quadtree::{MAX_LEVEL, Quadtree, Square, Step, Watch};
use super::region_builder::LEAST_SLOPE;
use super::region_side::RegionSide;
use crate::plane::{Complex64, sort_by_number};
use crate::symm::options::Progress;
use std::f64::consts::{SQRT_2, TAU};
use std::rc::Rc;

/// A cell's radius, as a share of the distance to the circle, at which its polynomial is tried.
const SHARE_OF_CIRCLE: f64 = 0.6;
/// A polynomial must fit a cell whose radius is at most this share: the inverse is univalent in the disk that touches the
/// circle, so that its coefficients there are |aₖ| ≤ k|a₁| (de Branges), and all there is beyond is noise.
const SURE_SHARE: f64 = 0.15;
/// Squares that any disk may have.
const FEWEST_SQUARES: usize = 4000;
/// Squares for each cell or zone of the region (measured: 1 to 4 are usual).
const SQUARES_PER_EXPANSION: usize = 16;
/// Points of the closed disk may lie this far outside.
const ROUNDING: f64 = 1e-14;
/// Squares whose center is nearer to 0 than this are never left to a patch.
const NO_ARC_WITHIN: f64 = 0.5;

/// What the inverse of a chart's map is cut into.
#[derive(Clone, Debug)]
pub struct DiskParts {
    /// The squares.
    pub tree: Quadtree,
    /// Polynomials.
    pub cells: Cells,
    /// Boundary zones.
    pub patches: Vec<Patch>,
    /// Where walks to points start that no expansion reaches.
    pub seeds: Vec<Pair>,
}

/// Cuts a chart's disk. The squares number at most [`FEWEST_SQUARES`] and [`SQUARES_PER_EXPANSION`] for each cell and zone of
/// the region, which are in proportion to its vertices. Once `progress` has returned false nothing more is cut, and the rest is of
/// no use.
#[must_use]
pub fn build(atlas: &Atlas, region: &RegionSide, chart: usize, accuracy: Accuracy, progress: Progress) -> DiskParts {
    let mut tree = Quadtree::new(Complex64::ZERO, 1.01);
    let seeds: Vec<Pair> = region
        .centers()
        .map(|(z, w, own)| (atlas.link(chart, own).apply(w), z))
        .filter(|(w, _)| w.norm_sqr() < 1.0)
        .collect();
    let center = (Complex64::ZERO, atlas.charts[chart].center());
    let mut builder = Builder {
        atlas,
        inverter: Inverter::new(atlas, region, chart, accuracy),
        chart,
        squares: FEWEST_SQUARES + SQUARES_PER_EXPANSION * (region.cells() + atlas.charts[chart].zones.list.len()),
        cells: Cells::default(),
        patches: region.patches_of(chart),
        alone: atlas.charts.len() == 1,
        size: region.size(),
        seeds: Vec::new(),
    };
    let mut watch = Watch::default();
    tree.grow(tree.root(), (Rc::new(seeds), center), &mut |square, known| {
        watch.step(square, Leaf::Outside.into(), progress, || builder.decide(square, &known))
    });
    tree.finish();
    DiskParts { tree, cells: builder.cells, patches: builder.patches.list, seeds: builder.seeds }
}

struct Builder<'a> {
    atlas: &'a Atlas,
    inverter: Inverter<'a>,
    chart: usize,
    /// So many more may be looked at before the rest is left to walks.
    squares: usize,
    cells: Cells,
    patches: Patches,
    seeds: Vec<Pair>,
    /// Whether there is no chart but this.
    alone: bool,
    /// Of the region.
    size: f64,
}

/// Pairs (w, z) near a square, and the one nearest to it.
type Known = (Rc<Vec<Pair>>, Pair);

impl Builder<'_> {
    fn decide(&mut self, square: Square, known: &Known) -> Step<Known> {
        let radius = square.half * SQRT_2;
        let distance = square.center.norm();
        self.squares = self.squares.saturating_sub(1);
        if distance - radius > 1.0 + ROUNDING {
            return Step::Leaf(Leaf::Outside.into());
        }
        match self.atlas.taken_over(self.chart, square.center, radius) {
            Taken::Whole(chart) => return Step::Leaf(Leaf::Chart(chart as u32).into()),
            Taken::Partly if square.level < MAX_LEVEL => return split(square, known),
            _ => {}
        }
        let seed = || nearest_seed(&known.0, square.center).unwrap_or(known.1);
        let room = 1.0 - distance;
        if radius <= SHARE_OF_CIRCLE * room {
            if let Some(cell) = self.inverter.cell(square.center, radius, seed()) {
                let index = self.cells.add(cell.center, cell.radius, self.chart, cell.coefficients());
                return Step::Leaf(Leaf::Cell(index).into());
            }
        } else if distance > NO_ARC_WITHIN
            && let Some(index) = self.arc(square)
        {
            return Step::Leaf(Leaf::Patch(index).into());
        }
        if self.alone && self.is_crowded(square, seed()) {
            return Step::Leaf(Leaf::Crowded.into());
        }
        if radius <= SURE_SHARE * room || square.level == MAX_LEVEL || self.squares == 0 {
            self.seeds.push(seed());
            return Step::Leaf(Leaf::Walk(self.seeds.len() as u32 - 1).into());
        }
        split(square, known)
    }

    /// Whether the one chart that there is crowds together what the square shows: the middle of a square that is small against
    /// its distance from the circle, or the zone beside one that is not.
    fn is_crowded(&mut self, square: Square, seed: Pair) -> bool {
        let radius = square.half * SQRT_2;
        if radius <= SHARE_OF_CIRCLE * (1.0 - square.center.norm()) {
            return self.inverter.is_crowded(seed, square.center);
        }
        let Some(zone) = self.candidates(square.center).first().copied() else { return false };
        let index = self.patches.get(self.atlas, self.chart, zone);
        let patch = &self.patches.list[index as usize];
        radius <= patch.farthest() && patch.typical_slope() * self.size < LEAST_SLOPE
    }

    /// A patch whose zone holds all that the square shows of the region.
    fn arc(&mut self, square: Square) -> Option<u32> {
        let spot = |x: f64, y: f64| {
            let w = square.center + Complex64::new(x, y) * square.half;
            w / w.norm().max(1.0)
        };
        for zone in self.candidates(square.center) {
            let index = self.patches.get(self.atlas, self.chart, zone);
            let patch = &self.patches.list[index as usize];
            if [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].iter().any(|&(x, y)| patch.misses(spot(x, y))) {
                continue;
            }
            let holds = |w: Complex64| {
                let tau = patch.straightened(w);
                tau.norm_sqr() <= 1.0 && tau.im >= 0.0 && patch.leads_to(tau, w)
            };
            let spots = [-1.0, -0.5, 0.0, 0.5, 1.0];
            if spots.into_iter().all(|y| spots.into_iter().all(|x| holds(spot(x, y)))) {
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
        sort_by_number(&mut near, |&zone| away(zone));
        near.dedup();
        near
    }
}

/// The quarters know the pairs near them, and the nearest even if it is far.
fn split(square: Square, (seeds, start): &Known) -> Step<Known> {
    let reach = 1.5 * square.half;
    let near = |w: &Complex64| {
        let d = w - square.center;
        d.re.abs() <= reach && d.im.abs() <= reach
    };
    let kept: Vec<_> = seeds.iter().copied().filter(|(w, _)| near(w)).collect();
    let closest = nearest_seed(&kept, square.center).unwrap_or(*start);
    Step::Split((Rc::new(kept), closest))
}

fn nearest_seed(seeds: &[Pair], w: Complex64) -> Option<Pair> {
    seeds.iter().copied().min_by(|a, b| (a.0 - w).norm_sqr().total_cmp(&(b.0 - w).norm_sqr()))
}
