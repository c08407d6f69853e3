//! A solved region seen from another center: its map, followed by an automorphism of the disk.
//!
//! By Riemann's theorem the maps of one region for two centers differ by an automorphism of the disk and by nothing else, so
//! that g = M ∘ f with M(f(center)) = 0 is the map of the other center, for the cost of one value of f. An error ε of f is one
//! of at most (1 + |a|) ε max |M'| in g, a = f(center): ε there, and |a| ε at most in a, as f is exact in its own center.

use super::atlas::{DiskPoint, Position};
use super::automorphism::Automorphism;
use super::rounding::{is_outside_disk, onto_disk};
use super::solved_region::{Evidence, Root, SolvedRegion};
use crate::Result;
use crate::map::Jet;
use crate::plane::{BoundaryPoint, Complex64, NOWHERE};
use crate::stored::Writer;
use crate::symm::options::{Progress, SolveOptions, Stop};
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// A solved region, and the automorphism that takes another point than its center to 0 and leaves vertex 0 at 1.
///
/// Numbers of the first chart's disk are those behind the automorphism; other charts keep theirs, and only lie elsewhere.
#[derive(Debug)]
pub(super) struct Recentred {
    root: Root,
    /// The point that goes to 0.
    center: Complex64,
    /// By direct summation: what the boundary needs, for which nothing is built.
    rim: Automorphism,
    /// By the evaluator, which it takes exactly to the center.
    inside: OnceLock<[Automorphism; 2]>,
    radius: OnceLock<f64>,
    positions: OnceLock<Vec<Position>>,
}

/// Points of a circle around the center for the derivative there, and the circle's radius as a share of the distance to the
/// boundary: by the trapezoidal rule the error is the share to the power of their number.
const AROUND: usize = 24;
const SHARE_OF_DISTANCE: f64 = 0.25;
/// Of what is stretched by more than this nothing is known.
const MOST_STRETCH: f64 = 1e6;

impl Recentred {
    /// The solution of `root` for another center inside; `None` where that is too far out for a map to be one.
    pub fn new(root: Root, center: Complex64) -> Option<Self> {
        let a = root.solved.to_disk_directly(center)?;
        let rim = Automorphism::new(a);
        let is_known = a.norm() < 1.0 && rim.stretch() <= MOST_STRETCH;
        is_known.then(|| Self {
            root,
            center,
            rim,
            inside: OnceLock::new(),
            radius: OnceLock::new(),
            positions: OnceLock::new(),
        })
    }

    fn solved(&self) -> &dyn SolvedRegion {
        &*self.root.solved
    }

    /// Root's disk → this one, and back.
    #[inline(never)]
    fn ways(&self) -> &[Automorphism; 2] {
        self.inside.get_or_init(|| {
            let known = self.solved().to_disk(self.center).map(|point| self.solved().flat(point));
            let way = known.filter(|a| a.norm() < 1.0).map_or(self.rim, Automorphism::new);
            [way, way.inverse()]
        })
    }

    /// Root's disk → this one.
    fn way(&self) -> &Automorphism {
        &self.ways()[0]
    }

    /// This disk → the root's.
    fn back(&self) -> &Automorphism {
        &self.ways()[1]
    }

    /// The points before this disk's turn and automorphism: outside the closed disk there are none.
    fn before(&self, images: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let (way, turn) = (self.back(), turn.conj());
        let before = |w: Complex64| if is_outside_disk(w) { NOWHERE } else { way.apply(onto_disk(w)) };
        images.iter().map(|w| before(turn * w)).collect()
    }

    /// Where a vertex goes, in the root's disk.
    fn vertex(&self, vertex: usize) -> Complex64 {
        Complex64::cis(TAU * self.solved().vertex_measures()[vertex])
    }
}

impl SolvedRegion for Recentred {
    fn evidence(&self) -> Evidence {
        let known = self.solved().evidence();
        let stretch = self.rim.stretch();
        Evidence {
            residual: known.residual * stretch,
            error_estimate: known.error_estimate * stretch * (1.0 + self.rim.zero().norm()),
            stop: Stop::Tolerance,
            ..known
        }
    }

    /// 1/|g'| = (1 − |a|²)/|f'|, f' by Cauchy's formula on a circle.
    fn conformal_radius(&self) -> f64 {
        *self.radius.get_or_init(|| {
            let nearest = self.root.region.nearest(self.center).point;
            let radius = SHARE_OF_DISTANCE * (nearest - self.center).norm();
            let sum: Complex64 = (0..AROUND)
                .map(|k| Complex64::cis(TAU * k as f64 / AROUND as f64))
                .map(|e| self.solved().to_disk_directly(self.center + e * radius).unwrap_or(NOWHERE) / e)
                .sum();
            (1.0 - self.rim.zero().norm_sqr()) * radius * AROUND as f64 / sum.norm()
        })
    }

    fn root(&self) -> Option<&Root> {
        Some(&self.root)
    }

