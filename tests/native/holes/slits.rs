//! Regions with slits, and electrostatics: right-hand sides of one system.

use super::{curve, options, square};
use conformal_warp::{Complex64, Conductors, Curve, Domain, Electrostatics, Error, SlitKind, SlitMap};
use std::f64::consts::TAU;

fn circle(center: Complex64, radius: f64) -> Vec<Complex64> {
    curve(32, |t| center + Complex64::from_polar(radius, t))
}

/// The three circles of SKPrime's example.
fn three_circles() -> Domain {
    let holes = [(-0.2517, 0.3129, 0.2377), (0.2307, -0.4667, 0.1557)].map(|(x, y, r)| circle(Complex64::new(x, y), r));
    Domain::new(&circle(Complex64::ZERO, 1.0), &holes, Curve::Smooth).unwrap()
}

fn windows() -> Domain {
    let outer = [(-3.0, -2.0), (3.0, -2.0), (3.0, 2.0), (-3.0, 2.0)].map(|(x, y)| Complex64::new(x, y));
    let at = |x: f64| square(0.5).iter().map(|z| z + x).collect::<Vec<_>>();
    Domain::new(&outer, &[at(-1.5), at(1.5)], Curve::Polygon).unwrap()
}

fn solve(domain: &Domain, kind: SlitKind) -> SlitMap {
    SlitMap::solve(domain, kind, &options(1e-12), &mut |_, _| true).unwrap()
}

/// Circular slits have both ends on one circle: its radius.
fn radius(map: &SlitMap, slit: usize) -> f64 {
    let [a, b] = map.slits()[slit].ends;
    assert!((a.norm() - b.norm()).abs() < 1e-13);
    a.norm()
}

#[test]
fn rings_with_circular_slits() {
    let inner = |map: &SlitMap, domain: &Domain, hole: usize| {
        let z = domain.holes()[hole][0];
        map.to_slits(&[z])[0].norm()
    };
    let domain = three_circles();
    for (hole, inner_radius) in [(0, 0.291_213_184_540_522), (1, 0.222_014_152_039_731)] {
        let map = solve(&domain, SlitKind::Annulus { hole });
        assert!((inner(&map, &domain, hole) - inner_radius).abs() < 1e-12);
        assert!((radius(&map, 0) - 0.784_132_575_364_947).abs() < 1e-12);
    }
    let domain = windows();
    let map = solve(&domain, SlitKind::Annulus { hole: 0 });
    assert!((inner(&map, &domain, 0) - 0.284_849_842_723).abs() < 1e-12);
    assert!((radius(&map, 0) - 0.869_079_520_679).abs() < 1e-12);
}

#[test]
fn maxwell_matrices() {
    let matrix = |domain: &Domain| {
        let given = Conductors::Potentials(vec![0.0, 1.0, 1.0]);
        let field = Electrostatics::solve(domain, &given, &options(1e-12), &mut |_, _| true).unwrap();
        assert!(field.capacitance().iter().all(|row| row.iter().sum::<f64>().abs() < 1e-10));
        field.capacitance().to_vec()
    };
    let circles = matrix(&three_circles());
    for (value, exact) in [(circles[1][1], 5.260_503_43), (circles[1][2], -0.849_981_61), (circles[2][2], 4.312_173_03)]
    {
        assert!((value - exact).abs() < 1e-8, "{value} {exact}");
    }
    let windows = matrix(&windows());
    for (value, exact) in
        [(windows[1][1], 5.066_619_684_33), (windows[1][2], -0.566_137_337_953), (windows[2][1], windows[1][2])]
    {
        assert!((value - exact).abs() < 1e-11, "{value} {exact}");
    }
}

#[test]
fn two_cylinders() {
    let outside = Domain::exterior(&[-2.0, 2.0].map(|x| circle(Complex64::new(x, 0.0), 1.0)), Curve::Smooth).unwrap();
    let given = Conductors::Charges(vec![-1.0, 1.0]);
    let field = Electrostatics::solve(&outside, &given, &options(1e-12), &mut |_, _| true).unwrap();
    let capacity = 2.385_492_095_780_448_8;
    assert!((field.capacitance()[0][0] - capacity).abs() < 1e-12);
    assert!((field.potentials()[1] - 1.0 / capacity).abs() < 1e-12 && field.potentials()[0] == 0.0);
    // Potential and field of line charges at ±√3.
    let z = Complex64::new(0.4, 1.1);
    let a = 3f64.sqrt();
    let exact = 0.5 / capacity - ((z - a).norm() / (z + a).norm()).ln() / TAU;
    assert!((field.potential(&[z])[0] - exact).abs() < 1e-12);
    let exact = ((z - a).inv() - (z + a).inv()).conj() / TAU;
    assert!((field.field(&[z])[0] - exact).norm() < 1e-12);
    assert!(field.potential(&[Complex64::new(2.0, 0.1)])[0].is_nan());
    let unbalanced = Conductors::Charges(vec![1.0, 1.0]);
    let refused = Electrostatics::solve(&outside, &unbalanced, &options(1e-8), &mut |_, _| true).unwrap_err();
    assert_eq!(refused.code(), "invalid-option");
}

