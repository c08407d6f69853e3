//! A joint triangulation in the making: nodes are added in pairs, then connected anew.

use super::correspondence::Correspondence;
use super::joint::MeshEvidence;
use super::ring::{Ring, RingNode, Room};
use super::side::Outline;
use super::triangles::orientation;
use crate::Result;
use crate::plane::{BoundaryPoint, Complex64};
use rustc_hash::FxHashSet;

/// Inner nodes are farther from an outline than this share of its length.
const LEAST_DEPTH: f64 = 1e-13;

/// Nodes of both copies, the ring of those on the boundary, and the triangles over them.
pub(super) struct Draft<'a> {
    pub(super) map: &'a dyn Correspondence,
    pub(super) outlines: [Outline<'a>; 2],
    pub(super) source: Vec<Complex64>,
    pub(super) target: Vec<Complex64>,
    /// The boundary nodes, anticlockwise, each with its index.
    pub(super) ring: Vec<(u32, RingNode)>,
    /// Where on the ring a node is, for boundary nodes.
    pub(super) places: Vec<Option<RingNode>>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) evidence: MeshEvidence,
    pub(super) room: Room,
    /// Where inner nodes of the source are, as bits: two middles may fall together.
    taken: FxHashSet<[u64; 2]>,
}

impl<'a> Draft<'a> {
    /// The refined boundary.
    pub(super) fn new(map: &'a dyn Correspondence, spacing: f64, room: Room) -> Result<Self> {
        let ring = Ring::new(map, spacing, room)?;
        let evidence = MeshEvidence { moved: ring.moved, ..MeshEvidence::default() };
        Ok(Self {
            map,
            outlines: map.copies().map(Outline::new),
            source: ring.nodes.iter().map(|n| n.source.point).collect(),
            target: ring.nodes.iter().map(|n| n.target.point).collect(),
            places: ring.nodes.iter().copied().map(Some).collect(),
            ring: ring.nodes.into_iter().enumerate().map(|(k, node)| (k as u32, node)).collect(),
            triangles: Vec::new(),
            evidence,
            room,
            taken: FxHashSet::default(),
        })
    }

    /// Adds the points of a grid that keeps away from the outline, with their images: no need to look how near that is.
    pub(super) fn add_grid(&mut self, points: &[Complex64]) {
        for (&z, w) in points.iter().zip(self.map.forward(points)).filter(|(_, w)| w.is_finite()) {
            self.source.push(z);
            self.target.push(w);
        }
        self.places.resize(self.source.len(), None);
    }

    /// Adds inner points of the source with their images under `map`; returns how many had one.
    pub(super) fn add_inner(&mut self, points: &[Complex64], map: &dyn Correspondence) -> usize {
        let pairs: Vec<_> = points.iter().copied().zip(map.forward(points)).collect();
        self.add_pairs(&pairs)
    }

    /// Adds inner nodes (source, target); returns how many. Not those that a map had no value for, nor those so close
    /// to an outline that rounding decides on which side of its edges they are.
    pub(super) fn add_pairs(&mut self, pairs: &[(Complex64, Complex64)]) -> usize {
        let before = self.source.len();
        let [source, target] = &self.outlines;
        for &(z, w) in pairs {
            let inside =
                source.depth(z) > LEAST_DEPTH * source.length() && target.depth(w) > LEAST_DEPTH * target.length();
            if inside && self.taken.insert([z.re.to_bits(), z.im.to_bits()]) {
                self.source.push(z);
                self.target.push(w);
            }
        }
        self.places.resize(self.source.len(), None);
        self.source.len() - before
    }

    /// For each node, the next one along the outline, or `u32::MAX` for an inner node.
    pub(super) fn next_on_ring(&self) -> Vec<u32> {
        let mut next = vec![u32::MAX; self.source.len()];
        for k in 0..self.ring.len() {
            next[self.ring[k].0 as usize] = self.ring[(k + 1) % self.ring.len()].0;
        }
        next
    }

