//! Chains of curved edges cut into short monotone pieces: what crosses what, what is inside, and what is nearest.

use super::polygon::Polygon;
use super::{BoundaryPoint, Complex64, Edge, EdgeTree};
use crate::{Error, Result};

/// A closed chain of edges in pieces that run monotonically in x and in y and hardly turn; a polygon joins their ends.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct EdgePieces {
    pieces: Vec<Piece>,
    /// Through the ends of the pieces, counter-clockwise.
    polygon: Polygon,
    /// Over the pieces: being monotone, they lie in the boxes of their ends.
    tree: EdgeTree,
}

/// Part of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    edge: usize,
    /// The edge's parameters at its ends.
    span: [f64; 2],
    curve: Edge,
    /// It stays as near as this to its chord.
    sagitta: f64,
}

/// No piece leaves its chord by more than this share of the chain's size: a hundredth of a pixel on a picture of 4096.
const LOOKS_LIKE: f64 = 2e-6;
/// Nor does it turn by more than this from its chord, in radians.
const TURN: f64 = 0.35;
/// Pieces as near to their chords as this share of the size are no longer told from them.
const FLAT: f64 = 1e-12;
/// How often a piece is halved at most.
const DEEPEST: usize = 40;
/// Chains that need more pieces than this to be kept apart run along themselves.
const MOST_PIECES: usize = 100_000;
/// Steps of a bracketed Newton's method, which doubles its digits, or at the worst gains one bit a step.
const STEPS: usize = 80;

impl EdgePieces {
    /// Cuts a closed chain of edges of the given size, in either orientation; tells whether it runs clockwise, in which case the
    /// pieces are those of the chain turned around.
    ///
    /// # Errors
    /// [`Error::SelfIntersecting`], its edges counted as given, and [`Error::InvalidOutline`] for edges too short to be told
    /// from a point.
    pub fn new(edges: &[Edge], size: f64) -> Result<(Self, bool)> {
        let pieces = separate(edges, size)?;
        if area(&pieces) >= 0.0 {
            return Ok((Self::of(edges, pieces)?, false));
        }
        // Cut anew, so that the same chain is cut the same way whichever way around it was given.
        let turned: Vec<Edge> = edges.iter().rev().map(Edge::reversed).collect();
        let named = |error| match error {
            Error::SelfIntersecting { first, second, at } => {
                let last = edges.len() - 1;
                Error::SelfIntersecting { first: last - second, second: last - first, at }
            }
            other => other,
        };
        let pieces = separate(&turned, size).and_then(|pieces| Self::of(&turned, pieces)).map_err(named)?;
        Ok((pieces, true))
    }

    /// The pieces of a chain that runs counter-clockwise.
    fn of(edges: &[Edge], pieces: Vec<Piece>) -> Result<Self> {
        let vertices: Vec<Complex64> = pieces.iter().map(|piece| piece.curve.from()).collect();
        let polygon = Polygon::new(&vertices).map_err(|error| match error {
            Error::SelfIntersecting { first, second, at } => {
                Error::SelfIntersecting { first: pieces[first].edge, second: pieces[second].edge, at }
            }
            other => other,
        })?;
        if polygon.vertices() != vertices {
            let length = |k: &usize| (edges[*k].to() - edges[*k].from()).norm();
            let edge = (0..edges.len()).min_by(|a, b| length(a).total_cmp(&length(b))).unwrap_or(0);
            let reason = format!("it has an edge, like edge {edge}, too short to be told from a point");
            return Err(Error::InvalidOutline { reason });
        }
        let tree = EdgeTree::new(&vertices);
        Ok(Self { pieces, polygon, tree })
    }

    /// The same pieces, `by` plane units away.
    pub fn moved(&self, by: Complex64) -> Self {
        let polygon = self.polygon.moved(by);
        let tree = EdgeTree::new(polygon.vertices());
        let moved = |piece: &Piece| Piece { curve: piece.curve.moved(by), ..*piece };
        Self { pieces: self.pieces.iter().map(moved).collect(), polygon, tree }
    }

    /// The polygon that looks like the chain.
    pub fn polygon(&self) -> &Polygon {
        &self.polygon
    }

