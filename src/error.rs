//! The one error type: each case carries its values, and its `Display` is a sentence that tells a visitor what to do.

use num_complex::Complex64;

/// Everything that can go wrong with a caller's input, or with a computation that noticed it failed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Fewer than three distinct boundary points.
    #[error("A region needs at least 3 distinct boundary points; this one has {found}.")]
    TooFewVertices {
        /// Distinct points found.
        found: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("{what} is not a finite point.")]
    NotFinite {
        /// Which point it is: "Boundary point 3", "The center", …
        what: String,
    },
    /// Two edges of the boundary cross or touch.
    #[error("The boundary crosses or touches itself: edge {first} meets edge {second} near {}.", place(.at))]
    SelfIntersecting {
        /// Index of the first edge (edge k runs from vertex k to vertex k + 1).
        first: usize,
        /// Index of the second edge.
        second: usize,
        /// A point near the meeting place.
        at: Complex64,
    },
    /// Text that is no outline.
    #[error(
        "The outline cannot be read: {reason}. Give points as JSON, [[x, y], …], the data of one SVG path, or an SVG file that draws one curve."
    )]
    InvalidOutline {
        /// What is wrong with it.
        reason: String,
    },
    /// The boundary turns back on itself at a point: an interior angle of 2π, or of 0 between edges that never part.
    #[error("The boundary has a cusp near {}, where edge {edge} starts: it turns back there around what is outside.", place(.at))]
    Cusp {
        /// Index of the edge that starts there.
        edge: usize,
        /// The tip.
        at: Complex64,
    },
    /// The center is not strictly inside the region.
    #[error("The center {} must lie inside the region.", place(.center))]
    CenterOutside {
        /// The center given.
        center: Complex64,
    },
    /// A point that must lie inside the region does not.
    #[error("{what} {index} (counted from 0), at {}, must lie inside the region, off its boundary.", place(.at))]
    PointOutside {
        /// What lies there.
        what: &'static str,
        /// Which of them, counted from 0.
        index: usize,
        /// The point given.
        at: Complex64,
    },
    /// The curve around a hole cannot be one.
    #[error("Hole {hole} (counted from 0): {error}")]
    InHole {
        /// The hole, counted from 0.
        hole: usize,
        /// What is wrong with it, points and edges being those of the hole.
        error: Box<Error>,
    },
    /// Two parts of a boundary cross or touch.
    #[error("{} crosses or touches {} near {}; move them apart.", capital(&part(*.first)), part(*.second), place(.at))]
    HolesMeet {
        /// The hole that meets another part of the boundary, counted from 0.
        first: Option<usize>,
        /// The hole that it meets; none for the outer boundary.
        second: Option<usize>,
        /// A point near the meeting place.
        at: Complex64,
    },
    /// A hole that does not lie where a hole can be.
    #[error("Hole {hole} (counted from 0) lies {}; a hole must lie inside the boundary, and outside the other holes.",
        inside.map_or_else(|| "outside the boundary".to_string(), |other| format!("inside hole {other}")))]
    HoleOutside {
        /// The hole, counted from 0.
        hole: usize,
        /// The hole that it lies in; none if it lies outside the outer boundary.
        inside: Option<usize>,
    },
    /// A region of another kind than the map is for.
    #[error("{what} needs {needed}; this region has {found}.")]
    WrongRegion {
        /// The map.
        what: &'static str,
        /// The regions it is for.
        needed: &'static str,
        /// What was given.
        found: String,
    },
    /// A frame whose width or pixel counts are not usable.
    #[error("A frame needs a finite center, a positive finite width and at least 1x1 pixels: {reason}.")]
    InvalidFrame {
        /// What is wrong with it.
        reason: &'static str,
    },
    /// A numeric option outside its range.
    #[error("{name} must be {expected}; it is {}.", number(*value))]
    InvalidOption {
        /// The option's name, in snake case; at the edge to JavaScript it becomes camel case.
        name: &'static str,
        /// What would be accepted.
        expected: &'static str,
        /// What was given.
        value: f64,
    },
    /// An array whose length does not fit its meaning.
    #[error("{what} must have {expected} numbers; it has {found}.")]
    WrongLength {
        /// The array's name.
        what: &'static str,
        /// The length, or rule for it, that would be accepted.
        expected: String,
        /// The length given.
        found: usize,
    },
    /// A picture whose pyramid would not fit into memory.
    #[error("A picture of {width} x {height} pixels is too large; 8192 x 8192 is the most to rely on.")]
    TextureTooLarge {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// More memory at once than there is.
    #[error(
        "This needs {bytes} bytes of memory at once, more than can be had: ask for fewer pixels, rows or points at a time."
    )]
    OutOfMemory {
        /// How many bytes were wanted.
        bytes: u64,
    },
    /// A texture that a prepared warp is not good for.
    #[error(
        "This warp was prepared for textures of {} x {} pixels with one wrap mode; this one has {} x {}, or another mode.",
        .expected[0], .expected[1], .found[0], .found[1]
    )]
    OtherTexture {
        /// Columns and rows that it was prepared for.
        expected: [usize; 2],
        /// Columns and rows given.
        found: [usize; 2],
    },
    /// Rows that the view does not have.
    #[error("The rows {start} to {end} are not rows of a view with {height}.")]
    InvalidRows {
        /// First row asked for.
        start: usize,
        /// The row after the last.
        end: usize,
        /// The view's rows.
        height: usize,
    },
    /// A triangle that names a node which does not exist.
    #[error("Triangle {triangle} names node {node}, but there are only {nodes} nodes.")]
    InvalidTriangle {
        /// Index of the triangle.
        triangle: usize,
        /// The node it names.
        node: u32,
        /// Number of nodes.
        nodes: usize,
    },
    /// Parts of a mesh that numbers can no longer tell apart.
    #[error("The maps crowd the mesh near {} together beyond double precision; move the center closer, or simplify the outline there.", place(.at))]
    Crowded {
        /// A point near the place, in the copy that is crowded.
        at: Complex64,
    },
    /// Far ends of two regions of which nobody can tell whether they belong together.
    #[error("These regions are too far apart: what lies near {} belongs to a far end of the other region, in a direction that double precision cannot tell. Move the centers, or in both regions `toward`, into the parts that should come together.", place(.at))]
    TooFarApart {
        /// A point of the region that the map was asked about.
        at: Complex64,
    },
    /// A joint triangulation that is not one.
    #[error("The mesh is not valid: {reason}.")]
    InvalidMesh {
        /// The first thing found wrong.
        reason: String,
    },
    /// Harmonic measure came out negative somewhere: the region could not be resolved in double precision.
    #[error(
        "No trustworthy map of this region was found: on edge {edge} (counted from 0) a part of the boundary got the harmonic measure {mass:.2e}, where only rounding below {estimate:.1e} would be acceptable. Widen what is narrow there, move the center away from it, or allow more unknowns."
    )]
    NegativeMass {
        /// The smallest mass of a panel.
        mass: f64,
        /// The error estimate that it exceeds.
        estimate: f64,
        /// The edge on which it lies: from this vertex of the region to the next.
        edge: usize,
    },
    /// A map so far off that it is none.
    #[error(
        "No trustworthy map of this region was found: the estimate of its error is {estimate:.1e}, the disk having radius 1. Allow more unknowns, or move the center away from the boundary."
    )]
    Inaccurate {
        /// The error estimate.
        estimate: f64,
    },
    /// A smooth curve that its points leave open.
    #[error(
        "{given} points do not determine the smooth curve; about {needed} would, closer together where it bends. If the outline has corners, take it as a polygon."
    )]
    TooFewPoints {
        /// Points given.
        given: usize,
        /// Points that would do, about, spread as these are.
        needed: usize,
    },
    /// A formula that does not follow the grammar.
    #[error("The formula cannot be read at position {position}: expected {expected}, found {found}.")]
    Syntax {
        /// Where, in UTF-16 units from the start of the text: JavaScript's `text[position]`.
        position: usize,
        /// What could have stood there.
        expected: String,
        /// What stands there.
        found: String,
    },
    /// A formula that is longer, deeper or more work than is allowed.
    #[error("The formula is too large: at most {limit} {what} are allowed.")]
    FormulaTooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How much of it is allowed.
        limit: usize,
    },
    /// A parameter's name that a formula cannot use.
    #[error("“{name}” cannot name a parameter: {reason}.")]
    InvalidParameter {
        /// The name given.
        name: String,
        /// Why it cannot.
        reason: &'static str,
    },
    /// A parameter that the formula was not made with.
    #[error("The formula has no parameter “{name}”; it has {known}.")]
    UnknownParameter {
        /// The name given.
        name: String,
        /// The names that exist, for reading.
        known: String,
    },
    /// Numbers that do not make a map of the kind asked for.
    #[error("{what} is not possible: {reason}.")]
    InvalidMap {
        /// The map asked for.
        what: &'static str,
        /// Why the numbers do not make one.
        reason: &'static str,
    },
    /// Two canonical regions of one kind but different shape.
    #[error(
        "{what} of different modulus cannot be joined conformally: theirs are {first:.10} and {second:.10}. Make them equal, or let one be stretched onto the other, which is not conformal."
    )]
    DifferentModuli {
        /// What is to be joined.
        what: &'static str,
        /// The modulus of the first: the ratio of a ring's radii, or of a rectangle's sides.
        first: f64,
        /// That of the second.
        second: f64,
    },
    /// Bytes that hold something else than the map asked for.
    #[error("These bytes do not hold {expected} that was stored; they hold {found}.")]
    NotStored {
        /// The map asked for.
        expected: &'static str,
        /// What it is instead.
        found: &'static str,
    },
    /// A map stored in a form that this version does not know.
    #[error(
        "This map was stored in format {found}, and this version reads format {known}: read it with the version that stored it, or make the map anew."
    )]
    OtherFormat {
        /// The bytes' format.
        found: u16,
        /// The format that can be read.
        known: u16,
    },
    /// A stored map that is not whole.
    #[error("The stored map is damaged: {reason}. Make the map anew.")]
    Damaged {
        /// What shows it.
        reason: &'static str,
    },
    /// The caller's progress function asked to stop.
    #[error("The computation was cancelled.")]
    Cancelled,
}

