//! `Region` in JavaScript.

use super::error::Failure;
use super::options::{self, Point};
use super::points;
use crate::Error;
use crate::plane::{self, Complex64, Curve, Domain, Edge, EllipticArc, NOWHERE};
use js_sys::{Array, Float64Array, Reflect};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};

/// What makes a region.
#[derive(Debug, Deserialize, Tsify)]
pub struct RegionOptions {
    /// The boundary points `[x0, y0, x1, y1, …]`, in either orientation. A boundary is given by this, by `path`, by `edges` or by
    /// `through`.
    #[serde(default, deserialize_with = "options::some_numbers")]
    #[tsify(optional, type = "Float64Array")]
    pub boundary: Option<Vec<f64>>,
    /// How the boundary points are joined; "polygon" by default.
    #[tsify(optional)]
    pub curve: Option<Curve>,
    /// The boundary as one closed curve in the language of SVG's paths, every command kept exactly; but in plane coordinates, y
    /// up, so that arcs with the sweep flag run counter-clockwise. Of several curves the largest is the outline, and those in it are
    /// holes.
    #[tsify(optional)]
    pub path: Option<String>,
    /// The boundary as a closed chain of edges, each of which starts where the last one ends, in either orientation.
    #[serde(default, deserialize_with = "options::some_value")]
    #[tsify(optional, type = "EdgeOptions[]")]
    pub edges: Option<JsValue>,
    /// Points `[x0, y0, x1, y1, …]` through which the boundary goes, smoothly but for `corners`: cubic splines, which leave a smooth
    /// curve through the same points by the fourth power of their distance.
    #[serde(default, deserialize_with = "options::some_numbers")]
    #[tsify(optional, type = "Float64Array")]
    pub through: Option<Vec<f64>>,
    /// Indices of the points of `through` that are corners; none by default.
    #[tsify(optional)]
    pub corners: Option<Vec<usize>>,
    /// Each hole, in either orientation: its boundary points, joined as those of `boundary`, or a path, or edges.
    #[serde(default, deserialize_with = "options::some_value")]
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

/// What makes the outside of bodies.
#[derive(Debug, Deserialize, Tsify)]
pub struct ExteriorOptions {
    /// Each body, in either orientation: its boundary points `[x0, y0, x1, y1, …]`, a path as `new Region({ path })` takes it, or edges.
    #[serde(deserialize_with = "options::some_value")]
    #[tsify(type = "HoleOptions[]")]
    pub holes: Option<JsValue>,
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
export type HoleOptions = Float64Array | string | EdgeOptions[];

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
#[derive(Debug, Serialize, Tsify)]
pub struct Shape {
    /// The outline.
    pub path: String,
    /// The holes in it.
    pub holes: Vec<String>,
}

/// How the text of a shape is to be understood.
#[derive(Debug, Default, Deserialize, Tsify)]
#[serde(default)]
pub struct ShapeOptions {
    /// Plane units per unit of the text, 1 by default.
    #[tsify(optional)]
    pub scale: Option<f64>,
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
        if corners.is_some() && through.is_none() {
            return Err(Failure::option("corners", "The option \"corners\" goes with \"through\" alone."));
        }
        let drawn = match (boundary, path, edges, through) {
            (Some(boundary), None, None, None) => Drawn::Points(points::from_flat("The boundary", &boundary)?),
            (None, Some(path), None, None) => {
                let plane::Shape { outline, holes: inner } = plane::parse_path_with_holes(&path)?;
                holes.splice(..0, inner.into_iter().map(Drawn::Edges));
                Drawn::Edges(outline)
            }
            (None, None, Some(edges), None) => Drawn::Edges(edges_of(&edges)?),
            (None, None, None, Some(through)) => {
                let points = points::from_flat("The points", &through)?;
                Drawn::Edges(plane::spline(&points, &corners.unwrap_or_default())?)
            }
            _ => {
                let message = "A region needs its boundary in one of the options \"boundary\", \"path\", \"edges\" and \"through\".";
                return Err(Failure::option("boundary", message));
            }
        };
        if holes.is_empty() {
            let (center, toward) = (given(center, "center")?.into(), given(toward, "toward")?.into());
            return Ok(Self(Kind::Simple(match drawn {
                Drawn::Points(points) => plane::Region::new(&points, curve.unwrap_or_default(), center, toward)?,
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
        Ok(Self(Kind::Domain(directed(domain_of(outlines(holes)?, false, curve)?, center, toward)?)))
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
        options::write(&Shape { path: plane::path_data(&outline), holes })
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

enum Drawn {
    Points(Vec<Complex64>),
    Edges(Vec<Edge>),
}

fn not_with_edges(option: &str) -> Failure {
    let message = format!("The option \"{option}\" goes with \"boundary\" alone.");
    Failure::option(option, &message)
}

/// The edges as options hold them: `EdgeOptions[]`.
///
/// # Errors
/// "invalid-option" for one that is none or several of a line, an arc and a Bézier curve.
fn edges_of(edges: &JsValue) -> Result<Vec<Edge>, Failure> {
    Array::from(edges).iter().enumerate().map(|(k, edge)| edge_of(k, &edge)).collect()
}

fn edge_of(k: usize, edge: &JsValue) -> Result<Edge, Failure> {
    let [line, arc, bezier] = ["line", "arc", "bezier"].map(|kind| property(edge, kind));
    let reason = match (&points_of(&line)[..], arc.is_undefined(), &points_of(&bezier)[..]) {
        (&[from, to], true, []) => return Ok(Edge::line(from, to)),
        ([], false, []) => return Ok(arc_of(&arc)),
        ([], true, &[a, b, c]) => return Ok(Edge::Quadratic([a, b, c])),
        ([], true, &[a, b, c, d]) => return Ok(Edge::Cubic([a, b, c, d])),
        ([], true, [_, ..]) => "a Bézier curve has 3 or 4 control points",
        _ => "an edge is one of line, arc and bezier",
    };
    let name = format!("edges[{k}]");
    Err(Failure::option(&name, &format!("The option \"{name}\" cannot be used: {reason}.")))
}

fn arc_of(arc: &JsValue) -> Edge {
    let number = |name: &str| property(arc, name).as_f64();
    let [center, radii] = ["center", "radii"].map(|name| point_of(&property(arc, name)));
    let turn = Complex64::cis(number("rotation").unwrap_or(0.0));
    let (cosine, sine) = (turn * radii.re, turn * Complex64::new(0.0, radii.im));
    let [start, sweep] = ["start", "sweep"].map(|name| number(name).unwrap_or(f64::NAN));
    Edge::Arc(EllipticArc::new(center, cosine, sine, start, sweep))
}

fn property(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or(JsValue::UNDEFINED)
}

fn points_of(value: &JsValue) -> Vec<Complex64> {
    if value.is_undefined() { Vec::new() } else { Array::from(value).iter().map(|point| point_of(&point)).collect() }
}

/// A point, not a finite one if it is anything else.
fn point_of(value: &JsValue) -> Complex64 {
    let [x, y] = [0, 1].map(|k| Reflect::get_u32(value, k).ok().and_then(|x| x.as_f64()).unwrap_or(f64::NAN));
    Complex64::new(x, y)
}

/// The outlines of holes.
///
/// # Errors
/// [`Error::WrongLength`] for an odd count of numbers; "invalid-option" for what is no outline, and what is wrong with a path.
fn outlines(holes: Option<JsValue>) -> Result<Vec<Drawn>, Failure> {
    let outline = |hole: JsValue| {
        if let Some(path) = hole.as_string() {
            return Ok(Drawn::Edges(plane::parse_path(&path)?));
        }
        match hole.dyn_ref::<Float64Array>() {
            Some(array) => Ok(Drawn::Points(points::from_flat("A hole", &array.to_vec())?)),
            None if Array::is_array(&hole) => Ok(Drawn::Edges(edges_of(&hole)?)),
            None => Err(Failure::option("holes", "A hole is a Float64Array, a path or an array of edges.")),
        }
    };
    holes.map_or_else(Array::new, |holes| Array::from(&holes)).iter().map(outline).collect()
}

/// The region that outlines bound, `bounded` telling whether the first is around it.
///
/// # Errors
/// Those of [`Domain::new`] and [`Domain::from_edges`]; "invalid-option" for a `curve` beside edges.
fn domain_of(outlines: Vec<Drawn>, bounded: bool, curve: Option<Curve>) -> Result<Domain, Failure> {
    let points = |outline: &Drawn| if let Drawn::Points(points) = outline { Some(points.clone()) } else { None };
    if let Some(all) = outlines.iter().map(points).collect::<Option<Vec<_>>>() {
        let curve = curve.unwrap_or_default();
        return Ok(if bounded { Domain::new(&all[0], &all[1..], curve)? } else { Domain::exterior(&all, curve)? });
    }
    if curve.is_some() {
        return Err(not_with_edges("curve"));
    }
    let edges = |outline| match outline {
        Drawn::Edges(edges) => edges,
        Drawn::Points(points) => {
            (0..points.len()).map(|k| Edge::line(points[k], points[(k + 1) % points.len()])).collect()
        }
    };
    let all: Vec<Vec<Edge>> = outlines.into_iter().map(edges).collect();
    Ok(if bounded { Domain::from_edges(&all[0], &all[1..])? } else { Domain::exterior_of_edges(&all)? })
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
