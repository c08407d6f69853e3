//! Maps onto disks with round holes.

use super::{curve, options, square};
use crate::support::{c, largest, points};
use conformal_warp::{
    AnnulusMap, Circle, CircleMap, Complex64, Curve, Domain, Error, Moebius, SlitKind, SlitMap, Stop,
};

fn circle(center: Complex64, radius: f64) -> Vec<Complex64> {
    curve(32, |t| center + Complex64::from_polar(radius, t))
}

fn solve(domain: &Domain) -> CircleMap {
    CircleMap::solve(domain, &options(1e-12), &mut |_, _| true).unwrap()
}

/// The unit circle around round holes.
fn round(circles: &[Circle]) -> Domain {
    let holes: Vec<_> = circles.iter().map(|circle| self::circle(circle.center, circle.radius)).collect();
    let domain = Domain::new(&circle(Complex64::ZERO, 1.0), &holes, Curve::Smooth).unwrap();
    domain.with_center(Complex64::ZERO).unwrap().with_toward(Complex64::ONE).unwrap()
}

/// The holes of SKPrime's example.
const HOLES: [Circle; 2] = [
    Circle { center: Complex64::new(-0.2517, 0.3129), radius: 0.2377 },
    Circle { center: Complex64::new(0.2307, -0.4667), radius: 0.1557 },
];

/// Points inside, beside walls and on them.
fn places(domain: &Domain) -> Vec<Complex64> {
    let (low, high) = (c(-3.0, -3.0), c(3.0, 3.0));
    let grid = (0..300).map(|k| {
        let at = |k: u32| (f64::from(k) + 0.37) / 17.5;
        low + c((high.re - low.re) * at(k % 17), (high.im - low.im) * at(k / 17))
    });
    let mut places: Vec<Complex64> = grid.filter(|z| domain.contains(*z)).collect();
    let contours = domain.boundary().into_iter().chain(domain.holes());
    for contour in contours {
        for k in 0..contour.len() {
            let (a, b) = (contour[k], contour[(k + 1) % contour.len()]);
            if domain.curve() == Curve::Polygon {
                places.extend([0.0, 0.02, 0.31].map(|t| a + (b - a) * t));
            } else {
                places.push(a);
            }
            let across = (b - a) * Complex64::I;
            for away in [1e-13, 1e-10, 1e-6, 1e-3, -1e-13, -1e-10, -1e-6, -1e-3] {
                let z = a + (b - a) * 0.4 + across * away;
                // Chords of smooth curves lie beside them.
                if domain.curve() == Curve::Polygon && domain.contains(z) {
                    places.push(z);
                }
            }
        }
    }
    places
}

/// How far places are from where they came back to, those beside outer corners, where the way back is conditioned like √ε, apart.
fn returned(domain: &Domain, places: &[Complex64], back: &[Complex64]) -> [f64; 2] {
    let corners = domain.boundary().unwrap();
    let beside = |z: &Complex64| corners.iter().any(|corner| (corner - z).norm() < 0.05);
    [false, true].map(|wanted| {
        let off = places.iter().zip(back).filter(|(z, _)| beside(z) == wanted).map(|(z, back)| (z - back).norm());
        largest(off.chain([0.0]))
    })
}

fn distance(a: &[Complex64], b: &[Complex64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).norm()))
}

#[test]
fn round_holes_stay() {
    let domain = round(&HOLES);
    let map = solve(&domain);
    println!("estimate {:.1e}, {:?}", map.error_estimate(), map.circles());
    for (found, exact) in map.circles().iter().zip(HOLES) {
        assert!(
            (found.center - exact.center).norm() < 1e-12 && (found.radius - exact.radius).abs() < 1e-12,
            "{found:?}"
        );
    }
    let z = places(&domain);
    let off = distance(&map.to_circles(&z), &z);
    assert!(off < 1e-10 && off <= map.error_estimate(), "{off:e}");
    let off = distance(&map.from_circles(&z), &z);
    assert!(off < 1e-10, "{off:e}");
    assert_eq!(map.stop(), Stop::Tolerance);
    // A point every few slopes.
    let slopes = map.derivative(&z.iter().step_by(7).copied().collect::<Vec<_>>());
    let off = largest(slopes.iter().map(|slope| (slope - 1.0).norm()));
    assert!(off < 1e-6, "{off:e}");
}

