//! Cauchy's formula for a million targets: what is far of a square is a power series there, what is near is summed.
//!
//! A square takes over its parent's series and what was near it; squares are decided when a target in them is first asked for.

use super::atlas::power_series::{Series, value_and_slope};
use super::lazy_tree::{Decision, LazyTree, Square};
use crate::Result;
use crate::plane::Complex64;
use crate::symm::curved::cauchy::{CauchyPart, Evaluated, Sampled, Seen, Side, Sums, sums_from};
use crate::symm::multipole::shift_series;
use crate::symm::options::Progress;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

/// Squares around all targets of one side.
#[derive(Debug)]
pub(super) struct CauchyTree {
    tree: LazyTree<FarAndNear, Leaf>,
    side: Side,
    least_level: u32,
}

/// Series of what is far, and the parts that are not: also what a square hands on to its quarters.
#[derive(Clone, Debug)]
pub(super) struct FarAndNear {
    far: Arc<FarSeries>,
    near: Arc<[Arc<CauchyPart>]>,
}

/// The sums of what is far, as series in (z − center)/radius: above and below.
#[derive(Debug)]
struct FarSeries {
    center: Complex64,
    radius: f64,
    series: [Vec<Complex64>; 2],
}

/// What is known in a square.
#[derive(Debug)]
pub(super) enum Leaf {
    /// The map.
    Series(Series),
    /// Both sums, but for what is near.
    Near(FarAndNear),
    /// The boundary does not go around it.
    Outside,
}

/// Series are of what lies this many radii away: terms fall like its powers.
const AWAY: f64 = 2.2;
/// The parts that are summed for every target of a square are at most so many,
const MOST_NEAR: usize = 10;
/// and the square is so small that few targets lie in squares at the boundary;
const LEAST_LEVEL: u32 = 8;
/// or less small where series may err by so much: rough maps are asked for few targets.
const LEAST_LEVEL_ROUGHLY: u32 = 5;
const ROUGHLY: f64 = 1e-8;
/// but never smaller than this.
const DEEPEST: u32 = 24;

impl CauchyTree {
    /// Nothing decided yet: the square around all targets, what the sums below are `around` the boundary, and series good to a
    /// tolerance.
    #[must_use]
    pub fn new(
        (center, half): (Complex64, f64),
        side: Side,
        parts: &[Arc<CauchyPart>],
        around: Complex64,
        tolerance: f64,
    ) -> Self {
        let terms = (-tolerance.ln() / AWAY.ln()).ceil() as usize;
        let mut series = [vec![Complex64::ZERO; terms], vec![Complex64::ZERO; terms]];
        series[1][0] = around;
        let far = FarSeries { center, radius: half * SQRT_2, series };
        let known = FarAndNear { far: Arc::new(far), near: parts.into() };
        let least_level = if tolerance > ROUGHLY { LEAST_LEVEL_ROUGHLY } else { LEAST_LEVEL };
        Self { tree: LazyTree::new(center, half, known), side, least_level }
    }

    /// What is known where a target lies; `None` beyond all squares.
    #[inline]
    #[must_use]
    pub fn find(&self, target: Complex64, solution: &dyn Sampled) -> Option<&Leaf> {
        self.tree.find(target, &|square, known| self.decide(solution, square, known))
    }

    /// Decides all squares.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was decided by then is kept.
    pub fn fill(&self, solution: &dyn Sampled, progress: Progress) -> Result<()> {
        self.tree.fill("expand", &|square, known| self.decide(solution, square, known), progress)
    }

    /// The value, its derivative, and what the sums below give for 1; `None` if the target is on the boundary.
    #[must_use]
    pub fn near(
        &self,
        FarAndNear { far, near }: &FarAndNear,
        target: Complex64,
        solution: &dyn Sampled,
    ) -> Option<Evaluated> {
        let [(above, above_slope), (below, below_slope)] =
            [0, 1].map(|k| value_and_slope(&far.series[k], (target - far.center) / far.radius));
        let (above_slope, below_slope) = (above_slope / far.radius, below_slope / far.radius);
        let sums = Sums { above, below, above_slope, below_slope };
        sums_from(sums, solution, near, target, self.side).map(|sums| sums.evaluated())
    }

    fn decide(&self, solution: &dyn Sampled, square: &Square, known: &FarAndNear) -> Decision<FarAndNear, Leaf> {
        let circle = (square.center, square.half * SQRT_2);
        let mut far = known.far.moved(circle);
        let mut near = Vec::new();
        let mut open: Vec<&Arc<CauchyPart>> = known.near.iter().rev().collect();
        while let Some(part) = open.pop() {
            match part.seen(self.side, circle, AWAY) {
                Seen::Far => part.add_series(self.side, circle, &mut far.series),
                Seen::Near => near.push(Arc::clone(part)),
                Seen::Large => {
                    let [first, second] = part.halves(solution);
                    open.extend([second, first]);
                }
            }
        }
        if near.is_empty() {
            return Decision::Leaf(far.quotient().map_or(Leaf::Outside, Leaf::Series));
        }
        let is_last = near.len() <= MOST_NEAR && square.level >= self.least_level || square.level >= DEEPEST;
        let known = FarAndNear { far: Arc::new(far), near: near.into() };
        if is_last { Decision::Leaf(Leaf::Near(known)) } else { Decision::Split(known) }
    }
}

impl FarSeries {
    /// The same in a smaller circle.
    fn moved(&self, (center, radius): (Complex64, f64)) -> Self {
        let (shift, shrink) = ((center - self.center) / self.radius, radius / self.radius);
        let series = self.series.each_ref().map(|series| shift_series(series.clone(), shift, shrink));
        Self { center, radius, series }
    }

    /// What is above over what is below, unless that is about 0, as outside the boundary.
    fn quotient(&self) -> Option<Series> {
        let [above, below] = &self.series;
        let is_inside = (below[0] - 1.0).norm() < 0.5;
        if !is_inside {
            return None;
        }
        let scale = below[0].inv();
        let mut coefficients: Vec<Complex64> = Vec::with_capacity(above.len());
        for k in 0..above.len() {
            let rest: Complex64 = (1..=k).map(|j| below[j] * coefficients[k - j]).sum();
            coefficients.push((above[k] - rest) * scale);
        }
        Some(Series { center: self.center, radius: self.radius, coefficients: coefficients.into() })
    }
}
