//! `PreparedWarp` in JavaScript.

use super::error::Failure;
use super::foveated::FoveatedTexture;
use super::memory;
use super::options;
use super::texture::Texture;
use super::warp::{self, DrawOptions, PaintContext};
use crate::warp::{Direction, PreparedWarp as Prepared, Warp, WarpOptions, buffer};
use js_sys::{Array, Uint8ClampedArray};
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// A warp whose geometry is done: for a picture that changes under a map and a view that do not, as a camera's. Made by the
/// `prepareWarp` methods; good for every texture of the size and wrap mode of the one that it was made with.
#[derive(Debug)]
#[wasm_bindgen]
pub struct PreparedWarp {
    geometry: Prepared,
    /// The newest picture.
    pixels: Vec<u8>,
}

#[wasm_bindgen]
impl PreparedWarp {
    /// The texture as the map shows it: RGBA bytes with straight alpha; `out`, filled, if it was given.
    ///
    /// Throws "other-texture" or "wrong-length".
    pub fn warp(&mut self, texture: &Texture, out: Option<Uint8ClampedArray>) -> Result<Uint8ClampedArray, Failure> {
        self.geometry.warp_into(texture.inner(), &mut self.pixels)?;
        self.given(out)
    }

    /// `warp`, onto a canvas.
    ///
    /// Throws as `warp` does, and what the context throws.
    pub fn paint(&mut self, context: &PaintContext, texture: &Texture) -> Result<(), Failure> {
        self.geometry.warp_into(texture.inner(), &mut self.pixels)?;
        warp::put(context, &self.pixels, self.geometry.size(), 0)
    }

    /// `warp` of a foveated texture, if this was made by `prepareFoveated`.
    ///
    /// Throws as `warp` does.
    #[wasm_bindgen(js_name = warpFoveated)]
    pub fn warp_foveated(
        &mut self,
        texture: &FoveatedTexture,
        out: Option<Uint8ClampedArray>,
    ) -> Result<Uint8ClampedArray, Failure> {
        texture.inner().draw(&self.geometry, &mut self.pixels)?;
        self.given(out)
    }

    /// Columns and rows of what it draws.
    #[wasm_bindgen(getter, unchecked_return_type = "[columns: number, rows: number]")]
    pub fn size(&self) -> Array {
        let [columns, rows] = self.geometry.size().map(|n| (n as f64).into());
        Array::of2(&columns, &rows)
    }

    /// Bytes that its geometry takes.
    #[wasm_bindgen(getter)]
    pub fn bytes(&self) -> usize {
        self.geometry.bytes()
    }

    fn given(&self, out: Option<Uint8ClampedArray>) -> Result<Uint8ClampedArray, Failure> {
        let Some(out) = out else {
            return Ok(Uint8ClampedArray::from(&self.pixels[..]));
        };
        buffer::check("out", out.length() as usize, self.geometry.size())?;
        out.copy_from(&self.pixels);
        Ok(out)
    }
}

/// Bytes of geometry for each byte of a picture, as they grow.
const GEOMETRY: f64 = 9.0;

impl PreparedWarp {
    /// What `make` makes for the options' view, whose pixels there must be room for.
    pub(super) fn make(options: &WarpOptions, make: impl FnOnce() -> crate::Result<Prepared>) -> Result<Self, Failure> {
        memory::room_for(GEOMETRY * options.output_len()? as f64)?;
        Ok(Self { geometry: make()?, pixels: buffer::blank(options.output_size()?)? })
    }
}

/// The warp of `map`, prepared. `usual` is the direction of this kind of map.
///
/// # Errors
/// As [`warp::warp`].
pub fn prepare(
    map: &impl Warp,
    usual: Direction,
    texture: &Texture,
    options: &Ts<DrawOptions>,
) -> Result<PreparedWarp, Failure> {
    let (options, _) = options::read(options)?.split(usual)?;
    PreparedWarp::make(&options, || map.prepare(texture.inner(), &options))
}
