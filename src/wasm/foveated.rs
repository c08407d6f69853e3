//! `FoveatedTexture` in JavaScript.

use super::error::Failure;
use super::options::{self, FrameOptions, Point};
use super::reading::fields;
use super::texture::{Texture, reader};
use crate::warp::{self, Light};
use js_sys::Uint8Array;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

/// Where a picture lies, and where it needs its detail.
#[derive(Debug, Tsify)]
pub struct FoveatedOptions {
    /// The picture's frame; its pixel counts are the picture's.
    pub picture: FrameOptions,
    /// The point of the plane that is looked at.
    pub fixation: Point,
    /// Pixels along each side of every level, 512 by default.
    #[tsify(optional)]
    pub side: Option<usize>,
    /// "linear" (the default) or "plain": the light in which pixels are averaged.
    #[tsify(optional)]
    pub light: Option<Light>,
}
fields!(FoveatedOptions: picture, fixation, side, light);

/// Pixels along each side of a level, unless asked otherwise.
const SIDE: usize = 512;

/// Full detail where an eye looks: crops of a picture around a point, each twice as wide as the one above it at the same
/// number of pixels. Pixels are taken from the finest level that has them, without visible rings.
#[derive(Debug)]
#[wasm_bindgen]
pub struct FoveatedTexture(warp::FoveatedTexture);

#[wasm_bindgen]
impl FoveatedTexture {
    /// The stack of a picture's RGBA bytes (straight alpha). The picture itself is not kept.
    ///
    /// Throws "wrong-length", "invalid-option", "invalid-frame" or "not-finite".
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | Uint8ClampedArray")] rgba: &Uint8Array,
        options: Ts<FoveatedOptions>,
    ) -> Result<Self, Failure> {
        let FoveatedOptions { picture, fixation, side, light } = options::read(&options)?;
        let (picture, side, light) = (picture.try_into()?, side.unwrap_or(SIDE), light.unwrap_or_default());
        let (length, fixation) = (rgba.length() as usize, fixation.into());
        let stack = warp::FoveatedTexture::around_rows(length, &mut reader(rgba), &picture, fixation, side, light)?;
        Ok(Self(stack))
    }

    /// A stack of one texture, to which closer ones are added: a wide shot and its close-ups, or the crops of a picture
    /// too large to be held at once. The texture is copied.
    pub fn of(texture: &Texture, frame: Ts<FrameOptions>) -> Result<Self, Failure> {
        let frame = options::read(&frame)?.try_into()?;
        Ok(Self(warp::FoveatedTexture::new(vec![(texture.inner().clone(), frame)])?))
    }

    /// Puts a copy of a closer texture on top.
    pub fn add(&mut self, texture: &Texture, frame: Ts<FrameOptions>) -> Result<(), Failure> {
        let frame = options::read(&frame)?.try_into()?;
        self.0.add(texture.inner().clone(), frame);
        Ok(())
    }

    /// Where the crops of a picture lie, the widest first: for pictures that are too large to be held at once, of which each
    /// crop is scaled to `side` pixels square elsewhere, and put together by `of` and `add`.
    ///
    /// Throws "invalid-option", "invalid-frame" or "not-finite".
    pub fn crops(options: Ts<FoveatedOptions>) -> Result<Vec<Ts<FrameOptions>>, Failure> {
        let FoveatedOptions { picture, fixation, side, .. } = options::read(&options)?;
        let crops = warp::FoveatedTexture::crops(&picture.try_into()?, fixation.into(), side.unwrap_or(SIDE))?;
        Ok(crops.into_iter().map(|crop| options::write(FrameOptions::from(crop))).collect())
    }

    /// Number of levels.
    #[wasm_bindgen(getter)]
    pub fn levels(&self) -> usize {
        self.0.levels().len()
    }

    /// Bytes that the levels take.
    #[wasm_bindgen(getter)]
    pub fn bytes(&self) -> usize {
        self.0.bytes()
    }
}

impl FoveatedTexture {
    /// The stack itself, for the classes that warp it.
    #[must_use]
    pub fn inner(&self) -> &warp::FoveatedTexture {
        &self.0
    }
}
