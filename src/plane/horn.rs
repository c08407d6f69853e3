//! Horns: corners of interior angle 0, where two edges part slowly. Their tips are cut off where nothing is told from them any more.

use super::{Complex64, Edge};
use crate::{Error, Result};
use std::f64::consts::PI;

/// Corners of angles nearer to 0 or 2π than this are horns, of the region or of what is outside, in radians.
const NARROW: f64 = 1e-6;
/// Of a horn as narrow as this share of the outline's size no inside is told.
const THINNEST: f64 = 1e-10;
/// From the center, e to the minus this is more than what is seen of a horn's tip that is cut off: less than rounding.
const UNSEEN: f64 = 42.0;
/// Distances from the tip at which a horn's width is asked for, to a doubling.
const PER_DOUBLING: f64 = 16.0;
/// Steps of a bisection.
const STEPS: usize = 100;

/// A corner with its two edges, both run from there.
#[derive(Clone, Debug, PartialEq)]
struct Horn {
    corner: usize,
    tip: Complex64,
    walls: [Edge; 2],
    /// The distance from the tip at which it is cut.
    cut: f64,
}

impl Horn {
    /// The corner where edge `k` starts, if it is one.
    fn at(edges: &[Edge], k: usize) -> Option<Self> {
        let (before, after) = (&edges[(k + edges.len() - 1) % edges.len()], &edges[k]);
        let turn = (after.start_direction() * before.end_direction().conj()).arg();
        let walls = [before.reversed(), *after];
        (turn.abs() > PI - NARROW).then(|| Self { corner: k, tip: after.from(), walls, cut: 0.0 })
    }

    /// Up to this distance from the tip both walls are looked at.
    fn reach(&self) -> f64 {
        let [a, b] = self.walls.map(|wall| wall.from_start(0.5.into()).norm());
        a.min(b)
    }

    /// Parameters of the walls at a distance from the tip.
    fn parameters(&self, distance: f64) -> [f64; 2] {
        self.walls.map(|wall| bisected(&|t| wall.from_start(t.into()).norm() < distance, 0.0, 0.5))
    }

    /// The points there, as steps from the tip.
    fn across(&self, distance: f64) -> [Complex64; 2] {
        let [s, t] = self.parameters(distance);
        [self.walls[0].from_start(s.into()), self.walls[1].from_start(t.into())]
    }

    fn width(&self, distance: f64) -> f64 {
        let [a, b] = self.across(distance);
        (a - b).norm()
    }

    /// The distance from the tip where it is so wide.
    fn as_wide_as(&self, width: f64) -> Option<f64> {
        let reach = self.reach();
        (self.width(reach) > width).then(|| bisected(&|distance| self.width(distance) < width, 0.0, reach))
    }

    /// The distance from the tip beyond which nothing is seen from `center`, or that of the cut, if that is larger.
    ///
    /// Of what lies deeper in a channel than r one sees at most about exp(−π ∫ ds/width(s)), from r to where one stands or the
    /// channel ends (Ahlfors).
    fn seen_from(&self, center: Complex64) -> f64 {
        let step = (-PER_DOUBLING.recip()).exp2();
        let mut distance = self.reach().min(0.5 * (center - self.tip).norm());
        let mut open = true;
        let mut depth = 0.0;
        while depth < UNSEEN && distance > self.cut {
            let width = self.width(distance * step.sqrt());
            // It begins where it is no wider than it is long.
            open &= width > distance;
            if !open {
                depth += PI * distance * (1.0 - step) / width;
            }
            distance *= step;
        }
        distance.max(self.cut)
    }
}

/// Where a condition that holds at `low` and not at `high` ends to hold.
fn bisected(holds: &dyn Fn(f64) -> bool, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if holds(middle) { low = middle } else { high = middle }
    }
    high
}

/// A chain of edges, and the same with a short line across each horn in place of the tip.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CutHorns {
    cut: Vec<Edge>,
    /// Of each edge of the cut chain: the edge that it is part of, with the parameters of its ends, or the corner that was cut off.
    sources: Vec<Source>,
    /// Of each edge of the whole chain: which one it is of the cut chain, and the parameters kept.
    kept: Vec<(usize, [f64; 2])>,
    horns: Vec<Horn>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Source {
    Part(usize, [f64; 2]),
    Cut(usize),
}

impl CutHorns {
    /// Cuts where horns are too thin to tell an inside from an outside; `None` if there are none.
    ///
    /// # Errors
    /// [`Error::Cusp`] where edges never part.
    pub fn thin(edges: &[Edge], size: f64) -> Result<Option<Self>> {
        let mut horns: Vec<Horn> = (0..edges.len()).filter_map(|k| Horn::at(edges, k)).collect();
        for horn in &mut horns {
            let never = Error::Cusp { edge: horn.corner, at: horn.tip };
            horn.cut = horn.as_wide_as(THINNEST * size).ok_or(never)?;
        }
        Ok((!horns.is_empty()).then(|| Self::new(edges, horns)))
    }

