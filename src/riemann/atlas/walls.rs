//! Distances to the boundary.

use crate::plane::{Complex64, EdgeTree};
use crate::symm::panel::Boundary;
use std::sync::Arc;

/// The edges of the boundary, asked for the nearest.
#[derive(Clone, Debug)]
pub struct Walls {
    boundary: Arc<Boundary>,
    tree: Arc<EdgeTree>,
    /// Points as near to the boundary as this are on it, as far as numbers can tell.
    pub thickness: f64,
    /// Whether the map is singular at each vertex: unless π is a multiple of the interior angle, it is.
    singular: Vec<bool>,
}

/// The boundary point nearest to a point.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    pub distance: f64,
    pub edge: usize,
    /// Distance from the start of the edge.
    pub along: f64,
    /// Whether the point lies in the region.
    pub inside: bool,
}

/// How a disk lies to the walls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lie {
    /// Nothing of it is in the region, or on its boundary.
    Outside,
    /// So far inside that one power series may serve it.
    Clear,
    /// Inside, but beside a corner where the map is singular.
    BesideCorner,
    /// Beside a wall, or across one.
    BesideWall,
}

/// A power series may serve a disk whose radius is at most this share of the distance from its center to the wall,
const SHARE_OF_WALL: f64 = 0.9;
/// and this one of the distance to a corner where the map is singular.
const SHARE_OF_CORNER: f64 = 0.6;

impl Walls {
    #[must_use]
    pub fn new(boundary: &Arc<Boundary>, thickness: f64) -> Self {
        let regular = |alpha: &f64| (1.0 / alpha - (1.0 / alpha).round()).abs() < 1e-9;
        let singular = boundary.alpha.iter().map(|alpha| !regular(alpha)).collect();
        let tree = Arc::new(EdgeTree::joined(&boundary.vertices, |k| boundary.next(k)));
        Self { boundary: Arc::clone(boundary), tree, thickness, singular }
    }

    /// `z` in the coordinates of an edge: start at 0, along the real axis, the region above.
    fn local(&self, z: Complex64, edge: usize) -> Complex64 {
        (z - self.boundary.vertices[edge]) * self.boundary.directions[edge].conj()
    }

    fn distance(&self, z: Complex64, edge: usize) -> f64 {
        let local = self.local(z, edge);
        Complex64::new(local.re - local.re.clamp(0.0, self.boundary.lengths[edge]), local.im).norm_sqr().sqrt()
    }

    /// The nearest point on one of some edges, the nearest edge of all being among them.
    #[must_use]
    pub fn nearest(&self, z: Complex64, among: &[u32]) -> Nearest {
        let mut best = (f64::INFINITY, 0, Complex64::ZERO);
        for &edge in among {
            let local = self.local(z, edge as usize);
            let beyond = local.re - local.re.clamp(0.0, self.boundary.lengths[edge as usize]);
            let square = beyond * beyond + local.im * local.im;
            if square < best.0 {
                best = (square, edge as usize, local);
            }
        }
        let (square, edge, local) = best;
        let along = local.re.clamp(0.0, self.boundary.lengths[edge]);
        let vertex = if along == local.re {
            None
        } else if along == 0.0 {
            Some(edge)
        } else {
            Some(self.boundary.next(edge))
        };
        // Nearest to a vertex from inside can only be where the corner is re-entrant.
        let inside = match vertex.map(|k| self.boundary.alpha[k]) {
            Some(alpha) if (alpha - 1.0).abs() > 1e-6 => alpha > 1.0,
            _ => local.im > 0.0,
        };
        Nearest { distance: square.sqrt(), edge, along, inside }
    }

    /// How a disk lies, `nearest` being the wall that is nearest to its center.
    #[must_use]
    pub fn lie(&self, center: Complex64, radius: f64, among: &[u32], nearest: Nearest) -> Lie {
        if !nearest.inside && nearest.distance > radius + self.thickness {
            return Lie::Outside;
        }
        let is_off_walls = nearest.inside && radius <= SHARE_OF_WALL * nearest.distance;
        if !is_off_walls {
            return Lie::BesideWall;
        }
        let corner = self.to_singular_vertex(center, among);
        if radius <= SHARE_OF_CORNER * corner { Lie::Clear } else { Lie::BesideCorner }
    }

    /// The nearest point on all edges.
    #[must_use]
    pub fn nearest_of_all(&self, z: Complex64) -> Nearest {
        let square = |edge: usize| self.distance(z, edge).powi(2);
        let edge = self.tree.nearest(z, f64::INFINITY, square).1.unwrap_or(0);
        self.nearest(z, &[edge as u32])
    }

    /// Those of some edges that come as near as `limit`.
    #[must_use]
    pub fn within(&self, z: Complex64, among: &[u32], limit: f64) -> Vec<u32> {
        among.iter().copied().filter(|&edge| self.distance(z, edge as usize) <= limit).collect()
    }

    /// Distance to the nearest end of some edges at which the map is singular.
    fn to_singular_vertex(&self, z: Complex64, among: &[u32]) -> f64 {
        let ends = among.iter().flat_map(|&edge| [edge as usize, self.boundary.next(edge as usize)]);
        let squares = ends.filter(|&k| self.singular[k]).map(|k| (z - self.boundary.vertices[k]).norm_sqr());
        squares.fold(f64::INFINITY, f64::min).sqrt()
    }

    /// Radius of the sector around the boundary point `along` an edge, between the edges that meet there, which no other
    /// wall enters. What lies behind these edges, as across a thin slot, does not matter to the map.
    #[must_use]
    pub fn room(&self, edge: usize, along: f64) -> f64 {
        let boundary = &self.boundary;
        let length = boundary.lengths[edge];
        let origin = boundary.vertices[edge] + boundary.directions[edge] * along;
        let (before, room, alpha) = if along == 0.0 {
            let before = boundary.previous(edge);
            (before, length.min(boundary.lengths[before]), boundary.alpha[edge])
        } else {
            (edge, along.min(length - along), 1.0)
        };
        if along == 0.0 && boundary.clearances[edge] >= room {
            return room;
        }
        let heights = |p: Complex64| [edge, before].map(|edge| ((p - origin) * boundary.directions[edge].conj()).im);
        // Where the nearest point of a wall lies outside the sector, the wall enters it beyond the ends of the edges, if at all.
        let seen = |p: Complex64| {
            let [a, b] = heights(p);
            if alpha > 1.0 { a.max(b) >= 0.0 } else { a.min(b) >= 0.0 }
        };
        let square = |k: usize| {
            if k == edge || k == before {
                return f64::INFINITY;
            }
            let p = self.nearest_of(origin, k);
            if seen(p) { (p - origin).norm_sqr() } else { f64::INFINITY }
        };
        self.tree.nearest(origin, room * room, square).0.sqrt()
    }

    /// The point of `edge` nearest to `z`.
    fn nearest_of(&self, z: Complex64, edge: usize) -> Complex64 {
        let along = self.local(z, edge).re.clamp(0.0, self.boundary.lengths[edge]);
        self.boundary.vertices[edge] + self.boundary.directions[edge] * along
    }

    /// Whether another edge than `own` comes as near to `z` as `radius`.
    #[must_use]
    pub fn intrudes(&self, z: Complex64, radius: f64, among: &[u32], own: [usize; 2]) -> bool {
        let mut others = among.iter().map(|&edge| edge as usize).filter(|edge| !own.contains(edge));
        others.any(|edge| self.distance(z, edge) <= radius)
    }

    /// All edges.
    #[must_use]
    pub fn all(&self) -> Vec<u32> {
        (0..self.boundary.len() as u32).collect()
    }
}
