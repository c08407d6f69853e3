//! `PotentialFlow` in JavaScript.

use super::error::Failure;
use super::level_lines::{self, LevelLines};
use super::options::{self, FrameOptions, Point};
use super::points;
use super::reading::{Read, Refused, fields};
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::solved_methods;
use crate::Error;
use crate::plane::Domain;
use crate::riemann::{Circulation, FlowLines, FlowPoints};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// What comes from far away, and how it turns around the bodies.
#[derive(Debug, Default, Tsify)]
pub struct FlowOptions {
    /// The speed far away, 1 by default; 0 within an outer boundary.
    #[tsify(optional)]
    pub speed: Option<f64>,
    /// Its angle to the x axis in radians, 0 by default.
    #[tsify(optional)]
    pub angle: Option<f64>,
    /// The circulation around each body, counter-clockwise; "kutta" for the one with which the fluid leaves at the trailing
    /// vertices. None by default.
    #[tsify(optional, type = "number[] | \"kutta\"")]
    pub circulation: Option<CirculationOption>,
    /// "kutta": the trailing vertex of each body, an index of its boundary points; 0 by default.
    #[tsify(optional, type = "number[]")]
    pub trailing: Option<Vec<usize>>,
    /// Points of the fluid that it turns around.
    #[tsify(optional)]
    pub vortices: Option<Vec<Vortex>>,
    /// Points of the fluid where more of it wells up, or drains away.
    #[tsify(optional)]
    pub sources: Option<Vec<FlowSource>>,
}
fields!(FlowOptions: speed, angle, circulation, trailing, vortices, sources);

/// A vortex of a flow.
#[derive(Clone, Copy, Debug, Tsify)]
pub struct Vortex {
    /// Where it is.
    #[tsify(type = "[x: number, y: number]")]
    pub at: Point,
    /// ∮ u·dl around it alone, counter-clockwise.
    pub circulation: f64,
}
fields!(Vortex: at, circulation);

/// A source of a flow.
#[derive(Clone, Copy, Debug, Tsify)]
pub struct FlowSource {
    /// Where it is.
    #[tsify(type = "[x: number, y: number]")]
    pub at: Point,
    /// How much fluid wells up, a unit of time and depth; less than 0 for a sink.
    pub strength: f64,
}
fields!(FlowSource: at, strength);

/// The circulation as options hold it.
#[derive(Clone, Debug)]
pub enum CirculationOption {
    /// Numbers.
    Given(Vec<f64>),
    /// A name.
    Named(String),
}

impl Read for CirculationOption {
    fn read(value: &JsValue) -> Result<Self, Refused> {
        if value.is_string() { String::read(value).map(Self::Named) } else { Vec::read(value).map(Self::Given) }
    }
}

/// What flow is asked for.
struct Given {
    speed: f64,
    angle: f64,
    circulation: Circulation,
    points: FlowPoints,
}

impl Given {
    /// For the bodies of a domain; the points of `before` where none are given.
    fn read(flow: Option<&Ts<FlowOptions>>, domain: &Domain, before: Option<&FlowPoints>) -> Result<Self, Failure> {
        let FlowOptions { speed, angle, circulation, trailing, vortices, sources } = options::read_or_default(flow)?;
        let bodies = domain.holes().len();
        let circulation = match circulation {
            None => Circulation::Given(vec![0.0; bodies]),
            Some(CirculationOption::Given(given)) => Circulation::Given(given),
            Some(CirculationOption::Named(name)) if name == "kutta" => {
                Circulation::Kutta { trailing: trailing.unwrap_or_else(|| vec![0; bodies]) }
            }
            Some(CirculationOption::Named(_)) => {
                return Err(Failure::option("circulation", "circulation must be an array of numbers or \"kutta\"."));
            }
        };
        let mut points = before.cloned().unwrap_or_default();
        if let Some(vortices) = vortices {
            points.vortices = vortices.into_iter().map(|vortex| (vortex.at.into(), vortex.circulation)).collect();
        }
        if let Some(sources) = sources {
            points.sources = sources.into_iter().map(|source| (source.at.into(), source.strength)).collect();
        }
        let speed = speed.unwrap_or(if domain.is_bounded() { 0.0 } else { 1.0 });
        Ok(Self { speed, angle: angle.unwrap_or(0.0), circulation, points })
    }
}

/// The plane flow of an ideal fluid past one or more bodies.
#[derive(Debug)]
#[wasm_bindgen]
pub struct PotentialFlow(crate::riemann::PotentialFlow);

#[wasm_bindgen]
impl PotentialFlow {
    /// Solves for the flow past the bodies of `Region.exterior`; with `vortices` or `sources` also within an outer boundary, where
    /// there is no wind.
    ///
    /// Throws "wrong-region" within an outer boundary without them, "point-outside" for those in bodies or on the boundary,
    /// "wrong-length", "invalid-option", "cancelled", "inaccurate" or "too-few-points".
    pub fn past(
        region: &Region,
        flow: Option<Ts<FlowOptions>>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let domain = region.domain();
        let given = Given::read(flow.as_ref(), &domain, None)?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::PotentialFlow::with_points(
            &domain,
            given.speed,
            given.angle,
            &given.circulation,
            &given.points,
            &options,
            &mut |stage, fraction| progress.report(stage, fraction),
        );
        progress.finish(solved).map(Self)
    }

