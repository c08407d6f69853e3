//! B in squares of a domain that analytic edges bound: Cauchy's formula as power series, and beside the walls point by point.

use super::super::cauchy_tree::{CauchyTree, Leaf};
use super::inside::{Ground, Inside};
use crate::Result;
use crate::plane::Complex64;
use crate::symm::curved::cauchy::Side;
use crate::symm::curved::field::CurvedField;
use crate::symm::options::Progress;

/// The squares.
#[derive(Debug)]
pub struct EdgeSquares {
    tree: CauchyTree,
    field: CurvedField,
}

/// Series err by at most this share of the solve,
const SHARE_OF_ERROR: f64 = 1e-3;
/// and by no more than this.
const LARGEST_ERROR: f64 = 1e-6;

impl EdgeSquares {
    /// None decided yet.
    #[must_use]
    pub fn new(field: &CurvedField, ground: Ground, solve_error: f64) -> Self {
        let error = (SHARE_OF_ERROR * solve_error).clamp(f64::EPSILON, LARGEST_ERROR);
        let square = (ground.center, ground.half);
        let tree = CauchyTree::new(square, Side::Region, field.parts(), field.around(), error);
        Self { tree, field: field.clone() }
    }

    /// Makes all.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn fill(&self, progress: Progress) -> Result<()> {
        self.tree.fill(&self.field, progress)
    }

    // Once in the module: what follows weighs more.
    #[inline(never)]
    fn leaf(&self, z: Complex64) -> Option<&Leaf> {
        self.tree.find(z, &self.field)
    }

    /// What is known of a point.
    #[must_use]
    pub fn at(&self, z: Complex64) -> Inside {
        match self.leaf(z) {
            None => Inside::Beyond,
            Some(Leaf::Near(_)) => Inside::Unknown,
            Some(Leaf::Outside) => Inside::Outside,
            Some(Leaf::Series(series)) => {
                let (value, slope) = self.field.of_single_valued(z, series.at(z));
                Inside::Whole(value, slope)
            }
        }
    }

    /// (B, B') at a point of the region beside a wall.
    #[must_use]
    pub fn beside(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let Some(Leaf::Near(sums)) = self.leaf(z) else { return None };
        Some(self.field.at_by(z, &|z| self.tree.near(sums, z, &self.field)))
    }
}
