//! Symm's map on boundaries of arcs and Bézier curves, against exact answers.

use crate::support::{angle_error, c, exact, largest, polygon, solve, spread_points};
use conformal_warp::{ArcTo, Complex64, Edge, EllipticArc, Region, RiemannMap, SolveOptions, Stop};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

const ORIGIN: Complex64 = Complex64::new(0.0, 0.0);

fn region(edges: &[Edge], center: Complex64) -> Region {
    Region::from_edges(edges, center, edges[0].from()).unwrap()
}

fn half_disk() -> [Edge; 2] {
    [Edge::line(c(-1.0, 0.0), c(1.0, 0.0)), Edge::circular(ORIGIN, 1.0, 0.0, PI)]
}

/// Between two circles through ±1 that meet there at `angle`; the upper arc first, from 1.
fn lens(angle: f64) -> [Edge; 2] {
    let half = 0.5 * angle;
    [1.0, -1.0].map(|sign| {
        let center = c(0.0, -sign / half.tan());
        Edge::circular(center, 1.0 / half.sin(), (c(sign, 0.0) - center).arg(), angle)
    })
}

fn circle(count: u32) -> Vec<Edge> {
    let turn = TAU / f64::from(count);
    (0..count).map(|k| Edge::circular(ORIGIN, 1.0, turn * f64::from(k), turn)).collect()
}

/// The regular tile {p, q} around 0: hyperbolic in the unit disk, or spherical in stereographic coordinates.
fn tile(p: u32, q: u32) -> Vec<Edge> {
    let phi = PI / f64::from(p);
    let ratio = (PI / f64::from(q)).cos() / phi.sin();
    let hyperbolic = ratio > 1.0;
    // The circle that holds an edge crosses the real axis at the edge's middle, and where its geometry says.
    let middle = if hyperbolic { (0.5 * ratio.acosh()).tanh() } else { (0.5 * ratio.acos()).tan() };
    let sign = if hyperbolic { 1.0 } else { -1.0 };
    let center = 0.5 * (middle + sign / middle);
    let radius = (middle - center).abs();
    let vertex = center * phi.cos() - sign * ((center * phi.cos()).powi(2) - sign).sqrt();
    let half = (vertex * phi.sin()).atan2((center - vertex * phi.cos()).abs());
    let arc = |k: u32| {
        let turn = 2.0 * phi * f64::from(k);
        let start = if hyperbolic { half - PI } else { -half };
        Edge::circular(Complex64::from_polar(center, turn), radius, start + turn, -sign * 2.0 * half)
    };
    (0..p).map(arc).collect()
}

/// Largest errors of f, of the way back (measured in the disk) and of f' at points.
pub(super) fn errors_of(
    map: &RiemannMap,
    points: &[Complex64],
    exact: impl Fn(Complex64) -> (Complex64, Complex64),
) -> [f64; 3] {
    let truth: Vec<_> = points.iter().map(|z| exact(*z)).collect();
    let images: Vec<_> = truth.iter().map(|(w, _)| *w).collect();
    let (there, back, slopes) = (map.to_disk(points), map.from_disk(&images), map.derivative(points));
    let forth = largest(there.iter().zip(&images).map(|(f, w)| (f - w).norm()));
    let back =
        largest(back.iter().zip(points).zip(&truth).map(|((z, exact), (_, slope))| (z - exact).norm() * slope.norm()));
    let slopes = largest(slopes.iter().zip(&truth).map(|(f, (_, slope))| (f - slope).norm() / (1.0 + slope.norm())));
    [forth, back, slopes]
}

