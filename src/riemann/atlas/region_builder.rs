//! How the region is cut into cells and patches for the map region → disk.

use super::accuracy::Accuracy;
use super::cells::{Cells, MOST_CELLS, SHARE_OF_SUM};
use super::charts::{Atlas, BETTER};
use super::leaf::Leaf;
use super::patches::Patches;
use super::power_series::{MAX_COEFFICIENTS, rescale};
use super::quadtree::{MAX_LEVEL, Quadtree, Square, Step, Watch, square_around};
use super::walls::{Lie, Nearest};
use crate::plane::Complex64;
use crate::symm::options::Progress;
use crate::symm::panel::Boundary;
use std::sync::Arc;

/// A chart is trusted where its |f'| × the region's size is at least this.
pub const LEAST_SLOPE: f64 = 0.05;
/// Radius of a series of which only value and slope count, as a share of a square's.
const TINY_SHARE: f64 = 1e-3;

/// What the region, or the part of it that one chart crowds together, is cut into.
#[derive(Clone, Debug)]
pub struct RegionParts {
    /// The squares.
    pub tree: Quadtree,
    /// Taylor polynomials.
    pub cells: Cells,
    /// Boundary zones.
    pub patches: Patches,
    /// Width of the region or its height, whichever is larger.
    pub size: f64,
    /// Left for further charts.
    pub open: Vec<Crowded>,
    /// Where crowding had to be accepted, a place where it is worst.
    pub crowded: Option<Complex64>,
}

/// Cuts the region for the map of the one chart of `atlas`; where that crowds it together, squares stay open. Once `progress`
/// has returned false, what is left is not cut any more.
pub fn build(boundary: &Arc<Boundary>, atlas: &Atlas, accuracy: Accuracy, progress: Progress) -> RegionParts {
    let (center, half) = square_around(&boundary.vertices);
    let mut tree = Quadtree::new(center, half);
    let root = (tree.root(), Arc::new(atlas.walls.all()));
    let mut builder = Builder::new(boundary, half, accuracy);
    builder.grow(&mut tree, atlas, vec![root], &mut Watch::default(), progress);
    for crowded in &builder.crowded {
        tree.set(crowded.square, Leaf::Crowded.into());
    }
    builder.parts(tree)
}

/// Cuts what `near` left open, and adds charts for it to `atlas`. The rest of the tree means nothing.
pub fn build_far(
    boundary: &Arc<Boundary>,
    near: &RegionParts,
    atlas: &mut Atlas,
    accuracy: Accuracy,
    progress: Progress,
) -> RegionParts {
    let mut tree = near.tree.clone();
    let mut builder = Builder::new(boundary, square_around(&boundary.vertices).1, accuracy);
    let mut watch = Watch::default();
    builder.crowded.clone_from(&near.open);
    while let Some(most) = builder.most_eligible() {
        let next = &builder.crowded[most];
        if next.charts < atlas.charts.len() && atlas.better_chart(next.chart, next.w, BETTER).is_some() {
            // It was looked at before there were others.
            let next = builder.crowded.swap_remove(most);
            builder.grow(&mut tree, atlas, vec![(next.square, next.walls)], &mut watch, progress);
            continue;
        }
        if !atlas.add(next.center, next.chart, progress) {
            builder.accept_crowding = true;
        }
        let newest = atlas.charts.len() - 1;
        let again = |c: &mut Crowded| builder.accept_crowding || c.is_near(atlas, newest);
        let open = builder.crowded.extract_if(.., again).map(|c| (c.square, c.walls)).collect();
        builder.grow(&mut tree, atlas, open, &mut watch, progress);
    }
    builder.parts(tree)
}

type WallList = Arc<Vec<u32>>;

/// A square whose map no chart knows well yet.
#[derive(Clone, Debug)]
pub struct Crowded {
    square: Square,
    walls: WallList,
    center: Complex64,
    chart: usize,
    /// The center's image in its disk.
    w: Complex64,
    /// |f'| × size there.
    slope: f64,
    /// Distance to the wall.
    clear: f64,
    /// How many charts there were when this was found out.
    charts: usize,
}

