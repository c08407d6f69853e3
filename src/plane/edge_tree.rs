//! Bounding boxes over runs of edges: nearest edges and crossings without looking at every edge.

use super::Complex64;

/// A binary tree of bounding boxes over the edges of a closed polygon, in boundary order.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeTree {
    /// Boxes of a complete binary tree: node k has the children 2k + 1 and 2k + 2; the leaves are runs of edges.
    boxes: Vec<Bounds>,
    /// Leaves, a power of two.
    leaves: usize,
    edges: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Bounds {
    low: Complex64,
    high: Complex64,
}

impl Bounds {
    const EMPTY: Self = Self {
        low: Complex64::new(f64::INFINITY, f64::INFINITY),
        high: Complex64::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    fn including(self, z: Complex64) -> Self {
        Self {
            low: Complex64::new(self.low.re.min(z.re), self.low.im.min(z.im)),
            high: Complex64::new(self.high.re.max(z.re), self.high.im.max(z.im)),
        }
    }

    /// Square of the distance from `z`, 0 inside.
    fn distance_sqr(&self, z: Complex64) -> f64 {
        let outside = |x: f64, low: f64, high: f64| (low - x).max(x - high).max(0.0);
        let (dx, dy) = (outside(z.re, self.low.re, self.high.re), outside(z.im, self.low.im, self.high.im));
        dx * dx + dy * dy
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.re <= other.high.re
            && other.low.re <= self.high.re
            && self.low.im <= other.high.im
            && other.low.im <= self.high.im
    }

    /// Whether the ray from `z` to the right can meet it.
    fn meets_ray(&self, z: Complex64) -> bool {
        self.high.re >= z.re && self.low.im <= z.im && self.high.im >= z.im
    }
}

/// Edges that a leaf should have.
const LEAF_EDGES: usize = 4;

impl EdgeTree {
    /// Over the edges between consecutive vertices.
    #[must_use]
    pub fn new(vertices: &[Complex64]) -> Self {
        Self::joined(vertices, |k| (k + 1) % vertices.len())
    }

    /// Over the edges from each vertex to the one that `next` tells.
    #[must_use]
    pub fn joined(vertices: &[Complex64], next: impl Fn(usize) -> usize) -> Self {
        let edges = vertices.len();
        let leaves = edges.div_ceil(LEAF_EDGES).next_power_of_two();
        let mut tree = Self { boxes: vec![Bounds::EMPTY; 2 * leaves - 1], leaves, edges };
        for leaf in 0..leaves {
            let bounds = &mut tree.boxes[leaves - 1 + leaf];
            let run = leaf * edges / leaves..(leaf + 1) * edges / leaves;
            if !run.is_empty() {
                *bounds = run.fold(Bounds::EMPTY, |b, k| b.including(vertices[k]).including(vertices[next(k)]));
            }
        }
        for k in (0..leaves - 1).rev() {
            let (left, right) = (tree.boxes[2 * k + 1], tree.boxes[2 * k + 2]);
            tree.boxes[k] =
                if right.low.re > right.high.re { left } else { left.including(right.low).including(right.high) };
        }
        tree
    }

    /// The least of `distance_sqr(edge)` and `bound`, with the edge, given that no edge is nearer to `z` than its boxes are.
    pub fn nearest(
        &self,
        z: Complex64,
        bound: f64,
        mut distance_sqr: impl FnMut(usize) -> f64,
    ) -> (f64, Option<usize>) {
        let mut best = (bound, None);
        // Depth-first, the nearer child first.
        let mut open = vec![(self.boxes[0].distance_sqr(z), 0)];
        while let Some((distance, node)) = open.pop() {
            if distance > best.0 {
                continue;
            }
            if let Some(run) = self.run(node) {
                for edge in run {
                    let distance = distance_sqr(edge);
                    if distance < best.0 {
                        best = (distance, Some(edge));
                    }
                }
                continue;
            }
            let mut children = [2 * node + 1, 2 * node + 2].map(|child| (self.boxes[child].distance_sqr(z), child));
            if children[0].0 < children[1].0 {
                children.swap(0, 1);
            }
            open.extend(children);
        }
        best
    }

    /// Calls `visit` for every edge whose run's box meets that of the segment ab.
    pub fn for_each_near(&self, a: Complex64, b: Complex64, mut visit: impl FnMut(usize)) {
        let bounds = Bounds::EMPTY.including(a).including(b);
        let mut open = vec![0];
        while let Some(node) = open.pop() {
            if !self.boxes[node].meets(&bounds) {
                continue;
            }
            match self.run(node) {
                Some(run) => run.for_each(&mut visit),
                None => open.extend([2 * node + 1, 2 * node + 2]),
            }
        }
    }

    /// Calls `visit` for every edge whose box meets the ray from `z` to the right.
    pub fn for_each_on_ray(&self, z: Complex64, mut visit: impl FnMut(usize)) {
        let mut open = vec![0];
        while let Some(node) = open.pop() {
            if !self.boxes[node].meets_ray(z) {
                continue;
            }
            match self.run(node) {
                Some(run) => run.for_each(&mut visit),
                None => open.extend([2 * node + 1, 2 * node + 2]),
            }
        }
    }

    /// The edges of a leaf.
    fn run(&self, node: usize) -> Option<std::ops::Range<usize>> {
        let leaf = (node + 1).checked_sub(self.leaves)?;
        Some(leaf * self.edges / self.leaves..(leaf + 1) * self.edges / self.leaves)
    }
}
