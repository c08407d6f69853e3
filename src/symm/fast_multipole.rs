//! The product masses → potentials in nearly linear time (Greengard & Rokhlin 1987), for thousands of vertices.
//!
//! A cluster of panels far away acts through its multipole expansion Q log(z−b) + Σ aₖ/(z−b)ᵏ, which becomes a Taylor
//! series Σ bₗ(z−t)ˡ around a cluster of targets; near pairs keep their exact matrix entries. Powers are scaled by the
//! clusters' radii, so that no size overflows.

use super::clusters::{Cluster, ClusterTree, Interactions};
use super::influence::{Influence, zeros};
use super::multipole::{binomials, shift_multipole, shift_series};
use super::options::Progress;
use super::panelled::Panelled;
use super::refinement::Refinement;
use crate::plane::Complex64;
use crate::{Error, Result};
use rustc_hash::{FxBuildHasher, FxHashMap};

/// Clusters this far apart interact through expansions, whose error falls like SEPARATION^order.
const SEPARATION: f64 = 0.5;
/// Unknowns of a leaf, about.
const LEAF_UNKNOWNS: usize = 48;

/// Near entries stored, far ones expanded.
pub struct FastInfluence {
    tree: ClusterTree,
    interactions: Interactions,
    p: usize,
    /// Terms of an expansion beyond the first.
    order: usize,
    /// Targets a panel.
    targets_per_panel: usize,
    /// The scaled multipole coefficients of a unit mass at each unknown of a leaf: order + 1 of them each.
    unit_multipoles: Vec<Complex64>,
    /// For each target, its place in its leaf's disk: (z − t)/radius.
    places: Vec<Complex64>,
    /// Entries of the near pairs, row-major, one after another.
    near_entries: Vec<f64>,
    /// `binomials[l·order + k]` = (−1)^(k+1) C(l+k, k), for the coefficient k + 1 of the source.
    binomials: Vec<f64>,
}

