//! `Region` in JavaScript.

use super::drawn::{Drawn, Given, directed, domain_of, not_with_edges, outlines};
use super::error::Failure;
use super::options::{self, Point};
use super::points;
use super::reading::fields;
use super::words::words;
use super::writing::written;
use crate::Error;
use crate::plane::{self, Complex64, Curve, Domain, NOWHERE};
use js_sys::{Array, Float64Array};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

words! {
    /// How the boundary points are joined.
    Curve { Polygon = "polygon", Smooth = "smooth"; Edges }
}

/// What makes a region.
#[derive(Debug, Tsify)]
pub struct RegionOptions {
    /// The boundary points `[x0, y0, x1, y1, …]`, in either orientation. A boundary is given by this, by `path`, by `edges` or by
    /// `through`.
    #[tsify(optional, type = "Float64Array")]
    pub boundary: Option<Float64Array>,
    /// How the boundary points are joined; "polygon" by default.
    #[tsify(optional)]
    pub curve: Option<Curve>,
    /// The boundary as one closed curve in the language of SVG's paths, every command kept exactly; but in plane coordinates, y
    /// up, so that arcs with the sweep flag run counter-clockwise. Of several curves the largest is the outline, and those in it are
    /// holes.
    #[tsify(optional)]
    pub path: Option<String>,
    /// The boundary as a closed chain of edges, each of which starts where the last one ends, in either orientation.
    #[tsify(optional, type = "EdgeOptions[]")]
    pub edges: Option<JsValue>,
    /// Points `[x0, y0, x1, y1, …]` through which the boundary goes, smoothly but for `corners`: cubic splines, which leave a smooth
    /// curve through the same points by the fourth power of their distance.
    #[tsify(optional, type = "Float64Array")]
    pub through: Option<Float64Array>,
    /// Indices of the points of `through` that are corners; none by default.
    #[tsify(optional)]
    pub corners: Option<Vec<usize>>,
    /// Each hole, in either orientation: its boundary points, joined as `curve` says or as they say themselves, or a path, or edges.
    #[tsify(optional, type = "HoleOptions[]")]
    pub holes: Option<JsValue>,
    /// The point strictly inside that the Riemann map takes to 0. A region with holes needs none, unless its map does.
    #[tsify(optional)]
    pub center: Option<Point>,
    /// The boundary point that goes to 1; snapped to the nearest point of the boundary. A region with holes needs none: its
    /// first boundary point goes there.
    #[tsify(optional)]
    pub toward: Option<Point>,
}
fields!(RegionOptions: boundary, curve, path, edges, through, corners, holes, center, toward);

/// What makes the outside of bodies.
#[derive(Debug, Tsify)]
pub struct ExteriorOptions {
    /// Each body, in either orientation: its boundary points `[x0, y0, x1, y1, …]`, joined as `curve` says or as they say themselves,
    /// a path as `new Region({ path })` takes it, or edges.
    #[tsify(type = "HoleOptions[]")]
    pub holes: JsValue,
    /// How the boundary points are joined; "polygon" by default.
    #[tsify(optional)]
    pub curve: Option<Curve>,
    /// A point that maps take to 0.
    #[tsify(optional)]
    pub center: Option<Point>,
    /// The point of the first body that gives maps their direction; snapped to its boundary.
    #[tsify(optional)]
    pub toward: Option<Point>,
}
fields!(ExteriorOptions: holes, curve, center, toward);

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** An edge of a boundary: one of `line`, `arc` and `bezier`. */
export interface EdgeOptions {
    /** A straight edge, by its two ends. */
    line?: [Point, Point];
    /** Part of a circle or an ellipse. */
    arc?: ArcOptions;
    /** A quadratic Bézier curve by its three control points, or a cubic one by four. */
    bezier?: Point[];
}

/** A hole or a body: boundary points `[x0, y0, x1, y1, …]`, a path in plane coordinates, y up, or edges. */
export type HoleOptions = Float64Array | string | EdgeOptions[] | JoinedPoints;

/** Part of a circle or an ellipse: center + turned by `rotation` (r₀ cos φ, r₁ sin φ), φ from `start` to `start` + `sweep`. */
export interface ArcOptions {
    /** The middle of the circle or ellipse. */
    center: Point;
    /** The radii r₀ and r₁ along the axes of the ellipse, both the same for a circle. */
    radii: [along: number, across: number];
    /** Angle from the x axis to the first axis of the ellipse, counter-clockwise, in radians; 0 by default. */
    rotation?: number;
    /** The angle φ where the arc starts, in radians. */
    start: number;
    /** How far φ runs from there, in radians: counter-clockwise if positive. */
    sweep: number;
}
";

/// What `Region.parseShape` finds: paths in plane coordinates, y up, as `new Region({ path })` takes them.
#[derive(Debug, Tsify)]
pub struct Shape {
    /// The outline.
    pub path: String,
    /// The holes in it.
    pub holes: Vec<String>,
}
written!(Shape: path, holes);

/// How the text of a shape is to be understood.
#[derive(Debug, Default, Tsify)]
pub struct ShapeOptions {
    /// Plane units per unit of the text, 1 by default.
    #[tsify(optional)]
    pub scale: Option<f64>,
}
fields!(ShapeOptions: scale);