    /// Whether `z` lies inside, by the crossing number with the curves themselves; undecided on them up to rounding.
    pub fn contains(&self, z: Complex64) -> bool {
        if !z.is_finite() {
            return false;
        }
        let mut inside = false;
        self.tree.for_each_on_ray(z, |k| {
            let (a, b) = self.polygon.edge(k);
            if (a.im <= z.im) != (b.im <= z.im) && self.pieces[k].crosses_right_of(z, a, b) {
                inside = !inside;
            }
        });
        inside
    }

    /// The point of the chain nearest to `z`, and its distance.
    pub fn nearest(&self, z: Complex64) -> (BoundaryPoint, f64) {
        let start = BoundaryPoint { edge: 0, t: 0.0, point: self.pieces[0].curve.from() };
        self.nearest_within(z, f64::INFINITY).unwrap_or((start, f64::INFINITY))
    }

    /// The same, if it is no farther than `most`.
    pub fn nearest_within(&self, z: Complex64, most: f64) -> Option<(BoundaryPoint, f64)> {
        // Also what is exactly as far.
        let most = most.next_up();
        let mut best = (most, 0, 0.0);
        self.tree.nearest(z, most * most, |k| {
            let piece = &self.pieces[k];
            let (a, b) = self.polygon.edge(k);
            let reach = (best.0 + piece.sagitta) * (1.0 + 1e-12);
            if distance_to_segment(z, a, b) > reach {
                return f64::INFINITY;
            }
            let s = piece.foot(z);
            let distance = (piece.curve.point(s) - z).norm();
            if distance < best.0 {
                best = (distance, k, s);
            }
            distance * distance
        });
        let (distance, k, s) = best;
        if distance >= most {
            return None;
        }
        let piece = &self.pieces[k];
        let point = piece.curve.point(s);
        let t = piece.span[0] + (piece.span[1] - piece.span[0]) * s;
        if t < 1.0 {
            return Some((BoundaryPoint { edge: piece.edge, t, point }, distance));
        }
        let edges = self.pieces[self.pieces.len() - 1].edge + 1;
        Some((BoundaryPoint { edge: (piece.edge + 1) % edges, t: 0.0, point }, distance))
    }
}

impl Piece {
    #[inline(never)]
    fn new(edge: usize, span: [f64; 2], curve: Edge) -> Self {
        let (a, b) = (curve.from(), curve.to());
        let sagitta = match curve {
            Edge::Line { .. } => 0.0,
            Edge::Arc(arc) => {
                // An affine image of a circle's arc, whose sagitta lies along the middle radius.
                let radius = curve.bend(0.5.into()).norm() / arc.sweep().powi(2);
                2.0 * radius * (0.25 * arc.sweep()).sin().powi(2)
            }
            // The weights of the inner control points add up to 2t(1 − t) and 3t(1 − t).
            Edge::Quadratic([_, c, _]) => 0.5 * distance_to_segment(c, a, b),
            Edge::Cubic([_, c, d, _]) => 0.75 * distance_to_segment(c, a, b).max(distance_to_segment(d, a, b)),
        };
        Self { edge, span, curve, sagitta }
    }

    fn chord(&self) -> Complex64 {
        self.curve.to() - self.curve.from()
    }

    /// The larger angle between the chord and the curve's directions at its ends, in radians.
    #[inline(never)]
    fn turn(&self) -> f64 {
        let chord = self.chord();
        [self.curve.start_direction(), self.curve.end_direction()]
            .map(|direction| (direction * chord.conj()).arg().abs())
            .into_iter()
            .fold(0.0, f64::max)
    }

    fn halves(&self) -> [Self; 2] {
        let [first, second] = self.curve.split(0.5);
        let middle = 0.5 * (self.span[0] + self.span[1]);
        [Self::new(self.edge, [self.span[0], middle], first), Self::new(self.edge, [middle, self.span[1]], second)]
    }

    /// Whether the piece, whose ends a and b are above and below `z`, passes it on the right.
    fn crosses_right_of(&self, z: Complex64, a: Complex64, b: Complex64) -> bool {
        if z.re < a.re.min(b.re) {
            return true;
        }
        if z.re > a.re.max(b.re) {
            return false;
        }
        let up = if b.im > a.im { 1.0 } else { -1.0 };
        let s = root(&|s| up * (self.curve.point(s).im - z.im), &|s| up * self.curve.tangent(s.into()).im);
        self.curve.point(s).re > z.re
    }

