//! Vortices and sources beside bodies and within walls, against images.

use super::{curve, options, square};
use crate::support::{c, largest, share};
use conformal_warp::{
    Circulation, Complex64, Curve, Domain, Edge, ExteriorMap, FlowLines, FlowPoints, PotentialFlow, Region, RiemannMap,
};
use std::f64::consts::{PI, TAU};

const I: Complex64 = Complex64::new(0.0, 1.0);

fn solve(domain: &Domain, speed: f64, circulation: &[f64], points: &FlowPoints) -> PotentialFlow {
    let given = Circulation::Given(circulation.to_vec());
    PotentialFlow::with_points(domain, speed, 0.3, &given, points, &options(1e-11), &mut |_, _| true).unwrap()
}

fn vortices(list: &[(Complex64, f64)]) -> FlowPoints {
    FlowPoints { vortices: list.to_vec(), sources: Vec::new() }
}

/// A square, an ellipse, and a half disk with a handle of a quadratic curve.
fn bodies() -> [(&'static str, Domain); 3] {
    let ellipse = curve(64, |t| c(1.3 * t.cos(), 0.8 * t.sin()));
    let drop = [
        Edge::circular(c(0.0, 0.0), 1.0, -PI / 2.0, PI),
        Edge::Quadratic([c(0.0, 1.0), c(-1.5, 0.3), c(-0.6, -0.2)]),
        Edge::line(c(-0.6, -0.2), c(0.0, -1.0)),
    ];
    [
        ("square", Domain::exterior(&[square(0.9)], Curve::Polygon).unwrap()),
        ("ellipse", Domain::exterior(&[ellipse], Curve::Smooth).unwrap()),
        ("drop", Domain::exterior_of_edges(&[drop.to_vec()]).unwrap()),
    ]
}

fn points_around() -> FlowPoints {
    FlowPoints {
        vortices: vec![(c(1.6, 0.4), 2.0), (c(-0.3, -1.9), -0.7), (c(9.0, 2.0), 1.0)],
        sources: vec![(c(2.0, -0.5), 1.5), (c(0.4, 1.4), -0.4)],
    }
}

/// Beside the body, around it, far away, to both sides of all cuts.
fn places() -> Vec<Complex64> {
    let around = |k: usize| Complex64::from_polar(1.35 + 12.0 * share(k, 0.37).powi(3), TAU * share(k, 0.618));
    (0..150).map(around).collect()
}

/// With the map onto the outside of the circle: the images at 1/w̄ and 0.
fn exact_velocity(map: &ExteriorMap, points: &FlowPoints, z: Complex64) -> Complex64 {
    let w = map.to_exterior(&[z])[0];
    let vortex = |(at, gamma): &(Complex64, f64)| {
        let a = map.to_exterior(&[*at])[0];
        -I * *gamma * ((w - a).inv() - (w - a.conj().inv()).inv() + w.inv())
    };
    let source = |(at, strength): &(Complex64, f64)| {
        let a = map.to_exterior(&[*at])[0];
        *strength * ((w - a).inv() + (w - a.conj().inv()).inv() - w.inv())
    };
    let sum: Complex64 =
        points.vortices.iter().map(vortex).chain(points.sources.iter().map(source)).sum::<Complex64>() / TAU;
    (sum * map.derivative(&[z])[0]).conj()
}

#[test]
fn images_in_a_body() {
    for (name, domain) in bodies() {
        let map = ExteriorMap::solve(&domain, &options(1e-12), &mut |_, _| true).unwrap();
        let points = points_around();
        let flow = solve(&domain, 0.0, &[0.0], &points);
        let off = places().into_iter().map(|z| {
            let (found, exact) = (flow.velocity(&[z])[0], exact_velocity(&map, &points, z));
            (found - exact).norm() / exact.norm().max(0.1)
        });
        let off = largest(off);
        println!("{name}: {off:.1e}, estimate {:.1e}", flow.error_estimate());
        assert!(off < 3e-8, "{name}: {off:e}");
        assert!(flow.error_estimate() < 1e-9, "{name}: {:e}", flow.error_estimate());
    }
}

/// ψ of vortices, with a wind and without, against the images, in the units that the estimate is stated in.
#[test]
fn errors_are_within_the_estimate() {
    for (name, domain) in bodies() {
        let map = ExteriorMap::solve(&domain, &options(1e-13), &mut |_, _| true).unwrap();
        let points = vortices(&points_around().vortices);
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let none = Circulation::Given(vec![0.0]);
            let flow =
                PotentialFlow::with_points(&domain, 0.0, 0.0, &none, &points, &options(tolerance), &mut |_, _| true);
            let flow = flow.unwrap();
            let level = |z: &Complex64| {
                let w = map.to_exterior(&[*z])[0];
                let of = |(at, gamma): &(Complex64, f64)| {
                    let a = map.to_exterior(&[*at])[0];
                    -gamma / TAU * ((w - a) * w / (w - a.conj().inv())).norm().ln()
                };
                points.vortices.iter().map(of).sum::<f64>()
            };
            let off: Vec<f64> =
                flow.stream(&places()).into_iter().zip(&places()).map(|(psi, z)| psi - level(z)).collect();
            let spread = largest(off.iter().copied()) - off.iter().copied().fold(f64::INFINITY, f64::min);
            let unit = points.vortices.iter().map(|(_, gamma)| gamma.abs()).sum::<f64>() / TAU;
            println!("{name} {tolerance:e}: {spread:.1e} of {:.1e}", flow.error_estimate() * unit);
            assert!(spread <= 2.0 * unit * flow.error_estimate(), "{name}, {tolerance:e}: {spread:e}");
        }
    }
}

