//! Quadrilaterals against closed forms.

use super::{options, toolbox};
use crate::support::random::Random;
use crate::support::{EXACT_CASES, c, case, largest, points, polygon, share, spread_points};
use conformal_warp::{Complex64, Curve, Error, RectangleMap, Region, RiemannMap, Stop};
use std::f64::consts::{FRAC_PI_2, TAU};

fn solve(region: &Region, corners: [Complex64; 4]) -> RectangleMap {
    RectangleMap::solve(region, corners, &options(1e-12), &mut |_, _| true).unwrap()
}

fn four(corners: &[Complex64]) -> [Complex64; 4] {
    corners.try_into().unwrap()
}

/// a × b, its lower left corner at 0.
fn rectangle(a: f64, b: f64) -> (Region, [Complex64; 4]) {
    let corners = [c(0.0, 0.0), c(a, 0.0), c(a, b), c(0.0, b)];
    (polygon(&corners, c(0.5 * a, 0.5 * b)), corners)
}

/// K(k')/K(k) for k² = χ, by the means.
fn ratio_of_quarters(chi: f64) -> f64 {
    let mean = |mut b: f64| {
        let mut a = 1.0f64;
        for _ in 0..30 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        a
    };
    mean((1.0 - chi).sqrt()) / mean(chi.sqrt())
}

/// The aspect of the disk with corners at four angles: K(k')/K(k), k² the share of the sides that lie upright.
fn aspect_of_disk(angles: [f64; 4]) -> f64 {
    let chord = |i: usize, j: usize| (0.5 * (angles[i] - angles[j])).sin().abs();
    ratio_of_quarters(chord(1, 2) * chord(3, 0) / (chord(0, 2) * chord(1, 3)))
}

#[test]
fn right_trapezoids() {
    for (l, modulus) in [
        (1.5, 0.776_943_410_607_367_97),
        (2.0, 1.279_261_571_171_006_5),
        (2.5, 1.779_359_959_478_044_0),
        (3.0, 2.279_364_207_967_674_7),
    ] {
        let corners = [c(0.0, 0.0), c(1.0, 0.0), c(1.0, l), c(0.0, l - 1.0)];
        let region = polygon(&corners, c(0.5, 0.4 * l));
        let [lies, stands] =
            [corners, [corners[1], corners[2], corners[3], corners[0]]].map(|four| solve(&region, four));
        let errors = [lies.aspect() * modulus - 1.0, stands.aspect() / modulus - 1.0];
        println!("L = {l}: errors {errors:?}, estimate {:.1e}", lies.error_estimate());
        assert!(errors.iter().all(|error| error.abs() < 1e-12), "L = {l}: {errors:?}");
        assert_eq!(lies.stop(), Stop::Tolerance);
    }
}

/// A rectangle goes to itself: at every place, its corners and walls included, and however long it is.
#[test]
fn rectangles_stay_what_they_are() {
    for (a, b) in [(1.0, 1.0), (2.0, 1.0), (1.0, 2.0), (0.5, 10.0), (20.0, 1.0), (40.0, 1.0)] {
        let (region, corners) = rectangle(a, b);
        let map = solve(&region, corners);
        let aspect = a / b;
        let error = (map.aspect() / aspect - 1.0).abs();
        let mut places = spread_points(&region, 300);
        for size in [1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 0.0] {
            let inwards = |corner: &Complex64| {
                let in_x = if corner.re == 0.0 { size } else { -size };
                let in_y = if corner.im == 0.0 { size } else { -size };
                [c(in_x, in_y), c(in_x, 0.3 * in_y), c(in_x, 0.0), c(0.0, in_y)].map(|by| corner + by)
            };
            places.extend(corners.iter().flat_map(inwards));
        }
        let along = |k: usize| share(k, 0.618_033_988_749_895);
        places.extend(
            (0..40).flat_map(|k| [c(a * along(k), 0.0), c(a * along(k), b), c(0.0, b * along(k)), c(a, b * along(k))]),
        );
        let images = map.to_rectangle(&places);
        let off = largest(images.iter().zip(&places).map(|(w, z)| (w - z / b).norm())) / aspect.min(1.0);
        let exact: Vec<Complex64> = places.iter().map(|z| z / b).collect();
        let back = map.from_rectangle(&exact);
        let back_off = largest(back.iter().zip(&places).map(|(back, z)| (back - z).norm())) / a.min(b);
        let slopes = map.derivative(&places);
        let bent = largest(slopes.iter().map(|slope| (slope * b - 1.0).norm()));
        println!(
            "{a} × {b}: aspect {error:.1e}, there {off:.1e}, back {back_off:.1e}, slope {bent:.1e}, estimate {:.1e}, {} charts",
            map.error_estimate(),
            map.disk().charts()
        );
        let length = aspect.max(1.0 / aspect);
        assert!(error < 1e-13 * length.max(10.0) && error <= map.error_estimate(), "{a} × {b}: aspect {error:e}");
        assert!(off < 5e-12 * length && off <= map.error_estimate(), "{a} × {b}: there {off:e}");
        assert!(back_off < 5e-12 * length, "{a} × {b}: back {back_off:e}");
        assert!(bent < 1e-7, "{a} × {b}: slope {bent:e}");
    }
}

