//! `HalfPlaneMap` in JavaScript.

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

/// The point that goes to infinity.
#[derive(Debug, Tsify)]
pub struct HalfPlaneOptions {
    /// The point of the boundary that goes to infinity; snapped to the boundary.
    pub pole: Point,
}
fields!(HalfPlaneOptions: pole);

/// The conformal map of a region onto the upper half plane that takes a boundary point to infinity and `center` to i.
#[wasm_bindgen]
pub struct HalfPlaneMap(Box<dyn PlaneMap>, crate::riemann::HalfPlaneMap);

#[wasm_bindgen]
impl HalfPlaneMap {
    /// Solves for the map.
    ///
    /// Throws "wrong-region" for a region with holes; "cancelled", "invalid-option", "inaccurate" or "negative-mass".
    pub fn solve(
        region: &Region,
        pole: Ts<HalfPlaneOptions>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let pole = options::read(&pole)?.pole.into();
        let region = region.simple("A map onto the half plane")?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::HalfPlaneMap::solve(region, pole, &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Region → half plane, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region, infinite at the pole.
    #[wasm_bindgen(js_name = toHalfPlane)]
    pub fn to_half_plane(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_half_plane(points))?)
    }

    /// Half plane → region, the inverse of `toHalfPlane`; NaN below the real axis.
    #[wasm_bindgen(js_name = fromHalfPlane)]
    pub fn from_half_plane(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_half_plane(points))?)
    }

    /// f' of the map region → half plane, per plane unit; NaN outside the closed region.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }
}

joinable!(HalfPlaneMap, 1);

solved_methods! {
    HalfPlaneMap, 1,
    " An estimate of the largest error of images w, in units of 1 + |w|²."
}

warp::warp_methods! {
    HalfPlaneMap, Direction::PushForward,
    " The texture as the map shows it on the half plane, pixel by pixel, without a mesh: RGBA bytes with straight alpha."
    " `pull-back` shows on the region what lies on the half plane."
}
