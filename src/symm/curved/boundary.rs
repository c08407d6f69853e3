//! A boundary of analytic edges cut into panels: each runs from a corner over the parameter of its edge.

use super::super::panel::{Panel, halved, halved_where};
use super::super::problem::Target;
use crate::plane::{Complex64, CurvedOutline, Edge, Polygon};
use std::ops::Range;

/// Half an edge, seen from the corner where it starts.
#[derive(Clone, Copy, Debug)]
pub struct Arm {
    /// The edge's curve, run from the corner: parameter 0 there, 0.5 at the end of the arm.
    pub curve: Edge,
    /// The vertex.
    pub corner: usize,
    /// The edge.
    pub edge: usize,
    /// Whether the boundary runs away from the corner here.
    pub outgoing: bool,
    /// The exponent of the corner variable.
    pub exponent: f64,
    /// θ − θ(corner) begins with this power of the parameter.
    pub power: f64,
    /// Whether the parameter stands still at the corner, z going like its square.
    pub slow: bool,
}

/// The scaled boundary, the region to the left. Arm 2k is the first half of edge k, arm 2k + 1 the second.
#[derive(Clone, Debug)]
pub struct CurvedBoundary {
    /// Where edges start, × `unit`.
    pub vertices: Vec<Complex64>,
    /// Two for each edge.
    pub arms: Vec<Arm>,
    /// Power of two: plane units × `unit` = units used here.
    pub unit: f64,
    /// Its components.
    pub loops: Vec<Loop>,
    /// Whether the first of them is around the region.
    pub bounded: bool,
}

/// A closed chain of edges.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its edges, and where they start.
    pub edges: Range<usize>,
    /// Whether it is around a hole: its edges are those of the outline backwards.
    is_hole: bool,
    /// Whether the outline is one closed edge, whose halves are two here: no arm ends where it starts.
    halves: bool,
    /// Its chords, to see what is behind a panel; none if they cross.
    chords: Option<Polygon>,
}

impl Loop {
    /// Number of edges of the outline.
    fn outline_edges(&self) -> usize {
        if self.halves { 1 } else { self.edges.len() }
    }
}

/// |z''/z'| times half a panel's parameter range is at most this: its curve is nearly straight, and no other point of the edge's
/// continuation meets a target near it.
pub const TAME: f64 = 0.5;
/// Neighbours are at most so many times as long.
const BALANCE: f64 = 2.5;
/// Panels shorter than this may be nearer to another component than they are long, until residuals say otherwise.
const LEAST_CROWDED: f64 = 1e-3;
/// Chords of an edge.
const CHORDS: usize = 16;
/// Singular powers of the corner variable that are not whole are at least this for each digit of the map (measured: more crowds the nodes,
/// less converges slowly).
const POWER_PER_DIGIT: f64 = 0.5;
/// Digits that the quadrature has more than the map.
pub const ROUND_DIGITS: f64 = 3.0;
/// The least and the most that serves.
const POWERS: [f64; 2] = [2.0, 6.0];

impl CurvedBoundary {
    /// Scales an outline to size about 1, for quadrature of so many digits.
    #[must_use]
    pub fn new(outline: &CurvedOutline, digits: f64) -> Self {
        Self::of(&[outline], true, digits)
    }

    /// The same of several outlines, `bounded` telling whether the first is around the region and not around a hole.
    #[must_use]
    pub fn of(outlines: &[&CurvedOutline], bounded: bool, digits: f64) -> Self {
        let smooth_power = (POWER_PER_DIGIT * (digits - ROUND_DIGITS)).clamp(POWERS[0], POWERS[1]);
        let size = if bounded { outlines[0].size() } else { size_of(outlines) };
        let unit = (-size.log2().round()).exp2();
        let mut boundary = Self { vertices: Vec::new(), arms: Vec::new(), unit, loops: Vec::new(), bounded };
        for (k, outline) in outlines.iter().enumerate() {
            boundary.add(outline, !bounded || k > 0, smooth_power);
        }
        boundary
    }

