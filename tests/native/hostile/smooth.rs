//! Smooth curves with exact answers: images of the circle under z + a zⁿ, and ellipses, from few and uneven points.

use super::{report, rounds};
use crate::support::random::Random;
use crate::support::{angle_error, exact, largest};
use conformal_warp::{Complex64, Curve, Error, Region, RiemannMap, SolveOptions, Stop};
use std::f64::consts::TAU;

/// Points of a curve, and the angle on the circle of each.
struct Case {
    points: Vec<Complex64>,
    angles: Vec<f64>,
}

/// Parameters around the circle: evenly spread, denser on one side, or scattered, which no smooth curve goes through.
fn parameters(random: &mut Random) -> Vec<f64> {
    let count = 16 + random.below(300);
    let even = |k: usize| TAU * k as f64 / count as f64;
    let (kind, dense) = (random.below(8), random.between(0.0, 0.5));
    let place = |k: usize, random: &mut Random| match kind {
        0 => even(k) + random.between(-0.3, 0.3) * TAU / count as f64,
        1..=3 => even(k) + dense * even(k).sin(),
        _ => even(k),
    };
    (0..count).map(|k| place(k, random)).collect()
}

/// The circle under z + a zⁿ, |a| n < 1: the inverse of its own map, up to a rotation.
fn polynomial(random: &mut Random) -> Case {
    let n = 2 + random.below(5);
    let a = random.between(0.0, 0.95) / n as f64;
    let t = parameters(random);
    let at = |t: &f64| Complex64::cis(*t) + a * Complex64::cis(*t * n as f64);
    Case { points: t.iter().map(at).collect(), angles: t }
}

fn ellipse(random: &mut Random) -> Case {
    let ratio = 10f64.powf(random.between(0.0, 0.7));
    let t = parameters(random);
    let points: Vec<_> = t.iter().map(|t| Complex64::new(ratio * t.cos(), t.sin())).collect();
    let angles = points.iter().map(|z| exact::ellipse(ratio, 1.0, *z).0.arg()).collect();
    Case { points, angles }
}

#[test]
fn estimates_of_smooth_curves_hold() {
    let wanted = 24 * rounds();
    let (mut solved, mut few, mut other, mut below, mut ratios) = (0u64, 0u64, 0u64, Vec::new(), Vec::new());
    for seed in 0..wanted {
        let mut random = Random::new(5_000_000 + seed);
        let case = if random.below(2) == 0 { polynomial(&mut random) } else { ellipse(&mut random) };
        let tolerance = [1e-3, 1e-6, 1e-9, 1e-12][random.below(4)];
        let region = match Region::new(&case.points, Curve::Smooth, Complex64::ZERO, case.points[0]) {
            Ok(region) => region,
            Err(Error::TooFewPoints { .. } | Error::SelfIntersecting { .. }) => {
                few += 1;
                continue;
            }
            Err(error) => panic!("seed {seed}: {error}"),
        };
        let options = SolveOptions { tolerance, ..SolveOptions::default() };
        let map = match RiemannMap::solve(&region, &options, &mut |_, _| true) {
            Ok(map) => map,
            Err(Error::TooFewPoints { .. }) => {
                few += 1;
                continue;
            }
            Err(error) => panic!("seed {seed} at {tolerance:e}: {error}"),
        };
        let error = largest(map.angles().iter().zip(&case.angles).map(|(a, b)| angle_error(*a, *b - case.angles[0])));
        let ratio = map.error_estimate() / error;
        match map.stop() {
            Stop::Tolerance => {
                solved += 1;
                assert!(error <= tolerance, "seed {seed}: {error:e} at {tolerance:e}");
            }
            Stop::TooFewPoints => few += 1,
            _ => other += 1,
        }
        if ratio.is_nan() || ratio < 1.0 && error > 1e-14 {
            below.push((seed, tolerance, ratio));
        }
        ratios.push(ratio);
    }
    ratios.sort_by(f64::total_cmp);
    report(&format!(
        "smooth curves: {wanted} tried, {solved} solved, {few} told that they need more points, {other} stopped otherwise, {} estimates too low {below:?}, median ratio {:.1}",
        below.len(),
        ratios[ratios.len() / 2]
    ));
    assert!(1000 * below.len() as u64 <= wanted, "estimates below the error: {below:?}");
    assert!(solved > wanted / 3, "only {solved} of {wanted} solved");
}
