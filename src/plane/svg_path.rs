//! The data of an SVG path ↔ edges, in the path's own coordinates: angles count from x to y.

use super::Complex64;
use super::edge::Edge;
use super::elliptic_arc::ArcTo;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use svgtypes::{PathParser, PathSegment};

/// A subpath: edges that each start where the last one ends. It need not be closed.
pub type Chain = Vec<Edge>;

/// Path data, the attribute `d`, → its subpaths, exactly; those without a segment, which draw nothing, are left out.
///
/// # Errors
/// The whole text is read: what cannot be is named, with its place.
pub fn read(data: &str) -> Result<Vec<Chain>, String> {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        pen.draw(segment.map_err(|error| explain(data, &error))?);
    }
    let mut chains = pen.chains;
    chains.retain(|chain| !chain.is_empty());
    if chains.iter().flatten().all(Edge::is_finite) { Ok(chains) } else { Err("a number is too large".into()) }
}

/// A closed chain → path data that [`read`] reads as the same edges, up to the rounding of arcs.
#[must_use]
pub fn write(chain: &[Edge]) -> String {
    let mut data = String::new();
    if let Some(first) = chain.first() {
        put(&mut data, 'M', &[first.from()]);
    }
    chain.iter().for_each(|edge| put_edge(&mut data, edge));
    data.push('Z');
    data
}

fn put_edge(data: &mut String, edge: &Edge) {
    match edge {
        Edge::Line { to, .. } => put(data, 'L', &[*to]),
        // Around half of an ellipse its center would be told badly, and a whole one not at all.
        Edge::Arc(arc) if arc.sweep().abs() > 0.75 * PI => edge.split(0.5).iter().for_each(|half| put_edge(data, half)),
        Edge::Arc(arc) => {
            let ArcTo { radii, rotation, large, counterclockwise } = arc.drawn();
            let (large, sweep) = (u8::from(large), u8::from(counterclockwise));
            // A String takes whatever is written.
            let _ = write!(data, "A{} {} {} {large} {sweep} ", radii.0, radii.1, rotation.to_degrees());
            put_points(data, &[edge.to()]);
        }
        Edge::Quadratic(points) => put(data, 'Q', &points[1..]),
        Edge::Cubic(points) => put(data, 'C', &points[1..]),
    }
}

fn put(data: &mut String, command: char, points: &[Complex64]) {
    data.push(command);
    put_points(data, points);
}

fn put_points(data: &mut String, points: &[Complex64]) {
    for (k, z) in points.iter().enumerate() {
        let _ = write!(data, "{}{} {}", if k == 0 { "" } else { " " }, z.re, z.im);
    }
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
#[derive(Default)]
struct Pen {
    chains: Vec<Chain>,
    at: Complex64,
    /// Where the subpath began.
    start: Complex64,
    /// Whether the subpath was closed: what follows begins another one there.
    closed: bool,
    /// The last control point, if the last segment was a cubic, or a quadratic: smooth ones mirror it.
    cubic: Option<Complex64>,
    quadratic: Option<Complex64>,
}

impl Pen {
    fn draw(&mut self, segment: PathSegment) {
        let origin = if segment.is_abs() { Complex64::ZERO } else { self.at };
        let place = |x: f64, y: f64| Complex64::new(x, y) + origin;
        let (cubic, quadratic) = (self.cubic.take(), self.quadratic.take());
        let at = self.at;
        match segment {
            PathSegment::MoveTo { x, y, .. } => self.begin(place(x, y)),
            PathSegment::LineTo { x, y, .. } => self.line_to(place(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => self.line_to(Complex64::new(x + origin.re, at.im)),
            PathSegment::VerticalLineTo { y, .. } => self.line_to(Complex64::new(at.re, y + origin.im)),
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.cubic_to(place(x1, y1), place(x2, y2), place(x, y));
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                self.cubic_to(mirrored(at, cubic), place(x2, y2), place(x, y));
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => self.quadratic_to(place(x1, y1), place(x, y)),
            PathSegment::SmoothQuadratic { x, y, .. } => self.quadratic_to(mirrored(at, quadratic), place(x, y)),
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                // Whole turns would cost the angle its digits.
                let rotation = (x_axis_rotation % 360.0).to_radians() % TAU;
                let arc = ArcTo { radii: (rx, ry), rotation, large: large_arc, counterclockwise: sweep };
                let to = place(x, y);
                // An arc to where it starts is none, as SVG has it.
                if to != at {
                    self.add(Edge::arc_to(at, to, arc));
                }
            }
            PathSegment::ClosePath { .. } => self.close(),
        }
    }

    fn begin(&mut self, at: Complex64) {
        self.chains.push(Chain::new());
        (self.at, self.start, self.closed) = (at, at, false);
    }

    fn add(&mut self, edge: Edge) {
        if self.closed {
            self.begin(self.start);
        }
        self.at = edge.to();
        if let Some(chain) = self.chains.last_mut() {
            chain.push(edge);
        }
    }

    fn line_to(&mut self, to: Complex64) {
        self.add(Edge::line(self.at, to));
    }

    fn cubic_to(&mut self, first: Complex64, second: Complex64, to: Complex64) {
        self.add(Edge::Cubic([self.at, first, second, to]));
        self.cubic = Some(second);
    }

    fn quadratic_to(&mut self, control: Complex64, to: Complex64) {
        self.add(Edge::Quadratic([self.at, control, to]));
        self.quadratic = Some(control);
    }

    /// A second `Z` closes nothing.
    fn close(&mut self) {
        (self.at, self.closed) = (self.start, true);
    }
}

/// The control point that continues the last curve smoothly.
fn mirrored(at: Complex64, control: Option<Complex64>) -> Complex64 {
    control.map_or(at, |control| at + (at - control))
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
