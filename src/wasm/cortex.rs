//! `RetinoCorticalMap` and `CorticalImage` in JavaScript.

use super::error::Failure;
use super::foveated::FoveatedTexture;
use super::memory;
use super::options::{self, FrameOptions, Point};
use super::overlay::{self, OverlayOptions};
use super::points;
use super::prepared::PreparedWarp;
use super::reading::fields;
use super::riemann::RiemannMap;
use super::texture::Texture;
use super::warp::{self, DrawOptions};
use super::words::words;
use crate::Error;
use crate::cortex::{self, CorticalModel, FieldPoint, Gaze, Hemisphere, Landmark, OutlineView, VisualCortex};
use crate::map::{InvertibleMap, Jet, PlaneMap};
use crate::plane::{Complex64, Frame};
use crate::warp::{Direction, Quality, WarpOptions, recovery};
use js_sys::{Array, Object, Reflect, Uint8ClampedArray};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

words! {
    /// The two halves of the brain. Each sees the opposite half of the visual field.
    Hemisphere { Left = "left", Right = "right" }

    /// How an outline of V1 was laid flat.
    ///
    /// V1 is a mirror image of the visual field: seen from outside, with the fovea on the left, the lower field lies above (a left
    /// hemisphere's medial side, dorsal up). Outlines of measured brains are such. The closed formulas draw the upper field
    /// above, which is the mirror image.
    OutlineView { Mirrored = "mirrored", Pial = "pial" }
}

/// A closed formula for the cortex: monopole without `b`, dipole with it, wedge-dipole with `shear` too.
#[derive(Debug, Tsify)]
pub struct CorticalModelOptions {
    /// Scale in millimetres.
    pub k: f64,
    /// Where the map turns from linear to logarithmic, in degrees.
    pub a: f64,
    /// Where the periphery is compressed once more, in degrees; without it the model is a monopole.
    #[tsify(optional)]
    pub b: Option<f64>,
    /// The factor by which azimuths are sheared first, 1 by default. Otherwise the map is not conformal.
    #[tsify(optional)]
    pub shear: Option<f64>,
    /// The largest eccentricity, in degrees; 90 by default.
    #[tsify(optional)]
    pub extent: Option<f64>,
    /// Scales the model to this area in mm², whatever `k` is.
    #[tsify(optional)]
    pub area: Option<f64>,
    /// "left" (the default) sees the right half of the field, "right" the left half.
    #[tsify(optional)]
    pub hemisphere: Option<Hemisphere>,
}
fields!(CorticalModelOptions: k, a, b, shear, extent, area, hemisphere);

impl CorticalModelOptions {
    fn model(&self) -> crate::Result<CorticalModel> {
        let shear = self.shear.unwrap_or(1.0);
        let model = CorticalModel::wedge_dipole(self.k, self.a, self.b.unwrap_or(f64::INFINITY), shear)?;
        let model = self.extent.map_or(Ok(model), |extent| model.up_to(extent))?;
        self.area.map_or(Ok(model), |area| model.with_area(area))
    }
}

/// What fixes the map of an outline: a landmark of the field and the way of the horizontal meridian there.
#[derive(Debug, Tsify)]
pub struct LandmarkOptions {
    /// The landmark in the right half of the field, in degrees; the blind spot, [15, −1.5], by default. It goes to the
    /// center of the outline's region.
    #[tsify(optional)]
    pub landmark: Option<Point>,
    /// Which way the cortex runs there as one moves away from the fovea, parallel to the horizontal meridian: radians,
    /// counter-clockwise from the cortex plane's x axis.
    pub direction: f64,
    /// From which side the outline is seen. V1 is a mirror image of the field: an outline of a measured brain, laid flat as it
    /// is seen from outside ("pial"), has the lower field above, where the fovea is on the left. "mirrored" (the
    /// default) has the upper field above, as the closed formulas do.
    #[tsify(optional)]
    pub view: Option<OutlineView>,
    /// "left" (the default), as the outline is, or "right": its mirror image.
    #[tsify(optional)]
    pub hemisphere: Option<Hemisphere>,
}
fields!(LandmarkOptions: landmark, direction, view, hemisphere);

