//! Region → region, through the disk.

use super::RiemannMap;
use super::atlas::Passage;
use super::doubt::Doubt;
use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap, pointwise};
use crate::plane::{BoundaryPoint, Complex64, NOWHERE};
use crate::stored::{Kind, read, written_in};
use crate::{Error, Result};
use std::sync::{Arc, OnceLock};

/// The conformal map region a → region b that takes center to center and `toward` to `toward`: b's Riemann map undone after
/// a's.
///
/// ```
/// use conformal_warp::{Complex64, Curve, Region, RegionMap, RiemannMap, SolveOptions};
/// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let turned = square.map(|z| Complex64::new(0.0, 3.0) * z);
/// let solve = |vertices: &[Complex64]| {
///     let region = Region::new(vertices, Curve::Polygon, Complex64::new(0.0, 0.0), vertices[0])?;
///     RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)
/// };
/// let map = RegionMap::between(&solve(&square)?, &solve(&turned)?);
/// let z = Complex64::new(0.3, 0.9);
/// assert!((map.forward(&[z])[0] - Complex64::new(0.0, 3.0) * z).norm() < 1e-7);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct RegionMap {
    a: RiemannMap,
    b: RiemannMap,
    /// How the disks lie on each other; worked out on first use.
    joint: Arc<OnceLock<Joint>>,
}

/// Two disks laid on each other.
#[derive(Debug)]
struct Joint {
    /// Disk of a → disk of b, and back.
    passages: [Passage; 2],
    /// What that leaves open in a, and in b.
    doubts: [Doubt; 2],
}

/// Where a point goes.
enum Image {
    /// There.
    At(Complex64),
    /// Nowhere: it lies outside.
    Outside,
    /// Nobody can tell.
    Untold,
}

/// No map is more accurate than this, some roundings of numbers near 1.
const ROUNDING: f64 = 1e-15;

impl RegionMap {
    /// The map from a's region to b's. Both keep what they have built; nothing is solved.
    #[must_use]
    pub fn between(a: &RiemannMap, b: &RiemannMap) -> Self {
        Self { a: a.clone(), b: b.clone(), joint: Arc::default() }
    }

    /// Both maps as bytes, from which [`RegionMap::from_bytes`] makes the same map, to the bit, without solving.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let format = self.a.format().max(self.b.format());
        written_in(format, Kind::Region, |to| [&self.a, &self.b].into_iter().for_each(|map| map.store(to)))
    }

    /// The map that [`RegionMap::to_bytes`] stored.
    ///
    /// # Errors
    /// As [`RiemannMap::from_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        read(Kind::Region, bytes, |from| {
            let (a, b) = (RiemannMap::restore(from)?, RiemannMap::restore(from)?);
            Ok(Self::between(&a, &b))
        })
    }

    /// The map of the region it comes from.
    #[must_use]
    pub fn source(&self) -> &RiemannMap {
        &self.a
    }

    /// The map of the region it goes to.
    #[must_use]
    pub fn target(&self) -> &RiemannMap {
        &self.b
    }

    /// Region a → region b. NaN outside the closed region a, and where nobody can tell; boundary points go to the boundary.
    ///
    /// The far ends of long regions do not get lost between: their points are carried from chart to chart
    /// ([`RiemannMap::to_disk_points`]) and never become numbers that crowd together on one circle. What remains is the
    /// nature of the map: where a far end of b belongs to a spot of a that is smaller than the distance of neighbouring
    /// numbers, or than the error of the solves, no point of a can be told from the next there. Two far ends correspond
    /// as exactly as their directions from the centers are known: exactly if `toward` lies in them or if a and b are one
    /// map, else to the error of the solves, which grows by e^h at the hyperbolic distance h from the way to `toward`. Where
    /// that could have brought a point to another place of b, its image to another of a, and either is off by more than a
    /// hundredth of the region's size (or 100 times the errors, if that is more), there is no answer:
    /// [`RegionMap::try_forward`] says so.
    #[must_use]
    pub fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.way().values(points)
    }

    /// Region b → region a. NaN outside the closed region b. As [`RegionMap::forward`] in everything else.
    #[must_use]
    pub fn inverse(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.way_back().values(points)
    }

    /// [`RegionMap::forward`], if all points can be told.
    ///
    /// # Errors
    /// [`Error::TooFarApart`] with the first point whose image nobody can tell.
    pub fn try_forward(&self, points: &[Complex64]) -> Result<Vec<Complex64>> {
        self.way().told_values(points)
    }

    /// [`RegionMap::inverse`], if all points can be told.
    ///
    /// # Errors
    /// As [`RegionMap::try_forward`].
    pub fn try_inverse(&self, points: &[Complex64]) -> Result<Vec<Complex64>> {
        self.way_back().told_values(points)
    }

    /// Whether nobody can tell how parts of the regions belong together that hold vertices.
    ///
    /// # Errors
    /// [`Error::TooFarApart`] with such a vertex, of either region.
    pub fn check(&self) -> Result<()> {
        self.try_forward(self.a.region().boundary())?;
        self.try_inverse(self.b.region().boundary())?;
        Ok(())
    }

    /// The derivative of [`RegionMap::forward`], units of b per unit of a. NaN outside the closed region a.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.jets(points, &mut jets);
        jets.iter().map(|jet| jet.dz).collect()
    }

    /// Boundary of region a → boundary of region b, as [`RegionMap::forward`] takes it.
    #[must_use]
    pub fn boundary_forward(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.way().boundary_point(point)
    }

    /// Boundary of region b → boundary of region a; the inverse of [`RegionMap::boundary_forward`].
    #[must_use]
    pub fn boundary_inverse(&self, point: BoundaryPoint) -> BoundaryPoint {
        self.way_back().boundary_point(point)
    }

    fn way(&self) -> Way<'_> {
        let Joint { passages: [passage, _], doubts: [here, there] } = self.joint();
        Way { from: &self.a, to: &self.b, passage, here, there }
    }

    fn way_back(&self) -> Way<'_> {
        let Joint { passages: [_, passage], doubts: [there, here] } = self.joint();
        Way { from: &self.b, to: &self.a, passage, here, there }
    }

    fn joint(&self) -> &Joint {
        self.joint.get_or_init(|| {
            let (a, b) = (self.a.compass(), self.b.compass());
            let errors = self.a.error_estimate() + self.b.error_estimate() + ROUNDING;
            let error = if self.a.is_same(&self.b) { 0.0 } else { errors };
            Joint {
                passages: [Passage::new(&a, &b), Passage::new(&b, &a)],
                doubts: [Doubt::new(&self.a, &a, error), Doubt::new(&self.b, &b, error)],
            }
        })
    }
}

