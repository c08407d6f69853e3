//! What integration tests share: fixtures, exact maps, small helpers.

pub mod exact;
pub mod golden;
pub mod kerzman_stein;
pub mod picture;
pub mod random;
pub mod schwarz_christoffel;

use conformal_warp::{BoundaryPoint, Complex64, Curve, Region, RiemannMap, SolveOptions};
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

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

/// Where a file of `tests/fixtures` is.
pub fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures").join(name)
}

/// Random polygons with exact answers, from the Schwarz–Christoffel integral.
pub const EXACT_CASES: [&str; 5] = ["sc_4_101", "sc_6_102", "sc_9_103", "sc_15_104", "sc_24_105"];

pub fn c(re: f64, im: f64) -> Complex64 {
    Complex64::new(re, im)
}

pub fn complex([re, im]: [f64; 2]) -> Complex64 {
    Complex64::new(re, im)
}

pub fn points(xy: &[[f64; 2]]) -> Vec<Complex64> {
    xy.iter().copied().map(complex).collect()
}

pub fn case(name: &str) -> Case {
    serde_json::from_str(&std::fs::read_to_string(fixture(&format!("{name}.json"))).unwrap()).unwrap()
}

/// A file of `tests/fixtures/faults`: an input that went wrong once, with the right answer.
pub fn fault(name: &str) -> serde_json::Value {
    serde_json::from_str(&std::fs::read_to_string(fixture(&format!("faults/{name}.json"))).unwrap()).unwrap()
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

/// The largest of them; not a number if one of them is not. Of nothing there is none.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    let larger = |a: f64, b: f64| if a.is_nan() || b <= a { a } else { b };
    values.into_iter().reduce(larger).expect("something to compare")
}

/// `count` points spread evenly over the region.
pub fn spread_points(region: &Region, count: usize) -> Vec<Complex64> {
    let (low, high) = region.polygon().bounds();
    let size = high - low;
    let point = |k: usize| {
        low + Complex64::new(size.re * share(k, 0.618_033_988_749_895), size.im * share(k, 0.754_877_666_246_692_7))
    };
    (1..).map(point).filter(|z| region.contains(*z)).take(count).collect()
}

/// The fractional part of k·a: evenly spread over [0, 1) for irrational a.
pub fn share(k: usize, a: f64) -> f64 {
    (k as f64 * a).fract()
}

/// Points of the boundary: every vertex, and points of each edge that crowd towards its ends.
pub fn boundary_points(region: &Region) -> Vec<BoundaryPoint> {
    let shares = [0.0, 1e-6, 1e-4, 0.003, 0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.62, 0.8, 0.93, 0.97, 0.995, 0.999];
    let polygon = region.polygon();
    let on_edge = |edge: usize| {
        let (a, b) = polygon.edge(edge);
        shares.map(|t| BoundaryPoint { edge, t, point: a + (b - a) * t })
    };
    (0..polygon.len()).flat_map(on_edge).collect()
}

/// Points of the region beside its boundary: a hundredth of an edge's piece away from it, where errors are largest.
pub fn points_beside_boundary(region: &Region) -> Vec<Complex64> {
    let polygon = region.polygon();
    let beside = |p: BoundaryPoint| {
        let (a, b) = polygon.edge(p.edge);
        p.point + (b - a) * Complex64::i() * 0.01 * p.t.min(1.0 - p.t)
    };
    boundary_points(region).into_iter().filter(|p| p.t > 0.0).map(beside).filter(|z| region.contains(*z)).collect()
}

/// The largest difference of two solved maps of one region, on the boundary, beside it and inside; summed directly, so that
/// no evaluator is built for each.
pub fn largest_difference(map: &RiemannMap, reference: &RiemannMap) -> f64 {
    let region = reference.region();
    let on_boundary =
        boundary_points(region).into_iter().map(|p| angle_error(map.boundary_angle(p), reference.boundary_angle(p)));
    let mut interior = points_beside_boundary(region);
    let rays = region.boundary().iter().flat_map(|v| [0.2, 0.6].map(|t| region.center() + (v - region.center()) * t));
    interior.extend(rays.filter(|z| region.contains(*z)));
    let values = map.to_disk_directly(&interior).into_iter().zip(reference.to_disk_directly(&interior));
    let inside = values.map(|(a, b)| (a - b).norm());
    largest(on_boundary.chain(inside))
}
