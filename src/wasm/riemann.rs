//! `RiemannMap` in JavaScript.

use super::canonical::joinable;
use super::error::Failure;
use super::memory;
use super::options::{self, Point};
use super::points;
use super::prepared::{self, PreparedWarp};
use super::progress::Progress;
use super::reading::fields;
use super::region::Region;
use super::texture::Texture;
use super::warp::{self, DrawOptions, PaintContext};
use super::words::words;
use crate::symm::options::{SolveOptions, Stop};
use crate::warp::Direction;
use js_sys::{Function, Uint8ClampedArray};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

words! {
    /// Why a solve ended.
    Stop {
        Tolerance = "tolerance", MaxUnknowns = "max-unknowns", SamePanels = "same-panels", TooFewPoints = "too-few-points",
        Stagnation = "stagnation"
    }
}

/// What a solve should reach, and what it may spend.
#[derive(Debug, Default, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(rename = "SolveOptions")]
pub struct RiemannOptions {
    /// The largest error of the map that is acceptable, the disk having radius 1; 1e-8 by default.
    #[tsify(optional)]
    pub tolerance: Option<f64>,
    /// The largest number of unknowns.
    #[tsify(optional)]
    pub max_unknowns: Option<usize>,
    /// Most centers, 1 to 64, 64 by default, whose maps are solved and linked so that the far ends of long regions stay apart.
    #[tsify(optional)]
    pub max_charts: Option<usize>,
    /// Told the stage and the fraction of it that is done; `false` cancels, and the solve throws "cancelled".
    #[tsify(optional, type = "(stage: string, fraction: number) => boolean | void")]
    pub on_progress: Option<Function>,
}
fields!(RiemannOptions: tolerance, max_unknowns, max_charts, on_progress);

/// The options of a solve, and whom it tells how far it is.
///
/// # Errors
/// "invalid-option".
pub fn solve_options(given: Option<&Ts<RiemannOptions>>) -> Result<(SolveOptions, Progress), Failure> {
    let given = options::read_or_default(given)?;
    let defaults = SolveOptions::default();
    let options = SolveOptions {
        tolerance: given.tolerance.unwrap_or(defaults.tolerance),
        max_unknowns: given.max_unknowns.unwrap_or(defaults.max_unknowns),
        max_charts: given.max_charts.unwrap_or(defaults.max_charts),
    };
    Ok((options, Progress::new(given.on_progress)))
}

/// Another center for a region that was already solved.
#[derive(Debug, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct CenterOptions {
    /// The point strictly inside that goes to 0.
    pub center: Point,
    /// The boundary point that goes to 1; snapped to the nearest point of the boundary.
    pub toward: Point,
    /// The largest acceptable error; by default the one that the map was made with. With a looser one, for drafts, a center
    /// may lie further from that of the solve before anything is solved again.
    #[tsify(optional)]
    pub tolerance: Option<f64>,
    /// As in `solve`.
    #[tsify(optional, type = "(stage: string, fraction: number) => boolean | void")]
    pub on_progress: Option<Function>,
}
fields!(CenterOptions: center, toward, tolerance, on_progress);

/// The conformal map region → unit disk with `center` → 0 and `toward` → 1, by Symm's method.
#[derive(Debug)]
#[wasm_bindgen]
pub struct RiemannMap(crate::riemann::RiemannMap);

#[wasm_bindgen]
impl RiemannMap {
    /// Solves Symm's equation for the region. The map keeps its own copy of it.
    ///
    /// Throws "cancelled", "invalid-option", or "negative-mass" if no trustworthy map was found.
    pub fn solve(region: &Region, options: Option<Ts<RiemannOptions>>) -> Result<Self, Failure> {
        let region = region.simple("A Riemann map")?;
        let (options, mut progress) = solve_options(options.as_ref())?;
        memory::reserve(region.boundary().len());
        let solved = crate::riemann::RiemannMap::solve(region, &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(solved).map(Self)
    }

    /// The map of the same boundary with another center and direction. What was solved for is used again: the map followed by an
    /// automorphism of the disk, as long as `errorEstimate`, which that stretches, meets the tolerance.
    ///
    /// Throws as `new Region()` and `solve` do.
    #[wasm_bindgen(js_name = withCenter)]
    pub fn with_center(&self, options: Ts<CenterOptions>) -> Result<Self, Failure> {
        let CenterOptions { center, toward, tolerance, on_progress } = options::read(&options)?;
        let mut progress = Progress::new(on_progress);
        let mut report = |stage, fraction| progress.report(stage, fraction);
        let (center, toward) = (center.into(), toward.into());
        let solved = match tolerance {
            Some(tolerance) => self.0.with_center_within(center, toward, tolerance, &mut report),
            None => self.0.with_center(center, toward, &mut report),
        };
        progress.finish(solved).map(Self)
    }

    /// The solved map as bytes, to be stored or sent to a worker: `RiemannMap.fromBytes` makes the same map of them, to the bit,
    /// without solving.
    #[wasm_bindgen(js_name = toBytes)]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.0.to_bytes()
    }

    /// The map that `toBytes` stored, by this version or an older one. What `withCenter` needs is made at its first call.
    ///
    /// Throws "not-stored", "other-format" or "damaged", whatever the bytes are; nothing is believed of them that they do not
    /// bear out.
    #[wasm_bindgen(js_name = fromBytes)]
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Failure> {
        memory::reserve(0);
        Ok(Self(crate::riemann::RiemannMap::from_bytes(bytes)?))
    }