/// An eye before a picture.
#[derive(Debug, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct GazeOptions {
    /// Where the picture lies in its plane.
    pub picture: FrameOptions,
    /// The angle that the picture's width spans, in degrees.
    pub field_of_view: f64,
    /// The point of the picture's plane that is fixated.
    pub fixation: Point,
}
fields!(GazeOptions: picture, field_of_view, fixation);

/// A picture on the cortex at finite resolution, and where it is drawn back.
#[derive(Debug, Tsify)]
pub struct RecoverOptions {
    /// Where the texture lies in the picture's plane.
    pub texture: FrameOptions,
    /// The cortical image's frame: `RetinoCorticalMap.frame` makes one of so many pixels a millimetre.
    pub cortex: FrameOptions,
    /// Which part of the picture's plane is drawn.
    pub view: FrameOptions,
    /// "trilinear" by default, there and back.
    #[tsify(optional)]
    pub quality: Option<Quality>,
    /// The other hemisphere's half, to which this one is added.
    #[tsify(optional, type = "Uint8ClampedArray")]
    pub out: Option<Uint8ClampedArray>,
}
fields!(RecoverOptions: texture, cortex, view, quality, out);

/// The map visual field → V1 of one hemisphere. Points of the field are E·e^{iθ} in degrees, `[x0, y0, x1, y1, …]` with x to
/// the right and y up as the eye sees them; points of the cortex are in millimetres.
#[derive(Debug)]
#[wasm_bindgen]
pub struct RetinoCorticalMap {
    cortex: VisualCortex,
    /// How far an outline's map misses its landmark.
    landmark_error: Option<[f64; 2]>,
}

/// An outline has two corners and three sides.
const LEAST_VERTICES: usize = 6;

#[wasm_bindgen]
impl RetinoCorticalMap {
    /// The map of a closed formula, the fovea at 0: k log((z + a)/(z + b)) + k log(b/a), or k log((z + a)/a).
    ///
    /// Throws "invalid-map" or "invalid-option".
    pub fn model(options: Ts<CorticalModelOptions>) -> Result<Self, Failure> {
        let options = options::read(&options)?;
        let cortex = VisualCortex::from_model(options.model()?, options.hemisphere.unwrap_or_default());
        Ok(Self { cortex, landmark_error: None })
    }

    /// The map of an outline of V1, from the map that was solved for it: stereographic half disk → disk → outline.
    ///
    /// Throws "invalid-map" if the landmark is not inside the right half of the field, or "invalid-option".
    pub fn outline(map: &RiemannMap, options: Ts<LandmarkOptions>) -> Result<Self, Failure> {
        let LandmarkOptions { landmark, direction, view, hemisphere } = options::read(&options)?;
        let (view, hemisphere) = (view.unwrap_or_default(), hemisphere.unwrap_or_default());
        let field = field_point(landmark.map(Into::into));
        let cortex = map.inner().region().center();
        let landmark = Landmark { field: view.coordinate(field.coordinate()), cortex, direction };
        let chain = cortex::RetinoCorticalMap::new(map.inner().clone(), landmark)?;
        let landmark_error = Some(chain.landmark_error());
        Ok(Self { cortex: VisualCortex::from_view(chain, map.inner().region(), view, hemisphere), landmark_error })
    }

    /// The outline of V1 under a closed formula, a polygon of so many vertices, 6 at least, in millimetres: a model, not a measurement.
    /// It begins at the fovea and is that of a left hemisphere.
    ///
    /// Throws "invalid-map" or "invalid-option".
    #[wasm_bindgen(js_name = modelOutline)]
    pub fn model_outline(
        options: Ts<CorticalModelOptions>,
        #[wasm_bindgen(unchecked_param_type = "Count")] vertices: usize,
    ) -> Result<Vec<f64>, Failure> {
        let model = options::read(&options)?.model()?;
        if vertices < LEAST_VERTICES {
            let value = vertices as f64;
            return Err(Error::InvalidOption { name: "vertices", expected: "at least 6", value }.into());
        }
        memory::room_for(64.0 * vertices as f64)?;
        Ok(points::to_flat(&model.outline(vertices)))
    }

