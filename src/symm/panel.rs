//! The boundary cut into panels, with the corner singularity put into the variable of each.

use crate::plane::{Complex64, Polygon};
use std::ops::Range;

/// The polygons around a region, scaled to size about 1, with what panels need to know of their corners. The region lies to the
/// left of each: an outer one, if there is one, comes first and counter-clockwise, holes are clockwise.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// Vertices × `unit`: only scaled, never moved, so that differences of vertices stay exact.
    pub vertices: Vec<Complex64>,
    /// Unit vector along each edge.
    pub directions: Vec<Complex64>,
    /// Length of each edge.
    pub lengths: Vec<f64>,
    /// Interior angle at each vertex, divided by π: in (0, 2).
    pub alpha: Vec<f64>,
    /// Distance from each vertex to the rest of the boundary, or to the nearer neighbour.
    pub clearances: Vec<f64>,
    /// Power of two: plane units × `unit` = units used here.
    pub unit: f64,
    /// The vertices of each component.
    pub loops: Vec<Range<usize>>,
    /// Whether the first component is around the region.
    pub bounded: bool,
    next: Vec<usize>,
    previous: Vec<usize>,
    polygons: Vec<Polygon>,
}

impl Boundary {
    /// Measures a polygon around a region.
    #[must_use]
    pub fn new(polygon: &Polygon) -> Self {
        Self::of(vec![polygon.clone()], true)
    }

    /// Measures all components, `bounded` telling whether the first is around the region.
    #[must_use]
    pub fn of(polygons: Vec<Polygon>, bounded: bool) -> Self {
        let unit = (-size_of(&polygons).log2().round()).exp2();
        let vertices: Vec<Complex64> = polygons.iter().flat_map(|p| p.vertices()).map(|v| v * unit).collect();
        let n = vertices.len();
        let mut loops: Vec<Range<usize>> = Vec::with_capacity(polygons.len());
        for polygon in &polygons {
            let start = loops.last().map_or(0, |range| range.end);
            loops.push(start..start + polygon.len());
        }
        let round = |step: fn(usize, usize) -> usize| {
            loops.iter().flat_map(move |r| r.clone().map(move |k| r.start + step(k - r.start, r.len()))).collect()
        };
        let next: Vec<usize> = round(|k, count| (k + 1) % count);
        let previous: Vec<usize> = round(|k, count| (k + count - 1) % count);
        let edges: Vec<Complex64> = (0..n).map(|k| vertices[next[k]] - vertices[k]).collect();
        let lengths: Vec<f64> = edges.iter().map(|e| e.norm()).collect();
        let directions: Vec<Complex64> = edges.iter().zip(&lengths).map(|(e, length)| e / length).collect();
        let turn = |k: usize| (directions[k] * directions[previous[k]].conj()).arg();
        let alpha = (0..n).map(|k| 1.0 - turn(k) / std::f64::consts::PI).collect();
        let clearances = loops.iter().enumerate().flat_map(|(own, range)| {
            let polygons = &polygons;
            range.clone().map(move |k| clearance(polygons, own, k - range.start) * unit)
        });
        let clearances = clearances.collect();
        Self { vertices, directions, lengths, alpha, clearances, unit, loops, bounded, next, previous, polygons }
    }

    /// Number of vertices.
    #[must_use]
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// The vertex after `k`.
    #[must_use]
    pub fn next(&self, k: usize) -> usize {
        self.next[k]
    }

    /// The vertex before `k`; also the edge that ends at vertex `k`.
    #[must_use]
    pub fn previous(&self, k: usize) -> usize {
        self.previous[k]
    }

    /// The component that a vertex or edge belongs to.
    #[must_use]
    pub fn loop_of(&self, k: usize) -> usize {
        self.loops.partition_point(|range| range.end <= k)
    }

