//! Cells: disks in which a map is a Taylor polynomial.

use super::power_series::{value, value_and_slope};
use crate::plane::Complex64;

/// More cells and patches than this are not made; what is left is summed directly.
pub const MOST_CELLS: usize = 400_000;
/// Sources are summed for a disk of at most this share of the distance to the wall: nearer to it they would have to be cut
/// small. The function's own series goes on beyond.
pub const SHARE_OF_SUM: f64 = 0.5;

/// A disk with a Taylor polynomial.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Its center.
    pub center: Complex64,
    inverse_radius: f64,
    first: u32,
    count: u16,
    /// Whose map it is.
    pub chart: u16,
}

/// Cells and their coefficients.
#[derive(Clone, Debug, Default)]
pub struct Cells {
    list: Vec<Cell>,
    coefficients: Vec<Complex64>,
}

impl Cells {
    /// Keeps a cell; returns its number.
    pub fn add(&mut self, center: Complex64, radius: f64, chart: usize, coefficients: &[Complex64]) -> u32 {
        let first = self.coefficients.len() as u32;
        self.coefficients.extend_from_slice(coefficients);
        let count = coefficients.len() as u16;
        self.list.push(Cell { center, inverse_radius: 1.0 / radius, first, count, chart: chart as u16 });
        self.list.len() as u32 - 1
    }

    /// The cell, its polynomial, and where a point lies in it.
    #[inline]
    #[must_use]
    pub fn at(&self, index: u32, z: Complex64) -> (&Cell, &[Complex64], Complex64) {
        let cell = &self.list[index as usize];
        let first = cell.first as usize;
        let t = (z - cell.center) * cell.inverse_radius;
        (cell, &self.coefficients[first..first + cell.count as usize], t)
    }

    /// The polynomial's value.
    #[inline]
    #[must_use]
    pub fn value(&self, index: u32, z: Complex64) -> (usize, Complex64) {
        let (cell, coefficients, t) = self.at(index, z);
        (cell.chart as usize, value(coefficients, t))
    }

    /// The polynomial's value and derivative.
    #[inline]
    #[must_use]
    pub fn value_and_slope(&self, index: u32, z: Complex64) -> (usize, Complex64, Complex64) {
        let (cell, coefficients, t) = self.at(index, z);
        let (w, slope) = value_and_slope(coefficients, t);
        (cell.chart as usize, w, slope * cell.inverse_radius)
    }

    /// (center, value there, chart) of every cell.
    pub fn centers(&self) -> impl Iterator<Item = (Complex64, Complex64, usize)> + '_ {
        self.list.iter().map(|cell| (cell.center, self.coefficients[cell.first as usize], cell.chart as usize))
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        std::mem::size_of_val(&self.list[..]) + std::mem::size_of_val(&self.coefficients[..])
    }
}
