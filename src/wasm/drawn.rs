//! Boundaries as options give them: points, a path, edges, or points to be gone through smoothly.

use super::error::Failure;
use super::options::Point;
use super::points;
use super::reading::{Read, fields};
use crate::Error;
use crate::plane::chains::lines_through;
use crate::plane::{self, Complex64, Curve, Domain, Edge, EllipticArc, smooth_edges};
use js_sys::{Array, Float64Array, Reflect};
use tsify::Tsify;
use wasm_bindgen::{JsCast, JsValue};

/// An outline before it is known to bound anything.
pub enum Drawn {
    /// Its points, and how they are joined if not as those of others.
    Points(Vec<Complex64>, Option<Curve>),
    /// Its chain of edges.
    Edges(Vec<Edge>),
}

/// A hole or a body of which the points are joined in its own way: smooth curves may lie beside polygons, paths and edges, as
/// cubic curves that leave them by a few 10⁻¹³ of their size.
#[derive(Debug, Tsify)]
pub struct JoinedPoints {
    /// Its boundary points `[x0, y0, x1, y1, …]`, in either orientation.
    #[tsify(type = "Float64Array")]
    pub boundary: Float64Array,
    /// How they are joined.
    pub curve: Curve,
}
fields!(JoinedPoints: boundary, curve);

/// The ways to give a boundary, of which options hold one.
pub struct Given {
    pub boundary: Option<Float64Array>,
    pub path: Option<String>,
    pub edges: Option<JsValue>,
    pub through: Option<Float64Array>,
    pub corners: Option<Vec<usize>>,
}

impl Given {
    /// The boundary of `what`; `read_path` tells what a path may hold.
    ///
    /// # Errors
    /// "invalid-option" for none or several, [`Error::WrongLength`] for an odd count of numbers, and what is wrong with a path, an
    /// edge or a spline.
    pub fn drawn(self, what: &str, read_path: impl FnOnce(&str) -> Result<Vec<Edge>, Error>) -> Result<Drawn, Failure> {
        if self.corners.is_some() && self.through.is_none() {
            return Err(Failure::option("corners", "The option \"corners\" goes with \"through\" alone."));
        }
        match (self.boundary, self.path, self.edges, self.through) {
            (Some(boundary), None, None, None) => {
                Ok(Drawn::Points(points::from_flat("The boundary", &boundary.to_vec())?, None))
            }
            (None, Some(path), None, None) => Ok(Drawn::Edges(read_path(&path)?)),
            (None, None, Some(edges), None) => Ok(Drawn::Edges(edges_of(&edges)?)),
            (None, None, None, Some(through)) => {
                let points = points::from_flat("The points", &through.to_vec())?;
                Ok(Drawn::Edges(plane::spline(&points, &self.corners.unwrap_or_default())?))
            }
            _ => {
                let message = format!(
                    "{what} needs its boundary in one of the options \"boundary\", \"path\", \"edges\" and \"through\"."
                );
                Err(Failure::option("boundary", &message))
            }
        }
    }
}

/// The refusal of an option that belongs to boundary points.
pub fn not_with_edges(option: &str) -> Failure {
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
        ([], false, []) => match arc_of(&arc) {
            Some(edge) => return Ok(edge),
            None => "the radii of an arc are positive",
        },
        ([], true, &[a, b, c]) => return Ok(Edge::Quadratic([a, b, c])),
        ([], true, &[a, b, c, d]) => return Ok(Edge::Cubic([a, b, c, d])),
        ([], true, [_, ..]) => "a Bézier curve has 3 or 4 control points",
        _ => "an edge is one of line, arc and bezier",
    };
    let name = format!("edges[{k}]");
    Err(Failure::option(&name, &format!("The option \"{name}\" cannot be used: {reason}.")))
}

/// An arc; none if its radii are not positive.
fn arc_of(arc: &JsValue) -> Option<Edge> {
    let number = |name: &str| property(arc, name).as_f64();
    let [center, radii] = ["center", "radii"].map(|name| point_of(&property(arc, name)));
    if !(radii.re > 0.0 && radii.im > 0.0) {
        return None;
    }
    let turn = Complex64::cis(number("rotation").unwrap_or(0.0));
    let (cosine, sine) = (turn * radii.re, turn * Complex64::new(0.0, radii.im));
    let [start, sweep] = ["start", "sweep"].map(|name| number(name).unwrap_or(f64::NAN));
    Some(Edge::Arc(EllipticArc::new(center, cosine, sine, start, sweep)))
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
pub fn outlines(holes: Option<JsValue>) -> Result<Vec<Drawn>, Failure> {
    let outline = |hole: JsValue| {
        if let Some(path) = hole.as_string() {
            return Ok(Drawn::Edges(plane::parse_path(&path)?));
        }
        match hole.dyn_ref::<Float64Array>() {
            Some(array) => Ok(Drawn::Points(points::from_flat("A hole", &array.to_vec())?, None)),
            None if Array::is_array(&hole) => Ok(Drawn::Edges(edges_of(&hole)?)),
            None => {
                let JoinedPoints { boundary, curve } = JoinedPoints::read(&hole)?;
                Ok(Drawn::Points(points::from_flat("A hole", &boundary.to_vec())?, Some(curve)))
            }
        }
    };
    holes.map_or_else(Array::new, |holes| Array::from(&holes)).iter().map(outline).collect()
}

/// The region that outlines bound, `bounded` telling whether the first is around it; `curve` joins the points of those that do not
/// say it themselves.
///
/// # Errors
/// Those of [`Domain::new`], [`Domain::from_edges`] and [`smooth_edges`]; "invalid-option" for a `curve` beside edges.
pub fn domain_of(outlines: Vec<Drawn>, bounded: bool, curve: Option<Curve>) -> Result<Domain, Failure> {
    let usual = curve.unwrap_or_default();
    let joined = |outline: &Drawn| if let Drawn::Points(_, own) = outline { Some(own.unwrap_or(usual)) } else { None };
    let curves: Vec<Option<Curve>> = outlines.iter().map(joined).collect();
    if curve.is_some() && curves.iter().any(Option::is_none) {
        return Err(not_with_edges("curve"));
    }
    if let (Some(curve), true) = (curves[0], curves.iter().all(|other| *other == curves[0])) {
        let points = |outline| if let Drawn::Points(points, _) = outline { points } else { Vec::new() };
        let all: Vec<Vec<Complex64>> = outlines.into_iter().map(points).collect();
        return Ok(if bounded { Domain::new(&all[0], &all[1..], curve)? } else { Domain::exterior(&all, curve)? });
    }
    let edges = |(k, outline)| {
        Ok(match outline {
            Drawn::Edges(edges) => edges,
            Drawn::Points(points, _) if curves[k] == Some(Curve::Smooth) => {
                smooth_edges(&points).map_err(|error| in_hole(k, bounded, error))?
            }
            Drawn::Points(points, _) => lines_through(&points),
        })
    };
    let all = outlines.into_iter().enumerate().map(edges).collect::<Result<Vec<Vec<Edge>>, Error>>()?;
    Ok(if bounded { Domain::from_edges(&all[0], &all[1..])? } else { Domain::exterior_of_edges(&all)? })
}

/// What is wrong with the outline number `k`, as [`Domain`] says it.
fn in_hole(k: usize, bounded: bool, error: Error) -> Error {
    match k.checked_sub(usize::from(bounded)) {
        Some(hole) => Error::InHole { hole, error: Box::new(error) },
        None => error,
    }
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