#[test]
fn conformal_radii_of_regions_of_arcs() {
    let quarter =
        [Edge::line(ORIGIN, c(1.0, 0.0)), Edge::circular(ORIGIN, 1.0, 0.0, FRAC_PI_2), Edge::line(c(0.0, 1.0), ORIGIN)];
    let mut cases = vec![
        ("half disk".to_string(), half_disk().to_vec(), c(0.0, 0.5), 0.6),
        ("quarter disk".to_string(), quarter.to_vec(), Complex64::from_polar(0.5, FRAC_PI_4), 15.0 / 34.0),
    ];
    for tenths in 1..20 {
        let share = 0.1 * f64::from(tenths);
        cases.push((format!("lens of {share:.1} π"), lens(share * PI).to_vec(), ORIGIN, share));
    }
    for share in [0.03, 1.97] {
        cases.push((format!("lens of {share} π"), lens(share * PI).to_vec(), ORIGIN, share));
    }
    let tiles = [
        (4, 5, 0.281_976_783_418_340_95),
        (4, 6, 0.347_204_318_714_071_02),
        (5, 4, 0.322_067_763_534_003_5),
        (7, 3, 0.274_550_156_103_637_3),
        (3, 7, 0.159_784_547_370_969_72),
        (6, 4, 0.434_884_719_099_858_44),
        (8, 3, 0.374_652_893_620_176_95),
        (3, 4, 0.353_553_390_593_273_76),
        (4, 3, 0.438_691_337_650_830_82),
        (3, 3, 0.561_231_024_154_686_5),
        (3, 5, 0.207_578_163_111_242_69),
        (5, 3, 0.297_100_409_661_000_56),
    ];
    for (p, q, radius) in tiles {
        cases.push((format!("tile {{{p}, {q}}}"), tile(p, q), ORIGIN, radius));
    }
    for (name, edges, center, radius) in cases {
        let map = solve(&region(&edges, center), 1e-12);
        let error = (map.conformal_radius() / radius - 1.0).abs();
        assert!(map.error_estimate() <= 1e-12, "{name}: estimate {:e}", map.error_estimate());
        assert!(error < 1e-12 && error <= map.error_estimate(), "{name}: {error:e}");
    }
}

#[test]
fn half_disk_everywhere() {
    let map = solve(&region(&half_disk(), c(0.0, 0.5)), 1e-12);
    // z ↦ ((1+z)/(1−z))² goes to the upper half plane, −1 to 0.
    let lift = |z: Complex64| {
        let (u, slope) = ((1.0 + z) / (1.0 - z), 2.0 / ((1.0 - z) * (1.0 - z)));
        (u * u, 2.0 * u * slope)
    };
    let a = lift(c(0.0, 0.5)).0;
    let exact = |z: Complex64| {
        let ((h, slope), turn) = (lift(z), a.conj() / a);
        (turn * (h - a) / (h - a.conj()), turn * slope * (a - a.conj()) / ((h - a.conj()) * (h - a.conj())))
    };
    let radii = [1e-9, 0.01, 0.3, 0.7, 0.95, 0.999, 1.0 - 1e-7, 1.0 - 1e-13];
    let angles = [1e-13, 1e-8, 1e-4, 0.02, 0.3, 1.0, 1.6, 2.5, 3.1, PI - 1e-6];
    let points: Vec<_> = radii.iter().flat_map(|r| angles.map(|angle| Complex64::from_polar(*r, angle))).collect();
    let [forth, back, _] = errors_of(&map, &points, exact);
    assert!(forth < 1e-12 && forth <= map.error_estimate(), "{forth:e}");
    assert!(back < 1e-12 && back <= map.error_estimate(), "{back:e}");
    // The map is known to rounding, so its derivative beside a corner to rounding over the distance from there.
    let there = map.derivative(&points);
    let slopes =
        points.iter().zip(there).map(|(z, f)| (f - exact(*z).1).norm() * (z - 1.0).norm().min((z + 1.0).norm()));
    let slope = largest(slopes);
    assert!(slope < 1e-12, "{slope:e}");
    let outside = [c(0.0, -1e-9), c(0.9, 0.6), c(0.0, 1.0 + 1e-9), c(-1.1, 0.0), c(f64::NAN, 0.0)];
    assert!(map.to_disk(&outside).iter().all(|w| w.is_nan()));
    // The walls themselves, both ways.
    let walls: Vec<_> = [0.1, 0.9, 2.0, 3.1]
        .map(Complex64::cis)
        .into_iter()
        .chain([-0.999, -0.4, 0.0, 0.7].map(|x| c(x, 0.0)))
        .collect();
    let [forth, back, slope] = errors_of(&map, &walls, exact);
    assert!(forth < 1e-12 && back < 1e-12 && slope < 1e-10, "{forth:e} {back:e} {slope:e}");
}

