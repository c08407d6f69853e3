//! Regions that break weaker solvers: solved, or refused in words; never a wrong map without a word.

use crate::support::{
    EXACT_CASES, angle_error, c, case, complex, exact, largest, largest_difference, points, polygon, solve,
};
use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions, Stop};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

fn max_angle_error(map: &RiemannMap, exact: impl IntoIterator<Item = f64>) -> f64 {
    largest(map.angles().iter().zip(exact).map(|(a, b)| angle_error(*a, b)))
}

#[test]
fn similar_regions_have_the_same_map() {
    let moves = [(c(0.3, -0.2), c(5.0, 7.0)), (c(-4e3, 1e3), c(-1e3, 0.0)), (c(1e-5, 2e-5), c(3e-5, -1e-4))];
    for name in EXACT_CASES {
        let case = case(name);
        for (factor, shift) in moves {
            let moved = |z: [f64; 2]| complex(z) * factor + shift;
            let vertices: Vec<_> = case.vertices.iter().copied().map(moved).collect();
            let region = Region::new(&vertices, Curve::Polygon, moved(case.center), moved(case.toward)).unwrap();
            let map = solve(&region, 1e-10);
            let error = max_angle_error(&map, case.angles.clone());
            assert!(error < 1e-10, "{name} × {factor} + {shift}: {error:e}");
            let radius = map.conformal_radius() / factor.norm() / case.conformal_radius - 1.0;
            assert!(radius.abs() < 1e-10, "{name}: radius {radius:e}");
        }
    }
}

#[test]
fn start_vertex_and_orientation_do_not_matter() {
    let case = case("sc_9_103");
    let n = case.vertices.len();
    for start in [1, 4, 8] {
        for reversed in [false, true] {
            let order = (0..n).map(|k| if reversed { (start + n - k) % n } else { (start + k) % n });
            let vertices: Vec<_> = order.map(|k| complex(case.vertices[k])).collect();
            let region = Region::new(&vertices, Curve::Polygon, complex(case.center), complex(case.toward)).unwrap();
            let map = solve(&region, 1e-10);
            // The region turns its vertices counter-clockwise, from the first one given.
            let exact = (0..n).map(|k| case.angles[(start + k) % n]);
            assert!(max_angle_error(&map, exact) < 1e-10, "start {start}, reversed {reversed}");
        }
    }
}

#[test]
fn collinear_and_repeated_vertices() {
    let vertices = points(&[
        [-1.0, -1.0],
        [-1.0, -1.0],
        [0.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [1.0, 1.0],
        [0.3, 1.0],
        [-1.0, 1.0],
        [-1.0, -1.0],
    ]);
    let map = solve(&polygon(&vertices, c(0.0, 0.0)), 1e-11);
    assert_eq!(map.region().boundary().len(), 6);
    for (k, exact) in [(0, 0.0), (1, 0.25 * PI), (2, FRAC_PI_2), (3, PI), (5, 1.5 * PI)] {
        assert!(angle_error(map.angles()[k], exact) < 1e-11, "vertex {k}: {}", map.angles()[k]);
    }
}

/// A square with a slit cut in from the right: interior angles 1.98π at its tip, sharp wedges beside it.
#[test]
fn slits_and_spikes() {
    let half_gap = (0.01 * PI).tan();
    let slit =
        points(&[[-1.0, -1.0], [1.0, -1.0], [1.0, -half_gap], [0.0, 0.0], [1.0, half_gap], [1.0, 1.0], [-1.0, 1.0]]);
    let spike_width = (0.015 * PI).tan();
    let spike = points(&[
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, -spike_width],
        [2.0, 0.0],
        [1.0, spike_width],
        [1.0, 1.0],
        [-1.0, 1.0],
    ]);
    for (name, vertices) in [("slit α = 1.98", slit), ("spike α = 0.03", spike)] {
        let region = polygon(&vertices, c(-0.5, 0.1));
        let map = solve(&region, 1e-9);
        assert_eq!(map.stop(), Stop::Tolerance, "{name}");
        let difference = largest_difference(&map, &solve(&region, 1e-12));
        assert!(difference < 1e-9, "{name}: {difference:e}");
    }
}