impl FastInfluence {
    /// The potentials at the given τ of every panel, in the order of the panels.
    /// Entries are good to `10^-digits`.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(discretisation: &dyn Panelled, taus: &[f64], digits: f64, progress: Progress) -> Result<Self> {
        let mut fast = Self::without_near(discretisation, taus, digits);
        fast.fill_near(discretisation, taus, None, progress)?;
        Ok(fast)
    }

    /// The same for refined panels; entries between panels that were kept are taken over.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn refined(
        &self,
        refinement: &Refinement,
        discretisation: &dyn Panelled,
        taus: &[f64],
        progress: Progress,
    ) -> Result<Self> {
        let mut fast = Self::without_near(discretisation, taus, discretisation.order().digits);
        fast.fill_near(discretisation, taus, Some(&NearBlocks::new(self, refinement)), progress)?;
        Ok(fast)
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        std::mem::size_of_val(&self.near_entries[..]) + std::mem::size_of_val(&self.unit_multipoles[..])
    }

    fn without_near(discretisation: &dyn Panelled, taus: &[f64], digits: f64) -> Self {
        let p = discretisation.order().p();
        let order = (digits * std::f64::consts::LN_10 / -SEPARATION.ln()).ceil() as usize;
        let tree = ClusterTree::new(discretisation, LEAF_UNKNOWNS.div_ceil(p));
        let interactions = tree.interactions(SEPARATION);
        let targets_per_panel = taus.len();
        Self {
            p,
            order,
            targets_per_panel,
            unit_multipoles: unit_multipoles(discretisation, &tree, order),
            places: places(discretisation, &tree, taus),
            near_entries: Vec::new(),
            binomials: signed_binomials(order),
            tree,
            interactions,
        }
    }

    fn fill_near(
        &mut self,
        discretisation: &dyn Panelled,
        taus: &[f64],
        known: Option<&NearBlocks>,
        progress: Progress,
    ) -> Result<()> {
        let clusters = &self.tree.clusters;
        let targets = discretisation.targets(taus);
        let size = |&(t, s): &(usize, usize)| {
            clusters[t].panels.len() * self.targets_per_panel * clusters[s].panels.len() * self.p
        };
        self.near_entries = zeros(self.interactions.near.iter().map(size).sum())?;
        let mut rest = self.near_entries.as_mut_slice();
        for (done, pair) in self.interactions.near.iter().enumerate() {
            let (block, after) = rest.split_at_mut(size(pair));
            rest = after;
            let (target, source) = (&clusters[pair.0], &clusters[pair.1]);
            let rows = target.panels.start * self.targets_per_panel..target.panels.end * self.targets_per_panel;
            for (i, row) in rows.zip(block.chunks_exact_mut(source.panels.len() * self.p)) {
                let target = &targets[i];
                let Some(known) = known else {
                    discretisation.fill_row(target, source.panels.start, row);
                    continue;
                };
                let mut before = None;
                for (q, entries) in source.panels.clone().zip(row.chunks_exact_mut(self.p)) {
                    match known.row(target.panel, i % taus.len(), q, &mut before) {
                        Some(row) => entries.copy_from_slice(row),
                        None => discretisation.fill_row(target, q, entries),
                    }
                }
            }
            if done % 64 == 0 && !progress("assemble", done as f64 / self.interactions.near.len() as f64) {
                return Err(Error::Cancelled);
            }
        }
        Ok(())
    }

    /// Upward: multipole coefficients of every cluster.
    fn multipoles(&self, masses: &[f64]) -> Vec<Complex64> {
        let terms = self.order + 1;
        let mut multipoles = vec![Complex64::ZERO; self.tree.clusters.len() * terms];
        for (index, cluster) in self.tree.clusters.iter().enumerate().rev() {
            let (head, tail) = multipoles.split_at_mut((index + 1) * terms);
            let own = &mut head[index * terms..];
            if let Some(children) = cluster.children {
                for child in children {
                    let from = &tail[(child - index - 1) * terms..][..terms];
                    shift_multipole(&self.tree.clusters[child], from, cluster, own);
                }
            } else {
                let unknowns = cluster.panels.start * self.p..cluster.panels.end * self.p;
                let units = self.unit_multipoles[unknowns.start * terms..unknowns.end * terms].chunks_exact(terms);
                for (mass, unit) in masses[unknowns].iter().zip(units) {
                    own.iter_mut().zip(unit).for_each(|(a, u)| *a += u * mass);
                }
            }
        }
        multipoles
    }

    /// Across: adds a far source's field to a target's Taylor series.
    fn add_far(&self, source: &Cluster, multipole: &[Complex64], target: &Cluster, local: &mut [Complex64]) {
        let apart = source.center - target.center;
        let (near, far) = (source.radius / apart, target.radius / apart);
        let charge = multipole[0];
        let mut scaled = [Complex64::ZERO; MAX_ORDER];
        let mut power = Complex64::new(1.0, 0.0);
        for (u, a) in scaled.iter_mut().zip(&multipole[1..]) {
            power *= near;
            *u = a * power;
        }
        let scaled = &scaled[..self.order];
        let mut power = Complex64::new(1.0, 0.0);
        for (l, b) in local.iter_mut().enumerate() {
            let row = &self.binomials[l * self.order..][..self.order];
            let sum: Complex64 = scaled.iter().zip(row).map(|(u, c)| u * c).sum();
            let log = if l == 0 { charge * (-apart).ln() } else { -charge / l as f64 };
            *b += (sum + log) * power;
            power *= far;
        }
    }

    /// Downward: adds the parent's Taylor series to a child's.
    fn shift_local(&self, parent: &Cluster, from: &[Complex64], child: &Cluster, to: &mut [Complex64]) {
        let shift = (child.center - parent.center) / parent.radius;
        let series = shift_series(from.to_vec(), shift, child.radius / parent.radius);
        to.iter_mut().zip(series).for_each(|(b, c)| *b += c);
    }

    fn locals(&self, multipoles: &[Complex64]) -> Vec<Complex64> {
        let terms = self.order + 1;
        let clusters = &self.tree.clusters;
        let mut locals = vec![Complex64::ZERO; clusters.len() * terms];
        for &(target, source) in &self.interactions.far {
            let multipole = &multipoles[source * terms..][..terms];
            let local = &mut locals[target * terms..][..terms];
            self.add_far(&clusters[source], multipole, &clusters[target], local);
        }
        for (index, cluster) in clusters.iter().enumerate() {
            for child in cluster.children.into_iter().flatten() {
                let (head, tail) = locals.split_at_mut(child * terms);
                self.shift_local(cluster, &head[index * terms..][..terms], &clusters[child], &mut tail[..terms]);
            }
        }
        locals
    }
}