    /// Adds a boundary node in the middle of each boundary edge that starts at a node of `starts` (in rising order);
    /// returns how many edges could be split.
    pub(super) fn split_boundary(&mut self, starts: &[u32]) -> usize {
        let mut ring = Vec::with_capacity(self.ring.len() + starts.len());
        for k in 0..self.ring.len() {
            let (id, node) = self.ring[k];
            ring.push((id, node));
            if starts.binary_search(&id).is_err() {
                continue;
            }
            if let Some(middle) = self.between(node, self.ring[(k + 1) % self.ring.len()].1, 0.5) {
                ring.push((self.source.len() as u32, middle));
                self.source.push(middle.source.point);
                self.target.push(middle.target.point);
                self.places.push(Some(middle));
            }
        }
        let added = ring.len() - self.ring.len();
        self.ring = ring;
        added
    }

    /// The boundary node between two neighbours, `share` of the way measured where they are farther apart.
    pub(super) fn between(&self, p: RingNode, q: RingNode, share: f64) -> Option<RingNode> {
        let [source, target] = &self.outlines;
        let part_way = |outline: &Outline, a: BoundaryPoint, b: BoundaryPoint| {
            let (from, mut to) = (outline.distance(a), outline.distance(b));
            if to <= from {
                to = outline.length();
            }
            (outline.at_distance(from + share * (to - from)), from, to)
        };
        let (a, a_from, a_to) = part_way(source, p.source, q.source);
        let (b, b_from, b_to) = part_way(target, p.target, q.target);
        let strictly_between = |outline: &Outline, point: BoundaryPoint, from: f64, to: f64| {
            let s = outline.distance(point);
            let margin = 1e-3 * (to - from);
            s > from + margin && s < to - margin
        };
        let node = if (a_to - a_from) / source.length() >= (b_to - b_from) / target.length() {
            let image = self.map.boundary_forward(a);
            RingNode { source: a, target: if strictly_between(target, image, b_from, b_to) { image } else { b } }
        } else {
            let origin = self.map.boundary_backward(b);
            if strictly_between(source, origin, a_from, a_to) {
                // As for inner nodes, the way there counts.
                let image = self.map.boundary_forward(origin);
                RingNode {
                    source: origin,
                    target: if strictly_between(target, image, b_from, b_to) { image } else { b },
                }
            } else {
                RingNode { source: a, target: b }
            }
        };
        let ends = [(p.source, q.source, node.source), (p.target, q.target, node.target)];
        ends.iter().all(|(p, q, m)| m.point != p.point && m.point != q.point).then_some(node)
    }

    /// What the maps can tell apart, in units of the disk.
    pub(super) fn trust(&self) -> f64 {
        let [source, target] = self.map.copies();
        source.error().max(target.error())
    }

    /// Size of each copy: what lengths are compared with.
    pub(super) fn sizes(&self) -> [f64; 2] {
        [self.outlines[0].length(), self.outlines[1].length()]
    }

    /// Not anticlockwise in both copies, or its corners on one edge of an outline.
    pub(super) fn is_bad(&self, t: [u32; 3]) -> bool {
        orientation(&self.target, t) <= 0.0 || orientation(&self.source, t) <= 0.0 || self.is_flat(t)
    }

    /// Whether the corners lie on one edge of an outline: then only rounding gives the triangle an area.
    pub(super) fn is_flat(&self, t: [u32; 3]) -> bool {
        (0..2).any(|copy| self.is_straight(copy, t))
    }

    /// Whether three nodes lie on one straight edge of a copy's outline.
    pub(super) fn is_straight(&self, copy: usize, nodes: [u32; 3]) -> bool {
        // Most triangles have an inner node.
        let is_inner = |k: u32| self.places.get(k as usize).is_none_or(Option::is_none);
        if nodes.into_iter().any(is_inner) {
            return false;
        }
        let edges = |k: u32| {
            let place = self.places[k as usize].map(|node| if copy == 0 { node.source } else { node.target })?;
            Some(self.outlines[copy].straight_edges(place))
        };
        let [Some(a), Some(b), Some(c)] = nodes.map(edges) else { return false };
        a.iter().any(|edge| edge.is_some() && b.contains(edge) && c.contains(edge))
    }
}
