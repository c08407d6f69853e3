//! A picture drawn by many threads, each in bands of its rows.

use super::buffer;
use super::options::{Direction, WarpOptions};
use super::sampler::Sampler;
use super::strip;
use super::texture::Texture;
use super::warping::Warp;
use crate::Result;
use rayon::prelude::*;

/// Bands for each thread: some rows cost more than others.
const BANDS_PER_THREAD: usize = 4;

/// A [`Warp`] drawn over all threads of rayon's current pool: the same pixels, to the bit, as by one.
///
/// All that can be shared between threads has it, so every map and mesh of this crate.
///
/// ```
/// use conformal_warp::{Complex64, FormulaMap, Frame, Light, ParallelWarp, Texture, Warp, WarpOptions, Wrap};
/// let frame = Frame::new(Complex64::new(0.0, 0.0), 2.0, [64, 48])?;
/// let texture = Texture::new(&[200; 4 * 64 * 48], 64, 48, Wrap::Repeat, Light::Linear)?;
/// let (map, options) = (FormulaMap::new("1/z")?, WarpOptions::new(frame, frame));
/// assert_eq!(map.par_warp(&texture, &options)?, map.warp(&texture, &options)?);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
pub trait ParallelWarp: Warp + Sync {
    /// [`Warp::warp_into`], over all threads.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    fn par_warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        buffer::check("The output", out.len(), options.output_size()?)?;
        let bands = bands(self, options)?;
        if bands.len() < 2 {
            return self.warp_into(texture, options, out);
        }
        // Here it makes the texture's light, which each band would make for itself.
        Sampler::new(texture, self.is_framed(options), options.quality)?;
        let line = 4 * options.view.pixels()[0];
        let mut rest = out;
        let mut work = Vec::with_capacity(bands.len());
        for rows in bands {
            let (band, after) = rest.split_at_mut(line * rows.len());
            work.push((WarpOptions { rows: Some(rows), ..options.clone() }, band));
            rest = after;
        }
        work.into_par_iter().try_for_each(|(options, band)| self.warp_into(texture, &options, band))
    }

    /// [`Warp::warp`], over all threads.
    ///
    /// # Errors
    /// As [`Warp::warp`].
    fn par_warp(&self, texture: &Texture, options: &WarpOptions) -> Result<Vec<u8>> {
        let mut out = buffer::blank(options.output_size()?)?;
        self.par_warp_into(texture, options, &mut out)?;
        Ok(out)
    }
}

impl<W: Warp + Sync + ?Sized> ParallelWarp for W {}

/// The rows that are drawn, in bands of whole strips.
fn bands<W: Warp + ?Sized>(warp: &W, options: &WarpOptions) -> Result<Vec<std::ops::Range<usize>>> {
    let rows = options.checked_rows()?;
    // What is pushed forward without its inverse is made into a mesh, anew for each band.
    let is_meshed = options.direction == Direction::PushForward && !warp.is_framed(options);
    let count = rayon::current_num_threads() * if is_meshed { 1 } else { BANDS_PER_THREAD };
    let first_strip = rows.start / strip::ROWS;
    let strips = rows.end.div_ceil(strip::ROWS).saturating_sub(first_strip);
    let height = strip::ROWS * strips.div_ceil(count).max(1);
    let starts = (first_strip * strip::ROWS..rows.end).step_by(height);
    Ok(starts.map(|start| start.max(rows.start)..rows.end.min(start + height)).collect())
}