    /// The landmark by which `outline` makes of `modelOutline` the closed formula's map again, but for its scale of
    /// eccentricity: the place of `landmark` (the blind spot by default, in degrees) on the cortex, to be the region's
    /// center, and the direction of the horizontal meridian there.
    ///
    /// Throws "invalid-map" or "invalid-option".
    #[wasm_bindgen(js_name = modelLandmark, unchecked_return_type = "{ center: [x: number, y: number], direction: number }")]
    pub fn model_landmark(options: Ts<CorticalModelOptions>, landmark: Option<Ts<Point>>) -> Result<Object, Failure> {
        let model = options::read(&options)?.model()?;
        let landmark = landmark.map(|point| options::read_point("landmark", &point)).transpose()?;
        let field = field_point(landmark).coordinate();
        // As `outline` refuses it.
        cortex::HalfDiskMap::new(field, 0.0)?;
        let Landmark { cortex, direction, .. } = model.landmark(field);
        let found = Object::new();
        // Setting a property of an object that was just made does not fail.
        let _ = Reflect::set(&found, &"center".into(), &points::pair(cortex));
        let _ = Reflect::set(&found, &"direction".into(), &direction.into());
        Ok(found)
    }

    /// Visual field → cortex; NaN in the other half of the field.
    #[wasm_bindgen(js_name = toCortex)]
    pub fn to_cortex(&self, field: &[f64]) -> Result<Vec<f64>, Failure> {
        let field = points::from_flat("The points", field)?;
        Ok(values(field.len(), |jets| self.cortex.jets(&field, jets)))
    }

    /// Cortex → visual field; NaN outside V1.
    #[wasm_bindgen(js_name = toField)]
    pub fn to_field(&self, cortex: &[f64]) -> Result<Vec<f64>, Failure> {
        let cortex = points::from_flat("The points", cortex)?;
        Ok(values(cortex.len(), |jets| self.cortex.inverse_jets(&cortex, jets)))
    }

    /// Cortical magnification at points of the field, in mm per degree.
    pub fn magnification(&self, field: &[f64]) -> Result<Vec<f64>, Failure> {
        Ok(self.cortex.magnification(&points::from_flat("The points", field)?))
    }

    /// The outline of the cortex as a polygon, counter-clockwise in millimetres.
    #[wasm_bindgen(getter)]
    pub fn boundary(&self) -> Vec<f64> {
        points::to_flat(self.cortex.outline())
    }

    /// The area of the cortex, in mm².
    #[wasm_bindgen(getter)]
    pub fn area(&self) -> f64 {
        self.cortex.area()
    }

    /// How far the map of an outline misses the correspondence asked for: the landmark's place in mm, and the meridian's
    /// direction there in radians. Undefined for a formula, which has no landmark.
    #[wasm_bindgen(getter, js_name = landmarkError, unchecked_return_type = "[distance: number, angle: number] | undefined")]
    pub fn landmark_error(&self) -> Option<Array> {
        self.landmark_error.map(|[distance, angle]| Array::of2(&distance.into(), &angle.into()))
    }

    /// The frame around the cortex with so many pixels a millimetre.
    ///
    /// Throws "invalid-option".
    pub fn frame(&self, dots_per_millimetre: f64) -> Result<Ts<FrameOptions>, Failure> {
        Ok(options::write(FrameOptions::from(self.cortex.frame(dots_per_millimetre)?)))
    }

    /// What this cortex sees of a picture.
    ///
    /// Throws "invalid-option" or "invalid-frame".
    pub fn seeing(&self, gaze: Ts<GazeOptions>) -> Result<CorticalImage, Failure> {
        let GazeOptions { picture, field_of_view, fixation } = options::read(&gaze)?;
        let picture: Frame = picture.try_into()?;
        Ok(CorticalImage(self.cortex.seeing(Gaze::new(&picture, field_of_view, fixation.into())?)))
    }

