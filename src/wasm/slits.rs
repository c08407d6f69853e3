//! `SlitMap` in JavaScript.

use super::error::Failure;
use super::options::{self, Point};
use super::points;
use super::reading::fields;
use super::region::Region;
use super::riemann::{RiemannOptions, solve_options};
use super::solved::{prepare_method, solved_methods};
use super::warp;
use super::words::words;
use crate::Error;
use crate::map::PlaneMap;
use crate::riemann::SlitKind;
use crate::warp::Direction;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// The name of a region with slits.
#[derive(Clone, Copy, Debug)]
pub enum SlitRegion {
    /// The unit disk with circular slits: `center` goes to 0, `toward` to 1.
    Disk,
    /// A ring with circular slits: one hole goes to the inner circle, `toward` to 1.
    Annulus,
    /// The plane with parallel slits: `center`, or infinity of the outside of bodies, goes to infinity.
    Parallel,
    /// The plane with slits on rays: `center` goes to 0, `pole` to infinity, `toward` to 1.
    Radial,
}

words! {
    /// The name of a region with slits.
    SlitRegion { Disk = "disk", Annulus = "annulus", Parallel = "parallel", Radial = "radial" }
}

/// Which region with slits is wanted.
#[derive(Debug, Tsify)]
pub struct SlitOptions {
    /// Its kind.
    pub kind: SlitRegion,
    /// "parallel": the slits' angle to the x axis in radians; 0 by default.
    #[tsify(optional)]
    pub angle: Option<f64>,
    /// "annulus": the hole that goes to the inner circle, counted from 0; 0 by default.
    #[tsify(optional)]
    pub hole: Option<usize>,
    /// "radial": the point inside that goes to infinity.
    #[tsify(optional)]
    pub pole: Option<Point>,
}
fields!(SlitOptions: kind, angle, hole, pole);

/// The conformal map of a region with any number of holes onto a region with slits.
#[wasm_bindgen]
pub struct SlitMap(Box<dyn PlaneMap>, crate::riemann::SlitMap);

#[wasm_bindgen]
impl SlitMap {
    /// Solves for the map.
    ///
    /// Throws "wrong-region" for a region that lacks what the kind needs, "center-outside" for a pole outside; "cancelled",
    /// "invalid-option", "inaccurate" or "too-few-points".
    pub fn solve(
        region: &Region,
        slits: Ts<SlitOptions>,
        options: Option<Ts<RiemannOptions>>,
    ) -> Result<Self, Failure> {
        let SlitOptions { kind, angle, hole, pole } = options::read(&slits)?;
        let strangers = [
            ("angle", angle.is_some(), matches!(kind, SlitRegion::Parallel), "parallel"),
            ("hole", hole.is_some(), matches!(kind, SlitRegion::Annulus), "annulus"),
            ("pole", pole.is_some(), matches!(kind, SlitRegion::Radial), "radial"),
        ];
        if let Some((name, .., of)) = strangers.iter().find(|(_, is_given, is_its, _)| *is_given && !is_its) {
            return Err(Failure::option(name, &format!("The option \"{name}\" goes with the kind \"{of}\" alone.")));
        }
        let angle = angle.unwrap_or(0.0);
        if !angle.is_finite() {
            return Err(Error::InvalidOption { name: "angle", expected: "a number of radians", value: angle }.into());
        }
        let kind = match kind {
            SlitRegion::Disk => SlitKind::Disk,
            SlitRegion::Annulus => SlitKind::Annulus { hole: hole.unwrap_or(0) },
            SlitRegion::Parallel => SlitKind::Parallel { angle },
            SlitRegion::Radial => SlitKind::Radial {
                pole: pole.ok_or_else(|| Failure::option("pole", "The option \"pole\" is missing."))?.into(),
            },
        };
        let (options, mut progress) = solve_options(options.as_ref())?;
        let solved = crate::riemann::SlitMap::solve(&region.domain(), kind, &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(|map| Self(Box::new(map.clone()), map))
    }

    /// Region → region with slits, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region.
    #[wasm_bindgen(js_name = toSlits)]
    pub fn to_slits(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.to_slits(points))?)
    }

    /// Region with slits → region. Of a point on a slit, one of the two boundary points that go there.
    #[wasm_bindgen(js_name = fromSlits)]
    pub fn from_slits(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.from_slits(points))?)
    }

    /// f' of the map region → region with slits, per plane unit.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(points::mapped(points, |points| self.1.derivative(points))?)
    }

    /// The two ends `[x0, y0, x1, y1]` of every slit, one after another.
    #[wasm_bindgen(getter)]
    pub fn slits(&self) -> Vec<f64> {
        self.1.slits().iter().flat_map(|slit| points::to_flat(&slit.ends)).collect()
    }
}

prepare_method! { SlitMap, 1 }

solved_methods! {
    SlitMap, 1,
    " An estimate of the largest error: of log w, or of w for parallel slits."
}

warp::warp_methods! {
    SlitMap, Direction::PushForward,
    " The texture as the map shows it on the region with slits, pixel by pixel: RGBA bytes with straight alpha."
    " `pull-back` shows on the region what lies on the region with slits."
}
