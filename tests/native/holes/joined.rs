//! Maps between regions through rings, outsides, rectangles, strips and half planes.

use super::{curve, options, square};
use crate::support::{c, largest, polygon};
use conformal_warp::{
    AnnulusMap, Complex64, Curve, Domain, Error, ExteriorMap, HalfPlaneMap, Inverse, Jet, JoinedMap, PlaneMap,
    RectangleMap, RiemannMap, StripMap,
};

fn ring(domain: &Domain) -> AnnulusMap {
    AnnulusMap::solve(domain, &options(1e-12), &mut |_, _| true).unwrap()
}

fn frame(half: f64) -> AnnulusMap {
    ring(&Domain::new(&square(1.0), &[square(half)], Curve::Polygon).unwrap())
}

/// Rings and their images by a Möbius map without a pole in them: the map between must be that map.
#[test]
fn rings_that_are_images_of_each_other() {
    let moebius = |z: Complex64| (z + c(0.2, 0.1)) / (1.0 + c(0.2, -0.1) * z);
    let circle = |center: Complex64, radius: f64| curve(64, move |t| center + Complex64::from_polar(radius, t));
    let image = |points: &[Complex64]| points.iter().map(|z| moebius(*z)).collect::<Vec<_>>();
    let domain = |outer: &[Complex64], hole: Vec<Complex64>| {
        let toward = outer[0];
        Domain::new(outer, &[hole], Curve::Smooth).unwrap().with_toward(toward).unwrap()
    };
    let (outer, hole) = (circle(c(0.0, 0.0), 1.0), circle(c(0.3, 0.0), 0.4));
    let a = ring(&domain(&outer, hole.clone()));
    let b = ring(&domain(&image(&outer), image(&hole)));
    let map = JoinedMap::between(a.clone(), b.clone()).unwrap();
    assert!(map.is_analytic());
    let z: Vec<Complex64> = (0..50).map(|k| Complex64::from_polar(0.72 + 0.005 * f64::from(k), f64::from(k))).collect();
    let images = map.forward(&z);
    let off = largest(images.iter().zip(&z).map(|(w, z)| (w - moebius(*z)).norm()));
    assert!(off < 1e-10, "{off:e}");
    let back = largest(map.inverse(&images).iter().zip(&z).map(|(back, z)| (back - z).norm()));
    assert!(back < 1e-10, "{back:e}");
    for (slope, z) in map.derivative(&z).iter().zip(&z) {
        let exact = 0.95 / (1.0 + c(0.2, -0.1) * z).powi(2);
        assert!((slope - exact).norm() < 1e-9, "{slope} {exact}");
    }
    assert!(map.forward(&[c(0.3, 0.0), c(2.0, 0.0)]).iter().all(|w| w.is_nan()));
}

#[test]
fn rings_of_different_modulus_are_stretched_or_refused() {
    let (thin, thick) = (frame(0.5), frame(0.25));
    let refused = JoinedMap::between(thin.clone(), thick.clone()).unwrap_err();
    assert!(
        matches!(refused, Error::DifferentModuli { first, second, .. } if first == thin.modulus() && second == thick.modulus())
    );
    assert_eq!(
        refused.to_string(),
        "Rings of different modulus cannot be joined conformally: theirs are 1.8477090112 and 3.6582849992. Make them equal, or let one be stretched onto the other, which is not conformal."
    );
    let map = JoinedMap::stretching(thin, thick).unwrap();
    assert!(!map.is_analytic());
    // Boundaries to boundaries, corners to corners; a derivative both ways.
    // The way back beside a corner of the outer square is conditioned like √ε.
    for (half, to, bound) in [(1.0, 1.0, 1e-6), (0.5, 0.25, 1e-9)] {
        for (w, exact) in map.forward(&square(half)).iter().zip(square(to)) {
            assert!((w - exact).norm() < bound, "{w} {exact}");
        }
    }
    let h = 1e-6;
    for k in 0..20 {
        let z = Complex64::from_polar(0.75 + 0.01 * f64::from(k), 0.9 * f64::from(k));
        let jet = map.jet(z);
        for step in [c(h, 0.0), c(0.0, h)] {
            let difference = map.forward(&[z + step])[0] - map.forward(&[z - step])[0];
            let by_jet = 2.0 * (jet.dz * step + jet.dzbar * step.conj());
            assert!((difference - by_jet).norm() < 1e-6 * h.max(by_jet.norm()), "{z}: {difference} {by_jet}");
        }
        assert!(jet.dzbar.norm() > 0.05 && jet.dzbar.norm() < jet.dz.norm());
        let back: Jet = Inverse(&map).jet(jet.value);
        assert!((back.value - z).norm() < 1e-10);
        // The product of both is the identity.
        let both = back.after(&jet);
        assert!((both.dz - 1.0).norm() < 1e-7 && both.dzbar.norm() < 1e-7, "{both:?}");
    }
}

