//! Outlines that come as text: points in JSON, the data of an SVG path, or an SVG file.

use super::svg_path::attainable;
use super::{Complex64, json_points, svg_file, svg_path};
use crate::{Error, Result};
use kurbo::{BezPath, PathEl, Point};

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
/// The outline may cross itself: whether it can bound a region is for [`Region::new`](super::Region::new)'s.
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
    for (name, value) in [("scale", scale), ("tolerance", tolerance)] {
        if !value.is_finite() || value <= 0.0 {
            return Err(Error::InvalidOption { name, expected: "a positive number", value });
        }
    }
    let text = text.trim();
    let vertices = match text.chars().next() {
        Some('[' | '{') => from_json(text)?,
        Some('<') => one_of(&svg_file::read(text, tolerance / scale / 4.0).map_err(invalid)?, tolerance / scale)?,
        _ => one_of(&[svg_path::read(text, tolerance / scale / 4.0).map_err(invalid)?], tolerance / scale)?,
    };
    Ok(vertices.into_iter().map(|z| z * scale).collect())
}

fn from_json(text: &str) -> Result<Vec<Complex64>> {
    let mut vertices = json_points::read(text).map_err(invalid)?;
    // A last vertex that repeats the first only closes what is closed.
    if vertices.len() > 1 && vertices.first() == vertices.last() {
        vertices.pop();
    }
    Ok(vertices)
}

/// The one curve that all these draw, as the vertices of a closed polygon.
fn one_of(paths: &[BezPath], tolerance: f64) -> Result<Vec<Complex64>> {
    if !paths.iter().all(BezPath::is_finite) {
        return Err(invalid("it is larger than numbers can say"));
    }
    let mut contours: Vec<_> = paths.iter().flat_map(|path| contours(path, tolerance)).collect();
    match (contours.len(), contours.pop()) {
        (1, Some(contour)) => Ok(contour),
        (0, _) => Err(invalid("there is no curve")),
        (count, _) => Err(invalid(format!("it has {count} curves, and an outline is one"))),
    }
}

/// The polygons of a path's subpaths; those without a segment draw nothing, and are none.
fn contours(path: &BezPath, tolerance: f64) -> Vec<Vec<Complex64>> {
    let mut contours: Vec<Vec<Complex64>> = Vec::new();
    // Elliptical arcs have had the rest of the tolerance.
    let size = path.control_box().size().to_vec2().hypot();
    kurbo::flatten(path, 0.75 * attainable(tolerance, size), |element| match element {
        PathEl::MoveTo(point) => contours.push(vec![vertex(point)]),
        PathEl::LineTo(point) => {
            if let Some(contour) = contours.last_mut().filter(|contour| contour.last() != Some(&vertex(point))) {
                contour.push(vertex(point));
            }
        }
        // Flattened paths have no curves.
        PathEl::QuadTo(..) | PathEl::CurveTo(..) | PathEl::ClosePath => {}
    });
    contours.iter_mut().for_each(|contour| close(contour, tolerance));
    contours.retain(|contour| contour.len() > 1);
    contours
}

fn vertex(point: Point) -> Complex64 {
    Complex64::new(point.x, -point.y)
}

/// Takes away a last vertex that is the first, or that misses it by what rounded relative commands leave: no more than the
/// tolerance, and little beside the edges around it.
fn close(contour: &mut Vec<Complex64>, tolerance: f64) {
    while let [first, second, .., before, last] = contour[..] {
        let residue = (last - first).norm();
        if residue > tolerance.min(0.25 * (second - first).norm()).min(0.25 * (last - before).norm()) {
            break;
        }
        contour.pop();
    }
    if contour.len() > 1 && contour.first() == contour.last() {
        contour.pop();
    }
}

fn invalid(reason: impl Into<String>) -> Error {
    Error::InvalidOutline { reason: reason.into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Polygon;

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
}
