//! `Electrostatics` in JavaScript.

use super::error::Failure;
use super::level_lines::{self, LevelLines};
use super::options::{self, FrameOptions};
use super::points;
use super::reading::fields;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::solved_methods;
use crate::Error;
use crate::riemann::Conductors;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// More lines of force would take minutes.
const MOST_LINES: usize = 10_000;

/// What is known of the conductors: one number for each, the outer boundary first if there is one, then the holes or bodies.
#[derive(Debug, Default, Tsify)]
pub struct ConductorOptions {
    /// Their potentials.
    #[tsify(optional)]
    pub potentials: Option<Vec<f64>>,
    /// Or their charges a unit of length over ε₀, which must add up to 0.
    #[tsify(optional)]
    pub charges: Option<Vec<f64>>,
}
fields!(ConductorOptions: potentials, charges);

/// The electric field between conductors: cylinders whose cross-section are the components of a region's boundary. Everything is
/// a unit of length, with ε₀ = 1.
#[derive(Debug)]
#[wasm_bindgen]
pub struct Electrostatics(crate::riemann::Electrostatics);

#[wasm_bindgen]
impl Electrostatics {
    /// Solves for the field. Of given charges, the first conductor has the potential 0.
    ///
    /// Throws "wrong-region" for a single conductor, "wrong-length", "invalid-option", "cancelled", "inaccurate" or
    /// "too-few-points".
    pub fn solve(
        region: &Region,
        conductors: Ts<ConductorOptions>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let given = match options::read(&conductors)? {
            ConductorOptions { potentials: Some(potentials), charges: None } => Conductors::Potentials(potentials),
            ConductorOptions { potentials: None, charges: Some(charges) } => Conductors::Charges(charges),
            _ => return Err(Failure::option("potentials", "Either potentials or charges must be given.")),
        };
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved =
            crate::riemann::Electrostatics::solve(&region.domain(), &given, &options, &mut |stage, fraction| {
                progress.report(stage, fraction)
            });
        progress.finish(solved).map(Self)
    }

    /// Maxwell's capacitance matrix over ε₀, row by row: charges = matrix · potentials.
    #[wasm_bindgen(getter)]
    pub fn capacitance(&self) -> Vec<f64> {
        self.0.capacitance().concat()
    }

    /// The potential of each conductor.
    #[wasm_bindgen(getter)]
    pub fn potentials(&self) -> Vec<f64> {
        self.0.potentials().to_vec()
    }

    /// The charge of each conductor a unit of length, over ε₀.
    #[wasm_bindgen(getter)]
    pub fn charges(&self) -> Vec<f64> {
        self.0.charges().to_vec()
    }

    /// The impedance in ohms of the line that two conductors make in vacuum; undefined for more of them.
    #[wasm_bindgen(getter)]
    pub fn impedance(&self) -> Option<f64> {
        self.0.impedance()
    }

    /// The logarithmic capacity of all bodies together, in plane units; undefined within an outer boundary.
    #[wasm_bindgen(getter, js_name = logarithmicCapacity)]
    pub fn logarithmic_capacity(&self) -> Option<f64> {
        self.0.logarithmic_capacity()
    }

    /// The potential at points `[x0, y0, x1, y1, …]`; NaN inside conductors.
    pub fn potential(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.0.potential(&points::from_flat("The points", points)?))
    }

    /// Lines of equal potential in a frame, traced by the field itself. A closed line smaller than 1/72 of the frame may be missed.
    ///
    /// Throws "invalid-option" or "invalid-frame".
    #[wasm_bindgen(js_name = levelLines)]
    pub fn level_lines(&self, levels: &[f64], frame: Ts<FrameOptions>) -> Result<LevelLines, Failure> {
        Ok(self.0.level_lines(level_lines::finite(levels)?, level_lines::window(&frame)?).into())
    }

    /// Lines of force in a frame: `count` leave the conductor with the largest charge, and from every other with a positive one
    /// as many as it has of it. The value of each is the number of the conductor that it leaves.
    ///
    /// Throws "invalid-option" or "invalid-frame".
    #[wasm_bindgen(js_name = forceLines)]
    pub fn force_lines(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Count")] count: usize,
        frame: Ts<FrameOptions>,
    ) -> Result<LevelLines, Failure> {
        if count > MOST_LINES {
            let value = count as f64;
            return Err(Error::InvalidOption { name: "count", expected: "at most 10000 lines", value }.into());
        }
        Ok(self.0.force_lines(count, level_lines::window(&frame)?).into())
    }

    /// The electric field `[Ex, Ey, …]` at points; NaN inside conductors.
    pub fn field(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.0.field(points))?)
    }
}

solved_methods! {
    Electrostatics, 0,
    " An estimate of the largest error of the potentials of unit charges."
}
