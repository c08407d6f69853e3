//! The whole chain visual field → half disk → disk → outline, with Symm's map of an outline whose answer is known: the
//! image of the half disk under a dipole.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{largest, solve};
use conformal_warp::map::cortex::{CorticalModel, FieldPoint, HalfDiskMap};
use conformal_warp::map::{Compose, InvertibleMap, Jet, Moebius, PlaneMap, RiemannMap};
use conformal_warp::plane::{Complex64, Curve, Region};

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

/// The outline's map with derivatives by differences of order 4, which is all that is asked of them here.
struct Outline(RiemannMap);

impl PlaneMap for Outline {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        const H: f64 = 1e-3;
        let at = |shift: f64| self.0.to_disk(&points.iter().map(|z| z + shift).collect::<Vec<_>>());
        let [far, near, value, after, beyond] = [-2.0 * H, -H, 0.0, H, 2.0 * H].map(at);
        for (k, jet) in jets.iter_mut().enumerate() {
            let slope = (8.0 * (after[k] - near[k]) - (beyond[k] - far[k])) / (12.0 * H);
            *jet = Jet::analytic(value[k], slope);
        }
    }
}

/// The largest errors of the chain from an outline of so many vertices: in millimetres on the cortex, and of the magnification,
/// relative. The blind spot and the direction of the horizontal meridian there are given.
fn errors(vertices: usize) -> [f64; 2] {
    let truth = truth();
    let landmark = FieldPoint::BLIND_SPOT.coordinate();
    let known = jets(&truth, &[landmark])[0];
    let outline = CorticalModel::POLIMENI_2006.outline(vertices);
    assert_eq!(outline.len(), vertices);
    let region = Region::new(&outline, Curve::Polygon, known.value, outline[0]).expect("the outline is simple");
    let outline = Outline(solve(&region, 1e-8));

    let center = jets(&outline, &[known.value])[0];
    let half_disk = HalfDiskMap::new(landmark, known.dz.arg() + center.dz.arg()).expect("the blind spot is inside");
    let chain = Compose { outer: half_disk.inverted(), inner: outline };
    let exact = jets(&truth, &field());
    let found = jets(&chain, &exact.iter().map(|jet| jet.value).collect::<Vec<_>>());
    let places = field().into_iter().zip(&found).zip(&exact);
    let millimetres = places.map(|((s, found), exact)| (found.value - s).norm() * exact.dz.norm());
    let magnifications = found.iter().zip(&exact).map(|(found, exact)| (found.dz * exact.dz).norm() - 1.0);
    [largest(millimetres), largest(magnifications.map(f64::abs))]
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
