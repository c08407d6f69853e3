//! Masses → potentials: the matrix of Symm's equation as something that can be applied.

use super::discretisation::{Discretisation, Target};
use super::lu::dot;
use super::options::Progress;
use crate::{Error, Result};
use std::ops::Range;

/// The linear map from node masses to ∫ log|x − y| dμ(y) at a fixed list of points x.
pub trait Influence: Send + Sync {
    /// Writes the potentials of `masses`.
    fn apply(&self, masses: &[f64], potentials: &mut [f64]);
}

/// Every entry stored: best up to a few thousand unknowns.
#[derive(Clone, Debug)]
pub struct DenseInfluence {
    columns: usize,
    entries: Vec<f64>,
}

impl DenseInfluence {
    /// The potentials at `targets`.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(discretisation: &Discretisation, targets: &[Target], progress: Progress) -> Result<Self> {
        let columns = discretisation.unknowns();
        let mut entries = vec![0.0; columns * targets.len()];
        for (i, (target, row)) in targets.iter().zip(entries.chunks_exact_mut(columns)).enumerate() {
            discretisation.fill_row(*target, 0, row);
            if i % 64 == 0 && !progress("assemble", i as f64 / targets.len() as f64) {
                return Err(Error::Cancelled);
            }
        }
        Ok(Self { columns, entries })
    }

    /// The row-major matrix of the whole system, with the constant and the total mass of each component, whose unknowns are
    /// given: [A E; Eᵀ 0], a column of E being 1 on its component.
    #[must_use]
    pub fn bordered(&self, components: &[Range<usize>]) -> Vec<f64> {
        let (n, m) = (self.columns, components.len());
        let mut matrix = Vec::with_capacity((n + m) * (n + m));
        for (i, row) in self.entries.chunks_exact(n).enumerate() {
            matrix.extend_from_slice(row);
            matrix.extend(components.iter().map(|own| f64::from(u8::from(own.contains(&i)))));
        }
        for own in components {
            matrix.extend((0..n).map(|i| f64::from(u8::from(own.contains(&i)))));
            matrix.resize(matrix.len() + m, 0.0);
        }
        matrix
    }
}

impl Influence for DenseInfluence {
    fn apply(&self, masses: &[f64], potentials: &mut [f64]) {
        for (potential, row) in potentials.iter_mut().zip(self.entries.chunks_exact(self.columns)) {
            *potential = dot(row, masses);
        }
    }
}
