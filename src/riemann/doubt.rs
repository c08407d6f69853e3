//! How far errors may move what a map between regions gives.
//!
//! The disks of two regions are laid on each other by center and `toward`, as exactly as both maps know them. At the hyperbolic
//! distance h from the ray center–toward an error grows by e^h, and with it what the far ends of long regions are off.

use super::RiemannMap;
use super::atlas::Compass;
use crate::plane::Complex64;

/// A place is another one from this share of the region's size on,
const ANOTHER_PLACE: f64 = 0.01;
/// or from this times the error, where maps are solved so loosely.
const OFTEN: f64 = 100.0;
/// What is off by this in a chart's disk may lie beyond the chart.
const BEYOND_CHART: f64 = 0.5;
/// Charts stretch a region by no more than the inverse of this, in units of its size, unless they crowd it together.
const LEAST_STRETCH: f64 = 0.05;

/// What errors leave open of the places in one region.
#[derive(Clone, Debug)]
pub(super) struct Doubt {
    /// For each chart, by how much they move a point in its disk.
    shifts: Vec<f64>,
    /// Plane units from which on a place is another one.
    limit: f64,
    /// Shifts below this move nothing so far.
    harmless: f64,
}

impl Doubt {
    /// `error` is that of the directions around the center.
    pub(super) fn new(map: &RiemannMap, compass: &Compass, error: f64) -> Self {
        let shifts = compass.positions.iter().map(|position| error * position.growth(&compass.toward)).collect();
        let share = ANOTHER_PLACE.max(OFTEN * error);
        let harmless = if map.crowded_at().is_some() { 0.0 } else { LEAST_STRETCH * share };
        Self { shifts, limit: share * map.region().polygon().size(), harmless }
    }

    /// Whether errors may have brought `z` here from another place. `map` is that of the region.
    pub(super) fn doubts(&self, map: &RiemannMap, z: Complex64) -> bool {
        if !self.shifts.iter().any(|shift| *shift > self.harmless) {
            return false;
        }
        let solved = map.solved();
        let Some(point) = solved.to_disk(z) else { return false };
        let shift = self.shifts[point.chart];
        if shift <= self.harmless {
            return false;
        }
        let inwards = if point.w == Complex64::ZERO { Complex64::ONE } else { point.w / point.w.norm() };
        let shifted = || solved.from_disk(point.map(|w| w - inwards * shift));
        shift > BEYOND_CHART || shifted().is_none_or(|shifted| (shifted - z).norm() > self.limit)
    }
}
