//! Icons of two packages as people have them, with areas by another reader.

use super::report;
use crate::support::fixture;
use crate::support::{largest, solve, spread_points};
use conformal_warp::{
    Complex64, CurvedOutline, Edge, Frame, JointTriangulation, MeshOptions, MeshStop, Region, RiemannMap, SolveOptions,
    parse_shape,
};
use std::collections::BTreeMap;

#[derive(serde::Deserialize)]
struct Icon {
    name: String,
    text: String,
    /// Of its curves, closed by lines, the largest first.
    areas: Vec<f64>,
}

fn icons() -> Vec<Icon> {
    let text = std::fs::read_to_string(fixture("icons.json")).unwrap();
    serde_json::from_str::<BTreeMap<String, Vec<Icon>>>(&text).unwrap().into_values().flatten().collect()
}

/// The area within a closed chain, by Simpson's rule with Richardson's extrapolation.
fn area(edges: &[Edge]) -> f64 {
    let rule = |edge: &Edge, steps: u32| {
        let value = |k: u32| {
            let t = f64::from(k) / f64::from(steps);
            (edge.point(t).conj() * edge.tangent(t.into())).im
        };
        let sum: f64 = (1..steps).map(|k| value(k) * if k % 2 == 1 { 4.0 } else { 2.0 }).sum();
        (value(0) + value(steps) + sum) / (6.0 * f64::from(steps))
    };
    edges.iter().map(|edge| rule(edge, 256) + (rule(edge, 256) - rule(edge, 128)) / 15.0).sum::<f64>().abs()
}

#[test]
fn icons_are_read_as_they_are_drawn() {
    let (mut bounded, mut holed, mut refused) = (0, 0, Vec::new());
    for Icon { name, text, areas } in icons() {
        let shape = match parse_shape(&text, 1.0) {
            Ok(shape) => shape,
            Err(error) => {
                // Several curves apart from each other.
                assert!(areas.len() > 1 && error.to_string().contains(" curves, and "), "{name}: {error}");
                refused.push(name);
                continue;
            }
        };
        assert_eq!(shape.holes.len() + 1, areas.len(), "{name}");
        let mut found: Vec<f64> = shape.holes.iter().map(|hole| area(hole)).collect();
        found.sort_by(|a, b| b.total_cmp(a));
        found.insert(0, area(&shape.outline));
        for (found, expected) in found.iter().zip(&areas) {
            // Ends that miss their start by the rounding of three digits are moved onto it.
            assert!((found - expected).abs() < 2e-3 * expected.max(1e-3), "{name}: {found} {expected}");
        }
        match CurvedOutline::new(&shape.outline) {
            Ok(outline) => {
                bounded += 1;
                holed += usize::from(!shape.holes.is_empty());
                let looks = outline.polygon().area();
                assert!((looks - found[0]).abs() < 1e-4 * found[0], "{name}: {looks} {}", found[0]);
                check_sides(&name, &outline);
            }
            Err(error) => {
                let reasons = ["self-intersecting", "cusp", "invalid-outline"];
                assert!(reasons.contains(&error.code()), "{name}: {error}");
                refused.push(format!("{name} ({})", error.code()));
            }
        }
    }
    report(&format!("icons: {bounded} bound regions, {holed} of them with holes; refused: {}", refused.join(", ")));
    assert!(bounded >= 40, "{bounded}");
}

/// Points close to either side of every edge are told apart.
fn check_sides(name: &str, outline: &CurvedOutline) {
    let reach = 1e-12 * outline.size();
    for (k, edge) in outline.edges().iter().enumerate() {
        let along = edge.tangent(0.37.into());
        let normal = Complex64::i() * along / along.norm();
        for side in [reach, -reach] {
            let found = outline.signed_distance(edge.point(0.37) + normal * side);
            assert!((found - side).abs() < 0.02 * reach, "{name}, edge {k}: {found} {side}");
        }
    }
}

