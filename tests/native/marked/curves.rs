//! Quadrilaterals, strips and half planes of regions with curved edges, against closed forms.

use super::options;
use crate::support::{c, largest, share};
use conformal_warp::{Complex64, Edge, HalfPlaneMap, RectangleMap, Region, StripMap};
use std::f64::consts::PI;

/// 1 < |z| < e, 0 < arg z < 2: log takes it to a rectangle, 1 × 2.
fn annular_sector() -> (Region, [Complex64; 4]) {
    let outer = 1.0f64.exp();
    let corners = [c(1.0, 0.0), c(outer, 0.0), Complex64::from_polar(outer, 2.0), Complex64::from_polar(1.0, 2.0)];
    let edges = [
        Edge::line(corners[0], corners[1]),
        Edge::circular(Complex64::ZERO, outer, 0.0, 2.0),
        Edge::line(corners[2], corners[3]),
        Edge::circular(Complex64::ZERO, 1.0, 2.0, -2.0),
    ];
    (Region::from_edges(&edges, Complex64::from_polar(1.7, 1.1), corners[0]).unwrap(), corners)
}

/// z ↦ ((1 + z)/(1 − z))² takes the half disk onto the upper half plane, −1 to 0 and 1 to ∞.
fn half_disk(center: Complex64) -> Region {
    let edges = [Edge::line(c(-1.0, 0.0), c(1.0, 0.0)), Edge::circular(Complex64::ZERO, 1.0, 0.0, PI)];
    Region::from_edges(&edges, center, c(1.0, 0.0)).unwrap()
}

fn lifted(z: Complex64) -> Complex64 {
    ((1.0 + z) / (1.0 - z)).powi(2)
}

/// From deep inside to beside the walls.
fn inside_of_half_disk() -> Vec<Complex64> {
    (1..60).map(|k| Complex64::from_polar(1.0 - 0.999 * share(k, 0.31), PI * share(k, 0.77))).collect()
}

#[test]
fn an_annular_sector_is_its_rectangle() {
    let (region, corners) = annular_sector();
    let map = RectangleMap::solve(&region, corners, &options(1e-12), &mut |_, _| true).unwrap();
    let error = (map.aspect() - 0.5).abs().min((map.aspect() - 2.0).abs());
    assert!(error < 1e-12 && error <= 2.0 * map.error_estimate(), "{} {:e}", map.aspect(), map.error_estimate());
    let places: Vec<Complex64> = (1..80).map(|k| c(share(k, 0.31), 2.0 * share(k, 0.77))).map(Complex64::exp).collect();
    let images = map.to_rectangle(&places);
    // The rectangle is the logarithm's up to its unit, which one pair of points tells.
    let unit = (images[1] - images[0]) / (places[1].ln() - places[0].ln());
    let miss =
        largest(places.iter().zip(&images).map(|(z, w)| (w - images[0] - unit * (z.ln() - places[0].ln())).norm()));
    assert!(miss < 1e-11 && unit.im.abs() < 1e-11, "{miss:e} {unit}");
    let back = map.from_rectangle(&images);
    assert!(largest(back.iter().zip(&places).map(|(a, b)| (a - b).norm())) < 1e-11);
}

#[test]
fn a_half_disk_is_a_half_plane_and_a_strip() {
    let places = inside_of_half_disk();
    let center = c(0.1, 0.4);
    let (region, there) = (half_disk(center), lifted(center));
    let map = HalfPlaneMap::solve(&region, c(1.0, 0.0), &options(1e-12), &mut |_, _| true).unwrap();
    let exact = |z: Complex64| (lifted(z) - there.re) / there.im;
    let images = map.to_half_plane(&places);
    let miss = largest(places.iter().zip(&images).map(|(z, w)| (w - exact(*z)).norm() / (1.0 + exact(*z).norm_sqr())));
    assert!(miss < 1e-12, "{miss:e}");
    let back = map.from_half_plane(&images);
    assert!(largest(back.iter().zip(&places).map(|(a, b)| (a - b).norm())) < 1e-10);
    // Both corners as ends: 2 log((1 + z)/(1 − z))/π, up to where the strip begins to be counted.
    let map = StripMap::solve(&region, [c(-1.0, 0.0), c(1.0, 0.0)], &options(1e-12), &mut |_, _| true).unwrap();
    let images = map.to_strip(&places);
    let exact: Vec<Complex64> = places.iter().map(|z| lifted(*z).ln() / PI).collect();
    let shift = images[0] - exact[0];
    let miss = largest(images.iter().zip(&exact).map(|(w, exact)| (w - exact - shift).norm()));
    assert!(miss < 1e-11 && shift.im.abs() < 1e-12, "{miss:e} {shift}");
    let back = map.from_strip(&images);
    assert!(largest(back.iter().zip(&places).map(|(a, b)| (a - b).norm())) < 1e-10);
}
