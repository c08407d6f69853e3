//! One analytic piece of a boundary: a line, an arc of a circle or an ellipse, a quadratic or cubic Bézier curve.

use super::Complex64;
use super::elliptic_arc::{ArcTo, EllipticArc};

/// A curve z(t), t from 0 to 1, analytic there and continued to complex t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// z = from + (to − from)·t.
    Line {
        /// z(0).
        from: Complex64,
        /// z(1).
        to: Complex64,
    },
    /// Part of an ellipse.
    Arc(EllipticArc),
    /// A quadratic Bézier curve by its three control points.
    Quadratic([Complex64; 3]),
    /// A cubic Bézier curve by its four control points.
    Cubic([Complex64; 4]),
}

/// Control points nearer to an end than this share of the curve's size do not tell its direction there.
const COINCIDENT: f64 = 1e-9;
/// Steps of Newton's method.
const STEPS: usize = 30;

impl Edge {
    /// A straight edge.
    #[must_use]
    pub fn line(from: Complex64, to: Complex64) -> Self {
        Self::Line { from, to }
    }

    /// An arc of a circle around `center` from angle `start` to `start` + `sweep`, in radians.
    #[must_use]
    pub fn circular(center: Complex64, radius: f64, start: f64, sweep: f64) -> Self {
        Self::Arc(EllipticArc::new(center, radius.into(), Complex64::new(0.0, radius), start, sweep))
    }

    /// An arc of an ellipse between two points, as SVG describes it; a line where a radius is 0. Where the radii are too small
    /// to reach, the ellipse is enlarged, as SVG's rules say.
    #[must_use]
    pub fn arc_to(from: Complex64, to: Complex64, arc: ArcTo) -> Self {
        if arc.radii.0 == 0.0 || arc.radii.1 == 0.0 || from == to {
            return Self::line(from, to);
        }
        Self::Arc(EllipticArc::drawn_to(from, to, arc))
    }

    /// z(0).
    #[must_use]
    pub fn from(&self) -> Complex64 {
        match self {
            Self::Line { from, .. } => *from,
            Self::Arc(arc) => arc.from(),
            Self::Quadratic(b) => b[0],
            Self::Cubic(b) => b[0],
        }
    }

    /// z(1).
    #[must_use]
    pub fn to(&self) -> Complex64 {
        match self {
            Self::Line { to, .. } => *to,
            Self::Arc(arc) => arc.to(),
            Self::Quadratic(b) => b[2],
            Self::Cubic(b) => b[3],
        }
    }

    /// z(t), exactly the ends at 0 and 1.
    #[must_use]
    #[inline(never)]
    pub fn point(&self, t: f64) -> Complex64 {
        if t < 0.5 {
            self.from() + self.from_start(t.into())
        } else {
            self.to() + self.reversed().from_start((1.0 - t).into())
        }
    }

    /// z(t) − z(0), its rounding error relative to itself.
    #[must_use]
    pub fn from_start(&self, t: Complex64) -> Complex64 {
        t * self.chord(Complex64::ZERO, t)
    }

    /// (z(t) − z(s))/(t − s), without cancellation; z'(t) where s = t.
    #[must_use]
    #[inline(never)]
    pub fn chord(&self, s: Complex64, t: Complex64) -> Complex64 {
        match self {
            Self::Line { from, to } => to - from,
            Self::Arc(arc) => arc.chord(s, t),
            Self::Quadratic(_) | Self::Cubic(_) => {
                let [c1, c2, c3] = self.powers();
                c1 + c2 * (s + t) + c3 * (s * s + s * t + t * t)
            }
        }
    }

    /// The derivative of [`Edge::chord`] by t.
    #[must_use]
    pub fn chord_slope(&self, s: Complex64, t: Complex64) -> Complex64 {
        match self {
            Self::Line { .. } => Complex64::ZERO,
            Self::Arc(arc) => arc.chord_slope(s, t),
            Self::Quadratic(_) | Self::Cubic(_) => {
                let [_, c2, c3] = self.powers();
                c2 + c3 * (s + 2.0 * t)
            }
        }
    }

    /// z'(t).
    #[must_use]
    #[inline(never)]
    pub fn tangent(&self, t: Complex64) -> Complex64 {
        match self {
            Self::Line { from, to } => to - from,
            Self::Arc(arc) => arc.tangent(t),
            Self::Quadratic(_) | Self::Cubic(_) => {
                let [c1, c2, c3] = self.powers();
                c1 + t * (2.0 * c2 + 3.0 * t * c3)
            }
        }
    }

