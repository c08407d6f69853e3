//! `RegionMap` in JavaScript.

use super::error::Failure;
use super::points;
use super::riemann::RiemannMap;
use super::warp::{self};
use crate::warp::Direction;
use wasm_bindgen::prelude::wasm_bindgen;

/// The conformal map region A → region B through the disk: center to center, `toward` to `toward`.
#[derive(Debug)]
#[wasm_bindgen]
pub struct RegionMap(crate::riemann::RegionMap);

#[wasm_bindgen]
impl RegionMap {
    /// The map from A's region to B's. Nothing is solved; both maps may be freed afterwards.
    pub fn between(a: &RiemannMap, b: &RiemannMap) -> Self {
        Self(crate::riemann::RegionMap::between(a.inner(), b.inner()))
    }

    /// A → B, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region A.
    ///
    /// Far ends of long regions keep their accuracy. Only where a far end of B belongs to a spot of A that is smaller than the
    /// distance of neighbouring numbers, or than the error of the maps, points cannot be told apart.
    ///
    /// Throws "too-far-apart" where it is a far end of A too, in a direction that the maps do not know: there nobody can tell
    /// what belongs together. `warp` draws nothing there.
    pub fn forward(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.0.try_forward(&points)?))
    }

    /// B → A; NaN outside the closed region B.
    ///
    /// Throws as `forward` does.
    pub fn inverse(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.0.try_inverse(&points)?))
    }

    /// The derivative of `forward`; NaN outside, and where that throws.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.0.derivative(&points)))
    }
}

warp::warp_methods! {
    RegionMap, Direction::PushForward,
    " A's texture as the map shows it on B, pixel by pixel, without a mesh: RGBA bytes with straight alpha. `pull-back`"
    " shows on A what lies on B."
}