/// The near entries of an earlier round, by panels.
struct NearBlocks<'a> {
    fast: &'a FastInfluence,
    refinement: &'a Refinement,
    /// The leaf of each old panel.
    leaves: Vec<usize>,
    /// Where the entries of each pair of leaves start.
    starts: FxHashMap<(usize, usize), usize>,
}

impl<'a> NearBlocks<'a> {
    fn new(fast: &'a FastInfluence, refinement: &'a Refinement) -> Self {
        let clusters = &fast.tree.clusters;
        let mut leaves = vec![0; clusters[0].panels.len()];
        for (index, leaf) in clusters.iter().enumerate().filter(|(_, cluster)| cluster.children.is_none()) {
            leaves[leaf.panels.clone()].fill(index);
        }
        let mut starts = FxHashMap::with_capacity_and_hasher(fast.interactions.near.len(), FxBuildHasher);
        let mut start = 0;
        for &(t, s) in &fast.interactions.near {
            starts.insert((t, s), start);
            start += clusters[t].panels.len() * fast.targets_per_panel * clusters[s].panels.len() * fast.p;
        }
        Self { fast, refinement, leaves, starts }
    }

    /// The entries at a target of new panel `panel` from the nodes of new panel `source`, if both were kept and were near.
    /// `before` remembers where the last pair of leaves starts.
    fn row(&self, panel: usize, target: usize, source: usize, before: &mut Option<Found>) -> Option<&'a [f64]> {
        let (panel, source) = (self.refinement.kept(panel)?, self.refinement.kept(source)?);
        let pair = (self.leaves[panel], self.leaves[source]);
        let start = match *before {
            Some((known, start)) if known == pair => start,
            _ => self.starts.get(&pair).copied(),
        };
        *before = Some((pair, start));
        let (rows, columns) = (&self.fast.tree.clusters[pair.0].panels, &self.fast.tree.clusters[pair.1].panels);
        let row = (panel - rows.start) * self.fast.targets_per_panel + target;
        let p = self.fast.p;
        Some(&self.fast.near_entries[start? + (row * columns.len() + source - columns.start) * p..][..p])
    }
}

/// A pair of leaves, and where its entries start if it is near.
type Found = ((usize, usize), Option<usize>);

/// More terms than 16 digits need at this separation.
const MAX_ORDER: usize = 56;

impl Influence for FastInfluence {
    fn apply(&self, masses: &[f64], potentials: &mut [f64]) {
        let terms = self.order + 1;
        let locals = self.locals(&self.multipoles(masses));
        for (index, cluster) in self.tree.clusters.iter().enumerate().filter(|(_, c)| c.children.is_none()) {
            let local = &locals[index * terms..][..terms];
            let rows = cluster.panels.start * self.targets_per_panel..cluster.panels.end * self.targets_per_panel;
            for i in rows {
                let place = self.places[i];
                potentials[i] = local.iter().rev().fold(Complex64::ZERO, |sum, b| sum * place + b).re;
            }
        }
        let mut entries = self.near_entries.as_slice();
        for &(target, source) in &self.interactions.near {
            let (target, source) = (&self.tree.clusters[target], &self.tree.clusters[source]);
            let masses = &masses[source.panels.start * self.p..source.panels.end * self.p];
            for i in target.panels.start * self.targets_per_panel..target.panels.end * self.targets_per_panel {
                let (row, rest) = entries.split_at(masses.len());
                entries = rest;
                potentials[i] += super::rows::dot(row, masses);
            }
        }
    }
}

/// Scaled multipole coefficients (charge, then aₖ/radiusᵏ with aₖ = −∫ (y−b)ᵏ dμ/k) of a unit mass at each node.
fn unit_multipoles(discretisation: &dyn Panelled, tree: &ClusterTree, order: usize) -> Vec<Complex64> {
    let p = discretisation.order().p();
    let mut multipoles = vec![Complex64::ZERO; discretisation.unknowns() * (order + 1)];
    for leaf in tree.clusters.iter().filter(|cluster| cluster.children.is_none()) {
        for q in leaf.panels.clone() {
            let panel = discretisation.panel(q);
            let corner = discretisation.vertex(q) - leaf.center;
            discretisation.rule(q).for_each_source(discretisation.order(), |place, masses| {
                let s = panel.start + place * panel.length();
                let y = (corner + discretisation.offset(q, s)) / leaf.radius;
                let mut power = Complex64::new(1.0, 0.0);
                for k in 0..=order {
                    let term = if k == 0 { power } else { -power / k as f64 };
                    for (j, mass) in masses.iter().enumerate() {
                        multipoles[(q * p + j) * (order + 1) + k] += term * mass;
                    }
                    power *= y;
                }
            });
        }
    }
    multipoles
}

