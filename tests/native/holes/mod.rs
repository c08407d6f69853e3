//! Regions with holes, and the outside of bodies.

mod annulus;
mod circles;
mod edges;
mod estimate;
mod evaluation;
mod exterior;
mod flow;
mod independent;
mod joined;
mod lines;
mod opened;
mod slits;
mod vortices;

use conformal_warp::{Complex64, SolveOptions};
use std::f64::consts::TAU;

fn options(tolerance: f64) -> SolveOptions {
    SolveOptions { tolerance, ..SolveOptions::default() }
}

fn square(half: f64) -> Vec<Complex64> {
    crate::support::points(&[[-half, -half], [half, -half], [half, half], [-half, half]])
}

/// A closed curve sampled evenly.
fn curve(n: usize, at: impl Fn(f64) -> Complex64) -> Vec<Complex64> {
    (0..n).map(|j| at(TAU * j as f64 / n as f64)).collect()
}