    /// Cuts the chain that was cut here where nothing is seen of the tips from `center`.
    pub fn unseen(&self, edges: &[Edge], center: Complex64) -> Self {
        let deeper = |horn: &Horn| Horn { cut: horn.seen_from(center), ..horn.clone() };
        Self::new(edges, self.horns.iter().map(deeper).collect())
    }

    fn new(whole: &[Edge], horns: Vec<Horn>) -> Self {
        let n = whole.len();
        let mut spans = vec![[0.0, 1.0]; n];
        for horn in &horns {
            let [before, after] = horn.parameters(horn.cut);
            spans[(horn.corner + n - 1) % n][1] = 1.0 - before;
            spans[horn.corner][0] = after;
        }
        let part = |k: usize| {
            let [start, end] = spans[k];
            whole[k].split(end)[0].split(start / end)[1]
        };
        let parts: Vec<Edge> = (0..n).map(part).collect();
        let (mut cut, mut sources, mut kept) = (Vec::new(), Vec::new(), Vec::new());
        for k in 0..n {
            if horns.iter().any(|horn| horn.corner == k) {
                cut.push(Edge::line(parts[(k + n - 1) % n].to(), parts[k].from()));
                sources.push(Source::Cut(k));
            }
            kept.push((cut.len(), spans[k]));
            cut.push(parts[k]);
            sources.push(Source::Part(k, spans[k]));
        }
        Self { cut, sources, kept, horns }
    }

    /// The chain without the tips.
    pub fn edges(&self) -> &[Edge] {
        &self.cut
    }

    /// An error whose edges are those of the cut chain, with those of the whole one.
    pub fn named(&self, error: Error) -> Error {
        let Error::SelfIntersecting { first, second, at } = error else { return error };
        let [first, second] = [first, second].map(|edge| self.outer(edge, 0.0).0);
        Error::SelfIntersecting { first: first.min(second), second: first.max(second), at }
    }

    /// Lines across horns, as edges of the cut chain, and the corners that they cut off.
    pub fn cuts(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let cut = |(edge, source): (usize, &Source)| if let Source::Cut(k) = source { Some((edge, *k)) } else { None };
        self.sources.iter().enumerate().filter_map(cut)
    }

    /// Edge and parameter of the cut chain → of the whole one; all of a cut is the tip.
    pub fn outer(&self, edge: usize, t: f64) -> (usize, f64) {
        match self.sources[edge] {
            Source::Part(k, [start, end]) => (k, start + (end - start) * t),
            Source::Cut(k) => (k, 0.0),
        }
    }

    /// Edge and parameter of the whole chain → of the cut one; what was cut off an edge is where its cut is.
    pub fn inner(&self, edge: usize, t: f64) -> (usize, f64) {
        let (k, [start, end]) = self.kept[edge];
        if t < start { (k - 1, 0.0) } else { (k, ((t - start) / (end - start)).min(1.0)) }
    }

    /// Where an edge of the whole chain starts: the edge of the cut one that starts there, or the cut.
    pub fn corner(&self, edge: usize) -> usize {
        self.inner(edge, 0.0).0
    }

    /// The cut that a point in a tip lies behind, given the point of the whole chain nearest to it.
    pub fn behind(&self, edge: usize, t: f64) -> Option<usize> {
        let n = self.kept.len();
        let (_, [start, end]) = self.kept[edge];
        let is_horn = |k: usize| self.horns.iter().any(|horn| horn.corner == k);
        let ends = [(edge, t - start), ((edge + 1) % n, end - t)];
        let nearer = ends.into_iter().filter(|(k, _)| is_horn(*k)).min_by(|a, b| a.1.total_cmp(&b.1));
        nearer.map(|(k, _)| self.corner(k))
    }

    /// The edge and parameter that a point in a tip is, up to rounding.
    pub fn in_tip(&self, z: Complex64, thickness: f64) -> Option<(usize, f64)> {
        self.horns.iter().find_map(|horn| {
            let step = z - horn.tip;
            let distance = step.norm();
            if distance > horn.cut + thickness {
                return None;
            }
            let [a, b] = horn.across(distance);
            let between = (step - a).norm() + (step - b).norm() <= (a - b).norm() + 2.0 * thickness;
            between.then(|| (horn.corner, horn.parameters(distance)[1]))
        })
    }

    /// The same chains, `by` plane units away.
    pub fn moved(&self, by: Complex64) -> Self {
        let moved = |horn: &Horn| Horn { tip: horn.tip + by, walls: horn.walls.map(|wall| wall.moved(by)), ..*horn };
        let horns = self.horns.iter().map(moved).collect();
        Self { cut: self.cut.iter().map(|edge| edge.moved(by)).collect(), horns, ..self.clone() }
    }
}
