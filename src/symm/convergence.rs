//! How fast the error falls: exponentially with the degree, algebraically with the number of panels.

use super::discretisation::Discretisation;
use super::options::{SolveOptions, Stop};
use super::order::Order;
use super::panel::{Boundary, Panel, initial_panels};
use super::problem::Problem;
use super::rule::Rules;
use super::solution::Solution;
use super::solve::solve;
use super::system::System;
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Curve, Region};
use std::f64::consts::TAU;
use std::sync::Arc;

fn l_shape() -> Result<Region> {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    let corners = corners.map(|(x, y)| Complex64::new(x, y));
    Region::new(&corners, Curve::Polygon, Complex64::new(0.5, 0.5), corners[0])
}

/// The region solved as well as doubles allow.
fn reference(region: &Region) -> Result<Solution> {
    solve(region, &SolveOptions { tolerance: 1e-13, ..SolveOptions::default() }, &mut |_, _| true)
}

/// Points of the boundary that crowd towards the ends of each edge.
fn boundary_points(region: &Region) -> Vec<BoundaryPoint> {
    let shares = [0.0, 1e-6, 1e-4, 0.003, 0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.62, 0.8, 0.93, 0.97, 0.995, 0.999];
    let polygon = region.polygon();
    let on_edge = |edge: usize| {
        let (a, b) = polygon.edge(edge);
        shares.map(|t| BoundaryPoint { edge, t, point: a + (b - a) * t })
    };
    (0..polygon.len()).flat_map(on_edge).collect()
}

/// Largest error of θ on the boundary with given panels and p unknowns each, and the number of unknowns.
fn error_with(region: &Region, reference: &Solution, panels: Vec<Panel>, p: usize) -> Result<(f64, usize)> {
    let boundary = Arc::new(Boundary::new(region.polygon()));
    let center = region.center() * boundary.unit;
    let discretisation = Discretisation::new(boundary, panels, &mut Rules::new(Order::new(p, 15.5)));
    let system = System::new(discretisation, &mut |_, _| true)?;
    let problem = Problem::measure(&system.discretisation.boundary, center);
    let outcome = system.solve(&problem, 1e-16, None, &mut |_, _| true)?;
    let (residual, masses) = (outcome.residual(), outcome.masses);
    let solution = Solution::new(system.discretisation, center, masses, residual, f64::NAN, Stop::SamePanels);
    let error = |point| {
        let turns: f64 = solution.measure_at(point) - reference.measure_at(point);
        TAU * (turns - turns.round()).abs()
    };
    let larger = |a: f64, b: f64| if a.is_nan() || b <= a { a } else { b };
    let errors = boundary_points(region).into_iter().map(error);
    Ok((errors.fold(0.0, larger), solution.masses.len()))
}

#[test]
fn exponential_in_the_degree() -> Result<()> {
    let region = l_shape()?;
    let reference = reference(&region)?;
    let panels = initial_panels(&Boundary::new(region.polygon()), 0.5);
    let mut errors = Vec::new();
    for p in [2, 4, 6, 8, 10, 12, 14] {
        errors.push(error_with(&region, &reference, panels.clone(), p)?.0);
    }
    for pair in errors.windows(2) {
        assert!(pair[1] < pair[0] / 5.0, "two degrees more should gain a factor of 5 at least: {errors:?}");
    }
    assert!(errors[6] < 1e-7, "{errors:?}");
    Ok(())
}

#[test]
fn algebraic_in_the_panels() -> Result<()> {
    let region = l_shape()?;
    let reference = reference(&region)?;
    for p in [2, 3] {
        let mut panels = initial_panels(&Boundary::new(region.polygon()), 0.5);
        let mut errors = Vec::new();
        for _ in 0..4 {
            errors.push(error_with(&region, &reference, panels.clone(), p)?);
            panels = panels.iter().flat_map(Panel::halves).collect();
        }
        let (first, last) = (errors[1], errors[3]);
        let order = (first.0 / last.0).ln() / (last.1 as f64 / first.1 as f64).ln();
        // A panel at the corner of angle 3π/2 holds powers of s^(2/3): halving it gains 2^(p/1.5) at least.
        assert!(order > p as f64 / 1.5, "order {order} with p = {p}: {errors:?}");
    }
    Ok(())
}
