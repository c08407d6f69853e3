//! Flow past bodies against Joukowski's closed forms.

use super::{curve, options};
use crate::support::points;
use conformal_warp::{Circulation, Complex64, Curve, Domain, PotentialFlow};
use std::f64::consts::TAU;

fn past(body: &[Complex64], kind: Curve, angle: f64, circulation: &Circulation) -> PotentialFlow {
    let outside = Domain::exterior(&[body.to_vec()], kind).unwrap();
    PotentialFlow::past(&outside, 2.0, angle, circulation, &options(1e-12), &mut |_, _| true).unwrap()
}

#[test]
fn a_turning_cylinder() {
    let body = curve(32, |t| Complex64::new(0.3, -0.2) + 1.5 * Complex64::cis(t));
    let (speed, angle, gamma) = (2.0, 0.3, -3.0);
    let flow = past(&body, Curve::Smooth, angle, &Circulation::Given(vec![gamma]));
    let exact = |z: Complex64| {
        let z = z - Complex64::new(0.3, -0.2);
        let turn = Complex64::cis(angle);
        // W' of a cylinder of radius 3/2.
        (speed * (turn.conj() - 2.25 * turn / (z * z)) - Complex64::i() * gamma / (TAU * z)).conj()
    };
    for z in [Complex64::new(2.0, 1.0), Complex64::new(-1.5, -0.3), Complex64::new(0.3, 5.0), Complex64::new(1.8, -0.2)]
    {
        assert!((flow.velocity(&[z])[0] - exact(z)).norm() < 1e-10, "{z}");
    }
    let density = 1.2;
    assert!((flow.lift(density) + density * speed * gamma).abs() < 1e-11);
    let force = flow.force(density) * Complex64::cis(-angle);
    assert!((force - Complex64::new(0.0, flow.lift(density))).norm() < 1e-9, "no drag, and Blasius agrees: {force}");
    for z in flow.stagnation_points() {
        assert!(exact(z).norm() < 1e-6, "{z}: {}", exact(z));
    }
    assert_eq!(flow.stagnation_points().len(), 2);
    // ψ is one number on the body and along the streamline that ends there.
    let on_body = flow.stream(&body[..5]);
    assert!(on_body.iter().all(|psi| (psi - on_body[0]).abs() < 1e-12), "{on_body:?}");
}

/// A circle around −1/10 through 1 goes to an airfoil by z + c²/z; c < 1 rounds its trailing edge.
#[test]
fn a_joukowski_airfoil() {
    let (middle, c) = (Complex64::new(-0.1, 0.08), 0.9);
    let trailing_point = Complex64::ONE;
    let radius = (trailing_point - middle).norm();
    let start = (trailing_point - middle).arg();
    let circle = |t: f64| middle + Complex64::from_polar(radius, start + t);
    let body = curve(256, |t| circle(t) + c * c / circle(t));
    let angle = 0.1;
    let flow = past(&body, Curve::Smooth, angle, &Circulation::Kutta { trailing: vec![0] });
    // The point of the circle that trails rests: Γ = −4πRU sin(α − arg).
    let gamma = -2.0 * TAU * radius * 2.0 * (angle - start).sin();
    assert!((flow.circulation()[0] - gamma).abs() < 1e-10, "{} {gamma}", flow.circulation()[0]);
    assert!((flow.lift(1.0) + 2.0 * gamma).abs() < 1e-10);
    let force = flow.force(1.0) * Complex64::cis(-angle);
    assert!((force - Complex64::new(0.0, flow.lift(1.0))).norm() < 1e-9, "{force}");
    assert!(flow.stagnation_points().iter().any(|z| (z - body[0]).norm() < 1e-6), "{:?}", flow.stagnation_points());
}

/// A flat rhombus: thin airfoils have the slope 2π of the lift coefficient by the angle, thickness adds to it.
#[test]
fn corners_trail() {
    let body = points(&[[1.0, 0.0], [0.0, 0.02], [-1.0, 0.0], [0.0, -0.02]]);
    let lift = |angle: f64| past(&body, Curve::Polygon, angle, &Circulation::Kutta { trailing: vec![0] }).lift(1.0);
    assert!(lift(0.0).abs() < 1e-9, "{}", lift(0.0));
    // Chord 2, speed 2: L = ½ρU² · chord · C.
    let slope = lift(0.01) / 0.01f64.sin() / 4.0;
    assert!(slope > TAU && slope < 1.03 * TAU, "{slope}");
    let flow = past(&body, Curve::Polygon, 0.1, &Circulation::Kutta { trailing: vec![0] });
    let beside = flow.velocity(&[Complex64::new(1.0 + 1e-9, 0.0), Complex64::new(-1.0 - 1e-9, 0.0)]);
    assert!(beside[0].norm() < 3.0 && beside[1].norm() > 100.0, "{beside:?}");
}

#[test]
fn what_cannot_be_is_refused() {
    let outside = Domain::exterior(&[super::square(1.0)], Curve::Polygon).unwrap();
    let past = |speed: f64, circulation: &Circulation| {
        PotentialFlow::past(&outside, speed, 0.0, circulation, &options(1e-6), &mut |_, _| true).unwrap_err().code()
    };
    assert_eq!(past(0.0, &Circulation::Given(vec![0.0])), "invalid-option");
    assert_eq!(past(f64::NAN, &Circulation::Given(vec![0.0])), "invalid-option");
    assert_eq!(past(1.0, &Circulation::Given(vec![])), "wrong-length");
    assert_eq!(past(1.0, &Circulation::Kutta { trailing: vec![7] }), "invalid-option");
}