    /// The piece's own parameter where it is nearest to `z`.
    #[inline(never)]
    fn foot(&self, z: Complex64) -> f64 {
        let curve = &self.curve;
        let behind = |at: Complex64, direction: Complex64| ((at - z) * direction.conj()).re;
        if behind(curve.from(), curve.start_direction()) >= 0.0 {
            return 0.0;
        }
        if behind(curve.to(), curve.end_direction()) <= 0.0 {
            return 1.0;
        }
        root(&|s| behind(curve.point(s), curve.tangent(s.into())), &|s| {
            let s = Complex64::from(s);
            curve.tangent(s).norm_sqr() + behind(curve.point(s.re), curve.bend(s))
        })
    }
}

/// The root in [0, 1] of a function that rises from below 0 to above, by Newton's method within a bracket.
fn root(value: &dyn Fn(f64) -> f64, slope: &dyn Fn(f64) -> f64) -> f64 {
    let (mut low, mut high, mut s) = (0.0, 1.0, 0.5);
    for _ in 0..STEPS {
        let found = value(s);
        if found == 0.0 {
            break;
        }
        if found < 0.0 {
            low = s
        } else {
            high = s
        }
        let newton = s - found / slope(s);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - s).abs() <= 0.5 * f64::EPSILON * next || next <= low || next >= high {
            return next;
        }
        s = next;
    }
    s
}

/// A chain's pieces, cut so finely that those which do not meet are apart.
fn separate(edges: &[Edge], size: f64) -> Result<Vec<Piece>> {
    let mut pieces = Vec::new();
    for (k, edge) in edges.iter().enumerate() {
        cut(k, edge, LOOKS_LIKE * size, &mut pieces);
    }
    keep_apart(&mut pieces, FLAT * size)?;
    Ok(pieces)
}

/// The points of an edge, its start left out, whose chords it leaves by `tolerance` at most.
#[inline(never)]
pub(super) fn flatten(edge: &Edge, tolerance: f64) -> Vec<Complex64> {
    let whole = Piece::new(0, [0.0, 1.0], *edge);
    if let (Edge::Arc(arc), true) = (edge, whole.sagitta > tolerance) {
        // A circle's arcs of angle φ leave their chords by r (1 − cos φ/2) ≤ r φ²/8; the longer axis counts.
        let radius = arc.drawn().radii.0;
        let steps = (arc.sweep().abs() * (radius / (8.0 * tolerance)).sqrt()).ceil().max(2.0) as u32;
        return (1..=steps).map(|k| edge.point(f64::from(k) / f64::from(steps))).collect();
    }
    let mut points = Vec::new();
    let mut open = vec![(whole, DEEPEST)];
    while let Some((piece, depth)) = open.pop() {
        if depth > 0 && piece.sagitta > tolerance {
            let [first, second] = piece.halves();
            open.extend([(second, depth - 1), (first, depth - 1)]);
        } else {
            points.push(piece.curve.to());
        }
    }
    points
}

/// Appends the pieces of an edge that leave their chords by `tolerance` at most.
fn cut(k: usize, edge: &Edge, tolerance: f64, pieces: &mut Vec<Piece>) {
    if let Edge::Line { .. } = edge {
        pieces.push(Piece::new(k, [0.0, 1.0], *edge));
        return;
    }
    // At least two, so that a line and a curve between the same points are a polygon.
    let mut cuts: Vec<f64> = edge.turning_points();
    cuts.push(0.5);
    cuts.retain(|t| *t > 1e-9 && *t < 1.0 - 1e-9);
    super::sort_by_number(&mut cuts, |t| *t);
    cuts.dedup_by(|a, b| *a - *b < 1e-9);
    cuts.push(1.0);
    let (mut rest, mut from) = (*edge, 0.0);
    for to in cuts {
        let [part, after] = if to < 1.0 { rest.split((to - from) / (1.0 - from)) } else { [rest, rest] };
        halve(Piece::new(k, [from, to], part), tolerance, DEEPEST, pieces);
        (rest, from) = (after, to);
    }
}

