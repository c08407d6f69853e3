//! Region → disk: a quadtree of Taylor polynomials, and of patches where the boundary is.

use super::super::rounding::ON_BOUNDARY;
use super::accuracy::Accuracy;
use super::cells::Cells;
use super::charts::Atlas;
use super::leaf::Leaf;
use super::patch::Patch;
use super::patches::Patches;
use super::quadtree::Quadtree;
use super::region_builder::{RegionParts, build};
use crate::plane::Complex64;
use crate::symm::options::Progress;
use crate::symm::panel::Boundary;
use std::sync::Arc;

/// The maps region → disk of all charts, each point in the chart that knows it best.
#[derive(Clone, Debug)]
pub struct RegionSide {
    tree: Quadtree,
    /// Taylor polynomials.
    pub cells: Cells,
    /// Boundary zones.
    pub patches: Patches,
    boundary: Arc<Boundary>,
    /// Where crowding had to be accepted, a place where it is worst.
    pub crowded: Option<Complex64>,
}

impl RegionSide {
    /// Builds the tree; adds charts where the map of the first is too crowded. Of no use once `progress` has returned false.
    pub fn new(boundary: &Arc<Boundary>, atlas: &mut Atlas, accuracy: Accuracy, progress: Progress) -> Self {
        let RegionParts { tree, cells, patches, crowded } = build(boundary, atlas, accuracy, progress);
        Self { tree, cells, patches, boundary: Arc::clone(boundary), crowded }
    }

    /// z → (chart, w there); `None` outside the closed region.
    #[inline]
    #[must_use]
    pub fn at(&self, atlas: &Atlas, z: Complex64) -> Option<(usize, Complex64)> {
        match Leaf::from(self.tree.find(z)?) {
            Leaf::Cell(index) => Some(self.cells.value(index, z)),
            Leaf::Patch(index) => {
                let patch = &self.patches.list[index as usize];
                patch.value(z).map(|w| (patch.chart, w))
            }
            Leaf::Outside | Leaf::Chart(_) | Leaf::Walk(_) => None,
            Leaf::Sum(chart) => {
                let w = self.directly(atlas, chart as usize, z)?;
                Some((chart as usize, w))
            }
        }
    }

    /// z → (chart, w, dw/dz).
    #[inline]
    #[must_use]
    pub fn with_slope(&self, atlas: &Atlas, z: Complex64) -> Option<(usize, Complex64, Complex64)> {
        match Leaf::from(self.tree.find(z)?) {
            Leaf::Cell(index) => Some(self.cells.value_and_slope(index, z)),
            Leaf::Patch(index) => {
                let patch = &self.patches.list[index as usize];
                patch.value_and_slope(z).map(|(w, slope)| (patch.chart, w, slope))
            }
            Leaf::Outside | Leaf::Chart(_) | Leaf::Walk(_) => None,
            Leaf::Sum(chart) => {
                let nearest = atlas.walls.nearest_of_all(z);
                if !nearest.inside || nearest.distance == 0.0 {
                    return None;
                }
                let mut coefficients = [Complex64::ZERO; 2];
                atlas.charts[chart as usize].expand(z, 0.1 * nearest.distance, &mut coefficients);
                Some((chart as usize, coefficients[0], coefficients[1] / (0.1 * nearest.distance)))
            }
        }
    }

    /// The patch that knows a point, if one does.
    #[must_use]
    pub fn patch_at(&self, z: Complex64) -> Option<&Patch> {
        match Leaf::from(self.tree.find(z)?) {
            Leaf::Patch(index) => Some(&self.patches.list[index as usize]),
            _ => None,
        }
    }

    /// Direct summation, for the few places that no expansion reaches.
    #[cold]
    fn directly(&self, atlas: &Atlas, chart: usize, z: Complex64) -> Option<Complex64> {
        let nearest = atlas.walls.nearest_of_all(z);
        let map = &atlas.charts[chart];
        if nearest.distance <= ON_BOUNDARY {
            let length = self.boundary.lengths[nearest.edge];
            let measure = map.measure((nearest.edge, nearest.along, length - nearest.along));
            return Some(Complex64::cis(std::f64::consts::TAU * measure));
        }
        nearest.inside.then(|| map.direct(z))
    }

    /// Squares of its tree.
    #[must_use]
    pub fn squares(&self) -> usize {
        self.tree.squares()
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.tree.bytes() + self.cells.bytes() + self.patches.bytes()
    }
}
