//! Affine maps of the plane, which take edges to edges.

use super::Complex64;
use super::edge::Edge;
use super::elliptic_arc::EllipticArc;
use std::ops::Mul;

/// z ↦ x·Re z + y·Im z + at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Affine {
    x: Complex64,
    y: Complex64,
    at: Complex64,
}

impl Affine {
    pub const IDENTITY: Self = Self { x: Complex64::ONE, y: Complex64::I, at: Complex64::ZERO };

    /// SVG's `matrix(a b c d e f)`.
    pub fn matrix([a, b, c, d, e, f]: [f64; 6]) -> Self {
        Self { x: Complex64::new(a, b), y: Complex64::new(c, d), at: Complex64::new(e, f) }
    }

    pub fn translate(x: f64, y: f64) -> Self {
        Self { at: Complex64::new(x, y), ..Self::IDENTITY }
    }

    pub fn scale(x: f64, y: f64) -> Self {
        Self::matrix([x, 0.0, 0.0, y, 0.0, 0.0])
    }

    fn turn(&self, v: Complex64) -> Complex64 {
        self.x * v.re + self.y * v.im
    }

    fn point(&self, z: Complex64) -> Complex64 {
        self.turn(z) + self.at
    }

    /// The image of an edge, of the same kind.
    pub fn edge(&self, edge: &Edge) -> Edge {
        match edge {
            Edge::Line { from, to } => Edge::line(self.point(*from), self.point(*to)),
            Edge::Arc(arc) => {
                let ([from, to, cosine, sine], angles) = arc.parts();
                let parts = [self.point(from), self.point(to), self.turn(cosine), self.turn(sine)];
                Edge::Arc(EllipticArc::of_parts(parts, angles))
            }
            Edge::Quadratic(points) => Edge::Quadratic(points.map(|z| self.point(z))),
            Edge::Cubic(points) => Edge::Cubic(points.map(|z| self.point(z))),
        }
    }
}

/// The inner map, and then the outer.
impl Mul for Affine {
    type Output = Self;

    fn mul(self, inner: Self) -> Self {
        Self { x: self.turn(inner.x), y: self.turn(inner.y), at: self.point(inner.at) }
    }
}
