//! Checks that need no closed form: Möbius images, mirrored regions, reciprocal domains.

use super::{curve, options};
use crate::support::largest;
use crate::support::random::Random;
use conformal_warp::{AnnulusMap, Complex64, Curve, Domain, Moebius};
use std::f64::consts::TAU;

fn solve(outer: &[Complex64], hole: &[Complex64], kind: Curve) -> AnnulusMap {
    let domain = Domain::new(outer, &[hole.to_vec()], kind).unwrap().with_toward(outer[0]).unwrap();
    AnnulusMap::solve(&domain, &options(1e-11), &mut |_, _| true).unwrap()
}

/// A smooth curve around a point.
fn wavy(random: &mut Random, center: Complex64, size: f64, points: usize) -> Vec<Complex64> {
    let waves: Vec<(f64, f64)> =
        (2..5).map(|k| (0.25 * random.unit() / f64::from(k * k), random.between(0.0, TAU))).collect();
    let radius =
        |t: f64| 1.0 + waves.iter().zip(2..).map(|(wave, k)| wave.0 * (f64::from(k) * t + wave.1).cos()).sum::<f64>();
    curve(points, |t| center + Complex64::from_polar(size * radius(t), t))
}

/// Points between the curves.
fn between(outer: &[Complex64], hole: &[Complex64], map: &AnnulusMap) -> Vec<Complex64> {
    let center = hole.iter().sum::<Complex64>() / hole.len() as f64;
    let shares = [0.2, 0.5, 0.9];
    let points = outer.iter().step_by(outer.len().div_ceil(24)).flat_map(|z| shares.map(|t| center + (z - center) * t));
    points.filter(|z| map.domain().contains(*z)).collect()
}

#[test]
fn images_and_reciprocals_of_smooth_rings() {
    let mut random = Random::new(31);
    for case in 0..12 {
        let outer = wavy(&mut random, Complex64::ZERO, 1.0, 128);
        let middle = Complex64::from_polar(0.3 * random.unit(), random.between(0.0, TAU));
        let size = random.between(0.1, 0.35);
        let hole = wavy(&mut random, middle, size, 128);
        let ring = solve(&outer, &hole, Curve::Smooth);
        let z = between(&outer, &hole, &ring);
        let w = ring.to_annulus(&z);
        // A pole far outside, and one in the hole, which turns the ring inside out.
        let far = Complex64::from_polar(random.between(2.0, 4.0), random.between(0.0, TAU));
        for (pole, turns) in [(far, false), (middle, true)] {
            let map = Moebius::new(Complex64::new(0.3, 1.0), Complex64::new(0.7, 0.2), Complex64::ONE, -pole).unwrap();
            let image = |points: &[Complex64]| points.iter().map(|z| map.apply(*z)).collect::<Vec<_>>();
            let (a, b) = (image(&outer), image(&hole));
            let other = if turns { solve(&b, &a, Curve::Smooth) } else { solve(&a, &b, Curve::Smooth) };
            let errors = ring.error_estimate() + other.error_estimate();
            let off = (other.inner_radius() / ring.inner_radius()).ln().abs();
            assert!(off <= errors && off < 1e-9, "case {case}, {turns}: modulus {off:e}, estimates {errors:e}");
            let images = other.to_annulus(&image(&z));
            // Inside out: |w| |w'| = ρ. The rest is a turn.
            let ratios: Vec<Complex64> =
                images.iter().zip(&w).map(|(v, w)| if turns { v * w / ring.inner_radius() } else { v / w }).collect();
            let off = largest(ratios.iter().map(|ratio| (ratio / ratios[0]).ln().norm().max(ratio.norm().ln().abs())));
            assert!(off <= 2.0 * errors && off < 1e-9, "case {case}, {turns}: {off:e}, estimates {errors:e}");
        }
    }
}

#[test]
fn mirrored_polygons() {
    let mut random = Random::new(32);
    for case in 0..8 {
        let star = |random: &mut Random, n: usize, size: f64| -> Vec<Complex64> {
            (0..n).map(|k| Complex64::from_polar(size * random.between(0.6, 1.0), TAU * k as f64 / n as f64)).collect()
        };
        let (outer, hole) = (star(&mut random, 5 + case, 2.0), star(&mut random, 3 + case % 4, 0.7));
        let mirrored = |points: &[Complex64]| points.iter().map(Complex64::conj).collect::<Vec<_>>();
        let (ring, other) =
            (solve(&outer, &hole, Curve::Polygon), solve(&mirrored(&outer), &mirrored(&hole), Curve::Polygon));
        let errors = ring.error_estimate() + other.error_estimate();
        let z = between(&outer, &hole, &ring);
        let (w, v) = (ring.to_annulus(&z), other.to_annulus(&mirrored(&z)));
        let off = largest(w.iter().zip(&v).map(|(w, v)| (v.conj() / w).ln().norm()));
        assert!(off <= errors && off < 1e-9, "case {case}: {off:e}, estimates {errors:e}");
        assert!((ring.inner_radius() / other.inner_radius()).ln().abs() <= errors);
    }
}
