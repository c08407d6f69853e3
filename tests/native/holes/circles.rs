//! Disks with round holes.

use super::{curve, options, square};
use crate::support::random::Random;
use conformal_warp::{Circle, CircleMap, Complex64, Curve, Domain, Error, SlitKind, SlitMap, Stop};
use std::f64::consts::TAU;

const HOLES: [(f64, f64, f64); 2] = [(-0.2517, 0.3129, 0.2377), (0.2307, -0.4667, 0.1557)];

fn at(x: f64, y: f64) -> Complex64 {
    Complex64::new(x, y)
}

/// The unit disk with round holes, pushed forward; 1 goes to where 1 goes.
fn pushed(f: impl Fn(Complex64) -> Complex64, center: Complex64) -> Domain {
    pushed_with(&HOLES, 64, f, center)
}

fn pushed_with(
    holes: &[(f64, f64, f64)],
    count: usize,
    f: impl Fn(Complex64) -> Complex64,
    center: Complex64,
) -> Domain {
    let circle = |center: Complex64, radius: f64| curve(count, |t| f(center + Complex64::from_polar(radius, t)));
    let holes: Vec<_> = holes.iter().map(|&(x, y, radius)| circle(at(x, y), radius)).collect();
    let domain = Domain::new(&circle(at(0.0, 0.0), 1.0), &holes, Curve::Smooth).unwrap();
    domain.with_center(f(center)).unwrap().with_toward(f(Complex64::ONE)).unwrap()
}

fn solve(domain: &Domain, tolerance: f64) -> CircleMap {
    CircleMap::solve(domain, &options(tolerance), &mut |_, _| true).unwrap()
}

/// Points of the unit disk outside the holes, and on all circles.
fn points(holes: &[(f64, f64, f64)]) -> Vec<Complex64> {
    let outside = |z: &Complex64| z.norm() < 1.0 && holes.iter().all(|&(x, y, radius)| (z - at(x, y)).norm() > radius);
    let grid = (0..100).map(|k| at(f64::from(k % 10) * 0.21 - 0.94, f64::from(k / 10) * 0.21 - 0.93)).filter(outside);
    let circles = holes.iter().copied().chain([(0.0, 0.0, 1.0)]);
    grid.chain(circles.flat_map(|(x, y, radius)| curve(7, |t| at(x, y) + Complex64::from_polar(radius, t + 0.1))))
        .collect()
}

/// The image of a circle under a Möbius map that takes the disk to itself.
fn image(f: impl Fn(Complex64) -> Complex64, (x, y, radius): (f64, f64, f64)) -> Circle {
    let [a, b, c] = [0.0, 2.0, 4.0].map(|t| f(at(x, y) + Complex64::from_polar(radius, t)));
    let (b, c) = (b - a, c - a);
    let center = (b * c * (b.conj() - c.conj())) / (b.conj() * c - b * c.conj());
    Circle { center: a + center, radius: center.norm() }
}

fn is_exact(
    map: &CircleMap,
    domain_of: impl Fn(Complex64) -> Complex64,
    disk_of: impl Fn(Complex64) -> Complex64 + Copy,
) {
    is_exact_with(&HOLES, map, domain_of, disk_of);
}

fn is_exact_with(
    holes: &[(f64, f64, f64)],
    map: &CircleMap,
    domain_of: impl Fn(Complex64) -> Complex64,
    disk_of: impl Fn(Complex64) -> Complex64 + Copy,
) {
    let bound = map.error_estimate();
    for (found, &hole) in map.circles().iter().zip(holes) {
        let exact = image(disk_of, hole);
        assert!((found.center - exact.center).norm() < bound && (found.radius - exact.radius).abs() < bound);
    }
    let points = points(holes);
    let places: Vec<Complex64> = points.iter().map(|&z| domain_of(z)).collect();
    let images = map.to_circles(&places);
    for (z, w) in points.iter().zip(&images) {
        let error = (w - disk_of(*z)).norm();
        assert!(error < bound, "{z} → {w}, error {error:e}, estimate {bound:e}");
    }
    for (z, back) in places.iter().zip(map.from_circles(&images)) {
        assert!((z - back).norm() < 3.0 * bound, "{z} ← {back}, estimate {bound:e}");
    }
}

#[test]
fn disks_with_round_holes_are_their_own_images() {
    for tolerance in [1e-4, 1e-9] {
        let map = solve(&pushed(|z| z, at(0.0, 0.0)), tolerance);
        assert!(map.stop() == Stop::Tolerance && map.error_estimate() <= tolerance);
        is_exact(&map, |z| z, |z| z);
        let outside = [at(1.1, 0.0), at(-0.25, 0.3), at(f64::NAN, 0.0)];
        assert!(map.to_circles(&outside).iter().chain(&map.from_circles(&outside)).all(|w| w.re.is_nan()));
        assert_eq!(map.to_circles(&[at(0.0, 0.0)]), [at(0.0, 0.0)]);
    }
}

#[test]
fn another_center_is_a_moebius_map() {
    let center = at(0.3, 0.2);
    let moebius = |z: Complex64| (z - center) / (1.0 - center.conj() * z);
    let turn = moebius(Complex64::ONE).conj();
    is_exact(&solve(&pushed(|z| z, center), 1e-8), |z| z, |z| turn * moebius(z));
}

#[test]
fn conformal_images_have_the_same_circles() {
    let polynomial = |z: Complex64| z + 0.1 * z * z + at(0.0, 0.08) * z * z * z;
    let map = solve(&pushed(polynomial, at(0.0, 0.0)), 1e-8);
    is_exact(&map, polynomial, |z| z);
    let (z, h) = (at(0.4, 0.3), 1e-5);
    let slope = (map.to_circles(&[z + h])[0] - map.to_circles(&[z - h])[0]) / (2.0 * h);
    assert!((slope - map.derivative(&[z])[0]).norm() < 1e-8);
}

