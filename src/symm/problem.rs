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
use std::f64::consts::TAU;

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

/// The function G = az + Σ pₖ/(z − aₖ) + Σ fₖ log(z − aₖ). Where a logarithm's factor is not real, g takes its argument, which is
/// continuous along each component: none may be around one such point alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Source {
    /// a.
    pub stream: Complex64,
    /// aₖ and pₖ.
    pub poles: Vec<(Complex64, Complex64)>,
    /// aₖ and fₖ.
    pub logs: Vec<(Complex64, Complex64)>,
}

impl Problem {
    /// Harmonic measure seen from `center` (scaled units): the disk's map.
    #[must_use]
    pub fn measure(boundary: &Boundary, center: Complex64) -> Self {
        let mut charges = vec![0.0; boundary.loops.len()];
        charges[0] = 1.0;
        Self { source: Source::log(center), charges }
    }

    /// Charges alone.
    #[must_use]
    pub fn charged(charges: Vec<f64>) -> Self {
        Self { source: Source::default(), charges }
    }
}

impl Source {
    /// log(z − a): what is solved for is harmonic measure seen from a.
    #[must_use]
    pub fn log(a: Complex64) -> Self {
        Self::logs(vec![(a, Complex64::ONE)])
    }

    /// Points and the factors of their logarithms.
    #[must_use]
    pub fn logs(logs: Vec<(Complex64, Complex64)>) -> Self {
        Self { logs, ..Self::default() }
    }

    /// A factor times 1/(z − a).
    #[must_use]
    pub fn pole(a: Complex64, factor: Complex64) -> Self {
        Self { poles: vec![(a, factor)], ..Self::default() }
    }

    /// A factor times z.
    #[must_use]
    pub fn stream(factor: Complex64) -> Self {
        Self { stream: factor, ..Self::default() }
    }

    /// i log((z − a)/(z − b)).
    #[must_use]
    pub fn vortices(a: Complex64, b: Complex64) -> Self {
        Self::logs(vec![(a, Complex64::i()), (b, -Complex64::i())])
    }

    /// The logarithms whose arguments g takes, with the factors of these.
    pub fn turning(&self) -> impl Iterator<Item = (Complex64, f64)> + '_ {
        self.logs.iter().filter(|(_, factor)| factor.im != 0.0).map(|(a, factor)| (*a, -factor.im))
    }

    /// g at points of the boundary.
    #[must_use]
    pub fn values(&self, boundary: &Boundary, targets: &[Target]) -> Vec<f64> {
        let value = |t: &Target| self.level_at(boundary.vertices[t.corner], t.offset);
        let mut values: Vec<f64> = targets.iter().map(value).collect();
        for (a, factor) in self.turning() {
            let at_vertices = boundary.arguments(a);
            for (value, t) in values.iter_mut().zip(targets) {
                let vertex = boundary.vertices[t.corner] - a;
                *value += factor * (at_vertices[t.corner] + ((vertex + t.offset) * vertex.conj()).arg());
            }
        }
        values
    }

    /// What takes B with arguments of the turning logarithms that are `along` in their order to B with principal ones at a point.
    #[must_use]
    pub fn turn(&self, z: Complex64, along: &dyn Fn(usize, Complex64) -> f64) -> f64 {
        let turn = |(k, (a, factor)): (usize, (Complex64, f64))| factor * whole_turns(along(k, a) - (z - a).arg());
        self.turning().enumerate().map(turn).sum()
    }

    /// What g is at a vertex plus an offset without its arguments.
    #[must_use]
    pub fn level_at(&self, vertex: Complex64, offset: Complex64) -> f64 {
        let from = |z: &Complex64| vertex - z + offset;
        let mut level = (self.stream * (vertex + offset)).re;
        for (a, factor) in &self.logs {
            level += factor.re * (0.5 * from(a).norm_sqr().ln());
        }
        for (a, factor) in &self.poles {
            level += (factor / from(a)).re;
        }
        level
    }

    /// The sum of this and a multiple of another.
    #[must_use]
    pub fn and(mut self, other: &Self, weight: f64) -> Self {
        self.stream += other.stream * weight;
        self.poles.extend(other.poles.iter().map(|(a, factor)| (*a, factor * weight)));
        for (a, factor) in &other.logs {
            match self.logs.iter_mut().find(|(there, _)| there == a) {
                Some((_, sum)) => *sum += factor * weight,
                None => self.logs.push((*a, factor * weight)),
            }
        }
        self
    }

    /// Where in the region G is singular.
    #[inline(never)]
    #[must_use]
    pub fn singularities(&self) -> Vec<Complex64> {
        let mut points = Vec::with_capacity(self.poles.len() + self.logs.len());
        for list in [&self.poles, &self.logs] {
            points.extend(list.iter().map(|(a, _)| *a));
        }
        points
    }

    /// (G, G') at a point of the region. The logarithms are principal ones.
    #[inline(never)]
    #[must_use]
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        let (mut value, mut slope) = (self.stream * z, self.stream);
        for (a, factor) in &self.poles {
            let share = factor / (z - a);
            value += share;
            slope -= share / (z - a);
        }
        for (a, factor) in &self.logs {
            value += factor * (z - a).ln();
            slope += factor / (z - a);
        }
        (value, slope)
    }
}

/// A multiple of 2π up to rounding.
#[must_use]
pub fn whole_turns(angle: f64) -> f64 {
    TAU * (angle / TAU).round()
}
