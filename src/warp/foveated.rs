//! Full detail where the eye looks, without the whole picture in memory: a stack of crops around the fixation point.

use super::light::Tables;
use super::{Light, Texture, Warp, WarpOptions, Wrap};
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};

/// Registered pictures of one scene, the widest first, each with its place in the plane. Every pixel is taken from the
/// last of them that has one there, through its own pyramid; the edges of the crops are blended.
///
/// This is the report's "special technique to obtain high resolution near the fovea": since a cortex magnifies by 1/E,
/// crops around fixation that halve in width at the same number of pixels are all that it can see. A picture of 100
/// megapixels in levels of 896² pixels takes 43 MB.
#[derive(Clone, Debug)]
pub struct FoveatedTexture {
    levels: Vec<(Texture, Frame)>,
}

/// The share of a crop's side over which it fades into the wider one below it.
const FEATHER: f64 = 0.125;

impl FoveatedTexture {
    /// A stack of textures with their frames, the widest first: crops, or a wide shot and a close-up. Where a closer one
    /// is transparent, the wider one shows.
    ///
    /// # Errors
    /// [`Error::WrongLength`] for an empty stack.
    pub fn new(levels: Vec<(Texture, Frame)>) -> Result<Self> {
        if levels.is_empty() {
            return Err(Error::WrongLength { what: "A foveated texture", expected: "at least 1".into(), found: 0 });
        }
        Ok(Self { levels })
    }

    /// The stack of crops of a picture (RGBA, straight alpha) that lies in `picture`, around the point `fixation` of the plane:
    /// the finest at full resolution, `side` pixels square, each further one twice as wide, down to the whole picture.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless `rgba` has 4 bytes for each of the frame's pixels; [`Error::InvalidOption`] for a side
    /// below 16; [`Error::NotFinite`] for the fixation point.
    pub fn around(rgba: &[u8], picture: &Frame, fixation: Complex64, side: usize, light: Light) -> Result<Self> {
        let [width, height] = picture.pixels();
        if rgba.len() != 4 * width * height {
            let expected = format!("4 x {width} x {height}");
            return Err(Error::WrongLength { what: "The picture's RGBA bytes", expected, found: rgba.len() });
        }
        if !(16..=1 << 14).contains(&side) {
            return Err(Error::InvalidOption { name: "side", expected: "16 to 16384 pixels", value: side as f64 });
        }
        if !fixation.is_finite() {
            return Err(Error::NotFinite { what: "The fixation point".into() });
        }
        let (x, y) = picture.to_pixels(fixation);
        let center = [x.clamp(0.0, width as f64), y.clamp(0.0, height as f64)];
        let mut levels = Vec::new();
        for doublings in 0.. {
            let crop = Crop::new(rgba, [width, height], center, side, 1 << doublings);
            let whole = crop.is_whole();
            let pixels = crop.pixels(light.tables(), !whole);
            levels.push((Texture::new(&pixels, side, side, Wrap::Transparent, light)?, crop.frame(picture)?));
            if whole {
                break;
            }
        }
        levels.reverse();
        Self::new(levels)
    }

    /// Puts a closer texture on top.
    pub fn add(&mut self, texture: Texture, frame: Frame) {
        self.levels.push((texture, frame));
    }

    /// The textures and their places, the widest first.
    #[must_use]
    pub fn levels(&self) -> &[(Texture, Frame)] {
        &self.levels
    }

    /// The stack as `map` shows it, in pixels as [`Warp::warp`] gives them of one texture. The options' texture frame is
    /// not used: each level has its own.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    pub fn warp<M: Warp + ?Sized>(&self, map: &M, options: &WarpOptions) -> Result<Vec<u8>> {
        let mut out = vec![0; options.output_len()?];
        self.warp_into(map, options, &mut out)?;
        Ok(out)
    }

    /// [`FoveatedTexture::warp`], into `out`. Every byte of it is written.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    pub fn warp_into<M: Warp + ?Sized>(&self, map: &M, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        let mut closer = vec![0; options.output_len()?];
        for (index, (texture, frame)) in self.levels.iter().enumerate() {
            let options = WarpOptions { texture: *frame, ..options.clone() };
            if index == 0 {
                map.warp_into(texture, &options, out)?;
            } else {
                map.warp_into(texture, &options, &mut closer)?;
                lay_over(out, &closer);
            }
        }
        Ok(())
    }
}