    /// z''(t).
    #[must_use]
    #[inline(never)]
    pub fn bend(&self, t: Complex64) -> Complex64 {
        match self {
            Self::Line { .. } => Complex64::ZERO,
            Self::Arc(arc) => arc.bend(t),
            Self::Quadratic(_) | Self::Cubic(_) => {
                let [_, c2, c3] = self.powers();
                2.0 * c2 + 6.0 * t * c3
            }
        }
    }

    /// c₁, c₂, c₃ of z(t) − z(0) = c₁t + c₂t² + c₃t³ for polynomial edges.
    fn powers(&self) -> [Complex64; 3] {
        match self {
            Self::Line { from, to } => [to - from, Complex64::ZERO, Complex64::ZERO],
            Self::Quadratic([a, b, c]) => [2.0 * (b - a), (c - b) - (b - a), Complex64::ZERO],
            Self::Cubic([a, b, c, d]) => {
                let (u, v, w) = (b - a, c - b, d - c);
                [3.0 * u, 3.0 * (v - u), (w - v) - (v - u)]
            }
            Self::Arc(_) => [Complex64::ZERO; 3],
        }
    }

    /// Unit vector along the edge at z(0); not finite if the edge is a point.
    #[must_use]
    #[inline(never)]
    pub fn start_direction(&self) -> Complex64 {
        let size = self.size();
        let first = |points: &[Complex64]| {
            let from = points[0];
            let steps = points[1..].iter().map(|p| p - from);
            let mut far = steps.filter(|step| step.norm() > COINCIDENT * size);
            far.next().unwrap_or(Complex64::ZERO)
        };
        let along = match self {
            Self::Line { from, to } => to - from,
            Self::Arc(_) => self.tangent(Complex64::ZERO),
            Self::Quadratic(points) => first(points),
            Self::Cubic(points) => first(points),
        };
        along / along.norm()
    }

    /// Unit vector along the edge at z(1); not finite if the edge is a point.
    #[must_use]
    pub fn end_direction(&self) -> Complex64 {
        -self.reversed().start_direction()
    }

    /// Whether z'(0) = 0: the parameter of a Bézier curve stands still where control points coincide.
    #[must_use]
    pub fn starts_slowly(&self) -> bool {
        self.tangent(Complex64::ZERO).norm() <= COINCIDENT * self.size()
    }

    /// The larger side of its box of control points, about.
    pub(super) fn size(&self) -> f64 {
        let from = self.from();
        let reach = |points: &[Complex64]| points.iter().map(|p| (p - from).norm()).fold(0.0, f64::max);
        match self {
            Self::Line { from, to } => (to - from).norm(),
            Self::Arc(arc) => arc.size(),
            Self::Quadratic(points) => reach(points),
            Self::Cubic(points) => reach(points),
        }
    }

    /// The same curve run backwards.
    #[must_use]
    #[inline(never)]
    pub fn reversed(&self) -> Self {
        match *self {
            Self::Line { from, to } => Self::Line { from: to, to: from },
            Self::Arc(arc) => Self::Arc(arc.reversed()),
            Self::Quadratic([a, b, c]) => Self::Quadratic([c, b, a]),
            Self::Cubic([a, b, c, d]) => Self::Cubic([d, c, b, a]),
        }
    }

    /// The same curve, `by` plane units away.
    #[must_use]
    #[inline(never)]
    pub fn moved(&self, by: Complex64) -> Self {
        match *self {
            Self::Line { from, to } => Self::Line { from: from + by, to: to + by },
            Self::Arc(arc) => Self::Arc(arc.moved(by)),
            Self::Quadratic(b) => Self::Quadratic(b.map(|b| b + by)),
            Self::Cubic(b) => Self::Cubic(b.map(|b| b + by)),
        }
    }

    /// The same curve, turned and scaled about 0.
    #[must_use]
    #[inline(never)]
    pub fn scaled(&self, by: Complex64) -> Self {
        match *self {
            Self::Line { from, to } => Self::Line { from: from * by, to: to * by },
            Self::Arc(arc) => Self::Arc(arc.scaled(by)),
            Self::Quadratic(b) => Self::Quadratic(b.map(|b| b * by)),
            Self::Cubic(b) => Self::Cubic(b.map(|b| b * by)),
        }
    }

    /// The parts before and after t.
    #[must_use]
    #[inline(never)]
    pub fn split(&self, t: f64) -> [Self; 2] {
        let mix = |a: Complex64, b: Complex64| a + (b - a) * t;
        match *self {
            Self::Line { from, to } => {
                let middle = mix(from, to);
                [Self::Line { from, to: middle }, Self::Line { from: middle, to }]
            }
            Self::Arc(arc) => arc.split(t, self.point(t)).map(Self::Arc),
            Self::Quadratic([a, b, c]) => {
                let (ab, bc) = (mix(a, b), mix(b, c));
                let middle = mix(ab, bc);
                [Self::Quadratic([a, ab, middle]), Self::Quadratic([middle, bc, c])]
            }
            Self::Cubic([a, b, c, d]) => {
                let (ab, bc, cd) = (mix(a, b), mix(b, c), mix(c, d));
                let (abc, bcd) = (mix(ab, bc), mix(bc, cd));
                let middle = mix(abc, bcd);
                [Self::Cubic([a, ab, abc, middle]), Self::Cubic([middle, bcd, cd, d])]
            }
        }
    }