#[test]
fn outsides_rectangles_strips_and_half_planes() {
    let outside = |points: Vec<Complex64>, kind| {
        ExteriorMap::solve(&Domain::exterior(&[points], kind).unwrap(), &options(1e-12), &mut |_, _| true).unwrap()
    };
    // Circle to ellipse: Joukowski's map.
    let a = outside(curve(32, Complex64::cis), Curve::Smooth);
    let b = outside(curve(64, |t| c(1.5 * t.cos(), 0.5 * t.sin())), Curve::Smooth);
    let map = JoinedMap::between(a, b).unwrap();
    for k in 0..20 {
        let z = Complex64::from_polar(1.0 + 0.2 * f64::from(k), 0.7 * f64::from(k));
        let exact = z + 0.5 / z;
        assert!((map.forward(&[z])[0] - exact).norm() < 1e-10 * exact.norm(), "{z}");
    }
    // A rectangle and one twice as large that stands.
    let corners = [c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(0.0, 1.0)];
    let large = corners.map(|z| c(5.0, 0.0) + z * c(0.0, 2.0));
    let solve = |corners: [Complex64; 4], first: usize| {
        let region = polygon(&corners, corners.iter().sum::<Complex64>() / 4.0);
        let marked = std::array::from_fn(|k| corners[(first + k) % 4]);
        RectangleMap::solve(&region, marked, &options(1e-12), &mut |_, _| true).unwrap()
    };
    let map = JoinedMap::between(solve(corners, 0), solve(large, 0)).unwrap();
    for z in [c(0.3, 0.7), c(1.9, 0.01), corners[2]] {
        let exact = c(5.0, 0.0) + z * c(0.0, 2.0);
        assert!((map.forward(&[z])[0] - exact).norm() < 1e-10, "{z}");
    }
    let error = JoinedMap::between(solve(corners, 0), solve(corners, 1)).unwrap_err();
    assert_eq!(error.code(), "different-moduli");
    let stretched = JoinedMap::stretching(solve(corners, 0), solve(corners, 1)).unwrap();
    assert!((stretched.forward(&[c(1.0, 0.5)])[0] - c(1.0, 0.5)).norm() < 1e-10);
    let jet = stretched.jet(c(0.4, 0.3));
    // (x, y) → (2 − 2y, x/2).
    assert!((jet.value - c(1.4, 0.2)).norm() < 1e-10 && (jet.dzbar - c(0.0, -0.75)).norm() < 1e-9, "{jet:?}");
    // Through strips and half planes a square goes to itself, turned.
    let square = square(1.0);
    let region = polygon(&square, Complex64::ZERO);
    let map = RiemannMap::solve(&region, &options(1e-12), &mut |_, _| true).unwrap();
    let turned = [
        JoinedMap::between(HalfPlaneMap::of(&map, square[0]).unwrap(), HalfPlaneMap::of(&map, square[1]).unwrap()),
        JoinedMap::between(
            StripMap::of(&map, [square[0], square[2]]).unwrap(),
            StripMap::of(&map, [square[1], square[3]]).unwrap(),
        ),
        JoinedMap::between(map.clone(), map.with_center(Complex64::ZERO, square[1], &mut |_, _| true).unwrap()),
    ];
    for map in turned {
        let z = c(0.9, -0.35);
        assert!((map.unwrap().forward(&[z])[0] - z * Complex64::I).norm() < 1e-10);
    }
    assert_eq!(JoinedMap::between(frame(0.5), map).unwrap_err().code(), "invalid-map");
}

/// Per pixel, as pictures are warped: the view of a ring shows the other's picture where it belongs.
#[test]
fn pictures_go_through_rings() {
    use conformal_warp::{Direction, Frame, Light, Texture, Warp, WarpOptions, Wrap};
    let map = JoinedMap::stretching(frame(0.5), frame(0.25)).unwrap();
    // The upper half is red, the lower half green: symmetric in x, so it stays.
    let (red, green) = ([255, 0, 0, 255], [0, 255, 0, 255]);
    let pixels = [red.repeat(8).repeat(4), green.repeat(8).repeat(4)].concat();
    let texture = Texture::new(&pixels, 8, 8, Wrap::Clamp, Light::Linear).unwrap();
    let frame = Frame::new(Complex64::ZERO, 2.0, [64, 64]).unwrap();
    // Larger than the region, since pictures fade at their edges.
    let picture = Frame::new(Complex64::ZERO, 4.0, [8, 8]).unwrap();
    let options = WarpOptions { direction: Direction::PushForward, ..WarpOptions::new(picture, frame) };
    let warped = map.warp(&texture, &options).unwrap();
    let at = |x: usize, y: usize| &warped[4 * (64 * y + x)..4 * (64 * y + x) + 4];
    assert_eq!(at(32, 5), red);
    assert_eq!(at(32, 58), green);
    // Between the holes' walls, where only the target has a ring.
    assert_eq!(at(32, 18), red);
    assert_eq!(at(32, 32)[3], 0, "the hole");
}
