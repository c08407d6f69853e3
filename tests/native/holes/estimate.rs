//! The estimate is never below the error: rings that are images of exact rings, and polygons against a finer solve.

use super::{curve, options};
use crate::support::largest;
use crate::support::random::Random;
use conformal_warp::{AnnulusMap, Complex64, Curve, Domain, Error};
use std::f64::consts::TAU;

/// z = w + Σ aₖ wᵏ + Σ bₖ w⁻ᵏ, one to one on the ring ρ < |w| < 1, where the derivative's real part stays positive.
struct ExactRing {
    radius: f64,
    terms: Vec<(i32, Complex64)>,
}

impl ExactRing {
    fn random(random: &mut Random) -> Self {
        let radius = random.between(0.2, 0.9);
        let mut terms = Vec::new();
        let mut room = random.between(0.1, 0.7);
        for k in [2, -1, 3, -2, 4, 5] {
            // |k aₖ wᵏ⁻¹| ≤ what it takes of the room.
            let share = room * random.between(0.0, 0.6);
            room -= share;
            let largest = if k > 0 { 1.0 } else { f64::powi(radius, k - 1) };
            terms.push((k, Complex64::from_polar(share / (f64::from(k.abs()) * largest), random.between(0.0, TAU))));
        }
        Self { radius, terms }
    }

    fn at(&self, w: Complex64) -> Complex64 {
        w + self.terms.iter().map(|&(k, a)| a * w.powi(k)).sum::<Complex64>()
    }

    fn domain(&self, points: usize) -> Domain {
        let circle = |r: f64| curve(points, |t| self.at(Complex64::from_polar(r, t)));
        let domain = Domain::new(&circle(1.0), &[circle(self.radius)], Curve::Smooth).unwrap();
        domain.with_toward(self.at(Complex64::ONE)).unwrap()
    }
}

#[test]
fn smooth_images_of_exact_rings() {
    let mut random = Random::new(15);
    let mut solved = 0;
    for case in 0..500 {
        let exact = ExactRing::random(&mut random);
        let tolerance = 10f64.powf(random.between(-12.0, -2.0));
        let points = [24, 32, 48, 96][case % 4];
        let map = match AnnulusMap::solve(&exact.domain(points), &options(tolerance), &mut |_, _| true) {
            Err(Error::TooFewPoints { .. } | Error::Inaccurate { .. }) => continue,
            solved => solved.unwrap(),
        };
        solved += 1;
        let images: Vec<Complex64> = (0..20)
            .map(|k| Complex64::from_polar(exact.radius.powf(0.05 + 0.9 * f64::from(k) / 20.0), 1.3 * f64::from(k)))
            .collect();
        let places: Vec<Complex64> = images.iter().map(|w| exact.at(*w)).collect();
        let off = images.iter().zip(map.to_annulus(&places)).map(|(w, found)| (found / w).ln().norm());
        let error = largest(off.chain([(map.inner_radius() / exact.radius).ln().abs()]));
        let estimate = map.error_estimate();
        assert!(
            error <= estimate,
            "case {case}, tolerance {tolerance:.1e}: error {error:.1e}, estimate {estimate:.1e}"
        );
    }
    // The others are told that they need more points.
    assert!(solved > 250, "only {solved} of 500 were solved");
}

#[test]
fn polygons_against_finer_solves() {
    let mut random = Random::new(7);
    let mut tried = 0;
    for case in 0..40 {
        let star = |random: &mut Random, n: usize, low: f64, high: f64, center: Complex64| -> Vec<Complex64> {
            let at = |k: usize| TAU * k as f64 / n as f64;
            (0..n).map(|k| center + Complex64::from_polar(random.between(low, high), at(k))).collect()
        };
        let outer = star(&mut random, 5 + case % 9, 0.9, 1.5, Complex64::ZERO);
        let size = random.between(0.1, 0.6);
        let hole = star(&mut random, 3 + case % 6, 0.4 * size, size, Complex64::new(0.1, 0.05));
        let Ok(domain) = Domain::new(&outer, &[hole], Curve::Polygon) else { continue };
        tried += 1;
        let fine = AnnulusMap::solve(&domain, &options(1e-12), &mut |_, _| true).unwrap();
        let tolerance = 10f64.powf(random.between(-8.0, -2.0));
        let map = AnnulusMap::solve(&domain, &options(tolerance), &mut |_, _| true).unwrap();
        let grid: Vec<Complex64> = (0..150)
            .map(|_| Complex64::new(random.between(-1.3, 1.3), random.between(-1.3, 1.3)))
            .filter(|z| domain.contains(*z))
            .collect();
        let off = map.to_annulus(&grid).into_iter().zip(fine.to_annulus(&grid)).map(|(a, b)| (a / b).ln().norm());
        let error = largest(off.chain([(map.inner_radius() / fine.inner_radius()).ln().abs()]));
        let estimate = map.error_estimate() + fine.error_estimate();
        assert!(
            error <= estimate,
            "case {case}, tolerance {tolerance:.1e}: error {error:.1e}, estimate {estimate:.1e}"
        );
    }
    assert!(tried > 30, "only {tried} of 40 are regions");
}
