//! Region → region where the regions are so long that their far ends crowd together on the circle.

use crate::support::{c, case, largest, share, solve, spread_points};
use conformal_warp::{Complex64, Curve, Region, RegionMap};
use std::f64::consts::FRAC_PI_2;

/// [−a, a] × [−1, 1] with a center on its axis, and the middle of its right side as `toward`.
fn rectangle(a: f64, center: f64) -> Region {
    let vertices = [c(-a, -1.0), c(a, -1.0), c(a, 1.0), c(-a, 1.0)];
    Region::new(&vertices, Curve::Polygon, c(center, 0.0), c(a, 0.0)).unwrap()
}

/// The fixture with the middle of its right end as `toward`.
fn neck() -> Region {
    let neck = case("neck").region();
    neck.with_center(neck.center(), c(2.5, 0.0)).unwrap()
}

/// Points all over a region, and nearly as many beside its walls.
fn interior_points(region: &Region) -> Vec<Complex64> {
    let beside = (0..2000).map(|k| {
        let (a, b) = region.polygon().edge(k % region.polygon().len());
        let away = 10f64.powf(-9.0 + 7.0 * share(k, 0.324_717_957));
        a + (b - a) * share(k, 0.569_840_290_998) + c(0.0, away) * (b - a) / (b - a).norm()
    });
    spread_points(region, 1500).into_iter().chain(beside.filter(|z| region.contains(*z))).collect()
}

fn distance(a: &[Complex64], b: &[Complex64]) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| (a - b).norm()))
}

#[test]
fn a_map_to_itself_leaves_every_place_alone() {
    for region in [case("neck").region(), case("rect20").region(), neck()] {
        let map = solve(&region, 1e-10);
        assert!(map.charts() > 1);
        let same = RegionMap::between(&map, &map);
        let size = region.polygon().size();
        let z = interior_points(&region);
        assert!(distance(&same.forward(&z), &z) < 1e-9 * size, "{:e}", distance(&same.forward(&z), &z));
        assert!(distance(&same.inverse(&z), &z) < 1e-9 * size);
        for (slope, z) in same.derivative(&z).iter().zip(&z) {
            assert!((slope - 1.0).norm() < 1e-5, "at {z}: {slope}");
        }
    }
}

/// What rectangles of half lengths a and b map to each other, right ends to right ends, if the left ends were infinitely
/// far: sinh(π(b − z')/2) = λ sinh(π(a − z)/2), both sides being maps of a half strip to a half plane. λ takes center to
/// center. The left end changes this by e^(−π·distance from it).
struct Ends {
    from: f64,
    to: f64,
    lambda: f64,
}

impl Ends {
    fn new((from, center): (f64, f64), (to, image): (f64, f64)) -> Self {
        Self { from, to, lambda: (FRAC_PI_2 * (to - image)).sinh() / (FRAC_PI_2 * (from - center)).sinh() }
    }

    fn at(&self, z: Complex64) -> Complex64 {
        // asinh with a positive real part, also on the long sides, which lie on its cut.
        let y = (FRAC_PI_2 * (self.from - z)).sinh() * self.lambda;
        let root = (1.0 + y * y).sqrt();
        let largest = if (y + root).norm() >= (y - root).norm() { y + root } else { y - root };
        self.to - largest.ln() / FRAC_PI_2
    }

    fn derivative(&self, z: Complex64) -> Complex64 {
        let (from, to) = (FRAC_PI_2 * (self.from - z), FRAC_PI_2 * (self.to - self.at(z)));
        self.lambda * from.cosh() / to.cosh()
    }
}

