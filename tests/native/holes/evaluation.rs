//! Evaluation of solved maps, both ways: what is fast must be what is exact.

use super::{curve, options, square};
use crate::support::{largest, points};
use conformal_warp::{
    AnnulusMap, Circulation, Complex64, Curve, Domain, Error, ExteriorMap, Inverse, Jet, PlaneMap, PotentialFlow,
    SlitKind, SlitMap,
};

/// A polygon that goes around unevenly.
fn blob(count: usize, center: Complex64, radius: f64) -> Vec<Complex64> {
    let wave = |k: usize| 1.0 + 0.12 * (3.0 * k as f64).sin() + 0.05 * (k * 7 % 5) as f64;
    (0..count)
        .map(|k| center + Complex64::from_polar(radius * wave(k), std::f64::consts::TAU * k as f64 / count as f64))
        .collect()
}

fn rings() -> Vec<(&'static str, Domain)> {
    let c = Complex64::new;
    let domain = |outer: &[Complex64], hole: Vec<Complex64>, kind| Domain::new(outer, &[hole], kind).unwrap();
    let far = c(1e6, -3e5);
    let moved = |points: Vec<Complex64>| points.into_iter().map(|z| z + far).collect::<Vec<_>>();
    vec![
        ("frame", domain(&square(1.0), square(0.5), Curve::Polygon)),
        ("thin frame", domain(&square(1.0), square(0.95), Curve::Polygon)),
        ("frame far from 0", domain(&moved(square(1.0)), moved(square(0.5)), Curve::Polygon)),
        ("blobs", domain(&blob(40, Complex64::ZERO, 1.0), blob(30, c(0.1, 0.05), 0.4), Curve::Polygon)),
        (
            "circles",
            domain(
                &curve(64, |t| Complex64::cis(t) * 1.5),
                curve(64, |t| c(0.4, 0.1) + 0.5 * Complex64::cis(t)),
                Curve::Smooth,
            ),
        ),
    ]
}

/// Points all over the box around a domain, most of them inside.
fn scattered(domain: &Domain, count: usize) -> Vec<Complex64> {
    let outer = domain.boundary().unwrap_or(domain.holes()[0]);
    let low = outer.iter().fold(outer[0], |low, z| Complex64::new(low.re.min(z.re), low.im.min(z.im)));
    let high = outer.iter().fold(outer[0], |high, z| Complex64::new(high.re.max(z.re), high.im.max(z.im)));
    let (margin, size) = (0.02 * (high - low), high - low);
    let share = |k: usize, a: f64| (k as f64 * a).fract();
    (0..count)
        .map(|k| {
            let (x, y) = (share(k, 0.618_033_988_7), share(k, 0.754_877_666_2));
            low - margin + Complex64::new(1.04 * size.re * x, 1.04 * size.im * y)
        })
        .collect()
}

/// There and back again, NaN outside alone, up to the walls.
#[test]
fn round_trips_and_outsides() {
    for (name, domain) in rings() {
        let map = AnnulusMap::solve(&domain, &options(1e-9), &mut |_, _| true).unwrap();
        let grid = scattered(&domain, 20_000);
        let images = map.to_annulus(&grid);
        for (z, w) in grid.iter().zip(&images) {
            assert_eq!(domain.contains(*z), !w.is_nan(), "{name}: {z} ↦ {w}");
            assert!(
                w.is_nan() || (w.norm() <= 1.0 + 1e-9 && w.norm() >= map.inner_radius() - 1e-9),
                "{name}: {z} ↦ {w}"
            );
        }
        let (inside, images): (Vec<Complex64>, Vec<Complex64>) =
            grid.into_iter().zip(images).filter(|(_, w)| !w.is_nan()).unzip();
        let back = map.from_annulus(&images);
        let worst = largest(inside.iter().zip(&back).map(|(z, back)| (z - back).norm()));
        println!("{name}: {worst:.1e}");
        assert!(worst < 1e-7, "{name}: {worst:e}");
        let again = map.to_annulus(&back);
        let worst = largest(images.iter().zip(&again).map(|(w, again)| (w - again).norm()));
        assert!(worst < 1e-8, "{name}: {worst:e}");
    }
}

/// The same bits for the same point, whatever was asked before, alone or among others.
#[test]
fn a_value_depends_on_its_point_alone() {
    for (name, domain) in rings() {
        let solve = || AnnulusMap::solve(&domain, &options(1e-8), &mut |_, _| true).unwrap();
        let (one, other) = (solve(), solve());
        let grid = scattered(&domain, 300);
        let mut cancelled = 0;
        let refused = other.prepare(&mut |_, _| {
            cancelled += 1;
            cancelled < 2
        });
        assert_eq!(refused, Err(Error::Cancelled), "{name}");
        other.prepare(&mut |_, _| true).unwrap();
        let all = one.to_annulus(&grid);
        let alone: Vec<Complex64> = grid.iter().rev().map(|&z| other.to_annulus(&[z])[0]).collect();
        let bits = |w: &Complex64| [w.re.to_bits(), w.im.to_bits()];
        assert!(all.iter().zip(alone.iter().rev()).all(|(a, b)| bits(a) == bits(b)), "{name}");
        let back = one.from_annulus(&all);
        let alone: Vec<Complex64> = all.iter().rev().map(|&w| other.from_annulus(&[w])[0]).collect();
        assert!(back.iter().zip(alone.iter().rev()).all(|(a, b)| bits(a) == bits(b)), "{name}");
        let mut jets = vec![Jet::UNDEFINED; all.len()];
        Inverse(&one).jets(&all, &mut jets);
        assert!(jets.iter().zip(&back).all(|(jet, z)| bits(&jet.value) == bits(z)), "{name}");
    }
}

