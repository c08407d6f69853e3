//! Outlines that come as text: points in JSON, the data of an SVG path, or an SVG file.

use super::affine::Affine;
use super::chains::{area, closed, contour, lines_through, size, surrounds};
use super::svg_path::Chain;
use super::{Complex64, Edge, json_points, svg_file, svg_path};
use crate::{Error, Result};

/// An outline and its holes, each a closed chain of edges as it was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// The outline.
    pub outline: Vec<Edge>,
    /// What is inside of it.
    pub holes: Vec<Vec<Edge>>,
}

/// Text → the vertices of an outline, times `scale`.
///
/// - JSON, `[[x, y], …]`: the vertices, in the plane's own way, y up.
/// - What an SVG path has as `d`: one closed curve of any commands, y down and turned over. Curves become edges that leave
///   them by `tolerance` at most, in the outline's units (that is after scaling).
/// - An SVG file that draws one closed curve: a path or basic shape with all its transforms, in the user units of the
///   outermost `svg` (those of its `viewBox`).
///
/// Subpaths without a segment draw nothing. An end that misses the start by less than the tolerance, as the rounded numbers
/// of icons do, is closed. Text is read to its end: what cannot be read is an error that says where it stands.
///
/// The outline may cross itself: whether it can bound a region is for [`Region::new`](super::Region::new)'s. [`parse_shape`]
/// keeps curves as they are, and holes.
///
/// ```
/// use conformal_warp::parse_outline;
/// let square = parse_outline("[[0, 0], [2, 0], [2, 1], [0, 1]]", 10.0, 0.1)?;
/// assert_eq!((square.len(), square[2].re, square[2].im), (4, 20.0, 10.0));
/// let rounded = parse_outline("M0,0 h20 c5,0 5,-10 0,-10 h-20 z", 1.0, 0.1)?;
/// assert!(rounded.len() > 6 && rounded.iter().all(|z| z.im >= 0.0));
/// # Ok::<(), conformal_warp::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidOutline`] for text that is none of these; [`Error::InvalidOption`] unless scale and tolerance are positive and
/// finite.
pub fn parse_outline(text: &str, scale: f64, tolerance: f64) -> Result<Vec<Complex64>> {
    check_positive("scale", scale)?;
    check_positive("tolerance", tolerance)?;
    let vertices = match drawn(text)? {
        Drawn::Points(points) => points,
        Drawn::Chains(chains) => one_of(&chains, tolerance / scale)?,
    };
    Ok(vertices.into_iter().map(|z| z * scale).collect())
}

/// Text → an outline with its holes, exactly as drawn, times `scale`: lines, arcs and Bézier curves.
///
/// The texts are those of [`parse_outline`], which flattens curves. The curve of the largest area is the outline, those inside
/// of it are its holes. An end that misses the start by less than a thousandth of the curve's size and a quarter of the edges
/// there is moved onto it; a wider gap is closed by a line.
///
/// ```
/// use conformal_warp::{Complex64, Region, parse_shape};
/// let shape = parse_shape("M-1 0 A1 1 0 0 1 1 0 Z", 2.0)?;
/// assert_eq!((shape.outline.len(), shape.holes.len()), (2, 0));
/// let half_disk = Region::from_edges(&shape.outline, Complex64::new(0.0, 1.0), Complex64::new(2.0, 0.0))?;
/// assert!(half_disk.contains(Complex64::new(0.0, 2.0 - 1e-14)));
/// # Ok::<(), conformal_warp::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidOutline`] for text that is none of these, and for curves that are neither the outline nor inside of it, which
/// are counted; [`Error::InvalidOption`] unless `scale` is positive and finite.
pub fn parse_shape(text: &str, scale: f64) -> Result<Shape> {
    check_positive("scale", scale)?;
    let chains = match drawn(text)? {
        Drawn::Chains(chains) => chains.iter().map(|chain| closed(chain)).collect(),
        Drawn::Points(points) => vec![lines_through(&points)],
    };
    let scaled = |chain: Chain| chain.iter().map(|edge| edge.scaled(scale.into())).collect();
    let Shape { outline, holes } = sorted(chains)?;
    let shape = Shape { outline: scaled(outline), holes: holes.into_iter().map(scaled).collect() };
    if shape.outline.iter().all(Edge::is_finite) { Ok(shape) } else { Err(invalid(TOO_LARGE)) }
}

