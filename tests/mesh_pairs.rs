//! Region → region: random pairs of simple polygons, with spikes, re-entrant corners and mazes.
//!
//! `MESH_PAIRS=2000 [MESH_FIRST=0] cargo test --release --test mesh_pairs` runs the long version.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod support;

use conformal_warp::map::{RiemannMap, SolveOptions};
use conformal_warp::mesh::{JointTriangulation, MeshOptions};
use support::Random;

/// Pairs of the short version: of all kinds, small enough to be solved and inverted quickly.
const QUICK: [u64; 7] = [7, 41, 44, 45, 59, 65, 105];

fn pairs() -> Vec<u64> {
    let number = |name: &str| std::env::var(name).ok().map(|text| text.parse::<u64>().unwrap());
    let first = number("MESH_FIRST").unwrap_or(0);
    number("MESH_PAIRS").map_or(QUICK.to_vec(), |count| (first..first + count).collect())
}

/// The smallest angle on the circle between neighbouring corners: how much a map crowds.
fn smallest_gap(map: &RiemannMap) -> f64 {
    let mut angles = map.angles().to_vec();
    angles.sort_by(f64::total_cmp);
    angles.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min)
}

#[test]
fn random_pairs_are_triangulated_or_refused_in_words() {
    let (mut made, mut refused) = (0, 0);
    for seed in pairs() {
        let mut random = Random::new(seed);
        let maps = [0, 1].map(|_| {
            let region = support::region(&mut random);
            let options = SolveOptions { tolerance: 1e-8, ..SolveOptions::default() };
            RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap()
        });
        let spacing = maps[0].region().polygon().area().sqrt() / 12.0;
        let crowding = maps.iter().map(smallest_gap).fold(f64::INFINITY, f64::min);
        match JointTriangulation::region_to_region(&maps[0], &maps[1], &MeshOptions::with_spacing(spacing)) {
            Ok(mesh) => {
                mesh.validate().unwrap_or_else(|error| panic!("pair {seed}: {error}"));
                assert_eq!(mesh.flipped(), 0, "pair {seed}");
                for (copy, map) in [mesh.source(), mesh.target()].into_iter().zip(&maps) {
                    assert!(map.region().boundary().iter().all(|vertex| copy.contains(vertex)), "pair {seed}");
                }
                made += 1;
            }
            Err(error) => {
                println!("pair {seed}: corners {crowding:.0e} apart on the circle: {error}");
                assert_eq!(error.code(), "crowded", "pair {seed}: {error}");
                assert!(crowding < 1e-4, "pair {seed} is refused, although its corners are {crowding} apart");
                refused += 1;
            }
        }
    }
    println!("{made} made, {refused} refused");
    assert!(made > refused);
}
