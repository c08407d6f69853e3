//! Strips and half planes against closed forms.

use super::{options, toolbox};
use crate::support::{c, largest, points, polygon, share, spread_points};
use conformal_warp::{Complex64, Curve, HalfPlaneMap, Region, StripMap};
use std::f64::consts::{PI, TAU};

fn disk(center: Complex64) -> Region {
    let circle: Vec<Complex64> = (0..32).map(|k| Complex64::cis(TAU * f64::from(k) / 32.0)).collect();
    Region::new(&circle, Curve::Smooth, center, Complex64::ONE).unwrap()
}

fn strip(region: &Region, ends: [Complex64; 2]) -> StripMap {
    StripMap::solve(region, ends, &options(1e-12), &mut |_, _| true).unwrap()
}

fn half_plane(region: &Region, pole: Complex64) -> HalfPlaneMap {
    HalfPlaneMap::solve(region, pole, &options(1e-12), &mut |_, _| true).unwrap()
}

#[test]
fn the_disk() {
    let z: Vec<Complex64> =
        (1..60).map(|k| Complex64::from_polar(1.0 - 0.9 * share(k, 0.31), 0.7 * k as f64)).collect();
    // Through the center 0: log((1 + z)/(1 − z))/π + i/2.
    let map = strip(&disk(Complex64::ZERO), [c(-1.0, 0.0), c(1.0, 0.0)]);
    for (z, w) in z.iter().zip(map.to_strip(&z)) {
        let exact = ((1.0 + z) / (1.0 - z)).ln() / PI + c(0.0, 0.5);
        assert!((w - exact).norm() < 1e-12, "{z}: {w} {exact}");
    }
    // i(1 + z)/(1 − z), and the same for a center that goes to i.
    let map = half_plane(&disk(Complex64::ZERO), Complex64::ONE);
    for (z, w) in z.iter().zip(map.to_half_plane(&z)) {
        let exact = Complex64::I * (1.0 + z) / (1.0 - z);
        assert!((w - exact).norm() < 1e-12 * (1.0 + exact.norm_sqr()), "{z}: {w} {exact}");
    }
    let center = c(0.3, -0.4);
    let map = half_plane(&disk(center), -Complex64::I);
    let plain = |z: Complex64| Complex64::I * (1.0 + z * Complex64::I) / (1.0 - z * Complex64::I);
    let there = plain(center);
    for (z, w) in z.iter().zip(map.to_half_plane(&z)) {
        let exact = (plain(*z) - there.re) / there.im;
        assert!((w - exact).norm() < 1e-12 * (1.0 + exact.norm_sqr()), "{z}: {w} {exact}");
    }
    for (z, back) in z.iter().zip(map.from_half_plane(&map.to_half_plane(&z))) {
        assert!((z - back).norm() < 1e-11, "{z} {back}");
    }
    assert!(map.from_half_plane(&[c(0.0, -0.1)])[0].is_nan() && map.to_half_plane(&[c(2.0, 0.0)])[0].is_nan());
}

#[test]
fn the_square() {
    let corners = [c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)];
    let square = polygon(&corners, Complex64::ZERO);
    let map = half_plane(&square, corners[0]);
    let images = map.to_half_plane(&[corners[1], corners[2], corners[3], Complex64::ZERO]);
    for (w, exact) in images.iter().zip([c(-1.0, 0.0), Complex64::ZERO, c(1.0, 0.0), Complex64::I]) {
        assert!((w - exact).norm() < 1e-12, "{w} {exact}");
    }
    assert!(map.to_half_plane(&[corners[0]])[0].norm() > 1e14);
    // Beside the pole w ~ −C/(z − pole)², whose C two distances must agree on: far beyond what a number near the pole can say.
    let by_distance = |d: f64| map.to_half_plane(&[corners[0] + c(d, d)])[0] * d * d;
    for d in [1e-5, 1e-8, 1e-11] {
        let [near, far] = [by_distance(d), by_distance(1e-3)];
        // Corners carry 1e-16 of their size into distances from them.
        assert!((near / far - 1.0).norm() < 1e-5 + 1e-15 / d, "{d}: {near} {far}");
    }
    let map = strip(&square, [corners[0], corners[2]]);
    let images = map.to_strip(&[Complex64::ZERO, corners[1], corners[3]]);
    for (w, exact) in images.iter().zip([c(0.0, 0.5), Complex64::ZERO, c(0.0, 1.0)]) {
        assert!((w - exact).norm() < 1e-12, "{w} {exact}");
    }
    let ends = map.to_strip(&[corners[0], corners[2]]);
    assert!(ends[0].re == f64::NEG_INFINITY && ends[1].re == f64::INFINITY, "{ends:?}");
}