/// A Möbius map takes circles to circles: what comes back is the domain that it was made from.
#[test]
fn images_under_moebius_maps() {
    let moebius = Moebius::new(c(1.0, 0.4), c(0.3, -0.2), c(0.25, 0.1), c(1.1, 0.0)).unwrap();
    let image = |z: &Complex64| moebius.apply(*z);
    let original = round(&HOLES);
    // Unevenly spread, circles take more points.
    let dense = |center: Complex64, radius: f64| curve(96, |t| image(&(center + Complex64::from_polar(radius, t))));
    let holes: Vec<Vec<Complex64>> = HOLES.iter().map(|hole| dense(hole.center, hole.radius)).collect();
    let outer = dense(Complex64::ZERO, 1.0);
    let domain = Domain::new(&outer, &holes, Curve::Smooth).unwrap();
    let domain = domain.with_center(moebius.apply(Complex64::ZERO)).unwrap();
    let domain = domain.with_toward(moebius.apply(Complex64::ONE)).unwrap();
    let map = solve(&domain);
    for (found, exact) in map.circles().iter().zip(HOLES) {
        assert!(
            (found.center - exact.center).norm() < 1e-11 && (found.radius - exact.radius).abs() < 1e-11,
            "{found:?}"
        );
    }
    let w = places(&original);
    let z: Vec<Complex64> = w.iter().map(image).collect();
    let off = distance(&map.from_circles(&w), &z);
    assert!(off < 1e-9, "{off:e}");
    let z: Vec<Complex64> = w.iter().map(|w| moebius.apply(w * (1.0 - 1e-9))).filter(|z| domain.contains(*z)).collect();
    let back: Vec<Complex64> = z.iter().map(|z| moebius.inverse().apply(*z)).collect();
    let off = distance(&map.to_circles(&z), &back);
    assert!(off < 1e-9 && off <= map.error_estimate(), "{off:e}, estimate {:e}", map.error_estimate());
}

fn windows() -> Domain {
    let outer = points(&[[-3.0, -2.0], [3.0, -2.0], [3.0, 2.0], [-3.0, 2.0]]);
    let at = |x: f64| square(0.5).iter().map(|z| z + x).collect::<Vec<_>>();
    Domain::new(&outer, &[at(-1.5), at(1.5)], Curve::Polygon).unwrap().with_center(Complex64::ZERO).unwrap()
}

/// Two windows: symmetric circles, everything there and back, and the invariants of rings with slits on both sides.
#[test]
fn windows_in_a_rectangle() {
    let domain = windows().with_toward(c(3.0, 0.0)).unwrap();
    let map = solve(&domain);
    let [a, b] = [map.circles()[0], map.circles()[1]];
    println!("{a:?} {b:?}, estimate {:.1e}", map.error_estimate());
    assert!((a.center + b.center).norm() < 1e-11 && (a.radius - b.radius).abs() < 1e-11);
    assert!(b.center.im.abs() < 1e-12 && b.center.re > 0.0);
    let z = places(&domain);
    let images = map.to_circles(&z);
    let outside = |w: &Complex64| {
        w.norm() > 1.0 + 1e-12 || map.circles().iter().any(|o| (w - o.center).norm() < o.radius - 1e-11)
    };
    assert!(!images.iter().any(outside));
    let [off, at_corners] = returned(&domain, &z, &map.from_circles(&images));
    assert!(off < 1e-9 && at_corners < 1e-6, "{off:e} {at_corners:e}");
    let round = round(map.circles());
    for (domain, kind) in [(&domain, "region"), (&round, "round")] {
        let slits = SlitMap::solve(domain, SlitKind::Annulus { hole: 0 }, &options(1e-12), &mut |_, _| true).unwrap();
        let slit = slits.slits()[0].ends[0].norm();
        let inner = slits.to_slits(&[domain.holes()[0][0]])[0].norm();
        assert!((slit - 0.869_079_520_679).abs() < 1e-11 && (inner - 0.284_849_842_723).abs() < 1e-11, "{kind}");
    }
}

