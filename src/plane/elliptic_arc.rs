//! Arcs of ellipses, by the ellipse's own axes, and as SVG describes them.

use super::Complex64;
use std::f64::consts::{PI, TAU};

/// z(t) = center + cosine·cos φ + sine·sin φ, φ = start + sweep·t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipticArc {
    from: Complex64,
    to: Complex64,
    cosine: Complex64,
    sine: Complex64,
    start: f64,
    sweep: f64,
}

/// Radii, rotation and flags of SVG's arc command, in radians and with y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcTo {
    /// Radii along the ellipse's axes; enlarged if they are too small to reach.
    pub radii: (f64, f64),
    /// Angle of the first axis against the x axis, counter-clockwise, in radians.
    pub rotation: f64,
    /// Whether the arc is the one of more than half a turn.
    pub large: bool,
    /// Whether it runs counter-clockwise.
    pub counterclockwise: bool,
}

/// Arcs that sweep more than once around meet themselves; rounding may add a little.
const MOST_SWEEP: f64 = TAU * (1.0 + 1e-9);
impl EllipticArc {
    /// Part of the ellipse center + cosine·cos φ + sine·sin φ from φ = `start` to `start` + `sweep`, in radians.
    #[must_use]
    pub fn new(center: Complex64, cosine: Complex64, sine: Complex64, start: f64, sweep: f64) -> Self {
        let at = |phi: f64| center + cosine * phi.cos() + sine * phi.sin();
        Self { from: at(start), to: at(start + sweep), cosine, sine, start, sweep }
    }

    /// The arc between two points that SVG's command describes, its radii not 0.
    pub(super) fn drawn_to(from: Complex64, to: Complex64, arc: ArcTo) -> Self {
        let (rx, ry) = (arc.radii.0.abs(), arc.radii.1.abs());
        // On the unit circle of the ellipse's own coordinates.
        let turn = Complex64::cis(arc.rotation);
        let flat = |v: Complex64| {
            let v = v * turn.conj();
            Complex64::new(v.re / rx, v.im / ry)
        };
        let half = flat(to - from) * 0.5;
        let scale = half.norm().max(1.0);
        let half = half / scale;
        let height = (1.0 - half.norm_sqr()).max(0.0).sqrt();
        // The center is to the left of the chord where the short arc is counter-clockwise.
        let side = if arc.large == arc.counterclockwise { -1.0 } else { 1.0 };
        let center = Complex64::i() * half / half.norm() * (height * side);
        let (a, b) = (-half - center, half - center);
        let start = a.arg();
        let mut sweep = (b * a.conj()).arg();
        if arc.counterclockwise && sweep <= 0.0 {
            sweep += TAU;
        } else if !arc.counterclockwise && sweep >= 0.0 {
            sweep -= TAU;
        }
        let cosine = turn * rx * scale;
        let sine = turn * Complex64::new(0.0, ry * scale);
        Self { from, to, cosine, sine, start, sweep }
    }

    /// The middle of the ellipse.
    #[must_use]
    pub fn center(&self) -> Complex64 {
        self.from - self.cosine * self.start.cos() - self.sine * self.start.sin()
    }

    /// The angle φ that it runs through, in radians, negative from `cosine` away from `sine`.
    #[must_use]
    pub fn sweep(&self) -> f64 {
        self.sweep
    }

    /// How SVG's arc command describes it, its sweep being at most once around.
    pub(super) fn drawn(&self) -> ArcTo {
        // cosine·cos φ + sine·sin φ = p e^{iφ} + q e^{−iφ}.
        let turn = Complex64::i() * self.sine;
        let (p, q) = ((self.cosine - turn) * 0.5, (self.cosine + turn) * 0.5);
        let radii = (p.norm() + q.norm(), (p.norm() - q.norm()).abs());
        let rotation = if q.norm() <= 1e-15 * p.norm() { 0.0 } else { 0.5 * (p * q).arg() };
        let counterclockwise = (self.sweep > 0.0) == (p.norm() > q.norm());
        ArcTo { radii, rotation, large: self.sweep.abs() > PI, counterclockwise }
    }

    /// Both ends, the radii along cosine and sine, and the angles `start` and `sweep`: all that it is.
    pub(super) fn parts(&self) -> ([Complex64; 4], [f64; 2]) {
        ([self.from, self.to, self.cosine, self.sine], [self.start, self.sweep])
    }

    /// The arc of these parts, unless they contradict each other.
    pub(super) fn from_parts(points: [Complex64; 4], angles: [f64; 2]) -> Option<Self> {
        let arc = Self::of_parts(points, angles);
        let size = arc.cosine.norm() + arc.sine.norm() + arc.from.norm();
        let miss = (arc.from + Complex64::ONE * arc.chord(Complex64::ZERO, Complex64::ONE) - arc.to).norm();
        (miss <= 1e-9 * size && arc.sweep.abs() <= MOST_SWEEP).then_some(arc)
    }

