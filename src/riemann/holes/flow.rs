//! Flow of an ideal fluid past bodies.

use super::super::evidence::{Evidence, evidence_methods};
use super::field::DomainField;
use super::flow_points::FlowPoints;
use super::level_lines::{Function, LevelLine};
use super::peak::peak;
use super::solved::{Scale, Solved};
use crate::plane::{Complex64, Domain, NOWHERE};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::problem::{Problem, Source};
use crate::{Error, Result};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// How much fluid turns around the bodies.
#[derive(Clone, Debug, PartialEq)]
pub enum Circulation {
    /// ∮ u·dl around each body, counter-clockwise.
    Given(Vec<f64>),
    /// Whatever lets the fluid leave each body at this vertex (Kutta's condition).
    Kutta {
        /// The trailing vertex of each body: an index of its boundary points, counter-clockwise.
        trailing: Vec<usize>,
    },
}

/// Lines of a flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlowLines {
    /// The stream function ψ is constant: the fluid runs along them.
    Streamlines,
    /// The potential φ is constant.
    Potentials,
}

/// The plane flow of an ideal fluid past one or more bodies, or, without a wind, around points within an outer boundary.
///
/// The complex potential is W = U(e^{−iα} z + i ∫ log(z − y) σ(y) ds), of which Im W = −cⱼ on body j; its circulation is −2π times
/// the charge ∫ σ there. Kutta's condition, that σ has no singular part at the trailing vertex, is linear in the charges. To this a
/// vortex at a adds −iΓ/2π · log(z − a) and a source m/2π · log(z − a), with what σ answers: G of [`FlowPoints`].
///
/// ```
/// use conformal_warp::{Circulation, Complex64, Curve, Domain, PotentialFlow, SolveOptions};
/// use std::f64::consts::TAU;
/// let circle: Vec<_> = (0..40).map(|k| Complex64::from_polar(1.0, TAU * f64::from(k) / 40.0)).collect();
/// let outside = Domain::exterior(&[circle], Curve::Smooth)?;
/// let still = Circulation::Given(vec![0.0]);
/// let flow = PotentialFlow::past(&outside, 1.0, 0.0, &still, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((flow.velocity(&[Complex64::new(0.0, 1.0)])[0] - 2.0).norm() < 1e-8, "twice as fast at the shoulders");
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct PotentialFlow {
    /// Outside of bodies winds along x and y; a turning around each body; what the points make.
    solved: Arc<Solved>,
    field: DomainField,
    /// W = this · B + shift.
    factor: Complex64,
    shift: Complex64,
    speed: f64,
    angle: f64,
    /// Around each component, counter-clockwise.
    circulation: Vec<f64>,
    points: FlowPoints,
    evidence: Evidence,
}

impl PotentialFlow {
    /// Solves for the flow that comes from far away with a speed, at an angle to the x axis (radians).
    ///
    /// # Errors
    /// [`Error::WrongRegion`] within an outer boundary; [`Error::InvalidOption`] for a speed that is not positive, an angle that
    /// is not finite, or a trailing vertex that is none or points inwards; [`Error::WrongLength`] unless there is one circulation
    /// or vertex for each body; [`Error::Cancelled`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn past(
        domain: &Domain,
        speed: f64,
        angle: f64,
        circulation: &Circulation,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Self> {
        Self::with_points(domain, speed, angle, circulation, &FlowPoints::default(), options, progress)
    }