/// The point of a grid that lies deepest inside.
fn deepest(outline: &CurvedOutline) -> Complex64 {
    const STEPS: u32 = 40;
    let (low, high) = outline.polygon().bounds();
    let place = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(STEPS));
        Complex64::new(low.re + (high.re - low.re) * x, low.im + (high.im - low.im) * y)
    };
    let all = (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| place(i, j)));
    let depth = |z: &Complex64| outline.signed_distance(*z);
    all.max_by(|a, b| depth(a).total_cmp(&depth(b))).unwrap()
}

/// Each is solved to what was asked, and against a finer solve the error is below the estimate.
#[test]
fn icons_are_solved_as_they_are_drawn() {
    let (mut solved, mut unknowns, mut nearest) = (0, 0, 0.0);
    for Icon { name, text, .. } in icons() {
        let Ok(shape) = parse_shape(&text, 1.0) else { continue };
        let Ok(outline) = CurvedOutline::new(&shape.outline) else { continue };
        let region = Region::from_edges(&shape.outline, deepest(&outline), shape.outline[0].from()).unwrap();
        let options = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
        let map =
            RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap_or_else(|error| panic!("{name}: {error}"));
        let estimate = map.error_estimate();
        assert!(estimate <= 1e-6, "{name}: {estimate:e}");
        let finer = solve(&region, 1e-9);
        let points = spread_points(&region, 30);
        let images = finer.to_disk(&points);
        let there = largest(map.to_disk(&points).iter().zip(&images).map(|(a, b)| (a - b).norm()));
        let back = map.from_disk(&images).into_iter().zip(&points).zip(finer.derivative(&points));
        let back = largest(back.map(|((z, exact), slope)| (z - exact).norm() * slope.norm()));
        let error = there.max(back);
        assert!(error <= estimate + finer.error_estimate(), "{name}: {error:e}, estimate {estimate:e}");
        // There and back close to the circle, where each way may err by the estimate.
        let crowded: Vec<Complex64> =
            (0..200).map(|k| Complex64::from_polar(1.0 - 0.86f64.powi(k), f64::from(k * k))).collect();
        let there_and_back = map.to_disk(&map.from_disk(&crowded));
        let trip = there_and_back.iter().zip(&crowded).map(|(a, b)| (a - b).norm());
        assert!(trip.clone().all(|miss| miss <= 2.0 * estimate), "{name}: {:e}, estimate {estimate:e}", largest(trip));
        solved += 1;
        unknowns += map.unknowns();
        nearest = f64::max(nearest, error / estimate);
    }
    report(&format!(
        "icons: {solved} solved to 1e-6 with {unknowns} unknowns, largest error {nearest:.2} of its estimate"
    ));
    assert!(solved >= 40, "{solved}");
}

/// Each has a triangulation with the disk that keeps its bound, however close its walls lie and however far its ends.
#[test]
fn icons_are_triangulated() {
    let frame = Frame::new(Complex64::ZERO, 2.0, [256, 256]).unwrap();
    let mut nodes = Vec::new();
    for Icon { name, text, .. } in icons() {
        let Ok(shape) = parse_shape(&text, 1.0) else { continue };
        let Ok(outline) = CurvedOutline::new(&shape.outline) else { continue };
        let region = Region::from_edges(&shape.outline, deepest(&outline), shape.outline[0].from()).unwrap();
        let map = solve(&region, 1e-5);
        let mesh = JointTriangulation::region_to_disk(&map, &MeshOptions::quarter_pixel(frame))
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        mesh.validate().unwrap();
        assert!(mesh.flipped() == 0 && mesh.evidence().stop == MeshStop::Density, "{name}");
        assert!(mesh.evidence().largest_error_pixels().unwrap() <= 0.25, "{name}");
        nodes.push(mesh.source().len());
    }
    report(&format!(
        "icons: {} triangulated with {} to {} nodes",
        nodes.len(),
        nodes.iter().min().unwrap(),
        nodes.iter().max().unwrap()
    ));
    assert!(nodes.len() >= 40);
}
