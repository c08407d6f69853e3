//! Outlines that come as text: points in JSON, or the data of an SVG path.

use crate::plane::{Complex64, json_points};
use crate::{Error, Result};
use kurbo::{BezPath, PathEl, Point};

/// Text → the vertices of an outline, times `scale`.
///
/// - JSON, `[[x, y], …]`: the vertices, in the plane's own way, y up.
/// - What an SVG path has as `d`: one closed curve of any commands, y down and turned over. Curves become edges that leave
///   them by `tolerance` at most, in the outline's units (that is after scaling).
///
/// Whether it can bound a region is not asked: that is [`Region::new`](super::Region::new)'s.
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
/// [`Error::InvalidOutline`] for text that is neither; [`Error::InvalidOption`] unless scale and tolerance are positive and
/// finite.
pub fn parse_outline(text: &str, scale: f64, tolerance: f64) -> Result<Vec<Complex64>> {
    for (name, value) in [("scale", scale), ("tolerance", tolerance)] {
        if !value.is_finite() || value <= 0.0 {
            return Err(Error::InvalidOption { name, expected: "a positive number", value });
        }
    }
    let text = text.trim();
    let mut vertices = if text.starts_with(['[', '{']) {
        json_points::read(text).map_err(|reason| invalid(&reason))?
    } else {
        from_path(text, tolerance / scale)?
    };
    // A last vertex that repeats the first only closes what is closed.
    if vertices.len() > 1 && vertices.first() == vertices.last() {
        vertices.pop();
    }
    Ok(vertices.into_iter().map(|z| z * scale).collect())
}

fn from_path(data: &str, tolerance: f64) -> Result<Vec<Complex64>> {
    let path = BezPath::from_svg(data).map_err(|error| invalid(&error.to_string()))?;
    if !path.is_finite() {
        return Err(invalid("a number is too large"));
    }
    let (mut vertices, mut curves) = (Vec::new(), 0);
    let mut add = |point: Point| {
        let vertex = Complex64::new(point.x, -point.y);
        if vertices.last() != Some(&vertex) {
            vertices.push(vertex);
        }
    };
    kurbo::flatten(path, tolerance, |element| match element {
        PathEl::MoveTo(point) => {
            curves += 1;
            add(point);
        }
        PathEl::LineTo(point) => add(point),
        // Flattened paths have no curves.
        PathEl::QuadTo(..) | PathEl::CurveTo(..) | PathEl::ClosePath => {}
    });
    match curves {
        1 => Ok(vertices),
        0 => Err(invalid("there is no curve")),
        _ => Err(invalid(&format!("it has {curves} curves, and an outline is one"))),
    }
}

fn invalid(reason: &str) -> Error {
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
            ("hello", "path"),
            ("", "no curve"),
            ("M0 0h1v1z M5 5h1v1z", "2 curves"),
            ("M0 0 L 1e999 0 z", ""),
        ];
        for (text, reason) in refused {
            let error = parse_outline(text, 1.0, 0.1).unwrap_err();
            assert_eq!(error.code(), "invalid-outline", "{text}");
            println!("{error}");
            assert!(error.to_string().to_lowercase().contains(&reason.to_lowercase()), "{text}: {error}");
        }
        assert_eq!(parse_outline("M0 0h1v1z", 0.0, 0.1).unwrap_err().code(), "invalid-option");
        assert_eq!(parse_outline("M0 0h1v1z", 1.0, f64::NAN).unwrap_err().code(), "invalid-option");
    }
}
