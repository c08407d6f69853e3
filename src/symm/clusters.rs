//! A binary tree of runs of neighbouring panels, and which pairs of them are far apart.

use super::panelled::Panelled;
use crate::plane::Complex64;
use std::ops::Range;

/// A run of panels inside a disk.
#[derive(Clone, Debug)]
pub struct Cluster {
    /// The panels.
    pub panels: Range<usize>,
    /// Center of the disk.
    pub center: Complex64,
    /// Radius of the disk.
    pub radius: f64,
    /// The two halves, unless it is a leaf.
    pub children: Option<[usize; 2]>,
}

/// All clusters, parents before children; the root is the first.
#[derive(Clone, Debug)]
pub struct ClusterTree {
    /// The clusters.
    pub clusters: Vec<Cluster>,
}

/// Pairs (target, source) of clusters that cover every pair of panels once.
#[derive(Clone, Debug, Default)]
pub struct Interactions {
    /// Well separated: (r₁ + r₂) ≤ separation × distance of the centers.
    pub far: Vec<(usize, usize)>,
    /// Pairs of leaves that are not.
    pub near: Vec<(usize, usize)>,
}

impl ClusterTree {
    /// Halves the boundary until a run has at most `leaf` panels.
    #[must_use]
    pub fn new(discretisation: &dyn Panelled, leaf: usize) -> Self {
        let mut tree = Self { clusters: Vec::new() };
        tree.grow(discretisation, 0..discretisation.panel_count(), leaf);
        tree
    }

    /// The same for each component alone: one tree after another.
    #[must_use]
    pub fn of_components(discretisation: &dyn Panelled, leaf: usize) -> Self {
        let mut trees = Self { clusters: Vec::new() };
        for panels in discretisation.components() {
            trees.grow(discretisation, panels.clone(), leaf);
        }
        trees
    }

    fn grow(&mut self, discretisation: &dyn Panelled, panels: Range<usize>, leaf: usize) -> usize {
        let index = self.clusters.len();
        self.clusters.push(bounding_disk(discretisation, panels.clone()));
        if panels.len() > leaf {
            let middle = panels.start + panels.len() / 2;
            let first = self.grow(discretisation, panels.start..middle, leaf);
            let second = self.grow(discretisation, middle..panels.end, leaf);
            self.clusters[index].children = Some([first, second]);
        }
        index
    }

    /// Splits the pair (root, root) until every part is far or a pair of leaves.
    #[must_use]
    pub fn interactions(&self, separation: f64) -> Interactions {
        let mut interactions = Interactions::default();
        let mut open = vec![(0, 0)];
        while let Some((target, source)) = open.pop() {
            let (t, s) = (&self.clusters[target], &self.clusters[source]);
            if t.radius + s.radius <= separation * (t.center - s.center).norm() {
                interactions.far.push((target, source));
                continue;
            }
            match (t.children, s.children) {
                (None, None) => interactions.near.push((target, source)),
                (Some(halves), None) => open.extend(halves.map(|half| (half, source))),
                (None, Some(halves)) => open.extend(halves.map(|half| (target, half))),
                (Some(halves), Some(_)) if t.radius >= s.radius => open.extend(halves.map(|half| (half, source))),
                (Some(_), Some(halves)) => open.extend(halves.map(|half| (target, half))),
            }
        }
        interactions
    }
}

/// The disk around the bounding box of the panels.
fn bounding_disk(discretisation: &dyn Panelled, panels: Range<usize>) -> Cluster {
    let ends = |q: usize| {
        let at = move |s: f64| discretisation.vertex(q) + discretisation.offset(q, s);
        discretisation.extent(q).into_iter().map(at)
    };
    let (mut low, mut high) =
        (Complex64::new(f64::INFINITY, f64::INFINITY), Complex64::new(-f64::INFINITY, -f64::INFINITY));
    for z in panels.clone().flat_map(ends) {
        low = Complex64::new(low.re.min(z.re), low.im.min(z.im));
        high = Complex64::new(high.re.max(z.re), high.im.max(z.im));
    }
    let center = 0.5 * (low + high);
    let radius = panels.clone().flat_map(ends).map(|z| (z - center).norm()).fold(0.0, f64::max);
    Cluster { panels, center, radius, children: None }
}
