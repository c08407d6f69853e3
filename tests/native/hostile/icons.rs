//! Icons of two packages and glyphs of a font as people have them.

use super::report;
use crate::support::fixture;
use crate::support::{largest, solve, spread_points};
use conformal_warp::{
    Complex64, CurvedOutline, Edge, Frame, JointTriangulation, MeshOptions, MeshStop, Region, RiemannMap, SolveOptions,
    parse_path, parse_shape,
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

/// What became of outlines: how many were solved, with how many unknowns, the largest estimate, and the reasons of the others.
#[derive(Default)]
struct Solves {
    solved: usize,
    unknowns: usize,
    edges: usize,
    estimate: f64,
    refused: BTreeMap<&'static str, Vec<String>>,
}

impl Solves {
    /// Solves a chain to 1e-6, or notes why it bounds no region; a refusal names what is wrong with the drawing, not with the solver.
    fn take(&mut self, name: &str, edges: &[Edge]) {
        let outline = match CurvedOutline::new(edges) {
            Ok(outline) => outline,
            Err(error) => return self.refuse(error.code(), name),
        };
        let region = Region::from_edges(edges, deepest(&outline), edges[0].from()).unwrap();
        let options = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
        let map =
            RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(map.error_estimate() <= 1e-6, "{name}: {:e}", map.error_estimate());
        // There and back, where each way may err by the estimate.
        let points = spread_points(&region, 12);
        let images = map.to_disk(&points);
        let trip = map.to_disk(&map.from_disk(&images));
        let miss = largest(trip.iter().zip(&images).map(|(a, b)| (a - b).norm()));
        assert!(miss <= 2.0 * map.error_estimate(), "{name}: there and back {miss:e}");
        self.solved += 1;
        self.edges += edges.len();
        self.unknowns += map.unknowns();
        self.estimate = self.estimate.max(map.error_estimate());
    }

    fn refuse(&mut self, code: &'static str, name: &str) {
        assert!(["self-intersecting", "cusp", "invalid-outline"].contains(&code), "{name}: {code}");
        self.refused.entry(code).or_default().push(name.to_string());
    }

    fn tell(&self, what: &str) {
        let Self { solved, unknowns, edges, estimate, refused } = self;
        let refused: Vec<_> = refused.iter().map(|(code, names)| format!("{code}: {}", names.join(", "))).collect();
        report(&format!(
            "{what}: {solved} solved to 1e-6 ({edges} edges, {unknowns} unknowns, largest estimate {estimate:.1e}); refused: {}",
            refused.join("; ")
        ));
    }
}

#[test]
fn three_hundred_icons_of_one_curve_are_solved_or_refused_for_what_they_are() {
    let text = std::fs::read_to_string(fixture("outlines.json")).unwrap();
    let sets: BTreeMap<String, BTreeMap<String, String>> = serde_json::from_str(&text).unwrap();
    let mut solves = Solves::default();
    for (name, text) in sets.values().flatten() {
        match parse_shape(text, 1.0) {
            Ok(shape) => solves.take(name, &shape.outline),
            Err(error) => solves.refuse(error.code(), name),
        }
    }
    solves.tell("300 icons of one curve");
    assert!(solves.solved >= 240, "{}", solves.solved);
}

#[test]
fn glyphs_of_a_font_are_solved() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/www/letters.json")).unwrap();
    let letters: BTreeMap<String, Vec<String>> = serde_json::from_str(&text).unwrap();
    let mut solves = Solves::default();
    for (letter, paths) in &letters {
        solves.take(letter, &parse_path(&paths[0]).unwrap());
    }
    solves.tell("glyphs of a serif font");
    assert_eq!(solves.solved, letters.len());
}