/// The data of an SVG path in the plane's own coordinates, y up, → the edges of one closed curve. Arcs with the sweep flag run
/// counter-clockwise.
///
/// ```
/// use conformal_warp::{Complex64, parse_path};
/// let half_disk = parse_path("M-1 0 L1 0 A1 1 0 0 1 -1 0 Z")?;
/// assert!((half_disk[1].point(0.5) - Complex64::I).norm() < 1e-15);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
///
/// # Errors
/// [`Error::InvalidOutline`] for text that is no path data, or that draws none or several curves.
pub fn parse_path(data: &str) -> Result<Vec<Edge>> {
    let mut chains = svg_path::read(data.trim()).map_err(invalid)?;
    match (chains.len(), chains.pop()) {
        (1, Some(chain)) => Ok(closed(&chain)),
        (count, _) => Err(wrong_count(count)),
    }
}

/// The data of an SVG path in the plane's own coordinates → a closed curve, the largest of those that it draws, and the holes in it.
///
/// # Errors
/// As [`parse_shape`].
pub fn parse_path_with_holes(data: &str) -> Result<Shape> {
    sorted(svg_path::read(data.trim()).map_err(invalid)?.iter().map(|chain| closed(chain)).collect())
}

/// A closed chain of edges → the data of an SVG path in the plane's own coordinates, from which [`parse_path`] makes the same
/// edges, up to the rounding of arcs.
#[must_use]
pub fn path_data(edges: &[Edge]) -> String {
    svg_path::write(edges)
}

fn check_positive(name: &'static str, value: f64) -> Result<()> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(Error::InvalidOption { name, expected: "a positive number", value })
}

const TOO_LARGE: &str = "it is larger than numbers can say";

enum Drawn {
    Points(Vec<Complex64>),
    Chains(Vec<Chain>),
}

/// What a text draws, y up.
fn drawn(text: &str) -> Result<Drawn> {
    let text = text.trim();
    let chains = match text.chars().next() {
        Some('[' | '{') => return Ok(Drawn::Points(from_json(text)?)),
        Some('<') => svg_file::read(text),
        _ => svg_path::read(text),
    };
    let upright = Affine::scale(1.0, -1.0);
    let turned = |chain: Chain| -> Chain { chain.iter().map(|edge| upright.edge(edge)).collect() };
    let chains: Vec<Chain> = chains.map_err(invalid)?.into_iter().map(turned).collect();
    if chains.iter().flatten().all(Edge::is_finite) { Ok(Drawn::Chains(chains)) } else { Err(invalid(TOO_LARGE)) }
}

fn from_json(text: &str) -> Result<Vec<Complex64>> {
    let mut vertices = json_points::read(text).map_err(invalid)?;
    // A last vertex that repeats the first only closes what is closed.
    if vertices.len() > 1 && vertices.first() == vertices.last() {
        vertices.pop();
    }
    enclosing(vertices)
}

/// Vertices that can have something between them.
fn enclosing(vertices: Vec<Complex64>) -> Result<Vec<Complex64>> {
    match vertices.len() {
        0 => Err(invalid("it has no points")),
        1 | 2 => Err(invalid("an outline needs three points that differ")),
        _ => Ok(vertices),
    }
}

/// The one curve that all these draw, as the vertices of a closed polygon.
fn one_of(chains: &[Chain], tolerance: f64) -> Result<Vec<Complex64>> {
    let mut contours: Vec<_> = chains.iter().map(|chain| contour(chain, tolerance)).collect();
    contours.retain(|contour| contour.len() > 1);
    match (contours.len(), contours.pop()) {
        (1, Some(contour)) => enclosing(contour),
        (count, _) => Err(wrong_count(count)),
    }
}

fn wrong_count(count: usize) -> Error {
    if count == 0 {
        return invalid("there is no curve");
    }
    invalid(format!("it has {count} curves, and an outline is one"))
}

