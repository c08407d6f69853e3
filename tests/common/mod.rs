//! What integration tests share: fixtures, exact maps, small helpers.
#![allow(dead_code, missing_docs, clippy::unwrap_used)]

use conformal_warp::map::{RiemannMap, SolveOptions};
use conformal_warp::plane::{Complex64, Curve, Region};
use std::f64::consts::TAU;

/// A region from `tests/fixtures`; those built from the Schwarz–Christoffel integral carry their exact answers.
#[derive(serde::Deserialize)]
pub struct Case {
    pub vertices: Vec<[f64; 2]>,
    pub center: [f64; 2],
    pub toward: [f64; 2],
    #[serde(default)]
    pub angles: Vec<f64>,
    #[serde(default)]
    pub conformal_radius: f64,
    #[serde(default)]
    pub interior_z: Vec<[f64; 2]>,
    #[serde(default)]
    pub interior_w: Vec<[f64; 2]>,
}

macro_rules! fixtures {
    ($($name:literal),* $(,)?) => {
        /// The text of a fixture, compiled in so that wasm tests have it too.
        fn fixture(name: &str) -> &'static str {
            match name {
                $($name => include_str!(concat!("../fixtures/", $name, ".json")),)*
                _ => panic!("no fixture named {name}"),
            }
        }
    };
}

fixtures!(
    "sc_4_101",
    "sc_6_102",
    "sc_9_103",
    "sc_15_104",
    "sc_24_105",
    "neck",
    "slot",
    "spike",
    "rect10",
    "rect20",
    "blob100",
    "blob300",
    "blob1000",
    "blob10000"
);

/// Random polygons with exact answers, from the Schwarz–Christoffel integral.
pub const EXACT_CASES: [&str; 5] = ["sc_4_101", "sc_6_102", "sc_9_103", "sc_15_104", "sc_24_105"];

pub fn complex([re, im]: [f64; 2]) -> Complex64 {
    Complex64::new(re, im)
}

pub fn points(xy: &[[f64; 2]]) -> Vec<Complex64> {
    xy.iter().copied().map(complex).collect()
}

pub fn case(name: &str) -> Case {
    serde_json::from_str(fixture(name)).unwrap()
}

impl Case {
    pub fn region(&self) -> Region {
        Region::new(&points(&self.vertices), Curve::Polygon, complex(self.center), complex(self.toward)).unwrap()
    }
}

pub fn solve(region: &Region, tolerance: f64) -> RiemannMap {
    RiemannMap::solve(region, &SolveOptions { tolerance, ..SolveOptions::default() }, &mut |_, _| true).unwrap()
}

/// A polygon region from vertices, with `toward` the first of them.
pub fn polygon(vertices: &[Complex64], center: Complex64) -> Region {
    Region::new(vertices, Curve::Polygon, center, vertices[0]).unwrap()
}

/// Distance between angles on the circle.
pub fn angle_error(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(TAU);
    d.min(TAU - d)
}

pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
}
