//! Other centers by an automorphism of the disk: nothing is solved, and the estimate holds.

use crate::support::{
    angle_error, boundary_points, c, case, complex, exact, fixture, largest, largest_difference,
    points_beside_boundary, solve, spread_points,
};
use conformal_warp::{
    Complex64, Curve, DiskPoint, RectangleMap, Region, RegionMap, RiemannMap, SolveOptions, Stop, parse_shape,
};
use std::f64::consts::TAU;

/// The map for another center, by the automorphism alone.
fn recentred(map: &RiemannMap, center: Complex64) -> RiemannMap {
    let toward = map.region().boundary()[0];
    let nothing = &mut |stage: &str, _: f64| panic!("{stage}: something is solved");
    map.with_center_within(center, toward, 0.1, nothing).unwrap()
}

fn fresh(map: &RiemannMap, moved: &RiemannMap, tolerance: f64) -> RiemannMap {
    let region = map.region().with_center(moved.region().center(), moved.region().toward().point).unwrap();
    solve(&region, tolerance)
}

fn smooth() -> Region {
    let points: Vec<_> = (0..90).map(|k| TAU * f64::from(k) / 90.0).map(|t| c(3.0 * t.cos(), t.sin())).collect();
    Region::new(&points, Curve::Smooth, c(0.2, 0.1), points[7]).unwrap()
}

/// The widest outline of an icon.
fn icon(name: &str, center: Complex64) -> Region {
    let icons: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(fixture("icons.json")).unwrap()).unwrap();
    let all = icons.as_object().unwrap().values().flat_map(|icons| icons.as_array().unwrap());
    let icon = all.into_iter().find(|icon| icon["name"] == name).unwrap();
    let shape = parse_shape(icon["text"].as_str().unwrap(), 1.0).unwrap();
    Region::from_edges(&shape.outline, center, Complex64::ZERO).unwrap()
}

#[test]
fn as_good_as_its_estimate_says_everywhere() {
    let polygons = ["sc_15_104", "blob100", "sc_6_102"].map(|name| case(name).region());
    let curves = [smooth(), icon("git", c(6.0, -12.0))];
    for (k, region) in polygons.into_iter().chain(curves).enumerate() {
        for tolerance in [1e-4, 1e-9] {
            let map = solve(&region, tolerance);
            let mut tried = 0;
            for share in [0.1, 0.5, 0.8] {
                let center = region.center() * (1.0 - share) + spread_points(&region, 3)[k % 3] * share;
                if !region.contains(center) {
                    continue;
                }
                tried += 1;
                let moved = recentred(&map, center);
                assert!(moved.stop() == Stop::Tolerance && moved.error_estimate() > map.error_estimate());
                let fresh = fresh(&map, &moved, 1e-10);
                let allowed = moved.error_estimate() + fresh.error_estimate();
                let mut z = points_beside_boundary(&region);
                z.extend(boundary_points(&region).iter().map(|place| place.point));
                // Of curves these are points of chords.
                z.retain(|z| region.contains(*z));
                z.extend(spread_points(&region, 300));
                let (found, expected) = (moved.to_disk(&z), fresh.to_disk(&z));
                let error = largest(found.iter().zip(&expected).map(|(a, b)| (a - b).norm()));
                assert!(error <= allowed, "region {k}, {share}: {error:e} for {allowed:e}");
                let angles = largest(moved.angles().iter().zip(fresh.angles()).map(|(a, b)| angle_error(*a, *b)));
                assert!(angles <= allowed, "region {k}, {share}: angles {angles:e} for {allowed:e}");
                let radius = (moved.conformal_radius() / fresh.conformal_radius() - 1.0).abs();
                assert!(radius <= 2.0 * allowed, "region {k}, {share}: radius {radius:e} for {allowed:e}");
                assert!(moved.to_disk(&[center])[0].norm() < 1e-13, "region {k}, {share}");
                it_is_consistent(&moved, &format!("region {k}, {share}, {tolerance:e}"));
            }
            assert!(tried >= 2);
        }
    }
}

/// Both ways, with derivatives, points one by one and all at once, the boundary, and as bytes.
fn it_is_consistent(map: &RiemannMap, name: &str) {
    let z = spread_points(map.region(), 60);
    let w = map.to_disk(&z);
    let size = map.region().polygon().size();
    let estimate = map.error_estimate() + 1e-12;
    let back = map.from_disk(&w);
    // In the disk: where a region is narrow, errors in the plane are larger.
    let there = map.to_disk(&back);
    let error = largest(there.iter().zip(&w).map(|(a, b)| (a - b).norm()));
    assert!(error <= estimate, "{name}: {error:e} for {estimate:e}");
    let slopes = map.derivative(&z);
    for (k, slope) in slopes.iter().enumerate() {
        assert_eq!((map.to_disk(&[z[k]])[0], map.from_disk(&[w[k]])[0]), (w[k], back[k]), "{name}");
        let step = 1e-6 * size;
        let beside = map.to_disk(&[z[k] + step, z[k] - step]);
        let difference = (beside[0] - beside[1]) / (2.0 * step);
        // Cells meet where values jump by a share of the error.
        let jump = 1e-4 * slope.norm() + estimate / step;
        assert!(difference.norm().is_nan() || (difference - slope).norm() <= jump, "{name}: {slope} {difference}");
    }
    for k in 0..50 {
        let angle = TAU * f64::from(k) / 50.0;
        let place = map.boundary_point(angle);
        assert!(angle_error(map.boundary_angle(place), angle) <= 1e-9, "{name}: {angle}");
        let error = (map.to_disk(&[place.point])[0] - Complex64::cis(angle)).norm();
        assert!(error <= estimate, "{name}: {error:e} at {}", place.point);
    }
    let stored = map.to_bytes();
    let again = RiemannMap::from_bytes(&stored).unwrap();
    assert!(again.to_bytes() == stored && again.region() == map.region(), "{name}");
    assert_eq!((again.to_disk(&z), again.from_disk(&w)), (w, back), "{name}");
    assert_eq!((again.angles(), again.conformal_radius()), (map.angles(), map.conformal_radius()), "{name}");
}

