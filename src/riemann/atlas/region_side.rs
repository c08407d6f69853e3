//! Region → disk: a quadtree of Taylor polynomials, and of patches where the boundary is.

use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::leaf::Leaf;
use super::patch::Patch;
use super::patches::Patches;
use super::region_builder::{RegionParts, build, build_far};
use crate::plane::Complex64;
use crate::symm::options::Progress;
use crate::symm::panel::Boundary;
use std::sync::Arc;

/// The maps region → disk, each point in the chart that knows it best: those of all charts, or of the first alone.
#[derive(Clone, Debug)]
pub struct RegionSide {
    /// By the first chart.
    near: Arc<RegionParts>,
    /// By all charts, where the first tells too little apart.
    far: Option<Arc<RegionParts>>,
    boundary: Arc<Boundary>,
}

/// What a region's side says of a point.
pub enum Found<T> {
    /// Its image.
    Image(T),
    /// The first chart alone tells too little apart there.
    Crowded,
    /// It lies outside of what its expansion knows: outside the region or, but for rounding, on the boundary.
    Beside,
    /// It lies outside.
    Nowhere,
}

impl<T> Found<T> {
    /// The image, if there is one.
    pub fn image(self) -> Option<T> {
        match self {
            Self::Image(image) => Some(image),
            Self::Crowded | Self::Beside | Self::Nowhere => None,
        }
    }

    fn from(image: Option<T>) -> Self {
        image.map_or(Self::Beside, Self::Image)
    }

    /// With another kind of image.
    #[inline]
    pub fn map<U>(self, change: impl FnOnce(T) -> U) -> Found<U> {
        match self {
            Self::Image(image) => Found::Image(change(image)),
            Self::Crowded => Found::Crowded,
            Self::Beside => Found::Beside,
            Self::Nowhere => Found::Nowhere,
        }
    }
}

impl RegionSide {
    /// Of the first chart alone. Of no use once `progress` has returned false.
    pub fn near(boundary: &Arc<Boundary>, atlas: &Atlas, accuracy: Accuracy, progress: Progress) -> Self {
        let near = Arc::new(build(boundary, atlas, accuracy, progress));
        Self { near, far: None, boundary: Arc::clone(boundary) }
    }

    /// With the charts that the rest of the region asks for, which are added to `atlas`. Of no use once `progress` has returned
    /// false.
    #[must_use]
    pub fn with_far(&self, atlas: &mut Atlas, accuracy: Accuracy, progress: Progress) -> Self {
        let far = build_far(&self.boundary, &self.near, atlas, accuracy, progress);
        Self { far: Some(Arc::new(far)), ..self.clone() }
    }

