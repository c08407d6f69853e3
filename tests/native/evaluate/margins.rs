//! Where digits are scarce: centers beside a wall, spikes, thin wings, regions far from 0.

use crate::support::{c, case, fault, largest, polygon, share, solve, spread_points};
use conformal_warp::{Complex64, Curve, JointTriangulation, MeshOptions, Region, RegionMap, RiemannMap};
use std::f64::consts::TAU;

fn distance(a: &[Complex64], b: &[Complex64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).norm()))
}

fn spread_over_disk(count: usize) -> Vec<Complex64> {
    let point = |k| Complex64::from_polar(0.99 * share(k, 0.618_034).sqrt(), TAU * share(k, 0.754_878));
    (1..=count).map(point).collect()
}

/// So near to a straight wall it is a half plane: |w| = |z − c|/|z − c̄|, radius 2d, both up to d².
#[test]
fn a_center_beside_a_wall_sees_a_half_plane() {
    let square = polygon(&[c(-1.0, 0.0), c(1.0, 0.0), c(1.0, 2.0), c(-1.0, 2.0)], c(0.0, 1.0));
    let map = solve(&square, 1e-8);
    for d in [1e-3, 1e-6, 1e-9] {
        let center = c(0.25, d);
        let moved = map.with_center(center, c(1.0, 1.0), &mut |_, _| true).unwrap();
        assert!(moved.error_estimate() <= 1e-8, "{d:e}: {:e}", moved.error_estimate());
        let allowed = moved.error_estimate() + 10.0 * d * d + 1e-9;
        let radius = moved.conformal_radius() / (2.0 * d) - 1.0;
        assert!(radius.abs() <= allowed, "{d:e}: radius {radius:e} off");
        let z: Vec<_> = (0..60)
            .map(|k| center + Complex64::from_polar(d * (0.05 + 3.0 * share(k, 0.618_034)), TAU * share(k, 0.754_878)))
            .filter(|z| z.im > 0.0)
            .collect();
        let size = |z: Complex64| (z - center).norm() / (z - center.conj()).norm();
        let images = moved.to_disk(&z);
        let error = largest(images.iter().zip(&z).map(|(w, z)| (w.norm() - size(*z)).abs()));
        // Coordinates of a square of size 2 hold 2e-16: of d that share.
        assert!(error <= allowed + 2.5e-16 / d, "{d:e}: {error:e} off");
        let back = largest(moved.from_disk(&images).iter().zip(&z).map(|(a, b)| (a - b).norm() / d));
        assert!(back <= 10.0 * allowed + 1e-15 / d, "{d:e}: {back:e} off on the way back");
    }
}

/// A spike of 2.5 degrees, seven times as long as its room.
#[test]
fn a_spike_goes_both_ways() {
    let map = solve(&case("spike").region(), 1e-10);
    let w = spread_over_disk(5000);
    let worst = distance(&map.to_disk(&map.from_disk(&w)), &w);
    assert!(worst <= map.error_estimate(), "{worst:e} against {:e}", map.error_estimate());
    // At the distance d from the tip numbers of the disk are (d/7)^73 apart from its image: the deeper part comes back roughly.
    let axis = |from: f64, to: f64| (0..400).map(move |k| c(from + (to - from) * share(k, 0.618_034), 0.15));
    let z: Vec<_> = axis(1.0, 2.2).collect();
    let worst = distance(&map.from_disk(&map.to_disk(&z)), &z);
    assert!(worst <= 1e-6, "{worst:e}");
    let z: Vec<_> = axis(2.2, 8.0).collect();
    assert!(map.from_disk(&map.to_disk(&z)).iter().all(|z| map.region().contains(*z) && z.re > 2.0));
}

/// A symmetric wing section of four digits, as its tables give it: 35 points from the trailing edge around.
fn naca(thickness: f64) -> Region {
    let stations = [1.0, 0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1, 0.075, 0.05, 0.025, 0.0125];
    let height = |x: f64| {
        let series = 0.2969 * x.sqrt() + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1015 * x)));
        5.0 * thickness * series
    };
    let upper = stations.iter().map(|&x| c(x, height(x)));
    let lower = stations.iter().rev().map(|&x| c(x, -height(x)));
    let points: Vec<_> = upper.chain([Complex64::ZERO]).chain(lower).collect();
    Region::new(&points, Curve::Polygon, c(0.3, 0.0), c(1.0, 0.0)).unwrap()
}

