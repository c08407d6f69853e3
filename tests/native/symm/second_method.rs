//! Polygons without closed answers: the Schwarz–Christoffel integral over the prevertices found must give them back.

use crate::support::{case, exact, largest, points, polygon, schwarz_christoffel::side_lengths, solve};
use conformal_warp::{Complex64, Region};
use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};

/// The largest relative error of the sides that are not crowded as seen from the region's center, and which those are.
fn side_error(region: &Region, tolerance: f64) -> (f64, Vec<usize>) {
    let map = solve(region, tolerance);
    let corners = region.polygon().vertices();
    let n = corners.len();
    let sides: Vec<Complex64> = (0..n).map(|k| corners[(k + 1) % n] - corners[k]).collect();
    // Interior angles over π.
    let alpha: Vec<f64> = (0..n).map(|k| 1.0 - (sides[k] / sides[(k + n - 1) % n]).arg() / PI).collect();
    let lengths = side_lengths(map.angles(), &alpha);
    // A prevertex known to 1e-13 fixes the sides beside a gap g only to 1e-13/g.
    let gap = |k: usize| (map.angles()[(k + 1) % n] - map.angles()[k]).rem_euclid(TAU);
    let clear = |k: usize| [(k + n - 1) % n, k, (k + 1) % n].iter().all(|&j| gap(j) > 1e-5);
    // Beside a very sharp corner most of the integral lies where doubles end.
    let integrable = |k: usize| [k, (k + 1) % n].iter().all(|&j| alpha[j] > 0.1);
    let seen: Vec<usize> = (0..n).filter(|&k| clear(k) && integrable(k)).collect();
    let factor = seen.iter().map(|&k| sides[k].norm()).sum::<f64>() / seen.iter().map(|&k| lengths[k]).sum::<f64>();
    let error = largest(seen.iter().map(|&k| (lengths[k] * factor / sides[k].norm() - 1.0).abs()));
    (error, seen)
}

#[test]
fn sides_come_back() {
    let slot_like =
        points(&[[0.0, 0.0], [3.0, 0.0], [3.0, 0.8], [1.0, 0.9], [1.0, 1.1], [3.0, 1.2], [3.0, 2.0], [0.0, 2.0]]);
    let regions = [
        (
            "L",
            polygon(
                &points(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]]),
                Complex64::new(0.5, 0.5),
            ),
        ),
        ("7-gon", exact::regular(7)),
        ("rectangle 2:1", exact::rectangle(2.0)),
        ("slot, wide", polygon(&slot_like, Complex64::new(0.5, 1.0))),
        ("sc_9_103", case("sc_9_103").region()),
        ("sc_24_105", case("sc_24_105").region()),
    ];
    for (name, region) in regions {
        let (error, seen) = side_error(&region, 1e-13);
        assert_eq!(seen.len(), region.polygon().len(), "{name}: every side must be seen");
        assert!(error < 1e-8, "{name}: {error:e}");
    }
}

/// Long and narrow regions crowd their far ends together; seen from several centers, every side is checked somewhere.
#[test]
fn sides_of_crowded_regions_come_back() {
    let c = |x: f64, y: f64| Complex64::new(x, y);
    let looks: [(&str, Vec<Complex64>, usize); 4] = [
        ("neck", vec![c(-1.5, 0.0), c(1.5, 0.0)], 10),
        ("slot", vec![c(-0.5, 0.0), c(0.8, 0.4), c(0.8, -0.4)], 8),
        ("spike", vec![c(0.0, 0.0)], 5),
        ("rect10", vec![c(-9.5, 0.0), c(9.5, 0.0)], 2),
    ];
    for (name, centers, least) in looks {
        let region = case(name).region();
        let mut checked = BTreeSet::new();
        for center in centers {
            let look = Region::new(region.boundary(), region.curve(), center, region.boundary()[0]).unwrap();
            let (error, seen) = side_error(&look, 1e-13);
            assert!(error < 1e-8, "{name} from {center}: {error:e} on sides {seen:?}");
            checked.extend(seen);
        }
        assert!(checked.len() >= least, "{name}: only sides {checked:?} seen");
    }
}
