//! Smooth regions against the exact map of the ellipse and against an independent method.

use crate::support::{angle_error, exact, fault, kerzman_stein, largest, points, solve};
use conformal_warp::{Complex64, Curve, Error, Region, RiemannMap, SolveOptions, Stop};
use std::f64::consts::TAU;

fn region(n: usize, center: Complex64, at: impl Fn(f64) -> Complex64) -> Region {
    let points: Vec<_> = (0..n).map(|j| at(TAU * j as f64 / n as f64)).collect();
    Region::new(&points, Curve::Smooth, center, points[0]).unwrap()
}

#[test]
fn ellipses_to_twelve_digits() {
    for (a, b, n) in [(2.0, 1.0, 100), (5.0, 1.0, 300)] {
        let outline = |t: f64| Complex64::new(a * t.cos(), b * t.sin());
        let map = solve(&region(n, Complex64::ZERO, outline), 1e-12);
        assert_eq!(map.stop(), Stop::Tolerance);
        let angles = (0..n).map(|j| exact::ellipse(a, b, outline(TAU * j as f64 / n as f64)).0.arg());
        let vertices = largest(map.angles().iter().zip(angles).map(|(x, y)| angle_error(*x, y)));
        assert!(vertices < 1e-12 && vertices <= map.error_estimate(), "{a}:{b} vertices {vertices:e}");
        let inside: Vec<_> = [(0.1, 0.3), (0.6, 2.0), (0.95, 4.0), (0.999, 0.1), (0.999_999_9, 1.6)]
            .map(|(share, t)| outline(t) * share)
            .to_vec();
        let error =
            largest(map.to_disk(&inside).iter().zip(&inside).map(|(w, z)| (w - exact::ellipse(a, b, *z).0).norm()));
        assert!(error < 1e-12, "{a}:{b} inside {error:e}");
        let radius = map.conformal_radius() / exact::ellipse_conformal_radius(a, b) - 1.0;
        assert!(radius.abs() < 1e-12, "{a}:{b} radius {radius:e}");
    }
}

/// Kerzman & Stein's integral equation of the second kind is as unlike Symm's as can be.
#[test]
fn agrees_with_kerzman_and_stein() {
    let blob = |t: f64| Complex64::from_polar(1.0 + 0.25 * (3.0 * t).cos() + 0.1 * (2.0 * t + 0.5).sin(), t);
    let center = Complex64::new(0.2, -0.1);
    let n = 200;
    let map = solve(&region(n, center, blob), 1e-11);
    let values = kerzman_stein::boundary_values(n, center, blob);
    let turn = values[0];
    let error = largest(map.angles().iter().zip(&values).map(|(angle, w)| angle_error(*angle, (w / turn).arg())));
    assert!(error < 1e-10, "{error:e}");
}

#[test]
fn a_smooth_region_knows_its_edge() {
    let region = region(64, Complex64::ZERO, |t| Complex64::new(2.0 * t.cos(), t.sin()));
    let map = solve(&region, 1e-10);
    let t: f64 = 1.03;
    let (on, out, inside) = (Complex64::new(2.0 * t.cos(), t.sin()), 1.000_001, 0.999_999);
    assert!(region.contains(on * inside) && !region.contains(on * out));
    let w = map.to_disk(&[on * inside, on * out]);
    assert!((w[0].norm() - 1.0).abs() < 1e-5 && w[1].is_nan());
    let angle = map.boundary_angle(region.nearest(on));
    let back = map.boundary_point(angle);
    assert!((back.point - on).norm() < 1e-12, "{} {on}", back.point);
    let moved = map.with_center(Complex64::new(0.5, 0.1), on, &mut |_, _| true).unwrap();
    assert!(angle_error(moved.boundary_angle(region.nearest(on)), 0.0) < 1e-13);
    assert!(moved.to_disk(&[Complex64::new(0.5, 0.1)])[0].norm() < 1e-10);
}

