//! Connecting the nodes, and edge flips: triangles that are flat or turned over, where the other diagonal of two neighbours is not.

use super::connect::connect;
use super::draft::Draft;
use super::triangles::{edges, orientation};
use crate::Result;
use rustc_hash::{FxHashMap, FxHashSet};

impl Draft<'_> {
    /// Connects the nodes anew: a constrained Delaunay triangulation of the source, without triangles that only rounding
    /// made.
    pub(super) fn connect(&mut self) -> Result<()> {
        let ring: Vec<u32> = self.ring.iter().map(|(id, _)| *id).collect();
        self.triangles = connect(&self.source, &ring)?;
        self.flip_flat();
        Ok(())
    }

    /// Flips edges until no triangle has its corners on one straight edge of the source: rounding alone gives those an
    /// area.
    fn flip_flat(&mut self) {
        self.flip_while(
            |draft, t| draft.is_straight(0, t),
            |draft, t| !draft.is_straight(0, t) && orientation(&draft.source, t) > 0.0,
        );
    }

    /// Flips edges of bad triangles where that makes two good ones.
    pub(super) fn flip_bad(&mut self) {
        self.flip_while(Self::is_bad, |draft, t| !draft.is_bad(t));
    }

    fn flip_while(&mut self, wanted: impl Fn(&Self, [u32; 3]) -> bool, good: impl Fn(&Self, [u32; 3]) -> bool) {
        loop {
            let mut pending: Vec<usize> =
                (0..self.triangles.len()).filter(|&t| wanted(self, self.triangles[t])).collect();
            let nodes: FxHashSet<u32> = pending.iter().flat_map(|&t| self.triangles[t]).collect();
            if pending.is_empty() {
                return;
            }
            // Neighbours have two nodes of the triangle.
            let near = |t: &[u32; 3]| t.iter().filter(|k| nodes.contains(k)).count() > 1;
            let mut left_of: FxHashMap<(u32, u32), usize> = FxHashMap::default();
            for (index, t) in self.triangles.iter().enumerate().filter(|(_, t)| near(t)) {
                edges(*t).into_iter().for_each(|edge| left_of.extend([(edge, index)]));
            }
            let mut flipped = false;
            while let Some(index) = pending.pop() {
                if !wanted(self, self.triangles[index]) {
                    continue;
                }
                for (a, b) in edges(self.triangles[index]) {
                    let Some(&other) = left_of.get(&(b, a)) else { continue };
                    let (Some(c), Some(d)) =
                        (opposite(self.triangles[index], a, b), opposite(self.triangles[other], b, a))
                    else {
                        continue;
                    };
                    let (left, right) = ([a, d, c], [d, b, c]);
                    if !good(self, left) || !good(self, right) {
                        continue;
                    }
                    left_of.remove(&(a, b));
                    left_of.remove(&(b, a));
                    self.triangles[index] = left;
                    self.triangles[other] = right;
                    edges(left).into_iter().for_each(|edge| left_of.extend([(edge, index)]));
                    edges(right).into_iter().for_each(|edge| left_of.extend([(edge, other)]));
                    flipped = true;
                    break;
                }
            }
            if !flipped {
                return;
            }
        }
    }
}

/// The third corner of a triangle with the edge from a to b.
fn opposite(t: [u32; 3], a: u32, b: u32) -> Option<u32> {
    (0..3).find(|&k| t[k] == a && t[(k + 1) % 3] == b).map(|k| t[(k + 2) % 3])
}
