//! Lines of equal value: every point lies on its line, ends lie where they should.

use super::{curve, options, square};
use crate::support::{largest, points};
use conformal_warp::{
    AnnulusMap, Circulation, Complex64, Conductors, Curve, Domain, Electrostatics, ExteriorMap, FlowLines, LevelLine,
    PotentialFlow, RingLines,
};
use std::f64::consts::{PI, TAU};

const WINDOW: [Complex64; 2] = [Complex64::new(-3.0, -2.0), Complex64::new(3.0, 2.0)];

fn past(bodies: &[Vec<Complex64>], kind: Curve, angle: f64, circulation: &Circulation) -> PotentialFlow {
    let outside = Domain::exterior(bodies, kind).unwrap();
    PotentialFlow::past(&outside, 1.0, angle, circulation, &options(1e-10), &mut |_, _| true).unwrap()
}

fn all_points(lines: &[LevelLine]) -> Vec<Complex64> {
    lines.iter().flat_map(|line| line.points.clone()).collect()
}

/// The largest angle between neighbouring pieces, where they are not tiny.
fn sharpest(line: &LevelLine) -> f64 {
    let turn = |three: &[Complex64]| {
        let (a, b) = (three[1] - three[0], three[2] - three[1]);
        if a.norm() < 1e-3 || b.norm() < 1e-3 { 0.0 } else { (b * a.conj()).arg().abs() }
    };
    largest(line.points.windows(3).map(turn))
}

#[test]
fn streamlines_past_a_cylinder() {
    let body = curve(48, Complex64::cis);
    let flow = past(std::slice::from_ref(&body), Curve::Smooth, 0.0, &Circulation::Given(vec![0.0]));
    let levels = [-1.2, -0.5, 0.0, 0.3, 1.5];
    let lines = flow.level_lines(FlowLines::Streamlines, &levels, WINDOW);
    for line in &lines {
        let on_line = flow.stream(&line.points);
        // The ends are where straight pieces leave the window.
        let inner = &on_line[1..on_line.len() - 1];
        let miss = largest(inner.iter().map(|psi| (psi - line.level).abs()));
        assert!(miss < 1e-9, "ψ = {}: {miss:e}", line.level);
        assert!(sharpest(line) < 0.3, "ψ = {}: {}", line.level, sharpest(line));
        assert!(!line.closed);
        let along = flow.velocity(&[line.points[1]])[0];
        assert!(((line.points[2] - line.points[1]) * along.conj()).re > 0.0, "it runs with the fluid");
    }
    // One line a level; that of the body parts and joins at ±1.
    let count = |level: f64| lines.iter().filter(|line| line.level == level).count();
    assert_eq!(levels.map(count), [1, 1, 2, 1, 1]);
    for line in lines.iter().filter(|line| line.level == 0.0) {
        let end = if line.points[0].re < -2.0 { line.points[line.points.len() - 1] } else { line.points[0] };
        assert!((end.norm() - 1.0).abs() < 1e-12 && end.im.abs() < 1e-6, "{end}");
        assert!(line.points.iter().all(|z| z.im.abs() < 1e-6 && z.norm() > 1.0 - 1e-12), "straight along the axis");
    }
    let potentials = flow.level_lines(FlowLines::Potentials, &[-1.0, 0.0, 2.1], WINDOW);
    for line in &potentials {
        let phi: Vec<f64> = flow.potential(&line.points).iter().map(|w| w.re).collect();
        let miss = largest(phi[1..phi.len() - 1].iter().map(|phi| (phi - line.level).abs()));
        assert!(miss < 1e-8, "φ = {}: {miss:e}", line.level);
    }
    assert!(potentials.iter().any(|line| line.level == 0.0));
}

/// A cylinder that turns fast drags closed streamlines around itself, inside a point of rest below it.
#[test]
fn closed_streamlines_and_a_free_point_of_rest() {
    let gamma = -5.0 * PI;
    let flow = past(&[curve(48, Complex64::cis)], Curve::Smooth, 0.0, &Circulation::Given(vec![gamma]));
    // W' = 1 − 1/z² − iΓ/(2πz) = 0 at z = iy, y² + 5y/2 + 1 = 0.
    let rests = flow.free_stagnation_points(WINDOW);
    assert_eq!(rests.len(), 1, "{rests:?}");
    assert!(
        (rests[0] - Complex64::new(0.0, -2.0)).norm() < 1e-8 || (rests[0] - Complex64::new(0.0, 2.0)).norm() < 1e-8,
        "{rests:?}"
    );
    let side = rests[0].im.signum();
    let level = flow.stream(&rests)[0];
    let lines = flow.level_lines(FlowLines::Streamlines, &[level], [WINDOW[0] * 1.5, WINDOW[1] * 1.5]);
    let through = lines.iter().filter(|line| line.points.iter().any(|z| (z - rests[0]).norm() < 1e-9)).count();
    assert!(through >= 2, "{through} of {}", lines.len());
    let inside = flow.stream(&[Complex64::new(0.0, side * 1.5)])[0];
    let lines = flow.level_lines(FlowLines::Streamlines, &[inside], WINDOW);
    let around = lines.iter().find(|line| line.closed).unwrap();
    let area: f64 = (0..around.points.len())
        .map(|k| 0.5 * (around.points[k].conj() * around.points[(k + 1) % around.points.len()]).im)
        .sum();
    assert!(area.abs() > PI, "{area}");
    assert!(largest(flow.stream(&around.points).iter().map(|psi| (psi - inside).abs())) < 1e-9);
}

