//! `RegionMap` in JavaScript.

use super::canonical::Joinable;
use super::error::Failure;
use super::options;
use super::points;
use super::reading::fields;
use super::warp::{self};
use crate::riemann::JoinedMap;
use crate::warp::Direction;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// How two maps are joined.
#[derive(Debug, Default, Tsify)]
pub struct JoinOptions {
    /// Whether rings or rectangles of different shape are stretched onto each other, which is not conformal; false by default.
    #[tsify(optional)]
    pub stretch: Option<bool>,
}
fields!(JoinOptions: stretch);

/// The conformal map region A → region B through the region that both are mapped onto: the disk, center to center and `toward` to
/// `toward`; or a ring, the outside of the disk, a rectangle, the strip, the half plane.
#[derive(Debug)]
#[wasm_bindgen]
pub struct RegionMap(JoinedMap);

#[wasm_bindgen]
impl RegionMap {
    /// The map from A's region to B's. Nothing is solved; both maps may be freed afterwards.
    ///
    /// Throws "different-moduli" for rings and rectangles of different shape, unless they may be stretched; "invalid-map" for maps
    /// onto regions of different kinds.
    pub fn between(a: &Joinable, b: &Joinable, options: Option<Ts<JoinOptions>>) -> Result<Self, Failure> {
        let JoinOptions { stretch } = options::read_or_default(options.as_ref())?;
        let [a, b] = [a, b].map(|map| map.canonical().into_inner());
        Ok(Self(if stretch.unwrap_or_default() { JoinedMap::stretching(a, b)? } else { JoinedMap::between(a, b)? }))
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

    /// The derivative of `forward`, ∂/∂z where it stretches; NaN outside, and where that throws.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.0.derivative(&points)))
    }

    /// Whether the map is conformal: not if it stretches.
    #[wasm_bindgen(getter, js_name = isAnalytic)]
    pub fn is_analytic(&self) -> bool {
        self.0.is_analytic()
    }
}

warp::warp_methods! {
    RegionMap, Direction::PushForward,
    " A's texture as the map shows it on B, pixel by pixel, without a mesh: RGBA bytes with straight alpha. `pull-back`"
    " shows on A what lies on B."
}