    /// Lower left and upper right corner of the smallest box around it.
    #[must_use]
    #[inline(never)]
    pub fn bounds(&self) -> (Complex64, Complex64) {
        let (mut low, mut high) = (self.from(), self.from());
        let turning = self.turning_points();
        for point in turning.into_iter().filter(|t| *t > 0.0 && *t < 1.0).map(|t| self.point(t)).chain([self.to()]) {
            low = Complex64::new(low.re.min(point.re), low.im.min(point.im));
            high = Complex64::new(high.re.max(point.re), high.im.max(point.im));
        }
        (low, high)
    }

    /// Whether all its numbers are.
    pub(super) fn is_finite(&self) -> bool {
        match self {
            Self::Line { from, to } => from.is_finite() && to.is_finite(),
            Self::Arc(arc) => arc.is_finite(),
            Self::Quadratic(points) => points.iter().all(|z| z.is_finite()),
            Self::Cubic(points) => points.iter().all(|z| z.is_finite()),
        }
    }

    /// Whether it is an arc that goes around more than once.
    pub(super) fn overlaps_itself(&self) -> bool {
        matches!(self, Self::Arc(arc) if arc.overlaps_itself())
    }

    /// The parameters where x or y may be extreme.
    #[inline(never)]
    pub(super) fn turning_points(&self) -> Vec<f64> {
        match self {
            Self::Line { .. } => Vec::new(),
            Self::Arc(arc) => arc.turning_points(),
            Self::Quadratic(_) | Self::Cubic(_) => {
                let [c1, c2, c3] = self.powers();
                let mut roots = quadratic_roots(3.0 * c3.re, 2.0 * c2.re, c1.re);
                roots.extend(quadratic_roots(3.0 * c3.im, 2.0 * c2.im, c1.im));
                roots
            }
        }
    }

    /// The complex t₀ near `guess` with z(t₀) = z, by Newton's method; `None` where it does not settle.
    #[must_use]
    pub fn preimage(&self, z: Complex64, guess: Complex64) -> Option<Complex64> {
        if guess.re < 0.5 {
            self.preimage_from_start(z - self.from(), guess)
        } else {
            Some(1.0 - self.reversed().preimage_from_start(z - self.to(), 1.0 - guess)?)
        }
    }

    /// The complex t₀ near `guess` with z(t₀) − z(0) = `step`, precise relative to itself; `None` where it does not settle.
    #[must_use]
    pub fn preimage_from_start(&self, step: Complex64, guess: Complex64) -> Option<Complex64> {
        let mut t = guess;
        for _ in 0..STEPS {
            let newton = (self.from_start(t) - step) / self.tangent(t);
            if !newton.is_finite() {
                return None;
            }
            t -= newton;
            if newton.norm() <= 4.0 * f64::EPSILON * t.norm() {
                return Some(t);
            }
        }
        let miss = (self.from_start(t) - step).norm();
        (miss <= 1e-14 * step.norm()).then_some(t)
    }
}