/// The streamline of Joukowski's airfoil parts at one point of rest and leaves at the trailing edge.
#[test]
fn a_joukowski_airfoil_parts_the_fluid() {
    let (middle, c, angle) = (Complex64::new(-0.1, 0.08), 0.9, 0.1);
    let start = (Complex64::ONE - middle).arg();
    let radius = (Complex64::ONE - middle).norm();
    let circle = |t: f64| middle + Complex64::from_polar(radius, start + t);
    let body = curve(256, |t| circle(t) + c * c / circle(t));
    let flow = past(std::slice::from_ref(&body), Curve::Smooth, angle, &Circulation::Kutta { trailing: vec![0] });
    let gamma = -2.0 * TAU * radius * (angle - start).sin();
    assert!((flow.lift(1.0) + gamma).abs() < 1e-9, "{} {gamma}", flow.lift(1.0));
    let level = flow.stream(&body[..1])[0];
    let lines =
        flow.level_lines(FlowLines::Streamlines, &[level], [Complex64::new(-4.0, -3.0), Complex64::new(4.0, 3.0)]);
    assert_eq!(lines.len(), 2, "{:?}", lines.iter().map(|line| line.points.len()).collect::<Vec<_>>());
    let rests = flow.stagnation_points();
    for line in &lines {
        let (first, last) = (line.points[0], line.points[line.points.len() - 1]);
        assert!(rests.contains(&first) || rests.contains(&last), "{first} {last}");
        let miss = largest(flow.stream(&line.points[1..line.points.len() - 1]).iter().map(|psi| (psi - level).abs()));
        assert!(miss < 1e-9, "{miss:e}");
    }
    assert!(lines.iter().any(|line| (line.points[0] - body[0]).norm() < 1e-6), "one leaves at the trailing edge");
}

/// Of a profile with a sharp trailing edge the lift slope is 8π times its logarithmic capacity over its chord, and
/// 2π(1 + 0.77 t/c) for thin ones (Houghton and Carpenter, Aerodynamics for Engineering Students).
#[test]
fn naca_0012_by_200_points() {
    let half = 100;
    let thickness = |x: f64| {
        let y = 0.2969 * x.sqrt() - 0.1260 * x - 0.3516 * x * x + 0.2843 * x.powi(3) - 0.1036 * x.powi(4);
        5.0 * 0.12 * y.max(0.0)
    };
    // From the trailing edge above to the nose and back below, dense at both.
    let place = |k: usize| 0.5 * (1.0 + (PI * k as f64 / half as f64).cos());
    let body: Vec<Complex64> = (0..2 * half)
        .map(|k| {
            let x = place(k);
            Complex64::new(x, if k == 0 || k == half { 0.0 } else { thickness(x) * if k < half { 1.0 } else { -1.0 } })
        })
        .collect();
    let outside = Domain::exterior(&[body], Curve::Polygon).unwrap();
    let kutta = Circulation::Kutta { trailing: vec![0] };
    let still = PotentialFlow::past(&outside, 1.0, 0.0, &kutta, &options(1e-7), &mut |_, _| true).unwrap();
    assert!(still.lift(1.0).abs() < 1e-6, "{}", still.lift(1.0));
    let angle = 5f64.to_radians();
    let flow = still.again(1.0, angle, &kutta).unwrap();
    let slope = 2.0 * flow.lift(1.0) / angle.sin();
    let capacity = ExteriorMap::solve(&outside, &options(1e-8), &mut |_, _| true).unwrap().capacity();
    println!("NACA 0012: slope {slope}, 8π capacity {}, C at 5° {}", 8.0 * PI * capacity, 2.0 * flow.lift(1.0));
    assert!((slope / (8.0 * PI * capacity) - 1.0).abs() < 1e-5, "{slope} {}", 8.0 * PI * capacity);
    assert!((slope / (TAU * (1.0 + 0.77 * 0.12)) - 1.0).abs() < 0.02, "{slope}");
    let force = flow.force(1.0) * Complex64::cis(-angle);
    assert!((force - Complex64::new(0.0, flow.lift(1.0))).norm() < 1e-6, "no drag: {force}");
}