/// How the text of an outline is to be understood.
#[derive(Debug, Default, Tsify)]
pub struct OutlineOptions {
    /// Plane units per unit of the text, 1 by default.
    #[tsify(optional)]
    pub scale: Option<f64>,
    /// How far an edge may leave the curve that it stands for, in plane units; 0.1 by default.
    #[tsify(optional)]
    pub tolerance: Option<f64>,
}
fields!(OutlineOptions: scale, tolerance);

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
    /// Throws "not-finite", "too-few-vertices", "self-intersecting", "center-outside" or "invalid-option"; of `path` and `edges`
    /// "invalid-outline" or "cusp"; of holes "holes-meet" or "hole-outside", and the message names which.
    #[wasm_bindgen(constructor)]
    pub fn new(options: Ts<RegionOptions>) -> Result<Self, Failure> {
        let RegionOptions { boundary, curve, path, edges, through, corners, holes, center, toward } =
            options::read(&options)?;
        let given = |point: Option<Point>, name: &str| {
            point.ok_or_else(|| Failure::option(name, &format!("The option \"{name}\" is missing.")))
        };
        let mut holes = outlines(holes)?;
        let has_several = |path: &String| path.matches(['M', 'm']).count() > 1;
        if holes.is_empty() && !path.as_ref().is_some_and(has_several) {
            // What is missing is said before what is wrong.
            given(center, "center")?;
            given(toward, "toward")?;
        }
        let drawn = Given { boundary, path, edges, through, corners }.drawn("A region", |path| {
            let plane::Shape { outline, holes: inner } = plane::parse_path_with_holes(path)?;
            holes.splice(..0, inner.into_iter().map(Drawn::Edges));
            Ok(outline)
        })?;
        if holes.is_empty() {
            let (center, toward) = (given(center, "center")?.into(), given(toward, "toward")?.into());
            return Ok(Self(Kind::Simple(match drawn {
                Drawn::Points(points, _) => plane::Region::new(&points, curve.unwrap_or_default(), center, toward)?,
                Drawn::Edges(edges) => {
                    if curve.is_some() {
                        return Err(not_with_edges("curve"));
                    }
                    plane::Region::from_edges(&edges, center, toward)?
                }
            })));
        }
        holes.insert(0, drawn);
        Ok(Self(Kind::Domain(directed(domain_of(holes, true, curve)?, center, toward)?)))
    }

    /// The unbounded region outside one or more bodies.
    ///
    /// Throws as `new Region()`.
    pub fn exterior(options: Ts<ExteriorOptions>) -> Result<Self, Failure> {
        let ExteriorOptions { holes, curve, center, toward } = options::read(&options)?;
        Ok(Self(Kind::Domain(directed(domain_of(outlines(Some(holes))?, false, curve)?, center, toward)?)))
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

    /// Text → an outline and its holes, with every curve kept as it is: the data of an SVG path, or an SVG file with its basic
    /// shapes, transforms and units, y turned over; or JSON, `[[x, y], …]`. The largest curve is the outline.
    ///
    /// Throws "invalid-outline", also for curves outside of the largest, which it counts, or "invalid-option".
    #[wasm_bindgen(js_name = parseShape)]
    pub fn parse_shape(text: &str, options: Option<Ts<ShapeOptions>>) -> Result<Ts<Shape>, Failure> {
        let ShapeOptions { scale } = options::read_or_default(options.as_ref())?;
        let plane::Shape { outline, holes } = plane::parse_shape(text, scale.unwrap_or(1.0))?;
        let holes = holes.iter().map(|hole| plane::path_data(hole)).collect();
        Ok(options::write(Shape { path: plane::path_data(&outline), holes }))
    }

    /// The boundary points `[x0, y0, x1, y1, …]`, counter-clockwise; none of the outside of bodies. Of `path` and `edges`, those
    /// of a polygon that looks the same: it leaves the curves by less than a hundredth of a pixel where they fill 4096.
    #[wasm_bindgen(getter)]
    pub fn boundary(&self) -> Vec<f64> {
        match &self.0 {
            Kind::Simple(region) => points::to_flat(region.boundary()),
            Kind::Domain(domain) => points::to_flat(domain.boundary().unwrap_or_default()),
        }
    }

    /// The edges of a boundary that was given by `path` or `edges`, as a path in plane coordinates, y up, counter-clockwise, and behind
    /// it those of the holes; undefined for others.
    #[wasm_bindgen(getter)]
    pub fn path(&self) -> Option<String> {
        match &self.0 {
            Kind::Simple(region) => region.curved().map(|outline| plane::path_data(outline.edges())),
            Kind::Domain(domain) => {
                let data = |contour: &plane::Contour| Some(plane::path_data(contour.curved()?.edges()));
                domain.contours().iter().map(data).collect()
            }
        }
    }

    /// The boundary points of each hole or body, counter-clockwise.
    #[wasm_bindgen(getter, unchecked_return_type = "Float64Array[]")]
    pub fn holes(&self) -> Array {
        match &self.0 {
            Kind::Simple(_) => Array::new(),
            Kind::Domain(domain) => {
                domain.holes().iter().map(|hole| Float64Array::from(&points::to_flat(hole)[..])).collect()
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
