//! The whole chain visual field → half disk → disk → outline, with Symm's map of an outline whose answer is known: the
//! image of the half disk under a dipole.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{largest, solve};
use conformal_warp::map::cortex::{CorticalModel, FieldPoint, Landmark, RetinoCorticalMap};
use conformal_warp::map::{Compose, InvertibleMap, Jet, Moebius, PlaneMap, RiemannMap};
use conformal_warp::plane::{Complex64, Curve, Frame, Region};
use conformal_warp::warp::{Light, Texture, Warp, WarpOptions, Wrap};

fn jets(map: &impl PlaneMap, points: &[Complex64]) -> Vec<Jet> {
    let mut jets = vec![Jet::UNDEFINED; points.len()];
    map.jets(points, &mut jets);
    jets
}

/// Half disk |s| ≤ 1 → cortex in millimetres, 90° being at |s| = 1.
fn truth() -> impl InvertibleMap {
    let degrees = Moebius::new(90.0.into(), Complex64::ZERO, Complex64::ZERO, Complex64::ONE).expect("90 is not 0");
    Compose { outer: CorticalModel::POLIMENI_2006, inner: degrees }
}

/// Points of the half disk from 0.5° to 60°, up to 80° from the horizontal meridian.
fn field() -> Vec<Complex64> {
    let eccentricities = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 60.0];
    let azimuths = [-80.0, -45.0, -10.0, 0.0, 30.0, 65.0, 80.0];
    let point = |e: f64, a: f64| Complex64::from_polar(e / 90.0, f64::to_radians(a));
    eccentricities.iter().flat_map(|&e| azimuths.iter().map(move |&a| point(e, a))).collect()
}

/// The largest errors of the chain from an outline of so many vertices: in millimetres on the cortex, and of the magnification,
/// relative. The blind spot and the direction of the horizontal meridian there are given.
fn errors(vertices: usize) -> [f64; 2] {
    let exact = jets(&truth(), &field());
    let found = jets(&chain(vertices), &field());
    let millimetres = found.iter().zip(&exact).map(|(found, exact)| (found.value - exact.value).norm());
    let magnifications = found.iter().zip(&exact).map(|(found, exact)| (found.dz / exact.dz).norm() - 1.0);
    [largest(millimetres), largest(magnifications.map(f64::abs))]
}

/// Half disk → cortex, through Symm's map of an outline of so many vertices.
fn chain(vertices: usize) -> RetinoCorticalMap<RiemannMap> {
    let field = FieldPoint::BLIND_SPOT.coordinate();
    let known = truth().jet(field);
    let outline = CorticalModel::POLIMENI_2006.outline(vertices);
    assert_eq!(outline.len(), vertices);
    let region = Region::new(&outline, Curve::Polygon, known.value, outline[0]).expect("the outline is simple");
    let landmark = Landmark { field, cortex: known.value, direction: known.dz.arg() };
    RetinoCorticalMap::new(solve(&region, 1e-8), landmark).expect("the blind spot is inside")
}

#[test]
fn symm_agrees_with_the_closed_form() {
    let [coarse, middle, fine] = [100, 200, 400].map(errors);
    println!("100, 200, 400 vertices: {:.1e}, {:.1e}, {:.1e} mm", coarse[0], middle[0], fine[0]);
    println!("magnification: {:.1e}, {:.1e}, {:.1e}", coarse[1], middle[1], fine[1]);
    assert!(fine[0] < 1e-5 && fine[1] < 1e-4, "{fine:?}");
    // At least as the square of the edge length, in fact as its cube: the edges lie as much inside the curve as outside.
    assert!(middle[0] < coarse[0] / 4.0 && fine[0] < middle[0] / 4.0, "{coarse:?}, {middle:?}, {fine:?}");
}

/// The cortical picture itself: the closed form and Symm's chain draw the same pixels.
#[test]
fn both_draw_the_same_picture() {
    let size = 256;
    let pixel = |k: usize| {
        let (x, y) = (k % size, k / size);
        [(x ^ y) as u8, (3 * x) as u8, (2 * y) as u8, 255]
    };
    let rgba: Vec<u8> = (0..size * size).flat_map(pixel).collect();
    let texture = Texture::new(&rgba, size, size, Wrap::Transparent, Light::Linear).expect("the sizes fit");
    let half_disk = Frame::new(Complex64::ZERO, 2.0, [size, size]).expect("a frame");
    let cortex = Frame::new(Complex64::new(40.0, 0.0), 90.0, [240, 160]).expect("a frame");
    let options = WarpOptions::new(half_disk, cortex);
    let exact = truth().inverted().warp(&texture, &options).expect("a picture");
    let found = chain(200).inverted().warp(&texture, &options).expect("a picture");
    let drawn = exact.as_chunks::<4>().0.iter().filter(|pixel| pixel[3] == 255).count();
    assert!(drawn > 10_000, "only {drawn} pixels are drawn");
    let differing = exact.iter().zip(&found).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    // Pixels at the rim, whose share of the cortex is sampled, may differ.
    assert!(differing < 200, "{differing} of {} bytes differ", exact.len());
}
