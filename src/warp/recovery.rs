//! There and back: what is left of a picture whose image under a map has finite resolution.

use super::buffer;
use super::light::Light;
use super::options::{Direction, WarpOptions, Wrap};
use super::sampler::Sampler;
use super::texture::Texture;
use super::warping::Warp;
use crate::map::{Inverse, InvertibleMap};
use crate::plane::Frame;
use crate::{Error, Result};

/// The picture as its image recovers it: the image under the inverse of `map` (image's plane → picture's plane) is kept as
/// the pixels of the frame `image`, and these are drawn back into `options.view`, a part of the picture's plane. Where a
/// pixel of the image shows much of the picture, the picture comes back blurred.
///
/// What the map does not reach stays transparent; a picture that many maps share, as the two hemispheres do, is the sum of
/// what each recovers ([`add`]).
///
/// ```
/// use conformal_warp::{
///     Complex64, CorticalModel, Frame, Gaze, Hemisphere, Light, Texture, VisualCortex, WarpOptions, Wrap,
/// };
/// use conformal_warp::warp::recovery;
/// let frame = Frame::new(Complex64::new(0.0, 0.0), 2.0, [32, 32])?;
/// let texture = Texture::new(&[90; 4 * 32 * 32], 32, 32, Wrap::Transparent, Light::Linear)?;
/// let gaze = Gaze::new(&frame, 40.0, frame.center())?;
/// let mut recovered = vec![0; 4 * 32 * 32];
/// for hemisphere in [Hemisphere::Left, Hemisphere::Right] {
///     let cortex = VisualCortex::from_model(CorticalModel::POLIMENI_2006, hemisphere);
///     let dots = cortex.frame(2.0)?; // two pixels a millimetre
///     let half = recovery::recover(&cortex.seeing(gaze), &dots, &texture, &WarpOptions::new(frame, frame))?;
///     recovery::add(&mut recovered, &half)?;
/// }
/// # Ok::<(), conformal_warp::Error>(())
/// ```
///
/// # Errors
/// As [`Warp::warp`].
pub fn recover<M: InvertibleMap>(map: &M, image: &Frame, texture: &Texture, options: &WarpOptions) -> Result<Vec<u8>> {
    let there = WarpOptions { view: *image, direction: Direction::PullBack, rows: None, ..options.clone() };
    let kept = |texture: &Texture| {
        let [width, height] = image.pixels();
        Texture::new(&map.warp(texture, &there)?, width, height, Wrap::Transparent, texture.light())
    };
    let image_kept = kept(texture)?;
    // How much of each pixel of the image the map reaches: an image that ends must not fade where the map ends.
    let reached = kept(&Texture::new(&[255; 4], 1, 1, Wrap::Clamp, Light::Plain)?)?;
    let back = WarpOptions { texture: *image, direction: Direction::PullBack, ..options.clone() };
    let prepared = Inverse(map).prepare(&image_kept, &back)?;
    let drawn = Sampler::new(&image_kept, false, options.quality)?;
    let measured = Sampler::new(&reached, false, options.quality)?;
    let (mut out, mut shares) = (buffer::blank(options.output_size()?)?, Vec::new());
    prepared.fill(&mut out, |row, line| {
        shares.resize(line.len(), 0);
        drawn.row(&image_kept, row, line);
        measured.row(&reached, row, &mut shares);
        for (pixel, share) in line.as_chunks_mut::<4>().0.iter_mut().zip(shares.as_chunks::<4>().0) {
            let [alpha, share] = [pixel[3], share[3]].map(u32::from);
            pixel[3] = ((255 * alpha + share / 2) / share.max(1)).min(255) as u8;
        }
    })?;
    Ok(out)
}

/// Adds pixels with straight alpha to others, each being what the others let through: halves that share an edge.
///
/// # Errors
/// [`Error::WrongLength`] unless there are as many.
pub fn add(sum: &mut [u8], part: &[u8]) -> Result<()> {
    if sum.len() != part.len() {
        let expected = sum.len().to_string();
        return Err(Error::WrongLength { what: "The pixels to add", expected, found: part.len() });
    }
    for (sum, part) in sum.as_chunks_mut::<4>().0.iter_mut().zip(part.as_chunks::<4>().0) {
        match (sum[3], part[3]) {
            (_, 0) => {}
            (0, _) => *sum = *part,
            (a, b) => {
                let [a, b] = [a, b].map(u32::from);
                for channel in 0..3 {
                    let mixed = a * u32::from(sum[channel]) + b * u32::from(part[channel]);
                    sum[channel] = ((mixed + (a + b) / 2) / (a + b)) as u8;
                }
                sum[3] = (a + b).min(255) as u8;
            }
        }
    }
    Ok(())
}