/// ψ less the arguments of the sources, principal as they are, has one value anywhere: nothing but their cuts is there, up to and on
/// the body.
#[test]
fn the_stream_function_jumps_at_the_sources_cuts_alone() {
    for (name, domain) in bodies() {
        let points = points_around();
        let flow = solve(&domain, 0.7, &[1.0], &points);
        let rest = |z: Complex64| {
            let cut: f64 = points.sources.iter().map(|(at, m)| m / TAU * (z - at).arg()).sum();
            flow.stream(&[z])[0] - cut
        };
        // Around at several distances, the last of them on the body.
        let corners: Vec<Complex64> = (0..4000)
            .map(|k| Complex64::from_polar(2.5, TAU * (f64::from(k) + 0.5) / 4000.0))
            .map(|far| {
                // The body's point on the ray from the origin, by halving.
                let (mut inside, mut outside) = (0.0, 1.0);
                for _ in 0..60 {
                    let middle = 0.5 * (inside + outside);
                    *(if domain.contains(far * middle) { &mut outside } else { &mut inside }) = middle;
                }
                far * outside
            })
            .collect();
        for scale in [4.0, 1.05, 1.0 + 1e-4, 1.0 + 1e-9, 1.0] {
            let along: Vec<f64> = corners.iter().map(|z| rest(z * scale)).collect();
            let jump = largest((0..along.len()).map(|k| (along[k] - along[(k + 1) % along.len()]).abs()));
            assert!(jump < 0.05, "{name}, {scale}: {jump}");
        }
        // On the body ψ is one number, but for the cuts.
        let psi: Vec<f64> = flow.stream(&corners);
        let strengths: Vec<f64> = points.sources.iter().map(|(_, m)| *m).collect();
        let values = psi.iter().map(|value| value - psi[0]);
        let off = values.map(|difference| {
            let whole = (-1..=1).flat_map(|j| (-1..=1).map(move |k| (f64::from(j), f64::from(k))));
            whole.map(|(j, k)| (difference - j * strengths[0] - k * strengths[1]).abs()).fold(f64::INFINITY, f64::min)
        });
        let off = largest(off);
        println!("{name}: ψ on the body {off:.1e}");
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

#[test]
fn beside_a_cylinder_in_the_wind() {
    let domain = Domain::exterior(&[curve(48, Complex64::cis)], Curve::Smooth).unwrap();
    let (a, gamma, body) = (c(1.2, 0.9), 3.0, -1.4);
    let flow = solve(&domain, 2.0, &[body], &vortices(&[(a, gamma)]));
    let exact = |z: Complex64| {
        let wind = 2.0 * (Complex64::cis(-0.3) - Complex64::cis(0.3) / (z * z));
        let images = (z - a).inv() - (z - a.conj().inv()).inv() + z.inv();
        (wind - I * gamma / TAU * images - I * body / TAU / z).conj()
    };
    let off = largest(places().into_iter().map(|z| (flow.velocity(&[z])[0] - exact(z)).norm()));
    assert!(off < 1e-8, "{off:e}");
    // It is carried along by the wind, the body and its own images.
    let wind = 2.0 * (Complex64::cis(-0.3) - Complex64::cis(0.3) / (a * a));
    let carried = (wind + I * gamma / TAU * ((a - a.conj().inv()).inv() - a.inv()) - I * body / TAU / a).conj();
    assert!((flow.drift()[0] - carried).norm() < 1e-9, "{} {carried}", flow.drift()[0]);
    // The force is that of the pressure on the body.
    let (density, n) = (1.3, 2000);
    let press = |k: u32| {
        let normal = Complex64::cis(TAU * f64::from(k) / f64::from(n));
        normal * (0.5 * density * exact(normal).norm_sqr() * TAU / f64::from(n))
    };
    let pressed: Complex64 = (0..n).map(press).sum();
    let force = flow.force(density);
    assert!((force - pressed).norm() < 1e-8, "{force} {pressed}");
    for z in flow.stagnation_points() {
        assert!(exact(z).norm() < 1e-6, "{z}");
    }
    assert_eq!(flow.circulation(), [body]);
    // Nothing is solved again for others at the same place, with another wind.
    let again = flow.again_with_points(1.0, 0.3, &Circulation::Given(vec![0.5]), &vortices(&[(a, -1.0)])).unwrap();
    let anew = solve(&domain, 1.0, &[0.5], &vortices(&[(a, -1.0)]));
    let same = largest(places().into_iter().map(|z| (again.velocity(&[z])[0] - anew.velocity(&[z])[0]).norm()));
    assert!(same < 1e-9, "{same:e}");
    let moved = flow.again_with_points(1.0, 0.3, &Circulation::Given(vec![0.5]), &vortices(&[(a + 0.1, -1.0)]));
    assert_eq!(moved.unwrap_err().code(), "invalid-map");
}

/// Around two bodies and whatever is between: circulations and fluxes are those that were asked for.
#[test]
fn what_goes_around_and_through() {
    let bodies = [square(0.5), square(0.5).iter().map(|z| z * 1.5 + c(2.5, 0.7)).collect()];
    let domain = Domain::exterior(&bodies, Curve::Polygon).unwrap();
    let points =
        FlowPoints { vortices: vec![(c(1.1, 0.3), 2.0), (c(-1.0, 0.2), -3.0)], sources: vec![(c(0.9, -1.0), 1.2)] };
    let flow = solve(&domain, 1.0, &[0.4, -0.9], &points);
    let around = |middle: Complex64, half: f64| -> Complex64 {
        // ∮ W' dz around a square by the midpoint rule.
        let steps = 4000;
        let corners = square(half);
        (0..4)
            .flat_map(|k| {
                let (from, to) = (corners[k], corners[(k + 1) % 4]);
                let piece = (to - from) / f64::from(steps);
                (0..steps).map(move |j| (from + piece * (f64::from(j) + 0.5), piece))
            })
            .map(|(z, piece)| flow.velocity(&[middle + z])[0].conj() * piece)
            .sum()
    };
    let off = |found: Complex64, circulation: f64, flux: f64| (found - c(circulation, flux)).norm();
    assert!(off(around(c(0.0, 0.0), 0.6), 0.4, 0.0) < 1e-5);
    assert!(off(around(c(2.5, 0.7), 0.9), -0.9, 0.0) < 1e-5);
    assert!(off(around(c(1.1, 0.3), 0.2), 2.0, 0.0) < 1e-5);
    assert!(off(around(c(0.9, -1.0), 0.3), 0.0, 1.2) < 1e-5);
    assert!(off(around(c(1.0, 0.0), 20.0), 0.4 - 0.9 + 2.0 - 3.0, 1.2) < 1e-4);
}

#[test]
fn a_vortex_leaves_the_trailing_corner_smooth() {
    let domain = Domain::exterior(
        &[crate::support::points(&[[1.0, 0.0], [0.0, 0.1], [-1.0, 0.0], [0.0, -0.1]])],
        Curve::Polygon,
    );
    let domain = domain.unwrap();
    let kutta = Circulation::Kutta { trailing: vec![0] };
    let points = vortices(&[(c(1.5, 0.4), -1.5)]);
    let with = |points: &FlowPoints| {
        PotentialFlow::with_points(&domain, 1.0, 0.1, &kutta, points, &options(1e-10), &mut |_, _| true).unwrap()
    };
    let flow = with(&points);
    let beside = flow.velocity(&[c(1.0 + 1e-9, 0.0), c(-1.0 - 1e-9, 0.0)]);
    assert!(beside[0].norm() < 3.0 && beside[1].norm() > 100.0, "{beside:?}");
    assert!((flow.circulation()[0] - with(&FlowPoints::default()).circulation()[0]).abs() > 0.1);
}

/// Within walls: a disk, a square, a square around a square.
#[test]
fn images_in_a_wall() {
    let circle = Domain::new(&curve(48, Complex64::cis), &[], Curve::Smooth).unwrap();
    let (a, b, gamma) = (c(0.4, 0.3), c(-0.5, -0.1), 2.0);
    let turning = solve(&circle, 0.0, &[], &vortices(&[(a, gamma)]));
    let flowing = FlowPoints { vortices: Vec::new(), sources: vec![(a, 1.5), (b, -1.5)] };
    let welling = solve(&circle, 0.0, &[], &flowing);
    let image = |z: Complex64, a: Complex64| (z - a.conj().inv()).inv();
    let inside = |k: usize| Complex64::from_polar(share(k, 0.37).sqrt(), TAU * share(k, 0.618));
    for z in (1..100).map(inside).chain([c(0.0, 1.0), c(0.6, -0.8)]) {
        let exact = (-I * gamma / TAU * ((z - a).inv() - image(z, a))).conj();
        let found = turning.velocity(&[z])[0];
        assert!((found - exact).norm() < 1e-8 * exact.norm().max(1.0), "{z}: {found} {exact}");
        let exact = (1.5 / TAU * ((z - a).inv() + image(z, a) - (z - b).inv() - image(z, b))).conj();
        let found = welling.velocity(&[z])[0];
        assert!((found - exact).norm() < 1e-8 * exact.norm().max(1.0), "{z}: {found} {exact}");
    }
    let carried = (I * gamma / TAU * image(a, a)).conj();
    assert!((turning.drift()[0] - carried).norm() < 1e-9, "{}", turning.drift()[0]);
    // In a square the same after its Riemann map.
    let region = Region::new(&square(1.0), Curve::Polygon, c(0.0, 0.0), c(1.0, 1.0)).unwrap();
    let map = RiemannMap::solve(&region, &options(1e-12), &mut |_, _| true).unwrap();
    let walls = Domain::new(&square(1.0), &[], Curve::Polygon).unwrap();
    let edges: Vec<Edge> = (0..4).map(|k| Edge::line(square(1.0)[k], square(1.0)[(k + 1) % 4])).collect();
    let both = FlowPoints { vortices: vec![(c(0.1, -0.6), 0.8)], ..flowing };
    for walls in [walls, Domain::from_edges(&edges, &[]).unwrap()] {
        let flow = solve(&walls, 0.0, &[], &both);
        for z in (1..100).map(inside).chain([c(0.99, 0.5), c(-0.2, 0.999_999)]) {
            let (w, slope) = (map.to_disk(&[z])[0], map.derivative(&[z])[0]);
            let images = |at: Complex64, sign: f64| {
                let a = map.to_disk(&[at])[0];
                (w - a).inv() + sign * image(w, a)
            };
            let source = |(at, m): &(Complex64, f64)| *m * images(*at, 1.0);
            let vortex = |(at, gamma): &(Complex64, f64)| -I * *gamma * images(*at, -1.0);
            let sum: Complex64 = both.sources.iter().map(source).chain(both.vortices.iter().map(vortex)).sum();
            let exact = (sum * slope / TAU).conj();
            let found = flow.velocity(&[z])[0];
            assert!((found - exact).norm() < 1e-7 * exact.norm().max(1.0), "{z}: {found} {exact}");
        }
    }
    // By symmetry nothing carries a vortex in the middle along; around a hole it goes in circles.
    let ring = Domain::new(&square(1.0), &[square(0.3)], Curve::Polygon).unwrap();
    let still =
        solve(&Domain::new(&square(1.0), &[], Curve::Polygon).unwrap(), 0.0, &[], &vortices(&[(c(0.0, 0.0), 1.0)]));
    assert!(still.drift()[0].norm() < 1e-9, "{}", still.drift()[0]);
    let circling = solve(&ring, 0.0, &[1.0], &vortices(&[(c(0.6, 0.0), 1.0)]));
    assert!(circling.drift()[0].re.abs() < 1e-9 && circling.drift()[0].im.abs() > 0.1, "{}", circling.drift()[0]);
    let on_walls = circling.stream(&[c(1.0, 0.2), c(-0.3, 1.0), c(-1.0, -0.9)]);
    assert!(largest(on_walls.iter().map(|psi| (psi - on_walls[0]).abs())) < 1e-9, "{on_walls:?}");
    for z in circling.stagnation_points() {
        assert!(circling.velocity(&[z])[0].norm() < 1e-3, "{z} {}", circling.velocity(&[z])[0]);
    }
}

/// Beside a wall that is far longer than the way to it, a vortex runs along it with Γ/4πh, but for what the body's middle, some
/// 10,000 times as far away, answers.
#[test]
fn beside_a_long_wall() {
    let domain = Domain::exterior(&[square(500.0)], Curve::Polygon).unwrap();
    let (h, gamma) = (0.05, 2.0);
    let flow = solve(&domain, 0.0, &[0.0], &vortices(&[(c(7.0, 500.0 + h), gamma)]));
    let drift = flow.drift()[0];
    assert!((drift - gamma / (4.0 * PI * h)).norm() < 3e-4 * gamma / (4.0 * PI * h), "{drift}");
}

#[test]
fn streamlines_of_a_source_and_around_a_vortex() {
    for (name, domain) in bodies() {
        let points = FlowPoints { vortices: vec![(c(1.9, -1.1), 3.0)], sources: vec![(c(2.3, 0.45), 2.0)] };
        let flow = solve(&domain, 1.0, &[0.0], &points);
        let window = [c(-4.0, -3.0), c(4.0, 3.0)];
        let levels = [-1.5, -0.6, 0.1, 0.8, 1.7];
        let lines = flow.level_lines(FlowLines::Streamlines, &levels, window);
        assert!(lines.len() >= levels.len(), "{name}: {}", lines.len());
        for line in &lines {
            let psi = flow.stream(&line.points[1..line.points.len() - 1]);
            // A multiple of what wells up is added behind the cut.
            let miss = psi.iter().map(|psi| {
                let off = (psi - line.level) / 2.0;
                (off - off.round()).abs()
            });
            let miss = largest(miss);
            assert!(miss < 1e-7, "{name}, {}: {miss:e}", line.level);
            let u = flow.velocity(&[line.points[1]])[0];
            assert!(((line.points[2] - line.points[1]) * u.conj()).re > 0.0, "{name}: it runs with the fluid");
        }
        let potentials = flow.level_lines(FlowLines::Potentials, &[-1.0, 1.0], window);
        assert!(!potentials.is_empty());
        for line in &potentials {
            let phi = flow.potential(&line.points[1..line.points.len() - 1]);
            let miss = phi.iter().map(|w| {
                let off = (w.re - line.level) / 3.0;
                (off - off.round()).abs()
            });
            let miss = largest(miss);
            assert!(miss < 1e-7, "{name}, φ = {}: {miss:e}", line.level);
        }
        // The streamlines of the points of rest part and join there.
        for z in flow.stagnation_points() {
            let level = flow.stream(&[z])[0];
            let lines = flow.level_lines(FlowLines::Streamlines, &[level], window);
            let meets = |line: &conformal_warp::LevelLine| {
                [line.points[0], line.points[line.points.len() - 1]].iter().any(|end| (end - z).norm() < 1e-9)
            };
            assert!(lines.iter().any(meets), "{name}: {z}");
        }
        for z in flow.free_stagnation_points(window) {
            assert!(flow.velocity(&[z])[0].norm() < 1e-8, "{name}: {z}");
        }
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let none = Circulation::Given(vec![0.0]);
    let outside = Domain::exterior(&[square(1.0)], Curve::Polygon).unwrap();
    let inside = Domain::new(&square(2.0), &[square(1.0)], Curve::Polygon).unwrap();
    let code = |domain: &Domain, speed: f64, points: &FlowPoints| {
        let solved = PotentialFlow::with_points(domain, speed, 0.0, &none, points, &options(1e-6), &mut |_, _| true);
        solved.unwrap_err().code()
    };
    let sources = |list: &[(Complex64, f64)]| FlowPoints { vortices: Vec::new(), sources: list.to_vec() };
    for at in [c(0.0, 0.5), c(1.0, 0.3), c(1.0, 1.0)] {
        assert_eq!(code(&outside, 1.0, &vortices(&[(at, 1.0)])), "point-outside");
        assert_eq!(code(&outside, 1.0, &sources(&[(c(3.0, 0.0), 1.0), (at, 1.0)])), "point-outside");
    }
    assert_eq!(code(&inside, 0.0, &vortices(&[(c(2.5, 0.0), 1.0)])), "point-outside");
    assert_eq!(code(&outside, 1.0, &vortices(&[(c(f64::NAN, 0.0), 1.0)])), "not-finite");
    assert_eq!(code(&outside, 1.0, &vortices(&[(c(3.0, 0.0), f64::INFINITY)])), "invalid-option");
    assert_eq!(code(&outside, -1.0, &vortices(&[(c(3.0, 0.0), 1.0)])), "invalid-option");
    assert_eq!(code(&outside, 0.0, &FlowPoints::default()), "invalid-option");
    assert_eq!(code(&inside, 1.0, &vortices(&[(c(1.5, 0.0), 1.0)])), "invalid-option");
    assert_eq!(code(&inside, 0.0, &sources(&[(c(1.5, 0.0), 1.0)])), "invalid-option");
    assert_eq!(code(&inside, 0.0, &sources(&[(c(1.5, 0.0), 0.0)])), "wrong-region");
    assert_eq!(code(&inside, 0.0, &FlowPoints::default()), "wrong-region");
    let two = sources(&[(c(1.5, 0.0), 1.0), (c(-1.5, 0.0), -1.0)]);
    let flow = solve(&inside, 0.0, &[0.0], &two);
    assert!(flow.force(1.0).is_nan());
    let message = PotentialFlow::with_points(
        &outside,
        1.0,
        0.0,
        &none,
        &vortices(&[(c(3.0, 0.0), 1.0), (c(0.0, 0.0), 1.0)]),
        &options(1e-6),
        &mut |_, _| true,
    );
    assert!(message.unwrap_err().to_string().starts_with("Vortex 1 (counted from 0), at"));
}
