//! A map's jet in the units of a picture: texels of the texture against pixels of the view.

use super::mesh::largest_stretch;
use super::render::TexelGrid;
use crate::map::Jet;
use crate::plane::{Complex64, Frame};

/// Two numbers that go together: the texture's columns and rows.
pub(super) type Pair = [f64; 2];

/// What one point of the view shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The texture's point, in texels; NaN where there is none.
    pub at: Pair,
    /// Texels per pixel, across the view.
    pub dx: Pair,
    /// Texels per pixel, down the view.
    pub dy: Pair,
}

/// Beyond any texture, and still exact enough in single precision: where poles are cut off.
const FAR: f64 = 1e9;

impl Node {
    /// Whether the Jacobian is a turn and a scaling, to one part in a million: then ∂/∂x alone tells the stretch.
    pub fn is_conformal(&self) -> bool {
        let ([ux, vx], [uy, vy]) = (self.dx, self.dy);
        (ux - vy).abs() + (vx + uy).abs() <= 1e-6 * (ux.abs() + vx.abs())
    }

    /// Whether the map has a value here.
    pub fn is_defined(&self) -> bool {
        !self.at[0].is_nan() && !self.at[1].is_nan()
    }

    /// Whether the map has a value and derivatives here.
    pub fn is_regular(&self) -> bool {
        self.at.iter().chain(&self.dx).chain(&self.dy).all(|t| t.abs() < FAR)
    }

    /// The larger singular value of the Jacobian: the footprint's diameter in texels.
    pub fn stretch(&self) -> f64 {
        largest_stretch([self.dx[0], self.dx[1], self.dy[0], self.dy[1]])
    }
}

/// Jets → nodes.
#[derive(Clone, Copy)]
pub(super) struct Scale {
    grid: TexelGrid,
    /// Plane units per pixel of the view.
    pixel: f64,
}

impl Scale {
    pub fn new(grid: TexelGrid, view: &Frame) -> Self {
        Self { grid, pixel: view.pixel_size() }
    }

    pub fn node(&self, jet: &Jet) -> Node {
        let cut = |[u, v]: Pair| [u.clamp(-FAR, FAR), v.clamp(-FAR, FAR)];
        // A step down the view is a step of −i in the plane.
        let across = (jet.dz + jet.dzbar) * self.pixel;
        let down = (jet.dzbar - jet.dz) * Complex64::i() * self.pixel;
        Node { at: cut(self.grid.at(jet.value)), dx: cut(self.grid.step(across)), dy: cut(self.grid.step(down)) }
    }
}
