//! A third, independent check: random walkers count the harmonic measure of each wall.

use super::{report, rounds};
use crate::support::random::{self, Random};
use crate::support::{largest, solve};
use conformal_warp::{Complex64, Region};
use std::f64::consts::TAU;

/// Where a walker that jumps to the edge of the largest circle around it meets the wall.
fn walk(region: &Region, random: &mut Random) -> usize {
    let size = region.polygon().size();
    let mut at = region.center();
    loop {
        let nearest = region.nearest(at);
        let distance = (nearest.point - at).norm();
        if distance < 1e-6 * size {
            return nearest.edge;
        }
        at += Complex64::from_polar(distance, random.between(0.0, TAU));
    }
}

#[test]
fn walkers_meet_each_wall_as_often_as_the_map_says() {
    let walkers = 20_000 * rounds().min(50);
    let mut worst: f64 = 0.0;
    for seed in [7, 19, 23] {
        let mut random = Random::new(seed);
        let region = random::region(&mut random);
        let map = solve(&region, 1e-8);
        let n = map.angles().len();
        let mut met = vec![0u64; n];
        for _ in 0..walkers {
            met[walk(&region, &mut random)] += 1;
        }
        let share = |k: usize| (map.angles()[(k + 1) % n] - map.angles()[k]).rem_euclid(TAU) / TAU;
        // Counts scatter by the root of p (1 − p)/N; a walker that ends beside a corner may take its neighbour for the wall.
        let off = largest((0..n).map(|k| {
            let scatter = (share(k) * (1.0 - share(k)) / walkers as f64).sqrt() + 1.0 / walkers as f64;
            (met[k] as f64 / walkers as f64 - share(k)).abs() / scatter
        }));
        assert!(off < 5.0, "seed {seed}: {off} standard deviations");
        worst = worst.max(off);
    }
    report(&format!("walkers: 3 regions, {walkers} each, at most {worst:.1} standard deviations off"));
}
