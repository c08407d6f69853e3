//! `CircleMap` in JavaScript.

use super::error::Failure;
use super::points;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::{prepare_method, solved_methods};
use super::warp;
use crate::map::PlaneMap;
use crate::warp::Direction;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// The conformal map of a region with any number of holes onto the unit disk with round holes: `center` goes to 0, `toward` to 1.
#[wasm_bindgen]
pub struct CircleMap(Box<dyn PlaneMap>, crate::riemann::CircleMap);

#[wasm_bindgen]
impl CircleMap {
    /// Solves for the map.
    ///
    /// Throws "wrong-region" for a region without an outer boundary or a center; "cancelled", "invalid-option", "inaccurate" or
    /// "too-few-points".
    pub fn solve(region: &Region, options: Option<Ts<RiemannOptions>>) -> Result<Self, Failure> {
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::CircleMap::solve(&region.domain(), &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Region → disk with round holes, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region.
    #[wasm_bindgen(js_name = toCircles)]
    pub fn to_circles(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_circles(points))?)
    }

    /// Disk with round holes → region; NaN outside the closed disk and in the holes.
    #[wasm_bindgen(js_name = fromCircles)]
    pub fn from_circles(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_circles(points))?)
    }

    /// f' of the map region → disk with round holes, per plane unit.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }

    /// The middles `[x0, y0, x1, y1, …]` of the round holes, in the order of the region's.
    #[wasm_bindgen(getter)]
    pub fn centers(&self) -> Vec<f64> {
        self.1.circles().iter().flat_map(|circle| [circle.center.re, circle.center.im]).collect()
    }

    /// Their radii.
    #[wasm_bindgen(getter)]
    pub fn radii(&self) -> Vec<f64> {
        self.1.circles().iter().map(|circle| circle.radius).collect()
    }
}

prepare_method! { CircleMap, 1 }

solved_methods! {
    CircleMap, 1,
    " An estimate of the largest error of w."
}

warp::warp_methods! {
    CircleMap, Direction::PushForward,
    " The texture as the map shows it on the disk with round holes, pixel by pixel: RGBA bytes with straight alpha."
    " `pull-back` shows on the region what lies on the disk."
}
