//! Where the branch of B that direct summation gives jumps.

use crate::plane::Complex64;
use std::f64::consts::TAU;

/// Rays that run to the left, each from a point around which B grows by 2πi times a charge, which of L's is real.
#[derive(Clone, Debug, Default)]
pub struct Cuts(Vec<(Complex64, Complex64)>);

impl Cuts {
    /// From points and charges; what has no charge has no cut.
    #[must_use]
    pub fn new(mut points: Vec<(Complex64, Complex64)>) -> Self {
        points.retain(|(_, charge)| *charge != Complex64::ZERO);
        Self(points)
    }

    /// What B grows by with so many turns around each point.
    fn growth(&self, turns: &dyn Fn(&Complex64) -> f64) -> Complex64 {
        let sum: Complex64 = self.0.iter().map(|(point, charge)| charge * turns(point)).sum();
        Complex64::new(0.0, TAU) * sum
    }

    /// By how much B jumps on the straight way between two points, over what it changes by.
    #[must_use]
    pub fn jump(&self, from: Complex64, to: Complex64) -> Complex64 {
        let turns = |point: &Complex64| {
            let (a, b) = (from - point, to - point);
            // As the argument has it: 0 belongs to what lies above.
            if (a.im < 0.0) == (b.im < 0.0) || a.re + (b.re - a.re) * (a.im / (a.im - b.im)) >= 0.0 {
                return 0.0;
            }
            if b.im < 0.0 { -1.0 } else { 1.0 }
        };
        self.growth(&turns)
    }

    /// By how much B differs at `z` from what is continuous but for one cut, with all the charge, to the left of `middle`,
    /// and comes to the same far away.
    #[must_use]
    pub fn differing(&self, middle: Complex64, z: Complex64) -> Complex64 {
        let from = z - middle;
        let turns = |point: &Complex64| {
            let own = z - point;
            ((own.arg() - from.arg() - (own / from).arg()) / TAU).round()
        };
        self.growth(&turns)
    }
}
