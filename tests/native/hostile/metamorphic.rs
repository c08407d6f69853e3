//! One region written in other ways: what must not change, does not.

use super::{report, rounds};
use crate::support::random::{self, Random};
use crate::support::{angle_error, largest, solve, spread_points};
use conformal_warp::{Complex64, Curve, Region, RiemannMap};

/// A way to write a region anew: what becomes of its points, and whether orientation turns round.
struct Change {
    name: &'static str,
    at: fn(Complex64) -> Complex64,
    mirrored: bool,
}

const CHANGES: [Change; 6] = [
    Change { name: "the same", at: |z| z, mirrored: false },
    Change { name: "turned", at: |z| z * Complex64::new(0.6, 0.8), mirrored: false },
    Change { name: "1e8 times as large", at: |z| z * 1e8, mirrored: false },
    Change { name: "1e-8 times as large", at: |z| z * 1e-8, mirrored: false },
    Change { name: "moved by 1000", at: |z| z + 1000.0, mirrored: false },
    Change { name: "mirrored", at: |z| z.conj(), mirrored: true },
];

/// The outline from another vertex on, the other way round, and with a vertex on each edge that changes nothing.
fn rewritten(corners: &[Complex64], random: &mut Random) -> Vec<Complex64> {
    let mut corners = match random.below(3) {
        0 => corners.to_vec(),
        1 => corners.iter().rev().copied().collect(),
        _ => (0..corners.len())
            .flat_map(|k| [corners[k], 0.5 * (corners[k] + corners[(k + 1) % corners.len()])])
            .collect(),
    };
    let shift = random.below(corners.len());
    corners.rotate_left(shift);
    corners
}

/// z ↦ the disk, in the first region's own terms.
fn images(map: &RiemannMap, points: &[Complex64], change: &Change) -> Vec<Complex64> {
    let moved: Vec<_> = points.iter().map(|z| (change.at)(*z)).collect();
    let mirror = |w: Complex64| if change.mirrored { w.conj() } else { w };
    map.to_disk(&moved).into_iter().map(mirror).collect()
}

#[test]
fn a_region_written_otherwise_has_the_same_map() {
    let tried = 6 * rounds();
    let mut worst: f64 = 0.0;
    for seed in 0..tried {
        let mut random = Random::new(1_000_000 + seed);
        let region = random::region(&mut random);
        let map = solve(&region, 1e-8);
        let points = spread_points(&region, 40);
        let expected = map.to_disk(&points);
        let change = &CHANGES[random.below(CHANGES.len())];
        let corners: Vec<_> = rewritten(region.boundary(), &mut random).into_iter().map(change.at).collect();
        let (center, toward) = ((change.at)(region.center()), (change.at)(region.toward().point));
        let other = Region::new(&corners, Curve::Polygon, center, toward).unwrap();
        let other = solve(&other, 1e-8);
        let size = region.polygon().size();
        // What the numbers of the moved outline cannot hold is nobody's error.
        let held = corners.iter().map(|z| z.norm() * f64::EPSILON).fold(0.0, f64::max)
            / ((change.at)(Complex64::new(size, 0.0)) - (change.at)(Complex64::ZERO)).norm();
        let allowed = map.error_estimate() + other.error_estimate() + 1e4 * held;
        let found = images(&other, &points, change);
        let error = largest(found.iter().zip(&expected).map(|(a, b)| (a - b).norm()));
        assert!(error <= allowed, "seed {seed}, {}: {error:e} for {allowed:e}", change.name);
        // Back in the region, measured where it is seen: in the disk. Far ends crowd beyond what numbers there tell apart.
        let moved: Vec<_> = points.iter().map(|z| (change.at)(*z)).collect();
        let back = other.from_disk(&other.to_disk(&moved));
        let slopes = other.derivative(&moved);
        let away = largest((0..moved.len()).map(|k| (back[k] - moved[k]).norm() * slopes[k].norm()));
        assert!(away <= 20.0 * allowed, "seed {seed}, {}: {away:e} off on the way back, for {allowed:e}", change.name);
        worst = worst.max(error / allowed);
    }
    report(&format!("written otherwise: {tried} regions, largest difference {worst:.2} of the estimates' sum"));
}

