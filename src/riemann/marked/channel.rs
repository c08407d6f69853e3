//! Flow of an ideal fluid through a channel.

use super::super::RiemannMap;
use super::super::evidence::{Evidence, evidence_methods};
use super::super::holes::{FlowLines, LevelLine};
use super::super::polyline::polyline;
use super::rectangle::RectangleMap;
use super::strip::StripMap;
use crate::plane::{BoundaryPoint, Complex64, Contour, Region};
use crate::symm::options::{Progress, SolveOptions};
use crate::{Error, Result};
use std::f64::consts::FRAC_1_PI;

/// Where the fluid enters a region and leaves it. The rest of the boundary is walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChannelEnds {
    /// Through two parts of the boundary, on each of which the potential is one number: the inlet from the first of these points to
    /// the second, the outlet from the third to the fourth, all counter-clockwise.
    Sides([Complex64; 4]),
    /// At two points of the boundary: a source at the first, a sink at the second.
    Points([Complex64; 2]),
}

/// The plane flow of an ideal fluid through a simply connected region, or whatever else has a harmonic potential between two parts
/// of its boundary and none of it escapes through the others: groundwater, a current in a sheet, heat.
///
/// The complex potential is W = flux · w, w taking the region to the rectangle 0 < Re w < aspect, 0 < Im w < 1 whose left side is the
/// inlet ([`RectangleMap`]), or to the strip ([`StripMap`]). So ψ = Im W is 0 on the wall to the right of the stream and the flux on
/// the other one.
///
/// ```
/// use conformal_warp::{ChannelEnds, ChannelFlow, Complex64, Curve, Region, SolveOptions};
/// let corners = [(0.0, 1.0), (0.0, 0.0), (4.0, 0.0), (4.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let straight = Region::new(&corners, Curve::Polygon, Complex64::new(2.0, 0.5), corners[0])?;
/// let ends = ChannelEnds::Sides(corners);
/// let flow = ChannelFlow::solve(&straight, ends, 3.0, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((flow.velocity(&[Complex64::new(1.0, 0.2)])[0] - 3.0).norm() < 1e-7);
/// assert!((flow.potential_difference() - 12.0).abs() < 1e-6);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct ChannelFlow {
    map: Straight,
    flux: f64,
    speed: f64,
    evidence: Evidence,
}

/// What makes the channel straight and as wide as 1.
#[derive(Clone, Debug)]
enum Straight {
    Rectangle(Box<RectangleMap>),
    Strip(Box<StripMap>),
}

impl Straight {
    fn disk(&self) -> &RiemannMap {
        match self {
            Self::Rectangle(map) => map.disk(),
            Self::Strip(map) => map.disk(),
        }
    }

    fn images(&self, points: &[Complex64]) -> Vec<Complex64> {
        match self {
            Self::Rectangle(map) => map.to_rectangle(points),
            Self::Strip(map) => map.to_strip(points),
        }
    }

    fn slopes(&self, points: &[Complex64]) -> Vec<Complex64> {
        match self {
            Self::Rectangle(map) => map.derivative(points),
            Self::Strip(map) => map.derivative(points),
        }
    }

    fn place(&self, w: Complex64) -> Option<Complex64> {
        let found = match self {
            Self::Rectangle(map) => map.from_rectangle(&[w]),
            Self::Strip(map) => map.from_strip(&[w]),
        };
        found.into_iter().find(|z| z.is_finite())
    }
}