/// Cutting a corner of the square by 1e-6 changes the map only there: two vertices with a shared measure of about 1e-12
/// (the corner maps like s²), and everything else stays.
#[test]
fn tiny_edges_beside_long_ones() {
    let e = 1e-6;
    let vertices = points(&[[-1.0, -1.0], [1.0 - e, -1.0], [1.0, -1.0 + e], [1.0, 1.0], [-1.0, 1.0]]);
    let map = solve(&polygon(&vertices, c(0.0, 0.0)), 1e-11);
    assert_eq!(map.stop(), Stop::Tolerance);
    let exact = [0.0, FRAC_PI_2, FRAC_PI_2, PI, 1.5 * PI];
    let error = max_angle_error(&map, exact);
    assert!(error < 1e-11, "{error:e}");
}

#[test]
fn logarithmic_capacity_one_is_not_special() {
    // Side of the square of capacity 1: 4π^(3/2)/Γ(1/4)².
    let half_side = 0.5 / 0.590_170_299_508_048_1;
    let vertices: Vec<_> = points(&SQUARE).iter().map(|v| v * half_side).collect();
    let map = solve(&polygon(&vertices, c(0.0, 0.0)), 1e-12);
    assert!((map.conformal_radius() / half_side - 1.078_705_202_376_758_7).abs() < 1e-12);
}

/// The map for a center beside the wall is the map for the middle followed by a Möbius map.
#[test]
fn center_beside_the_wall() {
    let middle = solve(&polygon(&points(&SQUARE), c(0.0, 0.0)), 1e-13);
    for distance in [0.1, 1e-3, 1e-6] {
        let center = c(0.3, -1.0 + distance);
        let map = solve(&polygon(&points(&SQUARE), center), 1e-9);
        assert_eq!(map.stop(), Stop::Tolerance, "distance {distance:e}");
        let a = middle.to_disk(&[center])[0];
        let moebius = |w: Complex64| (w - a) / (1.0 - a.conj() * w);
        let turn = moebius(Complex64::cis(middle.angles()[0]));
        let exact = middle.angles().iter().map(|angle| (moebius(Complex64::cis(*angle)) / turn).arg());
        let error = max_angle_error(&map, exact);
        assert!(error < 1e-9 && error <= map.error_estimate(), "distance {distance:e}: {error:e}");
    }
}

#[test]
fn huge_and_tiny_coordinates() {
    for scale in [1e-150, 1e150] {
        let vertices: Vec<_> = points(&SQUARE).iter().map(|v| v * scale).collect();
        let map = solve(&polygon(&vertices, c(0.0, 0.0)), 1e-11);
        assert!(max_angle_error(&map, (0..4).map(|k| f64::from(k) * FRAC_PI_2)) < 1e-11);
        assert!((map.conformal_radius() / scale / 1.078_705_202_376_758_7 - 1.0).abs() < 1e-11, "{scale:e}");
    }
}

#[test]
fn crowded_ends_get_their_exact_measure() {
    for a in [2.0, 5.0, 10.0, 20.0] {
        let map = solve(&exact::rectangle(a), 1e-12);
        let angles = map.angles();
        let measure = (angles[2] - angles[1]) / TAU;
        assert!((measure - exact::short_side_measure(a)).abs() < 1e-12, "a = {a}: {measure:e}");
    }
}

