//! The map as a function: both ways against exact answers, each other and direct summation.

use crate::support::{EXACT_CASES, c, case, largest, points, polygon, share, solve, spread_points};
use conformal_warp::{Complex64, Region, RegionMap, RiemannMap};

fn square() -> Region {
    polygon(&[c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)], c(0.0, 0.0))
}

fn l_shape() -> Region {
    polygon(&[c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)], c(0.5, 0.5))
}

/// `count` points all over the region, and a tenth as many at distances from 1e-9 of its size to the wall.
fn interior_points(region: &Region, count: usize) -> Vec<Complex64> {
    let polygon = region.polygon();
    let mut found = spread_points(region, count);
    for k in 1..=count / 10 {
        let (a, b) = polygon.edge(k % polygon.len());
        let away = polygon.size() * 10f64.powf(-9.0 + 6.0 * share(k, 0.324_717_957));
        let z = a + (b - a) * share(k, 0.569_840_290_998) + c(0.0, away) * (b - a) / (b - a).norm();
        if polygon.contains_strictly(z) {
            found.push(z);
        }
    }
    found
}

/// Largest |fromDisk(toDisk(z)) − z| relative to the region's size.
fn round_trip(map: &RiemannMap, z: &[Complex64]) -> f64 {
    let back = map.from_disk(&map.to_disk(z));
    largest(back.iter().zip(z).map(|(a, b)| (a - b).norm())) / map.region().polygon().size()
}

/// The same through points that know their chart.
fn trip(map: &RiemannMap, z: &[Complex64]) -> f64 {
    let back = map.from_disk_points(&map.to_disk_points(z));
    largest(back.iter().zip(z).map(|(a, b)| (a - b).norm())) / map.region().polygon().size()
}

#[test]
fn round_trips_close_everywhere() {
    let mut regions: Vec<(&str, Region)> = EXACT_CASES.iter().map(|name| (*name, case(name).region())).collect();
    regions.extend([("square", square()), ("L", l_shape()), ("blob100", case("blob100").region())]);
    for (name, region) in regions {
        let map = solve(&region, 1e-8);
        let error = round_trip(&map, &interior_points(&region, 100_000));
        assert!(error <= 1e-8, "{name}: {error:e}");
    }
}

/// A neck ten times as long as wide, and a rectangle twenty times as long: seen from the center, what lies at the far ends
/// has harmonic measure 1e-14 and less.
#[test]
fn round_trips_close_at_the_far_ends_of_long_regions() {
    for name in ["neck", "rect20"] {
        let region = case(name).region();
        let map = solve(&region, 1e-10);
        let z = interior_points(&region, 100_000);
        let error = trip(&map, &z);
        assert!(map.charts() > 1 && error <= 1e-8, "{name}, {} charts: {error:e}", map.charts());
        assert!(map.to_disk(&z).iter().all(|w| w.norm() <= 1.0 + 1e-15));
    }
}

/// An evaluator is as coarse as the solve: where charts and patches differ by the solve's error, no square is split in vain.
#[test]
fn loose_solves_have_small_evaluators_that_go_both_ways() {
    for (name, tolerance) in [("slot", 1e-3), ("neck", 1e-3), ("rect20", 1e-3), ("blob100", 1e-2)] {
        let region = case(name).region();
        let map = solve(&region, tolerance);
        map.prepare(&mut |_, _| true).unwrap();
        let megabytes = map.evaluator_bytes() as f64 / 1e6;
        assert!(megabytes < 2.5, "{name}: {megabytes} MB");
        // A chart is used where |f'| × size is at least 1/20: that is how much an error in the disk may grow.
        let error = trip(&map, &interior_points(&region, 20_000));
        assert!(error <= 20.0 * map.error_estimate(), "{name}: {error:e}, estimate {:e}", map.error_estimate());
    }
}