/// A wind that is asked for again is that of a new solve.
#[test]
fn winds_of_one_solve() {
    let bodies = [square(0.4), points(&[[1.0, 0.5], [2.0, 0.3], [1.5, 1.0]])];
    let given = |a: f64, b: f64| Circulation::Given(vec![a, b]);
    let first = past(&bodies, Curve::Polygon, 0.0, &given(0.0, 0.0));
    for (angle, circulation) in [(0.7, given(1.0, -2.0)), (-0.3, Circulation::Kutta { trailing: vec![0, 1] })] {
        let again = first.again(1.0, angle, &circulation).unwrap();
        let anew = past(&bodies, Curve::Polygon, angle, &circulation);
        for (a, b) in again.circulation().iter().zip(anew.circulation()) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
        let places = [Complex64::new(0.7, 0.1), Complex64::new(-2.0, 1.0), Complex64::new(50.0, -20.0)];
        for (a, b) in again.velocity(&places).iter().zip(anew.velocity(&places)) {
            assert!((a - b).norm() < 1e-9, "{a} {b}");
        }
    }
    assert_eq!(first.again(-1.0, 0.0, &given(0.0, 0.0)).unwrap_err().code(), "invalid-option");
    assert_eq!(first.again(1.0, 0.0, &Circulation::Given(vec![])).unwrap_err().code(), "wrong-length");
}

#[test]
fn equal_potentials_and_lines_of_force() {
    let holes = [square(0.3), points(&[[1.0, 0.6], [1.6, 0.8], [1.1, 1.4]])];
    let domain = Domain::new(&square(2.0), &holes, Curve::Polygon).unwrap();
    let given = Conductors::Potentials(vec![0.0, 1.0, -0.5]);
    let field = Electrostatics::solve(&domain, &given, &options(1e-9), &mut |_, _| true).unwrap();
    let window = [Complex64::new(-2.0, -2.0), Complex64::new(2.0, 2.0)];
    let levels = [-0.4, -0.2, 0.2, 0.5, 0.9];
    let lines = field.level_lines(&levels, window);
    for level in levels {
        assert!(lines.iter().any(|line| line.level == level && line.closed), "{level}");
    }
    for line in &lines {
        let miss = largest(field.potential(&line.points).iter().map(|v| (v - line.level).abs()));
        assert!(miss < 1e-8, "{}: {miss:e}", line.level);
    }
    let force = field.force_lines(20, window);
    let largest_charge = field.charges().iter().fold(0.0, |most: f64, q| most.max(q.abs()));
    let of_first = (20.0 * field.charges()[1] / largest_charge).round() as usize;
    assert_eq!(force.iter().filter(|line| line.level == 1.0).count(), of_first);
    for line in &force {
        let ends = [line.points[0], line.points[line.points.len() - 1]];
        let [from, to] = [field.potential(&ends)[0], field.potential(&ends)[1]];
        assert!((from - [0.0, 1.0, -0.5][line.level as usize]).abs() < 1e-6, "{ends:?}: {from}");
        assert!([0.0, -0.5].iter().any(|v| (to - v).abs() < 1e-4), "{ends:?}: {to}");
        let falls = field.potential(&line.points);
        assert!(falls.windows(2).all(|pair| pair[1] < pair[0] + 1e-9), "the potential falls along it");
    }
    assert_eq!(all_points(&field.level_lines(&[7.0], window)), []);
}

#[test]
fn circles_and_rays_of_a_ring() {
    let domain = Domain::new(&square(1.0), &[square(0.5)], Curve::Polygon).unwrap();
    let map = AnnulusMap::solve(&domain, &options(1e-9), &mut |_, _| true).unwrap();
    for line in map.level_lines(RingLines::Circles, &[map.inner_radius(), 0.7, 0.95, 1.0]) {
        assert!(line.closed);
        let miss = largest(map.to_annulus(&line.points).iter().map(|w| (w.norm() - line.level).abs()));
        assert!(miss < 1e-8, "{}: {miss:e}", line.level);
    }
    for line in map.level_lines(RingLines::Rays, &[0.3, 2.0, -1.0]) {
        let angles = map.to_annulus(&line.points).into_iter().map(|w| (w * Complex64::cis(-line.level)).arg().abs());
        assert!(largest(angles) < 1e-7);
        let ends = [line.points[0], line.points[line.points.len() - 1]];
        let norms = map.to_annulus(&ends).iter().map(|w| w.norm()).collect::<Vec<_>>();
        assert!((norms[0] - 1.0).abs() < 1e-9 && (norms[1] - map.inner_radius()).abs() < 1e-9, "{norms:?}");
    }
}
