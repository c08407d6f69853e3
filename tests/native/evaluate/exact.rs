//! Derivatives against closed forms, the evaluator of smooth curves, and what is known beside a vertex.

use crate::support::{EXACT_CASES, c, case, exact, largest, polygon, share, solve, spread_points};
use conformal_warp::{Complex64, Curve, Region, RiemannMap};
use std::f64::consts::{PI, TAU};

/// Points of a region, many of them near its boundary.
fn interior_points(region: &Region) -> Vec<Complex64> {
    let beside = (1..1000).map(|k| {
        let (a, b) = region.polygon().edge(k % region.polygon().len());
        let on = a + (b - a) * share(k, 0.569_840_290_998);
        on + (region.center() - on) * 10f64.powf(-6.0 + 5.0 * share(k, 0.324_717_957))
    });
    spread_points(region, 1200).into_iter().chain(beside.filter(|z| region.contains(*z))).collect()
}

/// Largest error of f', relative to |f'| where that is more than 1, against `exact`(z, f(z)).
fn slope_error(map: &RiemannMap, exact: impl Fn(Complex64, Complex64) -> Complex64) -> f64 {
    map.prepare(&mut |_, _| true).unwrap();
    let z = interior_points(map.region());
    let images = map.to_disk(&z);
    let slopes = map.derivative(&z);
    largest((0..z.len()).map(|k| {
        let exact = exact(z[k], images[k]);
        (slopes[k] - exact).norm() / exact.norm().max(1.0)
    }))
}

/// Schwarz and Christoffel: dz/dw = C (1 − wⁿ)^(−2/n) for the regular n-gon, vertex 0 going to 1.
#[test]
fn derivatives_on_regular_polygons() {
    // Γ(1−1/n)/(Γ(1+1/n) Γ(1−2/n)).
    let radii = [(3, 0.566_046_680_363_159_7), (5, 0.851_462_270_201_060_4), (8, 0.944_217_194_784_510_4)];
    for (n, radius) in radii {
        let map = solve(&exact::regular(n), 1e-11);
        assert!((map.conformal_radius() - radius).abs() < 1e-11, "{n}: {}", map.conformal_radius());
        let error = slope_error(&map, |_, w| (1.0 - w.powu(n as u32)).powf(2.0 / n as f64) / radius);
        assert!(error < 1e-8, "{n}: {error:e}");
    }
    // The square of NUMERICS' figures lies with its vertex 0 at −1 − i.
    let square = polygon(&[c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)], Complex64::ZERO);
    let turn = Complex64::cis(0.75 * PI);
    let error = slope_error(&solve(&square, 1e-11), |_, w| turn * (1.0 - w.powu(4)).sqrt() / 1.078_705_202_376_758_7);
    assert!(error < 1e-8, "square: {error:e}");
}

/// The same with the four points where the vertices go: f' = f'(0) (1 − 2 cos 2β w² + w⁴)^½, β half the short side's arc.
#[test]
fn derivatives_on_rectangles() {
    for a in [1.5, 4.0] {
        let region = exact::rectangle(a).with_center(Complex64::ZERO, c(a, 0.0)).unwrap();
        let map = solve(&region, 1e-11);
        let beta = PI * exact::short_side_measure(a);
        let slope = exact::rectangle_slope(a);
        let error = slope_error(&map, |_, w| slope * (1.0 - 2.0 * (2.0 * beta).cos() * w * w + w.powu(4)).sqrt());
        assert!(error < 1e-8, "{a}: {error:e}");
    }
}

/// An inscribed polygon of n + 2 vertices differs from the half disk by the square of its edges.
#[test]
fn derivatives_on_the_half_disk() {
    let center = c(0.0, 0.4);
    let half_plane = |z: Complex64| ((1.0 + z) / (1.0 - z)).powi(2);
    let u0 = half_plane(center);
    let to_disk = |u: Complex64| (u - u0) / (u - u0.conj());
    let turn = to_disk(half_plane(c(-1.0, 0.0)));
    let exact = |z: Complex64| {
        let (u, slope) = (half_plane(z), 4.0 * (1.0 + z) / (1.0 - z).powi(3));
        slope * (u0 - u0.conj()) / (u - u0.conj()).powi(2) / turn
    };
    let probes = [c(0.5, 0.2), c(-0.3, 0.7), c(0.0, 0.9), c(-0.8, 0.05), c(0.2, 1e-9)];
    let errors = [50, 100].map(|n| {
        let mut vertices = vec![c(-1.0, 0.0)];
        vertices.extend((0..n).map(|k| Complex64::cis(PI * f64::from(k) / f64::from(n))));
        let map = solve(&polygon(&vertices, center), 1e-9);
        largest(map.derivative(&probes).iter().zip(&probes).map(|(slope, z)| (slope - exact(*z)).norm()))
    });
    let ratio = errors[0] / errors[1];
    assert!(errors[0] < 2e-2 && (3.5..4.5).contains(&ratio), "error should fall as edge²: {errors:?}");
}

