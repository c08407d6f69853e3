//! Long runs: solves cancelled at every stage, and what is usable afterwards.

use super::{report, rounds};
use crate::support::random::{self, Random};
use conformal_warp::{Error, JointTriangulation, MeshOptions, RiemannMap, SolveOptions};

/// A cancel after so many reports of progress.
fn after(reports: usize) -> impl FnMut(&str, f64) -> bool {
    let mut left = reports;
    move |_: &str, share: f64| {
        assert!((0.0..=1.0).contains(&share), "progress {share}");
        let goes_on = left > 0;
        left = left.saturating_sub(1);
        goes_on
    }
}

/// Reports after which is cancelled: all early ones, later ones ever further apart.
fn stages() -> impl Iterator<Item = usize> {
    (0..).map(|k: u32| if k < 6 { k as usize } else { 6 << ((k - 6) / 2) })
}

#[test]
fn whatever_is_cancelled_stops_and_leaves_the_rest_usable() {
    let tried = 6 * rounds();
    let (mut cancelled, mut finished) = (0u64, 0u64);
    for seed in 0..tried {
        let mut random = Random::new(6_000_000 + seed);
        let region = random::region(&mut random);
        let options = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
        let whole = RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap();
        let expected = whole.to_disk(&[region.center() + 0.01 * (region.toward().point - region.center())]);
        for reports in stages() {
            match RiemannMap::solve(&region, &options, &mut after(reports)) {
                Err(Error::Cancelled) => cancelled += 1,
                Ok(map) => {
                    assert_eq!(map.angles(), whole.angles(), "seed {seed}: a solve depends on what was cancelled");
                    finished += 1;
                    break;
                }
                Err(error) => panic!("seed {seed}: {error}"),
            }
        }
        let map = RiemannMap::solve(&region, &options, &mut |_, _| true).unwrap();
        for reports in stages() {
            match map.prepare(&mut after(reports)) {
                Err(Error::Cancelled) => cancelled += 1,
                Ok(()) => break,
                Err(error) => panic!("seed {seed}: {error}"),
            }
        }
        let mesh = MeshOptions::with_spacing(0.2);
        for reports in stages() {
            match JointTriangulation::region_to_disk_with(&map, &mesh, &mut after(reports)) {
                Err(Error::Cancelled) => cancelled += 1,
                Ok(_) | Err(Error::Crowded { .. }) => break,
                Err(error) => panic!("seed {seed}: {error}"),
            }
        }
        let found = map.to_disk(&[region.center() + 0.01 * (region.toward().point - region.center())]);
        assert_eq!(found, expected, "seed {seed}: an answer depends on what was cancelled");
    }
    report(&format!("cancelling: {cancelled} cancelled at every report, {finished} finished, answers the same bits"));
}