impl ChannelFlow {
    /// Solves for the flow of so much fluid a unit of time and depth. The points of `ends` are snapped to the boundary.
    ///
    /// # Errors
    /// As [`RiemannMap::solve`] and [`ChannelFlow::of`].
    pub fn solve(
        region: &Region,
        ends: ChannelEnds,
        flux: f64,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Self> {
        checked(flux)?;
        Self::of(&RiemannMap::solve(region, options, progress)?, ends, flux)
    }

    /// The flow through a region that was already solved: other ends cost nothing more.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for a flux that is not positive; [`Error::NotFinite`]; [`Error::InvalidMap`] unless the ends are
    /// different points, counter-clockwise; [`Error::Crowded`] for an inlet or outlet that double precision cannot tell from a point;
    /// [`Error::Inaccurate`].
    pub fn of(map: &RiemannMap, ends: ChannelEnds, flux: f64) -> Result<Self> {
        checked(flux)?;
        match ends {
            ChannelEnds::Sides([a, b, c, d]) => {
                // The inlet runs down the rectangle's left side.
                let map = RectangleMap::of(map, [b, c, d, a])?;
                let [to, _, _, from] = map.corners();
                let width = length_along(map.disk().region().contour(), from, to);
                let evidence = map.evidence;
                Ok(Self { map: Straight::Rectangle(Box::new(map)), flux, speed: flux / width, evidence })
            }
            ChannelEnds::Points(ends) => {
                let map = StripMap::of(map, ends)?;
                let slope = map.derivative(&[map.disk().region().center()])[0];
                let evidence = map.evidence;
                Ok(Self { map: Straight::Strip(Box::new(map)), flux, speed: flux * slope.norm(), evidence })
            }
        }
    }

    /// The map region → disk that it goes through.
    #[must_use]
    pub fn disk(&self) -> &RiemannMap {
        self.map.disk()
    }

    /// How much fluid flows through, a unit of time and depth.
    #[must_use]
    pub fn flux(&self) -> f64 {
        self.flux
    }

    /// The speed U that [`ChannelFlow::pressure`] compares with: the mean speed in the inlet, flux over its length; of a flow between
    /// points, the speed at the region's center.
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// φ at the outlet less φ at the inlet: the flux times the aspect of the region's rectangle. Infinite between points.
    #[must_use]
    pub fn potential_difference(&self) -> f64 {
        match &self.map {
            Straight::Rectangle(map) => self.flux * map.aspect(),
            Straight::Strip(_) => f64::INFINITY,
        }
    }

    /// The complex potential W = φ + iψ at points; NaN outside the closed region. φ is 0 at the inlet, or, between points, at the
    /// region's center.
    #[must_use]
    pub fn potential(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.images(points).into_iter().map(|w| w * self.flux).collect()
    }

    /// The stream function ψ at points: from 0 on the wall to the right of the stream to the flux on that to its left; NaN outside.
    #[must_use]
    pub fn stream(&self, points: &[Complex64]) -> Vec<f64> {
        self.map.images(points).into_iter().map(|w| w.im * self.flux).collect()
    }

    /// The velocity u + iv at points; NaN outside, infinite at a corner that the fluid goes around.
    #[must_use]
    pub fn velocity(&self, points: &[Complex64]) -> Vec<Complex64> {
        self.map.slopes(points).into_iter().map(|slope| slope.conj() * self.flux).collect()
    }

    /// The pressure coefficient 1 − |u|²/U² at points, U being [`ChannelFlow::speed`].
    #[must_use]
    pub fn pressure(&self, points: &[Complex64]) -> Vec<f64> {
        self.velocity(points).iter().map(|u| 1.0 - u.norm_sqr() / (self.speed * self.speed)).collect()
    }

    /// Lines on which ψ or φ has given values: straight lines of the rectangle, or of the strip, brought back. Streamlines run from
    /// the inlet to the outlet, potentials from the wall on the right to that on the left. Values that the flow does not have make no
    /// line.
    #[must_use]
    pub fn level_lines(&self, what: FlowLines, levels: &[f64]) -> Vec<LevelLine> {
        /// Pieces across the channel, which are halved where they turn,
        const ACROSS: usize = 64;
        /// along a piece as long as it is wide, and at most along all of it.
        const ALONG: f64 = 8.0;
        const MOST: f64 = 8192.0;
        let pieces = match (what, &self.map) {
            (FlowLines::Potentials, _) => ACROSS,
            (FlowLines::Streamlines, Straight::Rectangle(map)) => {
                ACROSS.max((ALONG * map.aspect()).clamp(1.0, MOST) as usize)
            }
            (FlowLines::Streamlines, Straight::Strip(_)) => 8 * ACROSS,
        };
        let line = |&level: &f64| {
            let share = level / self.flux;
            let at = |t: f64| match (what, &self.map) {
                (FlowLines::Potentials, _) => Complex64::new(share, t),
                (FlowLines::Streamlines, Straight::Rectangle(map)) => Complex64::new(map.aspect() * t, share),
                // From −∞ to ∞; beside the ends points crowd like t⁴.
                (FlowLines::Streamlines, Straight::Strip(_)) => {
                    Complex64::new(4.0 * FRAC_1_PI * (t / (1.0 - t)).ln(), share)
                }
            };
            let points = polyline(pieces, &|t| self.map.place(at(t)))?;
            Some(LevelLine { level, points, closed: false })
        };
        levels.iter().filter_map(line).collect()
    }
}

evidence_methods!(ChannelFlow, "of W, in units of the flux, and of the potential difference, relative to it.");

fn checked(flux: f64) -> Result<()> {
    if flux > 0.0 && flux.is_finite() {
        return Ok(());
    }
    Err(Error::InvalidOption { name: "flux", expected: "a positive number", value: flux })
}

/// The length of a boundary between two of its points, counter-clockwise.
fn length_along(contour: &Contour, from: Complex64, to: Complex64) -> f64 {
    /// Chords of an edge of a polygon, or of a piece of curve that sees as much as one.
    const CHORDS: usize = 8;
    let (from, to) = (contour.nearest_or_end(from), contour.nearest_or_end(to));
    let (count, chords) = (contour.edge_count(), CHORDS * contour.detail());
    let wraps = (to.edge, to.t) <= (from.edge, from.t);
    let last = to.edge + if wraps { count } else { 0 };
    let edge = |k: usize| {
        let start = if k == from.edge { from.t } else { 0.0 };
        let end = if k == last { to.t } else { 1.0 };
        let by_chords = |chords: usize| {
            let at = |j: usize| {
                let t = start + (end - start) * (j as f64 / chords as f64);
                contour.point(BoundaryPoint { edge: k % count, t, point: Complex64::ZERO })
            };
            (0..chords).map(|j| (at(j + 1) - at(j)).norm()).sum::<f64>()
        };
        // They are too short by about 1/chords².
        (4.0 * by_chords(chords) - by_chords(chords / 2)) / 3.0
    };
    (from.edge..=last).map(edge).sum()
}