/// A new chart looks at what it stretches to this share of what is trusted; the rest has time.
const NEAR_SHARE: f64 = 0.02;
/// Not for ever: from farther away (cosh of half the distance) numbers do not tell in which direction the new chart lies.
const LONGEST_LINK: f64 = 1e5;

impl Crowded {
    /// How good a center this is for a new chart: as far out as the old ones see well, as far from walls as can be.
    fn score(&self) -> f64 {
        if self.slope.is_finite() { self.slope * self.clear } else { 0.0 }
    }

    /// Whether chart `newest` might know this, or where it is.
    fn is_near(&self, atlas: &Atlas, newest: usize) -> bool {
        if !atlas.serves_better(newest, self.chart, self.w) {
            return false;
        }
        let link = atlas.link(newest, self.chart);
        let slope = self.slope * link.stretch(self.w);
        slope >= NEAR_SHARE * LEAST_SLOPE || slope.is_nan() || link.length() > LONGEST_LINK
    }
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
    /// The least slope that was accepted though it is crowded, and where.
    worst: Option<(f64, Complex64)>,
}

impl Builder {
    fn new(boundary: &Arc<Boundary>, half: f64, accuracy: Accuracy) -> Self {
        Self {
            boundary: Arc::clone(boundary),
            accuracy,
            size: 2.0 * half,
            cells: Cells::default(),
            patches: Patches::new(boundary, accuracy),
            crowded: Vec::new(),
            accept_crowding: false,
            hint: 0,
            worst: None,
        }
    }

    /// The crowded square that is the best center for a new chart.
    fn most_eligible(&self) -> Option<usize> {
        let score = |k: usize| self.crowded[k].score();
        (0..self.crowded.len()).max_by(|&a, &b| score(a).total_cmp(&score(b)))
    }

    /// Cuts open squares, as long as the caller wants more.
    fn grow(
        &mut self,
        tree: &mut Quadtree,
        atlas: &Atlas,
        open: Vec<(Square, WallList)>,
        watch: &mut Watch,
        progress: Progress,
    ) {
        for (square, walls) in open {
            tree.grow(square, walls, &mut |square, walls| {
                watch.step(square, Leaf::Sum(0).into(), progress, || self.decide(atlas, square, &walls))
            });
        }
    }

    fn parts(self, mut tree: Quadtree) -> RegionParts {
        tree.finish();
        let crowded = self.worst.map(|(_, place)| place);
        RegionParts { tree, cells: self.cells, patches: self.patches, size: self.size, open: self.crowded, crowded }
    }

    fn decide(&mut self, atlas: &Atlas, square: Square, walls: &WallList) -> Step<WallList> {
        let radius = square.half * std::f64::consts::SQRT_2;
        let nearest = atlas.walls.nearest(square.center, walls);
        let known = match atlas.walls.lie(square.center, radius, walls, nearest) {
            Lie::Outside => return Step::Leaf(Leaf::Outside.into()),
            Lie::Clear => self.taylor(atlas, square, walls, nearest.distance),
            Lie::BesideCorner => None,
            Lie::BesideWall => self.patch(atlas, square, walls, nearest),
        };
        if let Some(step) = known {
            return step;
        }
        if square.level == MAX_LEVEL || self.cells.len() + self.patches.list.len() > MOST_CELLS {
            return Step::Leaf(Leaf::Sum(self.hint as u32).into());
        }
        Step::Split(Arc::new(atlas.walls.within(square.center, walls, nearest.distance + 2.0 * radius)))
    }