    /// Whether the first chart tells the whole region apart.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.near.open.is_empty()
    }

    /// Where crowding had to be accepted, a place where it is worst.
    #[must_use]
    pub fn crowded(&self) -> Option<Complex64> {
        self.far.as_ref().and_then(|far| far.crowded)
    }

    /// The parts that know a point, and the leaf that holds it there.
    #[inline]
    fn leaf(&self, z: Complex64) -> (&RegionParts, Leaf) {
        let leaf = self.near.tree.find(z).map_or(Leaf::Outside, Leaf::from);
        match &self.far {
            Some(far) if leaf == Leaf::Crowded => (far, far.tree.find(z).map_or(Leaf::Outside, Leaf::from)),
            _ => (&self.near, leaf),
        }
    }

    /// z → (chart, w there).
    #[inline]
    #[must_use]
    pub fn at(&self, atlas: &Atlas, z: Complex64) -> Found<(usize, Complex64)> {
        // Most points lie in a cell of the first chart, which is no more than a polynomial.
        match self.near.tree.find(z).map(Leaf::from) {
            Some(Leaf::Cell(index)) => Found::Image(self.near.cells.value(index, z)),
            Some(Leaf::Outside) | None => Found::Nowhere,
            Some(_) => self.by_leaf(atlas, z),
        }
    }

    /// z → w, where a cell of the first chart, which is the disk itself, holds z.
    #[inline]
    #[must_use]
    pub fn by_cell(&self, z: Complex64) -> Option<Complex64> {
        match Leaf::from(self.near.tree.find(z)?) {
            Leaf::Cell(index) => Some(self.near.cells.value(index, z).1),
            _ => None,
        }
    }

    /// The derivative of [`RegionSide::by_cell`].
    #[inline]
    #[must_use]
    pub fn slope_by_cell(&self, z: Complex64) -> Option<Complex64> {
        match Leaf::from(self.near.tree.find(z)?) {
            Leaf::Cell(index) => Some(self.near.cells.value_and_slope(index, z).2),
            _ => None,
        }
    }

    fn by_leaf(&self, atlas: &Atlas, z: Complex64) -> Found<(usize, Complex64)> {
        let (parts, leaf) = self.leaf(z);
        match leaf {
            Leaf::Cell(index) => Found::Image(parts.cells.value(index, z)),
            Leaf::Patch(index) => {
                let patch = &parts.patches.list[index as usize];
                Found::from(patch.value(z).map(|w| (patch.chart, w)))
            }
            Leaf::Sum(chart) => Found::from(self.directly(atlas, chart as usize, z).map(|w| (chart as usize, w))),
            Leaf::Crowded => Found::Crowded,
            Leaf::Outside | Leaf::Chart(_) | Leaf::Walk(_) => Found::Nowhere,
        }
    }

    /// z → (chart, w, dw/dz).
    #[inline]
    #[must_use]
    pub fn with_slope(&self, atlas: &Atlas, z: Complex64) -> Found<(usize, Complex64, Complex64)> {
        match self.near.tree.find(z).map(Leaf::from) {
            Some(Leaf::Cell(index)) => Found::Image(self.near.cells.value_and_slope(index, z)),
            Some(Leaf::Outside) | None => Found::Nowhere,
            Some(_) => self.by_leaf_with_slope(atlas, z),
        }
    }

    fn by_leaf_with_slope(&self, atlas: &Atlas, z: Complex64) -> Found<(usize, Complex64, Complex64)> {
        let (parts, leaf) = self.leaf(z);
        match leaf {
            Leaf::Cell(index) => Found::Image(parts.cells.value_and_slope(index, z)),
            Leaf::Patch(index) => {
                let patch = &parts.patches.list[index as usize];
                Found::from(patch.value_and_slope(z).map(|(w, slope)| (patch.chart, w, slope)))
            }
            Leaf::Sum(chart) => {
                let nearest = atlas.walls.nearest_of_all(z);
                if !nearest.inside || nearest.distance == 0.0 {
                    return Found::Beside;
                }
                let mut coefficients = [Complex64::ZERO; 2];
                atlas.charts[chart as usize].expand(z, 0.1 * nearest.distance, &mut coefficients);
                Found::Image((chart as usize, coefficients[0], coefficients[1] / (0.1 * nearest.distance)))
            }
            Leaf::Crowded => Found::Crowded,
            Leaf::Outside | Leaf::Chart(_) | Leaf::Walk(_) => Found::Nowhere,
        }
    }

    /// The patch that knows a point, if one does.
    #[must_use]
    pub fn patch_at(&self, z: Complex64) -> Option<&Patch> {
        match self.leaf(z) {
            (parts, Leaf::Patch(index)) => Some(&parts.patches.list[index as usize]),
            _ => None,
        }
    }

    /// (center, value there, chart) of every cell.
    pub fn centers(&self) -> impl Iterator<Item = (Complex64, Complex64, usize)> + '_ {
        self.parts().flat_map(|parts| parts.cells.centers())
    }

    /// Width of the region or its height, whichever is larger.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.near.size
    }

    /// How many cells there are.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.parts().map(|parts| parts.cells.len()).sum()
    }

    /// The patches of one chart, to be added to.
    #[must_use]
    pub fn patches_of(&self, chart: usize) -> Patches {
        match &self.far {
            Some(far) if chart > 0 => far.patches.of_chart(chart),
            _ => self.near.patches.of_chart(chart),
        }
    }

    fn parts(&self) -> impl Iterator<Item = &RegionParts> {
        std::iter::once(&self.near).chain(&self.far).map(AsRef::as_ref)
    }

    /// Direct summation, for the few places that no expansion reaches.
    #[cold]
    fn directly(&self, atlas: &Atlas, chart: usize, z: Complex64) -> Option<Complex64> {
        let nearest = atlas.walls.nearest_of_all(z);
        let map = &atlas.charts[chart];
        if nearest.distance <= atlas.walls.thickness {
            let length = self.boundary.lengths[nearest.edge];
            let measure = map.measure((nearest.edge, nearest.along, length - nearest.along));
            return Some(Complex64::cis(std::f64::consts::TAU * measure));
        }
        nearest.inside.then(|| map.direct(z))
    }

    /// Squares of its trees.
    #[must_use]
    pub fn squares(&self) -> usize {
        self.parts().map(|parts| parts.tree.squares()).sum()
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.parts().map(|parts| parts.tree.bytes() + parts.cells.bytes() + parts.patches.bytes()).sum()
    }
}