#[test]
fn lenses_everywhere() {
    for share in [0.1, 0.4, 0.75, 1.0, 1.5, 1.9] {
        let map = solve(&region(&lens(share * PI), ORIGIN), 1e-12);
        let exact = |z: Complex64| {
            let u = (1.0 + z) / (1.0 - z);
            let power = u.powf(1.0 / share);
            let slope = power / u / share * 2.0 / ((1.0 - z) * (1.0 - z));
            ((power - 1.0) / (power + 1.0), slope * 2.0 / ((power + 1.0) * (power + 1.0)))
        };
        let mut points = Vec::new();
        // Along circles through both tips, at all depths.
        for turn in [0.0, 0.3, 0.9, 0.99, 0.9999, 1.0 - 1e-8] {
            for size in [-5.0, -1.0, 0.0, 0.5, 2.0, 4.0] {
                let u = Complex64::from_polar(f64::exp(size), 0.5 * PI * share * turn);
                points.extend([(u - 1.0) / (u + 1.0), ((u - 1.0) / (u + 1.0)).conj()]);
            }
        }
        let [forth, back, slope] = errors_of(&map, &points, exact);
        let estimate = map.error_estimate();
        assert!(
            forth < 1e-12 && back < 1e-12 && forth.max(back) <= estimate,
            "{share}: {forth:e} {back:e} {estimate:e}"
        );
        assert!(slope < 1e-10, "{share}: {slope:e}");
    }
}

#[test]
fn disks_of_arcs_are_disks() {
    for count in [1, 2, 4, 8] {
        for center in [ORIGIN, c(0.3, -0.2), c(0.0, 0.95)] {
            let map = solve(&region(&circle(count), center), 1e-12);
            let turn = (1.0 - center.conj()) / (1.0 - center);
            let exact = |z: Complex64| {
                let below = 1.0 - center.conj() * z;
                (turn * (z - center) / below, turn * (1.0 - center.norm_sqr()) / (below * below))
            };
            let points: Vec<_> = [0.0, 0.5, 0.9, 0.999, 1.0 - 1e-10]
                .iter()
                .flat_map(|r| (0..16).map(move |k| Complex64::from_polar(*r, 0.1 + f64::from(k))))
                .collect();
            let [forth, back, slope] = errors_of(&map, &points, exact);
            let estimate = map.error_estimate();
            assert!(
                forth < 1e-12 && back < 1e-12 && forth.max(back) <= estimate,
                "{count} {center}: {forth:e} {back:e}"
            );
            assert!(slope < 1e-9, "{count} {center}: {slope:e}");
            for (k, angle) in map.angles().iter().enumerate() {
                let w = exact(Complex64::cis(TAU * k as f64 / f64::from(count))).0;
                assert!(angle_error(*angle, w.arg()) < 1e-12, "{count} {center}: vertex {k}");
            }
        }
    }
}

/// More unknowns than a stored matrix serves: products by expansions, and the panels kept for another center.
#[test]
fn a_disk_of_many_arcs_is_a_disk() {
    let map = solve(&region(&circle(100), ORIGIN), 1e-11);
    assert!(map.unknowns() > 2500, "{}", map.unknowns());
    let moved = map.with_center(c(0.4, 0.3), c(1.0, 0.0), &mut |_, _| true).unwrap();
    assert_eq!(moved.unknowns(), map.unknowns());
    for (map, center) in [(&map, ORIGIN), (&moved, c(0.4, 0.3))] {
        let turn = (1.0 - center.conj()) / (1.0 - center);
        let exact = |z: Complex64| {
            let below = 1.0 - center.conj() * z;
            (turn * (z - center) / below, turn * (1.0 - center.norm_sqr()) / (below * below))
        };
        let points: Vec<_> = (0..40).map(|k| Complex64::from_polar(1.0 - 0.8f64.powi(k), f64::from(k))).collect();
        let [forth, back, slope] = errors_of(map, &points, exact);
        let estimate = map.error_estimate();
        assert!(estimate <= 1e-11 && forth.max(back) <= estimate, "{center}: {forth:e} {back:e} {estimate:e}");
        assert!(slope < 1e-9, "{center}: {slope:e}");
    }
}

