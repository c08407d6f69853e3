//! Boundaries that break geometry: needles, near touches, combs, spirals, Koch curves, repeats, and numbers that are none.

use super::{report, rounds};
use crate::support::random::{self, Random};
use conformal_warp::{Complex64, Curve, Polygon, Region};
use std::f64::consts::{FRAC_PI_3, TAU};

fn needle(random: &mut Random) -> Vec<Complex64> {
    let thin = 10f64.powf(random.between(-17.0, -1.0));
    [(0.0, 0.0), (1.0, -thin), (2.0, 0.0), (1.0, 1.0)].map(|(x, y)| Complex64::new(x, y)).to_vec()
}

/// A slot whose walls come as near as 1e-17, or cross.
fn near_touch(random: &mut Random) -> Vec<Complex64> {
    let gap = random.between(-1.0, 3.0) * 10f64.powf(random.between(-17.0, -10.0));
    let corners =
        [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0 - gap), (1.0, 1.0 - gap), (1.0, 1.0), (3.0, 1.0), (3.0, 2.0), (0.0, 2.0)];
    corners.map(|(x, y)| Complex64::new(x, y)).to_vec()
}

fn comb(random: &mut Random) -> Vec<Complex64> {
    let teeth = 2 + random.below(300);
    let tooth = |k: usize| {
        let x = k as f64;
        [(x, 0.0), (x + 0.4, 0.0), (x + 0.4, -50.0), (x + 0.6, -50.0), (x + 0.6, 0.0)]
            .map(|(x, y)| Complex64::new(x, y))
    };
    let mut corners: Vec<_> = (0..teeth).flat_map(tooth).collect();
    corners.extend([Complex64::new(teeth as f64, 0.0), Complex64::new(teeth as f64, 1.0), Complex64::new(0.0, 1.0)]);
    corners
}

fn spiral(random: &mut Random) -> Vec<Complex64> {
    let (turns, steps) = (random.between(1.0, 10.0), 200);
    let wall = |share: f64, offset: f64| Complex64::from_polar(1.0 + turns * share + offset, TAU * turns * share);
    let outer = (0..=steps).map(|k| wall(f64::from(k) / f64::from(steps), 0.6));
    let inner = (0..=steps).rev().map(|k| wall(f64::from(k) / f64::from(steps), 0.0));
    outer.chain(inner).collect()
}

fn koch(random: &mut Random) -> Vec<Complex64> {
    let mut corners: Vec<_> = (0..3).map(|k| Complex64::cis(-TAU * f64::from(k) / 3.0)).collect();
    for _ in 0..random.below(6) {
        let edge = |k: usize| {
            let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
            let third = (b - a) / 3.0;
            [a, a + third, a + third + third * Complex64::cis(FRAC_PI_3), a + third * 2.0]
        };
        corners = (0..corners.len()).flat_map(edge).collect();
    }
    corners
}

fn boundary(random: &mut Random) -> Vec<Complex64> {
    let mut corners = match random.below(6) {
        0 => needle(random),
        1 => near_touch(random),
        2 => comb(random),
        3 => spiral(random),
        4 => koch(random),
        _ => random::polygon(random).vertices().to_vec(),
    };
    let scale = [1.0, 1e-150, 1e150, 1e-8, 1e8][random.below(5)];
    corners.iter_mut().for_each(|z| *z *= scale);
    let at = random.below(corners.len());
    match random.below(8) {
        0 => corners.insert(at, corners[at]),
        1 => corners[at].re = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0][random.below(4)],
        2 => corners.swap(at, 0),
        3 => corners.truncate(at),
        4 => corners.insert(at, corners[random.below(corners.len())]),
        _ => {}
    }
    corners
}

/// What is said of a boundary: nothing, or a code.
fn verdict(corners: &[Complex64]) -> &'static str {
    Polygon::new(corners).map_or_else(|error| error.code(), |_| "")
}

#[test]
fn boundaries_are_accepted_or_refused_whichever_way_they_are_written() {
    let tried = 2_000 * rounds();
    let mut accepted = 0;
    for seed in 0..tried {
        let mut random = Random::new(seed);
        let corners = boundary(&mut random);
        let found = verdict(&corners);
        assert!(["", "not-finite", "too-few-vertices", "self-intersecting"].contains(&found), "seed {seed}: {found}");
        let reversed: Vec<_> = corners.iter().rev().copied().collect();
        let mirrored: Vec<_> = corners.iter().map(Complex64::conj).collect();
        let larger: Vec<_> = corners.iter().map(|z| z * 1024.0).collect();
        let mut shifted = corners.clone();
        shifted.rotate_left(random.below(corners.len().max(1)).min(corners.len()));
        for (what, other) in [("reversed", reversed), ("mirrored", mirrored), ("larger", larger), ("shifted", shifted)]
        {
            assert_eq!(verdict(&other), found, "seed {seed}, {what}");
        }
        let Ok(polygon) = Polygon::new(&corners) else { continue };
        accepted += 1;
        assert!(polygon.area() > 0.0, "seed {seed}: area {}", polygon.area());
        for k in 0..polygon.len().min(20) {
            let (a, b) = polygon.edge(k);
            let nearest = polygon.nearest(a);
            assert!(
                (nearest.point - a).norm() <= 1e-15 * polygon.size(),
                "seed {seed}: vertex {k} is off the boundary"
            );
            assert!(
                polygon.contains(a) && !polygon.contains_strictly(a),
                "seed {seed}: vertex {k} is not on the boundary"
            );
            let middle = 0.5 * (a + b);
            let away = (polygon.nearest(middle).point - middle).norm();
            // The middle is rounded, and so is its foot.
            assert!(away <= 2e-15 * polygon.size(), "seed {seed}: the middle of edge {k} is {away:e} off");
        }
        // A center that is inside makes a region; one that is not is refused as such.
        let (low, high) = polygon.bounds();
        let center = Complex64::new(random.between(low.re, high.re), random.between(low.im, high.im));
        let region = Region::new(&corners, Curve::Polygon, center, corners[0]);
        assert_eq!(region.is_ok(), polygon.contains_strictly(center), "seed {seed}");
    }
    report(&format!("boundaries: {tried} tried, {accepted} accepted, the others refused with their reason"));
    assert!(accepted > tried / 3, "only {accepted} of {tried} are simple");
}
