//! The error estimate is itself an answer: never below the true error; never more than a hundred times
//! above what is known of it, nor in the median above the truth.

use crate::support::{
    EXACT_CASES, angle_error, case, complex, exact, largest, largest_difference, points, polygon, solve,
};
use conformal_warp::{Complex64, Region, Stop};

fn regions() -> Vec<(String, Region)> {
    let names = EXACT_CASES.iter().chain(&["neck", "slot", "spike", "rect10", "rect20"]);
    let mut regions: Vec<_> = names.map(|name| (name.to_string(), case(name).region())).collect();
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    regions.push(("L".into(), polygon(&points(&corners), Complex64::new(0.5, 0.5))));
    for n in [3, 4, 7] {
        regions.push((format!("{n}-gon"), exact::regular(n)));
    }
    regions
}

#[test]
fn estimate_brackets_the_true_error() {
    let mut report = String::new();
    let (mut known, mut ratios) = (Vec::new(), Vec::new());
    let blobs = ["blob100", "blob300"].map(|name| (name.to_string(), case(name).region()));
    for (name, region) in regions().into_iter().chain(blobs) {
        let finest = match name.as_str() {
            "blob100" => 1e-6,
            "blob300" => 1e-4,
            _ => 1e-11,
        };
        let reference = solve(&region, finest * 1e-2);
        for tolerance in
            [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11].into_iter().filter(|t| *t >= finest)
        {
            let map = solve(&region, tolerance);
            let estimate = map.error_estimate();
            assert!(estimate <= tolerance, "{name} stopped short of {tolerance:e}: {estimate:e}");
            // The residual is |log|f|| at points of the boundary, where the exact value is 0: an error too.
            let error = largest_difference(&map, &reference);
            let ratio = estimate / error;
            known.push(estimate / largest([error, map.residual()]));
            ratios.push(ratio);
            report += &format!("{name} {tolerance:e}: error {error:.1e}, estimate {estimate:.1e}, ratio {ratio:.1}\n");
        }
    }
    assert!(known.iter().all(|ratio| (1.0..=100.0).contains(ratio)), "{report}");
    // Symmetric regions may be better than anyone knows: against the true error the promise is for the median.
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    assert!((1.0..=20.0).contains(&median), "{median}\n{report}");
}

/// A wall that ends in a very short edge between two re-entrant corners: opposite masses on its two faces hardly show in the
/// potential, so its tip's angle is wrong by far more than the residual.
#[test]
fn tips_of_thin_walls_are_in_the_estimate() {
    #[derive(serde::Deserialize)]
    struct Fault {
        boundary: Vec<[f64; 2]>,
        center: [f64; 2],
        expected: Expected,
    }
    #[derive(serde::Deserialize)]
    struct Expected {
        angles: Vec<f64>,
    }
    let fault: Fault =
        serde_json::from_str(include_str!("../../fixtures/faults/estimate_too_low_wall_tips.json")).unwrap();
    let region = polygon(&points(&fault.boundary), complex(fault.center));
    for tolerance in [1e-3, 1e-4, 1e-6, 1e-8, 1e-10] {
        let map = solve(&region, tolerance);
        assert_eq!(map.stop(), Stop::Tolerance);
        let error = largest(map.angles().iter().zip(&fault.expected.angles).map(|(a, b)| angle_error(*a, *b)));
        let estimate = map.error_estimate();
        assert!(error <= estimate && estimate <= tolerance, "{tolerance:e}: error {error:e}, estimate {estimate:e}");
    }
}