#[test]
fn ellipse_of_arcs_is_an_ellipse() {
    let arc = |k: u32| Edge::Arc(EllipticArc::new(ORIGIN, c(2.0, 0.0), c(0.0, 1.0), f64::from(k), 1.0));
    let last = Edge::Arc(EllipticArc::new(ORIGIN, c(2.0, 0.0), c(0.0, 1.0), 6.0, TAU - 6.0));
    let edges: Vec<_> = (0..6).map(arc).chain([last]).collect();
    let map = solve(&region(&edges, ORIGIN), 1e-12);
    let points: Vec<_> =
        (0..40).map(|k| 0.999 * share_of(k) * c(2.0 * f64::from(k).cos(), f64::from(k).sin())).collect();
    fn share_of(k: u32) -> f64 {
        (f64::from(k) / 39.0).sqrt()
    }
    let [forth, back, slope] = errors_of(&map, &points, |z| exact::ellipse(2.0, 1.0, z));
    let estimate = map.error_estimate();
    assert!(forth < 1e-12 && back < 1e-12 && forth.max(back) <= estimate, "{forth:e} {back:e} {estimate:e}");
    assert!(slope < 1e-10, "{slope:e}");
}

/// A closed curve as cubic pieces of equal parameters with its tangents at their ends.
fn in_beziers(pieces: u32, curve: impl Fn(f64) -> (Complex64, Complex64)) -> Vec<Edge> {
    let step = TAU / f64::from(pieces);
    let piece = |k: u32| {
        let [(a, along), (b, on)] = [k, (k + 1) % pieces].map(|k| curve(step * f64::from(k)));
        Edge::Cubic([a, a + along * step / 3.0, b - on * step / 3.0, b])
    };
    (0..pieces).map(piece).collect()
}

/// Curves drawn as a few Béziers, which meet smoothly and follow them roughly: each against a finer solve of what was drawn.
#[test]
fn curves_of_four_and_eight_beziers() {
    let power = |a: f64, n: i32| {
        move |t: f64| {
            let z = Complex64::cis(t);
            (z + a * z.powi(n), Complex64::i() * (z + f64::from(n) * a * z.powi(n)))
        }
    };
    let ellipse = |a: f64| move |t: f64| (c(a * t.cos(), t.sin()), c(-a * t.sin(), t.cos()));
    for pieces in [4, 8] {
        let cases = [
            ("z + 0.2 z²", in_beziers(pieces, power(0.2, 2))),
            ("z + 0.1 z⁴", in_beziers(pieces, power(0.1, 4))),
            ("ellipse 2:1", in_beziers(pieces, ellipse(2.0))),
            ("ellipse 5:1", in_beziers(pieces, ellipse(5.0))),
        ];
        for (name, edges) in cases {
            let region = region(&edges, c(0.1, 0.05));
            let finer = solve(&region, 1e-13);
            assert!(finer.error_estimate() <= 1e-12, "{name}: {:e}", finer.error_estimate());
            let points = spread_points(&region, 60);
            let exact = finer.to_disk(&points);
            for tolerance in [1e-4, 1e-8] {
                let map = solve(&region, tolerance);
                let error = largest(map.to_disk(&points).iter().zip(&exact).map(|(a, b)| (a - b).norm()));
                let estimate = map.error_estimate();
                assert!(
                    error <= estimate && estimate <= tolerance,
                    "{name}, {pieces}: {error:e}, estimate {estimate:e}"
                );
            }
        }
    }
    // Of sixteen Béziers an ellipse is one to some digits.
    let drawn = solve(&region(&in_beziers(16, ellipse(2.0)), ORIGIN), 1e-10);
    let miss = (drawn.to_disk(&[c(1.0, 0.2)])[0] - exact::ellipse(2.0, 1.0, c(1.0, 0.2)).0).norm();
    assert!(miss < 1e-4, "{miss:e}");
}

