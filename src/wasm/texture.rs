//! `Texture` in JavaScript.

use super::error::Failure;
use super::options;
use super::reading::fields;
use super::words::words;
use crate::warp::{self, Light, Wrap};
use js_sys::{Array, Uint8Array};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** A picture's pixels: an `ImageData`, or what has the same parts. */
export interface Pixels {
    readonly data: Uint8ClampedArray;
    readonly width: Count;
    readonly height: Count;
}
";

#[wasm_bindgen]
extern "C" {
    /// `Pixels`.
    pub type Picture;
    /// Clamped or not, its elements are bytes.
    #[wasm_bindgen(method, getter, structural)]
    fn data(this: &Picture) -> Uint8Array;
    #[wasm_bindgen(method, getter, structural)]
    fn width(this: &Picture) -> usize;
    #[wasm_bindgen(method, getter, structural)]
    fn height(this: &Picture) -> usize;
}

/// Reads a row at a time from JavaScript's memory: a picture of 100 megapixels would take 0.4 GB of the module's for a moment, and that
/// is never given back.
pub(super) fn reader(rgba: &Uint8Array) -> impl FnMut(usize, &mut [u8]) {
    |row, line| {
        let start = row * line.len();
        rgba.subarray(start as u32, (start + line.len()) as u32).copy_to(line);
    }
}

words! {
    /// What lies beyond the edges of a texture that is pulled back.
    Wrap { Transparent = "transparent", Clamp = "clamp", Repeat = "repeat", Mirror = "mirror" }

    /// The quantity that is averaged when texels become the coarser levels of a texture, and interpolated in the best quality.
    Light { Linear = "linear", Plain = "plain" }
}

/// How a texture continues, and in which light it is filtered.
#[derive(Debug, Default, Tsify)]
pub struct TextureOptions {
    /// What lies beyond the edges where the texture is pulled back; "transparent" by default.
    #[tsify(optional)]
    pub wrap: Option<Wrap>,
    /// "linear" (the default) averages the light itself, decoded from sRGB; "plain" the bytes as they are.
    #[tsify(optional)]
    pub light: Option<Light>,
}
fields!(TextureOptions: wrap, light);

/// A picture made ready for warping: a mip pyramid. Built once; a warp never copies it.
#[derive(Debug)]
#[wasm_bindgen]
pub struct Texture(warp::Texture);

#[wasm_bindgen]
impl Texture {
    /// A texture of RGBA bytes with straight alpha, row by row: 4 · width · height of them, as in `ImageData.data`.
    ///
    /// Throws "wrong-length", "texture-too-large" or "invalid-option".
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | Uint8ClampedArray")] rgba: &Uint8Array,
        #[wasm_bindgen(unchecked_param_type = "Count")] width: usize,
        #[wasm_bindgen(unchecked_param_type = "Count")] height: usize,
        options: Option<Ts<TextureOptions>>,
    ) -> Result<Self, Failure> {
        let TextureOptions { wrap, light } = options::read_or_default(options.as_ref())?;
        let length = rgba.length() as usize;
        Ok(Self(warp::Texture::from_rows(
            length,
            [width, height],
            wrap.unwrap_or_default(),
            light.unwrap_or_default(),
            &mut reader(rgba),
        )?))
    }

    /// A texture of what a canvas holds: `Texture.fromImageData(context.getImageData(0, 0, width, height))`.
    ///
    /// Throws as the constructor does.
    #[wasm_bindgen(js_name = fromImageData)]
    pub fn from_image_data(
        #[wasm_bindgen(unchecked_param_type = "Pixels")] image: &Picture,
        options: Option<Ts<TextureOptions>>,
    ) -> Result<Self, Failure> {
        Self::new(&image.data(), image.width(), image.height(), options)
    }

    /// Shows another picture of the same size, in the same memory: a camera's next frame.
    ///
    /// Throws "wrong-length".
    pub fn replace(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Uint8Array | Uint8ClampedArray")] rgba: &Uint8Array,
    ) -> Result<(), Failure> {
        Ok(self.0.replace_rows(rgba.length() as usize, &mut reader(rgba))?)
    }

    /// Columns and rows of the picture.
    #[wasm_bindgen(getter, unchecked_return_type = "[columns: number, rows: number]")]
    pub fn size(&self) -> Array {
        let [columns, rows] = self.0.size().map(|n| (n as f64).into());
        Array::of2(&columns, &rows)
    }
}

impl Texture {
    /// The texture itself, for the classes that warp it.
    #[must_use]
    pub fn inner(&self) -> &warp::Texture {
        &self.0
    }
}
