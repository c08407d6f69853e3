//! `ChannelFlow` in JavaScript.

use super::error::Failure;
use super::level_lines::{self, LevelLines};
use super::options::{self, Point};
use super::points;
use super::reading::fields;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::solved_methods;
use crate::riemann::ChannelEnds;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// Where the fluid enters and leaves, `corners` or `ends`, and how much of it.
#[derive(Debug, Tsify)]
pub struct ChannelOptions {
    /// Four points of the boundary, counter-clockwise: the inlet lies from the first to the second, the outlet from the third to
    /// the fourth. Snapped to the boundary.
    #[tsify(
        optional,
        type = "[[x: number, y: number], [x: number, y: number], [x: number, y: number], [x: number, y: number]]"
    )]
    pub corners: Option<[Point; 4]>,
    /// Two points of the boundary instead: a source at the first, a sink at the second.
    #[tsify(optional, type = "[[x: number, y: number], [x: number, y: number]]")]
    pub ends: Option<[Point; 2]>,
    /// How much fluid flows through, a unit of time and depth; 1 by default.
    #[tsify(optional)]
    pub flux: Option<f64>,
}
fields!(ChannelOptions: corners, ends, flux);

/// The plane flow of an ideal fluid through a region without holes, from an inlet to an outlet; the rest of the boundary is walls.
/// Groundwater, a current in a sheet and heat between insulated walls are the same.
#[derive(Debug)]
#[wasm_bindgen]
pub struct ChannelFlow(crate::riemann::ChannelFlow);

#[wasm_bindgen]
impl ChannelFlow {
    /// Solves for the flow.
    ///
    /// Throws "wrong-region" for a region with holes, "invalid-map" unless the points are different ones, counter-clockwise,
    /// "crowded" for an inlet or outlet that numbers cannot tell from a point; "cancelled", "invalid-option", "inaccurate" or
    /// "negative-mass".
    pub fn solve(
        region: &Region,
        channel: Ts<ChannelOptions>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let ChannelOptions { corners, ends, flux } = options::read(&channel)?;
        let ends = match (corners, ends) {
            (Some(corners), None) => ChannelEnds::Sides(corners.map(Into::into)),
            (None, Some(ends)) => ChannelEnds::Points(ends.map(Into::into)),
            _ => return Err(Failure::option("corners", "A channel needs either four corners or two ends.")),
        };
        let region = region.simple("A channel")?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved =
            crate::riemann::ChannelFlow::solve(region, ends, flux.unwrap_or(1.0), &options, &mut |stage, fraction| {
                progress.report(stage, fraction)
            });
        progress.finish(solved).map(Self)
    }

    /// Lines of the flow: "streamlines", on which ψ has the given values, from the inlet to the outlet, or "potentials", on which
    /// φ has, from wall to wall. Values that the flow does not have make no line.
    ///
    /// Throws "invalid-option".
    #[wasm_bindgen(js_name = levelLines)]
    pub fn level_lines(
        &self,
        #[wasm_bindgen(unchecked_param_type = "\"streamlines\" | \"potentials\"")] what: &str,
        levels: &[f64],
    ) -> Result<LevelLines, Failure> {
        let what = super::flow::lines(what)?;
        Ok(self.0.level_lines(what, level_lines::finite(levels)?).into())
    }

    /// The complex potential φ + iψ at points `[x0, y0, x1, y1, …]`; NaN outside the closed region. φ is 0 at the inlet, or,
    /// between `ends`, at the region's center; ψ is 0 on the wall to the right of the stream, and the flux on the other.
    pub fn potential(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.0.potential(points))?)
    }

    /// The stream function ψ at points: constant along streamlines; NaN outside.
    pub fn stream(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.0.stream(&points::from_flat("The points", points)?))
    }

    /// The velocity `[u, v, …]` at points; NaN outside, infinite at a corner that the fluid goes around.
    pub fn velocity(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.0.velocity(points))?)
    }

    /// The pressure coefficient 1 − |u|²/U² at points, U being `speed`; NaN outside.
    pub fn pressure(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.0.pressure(&points::from_flat("The points", points)?))
    }

    /// The mean speed in the inlet, flux over its length; between `ends`, the speed at the region's center.
    #[wasm_bindgen(getter)]
    pub fn speed(&self) -> f64 {
        self.0.speed()
    }

    /// φ at the outlet less φ at the inlet: the flux times the aspect of the region's rectangle; infinite between `ends`.
    #[wasm_bindgen(getter, js_name = potentialDifference)]
    pub fn potential_difference(&self) -> f64 {
        self.0.potential_difference()
    }
}

solved_methods! {
    ChannelFlow, 0,
    " An estimate of the largest error: of the potential, in units of the flux, and of `potentialDifference`, relative to it."
}