impl Error {
    /// A stable, machine-readable name of the case: what JavaScript sees as `error.code`.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooFewVertices { .. } => "too-few-vertices",
            Self::NotFinite { .. } => "not-finite",
            Self::SelfIntersecting { .. } => "self-intersecting",
            Self::InvalidOutline { .. } => "invalid-outline",
            Self::Cusp { .. } => "cusp",
            Self::CenterOutside { .. } => "center-outside",
            Self::PointOutside { .. } => "point-outside",
            Self::InHole { error, .. } => error.code(),
            Self::HolesMeet { .. } => "holes-meet",
            Self::HoleOutside { .. } => "hole-outside",
            Self::WrongRegion { .. } => "wrong-region",
            Self::InvalidFrame { .. } => "invalid-frame",
            Self::InvalidOption { .. } => "invalid-option",
            Self::WrongLength { .. } => "wrong-length",
            Self::TextureTooLarge { .. } => "texture-too-large",
            Self::OutOfMemory { .. } => "out-of-memory",
            Self::OtherTexture { .. } => "other-texture",
            Self::InvalidRows { .. } => "invalid-rows",
            Self::InvalidTriangle { .. } => "invalid-triangle",
            Self::Crowded { .. } => "crowded",
            Self::TooFarApart { .. } => "too-far-apart",
            Self::InvalidMesh { .. } => "invalid-mesh",
            Self::NegativeMass { .. } => "negative-mass",
            Self::Inaccurate { .. } => "inaccurate",
            Self::TooFewPoints { .. } => "too-few-points",
            Self::Syntax { .. } => "syntax",
            Self::FormulaTooLarge { .. } => "formula-too-large",
            Self::InvalidParameter { .. } => "invalid-parameter",
            Self::UnknownParameter { .. } => "unknown-parameter",
            Self::InvalidMap { .. } => "invalid-map",
            Self::DifferentModuli { .. } => "different-moduli",
            Self::NotStored { .. } => "not-stored",
            Self::OtherFormat { .. } => "other-format",
            Self::Damaged { .. } => "damaged",
            Self::Cancelled => "cancelled",
        }
    }
}

