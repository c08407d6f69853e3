//! Corners of interior angle 0, where edges touch: exact answers by Möbius maps and strips.

use super::curved::errors_of;
use crate::support::{c, largest, solve};
use conformal_warp::{Complex64, Edge, Error, Region, RiemannMap, SolveOptions};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Conformal radius of the ideal triangle at its middle.
const TRIANGLE: f64 = 0.307_509_933_909_916_8;

/// The regular polygon whose `n` corners lie on the unit circle, and whose edges are hyperbolic lines.
fn ideal(n: u32) -> Vec<Edge> {
    let half = PI / f64::from(n);
    let arc = |k: u32| {
        let turn = 2.0 * half * f64::from(k) + half;
        let center = Complex64::from_polar(1.0 / half.cos(), turn);
        Edge::circular(center, half.tan(), turn + PI + FRAC_PI_2 - half, -(PI - 2.0 * half))
    };
    (0..n).map(arc).collect()
}

fn arbelos() -> [Edge; 3] {
    [
        Edge::circular(c(0.0, 0.0), 1.0, 0.0, PI),
        Edge::circular(c(-0.5, 0.0), 0.5, PI, -PI),
        Edge::circular(c(0.5, 0.0), 0.5, PI, -PI),
    ]
}

/// Between two circles that touch in 1: twice a corner.
fn crescent() -> [Edge; 2] {
    [Edge::circular(c(0.0, 0.0), 1.0, 0.0, TAU), Edge::circular(c(0.5, 0.0), 0.5, 0.0, -TAU)]
}

/// The crescent's map: 1/(z − 1) goes to the strip −1 < Re < −½, and a power of e to a half plane.
fn from_crescent(center: Complex64, z: Complex64) -> (Complex64, Complex64) {
    let lift = |z: Complex64| {
        let u = (z - 1.0).inv();
        let e = (TAU * Complex64::i() * (u + 1.0)).exp();
        (e, -TAU * Complex64::i() * u * u * e)
    };
    let (a, (e, slope)) = (lift(center).0, lift(z));
    let below = e - a.conj();
    ((e - a) / below, slope * (a - a.conj()) / (below * below))
}

fn solved(edges: &[Edge], center: Complex64, tolerance: f64) -> RiemannMap {
    solve(&Region::from_edges(edges, center, edges[0].from()).unwrap(), tolerance)
}

#[test]
fn conformal_radii_of_regions_with_horns() {
    let cases = [
        ("ideal triangle", ideal(3), c(0.0, 0.0), TRIANGLE),
        ("ideal square", ideal(4), c(0.0, 0.0), 0.456_946_581_044_463_63),
        ("ideal hexagon", ideal(6), c(0.0, 0.0), 0.615_019_867_819_833_6),
        ("arbelos", arbelos().to_vec(), c(0.0, 3.0_f64.sqrt().recip()), 2.0 * TRIANGLE / 3.0_f64.sqrt()),
        ("crescent", crescent().to_vec(), c(-0.5, 0.0), 0.620_245_007_349_516_1),
    ];
    for (name, edges, center, radius) in cases {
        let turned: Vec<Edge> = edges.iter().rev().map(Edge::reversed).collect();
        for edges in [edges, turned] {
            let map = solved(&edges, center, 1e-12);
            let error = (map.conformal_radius() / radius - 1.0).abs();
            println!("{name}: {error:e}, estimate {:e}, {} unknowns", map.error_estimate(), map.unknowns());
            assert!(map.error_estimate() <= 1e-12, "{name}: estimate {:e}", map.error_estimate());
            assert!(error < 1e-12 && error <= map.error_estimate(), "{name}: {error:e}");
        }
    }
}

