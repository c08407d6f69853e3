//! How accurate expansions should be, and how many terms that takes.

use crate::plane::Complex64;
use crate::symm::solution::Solution;

/// How accurate expansions should be.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// Largest error of an expansion: of w in the unit disk, of z relative to the region's size.
    pub tolerance: f64,
    /// The solve's own.
    pub solve_error: f64,
}

/// Expansions err by at most this share of the solve.
const SHARE_OF_ERROR: f64 = 0.03;
/// And by no more than this, so that the loosest solve's map is still smooth and goes both ways.
const LARGEST_ERROR: f64 = 1e-3;

impl Accuracy {
    /// The accuracy of the expansions of a solution.
    #[must_use]
    pub fn of(solution: &Solution) -> Self {
        Self::beside(solution.error_estimate)
    }

    /// The accuracy of expansions of what was solved for with some error.
    #[must_use]
    pub fn beside(solve_error: f64) -> Self {
        Self { tolerance: (SHARE_OF_ERROR * solve_error).clamp(1e-13, LARGEST_ERROR), solve_error }
    }

    /// Decimal digits of the tolerance.
    #[must_use]
    pub fn digits(self) -> f64 {
        -self.tolerance.log10()
    }

    /// Degree of a patch's series, whose terms fall like 0.4ᵏ.
    #[must_use]
    pub fn patch_degree(self) -> usize {
        (2.2 * self.digits()).ceil().max(LEAST_DEGREE) as usize
    }

    /// Most coefficients of a cell's polynomial.
    #[must_use]
    pub fn cell_terms(self) -> usize {
        (12 + self.digits() as usize).min(24)
    }

    /// How many coefficients are needed for a tolerance; `None` if there are too few.
    #[must_use]
    pub fn terms_needed(self, coefficients: &[Complex64], tolerance: f64) -> Option<usize> {
        let mut count = coefficients.len();
        // What lies beyond the end is about as large as the last two.
        let mut tail = coefficients[count - 1].norm() + coefficients[count - 2].norm();
        if tail.is_nan() || tail > 0.5 * tolerance {
            return None;
        }
        while count > 2 {
            tail += coefficients[count - 1].norm();
            if tail > tolerance {
                break;
            }
            count -= 1;
        }
        Some(count)
    }

    /// How many coefficients say something, if the last ones do not fall any more but are `noise`: where charts and patches
    /// meet, samples jump by a part of the solve's error.
    #[must_use]
    pub fn terms_above_noise(self, coefficients: &[Complex64], noise: f64) -> Option<usize> {
        let largest = |part: &[Complex64]| part.iter().map(|c| c.norm()).fold(0.0, f64::max);
        let quarter = coefficients.len() / 4;
        let last = largest(&coefficients[coefficients.len() - quarter..]);
        let before = largest(&coefficients[coefficients.len() - 2 * quarter..coefficients.len() - quarter]);
        if !(last <= noise && last >= FLAT * before) {
            return None;
        }
        let kept = coefficients.iter().rposition(|c| c.norm() > 2.0 * last)?;
        Some((kept + 1).max(2))
    }
}

/// Coefficients of an analytic function fall by more than this over a quarter of them.
const FLAT: f64 = 0.3;

/// A patch's series has at least as many terms as the first guess of its inverse.
const LEAST_DEGREE: f64 = 6.0;