#[test]
fn outlines_need_edges() {
    let error = Region::from_edges(&[], ORIGIN, ORIGIN).unwrap_err();
    assert!(error.code() == "invalid-outline" && error.to_string().contains("no edges"), "{error}");
}

/// The straight edges between corners, the first one written as a curve, so that the chain is not taken for a polygon.
fn nearly_polygon(corners: &[Complex64]) -> Vec<Edge> {
    let line = |k: usize| Edge::line(corners[k], corners[(k + 1) % corners.len()]);
    let (a, b) = (corners[0], corners[1]);
    let first = Edge::Cubic([a, a + (b - a) / 3.0, b - (b - a) / 3.0, b]);
    std::iter::once(first).chain((1..corners.len()).map(line)).collect()
}

#[test]
fn chains_of_lines_are_polygons() {
    let corners = [c(0.0, 0.0), c(12.0, 0.0), c(12.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)];
    let edges: Vec<_> = (0..6).map(|k| Edge::line(corners[k], corners[(k + 1) % 6])).collect();
    let (map, same) = (solve(&region(&edges, c(0.5, 0.5)), 1e-8), solve(&polygon(&corners, c(0.5, 0.5)), 1e-8));
    let points = spread_points(same.region(), 200);
    assert_eq!(map.to_disk(&points), same.to_disk(&points));
    assert_eq!(map.region().curved().unwrap().edges().len(), 6);
    let again = RiemannMap::from_bytes(&map.to_bytes()).unwrap();
    assert_eq!(again.to_disk(&points), same.to_disk(&points));
}

#[test]
fn straight_edges_are_a_polygon() {
    let corners = [c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)];
    let edges = nearly_polygon(&corners);
    let center = c(0.5, 0.5);
    let (map, reference) = (solve(&region(&edges, center), 1e-12), solve(&polygon(&corners, center), 1e-13));
    // Both have vertex 0 at 1 once they are turned.
    let turn = |map: &RiemannMap| Complex64::cis(-map.angles()[0]);
    let points = spread_points(reference.region(), 200);
    let (a, b) = (map.to_disk(&points), reference.to_disk(&points));
    let error = largest(a.iter().zip(&b).map(|(a, b)| (a * turn(&map) - b * turn(&reference)).norm()));
    assert!(error < 1e-12 && error <= map.error_estimate() + reference.error_estimate(), "{error:e}");
}

/// Corners of straight edges at angles of no whole share of π, whose variable is a fractional power.
#[test]
fn the_way_back_from_a_polygon_of_any_angles() {
    let corners = [c(0.7, 0.1), c(-0.3, 0.7), c(-0.5, 0.25), c(-0.1, 0.0), c(-0.3, -0.35), c(0.4, -0.5)];
    let edges = nearly_polygon(&corners);
    let center = c(0.2, 0.0);
    let (map, reference) = (solve(&region(&edges, center), 1e-12), solve(&polygon(&corners, center), 1e-13));
    let points = spread_points(reference.region(), 100);
    let images = reference.to_disk(&points);
    let (back, slopes) = (map.from_disk(&images), reference.derivative(&points));
    let error =
        largest(back.iter().zip(&points).zip(&slopes).map(|((z, exact), slope)| (z - exact).norm() * slope.norm()));
    assert!(error < 1e-12 && error <= map.error_estimate() + reference.error_estimate(), "{error:e}");
}

