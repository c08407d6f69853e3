//! Masses → potentials: the matrix of Symm's equation as something that can be applied.

use super::options::Progress;
use super::panelled::Panelled;
use super::refinement::Refinement;
use super::rows::dot;
use crate::{Error, Result};
use std::ops::Range;

/// The linear map from node masses to ∫ log|x − y| dμ(y) at a fixed list of points x.
pub trait Influence: Send + Sync {
    /// Writes the potentials of `masses`.
    fn apply(&self, masses: &[f64], potentials: &mut [f64]);
}

/// So many zeros.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn zeros(count: usize) -> Result<Vec<f64>> {
    let mut values = room(count)?;
    values.resize(count, 0.0);
    Ok(values)
}

/// Room for so many numbers: matrices are what memory ends with first.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub fn room(count: usize) -> Result<Vec<f64>> {
    let mut values = Vec::new();
    values.try_reserve_exact(count).map_err(|_| Error::OutOfMemory { bytes: 8 * count as u64 })?;
    Ok(values)
}

/// Every entry stored: best up to a few thousand unknowns.
#[derive(Clone, Debug)]
pub struct DenseInfluence {
    columns: usize,
    entries: Vec<f64>,
}

impl DenseInfluence {
    /// The potentials at the given τ of every panel. What lies between panels that were kept is taken over from `before`.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(
        discretisation: &dyn Panelled,
        taus: &[f64],
        before: Option<(&Self, &Refinement)>,
        progress: Progress,
    ) -> Result<Self> {
        let (columns, p) = (discretisation.unknowns(), discretisation.order().p());
        let targets = discretisation.targets(taus);
        let mut entries = zeros(columns * targets.len())?;
        for (i, (target, row)) in targets.iter().zip(entries.chunks_exact_mut(columns)).enumerate() {
            let known = before.and_then(|(old, refinement)| Some((old, refinement, refinement.kept(target.panel)?)));
            if let Some((old, refinement, kept)) = known {
                let old = &old.entries[(kept * taus.len() + i % taus.len()) * old.columns..][..old.columns];
                for (q, entries) in row.chunks_exact_mut(p).enumerate() {
                    match refinement.kept(q) {
                        Some(source) => entries.copy_from_slice(&old[source * p..][..p]),
                        None => discretisation.fill_row(target, q, entries),
                    }
                }
            } else {
                discretisation.fill_row(target, 0, row);
            }
            if i % 64 == 0 && !progress("assemble", i as f64 / targets.len() as f64) {
                return Err(Error::Cancelled);
            }
        }
        Ok(Self { columns, entries })
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        std::mem::size_of_val(&self.entries[..])
    }

    /// Of potentials at the nodes: the row-major matrix of some panels alone, of p nodes each.
    #[must_use]
    pub fn block(&self, members: &[usize], p: usize) -> Vec<f64> {
        let mut block = Vec::with_capacity((members.len() * p).pow(2));
        for i in members.iter().flat_map(|q| q * p..(q + 1) * p) {
            let row = &self.entries[i * self.columns..][..self.columns];
            members.iter().for_each(|q| block.extend_from_slice(&row[q * p..][..p]));
        }
        block
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_refused() {
        let count = usize::MAX / 32;
        assert_eq!(zeros(count), Err(Error::OutOfMemory { bytes: 8 * count as u64 }));
        assert_eq!(zeros(3), Ok(vec![0.0; 3]));
    }
}
