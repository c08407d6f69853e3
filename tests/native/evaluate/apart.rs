//! Region → region where the regions are so far apart that nobody can tell which of their far ends belong together.

use crate::support::{c, case, fault, largest, solve, spread_points};
use conformal_warp::{Complex64, Curve, Error, JointTriangulation, MeshOptions, Region, RegionMap, RiemannMap};

/// A region, turned by a quarter: z → iz.
fn turned(region: &Region) -> Region {
    let turn = |z: Complex64| c(0.0, 1.0) * z;
    let vertices: Vec<_> = region.boundary().iter().map(|&z| turn(z)).collect();
    Region::new(&vertices, Curve::Polygon, turn(region.center()), turn(region.toward().point)).unwrap()
}

/// A corridor 60 times as long as wide, seen from its middle.
fn corridor(toward: Complex64) -> Region {
    let vertices = [c(0.0, 0.0), c(60.0, 0.0), c(60.0, 1.0), c(0.0, 1.0)];
    Region::new(&vertices, Curve::Polygon, c(30.0, 0.5), toward).unwrap()
}

/// A corridor that winds around its center, which sees `toward` half way along it.
fn spiral() -> Region {
    let value = fault("first_evaluation_takes_43s_1.8GB");
    let point = |value: &serde_json::Value| {
        let [x, y]: [f64; 2] = serde_json::from_value(value.clone()).unwrap();
        c(x, y)
    };
    let vertices: Vec<_> = value["boundary"].as_array().unwrap().iter().map(point).collect();
    Region::new(&vertices, Curve::Polygon, point(&value["center"]), point(&value["toward"])).unwrap()
}

fn is_apart<T: std::fmt::Debug>(answer: Result<T, Error>) -> bool {
    matches!(answer, Err(Error::TooFarApart { .. }))
}

/// How far z → iz is missed.
fn miss(map: &RegionMap, z: &[Complex64]) -> f64 {
    let there = map.try_forward(z).unwrap();
    let back = map.try_inverse(&there).unwrap();
    let there = there.iter().zip(z).map(|(w, z)| (w - c(0.0, 1.0) * z).norm());
    largest(there.chain(back.iter().zip(z).map(|(a, b)| (a - b).norm())))
}

/// Both ends lie in directions that only symmetry tells: `toward` in the middle of a side. What is near is right; of the ends
/// nobody knows.
#[test]
fn ends_that_lie_aside_from_toward_are_not_joined() {
    for toward in [c(30.0, 1.0), c(60.0, 0.5)] {
        let region = corridor(toward);
        let (from, to) = (solve(&region, 1e-8), solve(&turned(&region), 1e-8));
        let map = RegionMap::between(&from, &to);
        let near: Vec<_> = (0..40).map(|k| c(28.0 + 0.1 * f64::from(k), 0.3)).collect();
        assert!(miss(&map, &near) < 1e-5, "{:e}", miss(&map, &near));
        assert!(is_apart(map.try_forward(&[c(2.0, 0.5)])) && is_apart(map.try_inverse(&[c(-0.5, 2.0)])));
        assert!(map.forward(&[c(2.0, 0.5)])[0].is_nan() && map.derivative(&[c(2.0, 0.5)])[0].is_nan());
        assert!(is_apart(map.check()));
        let far = [c(58.0, 0.5), c(60.0, 0.2), c(50.0, 0.9)];
        if toward.re == 60.0 {
            assert!(miss(&map, &far) < 1e-5, "{:e}", miss(&map, &far));
        } else {
            assert!(is_apart(map.try_forward(&far[..1])));
        }
        assert!(is_apart(JointTriangulation::region_to_region(&from, &to, &MeshOptions::with_spacing(0.5))));
    }
}

/// One map, or a second solve of the same problem, is joined to itself up to its ends.
#[test]
fn one_region_is_joined_to_itself() {
    let region = corridor(c(30.0, 1.0));
    let (from, to) = (solve(&region, 1e-8), solve(&region, 1e-8));
    let z = spread_points(&region, 300);
    for to in [&from, &to] {
        let images = RegionMap::between(&from, to).try_forward(&z).unwrap();
        let worst = largest(images.iter().zip(&z).map(|(a, b)| (a - b).norm()));
        assert!(worst < 1e-6, "{worst:e}");
    }
}

/// Where ends meet walls that are near, everything is known.
#[test]
fn ends_that_meet_walls_are_told() {
    let [end, side] = [c(60.0, 0.5), c(30.0, 1.0)].map(|toward| solve(&corridor(toward), 1e-8));
    let map = RegionMap::between(&end, &side);
    map.check().unwrap();
    let images = map.try_forward(&spread_points(end.region(), 500)).unwrap();
    assert!(images.iter().all(|z| side.region().contains(*z)));
}

/// Two copies of a spiral were joined wrongly in silence.
#[test]
fn spirals_are_joined_as_far_as_they_are_known() {
    let region = spiral();
    let (from, to) = (solve(&region, 1e-8), solve(&turned(&region), 1e-8));
    let map = RegionMap::between(&from, &to);
    let z = spread_points(&region, 400);
    let (mut told, mut untold) = (0, 0);
    for z in z {
        match map.try_forward(&[z]) {
            Ok(images) => {
                told += 1;
                let away = (images[0] - c(0.0, 1.0) * z).norm();
                assert!(away < 0.01 * 14.0, "{z} is {away:e} off");
            }
            Err(error) => {
                untold += 1;
                assert_eq!(error, Error::TooFarApart { at: z });
            }
        }
    }
    assert!(told > 50 && untold > 50, "{told} told, {untold} not");
    assert!(is_apart(JointTriangulation::region_to_region(&from, &to, &MeshOptions::with_spacing(0.3))));
}

/// Pairs that never were in doubt.
#[test]
fn ordinary_pairs_are_told() {
    let solved: Vec<RiemannMap> =
        ["rect10", "neck", "slot", "spike", "sc_24_105"].iter().map(|name| solve(&case(name).region(), 1e-6)).collect();
    for from in &solved {
        for to in &solved {
            let map = RegionMap::between(from, to);
            map.check().unwrap();
            assert!(map.forward(&spread_points(from.region(), 200)).iter().all(|z| z.is_finite()));
        }
    }
}
