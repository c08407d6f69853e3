//! Graded density: nodes where the affine pieces would leave the map.

use super::draft::Draft;
use super::probe::{Facet, Probe};
use super::ring::RingNode;
use super::triangles::edges;
use crate::plane::{Complex64, sort_by};
use crate::symm::options::Progress;
use crate::{Error, Result};
use rustc_hash::{FxHashMap, FxHashSet};

/// Each round halves edges that are too long where they are longer, so that this many reach 2^-40 of the first spacing.
const MOST_ROUNDS: usize = 40;
/// More nodes than this are not made; the largest error then says what is missing.
const MOST_NODES: usize = 400_000;
/// Cosine of the largest angle that an inner node may see a boundary edge under.
const WIDEST: f64 = -0.5;
/// In so many rounds the largest error must fall to this share: it halves in each where more nodes help at all.
const PATIENCE: usize = 8;
const HELPFUL: f64 = 0.7;
/// Fewer nodes than this are no sign of refinement that does not help.
const HARMLESS: usize = 5000;
/// What is shorter than this share of the source's outline shows one colour, whatever its place in the target.
const ONE_COLOUR: f64 = 1e-9;
/// The first, coarse grid has about this many samples across a region.
const COARSE: f64 = 10.0;

/// Spacing of the grid that a graded mesh starts from, for a region of this area.
pub(super) fn first_spacing(area: f64) -> f64 {
    area.sqrt() / COARSE
}

/// The map at probes, kept from round to round: most probes stay as they are.
#[derive(Default)]
pub(super) struct Known {
    inner: FxHashMap<Probe, Complex64>,
    boundary: FxHashMap<Probe, Option<RingNode>>,
}

