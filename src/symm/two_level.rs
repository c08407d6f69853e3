//! A preconditioner of two levels: overlapping groups of neighbouring panels, and one mass a group.
//!
//! The groups solve for what is local (corners, short waves along the boundary), the coarse level for what is not (the
//! distribution of mass over the groups, and the constant c). Restricted additive Schwarz: a group is solved with its two
//! neighbours around it, and only its own part is kept.

use super::lu::Lu;
use super::options::Progress;
use super::panelled::Panelled;
use super::refinement::Refinement;
use crate::plane::{Complex64, sort_by_number};
use crate::{Error, Result};
use std::ops::Range;
use std::sync::Arc;

/// Unknowns that a group should have.
const GROUP_UNKNOWNS: usize = 32;

/// The approximate inverse of Symm's bordered system.
#[derive(Clone, Debug)]
pub struct TwoLevel {
    groups: Vec<Group>,
    /// The panels of each group.
    ranges: Vec<Range<usize>>,
    /// The groups of each component.
    components: Vec<Range<usize>>,
    /// Share of its group's mass that each node carries on the coarse level.
    shares: Vec<f64>,
    coarse: Arc<Lu>,
}

#[derive(Clone, Debug)]
struct Group {
    /// Its own unknowns.
    own: Range<usize>,
    /// Those solved for: its own first, then its neighbours'.
    extended: Vec<usize>,
    /// The groups of these neighbours.
    neighbours: Vec<usize>,
    local: Arc<Lu>,
}

impl TwoLevel {
    /// Groups the panels of a discretisation and factors the blocks that `local` gives.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(discretisation: &dyn Panelled, local: LocalMatrix, progress: Progress) -> Result<Self> {
        let p = discretisation.order().p();
        let mut ranges: Vec<Range<usize>> = Vec::new();
        let mut components = Vec::with_capacity(discretisation.components().len());
        for own in discretisation.components() {
            let (first, panels) = (ranges.len(), own.len());
            let count = (panels * p).div_ceil(GROUP_UNKNOWNS).min(panels / 2).max(1);
            let bounds: Vec<usize> = (0..=count).map(|g| own.start + g * panels / count).collect();
            ranges.extend(bounds.windows(2).map(|pair| pair[0]..pair[1]));
            components.push(first..ranges.len());
        }
        let count = ranges.len();
        let shares = coarse_shares(discretisation, &ranges);
        let layout = Layout::new(discretisation, &ranges, &components, &shares);
        let mut groups = Vec::with_capacity(count);
        let mut self_potential = Vec::with_capacity(count);
        for (g, range) in ranges.iter().enumerate() {
            if g % 16 == 0 && !progress("precondition", g as f64 / count as f64) {
                return Err(Error::Cancelled);
            }
            let neighbours = layout.neighbours(g);
            let members = members(&ranges, g, &neighbours);
            let matrix = local(&members);
            let own = range.start * p..range.end * p;
            self_potential.push(mean_potential(&matrix, members.len() * p, &shares[own]));
            groups.push(Group::new(p, range, &members, neighbours, Arc::new(Lu::new(members.len() * p, matrix))));
        }
        let coarse = coarse_matrix(&layout, &components, &shares, &self_potential);
        let coarse = Arc::new(Lu::new(count + components.len(), coarse));
        Ok(Self { groups, ranges, components, shares, coarse })
    }

    /// The same for refined panels, with the groups and the coarse level that there are; only groups with halved panels are
    /// factored. `None` if too many were halved for that.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn refined(
        &self,
        refinement: &Refinement,
        discretisation: &dyn Panelled,
        local: LocalMatrix,
        progress: Progress,
    ) -> Result<Option<Self>> {
        let p = discretisation.order().p();
        let panel = |q: usize| refinement.first_from(q);
        let ranges: Vec<Range<usize>> = self.ranges.iter().map(|old| panel(old.start)..panel(old.end)).collect();
        if ranges.iter().zip(&self.ranges).any(|(new, old)| new.len() > MOST_GROWTH * old.len()) {
            return Ok(None);
        }
        let mut groups = Vec::with_capacity(ranges.len());
        for (g, (range, old)) in ranges.iter().zip(&self.groups).enumerate() {
            if g % 16 == 0 && !progress("precondition", g as f64 / ranges.len() as f64) {
                return Err(Error::Cancelled);
            }
            let members = members(&ranges, g, &old.neighbours);
            let factors = if members.iter().all(|&q| refinement.kept(q).is_some()) {
                Arc::clone(&old.local)
            } else {
                Arc::new(Lu::new(members.len() * p, local(&members)))
            };
            groups.push(Group::new(p, range, &members, old.neighbours.clone(), factors));
        }
        let shares = coarse_shares(discretisation, &ranges);
        let (components, coarse) = (self.components.clone(), Arc::clone(&self.coarse));
        Ok(Some(Self { groups, ranges, components, shares, coarse }))
    }

    /// Writes an approximation of the bordered system's solution for the right-hand side `r` into `z`.
    pub fn apply(&self, r: &[f64], z: &mut [f64]) {
        let n = r.len() - self.components.len();
        let mut coarse: Vec<f64> =
            self.groups.iter().map(|group| group.own.clone().map(|i| self.shares[i] * r[i]).sum()).collect();
        coarse.extend_from_slice(&r[n..]);
        self.coarse.solve(&mut coarse);
        for (group, mass) in self.groups.iter().zip(&coarse) {
            // What the local solve adds is corrected by the coarse level only in its mean.
            let mut local: Vec<f64> = group.extended.iter().map(|&i| r[i]).collect();
            group.local.solve(&mut local);
            let own = &local[..group.own.len()];
            let total: f64 = own.iter().sum();
            for (i, value) in group.own.clone().zip(own) {
                z[i] = value + (mass - total) * self.shares[i];
            }
        }
        z[n..].copy_from_slice(&coarse[self.groups.len()..]);
    }
}