/// Round holes in the unit disk, apart from each other and from its circle by more than a share of their radii.
fn random_holes(random: &mut Random) -> Vec<(f64, f64, f64)> {
    let mut holes: Vec<(f64, f64, f64)> = Vec::new();
    for _ in 0..1 + random.below(8) {
        let (center, radius) = (Complex64::from_polar(random.unit(), TAU * random.unit()), 0.03 + 0.3 * random.unit());
        let away = |x: f64, y: f64| (center - at(x, y)).norm();
        let clear = holes.iter().all(|&(x, y, r)| away(x, y) - r - radius > 0.3 * r.min(radius));
        if 1.0 - center.norm() - radius > 0.3 * radius && away(0.0, 0.0) > radius + 0.1 && clear {
            holes.push((center.re, center.im, radius));
        }
    }
    holes
}

#[test]
fn random_images_have_their_circles_within_the_estimate() {
    let mut random = Random::new(15);
    for case in 0..36 {
        let holes = random_holes(&mut random);
        let [a, b] = [0.15, 0.08].map(|size| Complex64::from_polar(size * random.unit(), TAU * random.unit()));
        let polynomial = |z: Complex64| z + a * z * z + b * z * z * z;
        let center = Complex64::from_polar(0.1 * random.unit(), TAU * random.unit());
        let moebius = |z: Complex64| (z - center) / (1.0 - center.conj() * z);
        let turn = moebius(Complex64::ONE).conj();
        let domain = pushed_with(&holes, 96, polynomial, center);
        let tolerance = [1e-4, 1e-7, 1e-10][case % 3];
        let map = solve(&domain, tolerance);
        assert!(
            map.error_estimate() <= tolerance || map.stop() == Stop::TooFewPoints,
            "{case}: {:e}",
            map.error_estimate()
        );
        is_exact_with(&holes, &map, polynomial, |z| turn * moebius(z));
    }
}

#[test]
fn a_frame_has_the_modulus_of_its_ring() {
    let frame = Domain::new(&square(1.0), &[square(0.5)], Curve::Polygon).unwrap().with_center(at(0.75, 0.0)).unwrap();
    let map = solve(&frame, 1e-9);
    let Circle { center, radius } = map.circles()[0];
    let inner = (-((1.0 + radius * radius - center.norm_sqr()) / (2.0 * radius)).acosh()).exp();
    assert!((inner - 0.541_210_760_957_991).abs() < 1e-9, "{inner}");
    for (component, vertices) in frame.holes().iter().enumerate() {
        for w in map.to_circles(vertices) {
            let circle = map.circles()[component];
            assert!(((w - circle.center).norm() - circle.radius).abs() < 1e-12, "{w}");
        }
    }
}

#[test]
fn polygons_agree_with_the_slit_map_of_their_disk() {
    let boundary = [(-3.0, -2.0), (3.0, -2.0), (3.0, 2.0), (-3.0, 2.0)].map(|(x, y)| at(x, y));
    let hole = |x: f64| square(0.5).iter().map(|z| z + x).collect::<Vec<_>>();
    let windows = Domain::new(&boundary, &[hole(-1.5), hole(1.5)], Curve::Polygon).unwrap();
    let windows = windows.with_center(at(0.1, 0.2)).unwrap();
    let map = solve(&windows, 1e-9);
    let holes: Vec<_> =
        map.circles().iter().map(|c| curve(16, |t| c.center + Complex64::from_polar(c.radius, t))).collect();
    let disk = Domain::new(&curve(16, Complex64::cis), &holes, Curve::Smooth).unwrap();
    let disk = disk.with_center(at(0.0, 0.0)).unwrap().with_toward(Complex64::ONE).unwrap();
    let [of_windows, of_disk] = [&windows, &disk]
        .map(|domain| SlitMap::solve(domain, SlitKind::Disk, &options(1e-11), &mut |_, _| true).unwrap());
    let z = [at(0.0, 1.2), at(-2.5, 0.3), at(0.4, -1.7)];
    for (direct, by_circles) in of_windows.to_slits(&z).iter().zip(of_disk.to_slits(&map.to_circles(&z))) {
        assert!((direct - by_circles).norm() < 1e-8, "{direct} {by_circles}");
    }
}

#[test]
fn without_holes_it_is_the_disk_map() {
    let region = Domain::new(&square(1.0), &[], Curve::Polygon).unwrap().with_center(at(0.0, 0.0)).unwrap();
    let map = solve(&region, 1e-9);
    let radius = 1.078_705_202_376_758_7;
    assert!((map.derivative(&[at(0.0, 0.0)])[0].norm() - 1.0 / radius).abs() < 1e-9 && map.circles().is_empty());
}

#[test]
fn what_it_needs_is_said_and_it_can_be_cancelled() {
    let solve = |domain: &Domain| CircleMap::solve(domain, &options(1e-6), &mut |_, _| true).unwrap_err();
    let frame = Domain::new(&square(1.0), &[square(0.5)], Curve::Polygon).unwrap();
    assert_eq!(solve(&frame).to_string(), "A circle map needs a center; this region has none.");
    assert_eq!(solve(&Domain::exterior(&[square(1.0)], Curve::Polygon).unwrap()).code(), "wrong-region");
    let frame = frame.with_center(at(0.75, 0.0)).unwrap();
    for stage in ["circles", ""] {
        let cancelled = CircleMap::solve(&frame, &options(1e-6), &mut |now, _| !(now == stage || stage.is_empty()));
        assert!(matches!(cancelled, Err(Error::Cancelled)));
    }
}
