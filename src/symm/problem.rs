//! Right-hand sides: which boundary values and charges an equation is solved for.
//!
//! ```text
//! ∫ log|x − y| σ(y) ds + cⱼ = g(x) on Γⱼ,      ∫ σ over Γⱼ = qⱼ,      g = Re G
//! ```
//! With L(z) = ∫ log(z − y) σ(y) ds the function B = L − G is analytic in the region but for what G has there, Re B = −cⱼ on Γⱼ,
//! and B grows by 2πi qⱼ around Γⱼ. Every canonical map is B, or its exponential. The problem has one solution whatever the
//! region's size: with g = 0 and q = 0 the energy of ∫ log|x − y| σ is −2π Σ cⱼqⱼ = 0.
//!
//! The problems here are those where L − G vanishes outside an outer boundary (so that its constant is 0), and G continues into
//! holes: then σ is the normal derivative of B alone, and Im B falls by 2π ∫ σ along the boundary, the region to the left.

use super::panel::Boundary;
use crate::plane::Complex64;

/// A point of the boundary, held as a vertex and an offset from it, so that distances near the vertex keep their digits.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The panel that it lies on,
    pub panel: usize,
    /// and where.
    pub s: f64,
    /// The vertex.
    pub corner: usize,
    /// The point minus the vertex.
    pub offset: Complex64,
}

/// What is to be solved for.
#[derive(Clone, Debug)]
pub struct Problem {
    /// G.
    pub source: Source,
    /// qⱼ.
    pub charges: Vec<f64>,
}

/// The function G.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// 0.
    Nothing,
    /// log(z − a): what is solved for is harmonic measure seen from a.
    Log(Complex64),
    /// A factor times 1/(z − a).
    Pole(Complex64, Complex64),
    /// A factor times z.
    Stream(Complex64),
    /// i log((z − a)/(z − b)), continuous along each component.
    Vortices(Complex64, Complex64),
}

impl Problem {
    /// Harmonic measure seen from `center` (scaled units): the disk's map.
    #[must_use]
    pub fn measure(boundary: &Boundary, center: Complex64) -> Self {
        let mut charges = vec![0.0; boundary.loops.len()];
        charges[0] = 1.0;
        Self { source: Source::Log(center), charges }
    }

    /// Charges alone.
    #[must_use]
    pub fn charged(charges: Vec<f64>) -> Self {
        Self { source: Source::Nothing, charges }
    }
}

impl Source {
    /// g at points of the boundary.
    #[must_use]
    pub fn values(&self, boundary: &Boundary, targets: &[Target]) -> Vec<f64> {
        match *self {
            Self::Vortices(a, b) => {
                let at_vertices =
                    boundary.arguments(a).iter().zip(boundary.arguments(b)).map(|(a, b)| a - b).collect::<Vec<_>>();
                let along = |target: &Target, z: Complex64| {
                    let vertex = boundary.vertices[target.corner] - z;
                    ((vertex + target.offset) * vertex.conj()).arg()
                };
                targets.iter().map(|t| -(at_vertices[t.corner] + along(t, a) - along(t, b))).collect()
            }
            _ => targets.iter().map(|t| self.value_at(boundary.vertices[t.corner], t.offset)).collect(),
        }
    }

    /// g at a vertex plus an offset; of vortices, the principal value.
    #[must_use]
    pub fn value_at(&self, vertex: Complex64, offset: Complex64) -> f64 {
        let from = |z: Complex64| vertex - z + offset;
        match *self {
            Self::Nothing => 0.0,
            Self::Log(a) => 0.5 * from(a).norm_sqr().ln(),
            Self::Pole(a, factor) => (factor / from(a)).re,
            Self::Stream(factor) => (factor * from(Complex64::ZERO)).re,
            Self::Vortices(..) => self.at(vertex + offset).0.re,
        }
    }

    /// The sum of this and a multiple of another. Only of streams is it more than one of the two.
    #[must_use]
    pub fn and(self, other: Self, weight: f64) -> Self {
        match (self, other) {
            (sum, Self::Nothing) => sum,
            (Self::Nothing, Self::Stream(factor)) => Self::Stream(factor * weight),
            (Self::Stream(sum), Self::Stream(factor)) => Self::Stream(sum + factor * weight),
            (_, other) => other,
        }
    }

    /// Where in the region G is singular.
    #[must_use]
    pub fn singularities(&self) -> Vec<Complex64> {
        match *self {
            Self::Nothing | Self::Stream(_) => Vec::new(),
            Self::Log(a) | Self::Pole(a, _) => vec![a],
            Self::Vortices(a, b) => vec![a, b],
        }
    }

    /// What G is a logarithm of: the point and the factor.
    #[must_use]
    pub fn logarithm(&self) -> Option<(Complex64, f64)> {
        match *self {
            Self::Log(a) => Some((a, 1.0)),
            _ => None,
        }
    }

    /// (G, G') at a point of the region. The logarithms are principal ones.
    #[must_use]
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        match *self {
            Self::Nothing => (Complex64::ZERO, Complex64::ZERO),
            Self::Log(a) => ((z - a).ln(), (z - a).inv()),
            Self::Pole(a, factor) => (factor / (z - a), -factor / ((z - a) * (z - a))),
            Self::Stream(factor) => (factor * z, factor),
            Self::Vortices(a, b) => {
                let i = Complex64::i();
                (i * ((z - a) / (z - b)).ln(), i * ((z - a).inv() - (z - b).inv()))
            }
        }
    }
}
