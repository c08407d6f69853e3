//! L and B in squares of a domain that polygons bound: power series, and real ones beside the walls.

use super::super::atlas::accuracy::Accuracy;
use super::super::atlas::cells::Cells;
use super::super::atlas::fit::Fit;
use super::super::atlas::leaf::Leaf;
use super::super::atlas::power_series::{MAX_COEFFICIENTS, rescale};
use super::super::atlas::quadtree::{Quadtree, Square, Step};
use super::super::atlas::walls::{Nearest, Walls};
use super::super::atlas::zone::Zones;
use super::cuts::Cuts;
use super::inside::{Ground, Inside};
use super::wall_patch::{Beside, WallPatch};
use crate::plane::Complex64;
use crate::symm::field::Field;
use crate::symm::local_series::LocalSeries;
use crate::symm::options::Progress;
use std::collections::HashMap;
use std::f64::consts::SQRT_2;
use std::fmt;
use std::sync::Arc;

/// The squares.
pub struct PolygonSquares {
    tree: Quadtree,
    cells: Cells,
    patches: Vec<WallPatch>,
}

/// A series is tried where the square's half diagonal is at most this share of the distance to the boundary,
const SHARE_OF_WALL: f64 = 0.9;
/// and this one of the distance to a corner where B is singular.
const SHARE_OF_CORNER: f64 = 0.6;
/// Sources are summed for a disk of at most this share of the distance to the boundary; the series goes on beyond.
const SHARE_OF_SUM: f64 = 0.5;
/// Squares are not smaller than the whole by more than 2 to this.
const DEEPEST: u32 = 30;
/// More expansions are not made.
const MOST: usize = 400_000;
/// Squares between two reports.
const SQUARES_PER_REPORT: usize = 128;
/// Errors of B weigh more where it hardly changes, but not by more than this.
const LEAST_SLOPE: f64 = 0.05;

impl PolygonSquares {
    /// Cuts them; of no use once `progress` has returned false.
    #[must_use]
    pub fn new(
        field: &Field,
        walls: Walls,
        series: LocalSeries,
        ground: Ground,
        accuracy: Accuracy,
        progress: Progress,
    ) -> Self {
        let boundary = field.boundary();
        let zones = Zones::new(boundary, &walls, &field.source.singularities(), |_| 0.0);
        let all = Arc::new(walls.all());
        let fit = Fit::new(accuracy.patch_degree(), accuracy.tolerance);
        let (numbers, patches) = (HashMap::new(), Vec::new());
        let mut builder = PolygonBuilder { field, walls, series, zones, fit, numbers, patches };
        let mut squares = Squares::new(accuracy, progress);
        let tree = Quadtree::new(ground.center, ground.half);
        let tree = squares.cut(tree, all, &mut |squares, square, walls| builder.decide(squares, square, &walls));
        Self { tree, cells: squares.cells, patches: builder.patches }
    }

    /// What is known of a point.
    #[inline]
    #[must_use]
    pub fn at(&self, z: Complex64) -> Inside {
        let Some(number) = self.tree.find(z) else { return Inside::Beyond };
        match Leaf::from(number) {
            Leaf::Cell(index) => {
                let (_, value, slope) = self.cells.value_and_slope(index, z);
                Inside::Log(value, slope)
            }
            Leaf::Patch(index) => match self.patches[index as usize].at(z) {
                Beside::Known(value, slope) => Inside::Whole(value, slope),
                Beside::Corner | Beside::Outside => Inside::Unknown,
            },
            Leaf::Outside => Inside::Outside,
            _ => Inside::Unknown,
        }
    }

    /// What is to be added to B there, to have it on the branch of direct summation.
    #[must_use]
    pub fn branch(&self, z: Complex64, [cuts, cuts_with_source]: [&Cuts; 2]) -> Complex64 {
        match self.tree.find(z).map(Leaf::from) {
            Some(Leaf::Cell(index)) => cuts.jump(self.cells.at(index, z).0.center, z),
            Some(Leaf::Patch(index)) => self.patches[index as usize].branch(z, cuts_with_source),
            _ => Complex64::ZERO,
        }
    }
}

/// Squares being cut.
struct Squares<'p> {
    accuracy: Accuracy,
    cells: Cells,
    progress: Progress<'p>,
    seen: usize,
    /// The share of the whole that is decided.
    done: f64,
    stopped: bool,
}

impl<'p> Squares<'p> {
    fn new(accuracy: Accuracy, progress: Progress<'p>) -> Self {
        Self { accuracy, cells: Cells::default(), progress, seen: 0, done: 0.0, stopped: false }
    }