    /// arg(v − z) for all vertices v, continuous along each component from its first vertex, where it is principal.
    #[must_use]
    pub fn arguments(&self, z: Complex64) -> Vec<f64> {
        let mut arguments: Vec<f64> = Vec::with_capacity(self.len());
        for k in 0..self.len() {
            let before = self.previous[k];
            let here = self.vertices[k] - z;
            let argument = if before + 1 == k {
                arguments[before] + (here * (self.vertices[before] - z).conj()).arg()
            } else {
                here.arg()
            };
            arguments.push(argument);
        }
        arguments
    }

    /// The edge behind the middle of a panel, outside the region, and its distance, if that is at most `reach`.
    #[must_use]
    pub fn behind(&self, panel: &Panel, reach: f64) -> Option<(usize, f64)> {
        let middle = self.vertices[panel.corner] + panel.direction * (0.5 * (panel.start + panel.end));
        let along = if panel.outgoing { panel.direction } else { -panel.direction };
        // Only its own component comes back there.
        let own = self.loop_of(panel.edge);
        let facing = self.polygons[own].facing(middle / self.unit, -Complex64::i() * along, reach / self.unit);
        let (edge, distance) = facing?;
        Some((self.loops[own].start + edge, distance * self.unit))
    }

    /// The exponent a of the corner variable τ = s^(1/a) at vertex `k`.
    ///
    /// θ is analytic in s^(1/α); for α < 1 also in s^(1/(mα)) for whole m, and the largest mα ≤ 1 keeps spikes harmless.
    #[must_use]
    pub fn exponent(&self, k: usize) -> f64 {
        let alpha = self.alpha[k];
        let a = if alpha > 1.0 { alpha } else { alpha * (1.0 / alpha + 1e-9).floor() };
        if (a - 1.0).abs() < 1e-9 { 1.0 } else { a }
    }
}

/// The larger side of the box around all.
fn size_of(polygons: &[Polygon]) -> f64 {
    let (mut low, mut high) = polygons[0].bounds();
    for polygon in &polygons[1..] {
        let (l, h) = polygon.bounds();
        low = Complex64::new(low.re.min(l.re), low.im.min(l.im));
        high = Complex64::new(high.re.max(h.re), high.im.max(h.im));
    }
    (high.re - low.re).max(high.im - low.im)
}

/// [`Polygon::clearance`] of a vertex of polygon `own`, or its distance from another polygon if that is less.
fn clearance(polygons: &[Polygon], own: usize, vertex: usize) -> f64 {
    let z = polygons[own].vertices()[vertex];
    let mut least = polygons[own].clearance(vertex);
    for (_, other) in polygons.iter().enumerate().filter(|(k, _)| *k != own) {
        if let Some(near) = other.nearest_within(z, least) {
            least = (near.point - z).norm();
        }
    }
    least
}

/// A piece of an edge, s ∈ [start, end] from `corner` in `direction`, on which the density is a polynomial in τ ∈ [0, 1]:
/// s = start + (end − start)·τ^exponent, the exponent being 1 unless the panel touches its corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel {
    /// The edge it lies on.
    pub edge: usize,
    /// The vertex from which s is measured: the nearer end of the edge.
    pub corner: usize,
    /// Unit vector from `corner` along the edge.
    pub direction: Complex64,
    /// Whether the boundary runs away from `corner` here (else towards it).
    pub outgoing: bool,
    /// Distance of its near end from `corner`.
    pub start: f64,
    /// Distance of its far end from `corner`.
    pub end: f64,
    /// The exponent a of the corner variable.
    pub exponent: f64,
}

