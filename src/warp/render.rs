//! The one loop behind every warp: footprints of a strip, samples of the strip, next strip.

use super::options::WarpOptions;
use super::sampler;
use super::strip::{self, Strip};
use super::texture::Texture;
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};

/// What knows which point of the texture each pixel shows.
pub(super) trait Footprints {
    /// Writes the footprints of the strip's rows; what it leaves untouched shows nothing.
    fn fill(&mut self, strip: &mut Strip);

    /// Changes the finished pixels of the strip: rows of 4 · width bytes.
    fn finish(&mut self, _strip: &Strip, _out: &mut [u8]) {}
}

/// Draws the rows of the view that the options name into `out`.
pub(super) fn render(
    texture: &Texture,
    options: &WarpOptions,
    footprints: &mut impl Footprints,
    out: &mut [u8],
) -> Result<()> {
    let rows = options.checked_rows()?;
    let expected = options.output_len()?;
    if out.len() != expected {
        return Err(Error::WrongLength { what: "The output", expected: expected.to_string(), found: out.len() });
    }
    let width = options.view.pixels()[0];
    let mut strip = Strip::new(width, options.quality);
    let mut first = rows.start;
    let mut rest = out;
    while first < rows.end {
        let end = rows.end.min((first / strip::ROWS + 1) * strip::ROWS);
        let (band, below) = rest.split_at_mut(4 * width * (end - first));
        strip.reset(first, end - first);
        footprints.fill(&mut strip);
        sampler::sample(texture, options.quality, &strip, band);
        footprints.finish(&strip, band);
        (first, rest) = (end, below);
    }
    Ok(())
}

/// The plane → texels of a texture stretched over its frame.
#[derive(Clone, Copy)]
pub(super) struct TexelGrid {
    frame: Frame,
    /// Texels per pixel of the frame, across and down.
    scale: [f64; 2],
}

impl TexelGrid {
    pub fn new(frame: Frame, texture: &Texture) -> Self {
        let ([columns, rows], [width, height]) = (frame.pixels(), texture.size());
        Self { frame, scale: [width as f64 / columns as f64, height as f64 / rows as f64] }
    }

    /// Texel coordinates of a point.
    pub fn at(&self, z: Complex64) -> [f64; 2] {
        let (x, y) = self.frame.to_pixels(z);
        [x * self.scale[0], y * self.scale[1]]
    }

    /// The texels that a step in the plane passes, across and down.
    pub fn step(&self, dz: Complex64) -> [f64; 2] {
        let pixel = self.frame.pixel_size();
        [dz.re / pixel * self.scale[0], -dz.im / pixel * self.scale[1]]
    }

    /// Texels per plane unit; the larger of the two directions.
    pub fn density(&self) -> f64 {
        self.scale[0].max(self.scale[1]) / self.frame.pixel_size()
    }
}