#[test]
fn outside_there_is_nothing() {
    let (region, corners) = rectangle(2.0, 1.0);
    let map = solve(&region, corners);
    let outside = [c(-0.1, 0.5), c(2.1, 0.5), c(1.0, -0.01), c(f64::NAN, 0.0), c(f64::INFINITY, 0.0)];
    assert!(map.to_rectangle(&outside).iter().all(|w| w.is_nan()));
    assert!(map.from_rectangle(&outside).iter().all(|z| z.is_nan()));
}

/// Corners anywhere on a circle, which is smooth there, and on the sides of polygons that are known exactly.
#[test]
fn corners_need_not_be_vertices() {
    let circle: Vec<Complex64> = (0..32).map(|k| Complex64::cis(TAU * f64::from(k) / 32.0)).collect();
    let disk = Region::new(&circle, Curve::Smooth, c(0.2, -0.1), Complex64::ONE).unwrap();
    let map = RiemannMap::solve(&disk, &options(1e-12), &mut |_, _| true).unwrap();
    for angles in [[0.1, 1.7, 3.2, 4.9], [-0.3, 0.1, 2.9, 3.0], [0.0, 0.3, 0.6, 5.0]] {
        let corners = angles.map(Complex64::cis);
        let rectangle = RectangleMap::of(&map, corners).unwrap();
        let exact = aspect_of_disk(angles);
        let error = (rectangle.aspect() / exact - 1.0).abs();
        assert!(error < 1e-12 && error <= rectangle.error_estimate(), "{angles:?}: {error:e}");
        let turned = RectangleMap::of(&map, [corners[1], corners[2], corners[3], corners[0]]).unwrap();
        assert!((rectangle.aspect() * turned.aspect() - 1.0).abs() < 1e-13);
        let inside: Vec<Complex64> = (0..40).map(|k| Complex64::from_polar(0.95, 0.16 * f64::from(k))).collect();
        let images = rectangle.to_rectangle(&inside);
        let back = rectangle.from_rectangle(&images);
        assert!(largest(back.iter().zip(&inside).map(|(a, b)| (a - b).norm())) < 1e-10);
        for (z, slope) in inside.iter().zip(rectangle.derivative(&inside)) {
            let [before, after] = [z - 1e-6, z + 1e-6].map(|z| rectangle.to_rectangle(&[z])[0]);
            assert!(((after - before) / 2e-6 - slope).norm() < 1e-7 * slope.norm().max(1.0), "{z}");
        }
    }
    // By symmetry: the middles of a square's sides.
    let (square, _) = rectangle(1.0, 1.0);
    let map = solve(&square, [c(0.5, 0.0), c(1.0, 0.5), c(0.5, 1.0), c(0.0, 0.5)]);
    assert!((map.aspect() - 1.0).abs() < 1e-12);
}

/// Polygons from the Schwarz–Christoffel integral: every choice of four vertices has the aspect that their angles give.
#[test]
fn vertices_of_exact_polygons() {
    let mut random = Random::new(27);
    for name in EXACT_CASES {
        let exact = case(name);
        let region = exact.region();
        for tolerance in [1e-6, 1e-10] {
            let map = RiemannMap::solve(&region, &options(tolerance), &mut |_, _| true).unwrap();
            let count = exact.angles.len();
            let mut tried = 0;
            while tried < 12 {
                let mut chosen: Vec<usize> =
                    (0..4).map(|_| (random.between(0.0, count as f64) as usize).min(count - 1)).collect();
                chosen.sort_unstable();
                chosen.dedup();
                if chosen.len() < 4 {
                    continue;
                }
                tried += 1;
                let corners = four(&chosen.iter().map(|&k| region.boundary()[k]).collect::<Vec<_>>());
                let angles = chosen.iter().map(|&k| exact.angles[k]).collect::<Vec<f64>>().try_into().unwrap();
                match RectangleMap::of(&map, corners) {
                    Ok(rectangle) => {
                        let error = (rectangle.aspect() / aspect_of_disk(angles) - 1.0).abs();
                        // The fixtures are good to 1e-13 themselves.
                        assert!(
                            error <= rectangle.error_estimate() + 1e-11,
                            "{name} {chosen:?}: {error:e}, estimate {:e}",
                            rectangle.error_estimate()
                        );
                    }
                    Err(error) => assert_eq!(error.code(), "inaccurate", "{name} {chosen:?}"),
                }
            }
        }
    }
}