/// Straight-alpha pixels over others.
fn lay_over(below: &mut [u8], above: &[u8]) {
    for (below, above) in below.as_chunks_mut::<4>().0.iter_mut().zip(above.as_chunks::<4>().0) {
        match above[3] {
            0 => {}
            255 => *below = *above,
            share => {
                let top = u32::from(share) * 255;
                let rest = u32::from(below[3]) * (255 - u32::from(share));
                let total = top + rest;
                for channel in 0..3 {
                    let sum = u32::from(above[channel]) * top + u32::from(below[channel]) * rest;
                    below[channel] = ((sum + total / 2) / total) as u8;
                }
                below[3] = ((total + 127) / 255) as u8;
            }
        }
    }
}

/// A square of a picture, in blocks of `block`² pixels that become one.
struct Crop<'a> {
    rgba: &'a [u8],
    size: [usize; 2],
    /// First column and row; may lie outside the picture.
    start: [isize; 2],
    side: usize,
    block: usize,
}

impl<'a> Crop<'a> {
    fn new(rgba: &'a [u8], size: [usize; 2], center: [f64; 2], side: usize, block: usize) -> Self {
        let start = center.map(|c| (c - 0.5 * (side * block) as f64).round() as isize);
        Self { rgba, size, start, side, block }
    }

    fn is_whole(&self) -> bool {
        let extent = (self.side * self.block) as isize;
        self.start.iter().zip(self.size).all(|(&start, size)| start <= 0 && start + extent >= size as isize)
    }

    fn frame(&self, picture: &Frame) -> Result<Frame> {
        let half = 0.5 * (self.side * self.block) as f64;
        let center = picture.to_plane(self.start[0] as f64 + half, self.start[1] as f64 + half);
        Frame::new(center, 2.0 * half * picture.pixel_size(), [self.side, self.side])
    }

    fn pixels(&self, tables: &Tables, feathered: bool) -> Vec<u8> {
        let mut pixels = Vec::with_capacity(4 * self.side * self.side);
        for row in 0..self.side {
            for column in 0..self.side {
                let [r, g, b, alpha] = self.average(column, row, tables);
                let share = if feathered { self.fade(column) * self.fade(row) } else { 1.0 };
                pixels.extend([r, g, b, (f64::from(alpha) * share).round() as u8]);
            }
        }
        pixels
    }

    /// 0 at the crop's edge, 1 further in, smooth between.
    fn fade(&self, index: usize) -> f64 {
        let edge = (index as f64 + 0.5).min(self.side as f64 - index as f64 - 0.5);
        let t = (edge / (FEATHER * self.side as f64)).min(1.0);
        t * t * (3.0 - 2.0 * t)
    }