/// The real roots of at² + bt + c.
fn quadratic_roots(a: f64, b: f64, c: f64) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    [q / a, c / q].into_iter().filter(|root| root.is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn at(re: f64, im: f64) -> Complex64 {
        Complex64::new(re, im)
    }

    fn edges() -> [Edge; 5] {
        let arc = ArcTo { radii: (2.0, 1.0), rotation: 0.4, large: true, counterclockwise: true };
        [
            Edge::line(at(0.0, 1.0), at(2.0, -1.0)),
            Edge::circular(at(1.0, 1.0), 2.0, 0.3, 2.0),
            Edge::arc_to(at(0.0, 0.0), at(1.0, 1.5), arc),
            Edge::Quadratic([at(0.0, 0.0), at(1.0, 2.0), at(2.0, 0.0)]),
            Edge::Cubic([at(0.0, 0.0), at(1.0, 2.0), at(2.0, 2.0), at(3.0, -1.0)]),
        ]
    }

    #[test]
    fn derivatives_are_those_of_the_points() {
        for edge in edges() {
            for t in [at(0.1, 0.0), at(0.31, 0.1), at(0.45, 0.2), at(0.9, -0.1)] {
                let h = 1e-5;
                let slope = (edge.from_start(t + h) - edge.from_start(t - h)) / (2.0 * h);
                assert!((edge.tangent(t) - slope).norm() < 1e-8 * (1.0 + slope.norm()), "{edge:?} {t}");
                let bend = (edge.tangent(t + h) - edge.tangent(t - h)) / (2.0 * h);
                assert!((edge.bend(t) - bend).norm() < 1e-8 * (1.0 + bend.norm()), "{edge:?} {t}");
                let chord = (edge.from_start(t) - edge.from_start(at(0.3, 0.1))) / (t - at(0.3, 0.1));
                assert!((edge.chord(at(0.3, 0.1), t) - chord).norm() < 1e-13, "{edge:?} {t}");
                let by_t = edge.chord(at(0.3, 0.1), t + h) - edge.chord(at(0.3, 0.1), t - h);
                let slope = edge.chord_slope(at(0.3, 0.1), t);
                assert!((slope - by_t / (2.0 * h)).norm() < 1e-8 * (1.0 + slope.norm()), "{edge:?} {t}");
                assert!((edge.chord(t, t) - edge.tangent(t)).norm() < 1e-14);
            }
        }
    }

    #[test]
    fn both_ends_are_met_and_steps_from_them_are_relatively_exact() {
        for edge in edges() {
            assert!((edge.from() + edge.from_start(1.0.into()) - edge.to()).norm() < 4e-15, "{edge:?}");
            let step = edge.from_start(1e-20.into());
            assert!((step - 1e-20 * edge.tangent(Complex64::ZERO)).norm() < 1e-34, "{edge:?}");
            let back = edge.reversed();
            assert!((edge.point(0.3) - back.point(0.7)).norm() < 1e-15);
            assert!((edge.start_direction() + back.end_direction()).norm() < 1e-15);
        }
    }

    #[test]
    fn points_near_the_edge_come_back_to_their_parameters() {
        for edge in edges() {
            for t in [at(0.02, 0.01), at(0.5, 0.05), at(0.97, -0.02), at(1e-9, 1e-10)] {
                let found = edge.preimage_from_start(edge.from_start(t), t * at(1.2, 0.1)).unwrap();
                assert!((found - t).norm() < 1e-13 * t.norm(), "{edge:?} {t}: {found}");
            }
        }
        let flat = Edge::Quadratic([at(0.0, 0.0), at(0.0, 0.0), at(0.0, 0.0)]);
        assert_eq!(flat.preimage(at(1.0, 0.0), at(0.3, 0.0)), None);
    }

    #[test]
    fn halves_and_boxes_are_those_of_the_whole() {
        for edge in edges() {
            let [first, second] = edge.split(0.3);
            let (low, high) = edge.bounds();
            let mut reached = (edge.from(), edge.from());
            for k in 0..=1000 {
                let t = f64::from(k) / 1000.0;
                let z = edge.point(t);
                let half = if t <= 0.3 { first.point(t / 0.3) } else { second.point((t - 0.3) / 0.7) };
                assert!((z - half).norm() < 4e-15, "{edge:?} {t}");
                reached.0 = at(reached.0.re.min(z.re), reached.0.im.min(z.im));
                reached.1 = at(reached.1.re.max(z.re), reached.1.im.max(z.im));
            }
            assert!((reached.0 - low).norm() < 1e-4 && (reached.1 - high).norm() < 1e-4, "{edge:?}");
            assert!(reached.0.re >= low.re - 1e-14 && reached.1.im <= high.im + 1e-14);
        }
    }

    #[test]
    fn arcs_are_those_of_svg() {
        let half = |large, counterclockwise| ArcTo { radii: (1.0, 1.0), rotation: 0.0, large, counterclockwise };
        let (a, b) = (at(1.0, 0.0), at(0.0, 1.0));
        assert!((Edge::arc_to(a, b, half(false, true)).point(0.5) - Complex64::cis(PI / 4.0)).norm() < 1e-15);
        let far = -Complex64::cis(PI / 4.0);
        assert!((Edge::arc_to(a, b, half(true, false)).point(0.5) - far).norm() < 1e-15);
        let near = at(1.0, 1.0) - Complex64::cis(PI / 4.0);
        assert!((Edge::arc_to(a, b, half(false, false)).point(0.5) - near).norm() < 1e-15);
        // Enlarged to reach.
        let wide = Edge::arc_to(at(-3.0, 0.0), at(3.0, 0.0), half(false, false));
        assert!((wide.point(0.5) - at(0.0, 3.0)).norm() < 1e-14);
        assert_eq!(Edge::arc_to(a, b, ArcTo { radii: (0.0, 1.0), ..half(true, true) }), Edge::line(a, b));
    }
}