/// Control points that coincide make the parameter stand still at an end, or on the way; the curve does not care.
#[test]
fn parameters_may_stand_still() {
    let v = [c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)];
    let edges = [
        Edge::Cubic([v[0], v[0], v[1], v[1]]),
        Edge::Quadratic([v[1], v[1], v[2]]),
        Edge::Cubic([v[2], v[3], v[2], v[3]]),
        Edge::Cubic([v[3], v[3], v[3], v[0]]),
    ];
    let (map, square) = (solve(&region(&edges, ORIGIN), 1e-12), solve(&polygon(&v, ORIGIN), 1e-13));
    let points = spread_points(square.region(), 100);
    let (a, b) = (map.to_disk(&points), square.to_disk(&points));
    let error = largest(a.iter().zip(&b).map(|(a, b)| (a - b).norm()));
    assert!(error < 1e-12 && error <= map.error_estimate() + square.error_estimate(), "{error:e}");
    // On a curve, from both ends.
    let bowed = [
        Edge::Cubic([v[0], v[0], c(0.4, -1.6), v[1]]),
        Edge::Cubic([v[1], c(1.5, 0.3), v[2], v[2]]),
        edges[2],
        edges[3],
    ];
    let (rough, fine) = (solve(&region(&bowed, ORIGIN), 1e-7), solve(&region(&bowed, ORIGIN), 1e-12));
    let points = spread_points(fine.region(), 100);
    let (a, b) = (rough.to_disk(&points), fine.to_disk(&points));
    let error = largest(a.iter().zip(&b).map(|(a, b)| (a - b).norm()));
    assert!(error <= rough.error_estimate() && fine.error_estimate() <= 1e-12, "{error:e}");
    // So still that nobody can tell where it goes.
    let edges = [Edge::Cubic([v[0], v[0] + c(0.0, 1e-11), v[0], v[1]]), edges[1], edges[2], edges[3]];
    let error = RiemannMap::solve(&region(&edges, ORIGIN), &SolveOptions::default(), &mut |_, _| true).unwrap_err();
    assert!(error.code() == "invalid-outline" && error.to_string().contains("edge 0"), "{error}");
}

/// A letter "a" of sorts: lines, cubic and quadratic curves, smooth joins, sharp and re-entrant corners.
fn letter() -> Vec<Edge> {
    let arc = ArcTo { radii: (0.5, 0.7), rotation: 0.3, large: false, counterclockwise: true };
    vec![
        Edge::line(c(0.0, 0.0), c(1.0, 0.0)),
        Edge::Quadratic([c(1.0, 0.0), c(1.2, 0.5), c(1.8, 0.2)]),
        Edge::line(c(1.8, 0.2), c(3.0, 0.0)),
        Edge::Cubic([c(3.0, 0.0), c(3.4, 0.8), c(2.6, 1.4), c(3.0, 2.0)]),
        Edge::arc_to(c(3.0, 2.0), c(2.2, 2.4), arc),
        Edge::Cubic([c(2.2, 2.4), c(1.2, 1.6), c(1.4, 3.2), c(0.2, 2.6)]),
        Edge::Quadratic([c(0.2, 2.6), c(0.9, 1.4), c(0.0, 0.0)]),
    ]
}

#[test]
fn digits_cost_unknowns_in_proportion() {
    for (name, edges, center) in [("lens", lens(1.3 * PI).to_vec(), ORIGIN), ("letter", letter(), c(1.5, 1.0))] {
        let region = region(&edges, center);
        let reference = solve(&region, 1e-13);
        assert!(reference.error_estimate() <= 1e-12, "{name}: {:e}", reference.error_estimate());
        let points = spread_points(&region, 60);
        let exact = reference.to_disk(&points);
        let mut first = 0;
        for digits in [3, 6, 9, 12] {
            let tolerance = 10f64.powi(-digits);
            let map = solve(&region, tolerance);
            let images = map.to_disk(&points);
            let error = largest(images.iter().zip(&exact).map(|(a, b)| (a - b).norm()));
            let estimate = map.error_estimate();
            assert_eq!(map.stop(), Stop::Tolerance, "{name}");
            assert!(error <= estimate && estimate <= tolerance, "{name}: {error:e}, estimate {estimate:e}");
            if first == 0 {
                first = map.unknowns();
            }
            // A fixed order would multiply them by ten for a few digits more.
            assert!(
                map.unknowns() <= 8 * first,
                "{name}: {} unknowns for {digits} digits, {first} for 3",
                map.unknowns()
            );
        }
    }
}