    /// Rings and rays of the visual field, or another drawing of the map cortex → field in degrees, over a view of the
    /// cortex.
    ///
    /// Throws "invalid-option", "invalid-frame", "invalid-rows" or "wrong-length".
    pub fn overlay(&self, options: Ts<OverlayOptions>) -> Result<Uint8ClampedArray, Failure> {
        overlay::draw(&self.cortex.clone().inverted(), &options)
    }
}

/// What a cortex sees of a picture: the map cortex → picture.
#[derive(Debug)]
#[wasm_bindgen]
pub struct CorticalImage(cortex::CorticalImage);

#[wasm_bindgen]
impl CorticalImage {
    /// `warp` of a foveated texture, each of whose levels has its own frame: `options.texture` is not used.
    ///
    /// Throws as `warp` does.
    #[wasm_bindgen(js_name = warpFoveated)]
    pub fn warp_foveated(
        &self,
        texture: &FoveatedTexture,
        options: Ts<DrawOptions>,
    ) -> Result<Uint8ClampedArray, Failure> {
        warp::draw(Direction::PullBack, &options, |options| texture.inner().warp(&self.0, options))
    }

    /// `warpFoveated` with all but the sampling done: for stacks of other pictures with the same frames. It is drawn by
    /// the prepared warp's `warpFoveated`.
    ///
    /// Throws as `warp` does.
    #[wasm_bindgen(js_name = prepareFoveated)]
    pub fn prepare_foveated(
        &self,
        texture: &FoveatedTexture,
        options: Ts<DrawOptions>,
    ) -> Result<PreparedWarp, Failure> {
        let (options, _) = options::read(&options)?.split(Direction::PullBack)?;
        PreparedWarp::make(&options, || texture.inner().prepare(&self.0, &options))
    }

    /// The half of the picture that this cortex sees, as far as it can be recovered from the cortical image: that is kept on
    /// the pixels of `options.cortex` and drawn back. RGBA bytes; added to `out`, if it was given: the other hemisphere's.
    ///
    /// Throws as `warp` does.
    pub fn recover(&self, texture: &Texture, options: Ts<RecoverOptions>) -> Result<Uint8ClampedArray, Failure> {
        let RecoverOptions { texture: frame, cortex, view, quality, out } = options::read(&options)?;
        let options = WarpOptions {
            quality: quality.unwrap_or_default(),
            ..WarpOptions::new(frame.try_into()?, view.try_into()?)
        };
        let half = recovery::recover(&self.0, &cortex.try_into()?, texture.inner(), &options)?;
        let Some(out) = out else {
            return Ok(Uint8ClampedArray::from(&half[..]));
        };
        let mut sum = out.to_vec();
        recovery::add(&mut sum, &half)?;
        out.copy_from(&sum);
        Ok(out)
    }

    /// Cortex → picture, point by point `[x0, y0, x1, y1, …]`; NaN outside V1.
    #[wasm_bindgen(js_name = toPicture)]
    pub fn to_picture(&self, cortex: &[f64]) -> Result<Vec<f64>, Failure> {
        let cortex = points::from_flat("The points", cortex)?;
        Ok(values(cortex.len(), |jets| self.0.jets(&cortex, jets)))
    }
}

warp::warp_methods! {
    CorticalImage, Direction::PullBack,
    " The picture on the cortex: RGBA bytes with straight alpha; `out`, filled, if it was given. The view is a frame of"
    " the cortex in millimetres."
}

/// A point of the field in degrees, the blind spot by default.
fn field_point(degrees: Option<Complex64>) -> FieldPoint {
    degrees.map_or(FieldPoint::BLIND_SPOT, FieldPoint::from_degrees)
}

fn values(count: usize, fill: impl FnOnce(&mut [Jet])) -> Vec<f64> {
    let mut jets = vec![Jet::UNDEFINED; count];
    fill(&mut jets);
    jets.iter().flat_map(|jet| [jet.value.re, jet.value.im]).collect()
}