    /// Cuts a tree, unless the caller wants no more.
    fn cut<T: Clone>(
        &mut self,
        mut tree: Quadtree,
        data: T,
        decide: &mut dyn FnMut(&mut Self, Square, T) -> Step<T>,
    ) -> Quadtree {
        let root = tree.root();
        tree.grow(root, data, &mut |square, data| {
            let report = self.seen.is_multiple_of(SQUARES_PER_REPORT);
            self.stopped = self.stopped || (report && !(self.progress)("expand", self.done));
            self.seen += 1;
            if self.stopped {
                return Step::Leaf(Leaf::Sum(0).into());
            }
            let step = decide(self, square, data);
            if matches!(step, Step::Leaf(_)) {
                self.done += 0.25f64.powi(square.level as i32);
            }
            step
        });
        tree.finish();
        tree
    }

    /// A power series of L, if it is accurate in the square; nothing of the boundary is nearer to its center than `clear`.
    fn series<T>(
        &mut self,
        square: Square,
        clear: f64,
        expand: &dyn Fn(Complex64, f64, &mut [Complex64]),
    ) -> Option<Step<T>> {
        let radius = square.half * SQRT_2;
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        let coefficients = &mut coefficients[..self.accuracy.cell_terms()];
        let unit = radius.min(SHARE_OF_SUM * clear);
        expand(square.center, unit, coefficients);
        rescale(coefficients, radius / unit);
        let slope = coefficients[1].norm() / radius;
        let count =
            self.accuracy.terms_needed(coefficients, self.accuracy.tolerance * slope.clamp(LEAST_SLOPE, 1.0))?;
        let index = self.cells.add(square.center, radius, 0, &coefficients[..count]);
        Some(Step::Leaf(Leaf::Cell(index).into()))
    }
}

type WallList = Arc<Vec<u32>>;

/// Decides on squares of a domain that polygons bound.
struct PolygonBuilder<'a> {
    field: &'a Field,
    walls: Walls,
    series: LocalSeries,
    zones: Zones,
    fit: Fit,
    /// The patches of zones.
    numbers: HashMap<usize, u32>,
    patches: Vec<WallPatch>,
}

impl PolygonBuilder<'_> {
    fn decide(&mut self, squares: &mut Squares, square: Square, walls: &WallList) -> Step<WallList> {
        let radius = square.half * SQRT_2;
        let nearest = self.walls.nearest(square.center, walls);
        if !nearest.inside && nearest.distance > radius + self.walls.thickness {
            return Step::Leaf(Leaf::Outside.into());
        }
        if nearest.inside && radius <= SHARE_OF_WALL * nearest.distance {
            let corner = self.walls.to_singular_vertex(square.center, walls);
            let expand =
                |center, radius, coefficients: &mut [Complex64]| self.series.expand(center, radius, coefficients);
            if radius <= SHARE_OF_CORNER * corner
                && let Some(step) = squares.series(square, nearest.distance, &expand)
            {
                return step;
            }
        } else if let Some(index) = self.patch(square, walls, nearest) {
            return Step::Leaf(Leaf::Patch(index).into());
        }
        if square.level == DEEPEST || squares.cells.len() + self.patches.len() > MOST {
            return Step::Leaf(Leaf::Sum(0).into());
        }
        Step::Split(Arc::new(self.walls.within(square.center, walls, nearest.distance + 2.0 * radius)))
    }

    /// The patch of a zone that covers the square.
    fn patch(&mut self, square: Square, walls: &WallList, nearest: Nearest) -> Option<u32> {
        let radius = square.half * SQRT_2;
        let boundary = self.field.boundary();
        let zone = self.zones.covering(boundary, nearest.edge, nearest.along, square.center, radius)?;
        // A zone may reach across a thin wall, where the region goes on.
        let own = self.zones.list[zone].edges(boundary);
        if self.walls.intrudes(square.center, radius, walls, own) {
            return None;
        }
        Some(*self.numbers.entry(zone).or_insert_with(|| {
            let expand =
                |center, radius, coefficients: &mut [Complex64]| self.series.expand(center, radius, coefficients);
            self.patches.push(WallPatch::new(self.field, self.zones.list[zone], &expand, &self.fit));
            self.patches.len() as u32 - 1
        }))
    }
}

impl fmt::Debug for PolygonSquares {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PolygonSquares")
            .field("squares", &self.tree.squares())
            .field("cells", &self.cells.len())
            .field("patches", &self.patches.len())
            .finish_non_exhaustive()
    }
}
