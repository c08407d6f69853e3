//! The error estimate under fire: random polygons with exact answers, from the Schwarz–Christoffel integral.

use super::{report, rounds};
use crate::support::random::Random;
use crate::support::schwarz_christoffel::side_lengths;
use crate::support::{angle_error, largest};
use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A region seen from 0 with conformal radius 1, and the angles of its vertices.
struct Exact {
    region: Region,
    angles: Vec<f64>,
    /// By how much two integrals for the same sides differ.
    own_error: f64,
}

/// w_k ∫₀¹ ∏ (1 − t w_k/w_j)^(α_j − 1) dt by double-exponential quadrature, with 1 − t carried separately.
fn vertex(k: usize, theta: &[f64], alpha: &[f64]) -> Complex64 {
    let step = 1.0 / 64.0;
    let sum = (-330..=330).map(|i| {
        let x = f64::from(i) * step;
        let q = FRAC_PI_2 * x.sinh();
        let (t, rest) = (1.0 / (1.0 + (-2.0 * q).exp()), 1.0 / (1.0 + (2.0 * q).exp()));
        let log =
            |j: usize| if j == k { rest.ln().into() } else { (1.0 - t * Complex64::cis(theta[k] - theta[j])).ln() };
        let product: Complex64 = (0..theta.len()).map(|j| (alpha[j] - 1.0) * log(j)).sum();
        // dt = 2 t (1 − t) dq.
        (product + rest.ln() + t.ln()).exp() * (step * PI * x.cosh())
    });
    Complex64::cis(theta[k]) * sum.sum::<Complex64>()
}

/// None where the image overlaps itself.
fn exact(random: &mut Random) -> Option<Exact> {
    let n = 3 + random.below(10);
    let mut alpha: Vec<f64> = (1..n).map(|_| random.between(0.15, 1.9)).collect();
    let last = n as f64 - 2.0 - alpha.iter().sum::<f64>();
    if !(0.15..1.9).contains(&last) {
        return None;
    }
    alpha.push(last);
    let gaps: Vec<f64> = (0..n).map(|_| random.between(0.2, 1.8)).collect();
    let whole: f64 = gaps.iter().sum();
    let theta: Vec<f64> = (0..n).map(|k| TAU * gaps[..k].iter().sum::<f64>() / whole).collect();
    let vertices: Vec<_> = (0..n).map(|k| vertex(k, &theta, &alpha)).collect();
    let side = |k: usize| (vertices[(k + 1) % n] - vertices[k]).norm();
    let own_error =
        largest(side_lengths(&theta, &alpha).iter().enumerate().map(|(k, length)| (side(k) / length - 1.0).abs()));
    let region = Region::new(&vertices, Curve::Polygon, Complex64::ZERO, vertices[0]).ok()?;
    Some(Exact { region, angles: theta, own_error })
}

#[test]
fn estimates_hold_on_random_polygons_with_exact_answers() {
    let wanted = 60 * rounds();
    let (mut solved, mut below, mut missed, mut ratios) = (0u64, Vec::new(), Vec::new(), Vec::new());
    for seed in 0.. {
        if solved == wanted {
            break;
        }
        let mut random = Random::new(seed);
        let Some(case) = exact(&mut random).filter(|case| case.own_error < 1e-12) else { continue };
        let tolerance = [1e-3, 1e-6, 1e-8, 1e-10][random.below(4)];
        let options = SolveOptions { tolerance, ..SolveOptions::default() };
        let map = RiemannMap::solve(&case.region, &options, &mut |_, _| true)
            .unwrap_or_else(|error| panic!("seed {seed} at {tolerance:e}: {error}"));
        solved += 1;
        // Reversed input keeps its first vertex, so that angles stand in the order of the region's own boundary.
        assert_eq!(map.region().boundary().len(), case.angles.len(), "seed {seed}");
        let angles = map.angles().iter().zip(&case.angles).map(|(a, b)| angle_error(*a, *b));
        let error = largest(angles.chain([(map.conformal_radius() - 1.0).abs()]));
        let ratio = map.error_estimate() / error;
        // The reference has digits of its own to lose.
        if ratio.is_nan() || ratio < 1.0 && error > 100.0 * case.own_error {
            below.push((seed, tolerance, ratio));
        }
        if error.is_nan() || error > tolerance {
            missed.push((seed, tolerance, error));
        }
        ratios.push(ratio);
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    report(&format!(
        "estimates: {solved} exact polygons, {} estimates too low {below:?}, {} tolerances missed {missed:?}, median ratio {median:.1}",
        below.len(),
        missed.len()
    ));
    assert!(missed.is_empty(), "tolerances missed: {missed:?}");
    assert!(1000 * below.len() as u64 <= solved, "estimates below the error: {below:?}");
    assert!(median < 100.0, "{median}");
}