/// A refined group may have so many times the panels that it had.
const MOST_GROWTH: usize = 2;

impl Group {
    fn new(p: usize, range: &Range<usize>, members: &[usize], neighbours: Vec<usize>, local: Arc<Lu>) -> Self {
        let extended = members.iter().flat_map(|q| q * p..(q + 1) * p).collect();
        Self { own: range.start * p..range.end * p, extended, neighbours, local }
    }
}

/// The panels that are solved for with group `g`: its own come first, then the neighbours'.
fn members(ranges: &[Range<usize>], g: usize, neighbours: &[usize]) -> Vec<usize> {
    ranges[g].clone().chain(neighbours.iter().flat_map(|&h| ranges[h].clone())).collect()
}

/// The equations at some panels' nodes in these panels' masses, row-major.
pub type LocalMatrix<'a> = &'a dyn Fn(&[usize]) -> Vec<f64>;

/// That matrix, where no entries are stored.
#[must_use]
pub fn local_matrix(discretisation: &dyn Panelled, members: &[usize]) -> Vec<f64> {
    let taus = discretisation.node_taus();
    let (p, size) = (taus.len(), taus.len() * members.len());
    let mut matrix = vec![0.0; size * size];
    let targets = members.iter().flat_map(|&q| taus.iter().map(move |tau| discretisation.target(q, *tau)));
    for (target, row) in targets.zip(matrix.chunks_exact_mut(size)) {
        for (&q, entries) in members.iter().zip(row.chunks_exact_mut(p)) {
            discretisation.fill_row(&target, q, entries);
        }
    }
    matrix
}

/// How a group's mass is spread over its nodes on the coarse level: by length.
fn coarse_shares(discretisation: &dyn Panelled, ranges: &[Range<usize>]) -> Vec<f64> {
    let weights = &discretisation.order().panel.weights;
    let mut shares = Vec::with_capacity(discretisation.unknowns());
    for range in ranges {
        let lengths: Vec<f64> = range.clone().map(|q| discretisation.length(q)).collect();
        let total: f64 = lengths.iter().sum();
        shares.extend(lengths.iter().flat_map(|length| weights.iter().map(move |w| 0.5 * w * length / total)));
    }
    shares
}