    /// Another wind, and another turning, past the same bodies: nothing is solved again. Vortices and sources stay, or are given
    /// again, at the same places.
    ///
    /// Throws "wrong-length", "invalid-option", or "invalid-map" for vortices and sources at other places.
    pub fn again(&self, flow: Option<Ts<FlowOptions>>) -> Result<Self, Failure> {
        let given = Given::read(flow.as_ref(), self.0.domain(), Some(self.0.points()))?;
        Ok(Self(self.0.again_with_points(given.speed, given.angle, &given.circulation, &given.points)?))
    }

    /// The velocities `[u, v, …]` that the vortices are carried along with, each by all but its own turning (Kirchhoff and Routh).
    #[wasm_bindgen(getter)]
    pub fn drift(&self) -> Vec<f64> {
        points::to_flat(&self.0.drift())
    }

    /// Lines of the flow in a frame, traced by the flow itself: "streamlines", on which ψ has the given values, or
    /// "potentials", on which φ has. Streamlines with the value of a body or of another stagnation point part and join there
    /// exactly. A closed line smaller than 1/72 of the frame may be missed.
    ///
    /// Throws "invalid-option" or "invalid-frame".
    #[wasm_bindgen(js_name = levelLines)]
    pub fn level_lines(
        &self,
        #[wasm_bindgen(unchecked_param_type = "\"streamlines\" | \"potentials\"")] what: &str,
        levels: &[f64],
        frame: Ts<FrameOptions>,
    ) -> Result<LevelLines, Failure> {
        Ok(self.0.level_lines(lines(what)?, level_lines::finite(levels)?, level_lines::window(&frame)?).into())
    }

    /// The points off the bodies in a frame where the fluid rests.
    ///
    /// Throws "invalid-option" or "invalid-frame".
    #[wasm_bindgen(js_name = freeStagnationPoints)]
    pub fn free_stagnation_points(&self, frame: Ts<FrameOptions>) -> Result<Vec<f64>, Failure> {
        Ok(points::to_flat(&self.0.free_stagnation_points(level_lines::window(&frame)?)))
    }

    /// The circulation around each body, counter-clockwise.
    #[wasm_bindgen(getter)]
    pub fn circulation(&self) -> Vec<f64> {
        self.0.circulation().to_vec()
    }

    /// The complex potential φ + iψ at points `[x0, y0, x1, y1, …]`; NaN inside bodies. From bodies and vortices with circulation cuts run
    /// to the left, across which φ jumps, and from sources such across which ψ does.
    pub fn potential(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.0.potential(points))?)
    }

    /// The stream function ψ at points: constant along streamlines; NaN inside bodies.
    pub fn stream(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.0.stream(&points::from_flat("The points", points)?))
    }

    /// The velocity `[u, v, …]` at points; NaN inside bodies.
    pub fn velocity(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.0.velocity(points))?)
    }

    /// The pressure coefficient 1 − |u|²/U² at points, −|u|² without a wind; NaN inside bodies.
    pub fn pressure(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.0.pressure(&points::from_flat("The points", points)?))
    }

    /// The points of the bodies where the fluid rests.
    #[wasm_bindgen(getter, js_name = stagnationPoints)]
    pub fn stagnation_points(&self) -> Vec<f64> {
        points::to_flat(&self.0.stagnation_points())
    }

    /// The lift of all bodies a unit of span by Kutta and Joukowski, without what vortices and sources add, for a fluid of this density (1 by default).
    ///
    /// Throws "invalid-option".
    pub fn lift(&self, density: Option<f64>) -> Result<f64, Failure> {
        Ok(self.0.lift(checked(density)?))
    }

    /// The force `[X, Y]` on all bodies a unit of span by Blasius' integral, vortices and sources being held where they are, for a fluid
    /// of this density (1 by default). NaN within an outer boundary.
    ///
    /// Throws "invalid-option".
    #[wasm_bindgen(unchecked_return_type = "[x: number, y: number]")]
    pub fn force(&self, density: Option<f64>) -> Result<js_sys::Array, Failure> {
        Ok(points::pair(self.0.force(checked(density)?)))
    }
}

/// Which lines are meant.
///
/// # Errors
/// "invalid-option" for others.
pub fn lines(what: &str) -> Result<FlowLines, Failure> {
    match what {
        "streamlines" => Ok(FlowLines::Streamlines),
        "potentials" => Ok(FlowLines::Potentials),
        _ => Err(Failure::option("what", "what must be \"streamlines\" or \"potentials\".")),
    }
}

/// The density of a fluid.
fn checked(density: Option<f64>) -> crate::Result<f64> {
    match density.unwrap_or(1.0) {
        density if density > 0.0 && density.is_finite() => Ok(density),
        value => Err(Error::InvalidOption { name: "density", expected: "a positive number", value }),
    }
}

solved_methods! {
    PotentialFlow, 0,
    " An estimate of the largest error of the potential, in units of the speed times the bodies' size."
}