/// What the points leave open is part of the estimate, and said where it is all that is missing.
#[test]
fn points_that_leave_a_curve_open_are_in_the_estimate() {
    let fault = fault("smooth_curve_underresolved_in_silence");
    let boundary = points(&serde_json::from_value::<Vec<[f64; 2]>>(fault["boundary"].clone()).unwrap());
    let map = solve(&Region::new(&boundary, Curve::Smooth, Complex64::ZERO, boundary[0]).unwrap(), 1e-8);
    // The file says what the angles are of the whole circle: those of its points, seen from its center's image.
    let error = fault["got"]["largestAngleError"].as_f64().unwrap();
    assert!(map.error_estimate() >= error, "{:e} for {error:e}", map.error_estimate());
    assert!(map.error_estimate() <= 300.0 * error && map.stop() == Stop::TooFewPoints, "{:e}", map.error_estimate());
    // Inverted ellipses: z = 2pw/((1+p) − (1−p)w²).
    for (p, n) in [(0.2, 128), (0.3, 128), (0.4, 100)] {
        let outline = |t: f64| {
            let w = Complex64::cis(t);
            2.0 * p * w / ((1.0 + p) - (1.0 - p) * w * w)
        };
        let map = solve(&region(n, Complex64::ZERO, outline), 1e-8);
        let radius = (map.conformal_radius() - 2.0 * p / (1.0 + p)).abs();
        assert!(radius <= map.error_estimate(), "{p}: {radius:e} {:e}", map.error_estimate());
    }
    // Of a square, eight points: no estimate that anybody would take for an answer.
    let square = [(1.0, 1.0), (0.0, 1.0), (-1.0, 1.0), (-1.0, 0.0), (-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (1.0, 0.0)];
    let square: Vec<_> = square.iter().map(|&(x, y)| Complex64::new(x, y)).collect();
    match RiemannMap::solve(
        &Region::new(&square, Curve::Smooth, Complex64::ZERO, square[0]).unwrap(),
        &SolveOptions::default(),
        &mut |_, _| true,
    ) {
        Ok(map) => assert!(map.error_estimate() > 0.01 && map.stop() == Stop::TooFewPoints),
        Err(error) => assert_eq!(error.code(), "too-few-points"),
    }
}

/// The points that a curve needs decide, not those that it has.
#[test]
fn sixteen_thousand_points() {
    let outline = |t: f64| Complex64::new(t.cos() + 0.1 * (3.0 * t).cos(), t.sin() + 0.1 * (3.0 * t).sin());
    let map = solve(&region(16_000, Complex64::ZERO, outline), 1e-8);
    assert!((map.conformal_radius() - 1.0).abs() < map.error_estimate(), "{}", map.conformal_radius());
    assert!(map.unknowns() < 1000 && map.stop() == Stop::Tolerance, "{} {:?}", map.unknowns(), map.stop());
    let w = map.to_disk(map.region().boundary());
    assert!(largest(w.iter().map(|w| (w.norm() - 1.0).abs())) < 1e-14);
}

/// z = 2pw/((1+p) − (1−p)w²) has a waist that its points leave open, and does not cross itself.
#[test]
fn how_many_points_a_curve_needs_is_said() {
    let p = 0.05;
    let outline = |t: f64| {
        let w = Complex64::cis(t);
        2.0 * p * w / ((1.0 + p) - (1.0 - p) * w * w)
    };
    let points: Vec<_> = (0..64).map(|j| outline(TAU * f64::from(j) / 64.0)).collect();
    let refused = Region::new(&points, Curve::Smooth, Complex64::ZERO, points[0])
        .and_then(|region| RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true))
        .unwrap_err();
    let Error::TooFewPoints { given: 64, needed } = refused else { panic!("{refused}") };
    let map = solve(&region(2 * needed, Complex64::ZERO, outline), 1e-3);
    assert!(map.error_estimate() < 0.1, "{needed}: {:e}", map.error_estimate());
}

#[test]
fn refusals() {
    let eight: Vec<_> =
        (0..40).map(|j| TAU * f64::from(j) / 40.0).map(|t| Complex64::new(t.sin(), (2.0 * t).sin())).collect();
    let error = Region::new(&eight, Curve::Smooth, Complex64::new(0.5, 0.1), eight[0]).unwrap_err();
    assert_eq!(error.code(), "self-intersecting");
    let circle: Vec<_> = (0..16).map(|j| Complex64::cis(TAU * f64::from(j) / 16.0)).collect();
    let beyond_polygon = Complex64::from_polar(0.99, TAU / 32.0);
    assert!(Region::new(&circle, Curve::Smooth, beyond_polygon, circle[0]).is_ok());
    let outside = Region::new(&circle, Curve::Smooth, Complex64::new(1.001, 0.0), circle[0]).unwrap_err();
    assert_eq!(outside.code(), "center-outside");
}