    /// The same with vortices and sources. The speed may be 0 then, and must be within an outer boundary; the circulations are still
    /// those of the bodies, or holes, alone.
    ///
    /// ```
    /// use conformal_warp::{Circulation, Complex64, Curve, Domain, FlowPoints, PotentialFlow, SolveOptions};
    /// use std::f64::consts::TAU;
    /// let circle: Vec<_> = (0..40).map(|k| Complex64::from_polar(1.0, TAU * f64::from(k) / 40.0)).collect();
    /// let disk = Domain::new(&circle, &[], Curve::Smooth)?;
    /// let none = Circulation::Given(vec![]);
    /// let points = FlowPoints { vortices: vec![(Complex64::new(0.5, 0.0), TAU)], sources: vec![] };
    /// let flow = PotentialFlow::with_points(&disk, 0.0, 0.0, &none, &points, &SolveOptions::default(), &mut |_, _| true)?;
    /// // It goes around the middle as its image at 2 drives it.
    /// assert!((flow.drift()[0] - Complex64::new(0.0, 1.0 / 1.5)).norm() < 1e-8);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`PotentialFlow::past`]; [`Error::PointOutside`] for points in bodies or on the boundary; [`Error::InvalidOption`] for a speed
    /// within an outer boundary, and for sources there that do not add up to 0; [`Error::NotFinite`].
    pub fn with_points(
        domain: &Domain,
        speed: f64,
        angle: f64,
        circulation: &Circulation,
        points: &FlowPoints,
        options: &SolveOptions,
        progress: Progress,
    ) -> Result<Self> {
        points.check(domain)?;
        if domain.is_bounded() && points.vortices.is_empty() && points.sources.len() < 2 {
            let found = "an outer boundary".to_string();
            return Err(Error::WrongRegion { what: "A flow past bodies", needed: "the outside of bodies", found });
        }
        checked(domain, speed, angle, circulation, points)?;
        let problems = |scale: Scale| {
            let (count, bounded) = (domain.contours().len(), domain.is_bounded());
            let mut problems = Vec::new();
            if !bounded {
                // Along x and along y.
                for factor in [Complex64::i(), Complex64::ONE] {
                    problems.push(Problem { source: Source::stream(factor), charges: vec![0.0; count] });
                }
            }
            for body in usize::from(bounded)..count {
                let mut charges = vec![0.0; count];
                if bounded {
                    charges[0] = -1.0;
                }
                charges[body] = 1.0;
                problems.push(Problem::charged(charges));
            }
            problems.append(&mut points.problems(domain, &|z| scale.scaled(z)).0);
            problems
        };
        let solved = Arc::new(Solved::solve(domain, &problems, options, progress)?);
        Ok(Self::of(solved, speed, angle, circulation, points.clone()))
    }

    /// Another wind, and another turning, past the same bodies: nothing is solved again. Vortices and sources stay.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] and [`Error::WrongLength`] as [`PotentialFlow::past`].
    pub fn again(&self, speed: f64, angle: f64, circulation: &Circulation) -> Result<Self> {
        self.again_with_points(speed, angle, circulation, &self.points)
    }

    /// The same with other circulations of the vortices, and other strengths of the sources, all at their places.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] and [`Error::WrongLength`] as [`PotentialFlow::with_points`]; [`Error::InvalidMap`] for other places.
    pub fn again_with_points(
        &self,
        speed: f64,
        angle: f64,
        circulation: &Circulation,
        points: &FlowPoints,
    ) -> Result<Self> {
        let same = |a: &[(Complex64, f64)], b: &[(Complex64, f64)]| {
            a.len() == b.len() && a.iter().zip(b).all(|((a, _), (b, _))| a == b)
        };
        if !(same(&points.vortices, &self.points.vortices) && same(&points.sources, &self.points.sources)) {
            let reason = "vortices and sources can change what they are again, but not where: solve for other places";
            return Err(Error::InvalidMap { what: "A flow", reason });
        }
        points.check(self.domain())?;
        checked(self.domain(), speed, angle, circulation, points)?;
        Ok(Self::of(Arc::clone(&self.solved), speed, angle, circulation, points.clone()))
    }

    fn of(solved: Arc<Solved>, speed: f64, angle: f64, circulation: &Circulation, points: FlowPoints) -> Self {
        let scale = solved.scale();
        let domain = solved.domain();
        let first = usize::from(domain.is_bounded());
        let bodies = domain.contours().len() - first;
        let unit_speed = unit_speed(speed, circulation, &points, scale);
        let by_turning = scale.unit / (TAU * unit_speed);
        let mut weights = Vec::new();
        if first == 0 {
            let share = speed / unit_speed;
            weights.extend([angle.cos() * share, angle.sin() * share]);
        }
        let start = weights.len();
        weights.resize(start + bodies, 0.0);
        for amount in points.problems(domain, &|z| z).1 {
            weights.push(amount * by_turning);
        }
        let mut circulation = match circulation {
            Circulation::Given(given) => given.clone(),
            Circulation::Kutta { trailing } => {
                let mut charges = kutta_charges(&solved, &weights, start, trailing);
                charges.iter_mut().for_each(|charge| *charge /= -by_turning);
                charges
            }
        };
        for (weight, gamma) in weights[start..].iter_mut().zip(&circulation) {
            *weight = -gamma * by_turning;
        }
        if first == 1 {
            let of_vortices: f64 = points.vortices.iter().map(|(_, gamma)| gamma).sum();
            circulation.insert(0, circulation.iter().sum::<f64>() + of_vortices);
        }
        let field = solved.field(&weights);
        let factor = Complex64::i() * (unit_speed / scale.unit);
        let shift = speed * Complex64::cis(-angle) * scale.origin;
        let evidence = solved.evidence;
        Self { solved, field, factor, shift, speed, angle, circulation, points, evidence }
    }

