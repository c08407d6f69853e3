//! Frames in JavaScript: pixels ↔ plane.

use super::error::Failure;
use super::options::{self, FrameOptions};
use super::points;
use crate::plane::{Complex64, Frame};
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// Pixel coordinates → plane, `[x0, y0, x1, y1, …]` both: what a pointer shows. The middle of pixel (i, j) is at
/// (i + ½, j + ½), rows are counted downwards; the plane's y points up.
///
/// Throws "invalid-option", "invalid-frame" or "wrong-length".
#[wasm_bindgen(js_name = frameToPlane)]
pub fn frame_to_plane(frame: Ts<FrameOptions>, pixels: &[f64]) -> Result<Vec<f64>, Failure> {
    moved(&frame, "The pixels", pixels, |frame, at| frame.to_plane(at.re, at.im))
}

/// Plane → pixel coordinates: where in the picture points lie. The inverse of `frameToPlane`.
///
/// Throws "invalid-option", "invalid-frame" or "wrong-length".
#[wasm_bindgen(js_name = frameToPixels)]
pub fn frame_to_pixels(frame: Ts<FrameOptions>, points: &[f64]) -> Result<Vec<f64>, Failure> {
    moved(&frame, "The points", points, |frame, z| {
        let (x, y) = frame.to_pixels(z);
        Complex64::new(x, y)
    })
}

fn moved(
    frame: &Ts<FrameOptions>,
    what: &'static str,
    flat: &[f64],
    to: impl Fn(&Frame, Complex64) -> Complex64,
) -> Result<Vec<f64>, Failure> {
    let frame: Frame = options::read(frame)?.try_into()?;
    let moved: Vec<Complex64> = points::from_flat(what, flat)?.into_iter().map(|at| to(&frame, at)).collect();
    Ok(points::to_flat(&moved))
}