    #[inline(never)]
    fn add(&mut self, outline: &CurvedOutline, is_hole: bool, smooth_power: f64) {
        let mut edges: Vec<Edge> = outline.edges().iter().map(|edge| edge.scaled(self.unit.into())).collect();
        let mut alpha: Vec<f64> = (0..edges.len()).map(|corner| outline.alpha(corner)).collect();
        if is_hole {
            edges = edges.iter().rev().map(Edge::reversed).collect();
            alpha[1..].reverse();
            alpha.iter_mut().for_each(|alpha| *alpha = 2.0 - *alpha);
        }
        let halves = edges.len() == 1;
        if halves {
            edges = edges[0].split(0.5).to_vec();
            alpha.push(1.0);
        }
        let (n, start) = (edges.len(), self.vertices.len());
        self.vertices.extend(edges.iter().map(Edge::from));
        let is_straight = |k: usize| matches!(edges[k], Edge::Line { .. });
        for (k, edge) in edges.iter().enumerate() {
            for (corner, outgoing) in [(k, true), ((k + 1) % n, false)] {
                let curve = if outgoing { *edge } else { edge.reversed() };
                let slow = curve.starts_slowly();
                let straight = is_straight(corner) && is_straight((corner + n - 1) % n);
                // There the parameter is about the square root of the distance.
                let alpha = if slow { 0.5 * alpha[corner] } else { alpha[corner] };
                let exponent = exponent(alpha, straight, smooth_power);
                let (corner, edge) = (start + corner, start + k);
                self.arms.push(Arm { curve, corner, edge, outgoing, exponent, power: alpha.recip(), slow });
            }
        }
        let chord = |edge: &Edge| {
            let edge = *edge;
            (0..CHORDS).map(move |j| edge.point(j as f64 / CHORDS as f64))
        };
        let chords = Polygon::new(&edges.iter().flat_map(chord).collect::<Vec<_>>()).ok();
        // A polygon is counter-clockwise unless it is told otherwise.
        let chords = if is_hole { chords.map(|chords| chords.clockwise()) } else { chords };
        self.loops.push(Loop { edges: start..start + n, is_hole, halves, chords });
    }

    /// The loop that an edge belongs to.
    #[must_use]
    #[inline(never)]
    pub fn loop_of(&self, edge: usize) -> usize {
        self.loops.partition_point(|own| own.edges.end <= edge)
    }

    /// Edge and parameter of the outline of a component → of the edges here.
    #[must_use]
    pub fn inner(&self, component: usize, edge: usize, t: f64) -> (usize, f64) {
        let own = &self.loops[component];
        let (edge, t) = if own.is_hole { (own.outline_edges() - 1 - edge, 1.0 - t) } else { (edge, t) };
        let (edge, t) = match (own.halves, t < 0.5) {
            (false, _) => (edge, t),
            (true, true) => (0, 2.0 * t),
            (true, false) => (1, 2.0 * t - 1.0),
        };
        (own.edges.start + edge, t)
    }

    /// The inverse of [`CurvedBoundary::inner`] for an outer boundary.
    #[must_use]
    pub fn outer(&self, edge: usize, t: f64) -> (usize, f64) {
        if self.loops[0].halves { (0, 0.5 * (t + edge as f64)) } else { (edge, t) }
    }

    /// Number of edges of the first outline.
    #[must_use]
    pub fn outline_edges(&self) -> usize {
        self.loops[0].outline_edges()
    }

    /// An edge that stands still so long where it starts or ends that no square root tells its parameter.
    #[must_use]
    pub fn halted(&self) -> Option<usize> {
        let stands =
            |arm: &&Arm| arm.slow && arm.curve.bend(Complex64::ZERO).norm() <= arm.curve.bend(1.0.into()).norm() * 1e-9;
        let arm = self.arms.iter().find(stands)?;
        Some(if self.loops[self.loop_of(arm.edge)].halves { 0 } else { arm.edge })
    }

    /// Whether a panel lies where the parameter stands still.
    #[must_use]
    pub fn is_slow(&self, panel: &Panel) -> bool {
        panel.start == 0.0 && self.arm(panel).slow
    }

