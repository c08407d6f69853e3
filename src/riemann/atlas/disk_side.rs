//! Disk → region, for one chart: a quadtree of Taylor polynomials of the inverse, and of arcs where Newton's method on a
//! patch's series takes over.

use super::accuracy::Accuracy;
use super::cells::Cells;
use super::charts::Atlas;
use super::disk_builder::build;
use super::leaf::Leaf;
use super::patch::Patch;
use super::quadtree::Quadtree;
use super::region_side::RegionSide;
use crate::plane::Complex64;

/// The inverse of one chart's map, or the chart to ask instead.
#[derive(Clone, Debug)]
pub struct DiskSide {
    tree: Quadtree,
    cells: Cells,
    patches: Vec<Patch>,
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

impl DiskSide {
    /// Builds the inverse of a chart's map.
    #[must_use]
    pub fn new(atlas: &Atlas, region: &RegionSide, chart: usize, accuracy: Accuracy) -> Self {
        let (tree, cells, patches) = build(atlas, region, chart, accuracy);
        Self { tree, cells, patches }
    }

    /// w → z, for w in the closed disk, up to rounding.
    #[inline]
    #[must_use]
    pub fn at(&self, w: Complex64) -> Source {
        let leaf = self.tree.find(w).map_or(Leaf::Outside, Leaf::from);
        match leaf {
            Leaf::Cell(index) => Source::Point(self.cells.value(index, w).1, Complex64::ZERO),
            Leaf::Patch(index) => {
                let patch = &self.patches[index as usize];
                Source::Point(patch.zone.point(patch.straightened(w)), Complex64::ZERO)
            }
            Leaf::Chart(chart) => Source::Chart(chart as usize),
            Leaf::Outside | Leaf::Sum(_) => Source::Nowhere,
        }
    }

    /// w → (z, dz/dw).
    #[must_use]
    pub fn with_slope(&self, w: Complex64) -> Source {
        let leaf = self.tree.find(w).map_or(Leaf::Outside, Leaf::from);
        match leaf {
            Leaf::Cell(index) => {
                let (_, z, slope) = self.cells.value_and_slope(index, w);
                Source::Point(z, slope)
            }
            Leaf::Patch(index) => {
                let patch = &self.patches[index as usize];
                let tau = patch.straightened(w);
                Source::Point(patch.zone.point(tau), patch.inverse_slope(tau, w))
            }
            _ => self.at(w),
        }
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.tree.bytes() + self.cells.bytes() + self.patches.iter().map(Patch::bytes).sum::<usize>()
    }
}
