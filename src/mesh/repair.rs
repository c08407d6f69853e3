//! No flipped triangle in either copy: refine where the connectivity of one would fold the other (Saalfeld's caveat).

use super::draft::Draft;
use super::ring::RingNode;
use super::validate::orientation;
use crate::plane::Complex64;
use crate::{Error, Result};
use std::collections::BTreeSet;

/// Refinement halves edges, so that this many rounds reach details 2^-40 of the region's size.
const MOST_ROUNDS: usize = 40;
/// The bound on the refinement: this many times the nodes at the start, and a thousand.
const MOST_GROWTH: usize = 2;
/// Pockets have an angle on the circle of less than this many errors of the maps.
const POCKET: f64 = 100.0;

impl Draft<'_> {
    /// Connects the nodes, then adds nodes until no triangle is flipped or degenerate.
    ///
    /// # Errors
    /// [`Error::Crowded`] if the bound on the refinement is met before.
    pub(super) fn connect_valid(&mut self) -> Result<()> {
        self.connect()?;
        let mut bad = self.bad_triangles();
        self.evidence.flipped_at_first = bad.len();
        let start = self.source.len();
        for _ in 0..MOST_ROUNDS {
            let (pockets, others): (Vec<_>, Vec<_>) = bad.iter().copied().partition(|t| self.is_pocket(*t));
            if others.is_empty() {
                self.raise(&pockets);
                bad = self.bad_triangles();
                self.evidence.added = self.source.len() - start;
                break;
            }
            let too_many = self.source.len() > MOST_GROWTH * start + 1000;
            if too_many || self.refine(&others) == 0 {
                break;
            }
            self.connect()?;
            bad = self.bad_triangles();
        }
        let Some(t) = bad.first() else { return Ok(()) };
        let [a, b, c] = t.map(|k| self.source[k as usize]);
        Err(Error::Crowded { at: (a + b + c) / 3.0 })
    }

    /// Whether a triangle is flat in the target because it lies in a pocket.
    fn is_pocket(&self, t: [u32; 3]) -> bool {
        let [Some(a), Some(b), Some(c)] = t.map(|k| self.places[k as usize]) else { return false };
        let far = [(a, b), (b, c), (c, a)].iter().any(|(p, q)| (p.angle - q.angle).abs() > POCKET * self.trust());
        !far && self.on_one_edge(1, [a, b, c]) && !self.on_one_edge(0, [a, b, c])
    }

    /// The triangles that are not anticlockwise in both copies, or have their corners on one edge of an outline.
    pub(super) fn bad_triangles(&self) -> Vec<[u32; 3]> {
        let bad = |t: &&[u32; 3]| {
            orientation(&self.target, **t) <= 0.0 || orientation(&self.source, **t) <= 0.0 || self.is_flat(**t)
        };
        self.triangles.iter().filter(bad).copied().collect()
    }

    /// Whether the corners lie on one edge of an outline: then only rounding gives the triangle an area.
    fn is_flat(&self, t: [u32; 3]) -> bool {
        let [Some(a), Some(b), Some(c)] = t.map(|k| self.places[k as usize]) else { return false };
        (0..2).any(|copy| self.on_one_edge(copy, [a, b, c]))
    }

    fn on_one_edge(&self, copy: usize, nodes: [RingNode; 3]) -> bool {
        let Some(polygon) = self.outlines[copy].straight() else { return false };
        let edges = |node: RingNode| {
            let place = if copy == 0 { node.source } else { node.target };
            let before = (place.edge + polygon.len() - 1) % polygon.len();
            [place.edge, if place.t == 0.0 { before } else { place.edge }]
        };
        let [a, b, c] = nodes.map(edges);
        a.iter().any(|edge| b.contains(edge) && c.contains(edge))
    }

    /// Adds the middle of the longest edge of each of these triangles; returns the number of nodes added.
    fn refine(&mut self, bad: &[[u32; 3]]) -> usize {
        let next_on_ring = self.next_on_ring();
        let mut inner: BTreeSet<(u32, u32)> = BTreeSet::new();
        let mut starts: Vec<u32> = Vec::new();
        let mut points: Vec<Complex64> = Vec::new();
        for &[a, b, c] in bad {
            let flat = self.is_flat([a, b, c]);
            let edges = [(a, b), (b, c), (c, a)];
            let on_boundary = |e: &(u32, u32)| next_on_ring[e.0 as usize] == e.1;
            let eligible = edges.iter().filter(|e| !(flat && on_boundary(e)));
            match eligible.max_by(|p, q| self.length(**p).total_cmp(&self.length(**q))) {
                Some(edge) if on_boundary(edge) => starts.push(edge.0),
                Some(&(p, q)) => {
                    inner.insert((p.min(q), p.max(q)));
                }
                None => points.push([a, b, c].iter().map(|&k| self.source[k as usize]).sum::<Complex64>() / 3.0),
            }
        }
        points.extend(inner.iter().map(|&(p, q)| 0.5 * (self.source[p as usize] + self.source[q as usize])));
        starts.sort_unstable();
        self.add_inner(&points) + self.split_boundary(&starts)
    }

    /// Length of an edge as a share of the outline, in the copy where it is longer.
    fn length(&self, (p, q): (u32, u32)) -> f64 {
        let (p, q) = (p as usize, q as usize);
        let [source, target] = self.sizes();
        ((self.source[p] - self.source[q]).norm() / source).max((self.target[p] - self.target[q]).norm() / target)
    }
}