/// A part of a boundary for reading.
fn part(hole: Option<usize>) -> String {
    hole.map_or_else(|| "the outer boundary".to_string(), |hole| format!("hole {hole} (counted from 0)"))
}

fn capital(text: &str) -> String {
    let (first, rest) = text.split_at(text.len().min(1));
    first.to_ascii_uppercase() + rest
}

/// A number for reading: no rows of zeros. Its digits are written as whole numbers, which takes little of a module.
fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || value.is_nan() || (1e-4..1e16).contains(&size) {
        return format!("{value}");
    }
    let sign = if value < 0.0 { "-" } else { "" };
    if size.is_infinite() {
        return format!("{sign}infinity");
    }
    let exponent = size.log10().floor() as i32;
    let thousandths = (size / 10f64.powi(exponent) * 1000.0).round() as u32;
    format!("{sign}{}.{:03}e{exponent}", thousandths / 1000, thousandths % 1000)
}

/// A point for reading, to seven digits of its larger coordinate.
fn place(z: &Complex64) -> String {
    let size = z.re.abs().max(z.im.abs());
    if size == 0.0 || !size.is_finite() {
        return format!("({}, {})", z.re, z.im);
    }
    let exponent = size.log10().floor() as i32;
    if (-3..7).contains(&exponent) {
        let digits = (6 - exponent) as usize;
        return format!("({:.digits$}, {:.digits$})", z.re, z.im);
    }
    format!("({:.6e}, {:.6e})", z.re, z.im)
}

/// Results of this crate.
pub type Result<T> = std::result::Result<T, Error>;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.0, -1.5, 1e-300, -2f64.powi(80)].map(number), ["0", "-1.5", "1.000e-300", "-1.209e24"]);
        assert_eq!([f64::NEG_INFINITY, f64::NAN].map(number), ["-infinity", "NaN"]);
    }

    #[test]
    fn places_can_be_told_apart_at_every_scale() {
        let place = |re, im| place(&Complex64::new(re, im));
        assert_eq!(place(10.0, -0.5), "(10.00000, -0.50000)");
        assert_eq!(place(1e-9, 2.5e-9), "(1.000000e-9, 2.500000e-9)");
        assert_eq!(place(0.0, 0.0), "(0, 0)");
    }
}
