//! What a solve says of itself.

use crate::symm::options::Stop;

/// How good a solution is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Evidence {
    /// Largest violation of the equations where they were not imposed.
    pub residual: f64,
    /// Estimate of the largest error.
    pub error_estimate: f64,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Why the solve ended.
    pub stop: Stop,
}

/// Gives a class with a field `evidence` the methods that tell it.
macro_rules! evidence_methods {
    ($class:ident, $of_what:literal) => {
        impl $class {
            #[doc = concat!("Estimate of the largest error ", $of_what)]
            #[must_use]
            pub fn error_estimate(&self) -> f64 {
                self.evidence.error_estimate
            }

            /// Largest violation of the boundary conditions where they were not imposed.
            #[must_use]
            pub fn residual(&self) -> f64 {
                self.evidence.residual
            }

            /// Number of unknowns of the last system solved.
            #[must_use]
            pub fn unknowns(&self) -> usize {
                self.evidence.unknowns
            }

            /// Why the solve ended.
            #[must_use]
            pub fn stop(&self) -> $crate::symm::options::Stop {
                self.evidence.stop
            }
        }
    };
}
pub(super) use evidence_methods;
