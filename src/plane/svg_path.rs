//! The data of an SVG path ↔ curves, in the path's own coordinates.

use kurbo::{Arc, BezPath, Point, SvgArc, Vec2};
use std::fmt::Write;
use svgtypes::{PathParser, PathSegment};

/// Path data, the attribute `d`, → lines and Béziers; elliptical arcs become cubics that leave them by `tolerance` at most.
///
/// # Errors
/// The whole text is read: what cannot be is named, with its place.
pub fn read(data: &str, tolerance: f64) -> Result<BezPath, String> {
    let mut pen = Pen { path: BezPath::new(), at: Point::ORIGIN, start: None, cubic: None, quadratic: None, tolerance };
    for segment in PathParser::from(data) {
        pen.draw(segment.map_err(|error| explain(data, &error))?);
    }
    if pen.path.is_finite() { Ok(pen.path) } else { Err("a number is too large".into()) }
}

/// A polyline → path data, to hundredths.
#[must_use]
pub fn polyline(points: impl IntoIterator<Item = (f64, f64)>, closed: bool) -> String {
    let mut data = String::new();
    for (k, (x, y)) in points.into_iter().enumerate() {
        // A String takes whatever is written.
        let _ = write!(data, "{}{x:.2} {y:.2}", if k == 0 { 'M' } else { 'L' });
    }
    if closed {
        data.push('Z');
    }
    data
}

/// What the pen remembers between segments.
struct Pen {
    path: BezPath,
    at: Point,
    /// Where a closed subpath began, as long as nothing follows it: what follows would begin there.
    start: Option<Point>,
    /// The last control point, if the last segment was a cubic, or a quadratic: smooth ones mirror it.
    cubic: Option<Point>,
    quadratic: Option<Point>,
    tolerance: f64,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let origin = if segment.is_abs() { Vec2::ZERO } else { self.at.to_vec2() };
        let place = |x: f64, y: f64| Point::new(x, y) + origin;
        let (cubic, quadratic) = (self.cubic.take(), self.quadratic.take());
        let is_move = matches!(segment, PathSegment::MoveTo { .. } | PathSegment::ClosePath { .. });
        if let (Some(start), false) = (self.start, is_move) {
            self.path.move_to(start);
            self.start = None;
        }
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.start = None;
                self.at = place(x, y);
                self.path.move_to(self.at);
            }
            PathSegment::LineTo { x, y, .. } => self.line_to(place(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => self.line_to(Point::new(x + origin.x, self.at.y)),
            PathSegment::VerticalLineTo { y, .. } => self.line_to(Point::new(self.at.x, y + origin.y)),
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.cubic_to(place(x1, y1), place(x2, y2), place(x, y));
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                self.cubic_to(self.mirrored(cubic), place(x2, y2), place(x, y));
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => self.quadratic_to(place(x1, y1), place(x, y)),
            PathSegment::SmoothQuadratic { x, y, .. } => self.quadratic_to(self.mirrored(quadratic), place(x, y)),
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                let (from, to, x_rotation) = (self.at, place(x, y), x_axis_rotation.to_radians());
                self.arc_to(&SvgArc { from, to, radii: Vec2::new(rx, ry), x_rotation, large_arc, sweep });
            }
            PathSegment::ClosePath { .. } => self.close(),
        }
    }

    fn line_to(&mut self, to: Point) {
        self.path.line_to(to);
        self.at = to;
    }

    fn cubic_to(&mut self, first: Point, second: Point, to: Point) {
        self.path.curve_to(first, second, to);
        (self.at, self.cubic) = (to, Some(second));
    }

    fn quadratic_to(&mut self, control: Point, to: Point) {
        self.path.quad_to(control, to);
        (self.at, self.quadratic) = (to, Some(control));
    }

    fn arc_to(&mut self, arc: &SvgArc) {
        match Arc::from_svg_arc(arc) {
            Some(curve) => {
                let mut pieces = Vec::new();
                let tolerance = attainable(self.tolerance, curve.radii.hypot());
                curve.to_cubic_beziers(tolerance, |first, second, to| pieces.push([first, second, to]));
                // The end that was written, not the one that sines and cosines give.
                if let Some(last) = pieces.last_mut() {
                    last[2] = arc.to;
                }
                pieces.into_iter().for_each(|[first, second, to]| self.path.curve_to(first, second, to));
                self.at = arc.to;
            }
            None => self.line_to(arc.to),
        }
    }

    /// A second `Z` closes nothing.
    fn close(&mut self) {
        if self.start.is_none() {
            let start = self.path.elements().iter().rev().find_map(|element| match element {
                kurbo::PathEl::MoveTo(start) => Some(*start),
                _ => None,
            });
            self.path.close_path();
            self.at = start.unwrap_or(self.at);
            self.start = Some(self.at);
        }
    }

    /// The control point that continues the last curve smoothly.
    fn mirrored(&self, control: Option<Point>) -> Point {
        control.map_or(self.at, |control| self.at + (self.at - control))
    }
}

/// Says which character cannot be read, and where it stands, counted from 1.
fn explain(data: &str, error: &svgtypes::Error) -> String {
    use svgtypes::Error as Fault;
    let place = match *error {
        Fault::UnexpectedData(place)
        | Fault::InvalidChar(_, place)
        | Fault::InvalidString(_, place)
        | Fault::InvalidNumber(place) => place,
        _ => return "the path ends in the middle of a command".into(),
    };
    // Blanks and commas before a number belong to what could not be read.
    let rest = data.chars().enumerate().skip(place - 1).find(|(_, c)| !" \t\r\n".contains(*c));
    match rest {
        Some((_, c)) if place == 1 => format!("a path begins with M or m, and this begins with “{c}”"),
        Some((index, c)) => format!("the path cannot be read from “{c}” (character {}) on", index + 1),
        None => "the path ends in the middle of a command".into(),
    }
}

/// The tolerance, or what the digits of something so large tell apart: to ask for less would only ask for memory.
pub fn attainable(tolerance: f64, size: f64) -> f64 {
    tolerance.max(1e-9 * size)
}
