//! What the `warp` and `paint` methods of all classes share.

use super::error::Failure;
use super::options::{self, FrameOptions};
use super::reading::fields;
use super::texture::Texture;
use super::words::words;
use crate::warp::{Direction, Quality, Warp, WarpOptions, buffer};
use js_sys::Uint8ClampedArray;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{Clamped, JsValue};
use web_sys::ImageData;

words! {
    /// Which way a map is used.
    Direction { PullBack = "pull-back", PushForward = "push-forward" }

    /// How texels become a pixel, from fast to good.
    Quality { Nearest = "nearest", Bilinear = "bilinear", Trilinear = "trilinear", Best = "best" }
}

/// How a texture is to be warped.
#[derive(Debug, Tsify)]
#[tsify(rename = "WarpOptions")]
pub struct DrawOptions {
    /// Where the texture lies in the plane. The texture is stretched over the frame, whatever its pixel counts.
    pub texture: FrameOptions,
    /// Which part of the plane is drawn, and on how many pixels.
    pub view: FrameOptions,
    /// "pull-back": the view's point p shows the texture at f(p). "push-forward": the points z of the texture's frame are
    /// shown, once, each at f(z); what lies beyond the frame is not drawn, whatever the texture's wrap mode. By default a formula pulls back, and what has a domain of its own (a region's map, a mesh, the cortex) pushes
    /// forward.
    #[tsify(optional)]
    pub direction: Option<Direction>,
    /// How texels become a pixel, from fast to good; "trilinear" by default.
    #[tsify(optional)]
    pub quality: Option<Quality>,
    /// The bytes to fill instead of new ones: 4 · columns · rows of them.
    #[tsify(optional, type = "Uint8ClampedArray")]
    pub out: Option<Uint8ClampedArray>,
    /// The band of rows to draw, [first, the one after the last]. Bands drawn apart make the same pixels as the whole.
    #[tsify(optional, type = "[first: Count, end: Count]")]
    pub rows: Option<[usize; 2]>,
}
fields!(DrawOptions: texture, view, direction, quality, out, rows);

impl DrawOptions {
    /// What the warp takes, and the bytes to fill.
    pub(super) fn split(self, usual: Direction) -> Result<(WarpOptions, Option<Uint8ClampedArray>), Failure> {
        let options = WarpOptions {
            texture: self.texture.try_into()?,
            view: self.view.try_into()?,
            direction: self.direction.unwrap_or(usual),
            quality: self.quality.unwrap_or_default(),
            rows: self.rows.map(|[first, end]| first..end),
        };
        Ok((options, self.out))
    }
}

/// The map's picture of the texture: RGBA bytes with straight alpha, `out` itself if it was given. `usual` is the
/// direction of this kind of map.
///
/// # Errors
/// "invalid-option", "invalid-frame", "invalid-rows", "wrong-length", and those of the map.
pub fn warp(
    map: &impl Warp,
    usual: Direction,
    texture: &Texture,
    options: &Ts<DrawOptions>,
) -> Result<Uint8ClampedArray, Failure> {
    draw(usual, options, |options| map.warp(texture.inner(), options))
}

/// The pixels of `picture`, in `out` if it was given.
///
/// # Errors
/// As [`warp`].
pub fn draw(
    usual: Direction,
    options: &Ts<DrawOptions>,
    picture: impl FnOnce(&WarpOptions) -> crate::Result<Vec<u8>>,
) -> Result<Uint8ClampedArray, Failure> {
    let (options, out) = options::read(options)?.split(usual)?;
    let Some(out) = out else {
        let pixels = picture(&options)?;
        return Ok(Uint8ClampedArray::from(&pixels[..]));
    };
    buffer::check("out", out.length() as usize, options.output_size()?)?;
    out.copy_from(&picture(&options)?);
    Ok(out)
}

/// [`warp`], onto a canvas, whose pixel (0, 0) is the view's.
///
/// # Errors
/// As [`warp`], and what the context throws.
pub fn paint(
    map: &impl Warp,
    usual: Direction,
    context: &PaintContext,
    texture: &Texture,
    options: &Ts<DrawOptions>,
) -> Result<(), Failure> {
    let (options, _) = options::read(options)?.split(usual)?;
    let rows = options.checked_rows()?;
    if rows.is_empty() {
        return Ok(());
    }
    let pixels = map.warp(texture.inner(), &options)?;
    put(context, &pixels, [options.view.pixels()[0], rows.len()], rows.start)
}

/// Puts pixels onto a canvas from its row `top`.
///
/// # Errors
/// "no-image-data", and what the context throws.
pub fn put(context: &PaintContext, pixels: &[u8], size: [usize; 2], top: usize) -> Result<(), Failure> {
    let [width, height] = size.map(|n| n as u32);
    let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(pixels), width, height).map_err(|_| {
        Failure::new("no-image-data", "There is no ImageData here, as under Node: warp() gives the pixels.")
    })?;
    context.put_image_data(&image, 0.0, top as f64).map_err(Failure::thrown)
}

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** The 2D context of a canvas, on the page or off it. */
export interface PaintContext {
    putImageData(image: any, x: number, y: number): void;
}
";

/// Gives a class the methods `warp`, `paint` and `prepareWarp` of the map in its first field: the usual direction of this
/// kind of map, and what `warp` shows, line by line (as strings, which the generated types quote as they are).
macro_rules! warp_methods {
    ($class:ident, $usual:expr, $($shows:tt)*) => {
        #[wasm_bindgen::prelude::wasm_bindgen]
        impl $class {
            $(#[doc = $shows])*
            ///
            /// Throws "invalid-option", "invalid-frame", "invalid-rows" or "wrong-length".
            pub fn warp(
                &self,
                texture: &$crate::wasm::texture::Texture,
                options: tsify::Ts<$crate::wasm::warp::DrawOptions>,
            ) -> Result<js_sys::Uint8ClampedArray, $crate::wasm::error::Failure> {
                $crate::wasm::warp::warp(&self.0, $usual, texture, &options)
            }

            /// `warp`, onto a canvas, whose pixel (0, 0) is the view's.
            ///
            /// Throws as `warp` does, "no-image-data" where there are no canvases, and what the context throws.
            pub fn paint(
                &self,
                context: &$crate::wasm::warp::PaintContext,
                texture: &$crate::wasm::texture::Texture,
                options: tsify::Ts<$crate::wasm::warp::DrawOptions>,
            ) -> Result<(), $crate::wasm::error::Failure> {
                $crate::wasm::warp::paint(&self.0, $usual, context, texture, &options)
            }

            /// `warp` with all but the sampling done, for pictures that change. `out` is not used.
            ///
            /// Throws as `warp` does.
            #[wasm_bindgen(js_name = prepareWarp)]
            pub fn prepare_warp(
                &self,
                texture: &$crate::wasm::texture::Texture,
                options: tsify::Ts<$crate::wasm::warp::DrawOptions>,
            ) -> Result<$crate::wasm::prepared::PreparedWarp, $crate::wasm::error::Failure> {
                $crate::wasm::prepared::prepare(&self.0, $usual, texture, &options)
            }
        }
    };
}
pub(super) use warp_methods;

#[wasm_bindgen]
extern "C" {
    /// The 2D context of a canvas, on the page or off it.
    #[wasm_bindgen(typescript_type = "PaintContext")]
    #[derive(Debug)]
    pub type PaintContext;

    #[wasm_bindgen(method, catch, structural, js_name = putImageData)]
    fn put_image_data(this: &PaintContext, image: &ImageData, x: f64, y: f64) -> Result<(), JsValue>;
}
