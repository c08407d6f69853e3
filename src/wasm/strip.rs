//! `StripMap` in JavaScript.

use super::canonical::joinable;
use super::error::Failure;
use super::options::{self, Point};
use super::points;
use super::reading::fields;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::solved_methods;
use super::warp;
use crate::map::PlaneMap;
use crate::warp::Direction;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// The two points that go to the ends of the strip.
#[derive(Debug, Tsify)]
pub struct StripOptions {
    /// The points of the boundary that go to the left end and to the right one; snapped to the boundary.
    #[tsify(type = "[[x: number, y: number], [x: number, y: number]]")]
    pub ends: [Point; 2],
}
fields!(StripOptions: ends);

/// The conformal map of a region onto the strip 0 < Im w < 1 that takes two boundary points to its ends and `center` to the
/// imaginary axis. Far ends stay apart.
#[wasm_bindgen]
pub struct StripMap(Box<dyn PlaneMap>, crate::riemann::StripMap);

#[wasm_bindgen]
impl StripMap {
    /// Solves for the map.
    ///
    /// Throws "wrong-region" for a region with holes, "invalid-map" if the ends are one point; "cancelled", "invalid-option",
    /// "inaccurate" or "negative-mass".
    pub fn solve(
        region: &Region,
        ends: Ts<StripOptions>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let ends = options::read(&ends)?.ends.map(Into::into);
        let region = region.simple("A strip map")?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::StripMap::solve(region, ends, &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Region → strip, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region, infinite at the ends.
    #[wasm_bindgen(js_name = toStrip)]
    pub fn to_strip(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_strip(points))?)
    }

    /// Strip → region, the inverse of `toStrip`; NaN outside the closed strip.
    #[wasm_bindgen(js_name = fromStrip)]
    pub fn from_strip(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_strip(points))?)
    }

    /// f' of the map region → strip, per plane unit; NaN outside the closed region.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }
}

joinable!(StripMap, 1);

solved_methods! {
    StripMap, 1,
    " An estimate of the largest error of images, the strip being 1 wide."
}

warp::warp_methods! {
    StripMap, Direction::PushForward,
    " The texture as the map shows it on the strip, pixel by pixel, without a mesh: RGBA bytes with straight alpha."
    " `pull-back` shows on the region what lies on the strip."
}
