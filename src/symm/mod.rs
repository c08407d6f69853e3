//! Symm's equation: region → boundary correspondence.
//!
//! The unknown is the harmonic measure μ of the boundary seen from the center z₀ (dμ = dθ/2π on the circle):
//!
//! ```text
//! ∫ log|x − y| dμ(y) + c = log|x − z₀|   for x on the boundary,      ∫ dμ = 1
//! ```
//!
//! the paper's appendix 2 with g = −∫ log|z − y| dμ. The exact c is 0; keeping it makes the system regular for every
//! region, also one of logarithmic capacity 1.
//!
//! In the order of the computation: [`panel`] cuts the boundary, [`rule`] integrates the logarithm over a panel
//! ([`log_moments`] when near), [`discretisation`] writes the equations, [`solve`] solves and refines them,
//! [`correspondence`] is θ on the boundary, [`potential`] the map inside.

pub mod clusters;
pub mod correspondence;
pub mod discretisation;
mod fast_log;
pub mod fast_multipole;
pub mod gmres;
pub mod influence;
pub mod legendre;
pub mod log_moments;
pub mod lu;
pub mod panel;
pub mod potential;
pub mod rule;
pub mod smooth;
pub mod solve;
pub mod system;
pub mod two_level;