/// One hole: the ring's modulus is that of the eccentric circles.
#[test]
fn a_frame_has_the_modulus_of_its_circles() {
    let domain = Domain::new(&square(1.0), &[square(0.5)], Curve::Polygon).unwrap();
    let domain = domain.with_center(c(0.75, 0.1)).unwrap();
    let map = solve(&domain);
    let Circle { center, radius } = map.circles()[0];
    let cosh: f64 = (1.0 + radius * radius - center.norm_sqr()) / (2.0 * radius);
    let inner = (-cosh.acosh()).exp();
    assert!((inner - 0.541_210_760_957_991_01).abs() < 1e-11, "{inner}");
    let ring = AnnulusMap::solve(&domain, &options(1e-12), &mut |_, _| true).unwrap();
    assert!((inner - ring.inner_radius()).abs() < 1e-11);
    assert_eq!(map.to_circles(&[c(0.75, 0.1)])[0], Complex64::ZERO);
    let z = places(&domain);
    let [off, at_corners] = returned(&domain, &z, &map.from_circles(&map.to_circles(&z)));
    assert!(off < 1e-9 && at_corners < 1e-6, "{off:e} {at_corners:e}");
    let h = 1e-6;
    for z in z.iter().step_by(17) {
        let [before, after] = [z - h, z + h].map(|z| map.to_circles(&[z])[0]);
        let (slope, difference) = (map.derivative(&[*z])[0], (after - before) / (2.0 * h));
        let beside =
            [c(0.02, 0.0), c(-0.02, 0.0), c(0.0, 0.02), c(0.0, -0.02)].iter().all(|by| domain.contains(z + by));
        assert!(!beside || (slope - difference).norm() < 1e-5 * slope.norm(), "{z}: {slope} {difference}");
    }
}

/// Many holes, among them close ones.
#[test]
fn five_holes() {
    let outer = points(&[[-3.0, -3.0], [3.0, -3.0], [3.0, 3.0], [-3.0, 3.0]]);
    let at = |x: f64, y: f64, half: f64| {
        square(half).iter().map(|z| z * Complex64::cis(0.3 * x) + c(x, y)).collect::<Vec<_>>()
    };
    let holes = [at(-1.5, -1.5, 0.6), at(1.5, -1.4, 0.4), at(1.3, 1.5, 0.7), at(-1.6, 1.2, 0.5), at(-0.5, 0.1, 0.3)];
    let domain = Domain::new(&outer, &holes, Curve::Polygon).unwrap().with_center(c(0.4, 0.0)).unwrap();
    let mut stages = Vec::new();
    let map = CircleMap::solve(&domain, &options(1e-8), &mut |stage, fraction| {
        stages.push((stage, fraction));
        true
    })
    .unwrap();
    println!("{} calls, estimate {:.1e}", stages.len(), map.error_estimate());
    assert!(stages.iter().any(|(stage, _)| *stage == "circles") && stages.iter().all(|(_, f)| (0.0..=1.0).contains(f)));
    let fine = solve(&domain);
    let off = largest(
        map.circles()
            .iter()
            .zip(fine.circles())
            .map(|(a, b)| (a.center - b.center).norm().max((a.radius - b.radius).abs())),
    );
    assert!(off <= map.error_estimate() + fine.error_estimate(), "{off:e}");
    let z = places(&domain);
    let off = distance(&map.to_circles(&z), &fine.to_circles(&z));
    assert!(off <= map.error_estimate() + fine.error_estimate(), "{off:e}");
    let [off, at_corners] = returned(&domain, &z, &map.from_circles(&map.to_circles(&z)));
    assert!(off < 1e-6 && at_corners < 1e-4, "{off:e} {at_corners:e}");
    let mut calls = 0;
    let cancelled = CircleMap::solve(&domain, &options(1e-8), &mut |stage, _| {
        calls += usize::from(stage == "circles");
        calls < 2
    });
    assert_eq!(cancelled.unwrap_err(), Error::Cancelled);
}

#[test]
fn what_round_holes_need_is_said() {
    let refused = |domain: &Domain| CircleMap::solve(domain, &options(1e-6), &mut |_, _| true).unwrap_err().to_string();
    let frame = Domain::new(&square(1.0), &[square(0.5)], Curve::Polygon).unwrap();
    assert_eq!(refused(&frame), "A map onto round holes needs a center; this region has none.");
    let outside = Domain::exterior(&[square(1.0)], Curve::Polygon).unwrap();
    assert_eq!(refused(&outside), "A map onto round holes needs an outer boundary; this region has none.");
}