    /// The arm that a panel lies on.
    #[must_use]
    pub fn arm(&self, panel: &Panel) -> &Arm {
        &self.arms[Self::arm_of(panel)]
    }

    /// Its index.
    #[must_use]
    pub fn arm_of(panel: &Panel) -> usize {
        2 * panel.edge + usize::from(!panel.outgoing)
    }

    /// A point of the panel `from`, given as a parameter of `panel`'s arm if it lies on the same edge, and as a step from the
    /// arm's corner.
    #[must_use]
    pub fn seen_from(&self, panel: &Panel, from: &Panel, target: &Target) -> (Option<f64>, Complex64) {
        if Self::arm_of(from) == Self::arm_of(panel) {
            return (Some(target.s), target.offset);
        }
        if from.edge == panel.edge {
            let s = 1.0 - target.s;
            return (Some(s), self.arm(panel).curve.from_start(s.into()));
        }
        (None, self.vertices[from.corner] - self.vertices[panel.corner] + target.offset)
    }

    /// Length of a panel, by its chord.
    #[must_use]
    pub fn length(&self, panel: &Panel) -> f64 {
        let curve = &self.arm(panel).curve;
        (curve.chord(panel.start.into(), panel.end.into()) * panel.length()).norm()
    }

    /// Largest |z''/z'| on a panel times half its parameter range: how far it is from straight.
    #[must_use]
    pub fn bend(&self, panel: &Panel) -> f64 {
        let curve = &self.arm(panel).curve;
        let at = |share: f64| {
            let s = Complex64::from(panel.start + share * panel.length());
            curve.bend(s).norm() / curve.tangent(s).norm()
        };
        let first = if self.is_slow(panel) { 2 } else { 0 };
        0.5 * panel.length() * [0.0, 0.25, 0.5, 0.75, 1.0][first..].iter().map(|share| at(*share)).fold(0.0, f64::max)
    }

    /// Distance of a point (scaled units) from a panel, by samples.
    fn distance(&self, panel: &Panel, z: Complex64) -> f64 {
        self.samples(panel).map(|sample| (z - sample).norm()).into_iter().fold(f64::INFINITY, f64::min)
    }

    #[inline(never)]
    fn samples(&self, panel: &Panel) -> [Complex64; 5] {
        let arm = self.arm(panel);
        let at = |share: f64| {
            let s = panel.start + share * panel.length();
            self.vertices[arm.corner] + arm.curve.from_start(s.into())
        };
        [0.0, 0.25, 0.5, 0.75, 1.0].map(at)
    }

    /// Distance from the middle of a panel to the boundary behind it, outside the region, if that is at most `reach`.
    #[must_use]
    pub fn behind(&self, panel: &Panel, reach: f64) -> Option<(usize, f64)> {
        let arm = self.arm(panel);
        let s = Complex64::from(0.5 * (panel.start + panel.end));
        let middle = self.vertices[arm.corner] + arm.curve.from_start(s);
        let tangent = arm.curve.tangent(s);
        let along = if panel.outgoing { tangent } else { -tangent } / tangent.norm();
        // Only its own component comes back there.
        let own = &self.loops[self.loop_of(panel.edge)];
        let (chord, distance) = own.chords.as_ref()?.facing(middle, -Complex64::i() * along, reach)?;
        let edge = own.edges.start + chord / CHORDS;
        (edge != panel.edge).then_some((edge, distance))
    }

    /// The piece of an arm between two parameters.
    #[must_use]
    pub fn panel(&self, arm: &Arm, start: f64, end: f64) -> Panel {
        let exponent = if start == 0.0 { arm.exponent } else { 1.0 };
        // The rules ask for no direction.
        let direction = Complex64::ONE;
        Panel { edge: arm.edge, corner: arm.corner, direction, outgoing: arm.outgoing, start, end, exponent }
    }

