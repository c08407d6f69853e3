//! No flipped triangle in either copy: refine where the connectivity of one would fold the other (Saalfeld's caveat).

use super::correspondence::Correspondence;
use super::draft::Draft;
use crate::plane::{Complex64, sort_by};
use crate::symm::options::Progress;
use crate::{Error, Result};
use std::collections::BTreeSet;

/// Refinement that has not undone the flips in so many rounds meets a place that double precision has no room for.
const MOST_ROUNDS: usize = 8;
/// The bound on the refinement: this many times the nodes at the start, and a thousand.
const MOST_GROWTH: usize = 2;

impl Draft<'_> {
    /// Connects the nodes, then adds nodes and their images under `map` until no triangle is flipped or degenerate; what is left then is mended.
    ///
    /// # Errors
    /// [`Error::Crowded`] if that is not possible either, and [`Error::Cancelled`].
    pub(super) fn connect_valid(&mut self, map: &dyn Correspondence, progress: Progress) -> Result<()> {
        self.connect()?;
        let mut bad = self.bad_triangles();
        self.evidence.flipped_at_first = self.evidence.flipped_at_first.max(bad.len());
        self.flip_bad();
        bad = self.bad_triangles();
        let start = self.source.len();
        for round in 0..MOST_ROUNDS {
            if !progress("undoing flips", round as f64 / MOST_ROUNDS as f64) {
                return Err(Error::Cancelled);
            }
            let too_many = self.source.len() > MOST_GROWTH * start + 1000;
            if bad.is_empty() || too_many || self.refine(&bad, map) == 0 {
                break;
            }
            self.connect()?;
            self.flip_bad();
            bad = self.bad_triangles();
        }
        self.evidence.added += self.source.len() - start;
        let Some(t) = bad.first() else { return Ok(()) };
        let [a, b, c] = t.map(|k| self.source[k as usize]);
        if self.mend(&bad) && self.bad_triangles().is_empty() {
            self.evidence.mended = bad.len();
            Ok(())
        } else {
            Err(Error::Crowded { at: (a + b + c) / 3.0 })
        }
    }

    /// The triangles that are not anticlockwise in both copies, or have their corners on one edge of an outline.
    fn bad_triangles(&self) -> Vec<[u32; 3]> {
        self.triangles.iter().filter(|t| self.is_bad(**t)).copied().collect()
    }

    /// Adds the middle of the longest edge of each of these triangles; returns the number of nodes added.
    fn refine(&mut self, bad: &[[u32; 3]], map: &dyn Correspondence) -> usize {
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
        sort_by(&mut starts, Ord::cmp);
        self.add_inner(&points, map) + self.split_boundary(&starts)
    }

    /// Length of an edge as a share of the outline, in the copy where it is longer.
    fn length(&self, (p, q): (u32, u32)) -> f64 {
        let (p, q) = (p as usize, q as usize);
        let [source, target] = self.sizes();
        ((self.source[p] - self.source[q]).norm() / source).max((self.target[p] - self.target[q]).norm() / target)
    }
}