    /// The mean of a block's light, weighted by alpha.
    fn average(&self, column: usize, row: usize, tables: &Tables) -> [u8; 4] {
        let range = |axis: usize, index: usize| {
            let first = self.start[axis] + (index * self.block) as isize;
            let inside = |at: isize| at.clamp(0, self.size[axis] as isize) as usize;
            inside(first)..inside(first + self.block as isize)
        };
        let mut light = [0u64; 3];
        let mut alphas = 0u64;
        for y in range(1, row) {
            for x in range(0, column) {
                let at = 4 * (y * self.size[0] + x);
                let [r, g, b, alpha] = [0, 1, 2, 3].map(|channel| self.rgba[at + channel]);
                for (sum, byte) in light.iter_mut().zip([r, g, b]) {
                    *sum += u64::from(alpha) * tables.decode[usize::from(byte)] as u64;
                }
                alphas += u64::from(alpha);
            }
        }
        if alphas == 0 {
            return [0; 4];
        }
        let [r, g, b] = light.map(|sum| tables.encode[((sum + alphas / 2) / alphas) as usize]);
        let count = (self.block * self.block) as u64;
        [r, g, b, ((alphas + count / 2) / count) as u8]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::FormulaMap;

    /// Waves that get finer towards the fixation point, as detail that only the inner crops can hold.
    fn picture(width: usize, height: usize, focus: [f64; 2]) -> Vec<u8> {
        let pixel = |k: usize| {
            let (x, y) = ((k % width) as f64 - focus[0], (k / width) as f64 - focus[1]);
            let wave = (24.0 * (1.0 + 0.02 * x.hypot(y)).ln() + 3.0 * y.atan2(x)).sin();
            [(128.0 + 90.0 * wave) as u8, (128.0 - 60.0 * wave) as u8, 90, 255]
        };
        (0..width * height).flat_map(pixel).collect()
    }

    fn stack(side: usize) -> (Vec<u8>, Frame, FoveatedTexture) {
        let frame = Frame::new(Complex64::new(1.0, 2.0), 4.0, [700, 500]).unwrap();
        let rgba = picture(700, 500, [420.0, 210.0]);
        let fixation = frame.to_plane(420.0, 210.0);
        let stack = FoveatedTexture::around(&rgba, &frame, fixation, side, Light::Linear).unwrap();
        (rgba, frame, stack)
    }

    #[test]
    fn levels_double_until_they_hold_the_picture() {
        let (_, frame, stack) = stack(96);
        let widths: Vec<f64> =
            stack.levels().iter().rev().map(|(_, level)| level.width() / frame.pixel_size()).collect();
        assert!(
            widths.iter().zip([96.0, 192.0, 384.0, 768.0, 1536.0]).all(|(a, b)| (a - b).abs() < 1e-9),
            "{widths:?}"
        );
        assert!(widths.len() == 5 || widths.len() == 4);
        let texels: usize = stack.levels().iter().map(|(texture, _)| texture.size().iter().product::<usize>()).sum();
        assert_eq!(texels, widths.len() * 96 * 96);
    }

    #[test]
    fn a_log_view_shows_the_whole_picture_without_rings() {
        let (rgba, frame, stack) = stack(128);
        let fixation = frame.to_plane(420.0, 210.0);
        let map = FormulaMap::with_params("c + exp(z)", &[("c", fixation)]).unwrap();
        // From 2 to 180 pixels from the fixation point; a pixel of the view is at least as wide as a texel of its crop.
        let (inner, outer) = (2.0 * frame.pixel_size(), 180.0 * frame.pixel_size());
        let middle = 0.5 * (inner.ln() + outer.ln());
        let view = Frame::new(Complex64::new(middle, 0.0), outer.ln() - inner.ln(), [120, 120]).unwrap();
        let options = WarpOptions::new(frame, view);
        let whole = Texture::new(&rgba, 700, 500, Wrap::Transparent, Light::Linear).unwrap();
        let expected = map.warp(&whole, &options).unwrap();
        let found = stack.warp(&map, &options).unwrap();
        let differences = expected.iter().zip(&found).map(|(a, b)| f64::from(a.abs_diff(*b)));
        let worst = differences.clone().fold(0.0, f64::max);
        let mean = differences.map(|d| d * d).sum::<f64>() / expected.len() as f64;
        assert!(worst <= 12.0 && mean < 2.0, "the largest difference is {worst} levels, the mean square {mean:.2}");
    }

    #[test]
    fn a_close_up_lies_over_a_wide_shot() {
        let solid = |color: [u8; 4]| Texture::new(&color.repeat(64), 8, 8, Wrap::Transparent, Light::Plain).unwrap();
        let place = |width| Frame::new(Complex64::ZERO, width, [8, 8]).unwrap();
        let stack = vec![(solid([200, 0, 0, 255]), place(8.0)), (solid([0, 100, 0, 255]), place(2.0))];
        let stack = FoveatedTexture::new(stack).unwrap();
        let view = Frame::new(Complex64::ZERO, 10.0, [10, 10]).unwrap();
        let mut out = vec![7; 400];
        stack.warp_into(&FormulaMap::new("z").unwrap(), &WarpOptions::new(view, view), &mut out).unwrap();
        let at = |x: usize, y: usize| &out[4 * (10 * y + x)..][..4];
        assert_eq!((at(2, 5), at(5, 5), at(0, 0)[3]), (&[200, 0, 0, 255][..], &[0, 100, 0, 255][..], 0));
        assert_eq!(FoveatedTexture::new(Vec::new()).unwrap_err().code(), "wrong-length");
        let frame = Frame::new(Complex64::ZERO, 1.0, [4, 4]).unwrap();
        let bad = FoveatedTexture::around(&[0; 64], &frame, Complex64::ZERO, 3, Light::Plain);
        assert_eq!(bad.unwrap_err().code(), "invalid-option");
    }
}
