//! L and B in squares of a domain that polygons bound: power series, and real ones beside the walls.

use super::super::atlas::accuracy::Accuracy;
use super::super::atlas::cells::{Cells, MOST_CELLS, SHARE_OF_SUM};
use super::super::atlas::fit::Fit;
use super::super::atlas::leaf::Leaf;
use super::super::atlas::power_series::{MAX_COEFFICIENTS, rescale};
use super::super::atlas::quadtree::{MAX_LEVEL, Quadtree, Square, Step, Watch};
use super::super::atlas::walls::{Lie, Nearest, Walls};
use super::super::atlas::zone::Zones;
use super::cuts::Cuts;
use super::inside::{Ground, Inside};
use super::wall_patch::{Beside, WallPatch};
use crate::plane::Complex64;
use crate::symm::field::Field;
use crate::symm::local_series::LocalSeries;
use crate::symm::options::Progress;
use rustc_hash::FxHashMap;
use std::f64::consts::SQRT_2;
use std::fmt;
use std::sync::Arc;

/// The squares.
pub struct PolygonSquares {
    tree: Quadtree,
    cells: Cells,
    patches: Vec<WallPatch>,
}

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
        let zones = Zones::new(field.boundary(), &walls, &field.source.singularities(), |_| 0.0);
        let all = Arc::new(walls.all());
        let fit = Fit::new(accuracy.patch_degree(), accuracy.tolerance);
        let (cells, numbers, patches) = (Cells::default(), FxHashMap::default(), Vec::new());
        let mut builder = Builder { field, walls, series, zones, accuracy, fit, cells, numbers, patches };
        let mut watch = Watch::default();
        let mut tree = Quadtree::new(ground.center, ground.half);
        tree.grow(tree.root(), all, &mut |square, walls| {
            watch.step(square, Leaf::Sum(0).into(), progress, || builder.decide(square, &walls))
        });
        tree.finish();
        Self { tree, cells: builder.cells, patches: builder.patches }
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

type WallList = Arc<Vec<u32>>;

/// Decides on squares.
struct Builder<'a> {
    field: &'a Field,
    walls: Walls,
    series: LocalSeries,
    zones: Zones,
    accuracy: Accuracy,
    fit: Fit,
    cells: Cells,
    /// The patches of zones.
    numbers: FxHashMap<usize, u32>,
    patches: Vec<WallPatch>,
}

impl Builder<'_> {
    fn decide(&mut self, square: Square, walls: &WallList) -> Step<WallList> {
        let radius = square.half * SQRT_2;
        let nearest = self.walls.nearest(square.center, walls);
        let known = match self.walls.lie(square.center, radius, walls, nearest) {
            Lie::Outside => Some(Leaf::Outside),
            Lie::Clear => self.cell(square.center, radius, nearest.distance),
            Lie::BesideCorner => None,
            Lie::BesideWall => self.patch(square.center, radius, walls, nearest),
        };
        if let Some(leaf) = known {
            return Step::Leaf(leaf.into());
        }
        if square.level == MAX_LEVEL || self.cells.len() + self.patches.len() > MOST_CELLS {
            return Step::Leaf(Leaf::Sum(0).into());
        }
        Step::Split(Arc::new(self.walls.within(square.center, walls, nearest.distance + 2.0 * radius)))
    }

    /// A power series of L, if it is accurate; nothing of the boundary is nearer to the center than `clear`.
    fn cell(&mut self, center: Complex64, radius: f64, clear: f64) -> Option<Leaf> {
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        let coefficients = &mut coefficients[..self.accuracy.cell_terms()];
        let unit = radius.min(SHARE_OF_SUM * clear);
        self.series.expand(center, unit, coefficients);
        rescale(coefficients, radius / unit);
        let slope = coefficients[1].norm() / radius;
        let tolerance = self.accuracy.tolerance * slope.clamp(LEAST_SLOPE, 1.0);
        let count = self.accuracy.terms_needed(coefficients, tolerance)?;
        Some(Leaf::Cell(self.cells.add(center, radius, 0, &coefficients[..count])))
    }

    /// The patch of a zone that covers the disk.
    fn patch(&mut self, center: Complex64, radius: f64, walls: &WallList, nearest: Nearest) -> Option<Leaf> {
        let zone = self.zones.serving(self.field.boundary(), (&self.walls, walls), nearest, center, radius)?;
        let index = *self.numbers.entry(zone).or_insert_with(|| {
            let expand =
                |center, radius, coefficients: &mut [Complex64]| self.series.expand(center, radius, coefficients);
            self.patches.push(WallPatch::new(self.field, self.zones.list[zone], &expand, &self.fit));
            self.patches.len() as u32 - 1
        });
        Some(Leaf::Patch(index))
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
