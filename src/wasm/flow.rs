//! `PotentialFlow` in JavaScript.

use super::error::Failure;
use super::options;
use super::points;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::solved_methods;
use crate::riemann::Circulation;
use serde::Deserialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// What comes from far away, and how it turns around the bodies.
#[derive(Debug, Default, Deserialize, Tsify)]
#[serde(default)]
pub struct FlowOptions {
    /// The speed far away, 1 by default.
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
}

/// The circulation as options hold it.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum CirculationOption {
    /// Numbers.
    Given(Vec<f64>),
    /// A name.
    Named(String),
}

/// The plane flow of an ideal fluid past one or more bodies.
#[derive(Debug)]
#[wasm_bindgen]
pub struct PotentialFlow(crate::riemann::PotentialFlow);

#[wasm_bindgen]
impl PotentialFlow {
    /// Solves for the flow past the bodies of `Region.exterior`.
    ///
    /// Throws "wrong-region" within an outer boundary, "wrong-length", "invalid-option", "cancelled", "inaccurate" or
    /// "too-few-points".
    pub fn past(
        region: &Region,
        flow: Option<Ts<FlowOptions>>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let FlowOptions { speed, angle, circulation, trailing } = options::read_or_default(flow.as_ref())?;
        let domain = region.domain();
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
        let (options, mut progress) = solve_options(options.as_ref())?;
        let (speed, angle) = (speed.unwrap_or(1.0), angle.unwrap_or(0.0));
        let solved = crate::riemann::PotentialFlow::past(
            &domain,
            speed,
            angle,
            &circulation,
            &options,
            &mut |stage, fraction| progress.report(stage, fraction),
        );
        progress.finish(solved).map(Self)
    }

    /// The circulation around each body, counter-clockwise.
    #[wasm_bindgen(getter)]
    pub fn circulation(&self) -> Vec<f64> {
        self.0.circulation().to_vec()
    }

    /// The complex potential φ + iψ at points `[x0, y0, x1, y1, …]`; NaN inside bodies.
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

    /// The pressure coefficient 1 − |u|²/U² at points; NaN inside bodies.
    pub fn pressure(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.0.pressure(&points::from_flat("The points", points)?))
    }

    /// The points of the bodies where the fluid rests.
    #[wasm_bindgen(getter, js_name = stagnationPoints)]
    pub fn stagnation_points(&self) -> Vec<f64> {
        points::to_flat(&self.0.stagnation_points())
    }

    /// The lift of all bodies a unit of span by Kutta and Joukowski, for a fluid of this density (1 by default).
    pub fn lift(&self, density: Option<f64>) -> f64 {
        self.0.lift(density.unwrap_or(1.0))
    }

    /// The force `[X, Y]` on all bodies a unit of span by Blasius' integral, for a fluid of this density (1 by default).
    #[wasm_bindgen(unchecked_return_type = "[x: number, y: number]")]
    pub fn force(&self, density: Option<f64>) -> js_sys::Array {
        points::pair(self.0.force(density.unwrap_or(1.0)))
    }
}

solved_methods! {
    PotentialFlow, 0,
    " An estimate of the largest error of the potential, in units of the speed times the bodies' size."
}