    /// Where the fluid is.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.field.domain()
    }

    /// ∮ u·dl around each body, counter-clockwise.
    #[must_use]
    pub fn circulation(&self) -> &[f64] {
        &self.circulation[self.first()..]
    }

    /// The vortices and sources.
    #[must_use]
    pub fn points(&self) -> &FlowPoints {
        &self.points
    }

    /// The first component that is a body.
    fn first(&self) -> usize {
        usize::from(self.domain().is_bounded())
    }

    /// The complex potential W = φ + iψ at points; NaN inside bodies. With circulation φ jumps across a cut from each body and vortex
    /// to the left, and with sources ψ across a cut from each of them to the left.
    #[must_use]
    pub fn potential(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.field.branched(z).map_or(NOWHERE, |(b, _)| self.factor * b + self.shift)).collect()
    }

    /// The stream function ψ at points: constant along streamlines, and on each body, but for the cuts that run from sources to the
    /// left; NaN inside bodies.
    #[must_use]
    pub fn stream(&self, points: &[Complex64]) -> Vec<f64> {
        if !self.points.sources.is_empty() {
            return self.potential(points).into_iter().map(|w| w.im).collect();
        }
        let stream = |(b, _): (Complex64, Complex64)| (self.factor * b + self.shift).im;
        points.iter().map(|&z| self.field.fast(z).map_or(f64::NAN, stream)).collect()
    }

    /// Lines on which ψ or φ has given values, in the box from `low` to `high`, traced by the flow itself. Streamlines whose
    /// value is that of a body or of another stagnation point part and join there exactly. Every point of a line has its value
    /// as exactly as the flow is solved; a closed line smaller than 1/72 of the box may be missed. With circulation φ has many
    /// values at a point: a line goes on across the cuts of [`PotentialFlow::potential`].
    #[must_use]
    pub fn level_lines(&self, what: FlowLines, levels: &[f64], [low, high]: [Complex64; 2]) -> Vec<LevelLine> {
        let window = (low, high);
        match what {
            FlowLines::Streamlines => {
                let function = self.function(Complex64::ONE);
                let mut rests = self.stagnation_points();
                rests.extend(function.rests_inside(window));
                function.lines(levels, window, &rests)
            }
            FlowLines::Potentials => {
                // The imaginary part of iW is φ.
                let function = self.function(Complex64::i());
                let rests = function.rests_inside(window);
                function.lines(levels, window, &rests)
            }
        }
    }

    /// The points off the bodies where the fluid rests, in the box from `low` to `high`.
    #[must_use]
    pub fn free_stagnation_points(&self, [low, high]: [Complex64; 2]) -> Vec<Complex64> {
        self.function(Complex64::ONE).rests_inside((low, high))
    }

    /// W times a number.
    fn function(&self, turn: Complex64) -> Function<'_> {
        Function { field: &self.field, factor: turn * self.factor, shift: turn * self.shift }
    }

    /// The velocity u + iv at points; NaN inside bodies, infinite at a corner that the fluid goes around.
    #[must_use]
    pub fn velocity(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.slope(z).map_or(NOWHERE, |slope| slope.conj())).collect()
    }

    /// The pressure coefficient 1 − |u|²/U² at points; −|u|² without a wind. Of vortices and sources that are held where they are.
    #[must_use]
    pub fn pressure(&self, points: &[Complex64]) -> Vec<f64> {
        let pressure = |u: &Complex64| match self.speed {
            0.0 => -u.norm_sqr(),
            speed => 1.0 - u.norm_sqr() / (speed * speed),
        };
        self.velocity(points).iter().map(pressure).collect()
    }

    /// The velocity that each vortex is carried along with, free as it is in the fluid: that of the flow there without the vortex' own
    /// turning (Kirchhoff and Routh).
    #[must_use]
    pub fn drift(&self) -> Vec<Complex64> {
        self.points.vortices.iter().map(|(at, _)| self.regular_slope(*at).conj()).collect()
    }

    /// W' at a vortex or source without what is singular there.
    fn regular_slope(&self, at: Complex64) -> Complex64 {
        const POINTS: u32 = 32;
        /// Of the way to what is nearest: this to the power of the points is what the mean is off by.
        const SHARE: f64 = 0.3;
        let wall = (self.domain().nearest(at).place.point - at).norm();
        let others = self.points.residues().into_iter().map(|(other, _)| (other - at).norm());
        let radius = SHARE * others.filter(|distance| *distance > 0.0).fold(wall, f64::min);
        // On a circle 1/(z − a) is 0 in the mean, and what is analytic is what it is in the middle.
        let turn = |k: u32| Complex64::from_polar(radius, TAU * (f64::from(k) + 0.5) / f64::from(POINTS));
        let slopes = (0..POINTS).map(|k| self.slope(at + turn(k)).unwrap_or(NOWHERE));
        slopes.sum::<Complex64>() / f64::from(POINTS)
    }

    fn slope(&self, z: Complex64) -> Option<Complex64> {
        self.field.fast(z).map(|(_, slope)| self.factor * slope)
    }

    /// The lift of all bodies a unit of span, by Kutta and Joukowski: −ρUΓ at right angles to the wind, for density ρ. What vortices
    /// and sources add to it is in [`PotentialFlow::force`].
    #[must_use]
    pub fn lift(&self, density: f64) -> f64 {
        -density * self.speed * self.circulation().iter().sum::<f64>()
    }

    /// The force on all bodies, X + iY a unit of span, by Blasius: X − iY = iρ/2 ∮ W'² dz around them, and not around vortices and
    /// sources, which are held where they are (Lagally). NaN within an outer boundary.
    #[must_use]
    pub fn force(&self, density: f64) -> Complex64 {
        const POINTS: u32 = 64;
        if self.domain().is_bounded() {
            return NOWHERE;
        }
        let residues = self.points.residues();
        let mut points: Vec<Complex64> = residues.iter().map(|(at, _)| *at).collect();
        for contour in self.domain().contours() {
            points.extend(contour.polygon().vertices());
        }
        let middle = points.iter().sum::<Complex64>() / points.len() as f64;
        let reach = points.iter().map(|z| (z - middle).norm()).fold(0.0, f64::max);
        let around: Complex64 = (0..POINTS)
            .map(|k| Complex64::from_polar(3.0 * reach, TAU * f64::from(k) / f64::from(POINTS)))
            .filter_map(|turn| {
                let slope = self.slope(middle + turn)?;
                Some(slope * slope * turn * Complex64::i())
            })
            .sum();
        // W' = κ/2π/(z − a) + r makes the residue κr/π of W'².
        let at_points = residues.iter().map(|(at, kappa)| self.regular_slope(*at) * kappa);
        let around = around * (TAU / f64::from(POINTS)) - Complex64::new(0.0, 2.0) * at_points.sum::<Complex64>();
        (Complex64::i() * (0.5 * density) * around).conj()
    }

    /// The direction that the wind blows in, in radians.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// The points of the bodies where the fluid rests: those from which streamlines part, and where they join.
    #[must_use]
    pub fn stagnation_points(&self) -> Vec<Complex64> {
        let contours = self.domain().contours();
        let along = |component: usize, place: f64| self.domain().place_along(component, place);
        let mut found = Vec::new();
        for (component, contour) in contours.iter().enumerate() {
            const SAMPLES: usize = 8;
            let (edges, per_edge) = (contour.edge_count(), SAMPLES * contour.detail());
            // φ along the body rises and falls between stagnation points.
            let phi = |place: f64| (self.factor * self.field.on_boundary(along(component, place)).0).re;
            let step = 1.0 / per_edge as f64;
            let count = edges * per_edge;
            let turn = self.circulation[component];
            let values: Vec<f64> = (0..count).map(|k| phi(k as f64 * step)).collect();
            let value = |k: usize| values[k % count] + turn * (k / count) as f64;
            for k in 1..=count {
                let (before, here, after) = (value(k - 1), value(k), value(k + 1));
                if (here - before) * (after - here) > 0.0 {
                    continue;
                }
                let sign = if here >= before { 1.0 } else { -1.0 };
                let base = k as f64 * step;
                let shifted = |place: f64| {
                    let laps = (place / edges as f64).floor();
                    sign * (phi(place) + turn * laps)
                };
                let place = peak(&shifted, base - step, base + step);
                found.push(self.domain().point_along(component, place));
            }
        }
        found
    }
}