#[test]
fn another_center_reuses_the_system() {
    let case = case("sc_15_104");
    let first = solve(&case.region(), 1e-9);
    let center = complex(case.center) + c(-0.15, 0.1);
    let toward = complex(case.vertices[5]);
    let moved = first.with_center(center, toward, &mut |_, _| true).unwrap();
    let fresh = solve(&Region::new(first.region().boundary(), Curve::Polygon, center, toward).unwrap(), 1e-9);
    assert!(largest_difference(&moved, &fresh) < 2e-9);
    assert!(angle_error(moved.angles()[5], 0.0) < 1e-15);
    // Turning only: nothing is solved at all.
    let mut calls = 0;
    let turned = first
        .with_center(first.region().center(), toward, &mut |_, _| {
            calls += 1;
            true
        })
        .unwrap();
    assert_eq!(calls, 0);
    assert!(angle_error(turned.angles()[5], 0.0) < 1e-15);
    assert_eq!(first.with_center(c(9.0, 9.0), toward, &mut |_, _| true).unwrap_err().code(), "center-outside");
}

#[test]
fn cancelling_and_bad_options() {
    let region = case("blob100").region();
    let mut stages = Vec::new();
    let cancelled = RiemannMap::solve(&region, &SolveOptions::default(), &mut |stage, fraction| {
        assert!((0.0..=1.0).contains(&fraction));
        stages.push(stage);
        stages.len() < 5
    });
    assert_eq!(cancelled.unwrap_err().code(), "cancelled");
    assert_eq!(stages.len(), 5);
    for tolerance in [0.0, -1.0, f64::NAN, 1.0, 1e-17] {
        let options = SolveOptions { tolerance, ..SolveOptions::default() };
        assert_eq!(RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap_err().code(), "invalid-option");
    }
}

#[test]
fn stopping_short_is_said() {
    let region = case("neck").region();
    let options = SolveOptions { tolerance: 1e-10, max_unknowns: 500, ..SolveOptions::default() };
    let map = RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap();
    assert_eq!(map.stop(), Stop::MaxUnknowns);
    assert!(map.unknowns() <= 500 && map.error_estimate() > 1e-10);
    let error = largest_difference(&map, &solve(&region, 1e-12));
    assert!(error <= map.error_estimate(), "{error:e} above {:e}", map.error_estimate());
}

/// Seen from a center at distance d above the middle of a long edge, the region is a half plane: the radius is 2d.
#[test]
fn center_next_to_an_edge() {
    let square = points(&[[-1.0, 0.0], [1.0, 0.0], [1.0, 2.0], [-1.0, 2.0]]);
    for distance in [1e-9, 1e-11, 1e-12] {
        let mut iterations = 0;
        let map = RiemannMap::solve(&polygon(&square, c(0.25, distance)), &SolveOptions::default(), &mut |stage, _| {
            iterations += usize::from(stage == "solve");
            true
        })
        .unwrap();
        assert_eq!(map.stop(), Stop::Tolerance, "{distance:e}");
        let radius = map.conformal_radius() / (2.0 * distance) - 1.0;
        assert!(radius.abs() < 1e-8, "{distance:e}: radius off by {radius:e}");
        assert!(iterations <= 60 && map.unknowns() <= 1500, "{iterations} iterations, {} unknowns", map.unknowns());
    }
}

/// Corridors: what is far from the center costs its unknowns, and no rounds of its own.
#[test]
fn combs_take_few_iterations() {
    let teeth = 100;
    let mut comb = vec![[0.0, -1.0], [2.0 * f64::from(teeth), -1.0]];
    for k in (0..teeth).rev() {
        let x = 2.0 * f64::from(k);
        comb.extend([[x + 1.5, 0.0], [x + 1.5, 3.0], [x + 0.5, 3.0], [x + 0.5, 0.0]]);
    }
    comb.push([0.0, 0.0]);
    comb.insert(2, [2.0 * f64::from(teeth), 0.0]);
    let region = polygon(&points(&comb), c(f64::from(teeth), -0.5));
    let mut iterations = 0;
    let options = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
    let map = RiemannMap::solve(&region, &options, &mut |stage, _| {
        iterations += usize::from(stage == "solve");
        true
    })
    .unwrap();
    assert_eq!(map.stop(), Stop::Tolerance);
    assert!(iterations <= 70 && map.unknowns() <= 5500, "{iterations} iterations, {} unknowns", map.unknowns());
}