impl Draft<'_> {
    /// Adds nodes until the map is within `bound` (plane units of the target) of its affine pieces at their probes, or no
    /// more nodes help. True if only the number of nodes ended it. What is found out of the map is added to `known`.
    ///
    /// # Errors
    /// [`Error::Crowded`] as in connecting, and [`Error::Cancelled`].
    pub(super) fn refine_to(&mut self, bound: f64, known: &mut Known, progress: Progress) -> Result<bool> {
        let mut worst = Vec::new();
        for _ in 0..MOST_ROUNDS {
            self.connect()?;
            self.flip_bad();
            let probes = self.probes();
            self.look_up(known, &probes);
            let fine = |probe: &&Probe| self.is_shorter(probe.facet, self.room.finest);
            let off = probes.iter().filter(|probe| !fine(probe)).map(|&probe| (probe, self.error(known, probe)));
            let off: Vec<_> = off.collect();
            worst.push(off.iter().map(|(_, error)| *error).fold(0.0, f64::max));
            let off: FxHashSet<_> =
                off.into_iter().filter(|(_, error)| *error > bound).map(|(probe, _)| probe.facet).collect();
            let fraction = 1.0 - off.len() as f64 / probes.len() as f64;
            if !progress("refining the mesh", fraction) {
                return Err(Error::Cancelled);
            }
            let helps = worst.len() <= PATIENCE || worst[worst.len() - 1] < HELPFUL * worst[worst.len() - 1 - PATIENCE];
            let nodes = self.source.len();
            if nodes > MOST_NODES {
                return Ok(true);
            }
            if !helps && nodes > HARMLESS || self.add_where(known, &off) == 0 {
                break;
            }
        }
        Ok(false)
    }

    /// Finds the largest distances between the map and its affine pieces: infinite if the map has no value at a probe. What is
    /// `known` of the map is not asked again.
    pub(super) fn measure(&mut self, known: &Known) {
        let (mut seen, mut crowded) = (0.0, 0.0_f64);
        let mut note = |probe: Probe, error: f64| {
            let largest = if self.is_shorter(probe.facet, ONE_COLOUR) { &mut crowded } else { &mut seen };
            *largest = error.max(*largest);
        };
        let mut new = Vec::new();
        for probe in self.probes() {
            if matches!(probe.facet, Facet::Boundary(..)) {
                let point = known.boundary.get(&probe).copied().unwrap_or_else(|| self.on_boundary(probe));
                note(probe, self.error_on_boundary(probe, point));
            } else if let Some(&image) = known.inner.get(&probe) {
                note(probe, self.error_inside(probe, image));
            } else {
                new.push(probe);
            }
        }
        for (&probe, image) in new.iter().zip(self.images(&new)) {
            note(probe, self.error_inside(probe, image));
        }
        self.evidence.largest_error = seen;
        self.evidence.crowded_error = crowded;
    }

    /// Computes what is not known yet.
    fn look_up(&self, known: &mut Known, probes: &[Probe]) {
        let mut new = Vec::new();
        for &probe in probes {
            match probe.facet {
                Facet::Boundary(..) => {
                    known.boundary.entry(probe).or_insert_with(|| self.on_boundary(probe));
                }
                _ if known.inner.contains_key(&probe) => {}
                _ => new.push(probe),
            }
        }
        let images = self.images(&new);
        known.inner.extend(new.into_iter().zip(images));
    }

    fn error(&self, known: &Known, probe: Probe) -> f64 {
        match probe.facet {
            Facet::Boundary(..) => self.error_on_boundary(probe, known.boundary[&probe]),
            _ => self.error_inside(probe, known.inner[&probe]),
        }
    }

    /// Adds the middles of edges that are `off`, and of such triangles whose edges are all good.
    fn add_where(&mut self, known: &Known, off: &FxHashSet<Facet>) -> usize {
        let edge_off =
            |(p, q): (u32, u32)| off.contains(&Facet::Edge(p.min(q), p.max(q))) || off.contains(&Facet::Boundary(p, q));
        let mut starts = Vec::new();
        let mut split = Vec::new();
        for &facet in off {
            match facet {
                Facet::Boundary(p, _) => starts.push(p),
                Facet::Triangle(t) if edges(t).into_iter().any(edge_off) => {}
                _ => split.push(facet),
            }
        }
        let mut nodes = self.middles_where_longer(known, &split);
        nodes.retain(|&(z, w)| match self.crowded_edge(z, w) {
            Some(start) => {
                starts.push(start);
                false
            }
            None => true,
        });
        sort_by(&mut nodes, |(p, _), (q, _)| {
            (p.re, p.im).partial_cmp(&(q.re, q.im)).unwrap_or(std::cmp::Ordering::Equal)
        });
        sort_by(&mut starts, Ord::cmp);
        starts.dedup();
        self.add_pairs(&nodes) + self.split_boundary(&starts)
    }

    /// The first node of a boundary edge that an inner node would be too close to, in either copy (Ruppert's rule): it is to
    /// be split instead.
    fn crowded_edge(&self, z: Complex64, w: Complex64) -> Option<u32> {
        [z, w].into_iter().enumerate().find_map(|(copy, z)| {
            let points = if copy == 0 { &self.source } else { &self.target };
            let nearest = self.outlines[copy].nearest(z)?;
            let s = self.outlines[copy].distance(nearest);
            let place = |node: &RingNode| if copy == 0 { node.source } else { node.target };
            let after = self.ring.partition_point(|(_, node)| self.outlines[copy].distance(place(node)) <= s);
            let [a, b] = [after.max(1) - 1, after % self.ring.len()].map(|k| self.ring[k].0);
            let [u, v] = [points[a as usize] - z, points[b as usize] - z];
            ((u.conj() * v).re < WIDEST * u.norm() * v.norm()).then_some(a)
        })
    }

    /// Nodes for the middles of facets in the copy where they are longer. Towards a corner that the map opens or closes, that
    /// halves the error; the middle in the shorter copy hardly changes it.
    fn middles_where_longer(&self, known: &Known, facets: &[Facet]) -> Vec<(Complex64, Complex64)> {
        let [from, to] = self.sizes();
        let longer_in_target = |f: &Facet| f.extent(&self.target) / to > f.extent(&self.source) / from;
        let (there, here): (Vec<_>, Vec<_>) = facets.iter().copied().partition(longer_in_target);
        let pair_of_source = |facet: Facet| (facet.middle(&self.source), known.inner[&Probe { facet, towards: None }]);
        let places: Vec<_> = there.iter().map(|facet| facet.middle(&self.target)).collect();
        let found = self.map.backward(&places);
        // The way there and back is not the same to the last digit, and a crowded place shows the difference. What errors are
        // measured with is the way there.
        let images = self.map.forward(&found);
        let of_target = there.iter().zip(found.into_iter().zip(images)).map(|(&facet, (z, w))| {
            // Beside a re-entrant corner the middle may lie outside the region.
            if z.is_finite() && w.is_finite() { (z, w) } else { pair_of_source(facet) }
        });
        of_target.chain(here.into_iter().map(pair_of_source)).collect()
    }
}
