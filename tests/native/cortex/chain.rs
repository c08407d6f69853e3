//! The whole chain visual field → half disk → disk → outline, with Symm's map of an outline whose answer is known: the
//! image of the half disk under a dipole.

use crate::support::{largest, solve};
use conformal_warp::{
    Complex64, Compose, CorticalModel, Curve, FieldPoint, Frame, Hemisphere, InvertibleMap, Jet, Landmark, Light,
    Moebius, OutlineView, PlaneMap, Region, RetinoCorticalMap, RiemannMap, Texture, VisualCortex, Warp, WarpOptions,
    Wrap,
};

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
    let found = jets(&chain(vertices, 1e-11), &field());
    let millimetres = found.iter().zip(&exact).map(|(found, exact)| (found.value - exact.value).norm());
    let magnifications = found.iter().zip(&exact).map(|(found, exact)| (found.dz / exact.dz).norm() - 1.0);
    [largest(millimetres), largest(magnifications.map(f64::abs))]
}

/// Half disk → cortex, through Symm's map of an outline of so many vertices, solved to a tolerance.
fn chain(vertices: usize, tolerance: f64) -> RetinoCorticalMap<RiemannMap> {
    let field = FieldPoint::BLIND_SPOT.coordinate();
    let landmark = CorticalModel::POLIMENI_2006.landmark(field);
    let outline = CorticalModel::POLIMENI_2006.outline(vertices);
    assert_eq!(outline.len(), vertices);
    let region = Region::new(&outline, Curve::Polygon, landmark.cortex, outline[0]).expect("the outline is simple");
    RetinoCorticalMap::new(solve(&region, tolerance), landmark).expect("the blind spot is inside")
}

#[test]
fn symm_agrees_with_the_closed_form() {
    let counts = [100, 200, 400, 800, 1600];
    let found = counts.map(errors);
    let [millimetres, magnification] = found[2];
    assert!(millimetres < 1e-5 && magnification < 1e-4, "{found:?}");
    // At least as the square of the edge length, in fact as its cube: the edges lie as much inside the curve as outside.
    for pair in found.windows(2) {
        assert!(pair[1][0] < pair[0][0] / 4.0, "{found:?}");
    }
}

/// Of the closed form: its area, its length along the horizontal meridian, and the share within 15°; of the chain from its
/// outline the same, by integration over the field.
#[test]
fn areas_and_extents_are_those_of_the_dipole() {
    let exact = CorticalModel::POLIMENI_2006;
    let map = chain(400, 1e-8);
    let area = |within: f64| {
        // ∫ |f'|² over the half disk, r + a evenly in its logarithm, in the unit of 90°.
        let (n, a) = (200, 0.69 / 90.0);
        let steps = (within / 90.0 / a).ln_1p() / f64::from(n);
        let radius = |i: f64| a * (steps * i).exp_m1();
        let angle = |j: f64| std::f64::consts::PI * (j / f64::from(n) - 0.5);
        let cells = (0..n * n).map(|k| [f64::from(k / n) + 0.5, f64::from(k % n) + 0.5]);
        let points: Vec<Complex64> = cells.map(|[i, j]| Complex64::from_polar(radius(i), angle(j))).collect();
        let ring = |s: &Complex64| s.norm() * (s.norm() + a) * steps * std::f64::consts::PI / f64::from(n);
        jets(&map, &points).iter().zip(&points).map(|(jet, s)| jet.dz.norm_sqr() * ring(s)).sum::<f64>()
    };
    let (whole, central) = (area(90.0), area(15.0));
    assert!((whole / 2253.0 - 1.0).abs() < 0.01 && (central / whole / 0.70 - 1.0).abs() < 0.01);
    assert!((whole / exact.area_within(90.0) - 1.0).abs() < 1e-3);
    // The fovea and the far end of the meridian lie on the outline: just inside.
    let ends = jets(&map, &[Complex64::new(1e-9, 0.0), Complex64::new(1.0 - 1e-9, 0.0)]);
    let length = (ends[1].value - ends[0].value).norm();
    let expected = exact.jet(Complex64::new(90.0, 0.0)).value.re;
    assert!((length / expected - 1.0).abs() < 1e-3, "{length} mm, not {expected}");
}

