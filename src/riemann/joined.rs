//! Region → region through a canonical region that both are mapped onto.

use super::{AnnulusMap, ExteriorMap, HalfPlaneMap, RectangleMap, RegionMap, RiemannMap, StripMap};
use crate::map::{Inverse, InvertibleMap, Jet, PlaneMap};
use crate::plane::Complex64;
use crate::{Error, Result};

/// A map onto a canonical region.
#[derive(Clone, Debug)]
pub enum CanonicalMap {
    /// Onto the unit disk.
    Disk(RiemannMap),
    /// Onto a ring.
    Ring(AnnulusMap),
    /// Onto the outside of the unit disk.
    Outside(ExteriorMap),
    /// Onto a rectangle.
    Rectangle(Box<RectangleMap>),
    /// Onto the strip.
    Strip(StripMap),
    /// Onto the half plane.
    HalfPlane(HalfPlaneMap),
}

impl CanonicalMap {
    /// The map itself.
    fn map(&self) -> &dyn InvertibleMap {
        match self {
            Self::Disk(map) => map,
            Self::Ring(map) => map,
            Self::Outside(map) => map,
            Self::Rectangle(map) => &**map,
            Self::Strip(map) => map,
            Self::HalfPlane(map) => map,
        }
    }

    /// A point of the canonical region, brought back onto a ring's circle if it is beyond that by no more than errors: boundaries
    /// go to boundaries.
    fn settled(&self, w: Complex64) -> Complex64 {
        let Self::Ring(map) = self else { return w };
        let radius = w.norm();
        let nearest = radius.clamp(map.inner_radius(), 1.0);
        let beyond = (radius / nearest - 1.0).abs();
        if beyond <= map.error_estimate() + BEYOND { w * (nearest / radius) } else { w }
    }
}

/// Rounding in the place of a circle, relative to its radius.
const BEYOND: f64 = 1e-13;

macro_rules! from_maps {
    ($($kind:ident $map:ident),*) => {
        $(impl From<$map> for CanonicalMap {
            fn from(map: $map) -> Self {
                Self::$kind(map)
            }
        })*
    };
}
from_maps!(
    Disk RiemannMap,
    Ring AnnulusMap,
    Outside ExteriorMap,
    Strip StripMap,
    HalfPlane HalfPlaneMap
);

impl From<RectangleMap> for CanonicalMap {
    fn from(map: RectangleMap) -> Self {
        Self::Rectangle(Box::new(map))
    }
}

/// The map region a → region b that any two maps onto the same canonical region make: b's undone after a's.
///
/// Disks are joined as [`RegionMap`] joins them. Rings and rectangles fit only if they are of one shape; others can be stretched
/// onto each other, which is not conformal but quasiconformal: rings evenly in log r, rectangles evenly in x.
///
/// ```
/// use conformal_warp::{AnnulusMap, Complex64, Curve, Domain, JoinedMap, SolveOptions};
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(x, y)| Complex64::new(x, y));
/// let frame = |half: f64| -> conformal_warp::Result<AnnulusMap> {
///     let frame = Domain::new(&square(1.0), &[square(half).to_vec()], Curve::Polygon)?;
///     AnnulusMap::solve(&frame, &SolveOptions::default(), &mut |_, _| true)
/// };
/// let (thin, thick) = (frame(0.5)?, frame(0.25)?);
/// assert_eq!(JoinedMap::between(thin.clone(), thick.clone()).unwrap_err().code(), "different-moduli");
/// let stretched = JoinedMap::stretching(thin, thick)?;
/// assert!(!stretched.is_analytic());
/// assert!((stretched.forward(&square(0.5))[2] - square(0.25)[2]).norm() < 1e-6, "hole goes to hole");
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct JoinedMap(Kind);

#[derive(Clone, Debug)]
enum Kind {
    /// With the charts of both.
    Disks(Box<RegionMap>),
    Others(Box<Others>),
}

#[derive(Clone, Debug)]
struct Others {
    a: CanonicalMap,
    b: CanonicalMap,
    between: Between,
}

