//! How fast the error falls: exponentially with the degree, algebraically with the number of panels, geometrically with the
//! nodes of a smooth curve.

use crate::support::{angle_error, boundary_points, exact, largest, points, polygon, solve};
use conformal_warp::Stop;
use conformal_warp::symm::correspondence::BoundaryCorrespondence;
use conformal_warp::symm::discretisation::Discretisation;
use conformal_warp::symm::order::Order;
use conformal_warp::symm::panel::{Boundary, Panel, initial_panels};
use conformal_warp::symm::potential::LogPotential;
use conformal_warp::symm::rule::Rules;
use conformal_warp::symm::solution::Solution;
use conformal_warp::symm::system::System;
use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
use std::f64::consts::TAU;
use std::sync::Arc;

fn l_shape() -> Region {
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    polygon(&points(&corners), Complex64::new(0.5, 0.5))
}

/// Largest error of θ on the boundary with given panels and p unknowns each, and the number of unknowns.
fn error_with(region: &Region, reference: &RiemannMap, panels: Vec<Panel>, p: usize) -> (f64, usize) {
    let boundary = Arc::new(Boundary::new(region.polygon()));
    let center = region.center() * boundary.unit;
    let discretisation = Discretisation::new(boundary, panels, &mut Rules::new(Order::new(p, 15.5)));
    let system = System::new(discretisation, &mut |_, _| true).unwrap();
    let outcome = system.solve(center, 1e-16, None, &mut |_, _| true).unwrap();
    let correspondence = BoundaryCorrespondence::new(&system.discretisation, &outcome.masses);
    let solution = Solution {
        correspondence,
        potential: LogPotential::new(&outcome.masses),
        residual: outcome.residual(),
        error_estimate: f64::NAN,
        stop: Stop::SamePanels,
        system: Arc::new(system),
        center,
        masses: outcome.masses,
    };
    let errors = boundary_points(region)
        .into_iter()
        .map(|point| angle_error(TAU * solution.measure_at(point), reference.boundary_angle(point)));
    (largest(errors), solution.masses.len())
}

#[test]
fn exponential_in_the_degree() {
    let region = l_shape();
    let reference = solve(&region, 1e-13);
    let panels = initial_panels(&Boundary::new(region.polygon()), 0.5);
    let errors: Vec<f64> =
        [2, 4, 6, 8, 10, 12, 14].map(|p| error_with(&region, &reference, panels.clone(), p).0).to_vec();
    for pair in errors.windows(2) {
        assert!(pair[1] < pair[0] / 5.0, "two degrees more should gain a factor of 5 at least: {errors:?}");
    }
    assert!(errors[6] < 1e-7, "{errors:?}");
}

#[test]
fn algebraic_in_the_panels() {
    let region = l_shape();
    let reference = solve(&region, 1e-13);
    for p in [2, 3] {
        let mut panels = initial_panels(&Boundary::new(region.polygon()), 0.5);
        let mut errors = Vec::new();
        for _ in 0..4 {
            errors.push(error_with(&region, &reference, panels.clone(), p));
            panels = panels.iter().flat_map(Panel::halves).collect();
        }
        let (first, last) = (errors[1], errors[3]);
        let order = (first.0 / last.0).ln() / (last.1 as f64 / first.1 as f64).ln();
        // A panel at the corner of angle 3π/2 holds powers of s^(2/3): halving it gains 2^(p/1.5) at least.
        assert!(order > p as f64 / 1.5, "order {order} with p = {p}: {errors:?}");
    }
}

/// The density of an ellipse is analytic in a strip of half-width ½ log((a+b)/(a−b)) about the real t: four nodes more gain
/// a factor (a−b)/(a+b).
#[test]
fn geometric_in_the_nodes_of_a_smooth_curve() {
    let points: Vec<_> =
        (0..100).map(|j| TAU * f64::from(j) / 100.0).map(|t| Complex64::new(5.0 * t.cos(), t.sin())).collect();
    let region = Region::new(&points, Curve::Smooth, Complex64::ZERO, points[0]).unwrap();
    let nodes = [64, 128];
    let errors = nodes.map(|n| {
        let options = SolveOptions { tolerance: 1e-14, max_unknowns: n, ..SolveOptions::default() };
        let map = RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap();
        assert_eq!((map.stop(), map.unknowns()), (Stop::MaxUnknowns, n));
        let exact = points.iter().map(|z| exact::ellipse(5.0, 1.0, *z).0.arg());
        largest(map.angles().iter().zip(exact).map(|(a, b)| angle_error(*a, b)))
    });
    let factor = (errors[1] / errors[0]).powf(4.0 / (nodes[1] - nodes[0]) as f64);
    assert!((0.58..0.72).contains(&factor), "each 4 nodes should give a factor of 2/3: {errors:?}");
}