/// Potential of a group's coarse mass on itself, averaged the same way.
fn mean_potential(matrix: &[f64], size: usize, shares: &[f64]) -> f64 {
    shares
        .iter()
        .enumerate()
        .map(|(i, share)| {
            let row = &matrix[i * size..][..shares.len()];
            share * row.iter().zip(shares).map(|(a, s)| a * s).sum::<f64>()
        })
        .sum()
}

/// Where the groups lie.
struct Layout {
    /// The groups before and after each.
    beside: Vec<[usize; 2]>,
    points: Vec<Complex64>,
    nodes: Vec<Range<usize>>,
    centers: Vec<Complex64>,
    radii: Vec<f64>,
}

/// Groups nearer than this share of their radii's sum are solved together: the two walls of a slot.
const NEAR: f64 = 0.75;
/// Neighbours beyond the two along the boundary.
const MOST_NEIGHBOURS: usize = 2;

impl Layout {
    fn new(
        discretisation: &dyn Panelled,
        ranges: &[Range<usize>],
        components: &[Range<usize>],
        shares: &[f64],
    ) -> Self {
        let p = discretisation.order().p();
        let points = discretisation.points(&discretisation.node_taus());
        let nodes: Vec<Range<usize>> = ranges.iter().map(|range| range.start * p..range.end * p).collect();
        let centers: Vec<Complex64> =
            nodes.iter().map(|nodes| nodes.clone().map(|i| points[i] * shares[i]).sum()).collect();
        let radius = |(nodes, center): (&Range<usize>, &Complex64)| {
            nodes.clone().map(|i| (points[i] - center).norm()).fold(0.0, f64::max)
        };
        let radii = nodes.iter().zip(&centers).map(radius).collect();
        let round = |own: &Range<usize>, g: usize, step: usize| own.start + (g - own.start + step) % own.len();
        let beside = |own: &Range<usize>| {
            let own = own.clone();
            own.clone().map(move |g| [round(&own, g, own.len() - 1), round(&own, g, 1)])
        };
        let beside = components.iter().flat_map(beside).collect();
        Self { beside, points, nodes, centers, radii }
    }

    /// The groups before and after `g`, and those that lie across from it.
    fn neighbours(&self, g: usize) -> Vec<usize> {
        let count = self.nodes.len();
        let mut beside = self.beside[g].to_vec();
        beside.dedup();
        beside.retain(|&h| h != g);
        let closeness = |h: usize| (self.centers[h] - self.centers[g]).norm() / (self.radii[g] + self.radii[h]);
        let mut across: Vec<usize> =
            (0..count).filter(|&h| h != g && !beside.contains(&h) && closeness(h) < NEAR).collect();
        sort_by_number(&mut across, |&h| closeness(h));
        across.truncate(MOST_NEIGHBOURS);
        beside.extend(across);
        beside
    }
}

/// Mean potentials between groups, bordered like the full system.
fn coarse_matrix(layout: &Layout, components: &[Range<usize>], shares: &[f64], self_potential: &[f64]) -> Vec<f64> {
    let count = layout.nodes.len();
    let size = count + components.len();
    let mut matrix = vec![0.0; size * size];
    for a in 0..count {
        for b in 0..count {
            let distance = (layout.centers[a] - layout.centers[b]).norm();
            matrix[a * size + b] = if a == b {
                self_potential[a]
            } else if distance > 2.0 * (layout.radii[a] + layout.radii[b]) {
                distance.ln()
            } else {
                let to = |i: usize| layout.nodes[b].clone().map(move |j| (i, j));
                let log = |i: usize, j: usize| 0.5 * (layout.points[i] - layout.points[j]).norm_sqr().ln();
                layout.nodes[a].clone().flat_map(to).map(|(i, j)| shares[i] * shares[j] * log(i, j)).sum()
            };
        }
    }
    for (border, own) in components.iter().enumerate().map(|(j, own)| (count + j, own)) {
        for a in own.clone() {
            matrix[a * size + border] = 1.0;
            matrix[border * size + a] = 1.0;
        }
    }
    matrix
}