    fn with_center(
        &self,
        center: Complex64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Arc<dyn SolvedRegion>> {
        self.solved().with_center(center, options, progress)
    }

    fn vertex_measures(&self) -> Vec<f64> {
        self.solved().vertex_measures().into_iter().map(|measure| self.rim.share(measure)).collect()
    }

    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        self.rim.share(self.solved().measure_at(point))
    }

    fn boundary_point(&self, measure: f64) -> BoundaryPoint {
        self.solved().boundary_point(self.rim.inverse().share(measure))
    }

    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.to_disk_with_slope(z).map(|(point, _)| point)
    }

    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        let (point, slope) = self.solved().to_disk_with_slope(z)?;
        if point.chart != 0 {
            return Some((point, slope));
        }
        let way = self.way();
        Some((point.map(|w| way.apply(w)), slope * way.slope(point.w)))
    }

    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64> {
        self.solved().to_disk_directly(z).map(|w| onto_disk(self.rim.apply(w)))
    }

    fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.from_disk_with_slope(point).map(|(z, _)| z)
    }

    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        if point.chart != 0 {
            return self.solved().from_disk_with_slope(point);
        }
        if is_outside_disk(point.w) {
            return None;
        }
        let (w, way) = (onto_disk(point.w), self.back());
        let (z, slope) = self.solved().from_disk_with_slope(DiskPoint::flat(onto_disk(way.apply(w))))?;
        Some((z, slope * way.slope(w)))
    }

    fn beside(&self, vertex: usize, z: Complex64) -> Option<(usize, Complex64)> {
        let (chart, angle) = self.solved().beside(vertex, z)?;
        let moved = if chart == 0 { self.way().angle_from(self.vertex(vertex), angle) } else { angle };
        Some((chart, moved))
    }

    fn from_beside(&self, vertex: usize, chart: usize, angle: Complex64) -> Option<(Complex64, Complex64)> {
        if chart != 0 {
            return self.solved().from_beside(vertex, chart, angle);
        }
        let origin = self.vertex(vertex);
        let (image, way) = (self.way().apply(origin), self.back());
        let before = way.angle_from(image, angle);
        let (z, slope) = self.solved().from_beside(vertex, chart, before)?;
        let [w, v] = [(origin, before), (image, angle)].map(|(from, angle)| from * (Complex64::I * angle).exp());
        Some((z, slope * way.slope(v) * v / w))
    }

    fn flat(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 { point.w } else { self.way().apply(self.solved().flat(point)) }
    }

    fn flat_slope(&self, point: DiskPoint) -> Complex64 {
        if point.chart == 0 {
            return Complex64::ONE;
        }
        self.way().slope(self.solved().flat(point)) * self.solved().flat_slope(point)
    }

    fn images(&self, points: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let way = self.way();
        let mut images = self.solved().images(points, Complex64::ONE);
        images.iter_mut().for_each(|w| *w = onto_disk(turn * way.apply(*w)));
        images
    }

    fn places(&self, images: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        self.solved().places(&self.before(images, turn), Complex64::ONE)
    }

    fn slopes(&self, points: &[Complex64], turn: Complex64) -> Vec<Complex64> {
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.jets(points, turn, &mut jets);
        jets.iter().map(|jet| jet.dz).collect()
    }

    fn jets(&self, points: &[Complex64], turn: Complex64, jets: &mut [Jet]) {
        let way = self.way();
        self.solved().jets(points, Complex64::ONE, jets);
        for jet in jets {
            *jet = Jet::analytic(onto_disk(turn * way.apply(jet.value)), turn * way.slope(jet.value) * jet.dz);
        }
    }

    fn inverse_jets(&self, images: &[Complex64], turn: Complex64, jets: &mut [Jet]) {
        let way = self.back();
        self.solved().inverse_jets(&self.before(images, turn), Complex64::ONE, jets);
        let turn = turn.conj();
        for (jet, w) in jets.iter_mut().zip(images) {
            jet.dz *= turn * way.slope(turn * w);
        }
    }

    fn crowded(&self) -> Option<Complex64> {
        self.solved().crowded()
    }

    fn positions(&self) -> &[Position] {
        self.positions.get_or_init(|| self.positions_from(Position::FIRST))
    }

    fn positions_from(&self, first: Position) -> Vec<Position> {
        let way = self.way();
        let is_same = way.zero() == Complex64::ZERO;
        let of_root = if is_same { first.clone() } else { first.next(way.apply(Complex64::ZERO), way.zero()) };
        let mut positions = self.solved().positions_from(of_root);
        positions[0] = first;
        positions
    }

    fn prepare(&self, progress: Progress) -> Result<()> {
        self.solved().prepare(progress)
    }

    fn store(&self, to: &mut Writer) {
        self.solved().store(to);
    }

    fn bytes(&self) -> usize {
        self.solved().bytes()
    }
}
