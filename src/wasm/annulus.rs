//! `AnnulusMap` in JavaScript.

use super::canonical::joinable;
use super::error::Failure;
use super::level_lines::{self, LevelLines};
use super::points;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::{prepare_method, solved_methods};
use super::warp;
use crate::map::PlaneMap;
use crate::riemann::RingLines;
use crate::warp::Direction;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// The conformal map of a region with one hole onto the ring 1 > |w| > `innerRadius`: the outer boundary goes to |w| = 1, and
/// the region's `toward` (else its first boundary point) to 1.
#[wasm_bindgen]
pub struct AnnulusMap(Box<dyn PlaneMap>, crate::riemann::AnnulusMap);

#[wasm_bindgen]
impl AnnulusMap {
    /// Solves for the map.
    ///
    /// Throws "wrong-region" unless the region has one hole; "cancelled", "invalid-option", "inaccurate" or "too-few-points".
    pub fn solve(region: &Region, options: Option<Ts<RiemannOptions>>) -> Result<Self, Failure> {
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::AnnulusMap::solve(&region.domain(), &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Region → ring, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region.
    #[wasm_bindgen(js_name = toAnnulus)]
    pub fn to_annulus(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_annulus(points))?)
    }

    /// Ring → region, the inverse of `toAnnulus`; NaN outside the closed ring.
    #[wasm_bindgen(js_name = fromAnnulus)]
    pub fn from_annulus(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_annulus(points))?)
    }

    /// f' of the map region → ring, per plane unit; NaN outside the closed region, infinite at a re-entrant vertex.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }

    /// Lines of the region that go to "circles" of the ring, with the radii `levels`, or to its "rays", with these angles.
    /// A circle that does not lie in the ring has no line.
    ///
    /// Throws "invalid-option".
    #[wasm_bindgen(js_name = levelLines)]
    pub fn level_lines(
        &self,
        #[wasm_bindgen(unchecked_param_type = "\"circles\" | \"rays\"")] what: &str,
        levels: &[f64],
    ) -> Result<LevelLines, Failure> {
        let what = match what {
            "circles" => RingLines::Circles,
            "rays" => RingLines::Rays,
            _ => return Err(Failure::option("what", "what must be \"circles\" or \"rays\".")),
        };
        let levels = level_lines::finite(levels)?;
        if let (RingLines::Circles, Some(k)) = (what, levels.iter().position(|radius| *radius <= 0.0)) {
            let name = format!("levels[{k}]");
            return Err(Failure::option(
                &name,
                &format!("The option \"{name}\" cannot be used: a radius is positive."),
            ));
        }
        Ok(self.1.level_lines(what, levels).into())
    }

    /// The radius of the ring's inner circle.
    #[wasm_bindgen(getter, js_name = innerRadius)]
    pub fn inner_radius(&self) -> f64 {
        self.1.inner_radius()
    }

    /// 1 / `innerRadius`: the ratio of the ring's radii, outer to inner.
    #[wasm_bindgen(getter)]
    pub fn modulus(&self) -> f64 {
        self.1.modulus()
    }

    /// 2π / log `modulus`: the capacity a unit of length, over ε₀, between hole and outer boundary.
    #[wasm_bindgen(getter)]
    pub fn capacity(&self) -> f64 {
        self.1.capacity()
    }
}

prepare_method! { AnnulusMap, 1 }
joinable!(AnnulusMap, 1);

solved_methods! {
    AnnulusMap, 1,
    " An estimate of the largest error of log w, so of w relative to its size."
}

warp::warp_methods! {
    AnnulusMap, Direction::PushForward,
    " The texture as the map shows it on the ring, pixel by pixel, without a mesh: RGBA bytes with straight alpha."
    " `pull-back` shows on the region what lies on the ring."
}
