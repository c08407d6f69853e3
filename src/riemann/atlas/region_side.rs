//! Region → disk: a quadtree of Taylor polynomials, and of patches where the boundary is.

use super::charts::{Atlas, MAX_COEFFICIENTS};
use super::fit::Fit;
use super::patch::Patch;
use super::power_series::{rescale, value, value_and_slope};
use super::quadtree::{MAX_LEVEL, Quadtree, Square, Step};
use super::walls::Nearest;
use super::{Accuracy, Leaf};
use crate::plane::Complex64;
use crate::symm::panel::Boundary;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

/// A disk with a Taylor polynomial.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Its center.
    pub center: Complex64,
    inverse_radius: f64,
    first: u32,
    count: u16,
    /// Whose map it is.
    pub chart: u16,
}

/// Cells and their coefficients.
#[derive(Clone, Debug, Default)]
pub struct Cells {
    list: Vec<Cell>,
    coefficients: Vec<Complex64>,
}

impl Cells {
    /// Keeps a cell; returns its number.
    pub fn add(&mut self, center: Complex64, radius: f64, chart: usize, coefficients: &[Complex64]) -> u32 {
        let first = self.coefficients.len() as u32;
        self.coefficients.extend_from_slice(coefficients);
        let count = coefficients.len() as u16;
        self.list.push(Cell { center, inverse_radius: 1.0 / radius, first, count, chart: chart as u16 });
        self.list.len() as u32 - 1
    }

    /// The cell, its polynomial, and where a point lies in it.
    #[inline]
    #[must_use]
    pub fn at(&self, index: u32, z: Complex64) -> (&Cell, &[Complex64], Complex64) {
        let cell = &self.list[index as usize];
        let first = cell.first as usize;
        let t = (z - cell.center) * cell.inverse_radius;
        (cell, &self.coefficients[first..first + cell.count as usize], t)
    }

    /// The polynomial's value.
    #[inline]
    #[must_use]
    pub fn value(&self, index: u32, z: Complex64) -> (usize, Complex64) {
        let (cell, coefficients, t) = self.at(index, z);
        (cell.chart as usize, value(coefficients, t))
    }

    /// The polynomial's value and derivative.
    #[inline]
    #[must_use]
    pub fn value_and_slope(&self, index: u32, z: Complex64) -> (usize, Complex64, Complex64) {
        let (cell, coefficients, t) = self.at(index, z);
        let (w, slope) = value_and_slope(coefficients, t);
        (cell.chart as usize, w, slope * cell.inverse_radius)
    }

    /// (center, value there, chart) of every cell.
    pub fn centers(&self) -> impl Iterator<Item = (Complex64, Complex64, usize)> + '_ {
        self.list.iter().map(|cell| (cell.center, self.coefficients[cell.first as usize], cell.chart as usize))
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        std::mem::size_of_val(&self.list[..]) + std::mem::size_of_val(&self.coefficients[..])
    }
}

/// Patches made so far, by chart and zone.
#[derive(Clone, Debug)]
pub struct Patches {
    boundary: Arc<Boundary>,
    fit: Arc<Fit>,
    numbers: HashMap<(usize, usize), u32>,
    /// The patches.
    pub list: Vec<Patch>,
}

impl Patches {
    fn new(boundary: &Arc<Boundary>, accuracy: Accuracy) -> Self {
        Self {
            boundary: Arc::clone(boundary),
            fit: Arc::new(Fit::new(accuracy.patch_degree(), accuracy.tolerance)),
            numbers: HashMap::new(),
            list: Vec::new(),
        }
    }

    /// Those of one chart, to be added to.
    #[must_use]
    pub fn of_chart(&self, chart: usize) -> Self {
        let mut own = Self { numbers: HashMap::new(), list: Vec::new(), ..self.clone() };
        let mut zones: Vec<_> = self.numbers.iter().filter(|((of, _), _)| *of == chart).collect();
        zones.sort_unstable();
        for (key, &index) in zones {
            own.numbers.insert(*key, own.list.len() as u32);
            own.list.push(self.list[index as usize].clone());
        }
        own
    }

    /// The number of a chart's patch in one of its zones.
    pub fn get(&mut self, atlas: &Atlas, chart: usize, zone: usize) -> u32 {
        *self.numbers.entry((chart, zone)).or_insert_with(|| {
            let map = &atlas.charts[chart];
            self.list.push(Patch::new(&self.boundary, map, chart, map.zones.list[zone], &self.fit));
            self.list.len() as u32 - 1
        })
    }
}