/// Centers 0 and 3 of one rectangle, and rectangles of different length: the far right ends, with `toward` in them, are
/// mapped to each other with the relative accuracy of the places there.
#[test]
fn far_ends_that_hold_toward_correspond() {
    for ((a, center), (b, image)) in
        [((20.0, 0.0), (20.0, 3.0)), ((20.0, 0.0), (10.0, -1.0)), ((10.0, 0.0), (20.0, 0.5))]
    {
        let (from, to) = (solve(&rectangle(a, center), 1e-10), solve(&rectangle(b, image), 1e-10));
        let map = RegionMap::between(&from, &to);
        let (exact, back) = (Ends::new((a, center), (b, image)), Ends::new((b, image), (a, center)));
        let right = |region: &Region, from: f64| {
            interior_points(region).into_iter().filter(|z| z.re > from).collect::<Vec<_>>()
        };
        // A chart is used where |f'| × size is at least 1/20: that is how much errors in the disk can grow in the plane.
        let solved = 20.0 * 20.0 * (from.error_estimate() + to.error_estimate());
        // Where the left ends are too far to matter. What the map stretches it stretches errors of the solves too.
        for z in right(from.region(), center.min(0.0)) {
            let (image, slope) = (map.forward(&[z])[0], exact.derivative(z));
            let error = (image - exact.at(z)).norm();
            assert!(error < 1e-8 + solved * slope.norm(), "{a} → {b} at {z}: {error:e}");
            let ratio = map.derivative(&[z])[0] / slope;
            assert!((ratio - 1.0).norm() < 1e-6 + solved * slope.norm(), "{a} → {b} at {z}: {ratio}");
        }
        for z in right(to.region(), image.min(0.0)) {
            let error = (map.inverse(&[z])[0] - back.at(z)).norm();
            assert!(error < 1e-8 + solved * back.derivative(z).norm(), "{b} → {a} at {z}: {error:e}");
        }
        // The boundary, upper side and right side.
        for z in [c(0.4 * a, 1.0), c(a - 1e-3, 1.0), c(a, 1.0), c(a, 0.999), c(a, 1e-6), c(a, 0.0)] {
            let image = map.boundary_forward(from.region().nearest(z)).point;
            let bound = 1e-8 + solved * exact.derivative(z).norm();
            assert!((image - exact.at(z)).norm() < bound, "{z} goes to {image}, not {}", exact.at(z));
            let again = map.boundary_inverse(to.region().nearest(image)).point;
            // At the corner h' = 0: there the way back has no bound of this kind.
            let bound = 1e-8 + solved / map.derivative(&[z])[0].norm();
            assert!((again - z).norm() < bound, "{z} comes back as {again}");
        }
    }
}

/// The far room of the neck, 1e-16 of the circle seen from its center, and the far end of the rectangle.
#[test]
fn the_far_room_of_the_neck_and_the_far_end_of_the_rectangle() {
    let (rectangle, neck) = (solve(&rectangle(20.0, 0.0), 1e-11), solve(&neck(), 1e-11));
    let map = RegionMap::between(&rectangle, &neck);
    let estimate = rectangle.error_estimate() + neck.error_estimate();
    for (region, there, back) in [
        (neck.region(), map.inverse(&interior_points(neck.region())), true),
        (rectangle.region(), map.forward(&interior_points(rectangle.region())), false),
    ] {
        let z = interior_points(region);
        let again = if back { map.forward(&there) } else { map.inverse(&there) };
        let slopes = map.derivative(if back { &there } else { &z });
        for k in 0..z.len() {
            let slope = if back { slopes[k].norm() } else { 1.0 / slopes[k].norm() };
            let error = (again[k] - z[k]).norm();
            assert!(error < 1e-8 + 2.0 * estimate * slope, "{} → {} → {}", z[k], there[k], again[k]);
        }
    }
    let from = c(2.2, 0.3);
    let away = (map.forward(&map.inverse(&[from]))[0] - from).norm();
    assert!(away < 1e-8, "{away:e}");
}

/// A room of ordinary size has a far end for image: what is told apart there is what its numbers tell apart.
#[test]
fn a_room_goes_to_a_long_region_as_far_as_its_numbers_do() {
    let vertices = [c(-2.0, -0.5), c(0.0, -0.5), c(0.0, 0.5), c(-1.0, 0.5), c(-1.0, 1.5), c(-2.0, 1.5)];
    let l_shape = Region::new(&vertices, Curve::Polygon, c(-1.5, 0.0), c(0.0, 0.0)).unwrap();
    let (l_shape, long) = (solve(&l_shape, 1e-11), solve(&rectangle(20.0, 0.0), 1e-11));
    let map = RegionMap::between(&l_shape, &long);
    let mut z = interior_points(l_shape.region());
    z.extend((1..12).map(|k| c(-(10f64.powi(-k)), 10f64.powi(-k))));
    let there = map.forward(&z);
    assert!(there.iter().all(|z| long.region().contains(*z)));
    assert!(distance(&map.inverse(&there), &z) < 1e-8);
    let far = interior_points(long.region());
    let back = map.inverse(&far);
    for (k, slope) in map.derivative(&back).iter().enumerate() {
        let error = (map.forward(&[back[k]])[0] - far[k]).norm();
        assert!(
            error < 1e-8 + (l_shape.error_estimate() + long.error_estimate()) * slope.norm(),
            "{} → {}: {error:e}, slope {slope}",
            far[k],
            back[k]
        );
    }
}
