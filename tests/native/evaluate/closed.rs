//! Points of the closed region and of the closed disk, far ends and walls included: each has an image, and that depends on
//! nothing but the point.

use crate::support::{c, case, complex, fault, largest, points, polygon, solve, spread_points};
use conformal_warp::{Complex64, Curve, Region, RiemannMap};
use std::f64::consts::TAU;

fn xy(value: &serde_json::Value) -> [f64; 2] {
    serde_json::from_value(value.clone()).unwrap()
}

fn list(value: &serde_json::Value) -> Vec<Complex64> {
    points(&serde_json::from_value::<Vec<[f64; 2]>>(value.clone()).unwrap())
}

/// The region of a file of `tests/fixtures/faults`.
fn faulty_region(fault: &serde_json::Value) -> Region {
    let (center, toward) = (complex(xy(&fault["center"])), complex(xy(&fault["toward"])));
    Region::new(&list(&fault["boundary"]), Curve::Polygon, center, toward).unwrap()
}

/// Every point, its image and what that comes back to.
fn goes_both_ways(name: &str, map: &RiemannMap, z: &[Complex64]) {
    let w = map.to_disk(z);
    for (z, w) in z.iter().zip(&w) {
        assert!(w.norm() <= 1.0, "{name}: {z} goes to {w}");
    }
    for (w, back) in w.iter().zip(map.from_disk(&w)) {
        assert!(back.is_finite(), "{name}: {w} comes from {back}");
        assert!(map.region().contains(back), "{name}: {w} comes from {back}, outside");
    }
}

#[test]
fn long_rectangles_seen_from_one_end() {
    for length in [16.0, 40.0] {
        let corners = [c(0.0, 0.0), c(length, 0.0), c(length, 1.0), c(0.0, 1.0)];
        let map = solve(&Region::new(&corners, Curve::Polygon, c(0.5, 0.5), c(0.0, 0.5)).unwrap(), 1e-8);
        let mut z = spread_points(map.region(), 2000);
        z.extend([c(12.246589769308022, 0.5), c(12.439167502507628, 0.1), c(13.0, 0.5), c(15.0, 0.25)]);
        z.extend(corners);
        goes_both_ways(&format!("{length}:1"), &map, &z);
    }
}

#[test]
fn corridors_stay_in_the_disk() {
    let fault = fault("toDisk_outside_then_NaN");
    let map = solve(&faulty_region(&fault), 1e-8);
    let mut z = list(&fault["toDisk"]);
    z.extend(spread_points(map.region(), 500));
    goes_both_ways("spiral", &map, &z);
}

#[test]
fn toward_goes_to_1_and_boundaries_belong_to_their_regions() {
    let fault = fault("toDisk_of_toward_NaN");
    let (boundary, center) = (list(&fault["boundary"]), complex(xy(&fault["center"])));
    let map = solve(&faulty_region(&fault), 1e-8);
    for k in 0..400 {
        let aim = center + Complex64::from_polar(2.0, TAU * f64::from(k) / 400.0);
        let region = Region::new(&boundary, Curve::Polygon, center, aim).unwrap();
        let toward = region.toward().point;
        assert!(region.contains(toward), "{toward}");
        let map = map.with_center(center, aim, &mut |_, _| true).unwrap();
        let w = map.to_disk(&[toward])[0];
        // The image errs by the estimate, and so does the measure up to `toward`, by which the disk was turned.
        assert!((w - 1.0).norm() <= 2.0 * map.error_estimate(), "{toward} goes to {w}");
        assert!(!map.derivative(&[toward])[0].is_nan());
    }
}

#[test]
fn one_by_one_is_bit_for_bit_the_same_as_all_at_once() {
    let smooth: Vec<_> = (0..64).map(|k| TAU * f64::from(k) / 64.0).map(|t| c(2.0 * t.cos(), t.sin())).collect();
    let smooth = Region::new(&smooth, Curve::Smooth, Complex64::ZERO, smooth[0]).unwrap();
    for region in [case("sc_6_102").region(), case("rect10").region(), smooth] {
        let (fresh, other) = (solve(&region, 1e-4), solve(&region, 1e-4));
        let z = spread_points(&region, 11_000);
        let w = other.to_disk(&z);
        let back = other.from_disk(&w);
        for k in (0..z.len()).step_by(997).rev() {
            assert_eq!(fresh.from_disk(&[w[k]]), [back[k]], "{}", w[k]);
            assert_eq!(fresh.to_disk(&[z[k]]), [w[k]], "{}", z[k]);
        }
    }
}

