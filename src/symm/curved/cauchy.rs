//! The map both ways by Cauchy's formula over the boundary, in barycentric form: f(z) = Σ f(y) δy/(y − z) / Σ δy/(y − z).
//!
//! A panel acts through 16 nodes where the target is far from it, through its halves where not. Halves are made when first asked
//! for, and kept.

use super::super::legendre::GaussRule;
use crate::plane::Complex64;
use std::sync::{Arc, OnceLock};

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

impl Sample {
    /// The node, its image and its weight for targets on a side.
    fn on(&self, side: Side) -> (Complex64, Complex64, Complex64) {
        match side {
            Side::Region => (self.z, self.w, self.dz),
            Side::Disk => (self.w, self.z, self.dw),
        }
    }
}

/// A part of a panel.
#[derive(Clone, Debug)]
pub struct CauchyPart {
    q: usize,
    from: f64,
    to: f64,
    samples: Vec<Sample>,
    /// Around the part in the region and in the disk.
    circles: [Circle; 2],
    halves: OnceLock<[Arc<CauchyPart>; 2]>,
}

/// How a circle sees a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// As a power series.
    Far,
    /// Its halves are to be asked.
    Large,
    /// Point by point.
    Near,
}

/// Around a part.
#[derive(Clone, Copy, Debug)]
struct Circle {
    middle: Complex64,
    radius: f64,
    /// As far from the middle the part is seen through its nodes.
    reach: f64,
}

/// The value, its derivative, and what the formula gives for the constant 1.
pub type Evaluated = (Complex64, Complex64, Complex64);

/// Where targets lie.
#[derive(Clone, Copy, Debug)]
pub enum Side {
    /// In the region.
    Region,
    /// In the disk.
    Disk,
}

/// Σ f(y) δy/(y − z) above, Σ δy/(y − z) below, and their derivatives.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    /// The first,
    pub above: Complex64,
    /// the second,
    pub below: Complex64,
    /// and by z.
    pub above_slope: Complex64,
    /// The same.
    pub below_slope: Complex64,
}

impl Sums {
    /// Their quotient.
    #[must_use]
    pub fn evaluated(&self) -> Evaluated {
        let value = self.above / self.below;
        (value, (self.above_slope - value * self.below_slope) / self.below, self.below)
    }
}

/// Nodes of a part.
const NODES: usize = 16;
/// Halvings after which a target is on the boundary.
const MOST_HALVINGS: usize = 40;
/// Parts are not halved below this share of a panel's τ.
const SHORTEST: f64 = 1e-12;
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
pub fn parts(solution: &dyn Sampled, panels: usize) -> Vec<Arc<CauchyPart>> {
    (0..panels).map(|q| Arc::new(CauchyPart::new(solution, gauss(), q, 0.0, 1.0))).collect()
}

/// The parts in halves, so small that what is singular at some points off the boundary is smooth on them.
#[must_use]
pub fn resolved(solution: &dyn Sampled, parts: Vec<Arc<CauchyPart>>, points: &[Complex64]) -> Vec<Arc<CauchyPart>> {
    let (mut open, mut done) = (parts, Vec::new());
    open.reverse();
    while let Some(part) = open.pop() {
        let Circle { middle, reach, .. } = part.circles[Side::Region as usize];
        let is_smooth = points.iter().all(|point| (point - middle).norm() >= reach);
        if is_smooth || part.to - part.from <= SHORTEST {
            done.push(part);
        } else {
            open.extend(part.halves(solution).iter().rev().cloned());
        }
    }
    done
}

/// The rule of all parts.
fn gauss() -> &'static GaussRule {
    static RULE: OnceLock<GaussRule> = OnceLock::new();
    RULE.get_or_init(|| GaussRule::new(NODES))
}

/// f(z) and f'(z) by parts.
#[must_use]
pub fn to_disk(solution: &dyn Sampled, parts: &[Arc<CauchyPart>], z: Complex64) -> Option<Evaluated> {
    evaluated(solution, parts, z, Side::Region)
}

/// The inverse of f, and its derivative.
#[must_use]
pub fn from_disk(solution: &dyn Sampled, parts: &[Arc<CauchyPart>], w: Complex64) -> Option<Evaluated> {
    evaluated(solution, parts, w, Side::Disk)
}

fn evaluated(solution: &dyn Sampled, parts: &[Arc<CauchyPart>], target: Complex64, side: Side) -> Option<Evaluated> {
    sums_from(Sums::default(), solution, parts, target, side).map(|sums| sums.evaluated())
}

/// The sums with what the parts add; `None` if the target is on one.
#[must_use]
pub fn sums_from(
    mut sums: Sums,
    solution: &dyn Sampled,
    parts: &[Arc<CauchyPart>],
    target: Complex64,
    side: Side,
) -> Option<Sums> {
    parts.iter().all(|part| part.add(solution, target, side, 0, &mut sums)).then_some(sums)
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
            let radius = all.map(|sample| (at(sample) - middle).norm()).fold(0.0, f64::max);
            Circle { middle, radius, reach: reach * radius }
        };
        let circles = [circle(|sample| sample.z, reach(exponent)), circle(|sample| sample.w, reach(power))];
        Self { q, from, to, samples, circles, halves: OnceLock::new() }
    }

    /// Adds what the part contributes; false if the target is on it.
    fn add(&self, solution: &dyn Sampled, target: Complex64, side: Side, depth: usize, sums: &mut Sums) -> bool {
        let Circle { middle, reach, .. } = self.circles[side as usize];
        if (target - middle).norm_sqr() >= reach * reach {
            for sample in &self.samples {
                let (at, value, weight) = sample.on(side);
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
        self.halves(solution).iter().all(|half| half.add(solution, target, side, depth + 1, sums))
    }

    /// Its halves, in τ.
    #[must_use]
    pub fn halves(&self, solution: &dyn Sampled) -> &[Arc<Self>; 2] {
        self.halves.get_or_init(|| {
            let middle = 0.5 * (self.from + self.to);
            [(self.from, middle), (middle, self.to)]
                .map(|(from, to)| Arc::new(Self::new(solution, gauss(), self.q, from, to)))
        })
    }

    /// How all targets in a circle see the part; its sums are a power series there if it lies `away` of the circle's radii away.
    #[must_use]
    pub fn seen(&self, side: Side, (center, radius): (Complex64, f64), away: f64) -> Seen {
        let own = self.circles[side as usize];
        let distance = (own.middle - center).norm();
        let is_away = distance - own.radius >= away * radius;
        if is_away && distance - radius >= own.reach {
            Seen::Far
        } else if (is_away || own.radius > radius) && self.to - self.from > SHORTEST {
            Seen::Large
        } else {
            Seen::Near
        }
    }

    /// Adds its sums, as series in (z − center)/radius: what is above, and what is below.
    pub fn add_series(&self, side: Side, (center, radius): (Complex64, f64), series: &mut [Vec<Complex64>; 2]) {
        let [above, below] = series;
        for sample in &self.samples {
            let (at, value, weight) = sample.on(side);
            let inverse = (at - center).inv();
            let (mut term, step) = (weight * inverse, radius * inverse);
            for (a, b) in above.iter_mut().zip(below.iter_mut()) {
                *a += value * term;
                *b += term;
                term *= step;
            }
        }
    }
}
