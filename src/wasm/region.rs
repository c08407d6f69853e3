//! `Region` in JavaScript.

use super::error::Failure;
use super::options::{self, Point};
use super::points;
use crate::Error;
use crate::plane::{self, Complex64, Curve, Domain, NOWHERE};
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
    /// The boundary points of each hole, in either orientation.
    #[serde(default, deserialize_with = "options::number_arrays")]
    #[tsify(optional, type = "Float64Array[]")]
    pub holes: Vec<Vec<f64>>,
    /// The point strictly inside that the Riemann map takes to 0. A region with holes needs none, unless its map does.
    #[tsify(optional)]
    pub center: Option<Point>,
    /// The boundary point that goes to 1; snapped to the nearest point of the boundary. A region with holes needs none: its
    /// first boundary point goes there.
    #[tsify(optional)]
    pub toward: Option<Point>,
}

/// What makes the outside of bodies.
#[derive(Debug, Deserialize, Tsify)]
pub struct ExteriorOptions {
    /// The boundary points of each body `[x0, y0, x1, y1, …]`, in either orientation.
    #[serde(deserialize_with = "options::number_arrays")]
    #[tsify(type = "Float64Array[]")]
    pub holes: Vec<Vec<f64>>,
    /// How the boundary points are joined; "polygon" by default.
    #[serde(default)]
    #[tsify(optional)]
    pub curve: Curve,
    /// A point that maps take to 0.
    #[tsify(optional)]
    pub center: Option<Point>,
    /// The point of the first body that gives maps their direction; snapped to its boundary.
    #[tsify(optional)]
    pub toward: Option<Point>,
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
/// makes its Riemann map unique. It may have holes, or be the outside of bodies (`Region.exterior`).
#[derive(Debug)]
#[wasm_bindgen]
pub struct Region(Kind);

#[derive(Debug)]
enum Kind {
    Simple(plane::Region),
    Domain(Domain),
}

#[wasm_bindgen]
impl Region {
    /// Checks the boundary and puts it in counter-clockwise order.
    ///
    /// Throws "not-finite", "too-few-vertices", "self-intersecting", "center-outside" or "invalid-option"; of holes "holes-meet"
    /// or "hole-outside", and the message names which.
    #[wasm_bindgen(constructor)]
    pub fn new(options: Ts<RegionOptions>) -> Result<Self, Failure> {
        let RegionOptions { boundary, curve, holes, center, toward } = options::read(&options)?;
        if holes.is_empty() {
            let given = |point: Option<Point>, name: &str| {
                point.ok_or_else(|| Failure::option(name, &format!("The option \"{name}\" is missing.")))
            };
            let (center, toward) = (given(center, "center")?, given(toward, "toward")?);
            let boundary = points::from_flat("The boundary", &boundary)?;
            return Ok(Self(Kind::Simple(plane::Region::new(&boundary, curve, center.into(), toward.into())?)));
        }
        let boundary = points::from_flat("The boundary", &boundary)?;
        Ok(Self(Kind::Domain(directed(Domain::new(&boundary, &outlines(&holes)?, curve)?, center, toward)?)))
    }

    /// The unbounded region outside one or more bodies.
    ///
    /// Throws as `new Region()`.
    pub fn exterior(options: Ts<ExteriorOptions>) -> Result<Self, Failure> {
        let ExteriorOptions { holes, curve, center, toward } = options::read(&options)?;
        Ok(Self(Kind::Domain(directed(Domain::exterior(&outlines(&holes)?, curve)?, center, toward)?)))
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

    /// The boundary points `[x0, y0, x1, y1, …]`, counter-clockwise; none of the outside of bodies.
    #[wasm_bindgen(getter)]
    pub fn boundary(&self) -> Vec<f64> {
        match &self.0 {
            Kind::Simple(region) => points::to_flat(region.boundary()),
            Kind::Domain(domain) => points::to_flat(domain.boundary().unwrap_or_default()),
        }
    }

    /// The boundary points of each hole or body, counter-clockwise.
    #[wasm_bindgen(getter, unchecked_return_type = "Float64Array[]")]
    pub fn holes(&self) -> Array {
        match &self.0 {
            Kind::Simple(_) => Array::new(),
            Kind::Domain(domain) => {
                domain.holes().iter().map(|hole| js_sys::Float64Array::from(&points::to_flat(hole)[..])).collect()
            }
        }
    }

    /// The point that goes to 0; NaN if none was given.
    #[wasm_bindgen(getter, unchecked_return_type = "[x: number, y: number]")]
    pub fn center(&self) -> Array {
        points::pair(match &self.0 {
            Kind::Simple(region) => region.center(),
            Kind::Domain(domain) => domain.center().unwrap_or(NOWHERE),
        })
    }

    /// The boundary point that goes to 1; NaN if none was given.
    #[wasm_bindgen(getter, unchecked_return_type = "[x: number, y: number]")]
    pub fn toward(&self) -> Array {
        points::pair(match &self.0 {
            Kind::Simple(region) => region.toward().point,
            Kind::Domain(domain) => domain.toward().unwrap_or(NOWHERE),
        })
    }

    /// For each point `[x0, y0, x1, y1, …]`: 1 in the closed region, 0 outside.
    ///
    /// Throws "wrong-length" for an odd count of numbers.
    pub fn contains(&self, points: &[f64]) -> Result<Vec<u8>, Failure> {
        let points = points::from_flat("The points", points)?;
        let contains = |z: &Complex64| match &self.0 {
            Kind::Simple(region) => region.contains(*z),
            Kind::Domain(domain) => domain.contains(*z),
        };
        Ok(points.iter().map(|z| u8::from(contains(z))).collect())
    }
}

impl Region {
    /// The region itself, for classes whose regions have no holes.
    ///
    /// # Errors
    /// [`Error::WrongRegion`] for one that has.
    pub fn simple(&self, what: &'static str) -> Result<&plane::Region, Error> {
        match &self.0 {
            Kind::Simple(region) => Ok(region),
            Kind::Domain(domain) => {
                let found = match domain.holes().len() {
                    _ if !domain.is_bounded() => "no outer boundary".to_string(),
                    1 => "a hole".to_string(),
                    count => format!("{count} holes"),
                };
                Err(Error::WrongRegion { what, needed: "a region without holes", found })
            }
        }
    }

    /// The region as a domain, for classes of regions with holes.
    #[must_use]
    pub fn domain(&self) -> Domain {
        match &self.0 {
            Kind::Simple(region) => Domain::from(region),
            Kind::Domain(domain) => domain.clone(),
        }
    }
}

/// The outlines of holes.
///
/// # Errors
/// [`Error::WrongLength`] for an odd count of numbers.
pub fn outlines(holes: &[Vec<f64>]) -> Result<Vec<Vec<Complex64>>, Error> {
    holes.iter().map(|hole| points::from_flat("A hole", hole)).collect()
}

/// The domain with the points that give maps their place and direction.
///
/// # Errors
/// Those of [`Domain::with_center`] and [`Domain::with_toward`].
pub fn directed(domain: Domain, center: Option<Point>, toward: Option<Point>) -> Result<Domain, Error> {
    let domain = match center {
        Some(center) => domain.with_center(center.into())?,
        None => domain,
    };
    match toward {
        Some(toward) => domain.with_toward(toward.into()),
        None => Ok(domain),
    }
}
