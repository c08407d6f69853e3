//! A solved boundary of analytic edges: Symm's equation on panels over the edges' parameters, evaluated by Cauchy's formula.

use super::atlas::DiskPoint;
use super::atlas::quadtree::square_around;
use super::cauchy_tree::{CauchyTree, Leaf};
use super::rounding::{is_on_circle, is_outside_disk, onto_disk};
use super::solved_region::{Evidence, SolvedRegion};
use crate::plane::{BoundaryPoint, Complex64, CurvedOutline, CutHorns, Region};
use crate::stored::{Reader, Writer};
use crate::symm::curved::cauchy::Side;
use crate::symm::curved::solution::CurvedSolution;
use crate::symm::curved::solve::{solve_curved, solve_curved_again};
use crate::symm::options::{Progress, SolveOptions};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// The solution of a region with curved edges.
#[derive(Debug)]
pub(super) struct SolvedEdges {
    /// Where `region` has its 0.
    origin: Complex64,
    region: Region,
    /// The boundary that was solved: the region's, but for the tips of horns.
    outline: Arc<CurvedOutline>,
    /// What was cut off: of less measure than rounding.
    horns: Option<CutHorns>,
    solution: CurvedSolution,
    /// Region → disk, and back; made when first asked for.
    trees: OnceLock<[CauchyTree; 2]>,
}

/// Series err by at most this share of the solve: where the region is narrow, an error in it is larger in the disk.
const SHARE_OF_ERROR: f64 = 1e-3;
/// They err by no more.
const LARGEST_ERROR: f64 = 1e-6;

impl SolvedEdges {
    fn new(origin: Complex64, region: Region, boundary: Boundary, solution: CurvedSolution) -> Self {
        let (outline, horns) = boundary;
        Self { origin, region, outline, horns, solution, trees: OnceLock::new() }
    }

    /// Good to [`SolvedEdges::series_error`].
    fn trees(&self) -> &[CauchyTree; 2] {
        self.trees.get_or_init(|| {
            let (low, high) = self.outline.polygon().bounds();
            let square = square_around(&[low * self.unit(), high * self.unit()]);
            let parts = self.solution.parts();
            let disk = (Complex64::ZERO, 1.0 + 1e-9);
            [(square, Side::Region), (disk, Side::Disk)]
                .map(|(square, side)| CauchyTree::new(square, side, parts, Complex64::ZERO, self.series_error()))
        })
    }

    fn series_error(&self) -> f64 {
        (SHARE_OF_ERROR * self.solution.error_estimate).clamp(f64::EPSILON, LARGEST_ERROR)
    }

    /// (f, f') at a point of the open region, in scaled units.
    fn inside(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let [tree, _] = self.trees();
        match tree.find(z, &self.solution) {
            Some(Leaf::Series(series)) => Some(series.at(z)),
            Some(Leaf::Near(sums)) => self.solution.to_disk_by(z, &|z| tree.near(sums, z, &self.solution)),
            _ => self.solution.to_disk(z),
        }
    }

    /// Solves Symm's equation for the edges that bound a region; `None` if it is bounded by something else.
    ///
    /// # Errors
    /// As [`solve_curved`].
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Option<Self>> {
        let (origin, region) = region.local();
        Self::solve_local(origin, region, options, progress)
    }

    fn solve_local(
        origin: Complex64,
        region: Region,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Option<Self>> {
        let Some(boundary) = without_tips(&region)? else { return Ok(None) };
        let solution = solve_curved(&boundary.0, region.center(), options, progress)?;
        Ok(Some(Self::new(origin, region, boundary, solution)))
    }

    /// Reads what [`SolvedRegion::store`] wrote.
    ///
    /// # Errors
    /// As [`CurvedSolution::restore`].
    pub fn restore(region: &Region, from: &mut Reader) -> Result<Self> {
        let (origin, region) = region.local();
        let damaged = Error::Damaged { reason: "its boundary does not consist of edges" };
        let boundary = without_tips(&region)?.ok_or(damaged)?;
        let solution = CurvedSolution::restore(&boundary.0, region.center(), from)?;
        Ok(Self::new(origin, region, boundary, solution))
    }

    fn unit(&self) -> f64 {
        self.solution.unit()
    }

    /// The point of the outline at edge and parameter, in plane units.
    fn place(&self, (edge, t): (usize, f64)) -> BoundaryPoint {
        let (edge, t) = self.horns.as_ref().map_or((edge, t), |horns| horns.outer(edge, t));
        let place = self.region.curved().unwrap_or(&self.outline).place(edge, t);
        BoundaryPoint { point: place.point + self.origin, ..place }
    }

    /// Edge and parameter of the region's boundary → of the one that was solved.
    fn solved(&self, place: BoundaryPoint) -> (usize, f64) {
        self.horns.as_ref().map_or((place.edge, place.t), |horns| horns.inner(place.edge, place.t))
    }

    /// Where the tip of the horn that holds `z` goes, if one does: all that is in it lies there up to rounding, and the map stands still.
    fn in_tip(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let horns = self.horns.as_ref()?;
        if !self.region.contains(z) || self.outline.contains(z) {
            return None;
        }
        let place = self.region.nearest(z);
        let (w, _) = self.solution.on_circle(horns.behind(place.edge, place.t)?, 0.0);
        Some((w, Complex64::ZERO))
    }
}

/// The boundary to be solved, with what was cut off.
type Boundary = (Arc<CurvedOutline>, Option<CutHorns>);

/// The boundary without the tips of its horns that are not seen from the center; `None` if it does not consist of edges.
fn without_tips(region: &Region) -> Result<Option<Boundary>> {
    let Some(outline) = region.curved() else { return Ok(None) };
    let Some(horns) = outline.horns() else { return Ok(Some((Arc::clone(outline), None))) };
    let cut = horns.unseen(outline.edges(), region.center());
    let outline = CurvedOutline::new(cut.edges()).map_err(|error| cut.named(error))?;
    Ok(Some((Arc::new(outline), Some(cut))))
}

impl SolvedRegion for SolvedEdges {
    fn evidence(&self) -> Evidence {
        let solution = &self.solution;
        Evidence {
            residual: solution.residual,
            error_estimate: solution.error_estimate,
            stop: solution.stop,
            unknowns: solution.masses.len(),
        }
    }

