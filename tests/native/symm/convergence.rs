//! How fast the error of a smooth curve's map falls: geometrically with the nodes. Panels and degrees of polygons are
//! compared inside `src/symm`.

use crate::support::{angle_error, exact, largest};
use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions, Stop};
use std::f64::consts::TAU;

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