evidence_methods!(
    PotentialFlow,
    "of W, in units of the speed times the bodies' size, or of circulations and strengths over 2π where these are larger."
);

/// What a flow may be asked for.
fn checked(domain: &Domain, speed: f64, angle: f64, circulation: &Circulation, points: &FlowPoints) -> Result<()> {
    let (fits, expected) = match (domain.is_bounded(), points.is_empty()) {
        (true, _) => (speed == 0.0, "0 within an outer boundary"),
        (false, true) => (speed > 0.0, "a positive number"),
        (false, false) => (speed >= 0.0, "0 or more"),
    };
    if !(fits && speed.is_finite()) {
        return Err(Error::InvalidOption { name: "speed", expected, value: speed });
    }
    if !angle.is_finite() {
        return Err(Error::InvalidOption { name: "angle", expected: "a number of radians", value: angle });
    }
    let bodies = domain.holes().len();
    let (what, found) = match circulation {
        Circulation::Given(given) => ("The circulation", given.len()),
        Circulation::Kutta { trailing } => ("trailing", trailing.len()),
    };
    if found != bodies {
        return Err(Error::WrongLength { what, expected: format!("as many as there are bodies, {bodies}"), found });
    }
    let trailing = match circulation {
        Circulation::Kutta { trailing } => trailing,
        Circulation::Given(given) => {
            let endless = given.iter().copied().find(|number| !number.is_finite());
            let refuse = |value| Err(Error::InvalidOption { name: "circulation", expected: "finite numbers", value });
            return endless.map_or(Ok(()), refuse);
        }
    };
    for (contour, &vertex) in domain.contours()[usize::from(domain.is_bounded())..].iter().zip(trailing) {
        let value = vertex as f64;
        if vertex >= contour.edge_count() {
            let expected = "the index of a boundary point of its body";
            return Err(Error::InvalidOption { name: "trailing", expected, value });
        }
        if contour.turn(vertex).is_some_and(|turn| !(turn > 0.0 && turn <= PI)) {
            let expected = "a vertex at which its body has a corner that points outwards";
            return Err(Error::InvalidOption { name: "trailing", expected, value });
        }
    }
    Ok(())
}