#[test]
fn interior_pairs_are_exact_both_ways() {
    for name in EXACT_CASES {
        let case = case(name);
        let map = solve(&case.region(), 1e-10);
        map.prepare(&mut |_, _| true).unwrap();
        let (z, w) = (points(&case.interior_z), points(&case.interior_w));
        let forward = largest(map.to_disk(&z).iter().zip(&w).map(|(a, b)| (a - b).norm()));
        let inverse = largest(map.from_disk(&w).iter().zip(&z).map(|(a, b)| (a - b).norm()));
        assert!(forward < 1e-9 && inverse < 1e-9, "{name}: {forward:e} forward, {inverse:e} back");
    }
}

#[test]
fn agrees_with_direct_summation() {
    for name in ["sc_9_103", "blob100"] {
        let region = case(name).region();
        let map = solve(&region, 1e-8);
        let z = interior_points(&region, 1000);
        let error = largest(map.to_disk(&z).iter().zip(map.to_disk_directly(&z)).map(|(a, b)| (a - b).norm()));
        assert!(error <= map.error_estimate(), "{name}: {error:e}");
    }
}

#[test]
fn outside_is_nan_and_the_boundary_goes_to_the_boundary() {
    let region = case("sc_15_104").region();
    let map = solve(&region, 1e-8);
    map.prepare(&mut |_, _| true).unwrap();
    let polygon = region.polygon();
    let size = polygon.size();
    for k in 0..polygon.len() {
        let (a, b) = polygon.edge(k);
        for t in [0.0, 1e-6, 0.3, 0.5, 0.999] {
            let on = a + (b - a) * t;
            let w = map.to_disk(&[on])[0];
            assert!((w.norm() - 1.0).abs() < 1e-14, "edge {k} at {t}: |w| − 1 = {:e}", w.norm() - 1.0);
            let back = map.from_disk(&[w])[0];
            let off = (polygon.nearest(back).point - back).norm();
            // Towards a vertex f' goes to 0, and rounding of w moves z by ε/|f'|.
            let rounding = 1e-14 / map.derivative(&[on])[0].norm();
            let error = (back - on).norm();
            assert!(off < 1e-14 * size, "edge {k} at {t}: {back} is {off:e} off the boundary");
            assert!(t == 0.0 || error < 1e-8 * size + rounding, "edge {k} at {t}: {back} is not {on}");
        }
        let outside = 0.5 * (a + b) - c(0.0, 1e-9 * size) * (b - a) / (b - a).norm();
        assert!(map.to_disk(&[outside])[0].is_nan() && map.derivative(&[outside])[0].is_nan(), "edge {k}");
    }
    let far = [c(1e3, 0.0), c(f64::NAN, 0.0), c(0.0, f64::INFINITY)];
    assert!(map.to_disk(&far).iter().chain(&map.from_disk(&far)).all(|w| w.is_nan()));
    assert!(map.from_disk(&[c(1.0 + 1e-9, 0.0)])[0].is_nan());
}

#[test]
fn derivatives_agree_with_central_differences() {
    for region in EXACT_CASES.map(|name| case(name).region()).into_iter().chain([l_shape(), case("blob100").region()]) {
        let map = solve(&region, 1e-10);
        let h = 1e-4 * region.polygon().size();
        let z: Vec<Complex64> = interior_points(&region, 500)
            .into_iter()
            .filter(|&z| (region.polygon().nearest(z).point - z).norm() > 20.0 * h)
            .collect();
        let at = |shift: f64| map.to_disk(&z.iter().map(|z| z + shift).collect::<Vec<_>>());
        let (far, near) = ([at(2.0 * h), at(-2.0 * h)], [at(h), at(-h)]);
        for (k, slope) in map.derivative(&z).iter().enumerate() {
            // Richardson's extrapolation, of fourth order.
            let (wide, narrow) = (far[0][k] - far[1][k], near[0][k] - near[1][k]);
            let difference = (8.0 * narrow - wide) / (12.0 * h);
            assert!((slope - difference).norm() < 1e-4 * slope.norm().max(1.0), "at {}: {slope} {difference}", z[k]);
        }
    }
}