#[inline(never)]
fn halve(piece: Piece, tolerance: f64, depth: usize, pieces: &mut Vec<Piece>) {
    let is_long = piece.chord().norm() > tolerance;
    if depth > 0 && (piece.sagitta > tolerance || (is_long && piece.turn() > TURN)) {
        piece.halves().into_iter().for_each(|half| halve(half, tolerance, depth - 1, pieces));
    } else {
        pieces.push(piece);
    }
}

/// Halves pieces until no two that do not meet could by their distance; what is flat is left to the polygon of chords.
fn keep_apart(pieces: &mut Vec<Piece>, flat: f64) -> Result<()> {
    loop {
        let count = pieces.len();
        let vertices: Vec<Complex64> = pieces.iter().map(|piece| piece.curve.from()).collect();
        let tree = EdgeTree::new(&vertices);
        let mut close = vec![false; count];
        let mut pair = None;
        for first in 0..count {
            tree.for_each_near(vertices[first], vertices[(first + 1) % count], |second| {
                let halved = [first, second].map(|k| pieces[k].sagitta > flat);
                if second > first && (halved[0] || halved[1]) && may_meet(pieces, first, second) {
                    close[first] |= halved[0];
                    close[second] |= halved[1];
                    pair = Some((first, second));
                }
            });
        }
        let Some((first, second)) = pair else { return Ok(()) };
        if count > MOST_PIECES {
            let at = pieces[first].curve.from();
            return Err(Error::SelfIntersecting { first: pieces[first].edge, second: pieces[second].edge, at });
        }
        let mut halved = Vec::with_capacity(count + 16);
        for (piece, close) in pieces.iter().zip(close) {
            if close { halved.extend(piece.halves()) } else { halved.push(*piece) }
        }
        *pieces = halved;
    }
}

/// Whether two pieces could share more than the point between them, for all that their chords and sagittas tell.
#[inline(never)]
fn may_meet(pieces: &[Piece], first: usize, second: usize) -> bool {
    let (a, b) = (&pieces[first], &pieces[second]);
    let is_before = first + 1 == second;
    if is_before || (second + 1) % pieces.len() == first {
        // Pieces of one edge go on smoothly; at corners each stays in a sector around its chord.
        let (before, after) = if is_before { (a, b) } else { (b, a) };
        let opening = (after.chord() * -before.chord().conj()).arg().abs();
        return a.edge != b.edge && opening <= 2.0 * (a.turn() + b.turn());
    }
    let [[p, q], [r, s]] = [a, b].map(|piece| [piece.curve.from(), piece.curve.to()]);
    let apart = |p: f64, q: f64, r: f64, s: f64| p.max(q) < r.min(s) || r.max(s) < p.min(q);
    if apart(p.re, q.re, r.re, s.re) || apart(p.im, q.im, r.im, s.im) {
        return false;
    }
    let cross = |a: Complex64, b: Complex64| (a.conj() * b).im;
    let divides =
        |p: Complex64, q: Complex64, r: Complex64, s: Complex64| cross(q - p, r - p) * cross(q - p, s - p) <= 0.0;
    let distance = if divides(p, q, r, s) && divides(r, s, p, q) {
        0.0
    } else {
        let ends = [(p, r, s), (q, r, s), (r, p, q), (s, p, q)];
        ends.into_iter().map(|(z, a, b)| distance_to_segment(z, a, b)).fold(f64::INFINITY, f64::min)
    };
    distance <= a.sagitta + b.sagitta
}

/// How far a point is from the straight way between two others, which may be one.
#[inline(never)]
pub(crate) fn distance_to_segment(z: Complex64, a: Complex64, b: Complex64) -> f64 {
    let t = (((z - a) * (b - a).conj()).re / (b - a).norm_sqr()).clamp(0.0, 1.0);
    (z - a - (b - a) * if t.is_nan() { 0.0 } else { t }).norm()
}

/// Twice the area within the chords, positive if counter-clockwise.
fn area(pieces: &[Piece]) -> f64 {
    let origin = pieces[0].curve.from();
    pieces.iter().map(|piece| ((piece.curve.from() - origin).conj() * (piece.curve.to() - origin)).im).sum()
}