/// A speed of the size that the flow has.
fn unit_speed(speed: f64, circulation: &Circulation, points: &FlowPoints, scale: Scale) -> f64 {
    let given: &[f64] = if let Circulation::Given(given) = circulation { given } else { &[] };
    let of_points = points.residues().iter().map(|(_, kappa)| kappa.norm()).sum::<f64>();
    let turning = given.iter().map(|gamma| gamma.abs()).sum::<f64>() + of_points;
    let sizes = [speed, turning * scale.unit / TAU, 1.0];
    sizes.into_iter().find(|size| *size > 0.0).unwrap_or(1.0)
}

/// Charges with which the densities' singular parts at the trailing vertices cancel; `base` are weights of all problems without
/// them, those of the bodies' turning from `start` on.
#[inline(never)]
fn kutta_charges(solved: &Solved, base: &[f64], start: usize, trailing: &[usize]) -> Vec<f64> {
    let (bodies, first) = (trailing.len(), usize::from(solved.domain().is_bounded()));
    let mut fields = vec![solved.field(base)];
    for body in 0..bodies {
        let mut turning = vec![0.0; base.len()];
        turning[start + body] = 1.0;
        fields.push(solved.field(&turning));
    }
    let mut system = Vec::with_capacity(bodies * bodies);
    let mut rhs = Vec::with_capacity(bodies);
    for (body, &vertex) in trailing.iter().enumerate() {
        let strength = |field: &DomainField| field.strength(&fields[1 + body], first + body, vertex);
        rhs.push(-strength(&fields[0]));
        system.extend(fields[1..].iter().map(strength));
    }
    crate::symm::small_solve(system, rhs)
}
