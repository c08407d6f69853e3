//! Pockets: parts of the source behind a neck so narrow that the target has room for them on one edge only.
//!
//! Their boundary nodes lie side by side on that edge, closer together than the maps are accurate, and triangles
//! between them are flat. Each chord between two such nodes gets a node on an arc over its ends instead: arcs over
//! nested chords are nested, and longer ones rise more steeply, which keeps every triangle between them anticlockwise.

use super::draft::Draft;
use crate::plane::Complex64;
use std::collections::HashMap;

/// Height of an arc over a chord as long as the outline, relative to the chord.
const RISE: f64 = 0.2;
/// How slowly shorter arcs get flatter.
const FLATTENING: f64 = 0.1;

impl Draft<'_> {
    /// Splits the chords of these triangles, which are flat in the target, and every triangle that has such a chord.
    pub(super) fn raise(&mut self, flat: &[[u32; 3]]) {
        let next_on_ring = self.next_on_ring();
        let mut arcs: HashMap<(u32, u32), u32> = HashMap::new();
        for &[a, b, c] in flat {
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let chord = (p.min(q), p.max(q));
                if next_on_ring[p as usize] == q || arcs.contains_key(&chord) {
                    continue;
                }
                arcs.insert(chord, self.source.len() as u32);
                self.source.push(0.5 * (self.source[p as usize] + self.source[q as usize]));
                self.target.push(self.over(p, q));
                self.places.push(None);
            }
        }
        let triangles = std::mem::take(&mut self.triangles);
        self.triangles =
            triangles.into_iter().flat_map(|t| split(t, |p, q| arcs.get(&(p.min(q), p.max(q))).copied())).collect();
    }

    /// The top of the arc over two boundary nodes on one edge of the target.
    fn over(&self, p: u32, q: u32) -> Complex64 {
        let along = |k: u32| self.places[k as usize].map_or(0.0, |place| self.outlines[1].distance(place.target));
        let (p, q) = if along(p) < along(q) { (p, q) } else { (q, p) };
        let (a, b) = (self.target[p as usize], self.target[q as usize]);
        let rise = RISE * ((b - a).norm() / self.outlines[1].length()).powf(FLATTENING);
        0.5 * (a + b) + Complex64::i() * (b - a) * (0.5 * rise)
    }
}

/// A triangle cut at the nodes in the middle of its edges.
fn split([a, b, c]: [u32; 3], middle: impl Fn(u32, u32) -> Option<u32>) -> Vec<[u32; 3]> {
    match [middle(a, b), middle(b, c), middle(c, a)] {
        [None, None, None] => vec![[a, b, c]],
        [Some(ab), None, None] => vec![[a, ab, c], [ab, b, c]],
        [Some(ab), Some(bc), None] => vec![[ab, b, bc], [a, ab, bc], [a, bc, c]],
        [Some(ab), Some(bc), Some(ca)] => vec![[a, ab, ca], [ab, b, bc], [bc, c, ca], [ab, bc, ca]],
        _ => split([b, c, a], middle),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn split_triangles_cover_the_whole() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];
        let area = |t: [u32; 3]| {
            let [a, b, c] = t.map(|k| Complex64::new(corners[k as usize].0, corners[k as usize].1));
            0.5 * ((b - a).conj() * (c - a)).im
        };
        for cut in 0..8 {
            let middle = |p: u32, q: u32| {
                let edge = match (p.min(q), p.max(q)) {
                    (0, 1) => 0,
                    (1, 2) => 1,
                    _ => 2,
                };
                (cut >> edge & 1 == 1).then_some(3 + edge)
            };
            let parts = split([0, 1, 2], middle);
            assert_eq!(parts.len(), 1 + (cut as u32).count_ones() as usize);
            assert!(parts.iter().all(|t| area(*t) > 0.0));
            assert_eq!(parts.into_iter().map(area).sum::<f64>(), 8.0);
        }
    }
}
