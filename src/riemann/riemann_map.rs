//! The Riemann map of a region, by Symm's method.

use super::atlas::{Compass, DiskPoint, Position};
use super::curved::SolvedEdges;
use super::polygon::SolvedPolygon;
use super::recentred::Recentred;
use super::rounding::onto_disk;
use super::smooth::SolvedCurve;
use super::solved_region::{Root, SolvedRegion};
use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap};
use crate::plane::{BoundaryPoint, Complex64, Curve, NOWHERE, Region};
use crate::stored::{Kind, RECENTRED, Reader, SOLVED, Writer, read, written_in};
use crate::symm::correspondence::angle_of_measure;
use crate::symm::options::{Progress, SolveOptions, Stop};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The conformal map region → unit disk with `center` ↦ 0 and `toward` ↦ 1.
///
/// f(z) = e^{iφ} (z − z₀) exp(−∫ log(z − y) dμ(y)), μ the harmonic measure seen from z₀ = `center`, which solves
/// ∫ log|x − y| dμ(y) + c = log|x − z₀| on the boundary (Frederick & Schwartz 1988, appendix 2, with g = −∫ log|z − y| dμ).
///
/// ```
/// use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
/// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let region = Region::new(&square, Curve::Polygon, Complex64::new(0.0, 0.0), square[0])?;
/// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((map.conformal_radius() - 1.0787052023767587).abs() < map.error_estimate());
/// assert!((map.angles()[1] - std::f64::consts::FRAC_PI_2).abs() < map.error_estimate());
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RiemannMap {
    region: Region,
    options: SolveOptions,
    /// Shared by clones.
    solved: Arc<dyn SolvedRegion>,
    /// Measure from vertex 0 to `toward`.
    toward_measure: f64,
    angles: Vec<f64>,
}

impl RiemannMap {
    /// Solves for the map of `region`. `progress` hears the stage and the fraction done, and cancels by returning false.
    ///
    /// # Errors
    /// [`Error::InvalidOption`](crate::Error::InvalidOption), [`Error::Cancelled`](crate::Error::Cancelled), and
    /// [`Error::NegativeMass`](crate::Error::NegativeMass) if no trustworthy map was found.
    pub fn solve(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let straight = region.straightened();
        let bounded = straight.as_ref().unwrap_or(region);
        let solved: Arc<dyn SolvedRegion> = if let Some(edges) = SolvedEdges::solve(bounded, options, progress)? {
            Arc::new(edges)
        } else if let Some(curve) = SolvedCurve::solve(bounded, options, progress)? {
            Arc::new(curve)
        } else {
            Arc::new(SolvedPolygon::solve(bounded, options, progress)?)
        };
        Ok(Self::new(region.clone(), options, solved))
    }

    /// The map of the same region for another center and direction, from what was solved before: moving only `toward` is a
    /// rotation. For another center it is the map that was solved, followed by an automorphism of the disk, which stretches
    /// errors: as long as [`RiemannMap::error_estimate`] then still meets the tolerance, nothing is solved or built. Otherwise
    /// the old panels serve, if they do within the tolerance; they are refined where they do not, as for a center much nearer
    /// to the boundary.
    ///
    /// # Errors
    /// As [`RiemannMap::solve`] and [`Region::new`].
    pub fn with_center(&self, center: Complex64, toward: Complex64, progress: Progress) -> Result<Self> {
        self.with_center_within(center, toward, self.options.tolerance, progress)
    }

