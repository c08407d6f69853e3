//! What maps with marked boundary points share: the points themselves, and what their errors come to.

use super::super::RiemannMap;
use super::super::evidence::Evidence;
use crate::plane::{BoundaryPoint, Complex64, Region};
use crate::{Error, Result};

/// Estimates above this are none.
const WORST_ESTIMATE: f64 = 1.0;
/// From one chart to the next, whose center lies near the circle, errors grow by no more than this; from there on they add up.
const PER_CHART: f64 = 100.0;
/// What rounding does to a map at best.
const ROUNDING: f64 = 2e-15;

/// The places on the boundary, which have to follow each other counter-clockwise.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::InvalidMap`].
pub fn marked_points<const N: usize>(
    region: &Region,
    what: &'static str,
    points: &[Complex64; N],
) -> Result<[BoundaryPoint; N]> {
    if let Some(k) = points.iter().position(|point| !point.is_finite()) {
        return Err(Error::NotFinite { what: format!("Marked point {k}") });
    }
    let count = region.contour().edge_count();
    let places = points.map(|point| {
        let place = region.nearest(point);
        if place.t < 1.0 { place } else { BoundaryPoint { edge: (place.edge + 1) % count, t: 0.0, ..place } }
    });
    let along = |place: &BoundaryPoint| (place.edge, place.t);
    let falls = |k: usize| along(&places[(k + 1) % N]) <= along(&places[k]);
    if (1..N).any(|k| (0..k).any(|j| along(&places[j]) == along(&places[k]))) {
        return Err(Error::InvalidMap { what, reason: "two of the marked boundary points are one" });
    }
    // Around once: it falls once.
    if (0..N).filter(|k| falls(*k)).count() != 1 {
        let reason = "the marked boundary points do not follow each other counter-clockwise";
        return Err(Error::InvalidMap { what, reason });
    }
    Ok(places)
}

/// The evidence of a map whose images move by `sensitivity` when points of a chart do.
///
/// # Errors
/// [`Error::Inaccurate`].
pub fn evidence_of(map: &RiemannMap, sensitivity: f64) -> Result<Evidence> {
    let known = map.solved().evidence();
    let links = 1.0 + PER_CHART * (map.charts() - 1) as f64;
    let estimate = (known.error_estimate + ROUNDING) * sensitivity * links;
    if estimate.is_nan() || estimate > WORST_ESTIMATE {
        return Err(Error::Inaccurate { estimate });
    }
    Ok(Evidence { error_estimate: estimate, ..known })
}
