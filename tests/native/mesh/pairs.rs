//! Region → region: random pairs of simple polygons, with spikes, re-entrant corners and mazes.
//!
//! `MESH_PAIRS=2000 [MESH_FIRST=0] cargo test --release --test native mesh::pairs -- --nocapture` runs the long version, and
//! says which pairs took longest and which are refused why.

use crate::support::random::{self, Random};
use conformal_warp::{Error, JointTriangulation, MeshOptions, RiemannMap, SolveOptions};

/// Pairs of the short version: of all kinds, quick to solve. 14, 39, 57, 163 and 175 crowd corners together beyond double
/// precision; 1081 had no room for its mended places;
/// for 645 a series was once asked for across a wall; in 6 and 18 the `toward` lies where rounding carries angles across 0; 1 was once refused as crowded.
const QUICK: [u64; 25] =
    [1, 3, 5, 6, 7, 10, 12, 14, 16, 18, 37, 39, 41, 44, 45, 57, 59, 61, 65, 105, 163, 175, 324, 645, 1081];

fn pairs() -> Vec<u64> {
    let number = |name: &str| std::env::var(name).ok().map(|text| text.parse::<u64>().unwrap());
    let first = number("MESH_FIRST").unwrap_or(0);
    number("MESH_PAIRS").map_or(QUICK.to_vec(), |count| (first..first + count).collect())
}

/// Two random regions, solved.
fn maps(seed: u64) -> Result<[RiemannMap; 2], Error> {
    let mut random = Random::new(seed);
    let mut map = || {
        let region = random::region(&mut random);
        let options = SolveOptions { tolerance: 1e-5, max_charts: 4, ..SolveOptions::default() };
        RiemannMap::solve(&region, &options, &mut |_, _| true)
    };
    let (a, b) = (map(), map());
    Ok([a?, b?])
}

/// The mesh of a pair, which must be right; an error only of the kinds that a region may earn.
fn triangulated(seed: u64) -> Result<JointTriangulation, Error> {
    let maps = maps(seed)?;
    let spacing = maps[0].region().polygon().area().sqrt() / 12.0;
    let mesh = JointTriangulation::region_to_region(&maps[0], &maps[1], &MeshOptions::with_spacing(spacing))?;
    mesh.validate().unwrap_or_else(|error| panic!("pair {seed}: {error}"));
    assert_eq!(mesh.flipped(), 0, "pair {seed}");
    for (copy, map) in [mesh.source(), mesh.target()].into_iter().zip(&maps) {
        assert!(map.region().boundary().iter().all(|vertex| copy.contains(vertex)), "pair {seed}");
    }
    Ok(mesh)
}

/// Seconds that this thread has computed, where the system says so.
fn seconds() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split_whitespace().next()?.parse::<f64>().ok()? * 1e-9)
}

#[test]
fn random_pairs_are_triangulated() {
    let is_long = std::env::var_os("MESH_PAIRS").is_some();
    let (mut refused, mut apart, mut times) = (0, 0, Vec::new());
    for seed in pairs() {
        let start = seconds();
        let mesh = triangulated(seed);
        if let (Some(start), Some(end)) = (start, seconds()) {
            times.push((end - start, seed));
        }
        if let Err(error) = mesh {
            match error.code() {
                "crowded" | "negative-mass" => refused += 1,
                "too-far-apart" => apart += 1,
                _ => panic!("pair {seed}: {error}"),
            }
            if is_long {
                println!("pair {seed} is refused: {error}");
            }
        }
        if is_long && times.last().is_some_and(|(time, _)| *time > 3.0) {
            println!("pair {seed} took {:.1} s", times[times.len() - 1].0);
        }
    }
    if is_long {
        let all: f64 = times.iter().map(|(time, _)| time).sum();
        times.sort_by(|a, b| b.0.total_cmp(&a.0));
        times.truncate(8);
        println!(
            "{} pairs, {refused} refused, {apart} too far apart, {all:.0} s of computing; the slowest: {times:.1?}",
            pairs().len()
        );
    }
    // About one pair in twenty has mazes whose far ends nobody can tell, one in five hundred a region that cannot be solved.
    assert!(10 * apart <= pairs().len(), "{apart} of {} are too far apart", pairs().len());
    assert!(250 * refused <= pairs().len(), "{refused} of {} are refused", pairs().len());
}