    /// [`RiemannMap::with_center`] with another tolerance: with a looser one than the map was solved with, centers far from the
    /// one that it was solved for need no new solve, as long as `tolerance` covers what that costs.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
    /// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
    /// let region = Region::new(&square, Curve::Polygon, Complex64::new(0.0, 0.0), square[0])?;
    /// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
    /// let center = Complex64::new(0.7, 0.4);
    /// let moved = map.with_center_within(center, square[0], 1e-5, &mut |_, _| true)?;
    /// assert!(moved.to_disk(&[center])[0].norm() < 1e-14 && moved.error_estimate() <= 1e-5);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`RiemannMap::with_center`], and [`Error::InvalidOption`](crate::Error::InvalidOption).
    pub fn with_center_within(
        &self,
        center: Complex64,
        toward: Complex64,
        tolerance: f64,
        progress: Progress,
    ) -> Result<Self> {
        let options = SolveOptions { tolerance, ..self.options.clone() };
        options.validate()?;
        let region = self.region.with_center(center, toward)?;
        let root = self.root();
        let is_enough = |solved: &dyn SolvedRegion| solved.evidence().error_estimate <= tolerance;
        let solved = if center == self.region.center() && (root.is_none() || is_enough(&*self.solved)) {
            Arc::clone(&self.solved)
        } else {
            let root = root.unwrap_or_else(|| self.as_root());
            match Recentred::new(root.clone(), center) {
                _ if center == root.region.center() => root.solved,
                Some(recentred) if is_enough(&recentred) => Arc::new(recentred),
                _ => root.solved.with_center(center, &options, progress)?,
            }
        };
        Ok(Self::new(region, &options, solved))
    }

    /// What this is seen from another center, if it is.
    fn root(&self) -> Option<Root> {
        self.solved.root().cloned()
    }

    /// This as what others are seen from.
    fn as_root(&self) -> Root {
        Root { region: self.region.clone(), options: self.options.clone(), solved: Arc::clone(&self.solved) }
    }

