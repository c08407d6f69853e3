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
//! In the order of the computation:
//! - [`options`] says what is wanted;
//! - `panel` cuts the boundary; `order` says how finely; `rule` integrates the logarithm over a panel,
//!   from `panel_blocks` (`log_moments` when near); `discretisation` writes the equations; `thin_walls` says
//!   where their residuals weigh most;
//! - `system` solves them: by factorisation (`lu`) when small, else by iteration (`gmres`) with a preconditioner
//!   (`two_level`) and products from stored entries (`influence`) or expansions (`fast_multipole`, `multipole`, `clusters`);
//!   `rows` holds its inner loops;
//! - `problem` is what is solved for: harmonic measure, or another right-hand side of a region with holes;
//! - `solve` refines (`refinement`) until the estimate meets the tolerance; `center` moves the center of what is
//!   solved, and `far_center` moves it far, where most of the `measure` is `known` already;
//! - `solution` is the answer: `correspondence` on the boundary (a `panel_measure`), `potential` inside, `local_series` there
//!   as power series.
//!
//! `smooth` does all this, more simply, for smooth curves, on a `smooth_system`.
//!
//! `curved` does it for boundaries of analytic edges. To the equations both are `panelled`.
//!
//! `stored` keeps solutions as bytes.
//!
//! `field`, `smooth_field` and `curved::field` are what a `problem` of a region with holes gives: one analytic function, known everywhere.

pub(crate) mod center;
mod circle_iteration;
mod clusters;
pub(crate) mod correspondence;
pub(crate) mod curved;
mod discretisation;
pub(crate) mod far_center;
mod fast_log;
mod fast_multipole;
pub(crate) mod field;
pub(crate) mod gmres;
mod influence;
mod known;
mod legendre;
pub(crate) mod local_series;
mod log_moments;
mod lu;
pub(crate) mod measure;
pub(crate) mod multipole;
pub mod options;
mod order;
pub(crate) mod panel;
mod panel_blocks;
mod panel_measure;
pub(crate) mod panelled;
pub(crate) mod potential;
pub(crate) mod problem;
mod refinement;
mod rows;
mod rule;
mod series_sum;
pub(crate) mod smooth;
pub(crate) mod smooth_field;
pub(crate) mod smooth_solve;
mod smooth_system;
pub(crate) mod solution;
pub(crate) mod solve;
mod stored;
mod system;
mod thin_walls;
mod two_level;

#[cfg(test)]
mod convergence;

pub(crate) use lu::{Lu, small_solve};
