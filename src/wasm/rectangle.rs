//! `RectangleMap` in JavaScript.

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

/// The four points that make a region a quadrilateral.
#[derive(Debug, Tsify)]
pub struct RectangleOptions {
    /// The points of the boundary, counter-clockwise, that go to the corners 0, `aspect`, `aspect` + i and i; snapped to the
    /// boundary.
    #[tsify(type = "[[x: number, y: number], [x: number, y: number], [x: number, y: number], [x: number, y: number]]")]
    pub corners: [Point; 4],
}
fields!(RectangleOptions: corners);

/// The conformal map of a region onto the rectangle 0 < Re w < `aspect`, 0 < Im w < 1 that takes four boundary points to its
/// corners. Long ones keep their accuracy.
#[wasm_bindgen]
pub struct RectangleMap(Box<dyn PlaneMap>, crate::riemann::RectangleMap);

#[wasm_bindgen]
impl RectangleMap {
    /// Solves for the map.
    ///
    /// Throws "wrong-region" for a region with holes, "invalid-map" unless the corners are four points counter-clockwise,
    /// "crowded" for sides that numbers cannot tell from points; "cancelled", "invalid-option", "inaccurate" or "negative-mass".
    pub fn solve(
        region: &Region,
        corners: Ts<RectangleOptions>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let corners = options::read(&corners)?.corners.map(Into::into);
        let region = region.simple("A rectangle map")?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::RectangleMap::solve(region, corners, &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Region → rectangle, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region.
    #[wasm_bindgen(js_name = toRectangle)]
    pub fn to_rectangle(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_rectangle(points))?)
    }

    /// Rectangle → region, the inverse of `toRectangle`; NaN outside the closed rectangle.
    #[wasm_bindgen(js_name = fromRectangle)]
    pub fn from_rectangle(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_rectangle(points))?)
    }

    /// f' of the map region → rectangle, per plane unit; NaN outside the closed region.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }

    /// Width over height of the rectangle: the conformal modulus of the quadrilateral.
    #[wasm_bindgen(getter)]
    pub fn aspect(&self) -> f64 {
        self.1.aspect()
    }
}

joinable!(RectangleMap, 1);

solved_methods! {
    RectangleMap, 1,
    " An estimate of the largest error: of the aspect, relative to it, and of images, the shorter side being 1."
}

warp::warp_methods! {
    RectangleMap, Direction::PushForward,
    " The texture as the map shows it on the rectangle, pixel by pixel, without a mesh: RGBA bytes with straight alpha."
    " `pull-back` shows on the region what lies on the rectangle."
}
