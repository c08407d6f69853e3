//! Pockets: parts of one copy behind a neck so narrow that double precision has no room for them in the other.
//!
//! Their nodes fall together there, and triangles turn over, however fine they are. No picture can show what happens in
//! so small a place, only that nothing is torn or folded. So a patch around each such place gets a connectivity that is
//! valid in both copies by construction, and no more conformal than the place has room for.

use super::compatible::{Corners, compatible};
use super::draft::Draft;
use super::triangles::{orientation, outlines_of};
use crate::plane::Complex64;
use rustc_hash::FxHashMap;

/// Patches grow by a ring of triangles until both their outlines are simple; this often at most.
const MOST_RINGS: usize = 40;
/// Larger patches than this are not pockets.
const MOST_CORNERS: usize = 1000;

/// A patch's new triangles; their nodes beyond those of the draft are `source` and `target`.
struct Mended {
    source: Vec<Complex64>,
    target: Vec<Complex64>,
    triangles: Vec<[u32; 3]>,
}

impl Draft<'_> {
    /// Connects the surroundings of these triangles anew. False if some cannot be mended.
    pub(super) fn mend(&mut self, bad: &[[u32; 3]]) -> bool {
        let mut patch: Vec<bool> = self.triangles.iter().map(|t| bad.contains(t)).collect();
        let mut known: FxHashMap<(usize, usize), Option<Mended>> = FxHashMap::default();
        for _ in 0..MOST_RINGS {
            let groups = self.groups(&patch);
            let mut done = true;
            for group in &groups {
                // A group is known by its first triangle and size: it only ever grows.
                let mended = known.entry((group[0], group.len())).or_insert_with(|| self.mended(group));
                if mended.is_none() {
                    done = false;
                    self.grow(group, &mut patch);
                }
            }
            if done {
                let mended = groups.iter().filter_map(|group| known.remove(&(group[0], group.len())).flatten());
                let mended: Vec<_> = mended.collect();
                self.replace(&patch, mended);
                return true;
            }
        }
        false
    }

    /// The marked triangles in groups that share no node.
    fn groups(&self, marked: &[bool]) -> Vec<Vec<usize>> {
        let mut leader: Vec<u32> = (0..self.source.len() as u32).collect();
        fn find(leader: &mut [u32], mut k: u32) -> u32 {
            while leader[k as usize] != k {
                leader[k as usize] = leader[leader[k as usize] as usize];
                k = leader[k as usize];
            }
            k
        }
        for (t, _) in self.triangles.iter().zip(marked).filter(|(_, marked)| **marked) {
            let root = find(&mut leader, t[0]);
            for k in &t[1..] {
                let other = find(&mut leader, *k);
                leader[other as usize] = root;
            }
        }
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut number: FxHashMap<u32, usize> = FxHashMap::default();
        for (index, t) in self.triangles.iter().enumerate().filter(|(index, _)| marked[*index]) {
            let root = find(&mut leader, t[0]);
            let group = *number.entry(root).or_insert_with(|| {
                groups.push(Vec::new());
                groups.len() - 1
            });
            groups[group].push(index);
        }
        groups
    }

    /// Marks the triangles around a group.
    fn grow(&self, group: &[usize], marked: &mut [bool]) {
        let mut inside = vec![false; self.source.len()];
        for &index in group {
            self.triangles[index].iter().for_each(|&k| inside[k as usize] = true);
        }
        for (t, marked) in self.triangles.iter().zip(marked) {
            *marked |= t.iter().any(|&k| inside[k as usize]);
        }
    }

    /// New triangles for a group, if its outlines are simple and the triangles valid.
    fn mended(&self, group: &[usize]) -> Option<Mended> {
        let ring = self.outline_of(group)?;
        if ring.len() > MOST_CORNERS {
            return None;
        }
        let next_on_ring = self.next_on_ring();
        let n = ring.len();
        let at = |points: &[Complex64]| -> Vec<Complex64> { ring.iter().map(|&k| points[k as usize]).collect() };
        let straight = |copy: usize| -> Vec<bool> {
            let neighbours = |k: usize| [ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]];
            (0..n)
                .map(|k| {
                    let [a, b, c] = neighbours(k);
                    let along = next_on_ring[a as usize] == b && next_on_ring[b as usize] == c;
                    along && self.is_straight(copy, [a, b, c])
                })
                .collect()
        };
        let (corners, flags) = ([at(&self.source), at(&self.target)], [straight(0), straight(1)]);
        let rings = [0, 1].map(|copy| Corners { places: &corners[copy], straight: &flags[copy] });
        let found = compatible(&rings[0], &rings[1])?;
        let node = |k: u32| match ring.get(k as usize) {
            Some(&corner) => corner,
            None => (self.source.len() + k as usize - n) as u32,
        };
        let [source, target] = [[&corners[0][..], &found.source].concat(), [&corners[1][..], &found.target].concat()];
        let upright = |t: &[u32; 3]| orientation(&source, *t) > 0.0 && orientation(&target, *t) > 0.0;
        let triangles: Vec<_> = found.triangles.iter().map(|t| t.map(node)).collect();
        let valid = found.triangles.iter().all(upright) && !triangles.iter().any(|t| self.is_flat(*t));
        valid.then_some(Mended { source: found.source, target: found.target, triangles })
    }

    /// The outline of a group of triangles, anticlockwise in the source; `None` unless it is one closed curve.
    fn outline_of(&self, group: &[usize]) -> Option<Vec<u32>> {
        let triangles: Vec<_> = group.iter().map(|&index| self.triangles[index]).collect();
        let mut outlines = outlines_of(&triangles).ok()?;
        outlines.pop().filter(|_| outlines.is_empty())
    }

    /// Puts new triangles in the place of the marked ones, and drops nodes that have none left.
    fn replace(&mut self, marked: &[bool], mended: Vec<Mended>) {
        let mut index = 0;
        self.triangles.retain(|_| {
            index += 1;
            !marked[index - 1]
        });
        let before = self.source.len();
        for patch in mended {
            let shift = (self.source.len() - before) as u32;
            let place = |k: u32| if (k as usize) < before { k } else { k + shift };
            self.triangles.extend(patch.triangles.iter().map(|t| t.map(place)));
            self.source.extend(patch.source);
            self.target.extend(patch.target);
        }
        self.places.resize(self.source.len(), None);
        self.drop_unused();
    }

    fn drop_unused(&mut self) {
        let mut used = vec![false; self.source.len()];
        self.triangles.iter().flatten().for_each(|&k| used[k as usize] = true);
        let mut numbers = Vec::with_capacity(used.len());
        let mut count = 0;
        for &used in &used {
            numbers.push(count);
            count += u32::from(used);
        }
        let keep = |k: usize| used[k];
        self.source = (0..used.len()).filter(|&k| keep(k)).map(|k| self.source[k]).collect();
        self.target = (0..used.len()).filter(|&k| keep(k)).map(|k| self.target[k]).collect();
        self.places = (0..used.len()).filter(|&k| keep(k)).map(|k| self.places[k]).collect();
        self.triangles.iter_mut().flatten().for_each(|k| *k = numbers[*k as usize]);
        self.ring.iter_mut().for_each(|(id, _)| *id = numbers[*id as usize]);
    }
}
