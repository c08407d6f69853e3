//! Flow of an ideal fluid past bodies.

use super::super::evidence::{Evidence, evidence_methods};
use super::field::DomainField;
use super::level_lines::{Function, LevelLine};
use super::peak::peak;
use super::solved::Solved;
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

/// The plane flow of an ideal fluid past one or more bodies.
///
/// The complex potential is W = U(e^{−iα} z + i ∫ log(z − y) σ(y) ds), of which Im W = −cⱼ on body j; its circulation is −2π times
/// the charge ∫ σ there. Kutta's condition, that σ has no singular part at the trailing vertex, is linear in the charges.
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
    /// Winds along x and y, and a turning around each body.
    solved: Arc<Solved>,
    field: DomainField,
    /// W = this · B + shift.
    factor: Complex64,
    shift: Complex64,
    speed: f64,
    angle: f64,
    circulation: Vec<f64>,
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
        let bodies = domain.contours().len();
        if domain.is_bounded() {
            let found = "an outer boundary".to_string();
            return Err(Error::WrongRegion { what: "A flow past bodies", needed: "the outside of bodies", found });
        }
        checked(domain, speed, angle, circulation)?;
        let problems = |_| {
            let turning = |k: usize| {
                let mut charges = vec![0.0; bodies];
                charges[k] = 1.0;
                Problem::charged(charges)
            };
            let wind = |factor| Problem { source: Source::Stream(factor), charges: vec![0.0; bodies] };
            // Along x and along y.
            [wind(Complex64::i()), wind(Complex64::ONE)].into_iter().chain((0..bodies).map(turning)).collect()
        };
        let solved = Arc::new(Solved::solve(domain, &problems, options, progress)?);
        Ok(Self::of(solved, speed, angle, circulation))
    }

    /// Another wind, and another turning, past the same bodies: nothing is solved again.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] and [`Error::WrongLength`] as [`PotentialFlow::past`].
    pub fn again(&self, speed: f64, angle: f64, circulation: &Circulation) -> Result<Self> {
        checked(self.domain(), speed, angle, circulation)?;
        Ok(Self::of(Arc::clone(&self.solved), speed, angle, circulation))
    }

    fn of(solved: Arc<Solved>, speed: f64, angle: f64, circulation: &Circulation) -> Self {
        let scale = solved.scale();
        let wind = [angle.cos(), angle.sin()];
        let charges = match circulation {
            Circulation::Given(given) => given.iter().map(|gamma| -gamma * scale.unit / (TAU * speed)).collect(),
            Circulation::Kutta { trailing } => kutta_charges(&solved, wind, trailing),
        };
        let circulation = charges.iter().map(|charge| -TAU * charge * speed / scale.unit).collect();
        let weights: Vec<f64> = wind.into_iter().chain(charges).collect();
        let field = solved.field(&weights);
        let factor = Complex64::i() * (speed / scale.unit);
        let shift = speed * Complex64::cis(-angle) * scale.origin;
        let evidence = solved.evidence;
        Self { solved, field, factor, shift, speed, angle, circulation, evidence }
    }

    /// The outside of the bodies.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.field.domain()
    }

    /// ∮ u·dl around each body, counter-clockwise.
    #[must_use]
    pub fn circulation(&self) -> &[f64] {
        &self.circulation
    }

    /// The complex potential W = φ + iψ at points; NaN inside bodies. With circulation φ jumps across a cut behind each body.
    #[must_use]
    pub fn potential(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.field.branched(z).map_or(NOWHERE, |(b, _)| self.factor * b + self.shift)).collect()
    }

    /// The stream function ψ at points: constant along streamlines, and on each body; NaN inside bodies.
    #[must_use]
    pub fn stream(&self, points: &[Complex64]) -> Vec<f64> {
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

    /// The pressure coefficient 1 − |u|²/U² at points.
    #[must_use]
    pub fn pressure(&self, points: &[Complex64]) -> Vec<f64> {
        self.velocity(points).iter().map(|u| 1.0 - u.norm_sqr() / (self.speed * self.speed)).collect()
    }

    fn slope(&self, z: Complex64) -> Option<Complex64> {
        self.field.fast(z).map(|(_, slope)| self.factor * slope)
    }

    /// The lift of all bodies a unit of span, by Kutta and Joukowski: −ρUΓ at right angles to the wind, for density ρ.
    #[must_use]
    pub fn lift(&self, density: f64) -> f64 {
        -density * self.speed * self.circulation.iter().sum::<f64>()
    }

    /// The force on all bodies, X + iY a unit of span, by Blasius: X − iY = iρ/2 ∮ W'² dz around them.
    #[must_use]
    pub fn force(&self, density: f64) -> Complex64 {
        const POINTS: u32 = 64;
        let points: Vec<Complex64> =
            self.domain().contours().iter().flat_map(|c| c.polygon().vertices()).copied().collect();
        let middle = points.iter().sum::<Complex64>() / points.len() as f64;
        let reach = points.iter().map(|z| (z - middle).norm()).fold(0.0, f64::max);
        let around: Complex64 = (0..POINTS)
            .map(|k| Complex64::from_polar(3.0 * reach, TAU * f64::from(k) / f64::from(POINTS)))
            .filter_map(|turn| {
                let slope = self.slope(middle + turn)?;
                Some(slope * slope * turn * Complex64::i())
            })
            .sum();
        (Complex64::i() * (0.5 * density * TAU / f64::from(POINTS)) * around).conj()
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

evidence_methods!(PotentialFlow, "of W, in units of the speed times the bodies' size.");

/// What a flow may be asked for.
fn checked(domain: &Domain, speed: f64, angle: f64, circulation: &Circulation) -> Result<()> {
    if !(speed.is_finite() && speed > 0.0) {
        return Err(Error::InvalidOption { name: "speed", expected: "a positive number", value: speed });
    }
    if !angle.is_finite() {
        return Err(Error::InvalidOption { name: "angle", expected: "a number of radians", value: angle });
    }
    let bodies = domain.contours().len();
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
    for (contour, &vertex) in domain.contours().iter().zip(trailing) {
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

/// Charges with which the densities' singular parts at the trailing vertices cancel.
fn kutta_charges(solved: &Solved, [along_x, along_y]: [f64; 2], trailing: &[usize]) -> Vec<f64> {
    let bodies = trailing.len();
    let turning = |k: usize| (0..2 + bodies).map(|j| f64::from(u8::from(j == 2 + k))).collect::<Vec<_>>();
    let wind: Vec<f64> = [along_x, along_y].into_iter().chain(vec![0.0; bodies]).collect();
    let fields: Vec<DomainField> =
        std::iter::once(wind).chain((0..bodies).map(turning)).map(|weights| solved.field(&weights)).collect();
    let mut system = Vec::with_capacity(bodies * bodies);
    let mut rhs = Vec::with_capacity(bodies);
    for (body, &vertex) in trailing.iter().enumerate() {
        let strengths: Vec<f64> = fields.iter().map(|field| field.strength(&fields[1 + body], body, vertex)).collect();
        system.extend_from_slice(&strengths[1..]);
        rhs.push(-strengths[0]);
    }
    crate::symm::small_solve(system, rhs)
}