/// Moved by a million times its size, a region has the same map.
#[test]
fn far_from_the_origin() {
    let fault = fault("fromDisk-far-from-origin");
    let boundary = list(&fault["boundary relative"]);
    let w: Vec<_> =
        (1..3000).map(|k| Complex64::from_polar(0.99 * (f64::from(k) / 3000.0).sqrt(), 2.4 * f64::from(k))).collect();
    let at = |offset: Complex64| {
        let boundary: Vec<_> = boundary.iter().map(|z| z + offset).collect();
        solve(&Region::new(&boundary, Curve::Polygon, c(35.0, 40.0) + offset, c(114.0, 30.0) + offset).unwrap(), 1e-10)
    };
    let (near, far) = (at(Complex64::ZERO), at(c(1e8, 1e8)));
    assert!((near.conformal_radius() - far.conformal_radius()).abs() < 1e-9);
    let moved = near.from_disk(&w).into_iter().zip(far.from_disk(&w));
    let error = largest(moved.map(|(a, b)| (a + c(1e8, 1e8) - b).norm()));
    assert!(error < 1e-7, "{error:e}");
    let error = largest(far.to_disk(&far.from_disk(&w)).iter().zip(&w).map(|(a, b)| (a - b).norm()));
    assert!(error < 1e-8, "{error:e}");
    let on: Vec<_> = far.region().boundary().to_vec();
    goes_both_ways("far", &far, &on);
}

#[test]
fn smooth_regions_far_from_the_origin() {
    let at = |offset: Complex64| {
        let curve = |t: f64| c(3.0 * t.cos(), t.sin() + 0.5 * (2.0 * t).cos()) + offset;
        let points: Vec<_> = (0..80).map(|k| curve(TAU * f64::from(k) / 80.0)).collect();
        solve(&Region::new(&points, Curve::Smooth, offset, points[0]).unwrap(), 1e-10)
    };
    let offset = c(-4e6, 2e6);
    let (near, far) = (at(Complex64::ZERO), at(offset));
    let z = spread_points(near.region(), 500);
    let moved: Vec<_> = z.iter().map(|z| z + offset).collect();
    let error = largest(near.to_disk(&z).iter().zip(far.to_disk(&moved)).map(|(a, b)| (a - b).norm()));
    assert!(error < 1e-8, "{error:e}");
    goes_both_ways("far smooth", &far, far.region().boundary());
}

/// The square seen from beside its lower wall, against the same square's map from its middle.
#[test]
fn centers_beside_a_wall() {
    let fault = fault("withCenter_loses_digits");
    let map = solve(&faulty_region(&fault), 1e-10);
    for case in fault["got"].as_array().unwrap() {
        let d = case["d"].as_f64().unwrap();
        if d < 1e-6 {
            continue;
        }
        let center = c(0.25, d);
        let near = map.with_center(center, c(1.0, 1.0), &mut |_, _| true).unwrap();
        let estimate = near.error_estimate();
        assert!(estimate <= 1e-9, "{d}: {estimate:e}");
        let radius = near.conformal_radius() / case["radius_fresh"].as_f64().unwrap() - 1.0;
        assert!(radius.abs() <= 10.0 * estimate, "{d}: {radius:e} {estimate:e}");
        // Both are maps of one region: they differ by the Möbius map that takes the image of the center to 0.
        let z = spread_points(map.region(), 200);
        let (w0, one) = (map.to_disk(&[center])[0], map.to_disk(&[c(1.0, 1.0)])[0]);
        let moebius = |w: Complex64| (w - w0) / (1.0 - w0.conj() * w);
        let turn = moebius(one) / moebius(one).norm();
        let error =
            largest(map.to_disk(&z).iter().zip(near.to_disk(&z)).map(|(w, found)| (moebius(*w) / turn - found).norm()));
        assert!(error <= 1e-8, "{d}: {error:e}");
    }
}

/// Fewer corners than the library's own tests have, all the same closed.
#[test]
fn vertices_go_to_the_circle_and_back() {
    let map = solve(&polygon(&[c(0.0, 0.0), c(3.0, 0.3), c(0.4, 2.0)], c(0.7, 0.6)), 1e-8);
    let w = map.to_disk(map.region().boundary());
    assert!(largest(w.iter().map(|w| (w.norm() - 1.0).abs())) < 1e-15);
    goes_both_ways("triangle", &map, map.region().boundary());
}