    /// The first panels in boundary order: tame, balanced, and no longer than their distance from what is singular in the region.
    #[must_use]
    pub fn initial_panels(&self, singular: &[Complex64]) -> Vec<Panel> {
        let panels = self.arms.iter().map(|arm| self.panel(arm, 0.0, 0.5)).collect();
        let wild = |panel: &Panel| !self.is_slow(panel) && self.bend(panel) > TAME || self.is_crowded(panel);
        let panels = halved_where(panels, &wild);
        match singular {
            [] => self.balanced(panels),
            centers => centers.iter().fold(panels, |panels, center| self.facing(panels, *center)),
        }
    }

    /// Whether a panel is long beside its distance from another component.
    fn is_crowded(&self, panel: &Panel) -> bool {
        let (own, length) = (self.loop_of(panel.edge), self.length(panel));
        let others = self.loops.iter().enumerate().filter(|(k, _)| *k != own);
        let mut chords = others.filter_map(|(_, other)| other.chords.as_ref());
        let is_near =
            |chords: &Polygon| self.samples(panel).iter().any(|z| chords.nearest_within(*z, length).is_some());
        length > LEAST_CROWDED && chords.any(is_near)
    }

    /// Halves panels until none is longer than its distance from the center, or much longer than its neighbour.
    #[must_use]
    #[inline(never)]
    pub fn facing(&self, panels: Vec<Panel>, center: Complex64) -> Vec<Panel> {
        self.balanced(halved_where(panels, &|panel| self.length(panel) > self.distance(panel, center)))
    }

    /// Halves panels until none is much longer than its neighbour.
    #[must_use]
    #[inline(never)]
    pub fn balanced(&self, mut panels: Vec<Panel>) -> Vec<Panel> {
        loop {
            let lengths: Vec<f64> = panels.iter().map(|panel| self.length(panel)).collect();
            let mut marked = vec![false; panels.len()];
            for own in self.components(&panels) {
                let (n, first) = (own.len(), own.start);
                let length = |q: usize| lengths[first + q % n];
                for q in 0..n {
                    let is_long = length(q) > BALANCE * length(q + 1).min(length(q + n - 1));
                    marked[first + q] = is_long && panels[first + q].can_be_halved();
                }
            }
            if !marked.contains(&true) {
                return panels;
            }
            panels = halved(&panels, &marked);
        }
    }

    /// Of panels in boundary order, those of each component.
    #[must_use]
    #[inline(never)]
    pub fn components(&self, panels: &[Panel]) -> Vec<Range<usize>> {
        let first = |edge: usize| panels.partition_point(|panel| panel.edge < edge);
        self.loops.iter().map(|own| first(own.edges.start)..first(own.edges.end)).collect()
    }
}

/// The larger side of the box around all.
fn size_of(outlines: &[&CurvedOutline]) -> f64 {
    let corners = outlines.iter().map(|outline| outline.bounds());
    let least = |a: Complex64, b: Complex64| Complex64::new(a.re.min(b.re), a.im.min(b.im));
    let around = corners.reduce(|(low, high), (l, h)| (least(low, l), -least(-high, -h)));
    around.map_or(1.0, |(low, high)| (high.re - low.re).max(high.im - low.im))
}

/// The exponent a of the corner variable s = τ^a at an interior angle απ.
///
/// Between straight edges θ is analytic in s^(1/α). Between curved ones it has the powers k/α + l as well, and logarithms where
/// these meet (R. S. Lehman, Pacific J. Math. 7, 1957): a = nα makes the first kind whole, and n so large that the others
/// start at τ^n(1+α), which polynomials follow closely.
fn exponent(alpha: f64, straight: bool, smooth_power: f64) -> f64 {
    if straight {
        let a = if alpha > 1.0 { alpha } else { alpha * (1.0 / alpha + 1e-9).floor() };
        return if (a - 1.0).abs() < 1e-9 { 1.0 } else { a };
    }
    // In a spike nodes are not crowded towards its mouth.
    alpha * (smooth_power / (1.0 + alpha) - 1e-9).ceil().max((1.0 / alpha + 1e-9).floor())
}
