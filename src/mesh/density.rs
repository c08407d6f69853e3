//! Graded density: nodes where the affine pieces would leave the map.

use super::draft::Draft;
use super::ring::RingNode;
use crate::Result;
use crate::plane::Complex64;
use std::collections::HashMap;

/// Each round halves edges that are too long where they are longer, so that this many reach 2^-40 of the first spacing.
const MOST_ROUNDS: usize = 40;
/// More nodes than this are not made; the largest error then says what is missing.
const MOST_NODES: usize = 400_000;
/// Cosine of the largest angle that an inner node may see a boundary edge under.
const WIDEST: f64 = -0.5;
/// Probes shorter than this share of the source's outline show one colour, whatever their place in the target.
const ONE_COLOUR: f64 = 1e-10;
/// The first, coarse grid has about this many samples across a region.
const COARSE: f64 = 10.0;

/// Spacing of the grid that a graded mesh starts from, for a region of this area.
pub(super) fn first_spacing(area: f64) -> f64 {
    area.sqrt() / COARSE
}

/// A place where the map is compared with the affine pieces.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Probe {
    /// The middle of an inner edge, its nodes in rising order.
    Edge(u32, u32),
    /// The middle of a boundary edge, by its place in the ring.
    Boundary(u32, u32),
    /// The centroid of a triangle.
    Triangle([u32; 3]),
}

/// The map at the middles of probes, kept from round to round: most probes stay as they are.
#[derive(Default)]
struct Middles {
    inner: HashMap<Probe, Complex64>,
    boundary: HashMap<Probe, Option<RingNode>>,
}