#[test]
fn crescents_everywhere() {
    for center in [c(-0.5, 0.0), c(0.3, 0.7), c(0.9, -0.4)] {
        let map = solved(&crescent(), center, 1e-12);
        let turn = map.to_disk(&[c(-0.7, 0.1)])[0] / from_crescent(center, c(-0.7, 0.1)).0;
        assert!((turn.norm() - 1.0).abs() < 1e-11, "{center}: {turn}");
        let turn = turn / turn.norm();
        let exact = |z: Complex64| {
            let (w, slope) = from_crescent(center, z);
            (turn * w, turn * slope)
        };
        // Along circles that touch in 1, from wall to wall, and into both horns.
        let mut points = Vec::new();
        for across in [1e-9, 1e-3, 0.2, 0.5, 0.9, 0.9999] {
            for along in [-4.0, -2.0, -0.7, 0.0, 0.4, 1.5, 5.0] {
                points.push(1.0 + c(-1.0 + 0.5 * across, along).inv());
            }
        }
        let [forth, back, slope] = errors_of(&map, &points, exact);
        let estimate = map.error_estimate();
        assert!(forth <= 1e-11 && back <= 1e-11 && slope < 1e-9, "{center}: {forth:e} {back:e} {slope:e} {estimate:e}");
        // Deep in a horn, and in its tip itself: the point that the tip goes to.
        for along in [60.0, 1e3, 1e6, -1e4] {
            let tip = map.to_disk(&[1.0 + c(-0.75, along).inv(), c(1.0, 0.0)]);
            let (wanted, _) = exact(1.0 + c(-0.75, 30.0 * f64::signum(along)).inv());
            assert!((tip[0] - wanted).norm() < 1e-11, "{center} {along}: {} {wanted}", tip[0]);
            assert!((tip[1].norm() - 1.0).abs() < 1e-14);
        }
        let outside = [c(0.5, 0.0), c(1.0 - 1e-3, 0.0), c(1.0 + 1e-9, 0.0), c(1.0, 0.1), c(0.99, 1e-6)];
        assert!(map.to_disk(&outside).iter().all(|w| w.is_nan()), "{:?}", map.to_disk(&outside));
    }
}

#[test]
fn corners_of_angle_zero_keep_their_places() {
    let region = Region::from_edges(&ideal(3), c(0.0, 0.0), c(1.0, 0.0)).unwrap();
    let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true).unwrap();
    for (angle, wanted) in map.angles().iter().zip([0.0, TAU / 3.0, 2.0 * TAU / 3.0]) {
        let miss = (angle - wanted).abs();
        assert!(miss.min(TAU - miss) < 1e-7, "{:?}", map.angles());
        let place = map.boundary_point(*angle);
        assert!((place.point - Complex64::cis(wanted)).norm() < 0.2, "{wanted}: {place:?}");
    }
    // Stored and read, and from another center.
    let stored = RiemannMap::from_bytes(&map.to_bytes()).unwrap();
    let points = [c(0.1, 0.2), c(0.8, 0.0), c(0.97, 1e-4), c(1.0, 0.0)];
    assert_eq!(stored.to_disk(&points), map.to_disk(&points));
    let moved = map.with_center(c(0.3, 0.1), c(1.0, 0.0), &mut |_, _| true).unwrap();
    let again = RiemannMap::solve(moved.region(), &SolveOptions::default(), &mut |_, _| true).unwrap();
    let (found, expected) = (moved.to_disk(&points), again.to_disk(&points));
    let error = largest(found.iter().zip(expected).map(|(a, b)| (a - b).norm()));
    assert!(error <= moved.error_estimate() + again.error_estimate(), "{error:e}");
}

#[test]
fn horns_of_what_is_outside_and_edges_that_never_part_are_refused() {
    let box_with = |dent: &[Edge]| {
        let [first, last] = [dent[0].from(), dent[dent.len() - 1].to()];
        let corners = [last, c(-2.0, 1.0), c(-2.0, -1.0), c(2.0, -1.0), c(2.0, 1.0), first];
        let lines = corners.windows(2).map(|ends| Edge::line(ends[0], ends[1]));
        Region::from_edges(&dent.iter().copied().chain(lines).collect::<Vec<_>>(), c(0.0, -0.5), c(0.0, -1.0))
    };
    let arcs =
        [Edge::circular(c(1.0, 0.0), 1.0, FRAC_PI_2, FRAC_PI_2), Edge::circular(c(-1.0, 0.0), 1.0, 0.0, FRAC_PI_2)];
    let slit = [Edge::line(c(0.0, 1.0), c(0.0, 0.0)), Edge::line(c(0.0, 0.0), c(0.0, 1.0))];
    for dent in [arcs, slit] {
        let error = box_with(&dent).unwrap_err();
        assert_eq!(error, Error::Cusp { edge: 1, at: c(0.0, 0.0) });
    }
}
