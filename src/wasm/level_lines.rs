//! Lines on which a function has one value, in JavaScript.

use super::error::Failure;
use super::options::{self, FrameOptions};
use super::points;
use crate::plane::{Complex64, Frame, svg_path};
use crate::riemann::LevelLine;
use tsify::Ts;
use wasm_bindgen::prelude::wasm_bindgen;

/// Lines on which a function has one value each: polylines fine enough to look smooth.
#[derive(Debug)]
#[wasm_bindgen]
pub struct LevelLines(Vec<LevelLine>);

#[wasm_bindgen]
impl LevelLines {
    /// The number of lines.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> usize {
        self.0.len()
    }

    /// The points of all lines, `[x0, y0, x1, y1, …]`, one line after another; streamlines run with the fluid, and lines of
    /// force with the field.
    #[wasm_bindgen(getter)]
    pub fn points(&self) -> Vec<f64> {
        self.0.iter().flat_map(|line| points::to_flat(&line.points)).collect()
    }

    /// Where each line begins, counted in points, and the number of all points at the end.
    #[wasm_bindgen(getter)]
    pub fn starts(&self) -> Vec<u32> {
        let ends = self.0.iter().scan(0, |end, line| {
            *end += line.points.len() as u32;
            Some(*end)
        });
        std::iter::once(0).chain(ends).collect()
    }

    /// The value of each line.
    #[wasm_bindgen(getter)]
    pub fn levels(&self) -> Vec<f64> {
        self.0.iter().map(|line| line.level).collect()
    }

    /// For each line 1 if its last point is joined to its first, else 0.
    #[wasm_bindgen(getter)]
    pub fn closed(&self) -> Vec<u8> {
        self.0.iter().map(|line| u8::from(line.closed)).collect()
    }

    /// All lines as the `d` of an SVG path, in the pixels of a frame.
    ///
    /// Throws "invalid-option" or "invalid-frame".
    #[wasm_bindgen(js_name = svgPath)]
    pub fn svg_path(&self, frame: Ts<FrameOptions>) -> Result<String, Failure> {
        let frame: Frame = options::read(&frame)?.try_into()?;
        let path = |line: &LevelLine| svg_path::polyline(line.points.iter().map(|z| frame.to_pixels(*z)), line.closed);
        Ok(self.0.iter().map(path).collect())
    }
}

impl From<Vec<LevelLine>> for LevelLines {
    fn from(lines: Vec<LevelLine>) -> Self {
        Self(lines)
    }
}

/// Values of a function that lines can have.
///
/// # Errors
/// "invalid-option" for one that is not finite.
pub fn finite(levels: &[f64]) -> Result<&[f64], Failure> {
    let Some(k) = levels.iter().position(|level| !level.is_finite()) else { return Ok(levels) };
    let name = format!("levels[{k}]");
    Err(Failure::option(
        &name,
        &format!("The option \"{name}\" cannot be used: a level is a finite number, not {}.", levels[k]),
    ))
}

/// The lower left and the upper right corner of a frame.
///
/// # Errors
/// "invalid-option" and "invalid-frame".
pub fn window(frame: &Ts<FrameOptions>) -> Result<[Complex64; 2], Failure> {
    let frame: Frame = options::read(frame)?.try_into()?;
    let half = Complex64::new(0.5 * frame.width(), 0.5 * frame.height());
    Ok([frame.center() - half, frame.center() + half])
}
