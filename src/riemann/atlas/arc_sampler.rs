//! A function on the arc of a zone, from as few power series as serve.

use super::power_series::{MAX_COEFFICIENTS, value_and_slope};
use super::zone::{Place, SHARE, Zone};
use crate::plane::{Complex64, NOWHERE};
use std::f64::consts::PI;

/// Writes the coefficients of tᵏ of a function at center + radius·t.
pub type Expand<'a> = &'a dyn Fn(Complex64, f64, &mut [Complex64]);

/// A function along the arc of a zone, by its expansions.
pub struct ArcSampler<'a> {
    expand: Expand<'a>,
    center: Complex64,
    /// The series is in (z − center)/unit,
    unit: f64,
    /// and good this far from the center.
    reach: f64,
    /// Share of the distance to a singularity in which a series is accurate.
    share: f64,
    coefficients: [Complex64; TERMS],
}

/// Coefficients of the series.
const TERMS: usize = 24;
const _: () = assert!(TERMS <= MAX_COEFFICIENTS);

/// Centers of series have one of these |τ|: far from the walls, far from a corner.
const DEPTHS: [f64; 3] = [0.7, 0.85, 1.0];
/// Angles by which a center may lie ahead of the first point that its series serves.
const AHEAD: [f64; 5] = [0.6, 0.45, 0.3, 0.15, 0.0];
/// Series continue the map beyond the walls, as far from the center as this times the distance to the wall; by then terms are
/// larger than they are at the wall by a factor that rounding can bear.
const BEYOND_WALL: f64 = 1.15;
/// Sources are summed for a disk of this share of the distance to the wall.
const SHARE_OF_SUM: f64 = 0.6;

impl<'a> ArcSampler<'a> {
    /// From series that err by no more than `accuracy`.
    #[must_use]
    pub fn new(expand: Expand<'a>, accuracy: f64) -> Self {
        let share = accuracy.powf(1.0 / TERMS as f64);
        Self { expand, center: Complex64::ZERO, unit: 1.0, reach: 0.0, share, coefficients: [Complex64::ZERO; TERMS] }
    }

    /// The function and its derivative by z at τ, which goes around the arc.
    pub fn at(&mut self, zone: &Zone, tau: Complex64) -> (Complex64, Complex64) {
        let z = zone.point(tau);
        if (z - self.center).norm() > self.reach {
            let turns = AHEAD.into_iter().flat_map(|angle| DEPTHS.map(|depth| Complex64::from_polar(depth, angle)));
            let centers = turns.map(|turn| tau * turn).filter(|tau| tau.im > 0.0);
            let mut series = centers.map(|tau| (zone.point(tau), self.reach_around(zone, tau)));
            let serves = |(center, reach): &(Complex64, f64)| (z - center).norm() <= *reach;
            (self.center, self.reach) = series.find(serves).unwrap_or((z, self.reach_around(zone, tau)));
            let Place::At(tau) = zone.place(self.center) else { return (NOWHERE, NOWHERE) };
            self.unit = SHARE_OF_SUM * wall_distance(zone, tau);
            (self.expand)(self.center, self.unit, &mut self.coefficients);
        }
        let (value, slope) = value_and_slope(&self.coefficients, (z - self.center) / self.unit);
        (value, slope / self.unit)
    }

    /// How far a series around the point at τ is accurate.
    fn reach_around(&self, zone: &Zone, tau: Complex64) -> f64 {
        let from = (zone.point(tau) - zone.origin).norm();
        let beyond = zone.reach / SHARE.powf(zone.alpha) - from;
        let singular = if zone.alpha == 1.0 { beyond } else { beyond.min(from) };
        (self.share * singular).min(BEYOND_WALL * wall_distance(zone, tau))
    }
}

/// Distance of the point at τ from the walls, those beyond the zone included.
fn wall_distance(zone: &Zone, tau: Complex64) -> f64 {
    let from = (zone.point(tau) - zone.origin).norm();
    // From the nearer wall of the sector.
    let angle = (tau.arg().min(PI - tau.arg()) * zone.alpha).min(0.5 * PI);
    (from * angle.sin()).min(zone.reach / SHARE.powf(zone.alpha) - from)
}