    /// The solved map as bytes: the region, the options and the solution, from which [`RiemannMap::from_bytes`] makes the same
    /// map, to the bit, without solving. About as many as the solve had unknowns, times eight; an evaluator is not among them.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
    /// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
    /// let region = Region::new(&square, Curve::Polygon, Complex64::new(0.0, 0.0), square[0])?;
    /// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
    /// let again = RiemannMap::from_bytes(&map.to_bytes())?;
    /// let z = [Complex64::new(0.9, -0.3)];
    /// assert_eq!(again.to_disk(&z), map.to_disk(&z));
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        written_in(self.format(), Kind::Riemann, |to| self.store(to))
    }

    /// The map that [`RiemannMap::to_bytes`] stored, by this version or an older one.
    ///
    /// The bytes may come from anywhere: what is not a whole map, unchanged, is refused. No array is made that is longer than
    /// the bytes bear out; altogether it takes no more memory than solving for a region of so many vertices. The system that
    /// [`RiemannMap::with_center`] needs is assembled when that is first called.
    ///
    /// # Errors
    /// [`Error::NotStored`](crate::Error::NotStored), [`Error::OtherFormat`](crate::Error::OtherFormat),
    /// [`Error::Damaged`](crate::Error::Damaged), and those of [`Region::new`] for bytes that somebody made up.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        read(Kind::Riemann, bytes, Self::restore)
    }

    /// The format that holds it.
    pub(super) fn format(&self) -> u16 {
        if self.solved.root().is_some() { RECENTRED } else { SOLVED }
    }

    pub(super) fn store(&self, to: &mut Writer) {
        let root = self.solved.root();
        if to.format() >= RECENTRED {
            to.case(u8::from(root.is_some()));
        }
        let Some(root) = root else {
            return store_solved(&self.region, &self.options, &*self.solved, to);
        };
        store_solved(&root.region, &root.options, &*root.solved, to);
        self.region.store_points(to);
        self.options.store(to);
    }

    pub(super) fn restore(from: &mut Reader) -> Result<Self> {
        let is_recentred = from.format() >= RECENTRED && from.case()? != 0;
        let root = restore_solved(from)?;
        if !is_recentred {
            return Ok(Self::new(root.region, &root.options, root.solved));
        }
        let region = root.region.restore_points(from)?;
        let options = SolveOptions::restore(from)?;
        let unknown = Error::Damaged { reason: "its center is not one that it knows" };
        let solved = Recentred::new(root, region.center()).ok_or(unknown)?;
        Ok(Self::new(region, &options, Arc::new(solved)))
    }

    fn new(region: Region, options: &SolveOptions, solved: Arc<dyn SolvedRegion>) -> Self {
        let toward_measure = solved.measure_at(region.toward());
        let measures = solved.vertex_measures();
        let angles = measures.iter().map(|measure| angle_of_measure(measure - toward_measure)).collect();
        Self { region, options: options.clone(), solved, toward_measure, angles }
    }

    /// The region it maps.
    #[must_use]
    pub fn region(&self) -> &Region {
        &self.region
    }

    /// Angle of each boundary vertex on the circle, in [0, 2π); `toward` is at 0.
    #[must_use]
    pub fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// Boundary of the region → angle on the circle, in [0, 2π).
    #[must_use]
    pub fn boundary_angle(&self, point: BoundaryPoint) -> f64 {
        angle_of_measure(self.solved.measure_at(point) - self.toward_measure)
    }

    /// [`RiemannMap::boundary_angle`] in [0, 2π], rising all the way from `toward` round to it: rounding never carries a
    /// point across.
    pub(crate) fn angle_from_toward(&self, point: BoundaryPoint) -> f64 {
        let toward = self.region.toward();
        let before = (point.edge, point.t) < (toward.edge, toward.t);
        let measure = self.solved.measure_at(point) - self.toward_measure + if before { 1.0 } else { 0.0 };
        TAU * measure.clamp(0.0, 1.0)
    }

    /// Angle on the circle → boundary of the region; the inverse of [`RiemannMap::boundary_angle`].
    #[must_use]
    pub fn boundary_point(&self, angle: f64) -> BoundaryPoint {
        self.solved.boundary_point(angle / TAU + self.toward_measure)
    }

    /// Region → disk. NaN outside the closed region; boundary points go to the circle.
    ///
    /// Accurate to the solve everywhere, up to the walls. The first call builds an evaluator (see [`RiemannMap::prepare`]);
    /// from then on a million points take a fraction of a second. A point's image depends on nothing but the point.
    #[must_use]
    pub fn to_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.solved.images(points, self.turn())
    }

    /// Disk → region, the inverse of [`RiemannMap::to_disk`]. NaN outside the closed disk; the circle goes to the boundary.
    ///
    /// Where a region is long, its far parts crowd into arcs of the circle that double precision cannot tell apart:
    /// beyond a harmonic measure of about 1e-13 a point w names a place only roughly. [`RiemannMap::to_disk_points`]
    /// and [`RiemannMap::from_disk_points`] do not have that limit.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
    /// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
    /// let region = Region::new(&square, Curve::Polygon, Complex64::new(0.0, 0.0), square[0])?;
    /// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
    /// let z = Complex64::new(0.9, -0.3);
    /// let back = map.from_disk(&map.to_disk(&[z]));
    /// assert!((back[0] - z).norm() < 1e-8);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    #[must_use]
    pub fn from_disk(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.solved.places(points, self.turn())
    }

    /// f' of the map region → disk, per plane unit. NaN outside the closed region; infinite at a re-entrant vertex.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.solved.slopes(points, self.turn())
    }

    /// Region → disk, as points that keep their places apart also where numbers cannot.
    #[must_use]
    pub fn to_disk_points(&self, points: &[Complex64]) -> Vec<DiskPoint> {
        let solved = self.solved();
        points.iter().map(|&z| solved.to_disk(z).map_or(DiskPoint::NOWHERE, |point| point.map(onto_disk))).collect()
    }

    /// Disk → region: the inverse of [`RiemannMap::to_disk_points`] of the same map.
    #[must_use]
    pub fn from_disk_points(&self, points: &[DiskPoint]) -> Vec<Complex64> {
        let solved = self.solved();
        points.iter().map(|&point| solved.from_disk(point).unwrap_or(NOWHERE)).collect()
    }

    /// Bytes of memory that the evaluator takes; 0 before its first use.
    #[must_use]
    pub fn evaluator_bytes(&self) -> usize {
        self.solved.bytes()
    }

    /// Number of centers whose maps are linked to serve the whole region; 1 unless a part of it is far away.
    #[must_use]
    pub fn charts(&self) -> usize {
        self.solved.positions().len()
    }

    /// Where evaluation had to accept that far parts of a region crowd together, because `max_charts` or their solves left
    /// no other way: a place (plane units) where it is worst. Errors in the plane are there more than twenty times those in
    /// the disk. `None` if there is no such place. Builds the way to the disk, as the first [`RiemannMap::to_disk`] does.
    #[must_use]
    pub fn crowded_at(&self) -> Option<Complex64> {
        self.solved.crowded()
    }

    /// Builds the evaluator now, both ways and for far ends too, instead of at its first use each way. That takes seconds for
    /// thousands of vertices and for long corridors; afterwards no call for points has anything left to build. `progress` as in
    /// [`RiemannMap::solve`]; it hears from all parts of the work.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled). Parts that are finished by then are kept, no half ones, and the map is as usable as before.
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        self.solved.prepare(progress)
    }

    /// Whether both are solutions of one problem that agree to the last bit.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.region == other.region && self.options == other.options && self.angles == other.angles
    }

    pub(super) fn solved(&self) -> &dyn SolvedRegion {
        &*self.solved
    }

    /// Where the charts lie with respect to `toward`.
    pub(super) fn compass(&self) -> Compass<'_> {
        let positions = self.solved.positions();
        let flat = Position::FIRST.direction_of(TAU * self.toward_measure);
        // Its own chart knows best where a far one is.
        let seen = |point: DiskPoint| positions[point.chart].direction_of(point.w.arg());
        let known = self.solved.to_disk(self.region.toward().point).filter(|point| point.chart != 0);
        Compass { positions, toward: known.map_or(flat, seen) }
    }

    /// The rotation that puts `toward` at 1.
    fn turn(&self) -> Complex64 {
        Complex64::cis(-TAU * self.toward_measure)
    }

    /// [`RiemannMap::to_disk`] by direct summation over the boundary: slow, and independent of the evaluator.
    #[must_use]
    pub fn to_disk_directly(&self, points: &[Complex64]) -> Vec<Complex64> {
        let turn = self.turn();
        points.iter().map(|&z| self.solved.to_disk_directly(z).map_or(NOWHERE, |w| onto_disk(turn * w))).collect()
    }

    /// |f'(center)|⁻¹, in plane units: exp ∫ log|y − z₀| dμ(y).
    #[must_use]
    pub fn conformal_radius(&self) -> f64 {
        self.solved.conformal_radius()
    }

    /// Largest violation of the boundary condition log|f| = 0 at points where it was not imposed.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.solved.evidence().residual
    }

    /// Estimate of the largest error of the map anywhere in the region, in units of the disk.
    #[must_use]
    pub fn error_estimate(&self) -> f64 {
        self.solved.evidence().error_estimate
    }

    /// Number of unknowns of the last system solved.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.solved.evidence().unknowns
    }

    /// Why the solve ended: with the tolerance met, or short of it.
    #[must_use]
    pub fn stop(&self) -> Stop {
        self.solved.evidence().stop
    }
}

fn store_solved(region: &Region, options: &SolveOptions, solved: &dyn SolvedRegion, to: &mut Writer) {
    region.store(to);
    options.store(to);
    solved.store(to);
}

fn restore_solved(from: &mut Reader) -> Result<Root> {
    let region = Region::restore(from)?;
    let options = SolveOptions::restore(from)?;
    let straight = region.straightened();
    let bounded = straight.as_ref().unwrap_or(&region);
    let solved: Arc<dyn SolvedRegion> = match bounded.curve() {
        Curve::Smooth => Arc::new(SolvedCurve::restore(bounded, from)?),
        Curve::Polygon => Arc::new(SolvedPolygon::restore(bounded, &options, from)?),
        Curve::Edges => Arc::new(SolvedEdges::restore(bounded, from)?),
    };
    Ok(Root { region, options, solved })
}

/// Region → disk.
impl PlaneMap for RiemannMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.solved.jets(points, self.turn(), jets);
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

/// Disk → region.
impl InvertibleMap for RiemannMap {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.solved.inverse_jets(points, self.turn(), jets);
    }
}