#[test]
fn it_is_used_only_while_the_estimate_meets_the_tolerance() {
    let region = case("sc_15_104").region();
    let map = solve(&region, 1e-6);
    let z = spread_points(&region, 50);
    let (mut near, mut solved) = (0, 0);
    for center in spread_points(&region, 40) {
        let moved = map.with_center(center, region.boundary()[0], &mut |_, _| true).unwrap();
        assert!(moved.error_estimate() <= 1e-6, "{center}: {:e}", moved.error_estimate());
        let by_automorphism = recentred(&map, center);
        let is_same = moved.to_disk(&z) == by_automorphism.to_disk(&z);
        assert_eq!(is_same, by_automorphism.error_estimate() <= 1e-6, "{center}");
        *(if is_same { &mut near } else { &mut solved }) += 1;
    }
    assert!(near > 0 && solved > 0, "{near} {solved}");
    // From wherever it is seen, it is the map that was solved: errors do not add up.
    let (mut around, far) = (map.clone(), c(0.1, 0.05) + region.center());
    for k in 0..20 {
        around = recentred(&around, region.center() + Complex64::from_polar(0.05, f64::from(k)));
    }
    assert_eq!(recentred(&around, far).to_disk(&z), recentred(&map, far).to_disk(&z));
    let home = recentred(&around, region.center());
    let there = map.with_center(region.center(), region.boundary()[0], &mut |_, _| true).unwrap();
    assert_eq!(home.to_disk(&z), there.to_disk(&z));
    for tolerance in [0.0, 0.5, f64::NAN] {
        let refused = map.with_center_within(far, region.boundary()[0], tolerance, &mut |_, _| true);
        assert_eq!(refused.unwrap_err().code(), "invalid-option");
    }
}

/// What lies beyond the numbers of the circle keeps its place: it has charts of its own.
#[test]
fn far_ends_of_long_regions_stay_apart() {
    let map = solve(&exact::rectangle(20.0), 1e-8);
    let moved = recentred(&map, map.region().center() + c(0.6, 0.2));
    assert!(moved.charts() == map.charts() && map.charts() > 1);
    let z: Vec<_> = spread_points(map.region(), 400);
    let back = moved.from_disk_points(&moved.to_disk_points(&z));
    let error = largest(back.iter().zip(&z).map(|(a, b)| (a - b).norm()));
    assert!(error < 1e-6, "{error:e}");
    let fresh = fresh(&map, &moved, 1e-8);
    let allowed = moved.error_estimate() + fresh.error_estimate();
    assert!(largest_difference(&moved, &fresh) <= allowed);
    // On to the same region by a fresh solve: where it can be told, all stays in its place.
    for [a, b] in [[&moved, &fresh], [&fresh, &moved]] {
        let there = RegionMap::between(a, b).forward(&z);
        let known: Vec<_> = there.iter().zip(&z).filter(|(w, _)| !w.is_nan()).map(|(a, b)| (a - b).norm()).collect();
        assert!(known.len() > 100 && largest(known.iter().copied()) < 0.3, "{} {:e}", known.len(), largest(known));
    }
    assert!(moved.to_disk_points(&z).iter().all(|point| *point != DiskPoint::NOWHERE));
    let stored = RegionMap::between(&moved, &fresh);
    let again = RegionMap::from_bytes(&stored.to_bytes()).unwrap();
    assert!(again.target().to_bytes() == fresh.to_bytes() && again.source().to_bytes() == moved.to_bytes());
}

/// Maps with marked vertices keep the relative accuracy beside them.
#[test]
fn vertices_keep_their_own_variable() {
    let square = [c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)];
    let region = Region::new(&square, Curve::Polygon, Complex64::ZERO, square[0]).unwrap();
    let map =
        RiemannMap::solve(&region, &SolveOptions { tolerance: 1e-12, ..SolveOptions::default() }, &mut |_, _| true);
    let map = map.unwrap();
    let rectangles = [&map, &recentred(&map, c(0.3, -0.2))].map(|map| RectangleMap::of(map, square).unwrap());
    assert!(rectangles.iter().all(|rectangle| (rectangle.aspect() - 1.0).abs() < 1e-10));
    for step in [1e-3, 1e-8, 1e-14] {
        let z = square[2] - complex([step, 0.4 * step]);
        let [solved, error] = rectangles.each_ref().map(|rectangle| {
            let w = rectangle.to_rectangle(&[z])[0];
            let expected = c(1.0, 1.0) - complex([0.5 * step, 0.2 * step]);
            assert!((w - expected).norm() < 1e-10, "{step:e}: {w}");
            (rectangle.from_rectangle(&[w])[0] - z).norm()
        });
        // No worse than the map as it was solved.
        assert!(error <= 3.0 * solved + 1e-12 * step, "{step:e}: {error:e} for {solved:e}");
    }
}