#[test]
fn every_kind_takes_its_components_where_it_says() {
    for domain in [three_circles(), windows()] {
        let center = Complex64::new(0.1, 0.05);
        let toward = domain.boundary().unwrap()[1];
        let domain = domain.with_center(center).unwrap().with_toward(toward).unwrap();
        let inside = |z: &Complex64| domain.contains(*z) && (z - center).norm() > 0.05;
        let grid: Vec<Complex64> = (0..225)
            .map(|k| Complex64::new(f64::from(k % 15) * 0.13 - 0.9, f64::from(k / 15) * 0.13 - 0.91))
            .filter(inside)
            .collect();
        let kinds = [
            SlitKind::Disk,
            SlitKind::Annulus { hole: 1 },
            SlitKind::Parallel { angle: 0.4 },
            SlitKind::Radial { pole: Complex64::new(0.05, 0.75) },
        ];
        for kind in kinds {
            let map = solve(&domain, kind);
            let images = map.to_slits(&grid);
            let back = map.from_slits(&images);
            for ((z, w), back) in grid.iter().zip(&images).zip(&back) {
                let bad = matches!(kind, SlitKind::Radial { pole } if (z - pole).norm() < 0.03);
                assert!(bad || (z - back).norm() < 1e-8, "{kind:?}: {z} → {w} → {back}");
            }
            for (hole, vertices) in domain.holes().iter().enumerate() {
                let images = map.to_slits(vertices);
                let straight = |w: &Complex64| match kind {
                    SlitKind::Disk | SlitKind::Annulus { .. } => w.norm().ln(),
                    SlitKind::Parallel { angle } => (w * Complex64::cis(-angle)).im,
                    SlitKind::Radial { .. } => (w / images[0]).arg(),
                };
                for w in &images {
                    assert!((straight(w) - straight(&images[0])).abs() < 1e-11, "{kind:?}: hole {hole}: {w}");
                }
            }
            if !matches!(kind, SlitKind::Parallel { .. }) {
                assert!((map.to_slits(&[toward])[0] - 1.0).norm() < 1e-12, "{kind:?}");
            }
            if matches!(kind, SlitKind::Disk | SlitKind::Radial { .. }) {
                assert_eq!(map.to_slits(&[center])[0], Complex64::ZERO);
            }
            let h = 1e-5;
            for z in grid.iter().step_by(7) {
                let [a, b] = [z - h, z + h].map(|z| map.to_slits(&[z])[0]);
                let slope = map.derivative(&[*z])[0];
                assert!(
                    ((b - a) / (2.0 * h) - slope).norm() < 1e-5 * (1.0 + slope.norm())
                        || (b - a).is_nan()
                        || !domain.contains(z + 0.05)
                        || !domain.contains(z - 0.05),
                    "{kind:?} {z}"
                );
            }
        }
    }
}

#[test]
fn parallel_slits_of_the_outside() {
    // A circle goes to a slit of four radii by Joukowski's map z + 1/z.
    let outside = Domain::exterior(&[circle(Complex64::ZERO, 1.0)], Curve::Smooth).unwrap();
    let map = solve(&outside, SlitKind::Parallel { angle: 0.0 });
    let z = Complex64::new(1.2, -0.7);
    assert!((map.to_slits(&[z])[0] - (z + z.inv())).norm() < 1e-12);
    let mut ends = map.slits()[0].ends;
    ends.sort_by(|a, b| a.re.total_cmp(&b.re));
    assert!((ends[0] + 2.0).norm() < 1e-12 && (ends[1] - 2.0).norm() < 1e-12, "{ends:?}");
}

#[test]
fn what_a_kind_needs_is_said() {
    let domain = three_circles();
    let solve = |kind| SlitMap::solve(&domain, kind, &options(1e-6), &mut |_, _| true).unwrap_err();
    assert_eq!(solve(SlitKind::Disk).to_string(), "A slit map of this kind needs a center; this region has none.");
    assert!(matches!(solve(SlitKind::Annulus { hole: 2 }), Error::WrongRegion { .. }));
}
