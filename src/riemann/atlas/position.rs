//! Where a chart's center lies in the hyperbolic plane, and how it is turned there: in polar form, which stays accurate
//! where the numbers of the disk crowd together.

use super::link::Link;
use crate::plane::Complex64;

/// An automorphism of the disk that takes one chart to the first: turn by `turn`, move by the hyperbolic `distance` along
/// the real axis, turn by `direction`.
///
/// Far away, directions have to be known far better than to 1e-16: at distance d, to e^−d.
#[derive(Clone, Debug)]
pub struct Position {
    distance: f64,
    direction: Angle,
    turn: f64,
}

impl Position {
    /// The first chart's own.
    pub const FIRST: Self = Self { distance: 0.0, direction: Angle::ZERO, turn: 0.0 };

    /// The position of a chart whose center lies at `there` in this one's disk, this one's at `back` in its.
    #[must_use]
    pub fn next(&self, there: Complex64, back: Complex64) -> Self {
        // Hyperbolic trigonometry in the triangle of the three centers.
        let step = 2.0 * there.norm().atanh();
        let (sin, cos) = (self.turn + there.arg()).sin_cos();
        let (far, near) = (self.distance, step);
        let ahead = near.sinh() * cos * far.cosh() + far.sinh() * near.cosh();
        let aside = near.sinh() * sin;
        let turned = (far.sinh() * sin).atan2(far.cosh() * near.sinh() + far.sinh() * near.cosh() * cos);
        Self {
            distance: ahead.hypot(aside).asinh(),
            direction: self.direction.plus(aside.atan2(ahead)),
            turn: turned - (-back).arg(),
        }
    }

    /// This chart → another of the same region.
    #[must_use]
    pub fn link_to(&self, to: &Self) -> Link {
        self.passage(to, &Angle::ZERO)
    }

    /// The direction in which the first chart sees the point e^(i·`angle`) of this chart's circle.
    #[must_use]
    pub fn direction_of(&self, angle: f64) -> Angle {
        let half = 0.5 * (self.turn + angle);
        self.direction.plus(2.0 * ((-self.distance).exp() * half.sin()).atan2(half.cos()))
    }

    /// By how much errors of directions around the first chart's center grow at this one's, that of `toward` being exact:
    /// e^h, h the hyperbolic distance from the ray toward it.
    #[must_use]
    pub fn growth(&self, toward: &Angle) -> f64 {
        let (sin, cos) = self.direction.minus(toward).value().sin_cos();
        let aside = if cos > 0.0 { sin.abs() } else { 1.0 };
        // Of what lies on the ray nothing grows, be it ever so far.
        let apart = if aside == 0.0 { 0.0 } else { aside * self.distance.sinh() };
        apart + apart.hypot(1.0)
    }

    /// This chart → the chart of `to`, which may belong to another region, whose disk is turned by `turn`:
    /// direction in it = direction here + `turn`.
    #[must_use]
    pub fn passage(&self, to: &Self, turn: &Angle) -> Link {
        let (sin, cos) = (0.5 * self.direction.minus(&to.direction.minus(turn)).value()).sin_cos();
        let (apart, both) = (0.5 * (self.distance - to.distance), 0.5 * (self.distance + to.distance));
        let a = Complex64::new(cos * apart.cosh(), sin * both.cosh());
        let b = Complex64::new(cos * apart.sinh(), sin * both.sinh());
        Link::from_matrix(
            a * Complex64::cis(0.5 * (self.turn - to.turn)),
            b * Complex64::cis(-0.5 * (self.turn + to.turn)),
        )
    }
}

/// An angle (radians) as the exact sum of some numbers, none of which overlap.
#[derive(Clone, Debug, Default)]
pub struct Angle(Vec<f64>);

impl Angle {
    const ZERO: Self = Self(Vec::new());