/// As wide as 1 and 0.06 high: 594 of 2500 points came back as NaN.
#[test]
fn wings_go_both_ways() {
    for thickness in [0.06, 0.12] {
        let region = naca(thickness);
        let map = solve(&region, 1e-8);
        let mut z = spread_points(&region, 2500);
        let directly = distance(&map.to_disk(&z), &map.to_disk_directly(&z));
        assert!(directly <= map.error_estimate(), "{thickness}: {directly:e}");
        z.extend(region.boundary());
        assert!(map.from_disk(&map.to_disk(&z)).iter().all(|z| region.contains(*z)), "{thickness}");
        let worst = distance(&map.from_disk_points(&map.to_disk_points(&z)), &z);
        assert!(worst <= 1e-6 * thickness, "{thickness}: {worst:e}");
        let w = spread_over_disk(2000);
        let worst = distance(&map.to_disk(&map.from_disk(&w)), &w);
        assert!(worst <= map.error_estimate(), "{thickness}: {worst:e}");
    }
}

/// The regions of projected maps: size 100 at 1e8, where coordinates hold 1.5e-8. Between two of them, and as meshes, they are
/// what they are at 0.
#[test]
fn regions_far_from_0_are_joined_as_near_ones() {
    let value = fault("fromDisk-far-from-origin");
    let list = |name: &str| -> Vec<[f64; 2]> { serde_json::from_value(value[name].clone()).unwrap() };
    let point = |name: &str| {
        let [x, y]: [f64; 2] = serde_json::from_value(value[name].clone()).unwrap();
        c(x, y)
    };
    let corners: Vec<_> = list("boundary relative").iter().map(|&[x, y]| c(x, y)).collect();
    let far = c(1e8, 1e8);
    let solved = |corners: &[Complex64], center: Complex64, toward: Complex64, by: Complex64| -> RiemannMap {
        let moved: Vec<_> = corners.iter().map(|z| z + by).collect();
        solve(&Region::new(&moved, Curve::Polygon, center + by, toward + by).unwrap(), 1e-8)
    };
    let square = [c(0.0, 0.0), c(100.0, 0.0), c(100.0, 100.0), c(0.0, 100.0)];
    let pair = |by: Complex64| {
        let from = solved(&corners, point("center relative"), point("toward relative"), by);
        (from, solved(&square, c(50.0, 50.0), c(100.0, 50.0), by))
    };
    let ((a, b), (far_a, far_b)) = (pair(Complex64::ZERO), pair(far));
    let (near, away) = (RegionMap::between(&a, &b), RegionMap::between(&far_a, &far_b));
    // Points that both coordinates hold; not beside corners, where neighbouring numbers go far apart.
    let inner = |z: &Complex64| (z - 35.0 - c(0.0, 40.0)).norm() < 30.0;
    let z: Vec<_> = spread_points(a.region(), 800).into_iter().filter(inner).map(|z| (z + far) - far).collect();
    let moved: Vec<_> = z.iter().map(|z| z + far).collect();
    let back = |points: Vec<Complex64>| -> Vec<Complex64> { points.into_iter().map(|z| z - far).collect() };
    let error = distance(&back(away.try_forward(&moved).unwrap()), &near.try_forward(&z).unwrap());
    assert!(error < 1e-6, "{error:e}");
    let images = near.forward(&z);
    let error = distance(&back(away.inverse(&away.forward(&moved))), &near.inverse(&images));
    assert!(error < 1e-6, "{error:e}");
    let mesh = JointTriangulation::region_to_region(&far_a, &far_b, &MeshOptions::with_spacing(8.0)).unwrap();
    mesh.validate().unwrap();
    assert!(mesh.flipped() == 0 && mesh.source().len() > 100, "{} nodes", mesh.source().len());
    for (z, w) in back(mesh.source().to_vec()).iter().zip(back(mesh.target().to_vec())).filter(|(z, _)| inner(z)) {
        let error = (near.forward(&[*z])[0] - w).norm();
        assert!(error < 1e-6, "{z} goes to {w}, {error:e} off");
    }
}
