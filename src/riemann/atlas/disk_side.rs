//! Disk → region, for one chart: a quadtree of Taylor polynomials of the inverse, and of arcs where Newton's method on a
//! patch's series takes over.

use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::disk_builder::{DiskParts, build};
use super::inverse_cell::Pair;
use super::leaf::Leaf;
use super::patch::Patch;
use super::region_side::RegionSide;
use crate::plane::Complex64;
use crate::symm::options::Progress;

/// The inverse of one chart's map, or the chart to ask instead.
#[derive(Clone, Debug)]
pub struct DiskSide {
    parts: DiskParts,
}

/// Where a point of the disk comes from.
pub enum Source {
    /// The point of the region, and dz/dw if it was asked for.
    Point(Complex64, Complex64),
    /// Another chart knows better.
    Chart(usize),
    /// Walk from here.
    Walk(Pair),
    /// The first chart alone tells too little apart there.
    Crowded,
    /// Outside the disk.
    Nowhere,
}

impl DiskSide {
    /// Builds the inverse of a chart's map. Of no use once `progress` has returned false.
    #[must_use]
    pub fn new(atlas: &Atlas, region: &RegionSide, chart: usize, accuracy: Accuracy, progress: Progress) -> Self {
        Self { parts: build(atlas, region, chart, accuracy, progress) }
    }

    #[inline]
    fn leaf(&self, w: Complex64) -> Leaf {
        self.parts.tree.find(w).map_or(Leaf::Outside, Leaf::from)
    }

    /// w → z, for w in the closed disk, up to rounding.
    #[inline]
    #[must_use]
    pub fn at(&self, w: Complex64) -> Source {
        match self.leaf(w) {
            Leaf::Cell(index) => Source::Point(self.parts.cells.value(index, w).1, Complex64::ZERO),
            leaf => self.by_leaf(leaf, w),
        }
    }

    /// w → z, where a cell holds w.
    #[inline]
    #[must_use]
    pub fn by_cell(&self, w: Complex64) -> Option<Complex64> {
        match self.leaf(w) {
            Leaf::Cell(index) => Some(self.parts.cells.value(index, w).1),
            _ => None,
        }
    }

    fn by_leaf(&self, leaf: Leaf, w: Complex64) -> Source {
        match leaf {
            Leaf::Cell(index) => Source::Point(self.parts.cells.value(index, w).1, Complex64::ZERO),
            Leaf::Patch(index) => {
                let patch = &self.parts.patches[index as usize];
                Source::Point(patch.zone.point(patch.straightened(w)), Complex64::ZERO)
            }
            Leaf::Chart(chart) => Source::Chart(chart as usize),
            Leaf::Walk(index) => Source::Walk(self.parts.seeds[index as usize]),
            Leaf::Crowded => Source::Crowded,
            Leaf::Outside | Leaf::Sum(_) => Source::Nowhere,
        }
    }

    /// w → (z, dz/dw).
    #[must_use]
    pub fn with_slope(&self, w: Complex64) -> Source {
        match self.leaf(w) {
            Leaf::Cell(index) => {
                let (_, z, slope) = self.parts.cells.value_and_slope(index, w);
                Source::Point(z, slope)
            }
            Leaf::Patch(index) => {
                let (z, slope) = self.parts.patches[index as usize].preimage(w);
                Source::Point(z, slope)
            }
            _ => self.at(w),
        }
    }

    /// Squares of its tree.
    #[must_use]
    pub fn squares(&self) -> usize {
        self.parts.tree.squares()
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let DiskParts { tree, cells, patches, seeds } = &self.parts;
        tree.bytes()
            + cells.bytes()
            + patches.iter().map(Patch::bytes).sum::<usize>()
            + std::mem::size_of_val(&seeds[..])
    }
}
