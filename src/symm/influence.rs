//! Masses → potentials: the matrix of Symm's equation as something that can be applied.

use super::discretisation::{Discretisation, Target};
use super::lu::dot;
use super::options::Progress;
use crate::{Error, Result};

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

    /// The row-major matrix of the whole system, with the constant c and the total mass: [A 1; 1ᵀ 0].
    #[must_use]
    pub fn bordered(&self) -> Vec<f64> {
        let n = self.columns;
        let mut matrix = Vec::with_capacity((n + 1) * (n + 1));
        for row in self.entries.chunks_exact(n) {
            matrix.extend_from_slice(row);
            matrix.push(1.0);
        }
        matrix.resize(matrix.len() + n, 1.0);
        matrix.push(0.0);
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
