//! Regions on which evaluation once took minutes, lost its digits or gave NaN: the work is bounded, the answers hold.

use crate::support::{c, case, complex, largest, points, share, solve};
use conformal_warp::{Complex64, Curve, Error, Region, RiemannMap, SolveOptions};
use std::f64::consts::TAU;

fn region(vertices: &[[f64; 2]], center: [f64; 2], toward: [f64; 2]) -> Region {
    Region::new(&points(vertices), Curve::Polygon, complex(center), complex(toward)).unwrap()
}

/// The coast of Taiwan, cut down to a spit of 3.4 degrees beside a bay.
fn spit() -> Region {
    let coast = [
        [121.906, 24.949],
        [120.841, 21.925],
        [120.333, 22.519],
        [120.286, 22.58],
        [120.333, 22.526],
        [120.088, 23.117],
    ];
    region(&coast, [120.811, 23.504], [121.906, 24.949])
}

/// A chamber of size 2 whose door leads to a room of size 20,000.
fn chamber() -> Region {
    let far = 10_000.0;
    let mut walls = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, -0.25], [1.2, -0.25], [1.2, -far], [2.0 * far + 1.2, -far]];
    walls.extend(walls.clone().into_iter().rev().map(|[x, y]| [x, -y]));
    region(&walls, [-0.3, 0.0], [-1.0, 0.0])
}

fn spread_over_disk(count: usize) -> Vec<Complex64> {
    let point = |k| Complex64::from_polar(0.99 * share(k, 0.618_034).sqrt(), TAU * share(k, 0.754_878));
    (1..=count).map(point).collect()
}

/// Where two charts met in the spike of this coast, 400,000 squares were cut for nothing: 6 MB.
#[test]
fn the_way_back_into_a_spike_is_bounded() {
    let map = solve(&spit(), 1e-4);
    map.prepare(&mut |_, _| true).unwrap();
    assert!(map.evaluator_bytes() < 1_000_000, "{} bytes", map.evaluator_bytes());
    let w = spread_over_disk(2000);
    let there_and_back = map.to_disk(&map.from_disk(&w));
    let worst = largest(there_and_back.iter().zip(&w).map(|(a, b)| (a - b).norm()));
    assert!(worst <= map.error_estimate(), "{worst:e} against {:e}", map.error_estimate());
}

/// A small chamber beside a room 10,000 times larger: errors are relative to the chamber.
#[test]
fn small_chambers_of_large_regions_keep_their_digits() {
    let map = solve(&chamber(), 1e-8);
    let w = spread_over_disk(20_000);
    let there_and_back = map.to_disk(&map.from_disk(&w));
    let worst = largest(there_and_back.iter().zip(&w).map(|(a, b)| (a - b).norm()));
    assert!(worst <= map.error_estimate(), "{worst:e} against {:e}", map.error_estimate());
}

/// What is crowded at the far end of a long region comes back roughly, but it comes back.
#[test]
fn crowded_far_ends_come_back() {
    let region = region(&[[0.0, 0.0], [16.0, 0.0], [16.0, 1.0], [0.0, 1.0]], [0.5, 0.5], [0.0, 0.5]);
    let map = solve(&region, 1e-8);
    let grid = (0..4000).map(|k| c(16.0 * share(k, 0.618_034), share(k, 0.754_878)));
    let w = map.to_disk(&grid.filter(|z| region.contains(*z)).collect::<Vec<_>>());
    assert!(w.iter().all(|w| w.norm() <= 1.0 + 2.0 * f64::EPSILON));
    assert!(map.from_disk(&w).iter().all(|z| z.re.is_finite() && z.im.is_finite()));
}

/// The same question has the same answer, alone or among many, whatever was asked before.
#[test]
fn answers_do_not_depend_on_history() {
    let region = spit();
    let w = spread_over_disk(12_000);
    let one_by_one: Vec<Complex64> = {
        let map = solve(&region, 1e-4);
        w.iter().flat_map(|&w| map.from_disk(&[w])).collect()
    };
    assert_eq!(solve(&region, 1e-4).from_disk(&w), one_by_one);
}

/// The first point of ten thousand vertices took minutes and 4.3 GB.
#[test]
fn ten_thousand_vertices_are_evaluated_in_bounded_memory() {
    let map = solve(&case("blob10000").region(), 1e-3);
    let w = spread_over_disk(1000);
    let there_and_back = map.to_disk(&map.from_disk(&w));
    assert!(map.evaluator_bytes() < 500_000_000, "{} bytes", map.evaluator_bytes());
    let worst = largest(there_and_back.iter().zip(&w).map(|(a, b)| (a - b).norm()));
    assert!(worst <= map.error_estimate(), "{worst:e} against {:e}", map.error_estimate());
}

/// 40:1, seen from one end.
fn strip() -> Region {
    region(&[[0.0, 0.0], [40.0, 0.0], [40.0, 1.0], [0.0, 1.0]], [0.5, 0.5], [0.0, 0.5])
}

