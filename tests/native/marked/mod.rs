//! Maps that marked boundary points make unique.

mod channel;
mod curves;
mod lines;
mod rectangle;

use conformal_warp::{Complex64, Curve, Region, SolveOptions};

fn options(tolerance: f64) -> SolveOptions {
    SolveOptions { tolerance, ..SolveOptions::default() }
}

/// The polygon of SC Toolbox's tests.
fn toolbox() -> Region {
    let vertices =
        crate::support::points(&[[4.0, 0.0], [0.0, 2.0], [-2.0, 4.0], [-3.0, 0.0], [-3.0, -1.0], [2.0, -2.0]]);
    Region::new(&vertices, Curve::Polygon, Complex64::ZERO, vertices[0]).unwrap()
}