    fn conformal_radius(&self) -> f64 {
        self.solution.conformal_radius()
    }

    fn with_center(
        &self,
        center: Complex64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Arc<dyn SolvedRegion>> {
        let region = self.region.with_center(center - self.origin, self.region.toward().point)?;
        // Other tips are seen from there.
        if self.horns.is_some()
            && let Some(solved) = Self::solve_local(self.origin, region.clone(), options, progress)?
        {
            return Ok(Arc::new(solved));
        }
        let solution = solve_curved_again(&self.solution, region.center(), options, progress)?;
        Ok(Arc::new(Self::new(self.origin, region, (Arc::clone(&self.outline), None), solution)))
    }

    fn vertex_measures(&self) -> Vec<f64> {
        let measures = self.solution.vertex_measures();
        let Some(horns) = &self.horns else { return measures };
        let edges = self.region.curved().map_or(0, |outline| outline.edges().len());
        (0..edges).map(|edge| measures[horns.corner(edge)]).collect()
    }

    fn measure_at(&self, point: BoundaryPoint) -> f64 {
        let (edge, t) = self.solved(point);
        self.solution.measure_at(edge, t)
    }

    fn boundary_point(&self, measure: f64) -> BoundaryPoint {
        self.place(self.solution.locate(measure))
    }

    fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        self.to_disk_with_slope(z).map(|(point, _)| point)
    }

    fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        let z = z - self.origin;
        let [tree, _] = self.trees();
        let scaled = z * self.unit();
        let (w, slope) = match tree.find(scaled, &self.solution) {
            Some(Leaf::Series(series)) => series.at(scaled),
            Some(Leaf::Outside) => self.in_tip(z)?,
            _ => match self.region.on_boundary(z) {
                Some(place) => {
                    let (edge, t) = self.solved(place);
                    self.solution.on_circle(edge, t)
                }
                None if !self.region.contains(z) => return None,
                None => match self.in_tip(z) {
                    Some(found) => found,
                    None => self.inside(scaled)?,
                },
            },
        };
        Some((DiskPoint::flat(onto_disk(w)), slope * self.unit()))
    }

    fn to_disk_directly(&self, z: Complex64) -> Option<Complex64> {
        self.to_disk(z).map(|point| point.w)
    }

    fn from_disk(&self, point: DiskPoint) -> Option<Complex64> {
        self.from_disk_with_slope(point).map(|(z, _)| z)
    }

    fn from_disk_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        if is_outside_disk(point.w) {
            return None;
        }
        if is_on_circle(point.w) {
            let (edge, t) = self.solution.locate(point.w.arg() / TAU);
            let (_, slope) = self.solution.on_circle(edge, t);
            return Some((self.place((edge, t)).point, (slope * self.unit()).inv()));
        }
        let [_, tree] = self.trees();
        let (z, slope) = match tree.find(point.w, &self.solution) {
            Some(Leaf::Series(series)) => {
                let (z, slope) = series.at(point.w);
                let map = |z| self.inside(z);
                self.solution.polished(point.w, (z, slope.inv()), self.series_error(), &map)?
            }
            Some(Leaf::Near(sums)) => {
                let cauchy = |w| tree.near(sums, w, &self.solution);
                self.solution.from_disk_by(point.w, &cauchy, &|z| self.inside(z))?
            }
            _ => self.solution.from_disk(point.w)?,
        };
        Some((z / self.unit() + self.origin, (slope * self.unit()).inv()))
    }

    fn prepare(&self, progress: Progress) -> Result<()> {
        self.trees().iter().try_for_each(|tree| tree.fill(&self.solution, progress))
    }

    fn crowded(&self) -> Option<Complex64> {
        self.solution.crowded().map(|z| z / self.unit() + self.origin)
    }

    fn store(&self, to: &mut Writer) {
        self.solution.store(to);
    }
}
