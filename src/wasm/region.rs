//! `Region` in JavaScript.

use super::error::Failure;
use super::options::{self, Point};
use super::points;
use crate::plane::{self, Curve};
use js_sys::Array;
use serde::Deserialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// What makes a region.
#[derive(Debug, Deserialize, Tsify)]
pub struct RegionOptions {
    /// The boundary points `[x0, y0, x1, y1, …]`, in either orientation.
    #[serde(deserialize_with = "options::numbers")]
    #[tsify(type = "Float64Array")]
    pub boundary: Vec<f64>,
    /// How the boundary points are joined; "polygon" by default.
    #[serde(default)]
    #[tsify(optional)]
    pub curve: Curve,
    /// The point strictly inside that the Riemann map takes to 0.
    pub center: Point,
    /// The boundary point that goes to 1; snapped to the nearest point of the boundary.
    pub toward: Point,
}

/// How the text of an outline is to be understood.
#[derive(Debug, Default, Deserialize, Tsify)]
#[serde(default)]
pub struct OutlineOptions {
    /// Plane units per unit of the text, 1 by default.
    #[tsify(optional)]
    pub scale: Option<f64>,
    /// How far an edge may leave the curve that it stands for, in plane units; 0.1 by default.
    #[tsify(optional)]
    pub tolerance: Option<f64>,
}

/// A region bounded by a simple closed curve, with a `center` inside it and a `toward` point on its boundary: what
/// makes its Riemann map unique.
#[derive(Debug)]
#[wasm_bindgen]
pub struct Region(plane::Region);

#[wasm_bindgen]
impl Region {
    /// Checks the boundary and puts it in counter-clockwise order.
    ///
    /// Throws "not-finite", "too-few-vertices", "self-intersecting", "center-outside" or "invalid-option".
    #[wasm_bindgen(constructor)]
    pub fn new(options: Ts<RegionOptions>) -> Result<Self, Failure> {
        let RegionOptions { boundary, curve, center, toward } = options::read(&options)?;
        let boundary = points::from_flat("The boundary", &boundary)?;
        Ok(Self(plane::Region::new(&boundary, curve, center.into(), toward.into())?))
    }

    /// Text → boundary points `[x0, y0, x1, y1, …]`: JSON, `[[x, y], …]`, the data of an SVG path (the attribute `d`), or an SVG file that
    /// draws one closed curve. SVG is turned over, since its y counts downwards; a file's transforms are applied.
    ///
    /// Throws "invalid-outline" or "invalid-option".
    #[wasm_bindgen(js_name = parseOutline)]
    pub fn parse_outline(text: &str, options: Option<Ts<OutlineOptions>>) -> Result<Vec<f64>, Failure> {
        let OutlineOptions { scale, tolerance } = options::read_or_default(options.as_ref())?;
        let vertices = plane::parse_outline(text, scale.unwrap_or(1.0), tolerance.unwrap_or(0.1))?;
        Ok(points::to_flat(&vertices))
    }

    /// The boundary points `[x0, y0, x1, y1, …]`, counter-clockwise.
    #[wasm_bindgen(getter)]
    pub fn boundary(&self) -> Vec<f64> {
        points::to_flat(self.0.boundary())
    }

    /// The point that goes to 0.
    #[wasm_bindgen(getter, unchecked_return_type = "[x: number, y: number]")]
    pub fn center(&self) -> Array {
        points::pair(self.0.center())
    }

    /// The boundary point that goes to 1.
    #[wasm_bindgen(getter, unchecked_return_type = "[x: number, y: number]")]
    pub fn toward(&self) -> Array {
        points::pair(self.0.toward().point)
    }

    /// For each point `[x0, y0, x1, y1, …]`: 1 in the closed region, 0 outside.
    ///
    /// Throws "wrong-length" for an odd count of numbers.
    pub fn contains(&self, points: &[f64]) -> Result<Vec<u8>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points.iter().map(|&z| u8::from(self.0.contains(z))).collect())
    }
}

impl Region {
    /// The region itself, for the classes that are made from one.
    #[must_use]
    pub fn inner(&self) -> &plane::Region {
        &self.0
    }
}