    /// The arc of these parts, which fit each other.
    pub(super) fn of_parts([from, to, cosine, sine]: [Complex64; 4], [start, sweep]: [f64; 2]) -> Self {
        Self { from, to, cosine, sine, start, sweep }
    }

    /// z(0).
    pub(super) fn from(&self) -> Complex64 {
        self.from
    }

    /// z(1).
    pub(super) fn to(&self) -> Complex64 {
        self.to
    }

    /// (z(t) − z(s))/(t − s), without cancellation.
    pub(super) fn chord(&self, s: Complex64, t: Complex64) -> Complex64 {
        let half = (t - s) * (0.5 * self.sweep);
        // sin x/x.
        let sinc = if half.norm_sqr() < 1e-12 { 1.0 - half * half / 6.0 } else { half.sin() / half };
        self.turned(self.angle(0.5 * (s + t))) * sinc * self.sweep
    }

    /// The derivative of [`EllipticArc::chord`] by t.
    pub(super) fn chord_slope(&self, s: Complex64, t: Complex64) -> Complex64 {
        let half = (t - s) * (0.5 * self.sweep);
        let (sinc, slope) = if half.norm_sqr() < 1e-4 {
            let square = half * half;
            (1.0 - square / 6.0 * (1.0 - square / 20.0), -half / 3.0 * (1.0 - square / 10.0 * (1.0 - square / 28.0)))
        } else {
            let sinc = half.sin() / half;
            (sinc, (half.cos() - sinc) / half)
        };
        let phi = self.angle(0.5 * (s + t));
        (-self.from_center(phi) * sinc + self.turned(phi) * slope) * (0.5 * self.sweep * self.sweep)
    }

    /// z'(t).
    pub(super) fn tangent(&self, t: Complex64) -> Complex64 {
        self.turned(self.angle(t)) * self.sweep
    }

    /// z''(t).
    pub(super) fn bend(&self, t: Complex64) -> Complex64 {
        -self.from_center(self.angle(t)) * (self.sweep * self.sweep)
    }

    /// About how far it reaches.
    pub(super) fn size(&self) -> f64 {
        (self.cosine.norm() + self.sine.norm()) * self.sweep.abs().min(1.0)
    }

    /// The same curve run backwards.
    pub(super) fn reversed(self) -> Self {
        Self { from: self.to, to: self.from, start: self.start + self.sweep, sweep: -self.sweep, ..self }
    }

    /// The same curve, `by` plane units away.
    pub(super) fn moved(self, by: Complex64) -> Self {
        Self { from: self.from + by, to: self.to + by, ..self }
    }

    /// The same curve, turned and scaled about 0.
    pub(super) fn scaled(self, by: Complex64) -> Self {
        let [from, to, cosine, sine] = self.parts().0.map(|z| z * by);
        Self { from, to, cosine, sine, ..self }
    }

    /// The parts before and after t, where the point `middle` is.
    pub(super) fn split(self, t: f64, middle: Complex64) -> [Self; 2] {
        let start = self.start + self.sweep * t;
        let first = Self { to: middle, sweep: self.sweep * t, ..self };
        [first, Self { from: middle, start, sweep: self.sweep * (1.0 - t), ..self }]
    }

    /// Whether its points and where it starts are.
    pub(super) fn is_finite(&self) -> bool {
        self.parts().0.iter().all(|z| z.is_finite()) && self.start.is_finite()
    }

    /// Whether it goes around more than once.
    pub(super) fn overlaps_itself(&self) -> bool {
        self.sweep.abs() > MOST_SWEEP
    }

    /// The parameters where x or y may be extreme.
    pub(super) fn turning_points(&self) -> Vec<f64> {
        let extremes = [(self.cosine.re, self.sine.re), (self.cosine.im, self.sine.im)];
        let first = extremes.map(|(cosine, sine)| sine.atan2(cosine));
        let turns = (self.sweep.abs() / PI) as i32 + 3;
        let at = |phi: f64| {
            let base = ((phi - self.start) / PI).floor();
            (-turns..=turns).map(move |k| (phi - self.start - PI * (base - f64::from(k))) / self.sweep)
        };
        first.into_iter().flat_map(at).collect()
    }

    /// z − center.
    fn from_center(&self, phi: Complex64) -> Complex64 {
        self.cosine * phi.cos() + self.sine * phi.sin()
    }

    /// dz/dφ.
    fn turned(&self, phi: Complex64) -> Complex64 {
        self.sine * phi.cos() - self.cosine * phi.sin()
    }

    fn angle(&self, t: Complex64) -> Complex64 {
        self.start + t * self.sweep
    }
}