/// There and back through all three steps, and through each alone.
#[test]
fn the_steps_and_the_chain_invert() {
    let map = chain(400, 1e-8);
    let back = jets(&(&map).inverted(), &jets(&map, &field()).iter().map(|jet| jet.value).collect::<Vec<_>>());
    let whole = largest(back.iter().zip(field()).map(|(back, s)| (back.value - s).norm()));
    let disk: Vec<Complex64> = jets(map.half_disk(), &field()).iter().map(|jet| jet.value).collect();
    let step = |there: Vec<Jet>, back: &dyn Fn(&[Complex64]) -> Vec<Jet>, from: &[Complex64]| {
        let back = back(&there.iter().map(|jet| jet.value).collect::<Vec<_>>());
        largest(back.iter().zip(from).map(|(back, from)| (back.value - from).norm()))
    };
    let half_disk = step(jets(map.half_disk(), &field()), &|z| jets(&map.half_disk().inverted(), z), &field());
    let outline = step(jets(&map.outline().inverted(), &disk), &|z| jets(map.outline(), z), &disk);
    let directions: Vec<FieldPoint> = field().into_iter().map(FieldPoint::from_coordinate).collect();
    let sphere = largest(directions.iter().zip(field()).map(|(point, s)| (point.coordinate() - s).norm()));
    assert!([sphere, half_disk, outline, whole].iter().all(|&error| error < 1e-12));
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
    let found = chain(200, 1e-8).inverted().warp(&texture, &options).expect("a picture");
    let drawn = exact.as_chunks::<4>().0.iter().filter(|pixel| pixel[3] == 255).count();
    assert!(drawn > 10_000, "only {drawn} pixels are drawn");
    let differing = exact.iter().zip(&found).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    // Pixels at the rim, whose share of the cortex is sampled, may differ.
    assert!(differing < 200, "{differing} of {} bytes differ", exact.len());
}

/// An outline as it is seen from outside is the mirror image of the formula's: lower field up.
#[test]
fn an_outline_seen_from_outside_has_the_lower_field_above() {
    let model = CorticalModel::POLIMENI_2006;
    let field = FieldPoint::BLIND_SPOT.coordinate();
    let plain = model.landmark(field);
    let (outline, seen) = (model.outline(160), |w: Complex64| w.conj());
    let cortex_of = |boundary: &[Complex64], landmark: Landmark, view: OutlineView| {
        let region = Region::new(boundary, Curve::Polygon, landmark.cortex, outline[0]).expect("the outline is simple");
        let chain = RetinoCorticalMap::new(solve(&region, 1e-9), landmark).expect("the blind spot is inside");
        VisualCortex::from_view(chain, &region, view, Hemisphere::Left)
    };
    let mirrored = cortex_of(&outline, plain, OutlineView::Mirrored);
    let turned: Vec<Complex64> = outline.iter().copied().map(seen).collect();
    let view = OutlineView::Pial;
    let landmark = Landmark { field: view.coordinate(field), cortex: plain.cortex.conj(), direction: -plain.direction };
    let pial = cortex_of(&turned, landmark, view);
    for z in [(15.0, -1.5), (3.0, 2.0), (40.0, -30.0), (8.0, 20.0)].map(|(x, y)| Complex64::new(x, y)) {
        let (a, b) = (mirrored.jet(z), pial.jet(z));
        assert!((a.value.conj() - b.value).norm() < 1e-5, "{z}: {} and {}", a.value, b.value);
        assert!((a.dz.conj() - b.dzbar).norm() < 1e-5 * a.dz.norm(), "{z}: {a:?} and {b:?}");
        let back = (&pial).inverted().jet(b.value);
        assert!((back.value - z).norm() < 1e-5 * z.norm(), "{z} came back as {}", back.value);
    }
}
