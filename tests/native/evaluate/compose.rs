//! A solved map with formulas before and after it: other targets than the disk, and moved regions.

use crate::support::{c, case, polygon, solve, spread_points};
use conformal_warp::{Complex64, Compose, FormulaMap, Inverse, InvertibleMap, Jet, Moebius, PlaneMap, RiemannMap};
use std::f64::consts::PI;

fn l_shape() -> RiemannMap {
    let vertices = [c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)];
    solve(&polygon(&vertices, c(0.5, 0.5)), 1e-10)
}

fn jets(map: &dyn PlaneMap, points: &[Complex64]) -> Vec<Jet> {
    let mut jets = vec![Jet::UNDEFINED; points.len()];
    map.jets(points, &mut jets);
    jets
}

/// Derivatives against central differences of the map itself.
fn check_derivatives(map: &dyn PlaneMap, points: &[Complex64]) {
    let h = 1e-5;
    let at = |shift: f64| jets(map, &points.iter().map(|z| z + shift).collect::<Vec<_>>());
    let (right, left) = (at(h), at(-h));
    for (k, jet) in jets(map, points).iter().enumerate() {
        let difference = (right[k].value - left[k].value) / (2.0 * h);
        let error = (jet.dz - difference).norm() / jet.dz.norm().max(1.0);
        assert!(error < 1e-5, "at {}: {} {difference}", points[k], jet.dz);
    }
}

/// Region → upper half plane: the boundary goes to the real axis, `toward` to ∞, the center to i.
#[test]
fn half_plane_targets() {
    let map = l_shape();
    let to_half_plane = Compose { outer: Moebius::cayley().inverted(), inner: &map };
    let z = spread_points(map.region(), 300);
    let images = jets(&to_half_plane, &z);
    for (jet, z) in images.iter().zip(&z) {
        assert!(jet.value.im > 0.0, "{z}: {}", jet.value);
    }
    assert!((jets(&to_half_plane, &[c(0.5, 0.5)])[0].value - Complex64::I).norm() < 1e-9);
    let on_boundary = jets(&to_half_plane, &[c(1.0, 0.0), c(0.3, 2.0), c(1.0, 1.5)]);
    assert!(on_boundary.iter().all(|jet| jet.value.im.abs() < 1e-12));
    check_derivatives(&to_half_plane, &z[..50]);
    // And back, exactly as it came.
    let mut back = vec![Jet::UNDEFINED; z.len()];
    to_half_plane.inverse_jets(&images.iter().map(|jet| jet.value).collect::<Vec<_>>(), &mut back);
    for ((jet, there), z) in back.iter().zip(&images).zip(&z) {
        assert!((jet.value - z).norm() < 1e-7 && (jet.dz * there.dz - 1.0).norm() < 1e-6, "{z}: {jet:?}");
    }
}

/// Region → strip: −1 and 1 of the circle, where `toward` and its opposite are, go to its ends, the rest of the boundary to
/// its walls Im = ±π/2.
#[test]
fn strip_targets() {
    let map = l_shape();
    let strip = Compose { outer: FormulaMap::new("log((1+z)/(1-z))").unwrap(), inner: &map };
    let z = spread_points(map.region(), 300);
    for (jet, z) in jets(&strip, &z).iter().zip(&z) {
        assert!(jet.value.im.abs() < 0.5 * PI, "{z}: {}", jet.value);
    }
    for wall in jets(&strip, &[c(1.0, 0.0), c(0.3, 2.0), c(1.0, 1.5)]) {
        assert!((wall.value.im.abs() - 0.5 * PI).abs() < 1e-12, "{}", wall.value);
    }
    check_derivatives(&strip, &z[..50]);
    // The formula undone by another, then the map.
    let back = Compose { outer: Inverse(&map), inner: FormulaMap::new("tanh(z/2)").unwrap() };
    let there: Vec<_> = jets(&strip, &z).iter().map(|jet| jet.value).collect();
    for (jet, z) in jets(&back, &there).iter().zip(&z) {
        assert!((jet.value - z).norm() < 1e-7, "{z}: {}", jet.value);
    }
}

/// A formula before the map: a moved and turned copy of the region, and outside of it nothing.
#[test]
fn formulas_and_moebius_maps_before() {
    let map = l_shape();
    let moved = Compose { outer: &map, inner: FormulaMap::new("i(z - 3 + i)/2").unwrap() };
    let z = spread_points(map.region(), 300);
    let place = |z: &Complex64| 2.0 * z / Complex64::I + 3.0 - Complex64::I;
    let there: Vec<_> = z.iter().map(place).collect();
    for (jet, w) in jets(&moved, &there).iter().zip(map.to_disk(&z)) {
        assert!((jet.value - w).norm() < 1e-10);
    }
    check_derivatives(&moved, &there[..50]);
    assert!(jets(&moved, &[place(&c(1.5, 1.5))])[0].value.is_nan());
    // Another point to 0: an automorphism after the map equals the map for another center, up to a turn.
    let other = map.with_center(c(1.5, 0.4), c(0.0, 0.0), &mut |_, _| true).unwrap();
    let w = map.to_disk(&[c(1.5, 0.4), c(0.0, 0.0)]);
    let automorphism = Moebius::disk_automorphism(w[0], 0.0).unwrap();
    let turn = Moebius::disk_automorphism(Complex64::ZERO, -automorphism.apply(w[1]).arg()).unwrap();
    let recentred = Compose { outer: turn.after(&automorphism), inner: &map };
    for (jet, w) in jets(&recentred, &z).iter().zip(other.to_disk(&z)) {
        assert!((jet.value - w).norm() < 1e-8, "{} {w}", jet.value);
    }
}

/// Formula, solved map, its inverse, formula: the chain rule over all four.
#[test]
fn chains_of_four() {
    let (from, to) = (l_shape(), solve(&case("sc_6_102").region(), 1e-10));
    let inner = Compose { outer: &from, inner: FormulaMap::new("z/2 + 0.2").unwrap() };
    let outer = Compose { outer: FormulaMap::new("exp(z)").unwrap(), inner: Inverse(&to) };
    let chain = Compose { outer, inner };
    let z: Vec<_> = spread_points(from.region(), 300).iter().map(|z| 2.0 * (z - 0.2)).collect();
    assert!(jets(&chain, &z).iter().all(|jet| jet.value.is_finite()));
    check_derivatives(&chain, &z[..50]);
}