/// withCenter = a fresh solve = the Möbius image of the first map.
#[test]
fn another_center_is_a_fresh_solve_and_a_moebius_image() {
    let tried = 4 * rounds();
    for seed in 0..tried {
        let mut random = Random::new(2_000_000 + seed);
        let region = random::region(&mut random);
        let map = solve(&region, 1e-8);
        let points = spread_points(&region, 40);
        let center = points[random.below(points.len())];
        let (a, b) = region.polygon().edge(random.below(region.polygon().len()));
        let toward = a + (b - a) * random.between(0.1, 0.9);
        let moved = map.with_center(center, toward, &mut |_, _| true).unwrap();
        let fresh = solve(&Region::new(region.boundary(), Curve::Polygon, center, toward).unwrap(), 1e-8);
        let found = moved.to_disk(&points);
        let error = largest(found.iter().zip(fresh.to_disk(&points)).map(|(a, b)| (a - b).norm()));
        let allowed = moved.error_estimate() + fresh.error_estimate();
        assert!(error <= allowed, "seed {seed}: {error:e} for {allowed:e}");
        if 1.0 - map.to_disk(&[center])[0].norm_sqr() < 1e-4 {
            continue;
        }
        // The Möbius image: w ↦ (w − a)/(1 − ā w), turned so that `toward` lies at 1. It amplifies what it starts from.
        let [w0] = map.to_disk(&[center])[..] else { unreachable!() };
        let moebius = |w: Complex64| (w - w0) / (1.0 - w0.conj() * w);
        let turn = moebius(Complex64::cis(map.boundary_angle(region.nearest(toward)))).conj();
        let amplified = 4.0 / (1.0 - w0.norm_sqr()) * map.error_estimate() + moved.error_estimate();
        let error = largest(found.iter().zip(map.to_disk(&points)).map(|(a, w)| (a - moebius(w) * turn).norm()));
        assert!(error <= amplified, "seed {seed}: Möbius image {error:e} for {amplified:e}");
    }
    report(&format!("another center: {tried} regions, each as a fresh solve and as a Möbius image"));
}

#[test]
fn points_one_by_one_are_those_of_the_batch_bit_for_bit() {
    let tried = 4 * rounds();
    for seed in 0..tried {
        let mut random = Random::new(3_000_000 + seed);
        let region = random::region(&mut random);
        let map = solve(&region, 1e-6);
        let points = spread_points(&region, 200);
        let batch = map.to_disk(&points);
        let back = map.from_disk(&batch);
        for (k, z) in points.iter().enumerate() {
            assert_eq!(map.to_disk(&[*z])[0], batch[k], "seed {seed}, point {k}");
            assert_eq!(map.from_disk(&[batch[k]])[0], back[k], "seed {seed}, point {k} back");
        }
    }
    report(&format!("one by one: {tried} regions of 200 points, the same bits"));
}

/// Angles of the vertices do not depend on which vertex comes first.
#[test]
fn angles_follow_their_vertices() {
    let tried = 12 * rounds();
    for seed in 0..tried {
        let mut random = Random::new(4_000_000 + seed);
        let region = random::region(&mut random);
        let map = solve(&region, 1e-8);
        let mut corners = region.boundary().to_vec();
        let shift = random.below(corners.len());
        corners.rotate_left(shift);
        let other =
            solve(&Region::new(&corners, Curve::Polygon, region.center(), region.toward().point).unwrap(), 1e-8);
        let n = corners.len();
        let error = largest((0..n).map(|k| angle_error(other.angles()[k], map.angles()[(k + shift) % n])));
        let allowed = map.error_estimate() + other.error_estimate();
        assert!(error <= allowed, "seed {seed}: {error:e} for {allowed:e}");
    }
}
