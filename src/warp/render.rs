//! The one loop behind every warp: footprints of a strip, what is done with the strip, next strip.

use super::buffer;
use super::options::WarpOptions;
use super::sampler::Sampler;
use super::strip::{self, Strip};
use super::texture::Texture;
use crate::Result;
use crate::plane::{Complex64, Frame};

/// What knows which point of the texture each pixel shows.
pub(super) trait Footprints {
    /// Writes the footprints of the strip's rows; what it leaves untouched shows nothing.
    fn fill(&mut self, strip: &mut Strip);
}

/// Fills the strips of the rows that the options name, and hands on each.
pub(super) fn each_strip(
    options: &WarpOptions,
    footprints: &mut impl Footprints,
    each: &mut dyn FnMut(&Strip),
) -> Result<()> {
    let rows = options.checked_rows()?;
    let mut strip = Strip::new(options.view.pixels()[0], options.quality);
    let mut first = rows.start;
    while first < rows.end {
        let end = rows.end.min((first / strip::ROWS + 1) * strip::ROWS);
        strip.reset(first, end - first);
        footprints.fill(&mut strip);
        each(&strip);
        first = end;
    }
    Ok(())
}

/// Draws the rows of the view that the options name into `out`, from strips; of the texture, if `framed`, only its frame.
pub(super) fn render(
    texture: &Texture,
    framed: bool,
    options: &WarpOptions,
    out: &mut [u8],
    strips: impl FnOnce(&mut dyn FnMut(&Strip)) -> Result<()>,
) -> Result<()> {
    buffer::check("The output", out.len(), options.output_size()?)?;
    let (first, line) = (options.checked_rows()?.start, 4 * options.view.pixels()[0]);
    let sampler = Sampler::new(texture, framed, options.quality)?;
    strips(&mut |strip| {
        let band = &mut out[line * (strip.first_row - first)..][..line * strip.rows];
        sampler.strip(texture, strip, band);
        for &(row, column, share) in &strip.shares {
            dim(&mut band[line * row + 4 * column + 3], share);
        }
    })
}

/// Multiplies an alpha by the share of the pixel that it holds for.
pub(super) fn dim(alpha: &mut u8, share: f32) {
    *alpha = (f32::from(*alpha) * share + 0.5) as u8;
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
