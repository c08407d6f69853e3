//! L in squares of a domain that smooth curves bound: power series, each made when a point of its square is first asked for.

use super::super::atlas::power_series::Series;
use super::super::lazy_tree::{Decision, LazyTree, Square};
use super::cuts::Cuts;
use super::inside::{Ground, Inside};
use crate::Result;
use crate::plane::{Complex64, Domain};
use crate::symm::options::Progress;
use crate::symm::smooth_field::SmoothField;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

/// The squares.
#[derive(Debug)]
pub struct CurveSquares {
    tree: LazyTree<(), CurveLeaf>,
    field: SmoothField,
    domain: Arc<Domain>,
    /// Scaled units are (z − origin) × unit.
    origin: Complex64,
    unit: f64,
}

#[derive(Debug)]
enum CurveLeaf {
    /// L.
    Series(Series),
    /// Beside a wall.
    Near,
    Outside,
}

/// The half diagonal of a square is at most this share of the distance from its middle to the boundary,
const SHARE: f64 = 0.4;
/// and samples are taken on a circle of this share.
const SAMPLED: f64 = 0.5;
/// 0.8ᵏ of the samples' rounding and 0.4ᵏ of L is left of what comes after so many terms.
const TERMS: usize = 38;
/// Squares are not smaller than the whole by more than 2 to this.
const DEEPEST: u32 = 8;

impl CurveSquares {
    /// None yet; the field's coordinates are (z − origin) × unit.
    #[must_use]
    pub fn new(field: &SmoothField, domain: &Arc<Domain>, (origin, unit): (Complex64, f64), ground: Ground) -> Self {
        let tree = LazyTree::new(ground.center, ground.half, ());
        Self { tree, field: field.clone(), domain: Arc::clone(domain), origin, unit }
    }

    /// Makes all.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn fill(&self, progress: Progress) -> Result<()> {
        self.tree.fill("expand", &|square, ()| self.decide(square), progress)
    }

    /// What is known of a point.
    #[must_use]
    pub fn at(&self, z: Complex64) -> Inside {
        match self.tree.find(z, &|square, ()| self.decide(square)) {
            None => Inside::Beyond,
            Some(CurveLeaf::Near) => Inside::Unknown,
            Some(CurveLeaf::Outside) => Inside::Outside,
            Some(CurveLeaf::Series(series)) => {
                let (value, slope) = series.at(z);
                Inside::Log(value, slope)
            }
        }
    }

    /// What is to be added to L there, to have it on the branch of direct summation.
    #[must_use]
    pub fn branch(&self, z: Complex64, cuts: &Cuts) -> Complex64 {
        match self.tree.find(z, &|square, ()| self.decide(square)) {
            Some(CurveLeaf::Series(series)) => cuts.jump(series.center, z),
            _ => Complex64::ZERO,
        }
    }

    fn decide(&self, square: &Square) -> Decision<(), CurveLeaf> {
        let radius = square.half * SQRT_2;
        let place = square.center / self.unit + self.origin;
        let distance = (self.domain.nearest(place).place.point - place).norm() * self.unit;
        // Beside a wall either side may be asked for.
        if distance > radius && !self.domain.contains(place) {
            return Decision::Leaf(CurveLeaf::Outside);
        }
        if radius <= SHARE * distance {
            let (center, radius) = (square.center, SAMPLED * distance);
            let mut coefficients = vec![Complex64::ZERO; TERMS];
            self.field.expand(center, radius, &mut coefficients);
            return Decision::Leaf(CurveLeaf::Series(Series { center, radius, coefficients: coefficients.into() }));
        }
        if square.level >= DEEPEST { Decision::Leaf(CurveLeaf::Near) } else { Decision::Split(()) }
    }
}