#[test]
fn moved_turned_and_scaled_regions_have_the_same_map() {
    let center = c(1.5, 1.0);
    let map = solve(&region(&letter(), center), 1e-10);
    let (scale, shift) = (c(30.0, -70.0), c(4e5, -1e5));
    let edges: Vec<_> = letter().iter().map(|edge| edge.scaled(scale).moved(shift)).collect();
    let other = solve(&region(&edges, center * scale + shift), 1e-10);
    let points = spread_points(map.region(), 60);
    let moved: Vec<_> = points.iter().map(|z| z * scale + shift).collect();
    let (a, b) = (map.to_disk(&points), other.to_disk(&moved));
    let error = largest(a.iter().zip(&b).map(|(a, b)| (a - b).norm()));
    assert!(error < 2e-10, "{error:e}");
    let back = other.from_disk(&b);
    assert!(largest(back.iter().zip(&moved).map(|(a, b)| (a - b).norm())) < 1e-6);
}

/// Around a ring that is nearly closed the far ends are exponentially small in the disk.
#[test]
fn crowded_ends_are_told() {
    let at = |radius: f64, angle: f64| Complex64::from_polar(radius, angle);
    let (gap, turn) = (0.3, TAU - 0.6);
    let edges = [
        Edge::circular(ORIGIN, 1.0, gap, turn),
        Edge::line(at(1.0, -gap), at(0.8, -gap)),
        Edge::circular(ORIGIN, 0.8, -gap, -turn),
        Edge::line(at(0.8, gap), at(1.0, gap)),
    ];
    let ring = solve(&region(&edges, c(-0.9, 0.0)), 1e-8);
    let place = ring.crowded_at().expect("the ends are crowded");
    assert!(place.re > 0.5, "{place}");
    assert!(solve(&region(&letter(), c(1.5, 1.0)), 1e-8).crowded_at().is_none());
}

#[test]
fn stored_maps_come_back_to_the_bit() {
    let map = solve(&region(&letter(), c(1.5, 1.0)), 1e-6);
    let bytes = map.to_bytes();
    let again = RiemannMap::from_bytes(&bytes).unwrap();
    let points = spread_points(map.region(), 40);
    assert_eq!(map.to_disk(&points), again.to_disk(&points));
    assert_eq!((map.angles(), map.error_estimate()), (again.angles(), again.error_estimate()));
    assert_eq!(again.to_bytes(), bytes);
}

/// Squares are decided when they are first asked for: nothing depends on when.
#[test]
fn answers_do_not_depend_on_what_was_asked_before() {
    let region = region(&letter(), c(1.5, 1.0));
    let (asked, prepared) = (solve(&region, 1e-8), solve(&region, 1e-8));
    let mut reports = 0;
    prepared
        .prepare(&mut |_, _| {
            reports += 1;
            true
        })
        .unwrap();
    assert!(reports > 10);
    assert_eq!(asked.prepare(&mut |_, _| false).unwrap_err().code(), "cancelled");
    let points = spread_points(&region, 500);
    let images = prepared.to_disk(&points);
    let one_by_one: Vec<_> = points.iter().rev().map(|z| asked.to_disk(&[*z])[0]).collect();
    assert!(images.iter().eq(one_by_one.iter().rev()));
    let back: Vec<_> = images.iter().rev().map(|w| asked.from_disk(&[*w])[0]).collect();
    assert!(prepared.from_disk(&images).iter().eq(back.iter().rev()));
}

#[test]
fn centers_move_and_solving_can_be_cancelled() {
    let first = region(&letter(), c(1.5, 1.0));
    let map = solve(&first, 1e-9);
    let moved = map.with_center(c(0.8, 2.0), c(3.0, 0.0), &mut |_, _| true).unwrap();
    let direct = solve(&first.with_center(c(0.8, 2.0), c(3.0, 0.0)).unwrap(), 1e-9);
    let points = spread_points(&first, 40);
    let error = largest(moved.to_disk(&points).iter().zip(direct.to_disk(&points)).map(|(a, b)| (a - b).norm()));
    assert!(error < 1e-9, "{error:e}");
    let cancelled = RiemannMap::solve(&first, &SolveOptions::default(), &mut |_, _| false).unwrap_err();
    assert_eq!(cancelled.code(), "cancelled");
}