    /// The exact sum (Shewchuk 1997, “Grow-Expansion”).
    fn plus(&self, angle: f64) -> Self {
        let mut sum = angle;
        let mut parts = Vec::with_capacity(self.0.len() + 1);
        for part in &self.0 {
            let total = sum + part;
            let taken = total - sum;
            let error = (sum - (total - taken)) + (part - taken);
            if error != 0.0 {
                parts.push(error);
            }
            sum = total;
        }
        parts.push(sum);
        Self(parts)
    }

    /// The exact difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        other.0.iter().fold(self.clone(), |sum, part| sum.plus(-part))
    }

    /// The position as one number.
    fn value(&self) -> f64 {
        self.0.iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_compose_like_matrices() {
        let (there, back) = (Complex64::from_polar(0.8, 1.1), Complex64::from_polar(0.8, -2.0));
        let (there2, back2) = (Complex64::from_polar(0.7, -0.4), Complex64::from_polar(0.7, 2.7));
        let first = Position::FIRST.next(there, back);
        let second = first.next(there2, back2);
        // Matrices: chart → first chart.
        let to_first = Link::new(there, back).inverse();
        let from_second = to_first.after(&Link::new(there2, back2).inverse());
        for w in [Complex64::new(0.3, -0.6), Complex64::cis(2.2), Complex64::ZERO] {
            let by_positions = second.passage(&Position::FIRST, &Angle::ZERO).apply(w);
            assert!((by_positions - from_second.apply(w)).norm() < 1e-14, "{w}: {by_positions}");
            let between = second.passage(&first, &Angle::ZERO).apply(w);
            assert!((between - Link::new(there2, back2).inverse().apply(w)).norm() < 1e-13, "{w}: {between}");
        }
        let seen = second.direction_of(0.9);
        let exact = from_second.apply(Complex64::cis(0.9)).arg();
        assert!(seen.plus(-exact).value().abs() < 1e-14);
    }

    #[test]
    fn errors_grow_with_the_distance_from_the_ray_toward() {
        let there = Complex64::from_polar(0.9999, 0.4);
        let position = Position::FIRST.next(there, -there);
        let distance = 2.0 * 0.9999f64.atanh();
        let growth = |angle| position.growth(&Angle::ZERO.plus(angle));
        assert!((growth(0.4) - 1.0).abs() < 1e-9, "{}", growth(0.4));
        for behind in [0.4 + std::f64::consts::PI, 0.4 - 2.0] {
            assert!((growth(behind) / distance.exp() - 1.0).abs() < 1e-9, "{}", growth(behind));
        }
        // A right angle from the ray, a leg of the triangle: sinh h = sinh d sin θ.
        let h = (distance.sinh() * 0.1f64.sin()).asinh();
        assert!((growth(0.5) / h.exp() - 1.0).abs() < 1e-9, "{}", growth(0.5));
    }

    /// Two chains of twenty steps to a hyperbolic distance of about 60 that differ in the last step only.
    #[test]
    fn far_charts_are_told_apart() {
        let link = |k: f64, angle: f64| (Complex64::from_polar(0.9, angle), Complex64::from_polar(0.9, 2.0 + k));
        let mut far = Position::FIRST;
        for k in 0..20 {
            let (there, back) = link(f64::from(k), (-back_of(f64::from(k) - 1.0)).arg() + 0.1);
            far = far.next(there, back);
        }
        let (there, back) = link(20.0, 0.7);
        let last = far.next(there, back);
        assert!(last.distance > 45.0);
        let passage = last.passage(&far, &Angle::ZERO);
        let exact = Link::new(there, back).inverse();
        for w in [Complex64::new(0.3, -0.6), Complex64::cis(2.2), Complex64::ZERO] {
            assert!((passage.apply(w) - exact.apply(w)).norm() < 1e-12, "{} {}", passage.apply(w), exact.apply(w));
        }
        let same = last.passage(&last, &Angle::ZERO);
        assert_eq!(same.apply(Complex64::new(0.25, 0.5)), Complex64::new(0.25, 0.5));
    }

    /// Where the parent of step k lies.
    fn back_of(k: f64) -> Complex64 {
        Complex64::from_polar(0.9, 2.0 + k)
    }
}