fn places(discretisation: &dyn Panelled, tree: &ClusterTree, taus: &[f64]) -> Vec<Complex64> {
    let mut places = discretisation.points(taus);
    for leaf in tree.clusters.iter().filter(|cluster| cluster.children.is_none()) {
        let own = &mut places[leaf.panels.start * taus.len()..leaf.panels.end * taus.len()];
        own.iter_mut().for_each(|z| *z = (*z - leaf.center) / leaf.radius);
    }
    places
}

/// `[l·order + k]` = (−1)^(k+1) C(l+k, k): row l, source coefficient k + 1.
fn signed_binomials(order: usize) -> Vec<f64> {
    let mut table = binomials(order + 1, order);
    table.chunks_exact_mut(order).for_each(|row| row.iter_mut().step_by(2).for_each(|value| *value = -*value));
    table
}

#[cfg(test)]
mod tests {
    use super::super::discretisation::Discretisation;
    use super::super::influence::DenseInfluence;
    use super::super::order::Order;
    use super::super::panel::{Boundary, initial_panels};
    use super::super::rule::Rules;
    use super::*;
    use crate::plane::Polygon;
    use std::f64::consts::TAU;
    use std::sync::Arc;

    /// With sixty rays.
    fn star() -> Arc<Boundary> {
        let radius = |k: u32| if k.is_multiple_of(2) { 1.0 } else { 0.8 };
        let tip = |k: u32| Complex64::from_polar(radius(k), f64::from(k) * TAU / 120.0);
        Arc::new(Boundary::new(&Polygon::new(&(0..120).map(tip).collect::<Vec<_>>()).unwrap()))
    }

    #[test]
    fn agrees_with_every_entry_stored() {
        let boundary = star();
        let mut rules = Rules::new(Order::new(4, 10.0));
        let panels = initial_panels(&boundary, 1.0);
        let discretisation = Discretisation::new(boundary, panels, &mut rules);
        let masses: Vec<f64> = (0..discretisation.unknowns()).map(|j| ((j * 37) % 11) as f64 / 2000.0).collect();
        for taus in [discretisation.node_taus(), discretisation.check_taus()] {
            let dense = DenseInfluence::new(&discretisation, &taus, None, &mut |_, _| true).unwrap();
            let mut exact = vec![0.0; taus.len() * discretisation.panels.len()];
            dense.apply(&masses, &mut exact);
            for digits in [4.0, 8.0, 11.0] {
                let fast = FastInfluence::new(&discretisation, &taus, digits, &mut |_, _| true).unwrap();
                assert!(fast.interactions.far.len() > 100);
                let mut potentials = vec![0.0; exact.len()];
                fast.apply(&masses, &mut potentials);
                let error = potentials.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(error < 10f64.powf(-digits) * 5.0, "{digits} digits: {error:e}");
            }
        }
    }

    #[test]
    fn refining_takes_over_what_stays() {
        let boundary = star();
        let mut rules = Rules::new(Order::new(4, 8.0));
        let panels = initial_panels(&boundary, 1.0);
        let before = Discretisation::new(Arc::clone(&boundary), panels, &mut rules);
        let residuals: Vec<f64> = (0..before.panels.len()).map(|q| f64::from(u8::from(q % 9 == 4))).collect();
        let refinement = Refinement::new(&before, &residuals, 0.5);
        let after = Discretisation::new(boundary, refinement.panels.clone(), &mut rules);
        assert!(after.panels.len() > before.panels.len() + 20);
        let progress = &mut |_: &'static str, _: f64| true;
        let old = FastInfluence::new(&before, &before.node_taus(), 8.0, progress).unwrap();
        let fresh = FastInfluence::new(&after, &after.node_taus(), 8.0, progress).unwrap();
        let refined = old.refined(&refinement, &after, &after.node_taus(), progress).unwrap();
        assert_eq!(refined.near_entries, fresh.near_entries, "bit for bit");
    }
}
