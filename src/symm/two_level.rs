//! A preconditioner of two levels: overlapping groups of neighbouring panels, and one mass a group.
//!
//! The groups solve for what is local (corners, short waves along the boundary), the coarse level for what is not (the
//! distribution of mass over the groups, and the constant c). Restricted additive Schwarz: a group is solved with its two
//! neighbours around it, and only its own part is kept.

use super::discretisation::Discretisation;
use super::lu::Lu;
use super::options::Progress;
use crate::plane::Complex64;
use crate::{Error, Result};
use std::ops::Range;

/// Unknowns that a group should have.
const GROUP_UNKNOWNS: usize = 32;

/// The approximate inverse of Symm's bordered system.
#[derive(Clone, Debug)]
pub struct TwoLevel {
    groups: Vec<Group>,
    /// Share of its group's mass that each node carries on the coarse level.
    shares: Vec<f64>,
    coarse: Lu,
}

#[derive(Clone, Debug)]
struct Group {
    /// Its own unknowns.
    own: Range<usize>,
    /// Those solved for: its own first, then its neighbours'.
    extended: Vec<usize>,
    local: Lu,
}

impl TwoLevel {
    /// Groups the panels of a discretisation and factors the blocks.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(discretisation: &Discretisation, progress: Progress) -> Result<Self> {
        let p = discretisation.order.p();
        let panels = discretisation.panels.len();
        let count = (panels * p).div_ceil(GROUP_UNKNOWNS).min(panels / 2).max(1);
        let bounds: Vec<usize> = (0..=count).map(|g| g * panels / count).collect();
        let ranges: Vec<Range<usize>> = bounds.windows(2).map(|pair| pair[0]..pair[1]).collect();
        let shares = coarse_shares(discretisation, &ranges);
        let layout = Layout::new(discretisation, &ranges, &shares);
        let targets = discretisation.collocation_points();
        let local_matrix = |members: &[usize]| {
            let mut matrix = Vec::with_capacity((members.len() * p).pow(2));
            let mut entries = vec![0.0; p];
            for &row_panel in members {
                for target in &targets[row_panel * p..][..p] {
                    for &q in members {
                        discretisation.fill_row(*target, q, &mut entries);
                        matrix.extend_from_slice(&entries);
                    }
                }
            }
            matrix
        };
        let mut groups = Vec::with_capacity(count);
        let mut self_potential = Vec::with_capacity(count);
        for (g, range) in ranges.iter().enumerate() {
            if g % 16 == 0 && !progress("precondition", g as f64 / count as f64) {
                return Err(Error::Cancelled);
            }
            // Its own panels come first, then the neighbours'.
            let neighbours = layout.neighbours(g);
            let members: Vec<usize> =
                range.clone().chain(neighbours.into_iter().flat_map(|h| ranges[h].clone())).collect();
            let size = members.len() * p;
            let matrix = local_matrix(&members);
            let own = range.start * p..range.end * p;
            self_potential.push(mean_potential(&matrix, size, &shares[own.clone()]));
            let extended = members.iter().flat_map(|q| q * p..(q + 1) * p).collect();
            groups.push(Group { own, extended, local: Lu::new(size, matrix) });
        }
        let coarse = coarse_matrix(&layout, &shares, &self_potential);
        Ok(Self { groups, shares, coarse: Lu::new(count + 1, coarse) })
    }

    /// Writes an approximation of the bordered system's solution for the right-hand side `r` into `z`.
    pub fn apply(&self, r: &[f64], z: &mut [f64]) {
        let n = r.len() - 1;
        let mut coarse: Vec<f64> =
            self.groups.iter().map(|group| group.own.clone().map(|i| self.shares[i] * r[i]).sum()).collect();
        coarse.push(r[n]);
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
        z[n] = coarse[self.groups.len()];
    }
}

/// How a group's mass is spread over its nodes on the coarse level: by length.
fn coarse_shares(discretisation: &Discretisation, ranges: &[Range<usize>]) -> Vec<f64> {
    let weights = &discretisation.order.panel.weights;
    let mut shares = Vec::with_capacity(discretisation.unknowns());
    for range in ranges {
        let panels = &discretisation.panels[range.clone()];
        let total: f64 = panels.iter().map(|panel| panel.length()).sum();
        shares.extend(panels.iter().flat_map(|panel| weights.iter().map(move |w| 0.5 * w * panel.length() / total)));
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
    fn new(discretisation: &Discretisation, ranges: &[Range<usize>], shares: &[f64]) -> Self {
        let p = discretisation.order.p();
        let points: Vec<Complex64> = discretisation
            .collocation_points()
            .iter()
            .map(|target| discretisation.boundary.vertices[target.corner] + target.offset)
            .collect();
        let nodes: Vec<Range<usize>> = ranges.iter().map(|range| range.start * p..range.end * p).collect();
        let centers: Vec<Complex64> =
            nodes.iter().map(|nodes| nodes.clone().map(|i| points[i] * shares[i]).sum()).collect();
        let radius = |(nodes, center): (&Range<usize>, &Complex64)| {
            nodes.clone().map(|i| (points[i] - center).norm()).fold(0.0, f64::max)
        };
        let radii = nodes.iter().zip(&centers).map(radius).collect();
        Self { points, nodes, centers, radii }
    }

    /// The groups before and after `g`, and those that lie across from it.
    fn neighbours(&self, g: usize) -> Vec<usize> {
        let count = self.nodes.len();
        let mut beside = vec![(g + count - 1) % count, (g + 1) % count];
        beside.dedup();
        beside.retain(|&h| h != g);
        let closeness = |h: usize| (self.centers[h] - self.centers[g]).norm() / (self.radii[g] + self.radii[h]);
        let mut across: Vec<usize> =
            (0..count).filter(|&h| h != g && !beside.contains(&h) && closeness(h) < NEAR).collect();
        across.sort_by(|&a, &b| closeness(a).total_cmp(&closeness(b)));
        across.truncate(MOST_NEIGHBOURS);
        beside.extend(across);
        beside
    }
}

/// Mean potentials between groups, bordered like the full system.
fn coarse_matrix(layout: &Layout, shares: &[f64], self_potential: &[f64]) -> Vec<f64> {
    let count = layout.nodes.len();
    let mut matrix = vec![0.0; (count + 1) * (count + 1)];
    for a in 0..count {
        for b in 0..count {
            let distance = (layout.centers[a] - layout.centers[b]).norm();
            matrix[a * (count + 1) + b] = if a == b {
                self_potential[a]
            } else if distance > 2.0 * (layout.radii[a] + layout.radii[b]) {
                distance.ln()
            } else {
                let to = |i: usize| layout.nodes[b].clone().map(move |j| (i, j));
                let log = |i: usize, j: usize| 0.5 * (layout.points[i] - layout.points[j]).norm_sqr().ln();
                layout.nodes[a].clone().flat_map(to).map(|(i, j)| shares[i] * shares[j] * log(i, j)).sum()
            };
        }
        matrix[a * (count + 1) + count] = 1.0;
        matrix[count * (count + 1) + a] = 1.0;
    }
    matrix
}