impl Draft<'_> {
    /// Adds nodes until the map is within `bound` (plane units of the target) of its affine pieces, at the middles of
    /// edges and triangles.
    pub(super) fn refine_to(&mut self, bound: f64) -> Result<()> {
        let mut middles = Middles::default();
        for _ in 0..MOST_ROUNDS {
            self.connect()?;
            let probes = self.probes();
            self.evaluate(&mut middles, &probes);
            if self.add_where(&middles, &probes, bound) == 0 || self.source.len() > MOST_NODES {
                break;
            }
        }
        Ok(())
    }

    /// The largest distance, in plane units of the target, between the map and its affine pieces.
    pub(super) fn largest_error(&self) -> f64 {
        let (boundary, inner): (Vec<_>, Vec<_>) =
            self.probes().into_iter().partition(|probe| matches!(probe, Probe::Boundary(..)));
        let points: Vec<_> = inner.iter().map(|&probe| mean(&self.source, probe)).collect();
        let inner = inner.iter().zip(self.map.forward(&points)).map(|(&probe, w)| self.error_at(probe, w));
        let boundary = boundary.iter().map(|&probe| self.boundary_error(probe, self.boundary_middle(probe)));
        inner.chain(boundary).fold(0.0, f64::max)
    }

    fn probes(&self) -> Vec<Probe> {
        let mut probes = Vec::with_capacity(3 * self.triangles.len());
        let next_on_ring = self.next_on_ring();
        for &t in &self.triangles {
            for (p, q) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                if next_on_ring[p as usize] == q {
                    probes.push(Probe::Boundary(p, q));
                } else if p < q {
                    probes.push(Probe::Edge(p, q));
                }
            }
            probes.push(Probe::Triangle(t));
        }
        probes
    }

    /// Computes the middles that are not known yet.
    fn evaluate(&self, middles: &mut Middles, probes: &[Probe]) {
        let mut new = Vec::new();
        for &probe in probes {
            match probe {
                Probe::Boundary(..) => {
                    middles.boundary.entry(probe).or_insert_with(|| self.boundary_middle(probe));
                }
                _ if middles.inner.contains_key(&probe) => {}
                _ => new.push(probe),
            }
        }
        let points: Vec<_> = new.iter().map(|&probe| mean(&self.source, probe)).collect();
        middles.inner.extend(new.into_iter().zip(self.map.forward(&points)));
    }

    /// How far the map is from the affine piece at its middle; 0 where the map has no value, or one colour, there.
    fn error(&self, middles: &Middles, probe: Probe) -> f64 {
        match probe {
            Probe::Boundary(..) => self.boundary_error(probe, middles.boundary[&probe]),
            _ => self.error_at(probe, middles.inner[&probe]),
        }
    }

    /// The same for an edge or triangle inside whose middle the map takes to `image`.
    fn error_at(&self, probe: Probe, image: Complex64) -> f64 {
        let distance = (image - mean(&self.target, probe)).norm();
        if distance.is_finite() && !self.has_one_colour(probe) { distance } else { 0.0 }
    }

    fn boundary_middle(&self, probe: Probe) -> Option<RingNode> {
        let Probe::Boundary(p, q) = probe else { return None };
        self.between(self.places[p as usize]?, self.places[q as usize]?)
    }

    fn boundary_error(&self, probe: Probe, middle: Option<RingNode>) -> f64 {
        let (Probe::Boundary(p, q), Some(middle)) = (probe, middle) else { return 0.0 };
        if self.has_one_colour(probe) {
            return 0.0;
        }
        let at = |points: &[Complex64], k: u32| points[k as usize];
        let share =
            (middle.source.point - at(&self.source, p)).norm() / (at(&self.source, q) - at(&self.source, p)).norm();
        let affine = at(&self.target, p) + (at(&self.target, q) - at(&self.target, p)) * share;
        (middle.target.point - affine).norm()
    }

    fn has_one_colour(&self, probe: Probe) -> bool {
        let at = |k: u32| self.source[k as usize];
        let length = ONE_COLOUR * self.outlines[0].length();
        match probe {
            Probe::Edge(p, q) | Probe::Boundary(p, q) => (at(p) - at(q)).norm() < length,
            Probe::Triangle([a, b, c]) => {
                [(a, b), (b, c), (c, a)].iter().all(|&(p, q)| (at(p) - at(q)).norm() < length)
            }
        }
    }

    /// Adds the middles of edges that are off by more than `bound`, and of triangles whose edges are all good.
    fn add_where(&mut self, middles: &Middles, probes: &[Probe], bound: f64) -> usize {
        let off: HashMap<Probe, ()> =
            probes.iter().filter(|&&probe| self.error(middles, probe) > bound).map(|&probe| (probe, ())).collect();
        let edge_off = |p: u32, q: u32| {
            off.contains_key(&Probe::Edge(p.min(q), p.max(q))) || off.contains_key(&Probe::Boundary(p, q))
        };
        let mut starts = Vec::new();
        let mut split = Vec::new();
        for &probe in off.keys() {
            match probe {
                Probe::Boundary(p, _) => starts.push(p),
                Probe::Triangle([a, b, c]) if edge_off(a, b) || edge_off(b, c) || edge_off(c, a) => {}
                _ => split.push(probe),
            }
        }
        let mut nodes = self.middles_where_longer(middles, &split);
        nodes.retain(|&(z, w)| match self.crowded_edge(z, w) {
            Some(start) => {
                starts.push(start);
                false
            }
            None => true,
        });
        nodes.sort_by(|(p, _), (q, _)| (p.re, p.im).partial_cmp(&(q.re, q.im)).unwrap_or(std::cmp::Ordering::Equal));
        starts.sort_unstable();
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

    /// The middle of each probe in the copy where it is longer, and its place in the other one. Towards a corner that the
    /// map opens or closes, that halves the error; the middle in the shorter copy hardly changes it.
    fn middles_where_longer(&self, middles: &Middles, probes: &[Probe]) -> Vec<(Complex64, Complex64)> {
        let [from, to] = self.sizes();
        let longer_in_target = |probe: &Probe| extent(&self.target, *probe) / to > extent(&self.source, *probe) / from;
        let (there, here): (Vec<_>, Vec<_>) = probes.iter().copied().partition(longer_in_target);
        let places: Vec<_> = there.iter().map(|&probe| mean(&self.target, probe)).collect();
        let pair_of_source = |probe: Probe| (mean(&self.source, probe), middles.inner[&probe]);
        let of_target = there.iter().zip(self.map.backward(&places)).zip(places).map(|((&probe, z), w)| {
            // Beside a re-entrant corner the middle may lie outside the region.
            if z.is_finite() { (z, w) } else { pair_of_source(probe) }
        });
        of_target.chain(here.into_iter().map(pair_of_source)).collect()
    }
}

/// Length of a probe's longest edge in one copy.
fn extent(points: &[Complex64], probe: Probe) -> f64 {
    let length = |p: u32, q: u32| (points[p as usize] - points[q as usize]).norm();
    match probe {
        Probe::Edge(p, q) | Probe::Boundary(p, q) => length(p, q),
        Probe::Triangle([a, b, c]) => length(a, b).max(length(b, c)).max(length(c, a)),
    }
}

/// The middle of a probe in one copy.
fn mean(points: &[Complex64], probe: Probe) -> Complex64 {
    let at = |k: u32| points[k as usize];
    match probe {
        Probe::Edge(p, q) | Probe::Boundary(p, q) => 0.5 * (at(p) + at(q)),
        Probe::Triangle([a, b, c]) => (at(a) + at(b) + at(c)) / 3.0,
    }
}