    /// Region → disk, point by point `[x0, y0, x1, y1, …]`; NaN outside the closed region.
    ///
    /// The first call builds what is needed, and the first that falls into a far end solves for more: seconds for thousands of
    /// vertices or long corridors. `prepare` does all of it before, with progress.
    #[wasm_bindgen(js_name = toDisk)]
    pub fn to_disk(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.evaluated().to_disk(&points)))
    }

    /// Disk → region, the inverse of `toDisk`; NaN outside the closed disk. What a long region crowds into an arc that double
    /// precision cannot resolve comes back only roughly.
    #[wasm_bindgen(js_name = fromDisk)]
    pub fn from_disk(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.evaluated().from_disk(&points)))
    }

    /// f' of the map region → disk, per plane unit; NaN outside the closed region, infinite at a re-entrant vertex.
    pub fn derivative(&self, points: &[f64]) -> Result<Vec<f64>, Failure> {
        let points = points::from_flat("The points", points)?;
        Ok(points::to_flat(&self.evaluated().derivative(&points)))
    }

    /// Builds what makes evaluation fast now, both ways and for far ends, instead of at its first use: afterwards no call for
    /// points, meshes or pictures has anything left to build. `onProgress` is told the stage and the fraction
    /// of it that is done; `false` cancels.
    ///
    /// Throws "cancelled", and what `onProgress` throws. What was built by then is kept.
    pub fn prepare(
        &self,
        #[wasm_bindgen(
            js_name = onProgress,
            unchecked_optional_param_type = "(stage: string, fraction: number) => boolean | void"
        )]
        on_progress: Option<Function>,
    ) -> Result<(), Failure> {
        let mut progress = Progress::new(on_progress);
        let prepared = self.evaluated().prepare(&mut |stage, fraction| progress.report(stage, fraction));
        progress.finish(prepared)
    }

    /// `[x, y]` where far parts of the region crowd together most, if evaluation had to accept that, as with few `maxCharts`:
    /// errors in the plane are there more than twenty times those in the disk. Builds what `toDisk` builds at its first use.
    #[wasm_bindgen(getter, js_name = crowdedAt, unchecked_return_type = "[x: number, y: number] | undefined")]
    pub fn crowded_at(&self) -> Option<Vec<f64>> {
        self.evaluated().crowded_at().map(|z| vec![z.re, z.im])
    }

    /// Bytes that this takes; 0 before its first use.
    #[wasm_bindgen(getter, js_name = evaluatorBytes)]
    pub fn evaluator_bytes(&self) -> usize {
        self.0.evaluator_bytes()
    }

    /// The texture as the map shows it on the disk, pixel by pixel, without a mesh: RGBA bytes with straight alpha.
    /// "pull-back" shows on the region what lies on the disk.
    ///
    /// Throws "invalid-option", "invalid-frame", "invalid-rows" or "wrong-length".
    pub fn warp(&self, texture: &Texture, options: Ts<DrawOptions>) -> Result<Uint8ClampedArray, Failure> {
        warp::warp(&self.0, Direction::PushForward, texture, &options)
    }

    /// `warp`, onto a canvas.
    ///
    /// Throws as `warp` does, and what the context throws.
    pub fn paint(&self, context: &PaintContext, texture: &Texture, options: Ts<DrawOptions>) -> Result<(), Failure> {
        warp::paint(&self.0, Direction::PushForward, context, texture, &options)
    }

    /// `warp` with all but the sampling done, for pictures that change. `out` is not used.
    ///
    /// Throws as `warp` does.
    #[wasm_bindgen(js_name = prepareWarp)]
    pub fn prepare_warp(&self, texture: &Texture, options: Ts<DrawOptions>) -> Result<PreparedWarp, Failure> {
        prepared::prepare(&self.0, Direction::PushForward, texture, &options)
    }

    /// The angle of each boundary vertex on the circle, in [0, 2π), with `toward` at 0.
    #[wasm_bindgen(getter)]
    pub fn angles(&self) -> Vec<f64> {
        self.0.angles().to_vec()
    }

    /// 1 / |f'(center)|, in plane units.
    #[wasm_bindgen(getter, js_name = conformalRadius)]
    pub fn conformal_radius(&self) -> f64 {
        self.0.conformal_radius()
    }

    /// An estimate of the largest error of the map, the disk having radius 1.
    #[wasm_bindgen(getter, js_name = errorEstimate)]
    pub fn error_estimate(&self) -> f64 {
        self.0.error_estimate()
    }

    /// The largest violation of |f| = 1 on the boundary, at points where it was not imposed.
    #[wasm_bindgen(getter)]
    pub fn residual(&self) -> f64 {
        self.0.residual()
    }

    /// Why the solve ended: with the tolerance met, or short of it.
    #[wasm_bindgen(getter, unchecked_return_type = "Stop")]
    pub fn stop(&self) -> JsValue {
        self.0.stop().into()
    }

    /// How many unknowns were solved for.
    #[wasm_bindgen(getter)]
    pub fn unknowns(&self) -> usize {
        self.0.unknowns()
    }
}

joinable!(RiemannMap, 0);

impl RiemannMap {
    /// The map itself, for the classes that are made from one.
    #[must_use]
    pub fn inner(&self) -> &crate::riemann::RiemannMap {
        &self.0
    }

    /// The map itself, with room for the evaluator that its first use builds.
    fn evaluated(&self) -> &crate::riemann::RiemannMap {
        if self.0.evaluator_bytes() == 0 {
            memory::reserve(0);
        }
        &self.0
    }
}