/// The images of a fine grid's cells keep their orientation: no sign change of the Jacobian, no fold.
fn assert_injective(name: &str, map: &RiemannMap, within: f64) {
    let region = map.region();
    let (low, high) = region.polygon().bounds();
    let n = 300;
    let step = (high - low) / f64::from(n);
    let place = |i: f64, j: f64| low + c(step.re * i, step.im * j);
    let grid: Vec<Complex64> = (0..=n).flat_map(|j| (0..=n).map(move |i| place(f64::from(i), f64::from(j)))).collect();
    let w = map.to_disk(&grid);
    let at = |i: i32, j: i32| w[(j * (n + 1) + i) as usize];
    let clear = |i: i32, j: i32| {
        let middle = place(f64::from(i) + 0.5, f64::from(j) + 0.5);
        (middle - region.center()).norm() < within
            && region.contains(middle)
            && (region.polygon().nearest(middle).point - middle).norm() > 0.51 * step.norm()
    };
    let cells: Vec<_> = (0..n).flat_map(|j| (0..n).map(move |i| (i, j))).filter(|&(i, j)| clear(i, j)).collect();
    assert!(cells.len() > 300, "{name}: {} cells", cells.len());
    for (i, j) in cells {
        let [a, b, d, e] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        for (a, b, d) in [(a, b, d), (e, d, b)] {
            assert!(((b - a).conj() * (d - a)).im > 0.0, "{name}, cell {i}, {j}: {a} {b} {d}");
        }
    }
}

#[test]
fn orientation_is_kept_everywhere() {
    let mut regions: Vec<(&str, Region)> = EXACT_CASES.iter().map(|name| (*name, case(name).region())).collect();
    regions.extend([("square", square()), ("L", l_shape()), ("blob100", case("blob100").region())]);
    for (name, region) in regions {
        assert_injective(name, &solve(&region, 1e-8), f64::INFINITY);
    }
    // Of long regions every part, seen from a center near it: one circle cannot show them whole.
    for (name, centers) in [("neck", [-1.5, 0.0, 1.5]), ("rect20", [-17.0, 0.0, 17.0])] {
        let map = solve(&case(name).region(), 1e-10);
        for x in centers {
            let near = map.with_center(c(x, 0.0), map.region().toward().point, &mut |_, _| true).unwrap();
            let within = match (name, x) {
                ("neck", 0.0) => 0.4,
                ("neck", _) => 1.3,
                _ => 3.5,
            };
            assert_injective(name, &near, within);
        }
    }
}

#[test]
fn between_regions_center_and_toward_correspond() {
    let a = solve(&l_shape(), 1e-9);
    let b = solve(&case("sc_6_102").region(), 1e-9);
    let map = RegionMap::between(&a, &b);
    let [from, to] = [a.region(), b.region()];
    let images = map.forward(&[from.center(), from.toward().point]);
    assert!((images[0] - to.center()).norm() < 1e-8 && (images[1] - to.toward().point).norm() < 1e-7, "{images:?}");
    let z: Vec<_> = interior_points(from, 2000).into_iter().take(2000).collect();
    let there = map.forward(&z);
    let back = map.inverse(&there);
    assert!(largest(back.iter().zip(&z).map(|(a, b)| (a - b).norm())) < 1e-6);
    // f' of the composition by the chain rule.
    let slopes = map.derivative(&z[..50]);
    let (outer, inner) = (b.derivative(&there[..50]), a.derivative(&z[..50]));
    for (slope, (outer, inner)) in slopes.iter().zip(outer.iter().zip(&inner)) {
        assert!((slope * outer / inner - 1.0).norm() < 1e-6, "{slope} {outer} {inner}");
    }
}