/// The maps region → disk of all charts, each point in the chart that knows it best.
#[derive(Clone, Debug)]
pub struct RegionSide {
    tree: Quadtree,
    /// Taylor polynomials.
    pub cells: Cells,
    /// Boundary zones.
    pub patches: Patches,
    boundary: Arc<Boundary>,
}

/// A cell's polynomial is tried where its radius is at most this share of the distance to the wall,
const SHARE_OF_WALL: f64 = 0.9;
/// and this one of the distance to a corner where the map is singular.
const SHARE_OF_CORNER: f64 = 0.6;
/// Sources are summed for a disk of at most this share of the distance to the wall: nearer to it they would have to be cut
/// small. The map's own series goes on beyond.
const SHARE_OF_SUM: f64 = 0.5;
/// A chart is trusted where its |f'| × the region's size is at least this.
const LEAST_SLOPE: f64 = 0.05;
/// More cells than this are not made; what is left is summed directly.
const MAX_CELLS: usize = 400_000;

impl RegionSide {
    /// Builds the tree; adds charts where the map of the first is too crowded.
    #[must_use]
    pub fn new(boundary: &Arc<Boundary>, atlas: &mut Atlas, accuracy: Accuracy) -> Self {
        let (center, half) = bounds(boundary);
        let mut tree = Quadtree::new(center, half);
        let patches = Patches::new(boundary, accuracy);
        let mut builder = Builder {
            boundary: Arc::clone(boundary),
            accuracy,
            size: 2.0 * half,
            cells: Cells::default(),
            patches,
            crowded: Vec::new(),
            accept_crowding: false,
            hint: 0,
        };
        let root = (tree.root(), Rc::new(atlas.walls.all()));
        let mut open = vec![root];
        loop {
            for (square, walls) in open.drain(..) {
                tree.grow(square, walls, &mut |square, walls| builder.decide(atlas, square, &walls));
            }
            let score = |c: &Crowded| if c.slope.is_finite() { c.slope * c.clear } else { 0.0 };
            let Some(next) = builder.crowded.iter().max_by(|a, b| score(a).total_cmp(&score(b))) else { break };
            if !atlas.add(next.center, next.chart) {
                builder.accept_crowding = true;
            }
            open = builder.crowded.drain(..).map(|c| (c.square, c.walls)).collect();
        }
        tree.finish();
        Self { tree, cells: builder.cells, patches: builder.patches, boundary: Arc::clone(boundary) }
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
            Leaf::Outside => None,
            Leaf::Other(chart) => {
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
            Leaf::Outside => None,
            Leaf::Other(chart) => {
                let nearest = atlas.walls.nearest(z, &atlas.walls.all());
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

    /// For the few places that no expansion reaches.
    #[cold]
    fn directly(&self, atlas: &Atlas, chart: usize, z: Complex64) -> Option<Complex64> {
        let nearest = atlas.walls.nearest(z, &atlas.walls.all());
        let map = &atlas.charts[chart];
        if nearest.distance <= 4.0 * f64::EPSILON {
            let length = self.boundary.lengths[nearest.edge];
            let measure = map.measure((nearest.edge, nearest.along, length - nearest.along));
            return Some(Complex64::cis(std::f64::consts::TAU * measure));
        }
        nearest.inside.then(|| map.direct(z))
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.tree.bytes() + self.cells.bytes() + self.patches.list.iter().map(Patch::bytes).sum::<usize>()
    }
}

/// The square around the boundary.
fn bounds(boundary: &Boundary) -> (Complex64, f64) {
    let start = boundary.vertices[0];
    let (low, high) = boundary.vertices.iter().fold((start, start), |(low, high), v| {
        (Complex64::new(low.re.min(v.re), low.im.min(v.im)), Complex64::new(high.re.max(v.re), high.im.max(v.im)))
    });
    let size = high - low;
    // A little wider, so that no wall lies on its edge.
    (0.5 * (low + high), 0.507 * size.re.max(size.im))
}

type WallList = Rc<Vec<u32>>;

/// A square whose map no chart knows well yet.
struct Crowded {
    square: Square,
    walls: WallList,
    center: Complex64,
    chart: usize,
    /// |f'| × size there.
    slope: f64,
    /// Distance to the wall.
    clear: f64,
}

struct Builder {
    boundary: Arc<Boundary>,
    accuracy: Accuracy,
    size: f64,
    cells: Cells,
    patches: Patches,
    crowded: Vec<Crowded>,
    accept_crowding: bool,
    /// The chart that served last.
    hint: usize,
}

impl Builder {
    fn decide(&mut self, atlas: &Atlas, square: Square, walls: &WallList) -> Step<WallList> {
        let radius = square.half * std::f64::consts::SQRT_2;
        let nearest = atlas.walls.nearest(square.center, walls);
        if !nearest.inside && nearest.distance > radius {
            return Step::Leaf(Leaf::Outside.into());
        }
        if nearest.inside && radius <= SHARE_OF_WALL * nearest.distance {
            let corner = atlas.walls.to_singular_vertex(square.center, walls);
            if radius <= SHARE_OF_CORNER * corner
                && let Some(step) = self.taylor(atlas, square, walls, nearest.distance)
            {
                return step;
            }
        } else if let Some(step) = self.patch(atlas, square, walls, nearest) {
            return step;
        }
        if square.level == MAX_LEVEL || self.cells.list.len() + self.patches.list.len() > MAX_CELLS {
            return Step::Leaf(Leaf::Other(self.hint as u32).into());
        }
        Step::Split(Rc::new(atlas.walls.within(square.center, walls, nearest.distance + 2.0 * radius)))
    }

    /// A Taylor polynomial, if it is accurate.
    fn taylor(&mut self, atlas: &Atlas, square: Square, walls: &WallList, clear: f64) -> Option<Step<WallList>> {
        let radius = square.half * std::f64::consts::SQRT_2;
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        let coefficients = &mut coefficients[..self.accuracy.cell_terms()];
        let unit = radius.min(SHARE_OF_SUM * clear);
        let chart = atlas.expand_best(self.hint, square.center, unit, coefficients);
        rescale(coefficients, radius / unit);
        self.hint = chart;
        let slope = coefficients[1].norm() / radius * self.size;
        if !self.trusts(slope) {
            self.crowded.push(Crowded { square, walls: Rc::clone(walls), center: square.center, chart, slope, clear });
            return Some(Step::Open);
        }
        let count = self.accuracy.terms_needed(coefficients, self.accuracy.tolerance * slope.min(1.0))?;
        let index = self.cells.add(square.center, radius, chart, &coefficients[..count]);
        Some(Step::Leaf(Leaf::Cell(index).into()))
    }

    /// A patch, if one covers the square.
    fn patch(&mut self, atlas: &Atlas, square: Square, walls: &WallList, nearest: Nearest) -> Option<Step<WallList>> {
        let radius = square.half * std::f64::consts::SQRT_2;
        let zone_of = |chart: usize| {
            let zones = &atlas.charts[chart].zones;
            let zone = zones.covering(&self.boundary, nearest.edge, nearest.along, square.center, radius)?;
            // A zone may reach across a thin wall, where the region goes on.
            let own = zones.list[zone].edges(&self.boundary);
            (!atlas.walls.intrudes(square.center, radius, walls, own)).then_some(zone)
        };
        let mut zone = zone_of(self.hint)?;
        let mut chart = self.hint;
        if atlas.charts.len() > 1 {
            let top = atlas.charts[chart].zones.list[zone].point(Complex64::i());
            let mut coefficients = [Complex64::ZERO; 2];
            chart = atlas.expand_best(chart, top, 1e-3 * radius, &mut coefficients);
            self.hint = chart;
            zone = zone_of(chart)?;
        }
        let index = self.patches.get(atlas, chart, zone);
        let patch = &self.patches.list[index as usize];
        let slope = patch.typical_slope() * self.size;
        if !self.trusts(slope) {
            let center = patch.zone.point(Complex64::i());
            // Half as eligible as a square in the middle of the region.
            let clear = 0.5 * patch.zone.reach;
            self.crowded.push(Crowded { square, walls: Rc::clone(walls), center, chart, slope, clear });
            return Some(Step::Open);
        }
        Some(Step::Leaf(Leaf::Patch(index).into()))
    }

    fn trusts(&self, slope: f64) -> bool {
        self.accept_crowding || slope >= LEAST_SLOPE
    }
}