/// Cancelled at any stage, solves of charts included, a build leaves nothing that changes the next one.
#[test]
fn a_cancelled_build_can_be_tried_again() {
    let options = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
    let solve = || RiemannMap::solve(&strip(), &options, &mut |_, _| true).unwrap();
    let (map, fresh) = (solve(), solve());
    let mut stages = Vec::new();
    fresh
        .prepare(&mut |stage, fraction| {
            assert!((0.0..=1.0).contains(&fraction), "{stage}: {fraction}");
            stages.push(stage);
            true
        })
        .unwrap();
    assert!(fresh.charts() > 1 && stages.contains(&"solve") && stages.contains(&"expand"), "{stages:?}");
    // What is finished: nothing, one chart's way to the disk, or both its ways.
    let one_way = solve();
    let w = one_way.to_disk(&[c(1.0, 0.5)]);
    let finished = [0, one_way.evaluator_bytes(), {
        assert_eq!(one_way.from_disk(&w).len(), 1);
        one_way.evaluator_bytes()
    }];
    for at in [0, stages.len() / 3, stages.len() / 2] {
        let mut left = at;
        let cancelled = map.prepare(&mut |_, _| {
            left = left.wrapping_sub(1);
            left != usize::MAX
        });
        assert_eq!(cancelled, Err(Error::Cancelled), "after {at} of {}", stages.len());
        let bytes = map.evaluator_bytes();
        assert!(finished.contains(&bytes), "after {at} of {}: {bytes} bytes", stages.len());
    }
    map.prepare(&mut |_, _| true).unwrap();
    assert_eq!(map.evaluator_bytes(), fresh.evaluator_bytes());
    let w = spread_over_disk(2000);
    let z = map.from_disk(&w);
    assert_eq!(z, fresh.from_disk(&w));
    assert_eq!(map.to_disk(&z), fresh.to_disk(&z));
}

/// With one chart the far end of a strip is crowded and said to be; with as many as it needs it is not.
#[test]
fn accepted_crowding_is_said() {
    let crowded_at = |max_charts| {
        let options = SolveOptions { tolerance: 1e-6, max_charts, ..SolveOptions::default() };
        RiemannMap::solve(&strip(), &options, &mut |_, _| true).unwrap().crowded_at()
    };
    let place = crowded_at(1).unwrap();
    assert!(place.re > 5.0 && strip().contains(place), "{place}");
    assert_eq!(crowded_at(64), None);
}

/// A corridor of many widths, seen from its middle.
fn corridor(length: f64) -> Region {
    region(&[[0.0, 0.0], [length, 0.0], [length, 1.0], [0.0, 1.0]], [0.5 * length, 0.5], [0.0, 0.0])
}

/// A corridor 60 times as long as wide has 20 charts, none of which is solved for until somebody asks for an end.
#[test]
fn charts_are_solved_when_they_are_asked_for() {
    let (map, before) = (solve(&corridor(60.0), 1e-8), solve(&corridor(60.0), 1e-8));
    let (near, far) = ([c(30.3, 0.4), c(29.0, 0.9)], [c(3.0, 0.2), c(55.0, 0.7)]);
    let (first, back) = (map.to_disk(&near), map.from_disk(&map.to_disk(&near)));
    let alone = map.evaluator_bytes();
    let ends = map.to_disk_points(&far);
    assert!(map.evaluator_bytes() > 3 * alone, "{alone} bytes, then {}", map.evaluator_bytes());
    let apart = largest(map.from_disk_points(&ends).iter().zip(&far).map(|(a, b)| (a - b).norm()));
    assert!(apart <= 1e-6, "{apart:e}");
    // In the other order the answers have the same bits.
    assert_eq!(before.to_disk_points(&far), ends);
    assert_eq!(before.to_disk(&near), first);
    assert_eq!(before.from_disk(&first), back);
}

/// Where there are not enough charts for all widths, far points come back roughly, and never as NaN.
#[test]
fn corridors_longer_than_their_charts_come_back() {
    let region = corridor(300.0);
    let map = solve(&region, 1e-8);
    let z: Vec<Complex64> = (0..2000)
        .map(|k| c(300.0 * share(k, 0.618_034), share(k, 0.754_878)))
        .filter(|z| region.contains(*z))
        .collect();
    for back in [map.from_disk_points(&map.to_disk_points(&z)), map.from_disk(&map.to_disk(&z))] {
        assert!(back.iter().all(|z| z.re.is_finite() && z.im.is_finite()));
    }
}

/// Nine teeth, each of which is far from the others: charts were tried, again and again, on parts that could not do.
#[test]
fn the_teeth_of_a_comb_come_back() {
    let tooth = |k: u32| {
        let x = 2.0 * f64::from(k);
        let gap = [[x, 1.0], [x - 1.0, 1.0]];
        [[x + 1.0, 5.0], [x, 5.0]].into_iter().chain(gap.into_iter().take(if k > 0 { 2 } else { 0 }))
    };
    let vertices: Vec<_> = [[0.0, 0.0], [17.0, 0.0]].into_iter().chain((0..9).rev().flat_map(tooth)).collect();
    let comb = region(&vertices, [8.0, 0.5], [0.0, 0.0]);
    let map = solve(&comb, 1e-6);
    let in_tooth =
        |k: u32| c(2.0 * f64::from(k % 9) + share(k as usize, 0.618_034), 5.0 * share(k as usize, 0.754_878));
    let z: Vec<Complex64> = (0..2000).map(in_tooth).filter(|z| comb.contains(*z)).collect();
    assert!(z.len() > 1900, "{}", z.len());
    let back = map.from_disk_points(&map.to_disk_points(&z));
    let worst = largest(z.iter().zip(&back).map(|(z, back)| (z - back).norm()));
    assert!(worst <= 1e-5, "{worst:e}");
}
