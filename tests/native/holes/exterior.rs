//! The outside of bodies: capacities against closed forms, and the map both ways.

use super::{curve, options, square};
use crate::support::points;
use conformal_warp::{Complex64, Conductors, Curve, Domain, Electrostatics, ExteriorMap, Stop};
use std::f64::consts::TAU;

fn exterior(body: &[Complex64], kind: Curve) -> ExteriorMap {
    let outside = Domain::exterior(&[body.to_vec()], kind).unwrap();
    ExteriorMap::solve(&outside, &options(1e-12), &mut |_, _| true).unwrap()
}

#[test]
fn capacities_of_regular_polygons() {
    let exact = [
        (3, 0.421_753_934_648_426_82),
        (4, 0.590_170_299_508_048_11),
        (5, 0.756_105_456_497_305_35),
        (6, 0.920_371_373_317_942_5),
        (8, 1.245_815_011_485_006_7),
    ];
    for (n, capacity) in exact {
        // Side 1.
        let radius = 0.5 / (TAU / 2.0 / f64::from(n)).sin();
        let body: Vec<Complex64> = (0..n)
            .map(|k| Complex64::new(3.0, -1.0) + Complex64::from_polar(radius, TAU * f64::from(k) / f64::from(n)))
            .collect();
        let map = exterior(&body, Curve::Polygon);
        let error = (map.capacity() - capacity).abs();
        println!("{n} sides: error {error:.1e}, estimate {:.1e}", map.error_estimate());
        assert!(error < 1e-12, "{n} sides: {error:e}");
        assert_eq!(map.stop(), Stop::Tolerance);
    }
}

#[test]
fn capacities_of_other_bodies() {
    let l = points(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]);
    assert!((exterior(&l, Curve::Polygon).capacity() - 1.084_890_390_444_8).abs() < 1e-12);
    let ellipse = curve(64, |t| Complex64::new(3.0 * t.cos(), t.sin()));
    assert!((exterior(&ellipse, Curve::Smooth).capacity() - 2.0).abs() < 1e-12);
    // Two unit squares one unit apart, which share a charge by halves.
    let at = |x: f64| square(0.5).iter().map(|z| z + x).collect::<Vec<_>>();
    let two = Domain::exterior(&[at(-1.0), at(1.0)], Curve::Polygon).unwrap();
    let given = Conductors::Potentials(vec![1.0, 0.0]);
    let field = Electrostatics::solve(&two, &given, &options(1e-12), &mut |_, _| true).unwrap();
    assert!((field.logarithmic_capacity().unwrap() - 1.131_755_061_555).abs() < 1e-12);
}

#[test]
fn an_ellipse_both_ways() {
    // f(z) = (z + √(z² − 8))/4 for semi-axes 3 and 1.
    let map = exterior(&curve(48, |t| Complex64::new(3.0 * t.cos(), t.sin())), Curve::Smooth);
    let exact = |w: Complex64| 2.0 * w + w.inv();
    let images: Vec<Complex64> = [1.0, 1.0 + 1e-7, 1.3, 4.0, 1e5]
        .into_iter()
        .flat_map(|r| (0..9).map(move |k| Complex64::from_polar(r, 0.3 + 0.7 * f64::from(k))))
        .collect();
    for ((w, z), image) in images
        .iter()
        .zip(map.from_exterior(&images))
        .zip(map.to_exterior(&images.iter().map(|w| exact(*w)).collect::<Vec<_>>()))
    {
        assert!((z - exact(*w)).norm() < 1e-10 * exact(*w).norm(), "{w}: {z} {}", exact(*w));
        assert!((image - w).norm() < 1e-11 * w.norm(), "{w}: {image}");
    }
    assert!(
        map.to_exterior(&[Complex64::ZERO])[0].is_nan() && map.from_exterior(&[Complex64::new(0.5, 0.0)])[0].is_nan()
    );
}

#[test]
fn a_polygon_both_ways() {
    let body = points(&[[0.0, 0.0], [3.0, 0.2], [3.0, 1.0], [1.0, 0.8], [1.0, 3.0], [0.0, 2.5]]);
    let map = exterior(&body, Curve::Polygon);
    let images: Vec<Complex64> = [1.0, 1.0 + 1e-6, 1.1, 2.0, 50.0]
        .into_iter()
        .flat_map(|r| (0..17).map(move |k| Complex64::from_polar(r, 0.1 + 0.4 * f64::from(k))))
        .collect();
    let places = map.from_exterior(&images);
    for ((w, z), back) in images.iter().zip(&places).zip(map.to_exterior(&places)) {
        assert!((back - w).norm() < 1e-9 * w.norm(), "{w} → {z} → {back}");
    }
    let far = map.to_exterior(&[Complex64::new(1e8, 0.0)])[0];
    assert!((far * map.capacity() / 1e8 - 1.0).norm() < 1e-6, "directions far away are kept: {far}");
}

/// SC Toolbox, tests/testExterior.m: it maps the disk, and turns it.
#[test]
fn toolbox_exterior() {
    let map = exterior(
        &points(&[[4.0, 0.0], [0.0, 2.0], [-2.0, 4.0], [-3.0, 0.0], [-3.0, -1.0], [2.0, -2.0]]),
        Curve::Polygon,
    );
    let half = 0.5f64.sqrt();
    let pairs = [
        ((0.5, 0.5), (3.383_320_944_105_799, -2.338_017_988_574_543)),
        ((-0.9, 0.0), (-3.257_095_120_413_423, 0.536_117_032_603_197)),
        ((-0.8, 0.3), (-3.428_512_520_416_633, -0.641_446_812_228_358)),
        ((half, half), (2.571_844_815_094_428, -1.428_155_184_905_573)),
    ];
    let turns: Vec<Complex64> = pairs
        .iter()
        .map(|&((u, v), (x, y))| {
            // The last lies on the boundary up to 1e-10.
            let z = Complex64::new(x, y) * (1.0 + 1e-11);
            map.to_exterior(&[z])[0] * Complex64::new(u, v)
        })
        .collect();
    for turn in &turns {
        assert!((turn - turns[0]).norm() < 1e-9 && (turn.norm() - 1.0).abs() < 1e-9, "{turns:?}");
    }
}
