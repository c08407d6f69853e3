//! Disk → region for a few points: each by Newton's method, while a chart's tree is not worth building.

use super::super::rounding::is_on_circle;
use super::accuracy::Accuracy;
use super::charts::{Atlas, TAKE_OVER};
use super::disk_side::Source;
use super::inverse_cell::{Inverter, Pair};
use super::region_side::RegionSide;
use crate::plane::Complex64;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Known points are told apart by so many directions,
const DIRECTIONS: f64 = 128.0;

/// Pairs (w, z) to start from, all over a chart's disk.
#[derive(Clone, Debug)]
pub struct Seeds(Vec<Pair>);

impl Seeds {
    /// From what the region's cells know; one for each direction and doubling of the distance from the circle.
    #[must_use]
    pub fn new(atlas: &Atlas, region: &RegionSide, chart: usize) -> Self {
        let mut kept = HashMap::new();
        for (z, w, own) in region.cells.centers() {
            let w = atlas.link(chart, own).apply(w);
            let square = w.norm_sqr();
            if square < 1.0 {
                let depth = (1.0 - square).log2().floor() as i32;
                kept.entry(((w.arg() * DIRECTIONS / TAU) as i32, depth)).or_insert((w, z));
            }
        }
        kept.insert((0, i32::MAX), (Complex64::ZERO, atlas.charts[chart].center()));
        let mut seeds: Vec<_> = kept.into_iter().collect();
        seeds.sort_unstable_by_key(|(key, _)| *key);
        Self(seeds.into_iter().map(|(_, pair)| pair).collect())
    }

    /// The nearest in the hyperbolic plane.
    fn nearest(&self, w: Complex64) -> Pair {
        let apart = |pair: &Pair| (pair.0 - w).norm_sqr() / (1.0 - pair.0.norm_sqr());
        let nearer = |a: (f64, Pair), &b: &Pair| if apart(&b) < a.0 { (apart(&b), b) } else { a };
        self.0.iter().fold((f64::INFINITY, self.0[0]), nearer).1
    }

    /// w → z for a point of the closed disk, or the chart to ask; `None` where Newton's method fails.
    #[must_use]
    pub fn at(
        &self,
        atlas: &Atlas,
        region: &RegionSide,
        chart: usize,
        accuracy: Accuracy,
        w: Complex64,
    ) -> Option<Source> {
        if let Some(best) = atlas.better_chart(chart, w, TAKE_OVER) {
            return Some(Source::Chart(best));
        }
        if is_on_circle(w) {
            let z = atlas.charts[chart].boundary_point(w.arg() / TAU);
            // Beside a corner the patch knows better than numbers that count from vertex 0.
            let patch = region.patch_at(z).filter(|patch| patch.chart == chart);
            let z = patch.map_or(z, |patch| patch.zone.point(patch.straightened(w)));
            return Some(Source::Point(z, Complex64::ZERO));
        }
        let z = Inverter::new(atlas, region, chart, accuracy).point(self.nearest(w), w)?;
        Some(Source::Point(z, Complex64::ZERO))
    }
}
