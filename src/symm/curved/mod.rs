//! Symm's equation on boundaries of analytic edges: lines, arcs of circles and ellipses, Bézier curves.
//!
//! - `boundary` cuts the edges into panels over their parameters, `kernel` integrates the logarithm over one (the parameter takes the
//!   place of arc length), and `discretisation` writes the equations; `arguments` follows arg(y − z) along the boundary;
//! - `solve` solves them to a tolerance, for the disk's map or for the problems of a region with holes;
//! - `measure` is what was solved for, along the boundary and beside it; `cauchy` sums Cauchy's formula over the boundary for many points;
//! - `solution` is the disk's map of a region without holes, `inverse` its way back, `stored` keeps it as bytes;
//! - `field` is the analytic function of a problem of a region with holes.

mod arguments;
mod boundary;
pub(crate) mod cauchy;
pub(crate) mod discretisation;
pub(crate) mod field;
mod inverse;
mod kernel;
mod measure;
pub(crate) mod solution;
pub(crate) mod solve;
mod stored;
