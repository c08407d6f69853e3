//! The map both ways by Cauchy's formula over the boundary, in barycentric form: f(z) = Σ f(y) δy/(y − z) / Σ δy/(y − z).
//!
//! A panel acts through 16 nodes where the target is far from it, through its halves where not. Halves are made when first asked
//! for, and kept.

use super::legendre::GaussRule;
use crate::plane::Complex64;
use std::sync::OnceLock;

/// A solved boundary, panel by panel.
pub trait Sampled {
    /// The boundary at τ of panel `q`, with weights for the step `dtau` there.
    fn sample(&self, q: usize, tau: f64, dtau: f64) -> Sample;

    /// The powers of τ that z and f begin with on panel `q`.
    fn exponents(&self, q: usize) -> (f64, f64);
}

/// One node.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// The boundary point.
    pub z: Complex64,
    /// Its image on the circle.
    pub w: Complex64,
    /// Weight in ∮ dz/2πi.
    pub dz: Complex64,
    /// Weight in ∮ dw/2πi.
    pub dw: Complex64,
}

/// A part of a panel.
#[derive(Clone, Debug)]
pub struct CauchyPart {
    q: usize,
    from: f64,
    to: f64,
    samples: Vec<Sample>,
    /// Middle and radius of the part in the region and in the disk, the radius times how far it is to be seen through its nodes.
    circles: [(Complex64, f64); 2],
    halves: OnceLock<Box<[CauchyPart; 2]>>,
}

/// The value, its derivative, and what the formula gives for the constant 1.
pub type Evaluated = (Complex64, Complex64, Complex64);

#[derive(Clone, Copy, Debug)]
enum Side {
    Region,
    Disk,
}

#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    above: Complex64,
    below: Complex64,
    above_slope: Complex64,
    below_slope: Complex64,
}

/// Nodes of a part.
const NODES: usize = 16;
/// Halvings after which a target is on the boundary.
const MOST_HALVINGS: usize = 40;
/// Parts serve targets at this distance, in their radii, with full digits: in the variable, Bernstein's ρ is 3.7 there.
const FAR: f64 = 2.0;
/// The same where the panel has a corner variable, of which nodes are dense at one end.
const FAR_GRADED: f64 = 4.0;
/// At a corner the variable's power is at least this.
const SMOOTH_POWER: f64 = 8.0;
/// Where the variable is τ ≤ 1 at a corner, ρ = 3.7 at τ = this.
const BEYOND_CORNER: f64 = 1.5;

/// The panels as they are seen from far.
#[must_use]
pub fn parts(solution: &dyn Sampled, panels: usize) -> Vec<CauchyPart> {
    let gauss = GaussRule::new(NODES);
    (0..panels).map(|q| CauchyPart::new(solution, &gauss, q, 0.0, 1.0)).collect()
}

/// f(z) and f'(z) by parts.
#[must_use]
pub fn to_disk(solution: &dyn Sampled, parts: &[CauchyPart], z: Complex64) -> Option<Evaluated> {
    evaluated(solution, parts, z, Side::Region)
}

/// The inverse of f, and its derivative.
#[must_use]
pub fn from_disk(solution: &dyn Sampled, parts: &[CauchyPart], w: Complex64) -> Option<Evaluated> {
    evaluated(solution, parts, w, Side::Disk)
}

fn evaluated(solution: &dyn Sampled, parts: &[CauchyPart], target: Complex64, side: Side) -> Option<Evaluated> {
    let mut sums = Sums::default();
    for part in parts {
        if !part.add(solution, target, side, 0, &mut sums) {
            return None;
        }
    }
    let value = sums.above / sums.below;
    Some((value, (sums.above_slope - value * sums.below_slope) / sums.below, sums.below))
}

impl CauchyPart {
    fn new(solution: &dyn Sampled, gauss: &GaussRule, q: usize, from: f64, to: f64) -> Self {
        let (exponent, power) = solution.exponents(q);
        let graded = exponent != 1.0 || power != 1.0;
        // At a corner fractional powers of τ are taken for whole ones of its root.
        let root = if graded && from == 0.0 { (SMOOTH_POWER / exponent).ceil().max(1.0) } else { 1.0 };
        let sample = |(t, w): (&f64, &f64)| {
            let share = 0.5 * (1.0 + t);
            let below = (to - from) * share.powf(root - 1.0);
            solution.sample(q, from + below * share, 0.5 * w * root * below)
        };
        let samples: Vec<Sample> = gauss.nodes.iter().zip(&gauss.weights).map(sample).collect();
        let reach = |power: f64| match (graded, from == 0.0) {
            (false, _) => FAR,
            (true, true) => FAR_GRADED.max(2.0 * BEYOND_CORNER.powf(power * root) - 1.0),
            (true, false) => FAR_GRADED,
        };
        let ends = [solution.sample(q, from, 0.0), solution.sample(q, to, 0.0)];
        let circle = |at: fn(&Sample) -> Complex64, reach: f64| {
            let middle = 0.5 * (at(&ends[0]) + at(&ends[1]));
            let all = samples.iter().chain(&ends);
            (middle, reach * all.map(|sample| (at(sample) - middle).norm()).fold(0.0, f64::max))
        };
        let circles = [circle(|sample| sample.z, reach(exponent)), circle(|sample| sample.w, reach(power))];
        Self { q, from, to, samples, circles, halves: OnceLock::new() }
    }

    /// Adds what the part contributes; false if the target is on it.
    fn add(&self, solution: &dyn Sampled, target: Complex64, side: Side, depth: usize, sums: &mut Sums) -> bool {
        let (middle, reach) = self.circles[side as usize];
        if (target - middle).norm_sqr() >= reach * reach {
            for sample in &self.samples {
                let (at, value, weight) = match side {
                    Side::Region => (sample.z, sample.w, sample.dz),
                    Side::Disk => (sample.w, sample.z, sample.dw),
                };
                let inverse = (at - target).inv();
                let weight = weight * inverse;
                sums.above += value * weight;
                sums.below += weight;
                let weight = weight * inverse;
                sums.above_slope += value * weight;
                sums.below_slope += weight;
            }
            return true;
        }
        if depth == MOST_HALVINGS {
            return false;
        }
        let halves = self.halves.get_or_init(|| {
            let gauss = GaussRule::new(NODES);
            let middle = 0.5 * (self.from + self.to);
            let part = |from: f64, to: f64| Self::new(solution, &gauss, self.q, from, to);
            Box::new([part(self.from, middle), part(middle, self.to)])
        });
        halves.iter().all(|half| half.add(solution, target, side, depth + 1, sums))
    }
}