fn smooth(n: usize, at: impl Fn(f64) -> Complex64) -> Region {
    let points: Vec<_> = (0..n).map(|j| at(TAU * j as f64 / n as f64)).collect();
    Region::new(&points, Curve::Smooth, Complex64::ZERO, points[0]).unwrap()
}

/// Smooth curves are evaluated by Cauchy's formula: the ellipse, and the inverted ellipse z = 2pw/((1+p) − (1−p)w²), a
/// formula for the way back.
#[test]
fn smooth_curves_go_both_ways() {
    let (a, b) = (2.0, 1.0);
    let ellipse = solve(&smooth(120, |t| c(a * t.cos(), b * t.sin())), 1e-12);
    let p = 0.4;
    let back = |w: Complex64| 2.0 * p * w / ((1.0 + p) - (1.0 - p) * w * w);
    let back_slope = |w: Complex64| {
        let below = (1.0 + p) - (1.0 - p) * w * w;
        2.0 * p * ((1.0 + p) + (1.0 - p) * w * w) / (below * below)
    };
    let inverted = solve(&smooth(160, |t| back(Complex64::cis(t))), 1e-12);
    assert!(slope_error(&ellipse, |z, _| exact::ellipse(a, b, z).1) < 1e-8);
    assert!(slope_error(&inverted, |_, w| back_slope(w).inv()) < 1e-8);
    for map in [&ellipse, &inverted] {
        let z = interior_points(map.region());
        let w = map.to_disk(&z);
        let error = largest(map.from_disk(&w).iter().zip(&z).map(|(a, b)| (a - b).norm()));
        assert!(error < 1e-10 && map.evaluator_bytes() == 0, "{error:e}");
        // The circle goes to the curve, and back.
        for k in 0..40 {
            let w = Complex64::cis(0.157 * f64::from(k) + 0.01);
            let on = map.from_disk(&[w])[0];
            assert!((map.region().nearest(on).point - on).norm() < 1e-13);
            assert!((map.to_disk(&[on])[0] - w).norm() < 1e-11);
        }
        assert!(map.from_disk(&[c(1.0 + 1e-9, 0.0)])[0].is_nan() && map.to_disk(&[c(3.0, 0.0)])[0].is_nan());
    }
    let w: Vec<_> =
        (1..500).map(|k| Complex64::from_polar((f64::from(k) / 500.0).sqrt(), 2.4 * f64::from(k))).collect();
    let error = largest(inverted.from_disk(&w).iter().zip(&w).map(|(z, w)| (z - back(*w)).norm()));
    assert!(error < 1e-11, "{error:e}");
}

/// At distance s from a vertex of angle απ, |w − w₀| ~ (s/r)^(1/α): w, rounded to ε, tells places apart that differ by
/// s^(1−1/α) ε, and nothing within ε^α. The way back is as exact as that.
#[test]
fn beside_a_vertex_the_way_back_is_as_exact_as_rounding_allows() {
    let mut regions: Vec<_> = EXACT_CASES.iter().map(|name| (*name, case(name).region())).collect();
    regions.push(("spike", case("spike").region()));
    for (name, region) in regions {
        let map = solve(&region, 1e-10);
        map.prepare(&mut |_, _| true).unwrap();
        let polygon = region.polygon();
        let n = polygon.len();
        for k in 0..n {
            let (corner, next) = polygon.edge(k);
            let before = polygon.vertices()[(k + n - 1) % n];
            let angle = ((before - corner) / (next - corner)).arg().rem_euclid(TAU);
            let alpha = angle / PI;
            let room = polygon.clearance(k);
            for distance in (1..30).map(|j| room * 10f64.powf(-0.4 * f64::from(j))) {
                let z =
                    corner + (next - corner) / (next - corner).norm() * Complex64::from_polar(distance, 0.4 * angle);
                let back = map.from_disk(&map.to_disk(&[z]))[0];
                // ε in units of the arc that the vertex's surroundings take: |w − w₀| at distance `room`.
                let top =
                    corner + (next - corner) / (next - corner).norm() * Complex64::from_polar(0.3 * room, 0.4 * angle);
                let arc = (map.to_disk(&[top])[0] - Complex64::cis(map.angles()[k])).norm();
                let rounding = room * (32.0 * f64::EPSILON / arc).powf(alpha);
                let error = (back - z).norm();
                let bound = 1e-9 * polygon.size() + rounding;
                assert!(error <= bound, "{name}, vertex {k} (α = {alpha:.3}), at {distance:e}: {error:e} > {bound:e}");
            }
        }
    }
}