/// One of the two directions.
struct Way<'a> {
    from: &'a RiemannMap,
    to: &'a RiemannMap,
    passage: &'a Passage,
    /// What is open of places in `from`,
    here: &'a Doubt,
    /// and in `to`.
    there: &'a Doubt,
}

impl Way<'_> {
    fn values(&self, points: &[Complex64]) -> Vec<Complex64> {
        let value = |&z| match self.image(z) {
            Image::At(image) => image,
            Image::Outside | Image::Untold => NOWHERE,
        };
        points.iter().map(value).collect()
    }

    fn told_values(&self, points: &[Complex64]) -> Result<Vec<Complex64>> {
        let value = |&z| match self.image(z) {
            Image::At(image) => Ok(image),
            Image::Outside => Ok(NOWHERE),
            Image::Untold => Err(Error::TooFarApart { at: z }),
        };
        points.iter().map(value).collect()
    }

    fn image(&self, z: Complex64) -> Image {
        let carried = |point| self.to.solved().from_disk(self.passage.carry(point).0);
        match self.from.solved().to_disk(z).and_then(carried) {
            None => Image::Outside,
            Some(image) if self.is_told(z, image) => Image::At(image),
            Some(_) => Image::Untold,
        }
    }

    /// Whether z and its image belong together at least roughly: it is enough if one of them is known.
    fn is_told(&self, z: Complex64, image: Complex64) -> bool {
        !(self.there.doubts(self.to, image) && self.here.doubts(self.from, z))
    }

    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let (from, to) = (self.from.solved(), self.to.solved());
        pointwise(points, jets, |z| {
            let (point, slope) = from.to_disk_with_slope(z)?;
            let (point, carried) = self.passage.carry(point);
            let (image, back) = to.from_disk_with_slope(point)?;
            self.is_told(z, image).then(|| Jet::analytic(image, slope * carried * back))
        });
    }

    fn boundary_point(&self, point: BoundaryPoint) -> BoundaryPoint {
        let (from, to) = (self.from.solved(), self.to.solved());
        let image = from.to_disk(point.point).and_then(|p| to.from_disk(self.passage.carry(p.onto_circle()).0));
        match image {
            Some(image) => self.to.region().nearest(image),
            // Rounding put the point outside the region.
            None => self.to.boundary_point(self.from.boundary_angle(point)),
        }
    }
}

/// Region a → region b.
impl PlaneMap for RegionMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.way().jets(points, jets);
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for RegionMap {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.way_back().jets(points, jets);
    }
}
