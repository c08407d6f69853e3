//! `ExteriorMap` in JavaScript.

use super::canonical::joinable;
use super::drawn::{Given, directed, domain_of};
use super::error::Failure;
use super::options::{self, Point};
use super::points;
use super::reading::fields;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::{prepare_method, solved_methods};
use super::warp;
use crate::map::PlaneMap;
use crate::plane::{self, Curve};
use crate::warp::Direction;
use js_sys::Float64Array;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// A body whose outside is mapped.
#[derive(Debug, Tsify)]
pub struct BodyOptions {
    /// The boundary points `[x0, y0, x1, y1, …]`, in either orientation. A boundary is given by this, by `path`, by `edges` or by
    /// `through`, as that of a region.
    #[tsify(optional, type = "Float64Array")]
    pub boundary: Option<Float64Array>,
    /// How the boundary points are joined; "polygon" by default.
    #[tsify(optional)]
    pub curve: Option<Curve>,
    /// The boundary as one closed curve in the language of SVG's paths; but in plane coordinates, y up.
    #[tsify(optional)]
    pub path: Option<String>,
    /// The boundary as a closed chain of edges.
    #[tsify(optional, type = "EdgeOptions[]")]
    pub edges: Option<JsValue>,
    /// Points `[x0, y0, x1, y1, …]` through which the boundary goes, smoothly but for `corners`.
    #[tsify(optional, type = "Float64Array")]
    pub through: Option<Float64Array>,
    /// Indices of the points of `through` that are corners; none by default.
    #[tsify(optional)]
    pub corners: Option<Vec<usize>>,
    /// The boundary point that goes to 1; without one, directions far away are kept.
    #[tsify(optional)]
    pub toward: Option<Point>,
}
fields!(BodyOptions: boundary, curve, path, edges, through, corners, toward);

/// The conformal map of the outside of a body onto the outside of the unit disk, infinity staying where it is.
#[wasm_bindgen]
pub struct ExteriorMap(Box<dyn PlaneMap>, crate::riemann::ExteriorMap);

#[wasm_bindgen]
impl ExteriorMap {
    /// Solves for the map.
    ///
    /// Throws as `new Region()`; "cancelled", "invalid-option", "inaccurate" or "too-few-points".
    pub fn solve(body: Ts<BodyOptions>, options: Option<Ts<RiemannOptions>>) -> Result<Self, Failure> {
        let BodyOptions { boundary, curve, path, edges, through, corners, toward } = options::read(&body)?;
        let drawn = Given { boundary, path, edges, through, corners }.drawn("A body", plane::parse_path)?;
        let domain = directed(domain_of(vec![drawn], false, curve)?, None, toward)?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::ExteriorMap::solve(&domain, &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Outside of the body → outside of the disk, point by point `[x0, y0, x1, y1, …]`; NaN inside the body.
    #[wasm_bindgen(js_name = toExterior)]
    pub fn to_exterior(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_exterior(points))?)
    }

    /// Outside of the disk → outside of the body, the inverse of `toExterior`; NaN inside the disk.
    #[wasm_bindgen(js_name = fromExterior)]
    pub fn from_exterior(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_exterior(points))?)
    }

    /// f' of the map, per plane unit; NaN inside the body.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }

    /// The logarithmic capacity of the body, in plane units: f(z) ~ z / capacity far away.
    #[wasm_bindgen(getter)]
    pub fn capacity(&self) -> f64 {
        self.1.capacity()
    }
}

prepare_method! { ExteriorMap, 1 }
joinable!(ExteriorMap, 1);

solved_methods! {
    ExteriorMap, 1,
    " An estimate of the largest error of log w, so of w relative to its size."
}

warp::warp_methods! {
    ExteriorMap, Direction::PushForward,
    " The texture as the map shows it outside the disk, pixel by pixel, without a mesh: RGBA bytes with straight alpha."
    " `pull-back` shows outside the body what lies outside the disk."
}