/// What lies in four far arms, and beside a neck.
#[test]
fn far_corners_go_there_and_back() {
    let cross = points(&[
        [0.5, -0.5],
        [9.0, -0.5],
        [9.0, 0.5],
        [0.5, 0.5],
        [0.5, 9.0],
        [-0.5, 9.0],
        [-0.5, 0.5],
        [-9.0, 0.5],
        [-9.0, -0.5],
        [-0.5, -0.5],
        [-0.5, -9.0],
        [0.5, -9.0],
    ]);
    let region = polygon(&cross, c(0.1, 0.0));
    // One corner in every arm: symmetric.
    let map = solve(&region, [c(-9.0, 0.0), c(0.0, -9.0), c(9.0, 0.0), c(0.0, 9.0)]);
    assert!((map.aspect() - 1.0).abs() < 1e-12, "{:e}", map.aspect() - 1.0);
    // Two in each of two: by symmetry the way is that from one end to the other.
    let ends = [c(-9.0, -0.5), c(9.0, -0.5), c(9.0, 0.5), c(-9.0, 0.5)];
    let long = solve(&region, ends);
    let turned = solve(&region, [ends[1], ends[2], ends[3], ends[0]]);
    assert!((long.aspect() * turned.aspect() - 1.0).abs() < 1e-12);
    assert!(long.aspect() > 17.0 && long.aspect() < 18.0, "{}", long.aspect());
    let z: Vec<Complex64> = (0..60).map(|k| c(-8.9 + 0.3 * f64::from(k), 0.4 * (f64::from(k) * 0.7).sin())).collect();
    for map in [&long, &turned] {
        let back = map.from_rectangle(&map.to_rectangle(&z));
        let off = largest(back.iter().zip(&z).map(|(a, b)| (a - b).norm()));
        assert!(off < 1e-10, "{off:e}");
    }
}

/// SC Toolbox, tests/testRectangle.m: theirs is [−K, K] × [0, K'], of the corners 4, 1, 2, 3.
#[test]
fn toolbox_rectangle() {
    let region = toolbox();
    let corners = [3, 0, 1, 2].map(|k| points(&[[4.0, 0.0], [0.0, 2.0], [-2.0, 4.0], [-3.0, 0.0]])[k]);
    let map = solve(&region, corners);
    let places = points(&[
        [3.641_550_444_027_862, -0.358_449_555_972_138],
        [-0.005_336_970_451_055, 1.988_135_598_448_822],
        [-1.643_459_212_104_280, 0.428_597_577_267_735],
        [1.646_072_527_976_422, -1.929_214_505_595_285],
    ]);
    let theirs = points(&[[1.5, 0.0], [1.4, 3.0], [-0.6, 1.0], [1.0, 0.0]]);
    // The 1e-10 by which printed points may lie outside.
    let places: Vec<Complex64> = places.iter().map(|z| z * (1.0 - 1e-11)).collect();
    let ours = map.to_rectangle(&places);
    let scale = (theirs[1] - theirs[2]) / (ours[1] - ours[2]);
    assert!(scale.im.abs() < 1e-7, "{scale}");
    for (a, b) in ours.iter().zip(&theirs) {
        let moved = b - a * scale;
        // The left side lies at −K, K = aspect · K'/2.
        assert!((moved + 0.5 * map.aspect() * scale).norm() < 1e-6, "{a} {b}: {moved}");
    }
    // K' of the aspect.
    let chi = {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            // K'/K = 2/aspect.
            if ratio_of_quarters(middle) > 2.0 / map.aspect() { low = middle } else { high = middle }
        }
        low
    };
    let height = FRAC_PI_2 / {
        let (mut a, mut b) = (1.0f64, chi.sqrt());
        for _ in 0..30 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        a
    };
    assert!((scale.re - height).abs() < 1e-6, "{scale} {height}");
}

#[test]
fn corners_that_make_no_quadrilateral_are_refused() {
    let (region, [a, b, c3, d]) = rectangle(2.0, 1.0);
    let map = RiemannMap::solve(&region, &options(1e-8), &mut |_, _| true).unwrap();
    let code = |corners| RectangleMap::of(&map, corners).unwrap_err();
    assert_eq!(
        code([a, d, c3, b]).to_string(),
        "A rectangle map is not possible: the marked boundary points do not follow each other counter-clockwise."
    );
    assert_eq!(code([a, c3, b, d]).code(), "invalid-map");
    assert_eq!(code([a, b, b, d]).code(), "invalid-map");
    assert_eq!(code([a, b, c(f64::NAN, 0.0), d]).code(), "not-finite");
    let (long, ends) = rectangle(2.0, 1.0);
    let near =
        RectangleMap::solve(&long, [ends[0], ends[0] + 1e-14, ends[2], ends[3]], &options(1e-8), &mut |_, _| true);
    assert!(
        matches!(near, Err(Error::Inaccurate { .. } | Error::Crowded { .. } | Error::InvalidMap { .. })),
        "{near:?}"
    );
}