/// Slits, and the outside of a body near and far.
#[test]
fn slits_and_outsides_come_back() {
    let holes = [
        square(0.3),
        points(&[[1.0, 0.6], [1.6, 0.8], [1.1, 1.4]]),
        points(&[[-1.5, -1.4], [-0.9, -1.2], [-1.2, -0.8]]),
    ];
    let domain =
        Domain::new(&square(2.0), &holes, Curve::Polygon).unwrap().with_center(Complex64::new(-1.0, 0.7)).unwrap();
    let kinds = [
        SlitKind::Disk,
        SlitKind::Annulus { hole: 0 },
        SlitKind::Parallel { angle: 0.4 },
        SlitKind::Radial { pole: Complex64::new(1.4, -1.2) },
    ];
    let grid: Vec<Complex64> = scattered(&domain, 3000).into_iter().filter(|z| domain.contains(*z)).collect();
    for kind in kinds {
        let map = SlitMap::solve(&domain, kind, &options(1e-9), &mut |_, _| true).unwrap();
        let images = map.to_slits(&grid);
        let back = map.from_slits(&images);
        let lost: Vec<_> =
            grid.iter().zip(&images).zip(&back).filter(|(_, back)| back.is_nan()).map(|(pair, _)| pair).collect();
        assert!(lost.is_empty(), "{kind:?}: nothing comes back from {lost:?}");
        let worst = largest(grid.iter().zip(&back).map(|(z, back)| (z - back).norm()));
        println!("{kind:?}: {worst:.1e}");
        assert!(worst < 1e-7, "{kind:?}: {worst:e}");
    }
    let outside =
        Domain::exterior(&[points(&[[0.0, 0.0], [1.0, 0.1], [0.4, 0.3], [0.3, 1.0]])], Curve::Polygon).unwrap();
    let map = ExteriorMap::solve(&outside, &options(1e-10), &mut |_, _| true).unwrap();
    let around: Vec<Complex64> = (0..4000)
        .map(|k| Complex64::from_polar(10f64.powf(f64::from(k) / 1000.0 - 1.0), f64::from(k) * 2.4))
        .filter(|z| outside.contains(*z))
        .collect();
    let images = map.to_exterior(&around);
    let back = map.from_exterior(&images);
    let worst = largest(around.iter().zip(&back).map(|(z, back)| ((z - back) / z.norm().max(1.0)).norm()));
    assert!(worst < 1e-8, "{worst:e}");
    let (z, w) = (around[around.len() - 1], images[images.len() - 1]);
    assert!((w * map.capacity() / z - 1.0).norm() < 1e-2, "far away it is z/capacity: {z} {w}");
}

/// The expansions agree with a finer solve, whose expansions are others.
#[test]
fn expansions_err_less_than_the_solve_says() {
    for (name, domain) in rings() {
        let solve = |tolerance| AnnulusMap::solve(&domain, &options(tolerance), &mut |_, _| true).unwrap();
        let (coarse, fine) = (solve(1e-5), solve(1e-11));
        let grid: Vec<Complex64> = scattered(&domain, 4000).into_iter().filter(|z| domain.contains(*z)).collect();
        let differ = |a: &[Complex64], b: &[Complex64]| largest(a.iter().zip(b).map(|(a, b)| (a / b - 1.0).norm()));
        let worst = differ(&coarse.to_annulus(&grid), &fine.to_annulus(&grid));
        println!("{name}: {worst:.1e}, estimate {:.1e}", coarse.error_estimate());
        assert!(worst < 2.0 * coarse.error_estimate(), "{name}: {worst:e}, estimate {:e}", coarse.error_estimate());
    }
}

/// φ + iψ far away, beside a body and between two, on one branch: what direct summation gave before there were expansions.
#[test]
fn a_potential_jumps_across_its_cut_alone() {
    let bodies = [square(0.5), points(&[[1.5, 0.5], [2.5, 0.3], [2.0, 1.0]])];
    let outside = Domain::exterior(&bodies, Curve::Polygon).unwrap();
    let given = Circulation::Given(vec![2.0, -0.7]);
    let flow = PotentialFlow::past(&outside, 1.0, 0.2, &given, &options(1e-10), &mut |_, _| true).unwrap();
    // Around both bodies the potential grows by both circulations, around one by its own.
    for (center, radius, turning) in
        [(Complex64::new(1.0, 0.2), 4.0, 1.3), (Complex64::ZERO, 0.75, 2.0), (Complex64::new(0.5, 0.0), 30.0, 1.3)]
    {
        let around: Vec<Complex64> = (0..=3000)
            .map(|k| center + Complex64::from_polar(radius, std::f64::consts::TAU * f64::from(k) / 3000.0 + 0.3))
            .collect();
        let phi: Vec<f64> = flow.potential(&around).iter().map(|w| w.re).collect();
        let steps: Vec<f64> = phi.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let smooth: f64 = steps.iter().filter(|step| step.abs() < 0.1 * radius.max(1.0)).sum();
        let jumps: Vec<&f64> = steps.iter().filter(|step| step.abs() >= 0.1 * radius.max(1.0)).collect();
        println!("{center} {radius}: {smooth} {jumps:?}");
        // The cut of the first body once, that of the second once or, from its lowest vertex to the left, twice.
        assert!(jumps.len() <= 3, "{jumps:?}");
        let whole: f64 = smooth + jumps.iter().map(|jump| **jump).sum::<f64>();
        assert!(whole.abs() < 1e-7, "the branch is one function: {whole}");
        if radius < 10.0 {
            assert!((smooth - turning).abs() < 0.05, "{smooth} {turning}");
        }
    }
}