impl Panel {
    /// Length.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.end - self.start
    }

    /// Distance from the corner at τ.
    #[must_use]
    pub fn distance_at(&self, tau: f64) -> f64 {
        self.start + self.length() * if self.exponent == 1.0 { tau } else { tau.powf(self.exponent) }
    }

    /// τ at distance `s` from the corner.
    #[must_use]
    pub fn tau_at(&self, s: f64) -> f64 {
        let share = ((s - self.start) / self.length()).clamp(0.0, 1.0);
        if self.exponent == 1.0 { share } else { share.powf(1.0 / self.exponent) }
    }

    /// dτ/ds at distance `s` from the corner; infinite at it where τ is a fractional power.
    #[must_use]
    pub fn slope_at(&self, s: f64) -> f64 {
        if self.exponent == 1.0 { 1.0 / self.length() } else { self.tau_at(s) / (self.exponent * (s - self.start)) }
    }

    /// Distance from the point `z` (scaled units).
    #[must_use]
    pub fn distance(&self, boundary: &Boundary, z: Complex64) -> f64 {
        let local = (z - boundary.vertices[self.corner]) * self.direction.conj();
        (local - local.re.clamp(self.start, self.end)).norm()
    }

    /// Whether it is a part of `whole`.
    #[must_use]
    pub fn is_within(&self, whole: &Self) -> bool {
        self.edge == whole.edge && self.outgoing == whole.outgoing && self.start >= whole.start && self.end <= whole.end
    }

    /// Whether doubles can tell places on its halves apart.
    #[must_use]
    pub fn can_be_halved(&self) -> bool {
        self.length() > SHORTEST * self.end
    }

    /// Its two halves, in boundary order; only the one at the corner keeps the corner variable.
    #[must_use]
    pub fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.start + self.end);
        let near = Self { end: middle, ..*self };
        let far = Self { start: middle, exponent: 1.0, ..*self };
        if self.outgoing { [near, far] } else { [far, near] }
    }
}

/// The panels in halves that are no longer than `share` of their distance from `center` (scaled units), as far as they can be
/// halved; in the same order.
#[must_use]
pub fn halved_towards(center: Complex64, share: f64, boundary: &Boundary, panels: Vec<Panel>) -> Vec<Panel> {
    halved_where(panels, &|panel| panel.length() > share * panel.distance(boundary, center))
}

/// Halves panels, and their halves, as far as `wild` says so and they can be halved; in the same order.
#[must_use]
pub fn halved_where(panels: Vec<Panel>, wild: &dyn Fn(&Panel) -> bool) -> Vec<Panel> {
    let mut done = Vec::with_capacity(panels.len());
    let mut open: Vec<Panel> = panels.into_iter().rev().collect();
    while let Some(panel) = open.pop() {
        if panel.can_be_halved() && wild(&panel) {
            let [first, second] = panel.halves();
            open.extend([second, first]);
        } else {
            done.push(panel);
        }
    }
    done
}

/// Halves the marked panels; in the same order.
#[must_use]
pub fn halved(panels: &[Panel], marked: &[bool]) -> Vec<Panel> {
    let halves = |(panel, split): (&Panel, &bool)| if *split { panel.halves().to_vec() } else { vec![*panel] };
    panels.iter().zip(marked).flat_map(halves).collect()
}

/// Shortest panel, measured in its distance from the corner.
const SHORTEST: f64 = 1e-13;

/// The first panels, in boundary order from vertex 0: at every corner one of `kappa` × its clearance, then panels that double in
/// length up to mid-edge.
#[must_use]
pub fn initial_panels(boundary: &Boundary, kappa: f64) -> Vec<Panel> {
    let n = boundary.len();
    let mut panels = Vec::new();
    for edge in 0..n {
        let (from, to) = (edge, boundary.next(edge));
        let direction = boundary.directions[edge];
        let middle = 0.5 * boundary.lengths[edge];
        let half = |corner: usize, direction: Complex64, outgoing: bool| {
            let first = Panel {
                edge,
                corner,
                direction,
                outgoing,
                start: 0.0,
                end: (kappa * boundary.clearances[corner]).min(middle),
                exponent: boundary.exponent(corner),
            };
            doubling_panels(first, middle)
        };
        panels.extend(half(from, direction, true));
        panels.extend(half(to, -direction, false).into_iter().rev());
    }
    panels
}

/// `first` and regular panels behind it, each at most as long as its distance from the corner, up to `middle`.
fn doubling_panels(first: Panel, middle: f64) -> Vec<Panel> {
    let mut panels = vec![first];
    let mut start = first.end;
    while middle - start > 1e-12 * middle {
        let end = if 2.5 * start >= middle { middle } else { 2.0 * start };
        panels.push(Panel { start, end, exponent: 1.0, ..first });
        start = end;
    }
    panels
}