    /// A Taylor polynomial, if it is accurate.
    fn taylor(&mut self, atlas: &Atlas, square: Square, walls: &WallList, clear: f64) -> Option<Step<WallList>> {
        let radius = square.half * std::f64::consts::SQRT_2;
        let unit = radius.min(SHARE_OF_SUM * clear);
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        let coefficients = &mut coefficients[..self.accuracy.cell_terms()];
        let is_alone = atlas.charts.len() == 1;
        let (chart, w, slope) = if is_alone {
            atlas.charts[0].expand(square.center, unit, coefficients);
            (0, coefficients[0], coefficients[1].norm() / unit * self.size)
        } else {
            self.look(atlas, square.center, unit)
        };
        if !self.trusts(slope, square.center) {
            let (walls, center, charts) = (Arc::clone(walls), square.center, atlas.charts.len());
            self.crowded.push(Crowded { square, walls, center, chart, w, slope, clear, charts });
            return Some(Step::Open);
        }
        if !is_alone {
            atlas.charts[chart].expand(square.center, unit, coefficients);
        }
        rescale(coefficients, radius / unit);
        let count = self.accuracy.terms_needed(coefficients, self.accuracy.tolerance * slope.min(1.0))?;
        let index = self.cells.add(square.center, radius, chart, &coefficients[..count]);
        Some(Step::Leaf(Leaf::Cell(index).into()))
    }

    /// A patch, if one covers the square.
    fn patch(&mut self, atlas: &Atlas, square: Square, walls: &WallList, nearest: Nearest) -> Option<Step<WallList>> {
        let radius = square.half * std::f64::consts::SQRT_2;
        let boundary = Arc::clone(&self.boundary);
        let zone_of = |chart: usize| {
            let zones = &atlas.charts[chart].zones;
            zones.serving(&boundary, (&atlas.walls, walls), nearest, square.center, radius)
        };
        let mut zone = zone_of(self.hint)?;
        let top_of = |chart: usize, zone: usize| {
            let zone = &atlas.charts[chart].zones.list[zone];
            (zone.point(Complex64::i()), zone.reach)
        };
        if atlas.charts.len() > 1 {
            let chart = self.look(atlas, top_of(self.hint, zone).0, TINY_SHARE * radius).0;
            zone = zone_of(chart)?;
        }
        let chart = self.hint;
        let (top, reach) = top_of(chart, zone);
        let (w, slope) = match self.patches.known(chart, zone) {
            Some(patch) => (patch.top(), patch.typical_slope() * self.size),
            None => self.look_by(atlas, chart, top, TINY_SHARE * radius),
        };
        if !self.trusts(slope, top) {
            // Half as eligible as a square in the middle of the region.
            let clear = 0.5 * reach;
            let (walls, charts) = (Arc::clone(walls), atlas.charts.len());
            self.crowded.push(Crowded { square, walls, center: top, chart, w, slope, clear, charts });
            return Some(Step::Open);
        }
        let index = self.patches.get(atlas, chart, zone);
        Some(Step::Leaf(Leaf::Patch(index).into()))
    }

    /// The chart that serves best at a point, which becomes the hint, the image there and |f'| × size.
    fn look(&mut self, atlas: &Atlas, center: Complex64, radius: f64) -> (usize, Complex64, f64) {
        let mut coefficients = [Complex64::ZERO; 2];
        self.hint = atlas.expand_best(self.hint, center, radius, &mut coefficients);
        (self.hint, coefficients[0], coefficients[1].norm() / radius * self.size)
    }

    /// The same by one chart.
    fn look_by(&self, atlas: &Atlas, chart: usize, center: Complex64, radius: f64) -> (Complex64, f64) {
        let mut coefficients = [Complex64::ZERO; 2];
        atlas.charts[chart].expand(center, radius, &mut coefficients);
        (coefficients[0], coefficients[1].norm() / radius * self.size)
    }

    fn trusts(&mut self, slope: f64, place: Complex64) -> bool {
        if slope >= LEAST_SLOPE {
            return true;
        }
        if self.accept_crowding && self.worst.is_none_or(|(least, _)| slope < least) {
            self.worst = Some((slope, place));
        }
        self.accept_crowding
    }
}