/// The outline, the chain of the largest area, and its holes.
#[inline(never)]
fn sorted(mut chains: Vec<Chain>) -> Result<Shape> {
    chains.retain(|chain| !chain.is_empty());
    let polygons: Vec<Vec<Complex64>> = chains.iter().map(|chain| contour(chain, 1e-3 * size(chain))).collect();
    let areas: Vec<f64> = polygons.iter().map(|polygon| area(polygon)).collect();
    let largest = (0..chains.len()).max_by(|a, b| areas[*a].total_cmp(&areas[*b]));
    let Some(largest) = largest else { return Err(wrong_count(0)) };
    let count = chains.len();
    let outside = (0..count).filter(|k| *k != largest && !surrounds(&polygons[largest], polygons[*k][0])).count();
    if outside > 0 {
        let reason = format!(
            "it has {count} curves, and {outside} of them {} outside of the largest: an outline is one curve, with holes inside",
            if outside == 1 { "lies" } else { "lie" }
        );
        return Err(invalid(reason));
    }
    let outline = chains.remove(largest);
    Ok(Shape { outline, holes: chains })
}

fn invalid(reason: impl Into<String>) -> Error {
    Error::InvalidOutline { reason: reason.into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::{ArcTo, Polygon};

    fn area(text: &str) -> f64 {
        Polygon::new(&parse_outline(text, 1.0, 1e-3).unwrap()).unwrap().area().abs()
    }

    #[test]
    fn json_and_path_give_the_same_triangle() {
        let json = parse_outline(" [[1, 2], [5, 2.5], [3, 7e0]]\n", 0.5, 0.1).unwrap();
        for path in ["M1,-2 L5,-2.5 3,-7 Z", "m 1 -2 l 4 -0.5 l -2 -4.5 z", "M1-2L5-2.5 3-7 1-2"] {
            assert_eq!(parse_outline(path, 0.5, 0.1).unwrap(), json, "{path}");
        }
    }

    #[test]
    fn curves_are_followed_within_the_tolerance() {
        // A circle by two arcs, of radius 10.
        let circle = "M10,0 A10,10 0 0 1 -10,0 A10,10 0 0 1 10,0 Z";
        assert!((area(circle) / (100.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
        for tolerance in [1.0, 0.1, 0.01] {
            for vertex in parse_outline(circle, 3.0, tolerance).unwrap() {
                assert!((vertex.norm() - 30.0).abs() <= tolerance);
            }
        }
        let [coarse, fine] = [1.0, 1e-3].map(|tolerance| parse_outline(circle, 3.0, tolerance).unwrap().len());
        assert!(fine > 3 * coarse, "{coarse} and {fine} vertices");
        // Relative cubic and smooth quadratic commands.
        assert!(area("M0 0c0-5 10-5 10 0s-10 5-10 0z") > 10.0 && area("M0 0q5 -9 10 0t-10 9z") > 10.0);
    }

    #[test]
    fn what_is_no_outline_is_refused_in_words() {
        let refused = [
            ("[[1, 2], [3]]", "length"),
            ("[1, 2, 3, 4]", "expected"),
            ("{\"x\": 1}", "expected"),
            ("[[0, 0], [1, 0], [", "EOF"),
            ("hello", "begins with “h”"),
            ("", "no curve"),
            ("M0 0h1v1z M5 5h1v1z", "2 curves"),
            ("M0 0 L 1e999 0 z", ""),
        ];
        for (text, reason) in refused {
            let error = parse_outline(text, 1.0, 0.1).unwrap_err();
            assert_eq!(error.code(), "invalid-outline", "{text}");
            assert!(error.to_string().to_lowercase().contains(&reason.to_lowercase()), "{text}: {error}");
        }
        assert_eq!(parse_outline("M0 0h1v1z", 0.0, 0.1).unwrap_err().code(), "invalid-option");
        assert_eq!(parse_outline("M0 0h1v1z", 1.0, f64::NAN).unwrap_err().code(), "invalid-option");
    }

    fn fault(name: &str) -> serde_json::Value {
        let path = format!("{}/tests/fixtures/faults/{name}.json", env!("CARGO_MANIFEST_DIR"));
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
    }

    #[test]
    fn nothing_is_dropped_after_a_strange_character() {
        for (name, text) in fault("path-silent-truncation")["inputs"].as_object().unwrap() {
            let error = parse_outline(text.as_str().unwrap(), 1.0, 0.1).unwrap_err();
            let strange = ["−", ";", "\u{a0}", ",", "\"", "…"].into_iter().find(|c| text.as_str().unwrap().contains(c));
            assert!(error.to_string().contains(&format!("“{}”", strange.unwrap())), "{name}: {error}");
        }
        let error = parse_outline("M0 0 L10 0 L10 10; L0 10 z", 1.0, 0.1).unwrap_err();
        assert!(error.to_string().contains("character 18"), "{error}");
        assert!(parse_outline("M0 0 L10", 1.0, 0.1).unwrap_err().to_string().contains("ends"));
    }

    #[test]
    fn subpaths_without_segments_draw_nothing() {
        for text in fault("path-trailing-moveto")["inputs"].as_object().unwrap().values() {
            let outline = parse_outline(text.as_str().unwrap(), 1.0, 0.1).unwrap();
            assert_eq!((outline.len(), Polygon::new(&outline).unwrap().area()), (4, 200.0), "{text}");
        }
    }

    #[test]
    fn a_closing_residue_is_closed() {
        let fault = fault("closing-residue");
        let outline = parse_outline(fault["input"].as_str().unwrap(), 1.0, 0.1).unwrap();
        assert_eq!(Polygon::new(&outline).unwrap().area(), 200.0);
        // A dense outline keeps all its vertices, also where they are closer than the tolerance.
        let dense: Vec<String> =
            (0..100).map(|k| Complex64::cis(0.0628 * f64::from(k))).map(|z| format!("{} {}", z.re, z.im)).collect();
        assert_eq!(parse_outline(&format!("M{}z", dense.join(" ")), 1.0, 0.5).unwrap().len(), 100);
    }

    #[test]
    fn smooth_commands_and_arcs_are_those_of_svg() {
        // T and S mirror the control point of their own kind only.
        let [after_line, written] = ["M0 0L4 0T8 4L0 8z", "M0 0L4 0Q4 0 8 4L0 8z"].map(|d| parse_outline(d, 1.0, 1e-3));
        assert_eq!(after_line, written);
        // Arcs keep the tolerance, however small.
        for vertex in parse_outline("M1 0A1 1 0 0 1-1 0A1 1 0 0 1 1 0z", 1.0, 1e-6).unwrap() {
            assert!((vertex.norm() - 1.0).abs() < 1e-6, "{vertex}");
        }
    }

    #[test]
    fn files_are_drawn_with_their_transforms() {
        let folder = format!("{}/tests/fixtures/faults", env!("CARGO_MANIFEST_DIR"));
        for (name, expected) in
            [("svg-file-transform", 5200.0 / 3.0), ("svg-file-first-path-is-not-the-outline", 2600.0 / 3.0)]
        {
            let text = std::fs::read_to_string(format!("{folder}/{name}.svg")).unwrap();
            assert!((area(&text) / expected - 1.0).abs() < 1e-3, "{name}");
        }
        let file = |inside: &str| {
            format!(
                "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 100 50'>{inside}</svg>"
            )
        };
        let drawn = [
            ("<rect x='1' y='2' width='30%' height='20'/>", 600.0),
            ("<rect width='20' height='10' rx='2'/>", 200.0 - 4.0 * (4.0 - std::f64::consts::PI) / 4.0 * 4.0),
            ("<circle cx='5' cy='5' r='3'/>", 9.0 * std::f64::consts::PI),
            ("<g transform='scale(2)'><ellipse cx='5' cy='5' rx='3' ry='1'/></g>", 12.0 * std::f64::consts::PI),
            ("<polygon points='0,0 4,0 4,3'/>", 6.0),
            ("<defs><path id='a' d='M0 0h2v2h-2z'/></defs><use xlink:href='#a' transform='scale(3 1)'/>", 12.0),
            ("<svg width='50' height='50' viewBox='0 0 10 10'><path d='M0 0h2v2h-2z'/></svg>", 100.0),
            ("<path d='M0 0h24v24H0z' fill='none'/><path style='fill:none;stroke:red' d='M0 0h2v2h-2z'/>", 4.0),
            ("<path d='M0 0h24v24H0z' display='none'/><rect width='1in' height='1'/>", 96.0),
        ];
        for (inside, expected) in drawn {
            let found = area(&file(inside));
            assert!((found / expected - 1.0).abs() < 2e-3, "{inside}: {found}");
        }
        let refused = [
            ("<svg><path", "no XML"),
            ("<html/>", "“html”"),
            (&file("<text>A</text>"), "no curve"),
            (&file("<path d='M0 0h1v1z'/><circle r='1'/>"), "2 curves"),
            (&file("<path d='M0 0h1v1z' transform='turn(3)'/>"), "turn(3)"),
            (&file("<use href='#a'/>"), "“#a”"),
            (&file("<g id='a'><use href='#a'/></g>"), "inside each other"),
            (&file("<rect width='wide'/>"), "no length"),
            (&file("<rect width='5' height='-3' rx='9'/>"), "no curve"),
        ];
        for (text, reason) in refused {
            let error = parse_outline(text, 1.0, 0.1).unwrap_err();
            assert!(error.code() == "invalid-outline" && error.to_string().contains(reason), "{text}: {error}");
        }
    }

    fn at(x: f64, y: f64) -> Complex64 {
        Complex64::new(x, y)
    }

    #[test]
    fn every_command_is_read_exactly() {
        // From (1, 2), absolutely and relatively; y up.
        let cubic = |b, c, d| Edge::Cubic([at(1.0, 2.0), b, c, d]);
        let quadratic = |b, c| Edge::Quadratic([at(1.0, 2.0), b, c]);
        let arc = ArcTo { radii: (3.0, 2.0), rotation: 30f64.to_radians(), large: true, counterclockwise: true };
        let drawn = [
            ("L4 6", "l3 4", Edge::line(at(1.0, 2.0), at(4.0, 6.0))),
            ("H4", "h3", Edge::line(at(1.0, 2.0), at(4.0, 2.0))),
            ("V6", "v4", Edge::line(at(1.0, 2.0), at(1.0, 6.0))),
            ("C3 2 5 4 4 6", "c2 0 4 2 3 4", cubic(at(3.0, 2.0), at(5.0, 4.0), at(4.0, 6.0))),
            ("S5 4 4 6", "s4 2 3 4", cubic(at(1.0, 2.0), at(5.0, 4.0), at(4.0, 6.0))),
            ("Q5 4 4 6", "q4 2 3 4", quadratic(at(5.0, 4.0), at(4.0, 6.0))),
            ("T4 6", "t3 4", quadratic(at(1.0, 2.0), at(4.0, 6.0))),
            ("A3 2 30 1 1 4 6", "a3 2 30 113 4", Edge::arc_to(at(1.0, 2.0), at(4.0, 6.0), arc)),
        ];
        for (absolute, relative, edge) in drawn {
            for command in [absolute, relative] {
                let path = parse_path(&format!("M1 2{command} V-9Z")).unwrap();
                assert_eq!((path.len(), path[0]), (3, edge), "{command}");
                assert_eq!((path[2].from().im, path[2].to()), (-9.0, at(1.0, 2.0)));
            }
        }
        // Smooth commands mirror the control point of the last curve of their own kind.
        let smooth = parse_path("M0 0C0 1 1 2 2 2s3 -1 3 -3Q5 -2 4 -2t-1 -1Z").unwrap();
        assert_eq!(smooth[1], Edge::Cubic([at(2.0, 2.0), at(3.0, 2.0), at(5.0, 1.0), at(5.0, -1.0)]));
        assert_eq!(smooth[3], Edge::Quadratic([at(4.0, -2.0), at(3.0, -2.0), at(3.0, -3.0)]));
        // Further pairs are lines, and what follows a closed subpath begins where that began.
        assert_eq!(parse_path("m1 2 3 4 5-6z").unwrap()[1], Edge::line(at(4.0, 6.0), at(9.0, 0.0)));
        assert!(parse_path("M0 0h1v1zh-1v-1z").unwrap_err().to_string().contains("2 curves"));
    }

    #[test]
    fn paths_are_written_as_they_are_read() {
        for path in ["M0 0Q5 -9 10 0C10 8 3 9 4 4L-1.5e-7 3Z", "M1 0A1 1 0 1 1 0 1L0.25 0.5Z", "M3 0A4 2 33 0 0 0 5V1Z"]
        {
            let edges = parse_path(path).unwrap();
            let again = parse_path(&path_data(&edges)).unwrap();
            let ends = |edges: &[Edge]| edges.iter().map(Edge::to).collect::<Vec<_>>();
            let straight = edges.iter().filter(|edge| !matches!(edge, Edge::Arc(_)));
            assert!(straight.clone().all(|edge| again.contains(edge)), "{path}: {again:?}");
            assert!(ends(&edges).iter().all(|end| ends(&again).contains(end)));
            for (k, edge) in edges.iter().enumerate().filter(|(_, edge)| matches!(edge, Edge::Arc(_))) {
                // Much of an ellipse is written as two parts.
                let halves = &again[k..k + 1 + again.len() - edges.len()];
                for t in [0.1, 0.4, 0.6, 0.9] {
                    let share = t * halves.len() as f64;
                    let half = &halves[share as usize];
                    assert!((half.point(share.fract()) - edge.point(t)).norm() < 1e-14, "{path} {t}");
                }
            }
        }
    }

    #[test]
    fn files_keep_circles_as_circles() {
        let file = "<svg viewBox='0 0 100 50'><g transform='translate(3 4) rotate(90) scale(2 -2)'>\
            <circle cx='1' cy='2' r='3'/></g></svg>";
        // (x, y) → (2y + 3, 2x + 4), and turned over.
        let shape = parse_shape(file, 0.5).unwrap();
        for edge in &shape.outline {
            for t in [0.0, 0.3, 0.5, 1.0] {
                assert!(((edge.point(t) - at(3.5, -3.0)).norm() - 3.0).abs() < 2e-15);
            }
        }
        let rect = parse_shape("<svg><rect x='1' width='9' height='5' rx='2' ry='1'/></svg>", 1.0).unwrap().outline;
        assert_eq!(rect.len(), 8);
        assert_eq!(rect[0], Edge::line(at(3.0, 0.0), at(8.0, 0.0)));
        let bow = (rect[1].point(0.5) - at(8.0, -1.0)) * std::f64::consts::SQRT_2;
        assert!((bow - at(2.0, 1.0)).norm() < 2e-15);
        assert_eq!(parse_shape("<svg><rect width='9' height='5'/></svg>", 1.0).unwrap().outline.len(), 4);
        let squeezed = "<svg><circle r='1' transform='scale(3 1) rotate(20)'/></svg>";
        for edge in parse_shape(squeezed, 1.0).unwrap().outline {
            let z = edge.point(0.3);
            assert!(((z.re / 3.0).hypot(z.im) - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn the_largest_subpath_is_the_outline_and_those_inside_are_holes() {
        let shape = parse_shape("M2 2h1v1h-1zM0 0h10v10h-10zm6 6a1 1 0 0 0 2 0 1 1 0 0 0-2 0zM0 0", 1.0).unwrap();
        assert_eq!(shape.outline[2].to(), at(0.0, -10.0));
        assert_eq!(shape.holes.iter().map(Vec::len).collect::<Vec<_>>(), [4, 2]);
        let apart = parse_shape("M0 0h9v9h-9zM2 2h1v1zM20 0h1v1zM30 0h1v1z", 1.0).unwrap_err().to_string();
        assert!(apart.contains("4 curves") && apart.contains("2 of them lie outside"), "{apart}");
        assert_eq!(parse_shape("[[0, 0], [1, 0], [0, 1], [0, 0]]", 1.0).unwrap().outline.len(), 3);
        assert!(parse_shape("M0 0zM1 1", 1.0).unwrap_err().to_string().contains("no curve"));
        assert_eq!(parse_shape("M0 0h1v1z", -1.0).unwrap_err().code(), "invalid-option");
    }

    #[test]
    fn known_faults_stay_right_with_curves() {
        let residue = parse_shape(fault("closing-residue")["input"].as_str().unwrap(), 1.0).unwrap().outline;
        assert_eq!((residue.len(), residue[4].to()), (5, at(10.0, 0.0)));
        // The same with an arc last: it is turned onto the start, and nothing is left to close.
        let bent = parse_shape("M10 0h10v10h-20a5 5 0 0 1 10.01-10z", 1.0).unwrap().outline;
        assert!(bent.len() == 4 && (bent[3].to() - at(10.0, 0.0)).norm() < 1e-14, "{bent:?}");
        for text in fault("path-trailing-moveto")["inputs"].as_object().unwrap().values() {
            let shape = parse_shape(text.as_str().unwrap(), 1.0).unwrap();
            assert_eq!((shape.outline.len(), shape.holes.len()), (4, 0), "{text}");
        }
        for (name, text) in fault("path-silent-truncation")["inputs"].as_object().unwrap() {
            assert_eq!(parse_shape(text.as_str().unwrap(), 1.0).unwrap_err().code(), "invalid-outline", "{name}");
        }
        // Where a gap is too wide for rounding, a line closes it.
        assert_eq!(parse_shape("M0 0h10v10h-10", 1.0).unwrap().outline.len(), 4);
    }
}
