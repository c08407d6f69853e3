//! Region → region, through the disk.

use super::{Compose, Inverse, InvertibleMap, Jet, PlaneMap, RiemannMap};
use crate::plane::Complex64;

/// The conformal map region a → region b that takes center to center and `toward` to `toward`: b's Riemann map undone after
/// a's.
///
/// ```
/// use conformal_warp::map::{RegionMap, RiemannMap, SolveOptions};
/// use conformal_warp::plane::{Complex64, Curve, Region};
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
}

impl RegionMap {
    /// The map from a's region to b's. Both keep what they have built; nothing is solved.
    #[must_use]
    pub fn between(a: &RiemannMap, b: &RiemannMap) -> Self {
        Self { a: a.clone(), b: b.clone() }
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

    /// Region a → region b. NaN outside the closed region a.
    ///
    /// What one region crowds into an arc of the circle that double precision cannot resolve has no certain place in the
    /// other (see [`RiemannMap::from_disk`]).
    #[must_use]
    pub fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.b.from_disk(&self.a.to_disk(points))
    }

    /// Region b → region a. NaN outside the closed region b.
    #[must_use]
    pub fn inverse(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.a.from_disk(&self.b.to_disk(points))
    }

    /// The derivative of [`RegionMap::forward`].
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.jets(points, &mut jets);
        jets.iter().map(|jet| jet.dz).collect()
    }
}

/// Region a → region b.
impl PlaneMap for RegionMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        Compose { outer: Inverse(&self.b), inner: &self.a }.jets(points, jets);
    }

    fn inverse(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for RegionMap {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        Compose { outer: Inverse(&self.a), inner: &self.b }.jets(points, jets);
    }
}