/// A long rectangle with its ends as those of the strip: away from them w = z + half the width of the sinh map, and the far
/// ends keep all their digits: sinh(π(a − z)/2)-like, as in maps between rectangles.
#[test]
fn far_ends_stay_apart() {
    for a in [5.0, 10.0, 20.0] {
        // [−a, a] × [0, 1].
        let corners = [c(-a, 0.0), c(a, 0.0), c(a, 1.0), c(-a, 1.0)];
        let region = polygon(&corners, c(0.0, 0.5));
        let map = strip(&region, [c(-a, 0.5), c(a, 0.5)]);
        let mut z = spread_points(&region, 200);
        z.extend((0..60).map(|k| c(a - 1e-3 - 0.05 * f64::from(k), share(k as usize, 0.618))));
        z.extend((0..60).map(|k| c(0.05 * f64::from(k) + 1e-3 - a, share(k as usize, 0.618))));
        // The half strip to the right: πw = −2 log tanh-like; from u = sn with k → 0 this is, up to e^(−2πa),
        // w = (2/π) asinh-like. Checked by what it must be: v = sin(iπ(z − z₀)) takes a half strip to a half plane.
        let exact = |z: Complex64| {
            // From the right end if that is nearer, else from the left, by symmetry.
            let (sign, z) = if z.re >= 0.0 { (1.0, z) } else { (-1.0, c(-z.re, z.im)) };
            // Half strip {Re y > 0, 0 < Im y < 1}, y = a − z̄ …: cosh(πy) takes it to the upper half plane, the end's middle to 0.
            let y = c(a - z.re, z.im);
            let cosh = (PI * y).cosh();
            // log cosh πy ≈ πy − log 2 far from the end.
            let log = cosh.ln();
            let w = c(a - (log.re + 2f64.ln()) / PI, log.im / PI);
            c(sign * w.re, w.im)
        };
        let images = map.to_strip(&z);
        let off = largest(images.iter().zip(&z).map(|(w, z)| (w - exact(*z)).norm()));
        println!("a = {a}: {off:.1e}, {} charts, estimate {:.1e}", map.disk().charts(), map.error_estimate());
        // The other end's part is e^(−2πa).
        assert!(off <= 1e-11 + map.error_estimate() + 2.0 * (-TAU * a).exp() && off < 1e-9, "a = {a}: {off:e}");
        let back = map.from_strip(&images);
        // Beside corners that are no ends the way back is conditioned like √ε.
        let beside = |z: &Complex64| corners.iter().any(|corner| (corner - z).norm() < 0.01);
        for (z, back) in z.iter().zip(&back) {
            let bound = if beside(z) { 1e-6 } else { 1e-10 };
            assert!((back - z).norm() < bound, "a = {a}: {z} came back to {back}");
        }
        for (z, slope) in z.iter().zip(map.derivative(&z)).take(200) {
            let [before, after] = [z - 1e-5, z + 1e-5].map(|z| map.to_strip(&[z])[0]);
            let difference = (after - before) / 2e-5;
            assert!(
                difference.is_nan() || (difference - slope).norm() < 1e-6 * slope.norm().max(1.0),
                "{z}: {difference} {slope}"
            );
        }
    }
}

/// SC Toolbox, tests/testStrip.m and tests/testHalfplane.m, which list values of the inverse maps, normalised otherwise.
#[test]
fn toolbox_strip_and_half_plane() {
    let region = toolbox();
    let map = strip(&region, [c(4.0, 0.0), c(-3.0, 0.0)]);
    let theirs = points(&[[1.0, 1.0], [-2.0, 0.5], [0.0, 0.0]]);
    let places = points(&[[-3.0, -0.312_856_946_533_931], [3.534_971_699_300_866, -0.074_755_569_347_609], [0.0, 2.0]]);
    let ours = map.to_strip(&places);
    for (w, exact) in ours.iter().zip(&theirs) {
        let moved = w - exact - (ours[2] - theirs[2]);
        assert!(moved.norm() < 1e-9 && (w.im - exact.im).abs() < 1e-9, "{w} {exact}");
    }
    let map = half_plane(&region, c(2.0, -2.0));
    let theirs = points(&[[-1.0, 0.01], [0.0, 2.0], [4.0, 0.5], [-1.0, 0.0]]);
    let places = points(&[
        [3.718_839_996_085_665, -0.046_084_791_699_413],
        [1.734_612_962_216_089, -0.777_136_490_010_106],
        [1.179_285_609_480_821, -1.753_573_737_693_204],
        [4.0, 0.0],
    ]);
    let ours = map.to_half_plane(&places);
    let scale = (ours[1] - ours[2]) / (theirs[1] - theirs[2]);
    assert!(scale.im.abs() < 1e-9 && scale.re > 0.0, "{scale}");
    for (w, exact) in ours.iter().zip(&theirs) {
        let moved = w - exact * scale - (ours[1] - theirs[1] * scale);
        assert!(moved.norm() < 1e-8, "{w} {exact}: {moved}");
    }
}

#[test]
fn ends_must_be_two() {
    let error = StripMap::solve(&toolbox(), [c(4.0, 0.0), c(4.0, 0.0)], &options(1e-8), &mut |_, _| true).unwrap_err();
    assert_eq!(error.to_string(), "A strip map is not possible: two of the marked boundary points are one.");
}