/// What lies between the two canonical regions.
#[derive(Clone, Copy, Debug)]
enum Between {
    /// Nothing.
    Nothing,
    /// w → w|w|^(s−1): ring → ring.
    Power(Stretch),
    /// x + iy → sx + iy: rectangle → rectangle.
    Scale(Stretch),
}

/// By how much, and whether that is more than errors.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    by: f64,
    is_real: bool,
}

impl Between {
    fn jet(self, w: Complex64) -> Jet {
        match self {
            Self::Nothing => Jet::analytic(w, Complex64::ONE),
            Self::Power(Stretch { by, is_real }) => {
                let size = w.norm().powf(by - 1.0);
                let value = w * size;
                if !is_real {
                    return Jet::analytic(value, size.into());
                }
                // w^((s+1)/2) w̄^((s−1)/2).
                let dzbar = 0.5 * (by - 1.0) * value / w.conj();
                Jet { value, dz: (0.5 * (by + 1.0) * size).into(), dzbar }
            }
            Self::Scale(Stretch { by, is_real }) => {
                let value = Complex64::new(w.re * by, w.im);
                if !is_real {
                    return Jet::analytic(value, Complex64::ONE);
                }
                Jet { value, dz: (0.5 * (by + 1.0)).into(), dzbar: (0.5 * (by - 1.0)).into() }
            }
        }
    }

    fn inverse(self) -> Self {
        let inverse = |stretch: Stretch| Stretch { by: 1.0 / stretch.by, ..stretch };
        match self {
            Self::Nothing => Self::Nothing,
            Self::Power(stretch) => Self::Power(inverse(stretch)),
            Self::Scale(stretch) => Self::Scale(inverse(stretch)),
        }
    }

    fn is_analytic(self) -> bool {
        match self {
            Self::Nothing => true,
            Self::Power(stretch) | Self::Scale(stretch) => !stretch.is_real,
        }
    }
}

impl JoinedMap {
    /// The conformal map from a's region to b's. Both keep what they have built; nothing is solved.
    ///
    /// # Errors
    /// [`Error::DifferentModuli`] for rings or rectangles that are not of one shape, up to their maps' errors;
    /// [`Error::InvalidMap`] for maps onto canonical regions of different kinds.
    pub fn between(a: impl Into<CanonicalMap>, b: impl Into<CanonicalMap>) -> Result<Self> {
        Self::join(a.into(), b.into(), false)
    }

    /// As [`JoinedMap::between`], but rings and rectangles of different shape are stretched onto each other.
    ///
    /// # Errors
    /// [`Error::InvalidMap`].
    pub fn stretching(a: impl Into<CanonicalMap>, b: impl Into<CanonicalMap>) -> Result<Self> {
        Self::join(a.into(), b.into(), true)
    }

    fn join(a: CanonicalMap, b: CanonicalMap, stretches: bool) -> Result<Self> {
        use CanonicalMap::{Disk, HalfPlane, Outside, Rectangle, Ring, Strip};
        let between = match (&a, &b) {
            (Disk(a), Disk(b)) => return Ok(Self(Kind::Disks(Box::new(RegionMap::between(a, b))))),
            (Outside(_), Outside(_)) | (Strip(_), Strip(_)) | (HalfPlane(_), HalfPlane(_)) => Between::Nothing,
            (Ring(a), Ring(b)) => {
                let [first, second] = [a.modulus(), b.modulus()];
                let errors = a.error_estimate() + b.error_estimate();
                let fits = (first.ln() - second.ln()).abs() <= errors;
                Between::Power(stretch("Rings", [first, second], second.ln() / first.ln(), fits, stretches)?)
            }
            (Rectangle(a), Rectangle(b)) => {
                let [first, second] = [a.aspect(), b.aspect()];
                let errors = a.error_estimate() + b.error_estimate();
                let fits = (second / first - 1.0).abs() <= errors;
                Between::Scale(stretch("Quadrilaterals", [first, second], second / first, fits, stretches)?)
            }
            _ => {
                let reason = "the two regions are mapped onto canonical regions of different kinds";
                return Err(Error::InvalidMap { what: "A map between them", reason });
            }
        };
        Ok(Self(Kind::Others(Box::new(Others { a, b, between }))))
    }

    /// Whether it is conformal: not if it stretches.
    #[must_use]
    pub fn is_analytic(&self) -> bool {
        match &self.0 {
            Kind::Disks(_) => true,
            Kind::Others(others) => others.between.is_analytic(),
        }
    }

    /// Region a → region b. NaN outside the closed region a.
    #[must_use]
    pub fn forward(&self, points: &[Complex64]) -> Vec<Complex64> {
        match &self.0 {
            Kind::Disks(map) => map.forward(points),
            Kind::Others(_) => values(points, &|points, jets| self.jets(points, jets)),
        }
    }

    /// Region b → region a. NaN outside the closed region b.
    #[must_use]
    pub fn inverse(&self, points: &[Complex64]) -> Vec<Complex64> {
        match &self.0 {
            Kind::Disks(map) => map.inverse(points),
            Kind::Others(_) => values(points, &|points, jets| self.inverse_jets(points, jets)),
        }
    }

    /// [`JoinedMap::forward`], if all points can be told: see [`RegionMap::try_forward`].
    ///
    /// # Errors
    /// [`Error::TooFarApart`], of disks alone.
    pub fn try_forward(&self, points: &[Complex64]) -> Result<Vec<Complex64>> {
        match &self.0 {
            Kind::Disks(map) => map.try_forward(points),
            Kind::Others(_) => Ok(self.forward(points)),
        }
    }

    /// [`JoinedMap::inverse`], if all points can be told.
    ///
    /// # Errors
    /// As [`JoinedMap::try_forward`].
    pub fn try_inverse(&self, points: &[Complex64]) -> Result<Vec<Complex64>> {
        match &self.0 {
            Kind::Disks(map) => map.try_inverse(points),
            Kind::Others(_) => Ok(self.inverse(points)),
        }
    }

    /// ∂/∂z of [`JoinedMap::forward`], the derivative of a conformal one; units of b per unit of a.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.jets(points, &mut jets);
        jets.iter().map(|jet| jet.dz).collect()
    }
}

/// By how much one shape is stretched to become the other.
fn stretch(what: &'static str, [first, second]: [f64; 2], by: f64, fits: bool, stretches: bool) -> Result<Stretch> {
    if !fits && !stretches {
        return Err(Error::DifferentModuli { what, first, second });
    }
    Ok(Stretch { by, is_real: !fits })
}

fn values(points: &[Complex64], map: &dyn Fn(&[Complex64], &mut [Jet])) -> Vec<Complex64> {
    let mut jets = vec![Jet::UNDEFINED; points.len()];
    map(points, &mut jets);
    jets.iter().map(|jet| jet.value).collect()
}

/// The jets of `back` undone after what lies between, after `there`.
fn through(points: &[Complex64], jets: &mut [Jet], there: &CanonicalMap, between: Between, back: &CanonicalMap) {
    there.map().jets(points, jets);
    jets.iter_mut().for_each(|jet| *jet = between.jet(jet.value).after(jet));
    let images: Vec<Complex64> = jets.iter().map(|jet| back.settled(jet.value)).collect();
    let mut last = vec![Jet::UNDEFINED; points.len()];
    back.map().inverse_jets(&images, &mut last);
    jets.iter_mut().zip(last).for_each(|(jet, last)| *jet = last.after(jet));
}

/// Region a → region b.
impl PlaneMap for JoinedMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        match &self.0 {
            Kind::Disks(map) => map.jets(points, jets),
            Kind::Others(others) => through(points, jets, &others.a, others.between, &others.b),
        }
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        Some(Box::new(Inverse(self)))
    }
}

impl InvertibleMap for JoinedMap {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        match &self.0 {
            Kind::Disks(map) => map.inverse_jets(points, jets),
            Kind::Others(others) => through(points, jets, &others.b, others.between.inverse(), &others.a),
        }
    }
}
