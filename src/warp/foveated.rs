//! Full detail where the eye looks, without the whole picture in memory: a stack of pictures of one scene.

use super::buffer;
use super::crop::Crop;
use super::light::Light;
use super::options::{WarpOptions, Wrap};
use super::prepared::PreparedWarp;
use super::render::TexelGrid;
use super::sampler::{Row, Sampler};
use super::texture::{PICTURE, Texture, copy_row};
use super::warping::Warp;
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};

/// Registered pictures of one scene, each with its place in the plane: the widest first, which holds all the others. Every
/// pixel is taken from the last of them that covers its footprint, through that picture's own pyramid; towards its edges a
/// picture fades into the wider ones below it, so that no ring is seen.
///
/// This is the report's "special technique to obtain high resolution near the fovea": since a cortex magnifies by 1/E,
/// crops around fixation that halve in width at the same number of pixels are all that it can see. A picture of 100
/// megapixels in levels of 896² pixels takes 22 MB, and in levels of 768² that were drawn in the quality `best` 48 MB.
#[derive(Clone, Debug)]
pub struct FoveatedTexture {
    levels: Vec<(Texture, Frame)>,
}

/// The share of a level's side over which it fades into the wider ones.
const FEATHER: f32 = 0.125;

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

    /// The stack of crops of a picture (RGBA, straight alpha) that lies in `picture`, as [`FoveatedTexture::crops`] lays them.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless `rgba` has 4 bytes for each of the frame's pixels, and those of
    /// [`FoveatedTexture::crops`].
    pub fn around(rgba: &[u8], picture: &Frame, fixation: Complex64, side: usize, light: Light) -> Result<Self> {
        Self::around_rows(rgba.len(), &mut |row, line| copy_row(rgba, row, line), picture, fixation, side, light)
    }

    /// [`FoveatedTexture::around`] in a picture of `bytes` RGBA bytes that are somewhere else: `read` writes those of the row that it
    /// is asked for.
    pub(crate) fn around_rows(
        bytes: usize,
        read: &mut dyn FnMut(usize, &mut [u8]),
        picture: &Frame,
        fixation: Complex64,
        side: usize,
        light: Light,
    ) -> Result<Self> {
        let size = picture.pixels();
        buffer::check(PICTURE, bytes, size)?;
        let level = |crop: &Crop| {
            let pixels = crop.pixels(size, read, light.tables());
            Ok((Texture::new(&pixels, side, side, Wrap::Transparent, light)?, crop.frame(picture)?))
        };
        Self::new(Crop::all(picture, fixation, side)?.iter().map(level).collect::<Result<_>>()?)
    }

    /// Where the crops of a picture lie around the point `fixation` of the plane, the widest first: the last at the picture's
    /// own resolution, `side` pixels square, each before it twice as wide, up to the one that holds the whole picture.
    ///
    /// ```
    /// use conformal_warp::{Complex64, FoveatedTexture, Frame};
    /// let picture = Frame::new(Complex64::new(0.0, 0.0), 2.0, [4000, 3000])?;
    /// let crops = FoveatedTexture::crops(&picture, Complex64::new(0.1, 0.0), 512)?;
    /// assert_eq!(crops.len(), 4);
    /// assert!((crops[3].pixel_size() - picture.pixel_size()).abs() < 1e-15);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for a side below 16; [`Error::NotFinite`] for the fixation point.
    pub fn crops(picture: &Frame, fixation: Complex64, side: usize) -> Result<Vec<Frame>> {
        Crop::all(picture, fixation, side)?.iter().map(|crop| crop.frame(picture)).collect()
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

    /// Bytes that the pyramids take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.levels.iter().map(|(texture, _)| texture.bytes()).sum()
    }

    /// The stack as `map` shows it, in pixels as [`Warp::warp`] gives them of one texture. The options' texture frame is
    /// not used: each level has its own.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    pub fn warp<M: Warp + ?Sized>(&self, map: &M, options: &WarpOptions) -> Result<Vec<u8>> {
        let mut out = buffer::blank(options.output_size()?)?;
        self.warp_into(map, options, &mut out)?;
        Ok(out)
    }

    /// [`FoveatedTexture::warp`], into `out`. Every byte of it is written.
    ///
    /// # Errors
    /// As [`Warp::warp_into`].
    pub fn warp_into<M: Warp + ?Sized>(&self, map: &M, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        self.draw(&self.prepare(map, options)?, out)
    }

    /// The geometry of the warp, for stacks whose widest level lies in the same frame with as many pixels.
    ///
    /// # Errors
    /// As [`Warp::prepare`].
    pub fn prepare<M: Warp + ?Sized>(&self, map: &M, options: &WarpOptions) -> Result<PreparedWarp> {
        let (texture, frame) = &self.levels[0];
        map.prepare(texture, &WarpOptions { texture: *frame, ..options.clone() })
    }

    /// The stack, by the geometry that [`FoveatedTexture::prepare`] found, into `out`. Every byte of it is written.
    ///
    /// # Errors
    /// [`Error::OtherTexture`] if the widest level is another than it was found for; [`Error::WrongLength`] if `out` does not fit.
    pub fn draw(&self, prepared: &PreparedWarp, out: &mut [u8]) -> Result<()> {
        prepared.check(&self.levels[0].0)?;
        let levels = (0..self.levels.len()).rev();
        let layers = levels.map(|level| Layer::new(self, level, prepared)).collect::<Result<Vec<Layer>>>()?;
        let mut scratch = Scratch::default();
        prepared.fill(out, |row, line| {
            line.fill(0);
            for layer in &layers {
                if !scratch.lay_under(layer, row, line) {
                    break;
                }
            }
        })
    }
}

/// A level as it is drawn: how the widest level's texels lie in it, and what samples it.
struct Layer<'a> {
    texture: &'a Texture,
    sampler: Sampler,
    /// Texels of this level per texel of the widest, and where the widest one's first lies.
    scale: [f32; 2],
    shift: [f32; 2],
    /// log₂ of the scale.
    level: f32,
    fades: bool,
}

impl<'a> Layer<'a> {
    fn new(stack: &'a FoveatedTexture, level: usize, prepared: &PreparedWarp) -> Result<Self> {
        let ((widest, wide_frame), (texture, frame)) = (&stack.levels[0], &stack.levels[level]);
        let (grid, wide) = (TexelGrid::new(*frame, texture), TexelGrid::new(*wide_frame, widest));
        // Two opposite corners of the frame, in texels of both.
        let half = 0.5 * Complex64::new(frame.width(), -frame.height());
        let corners = [frame.center() - half, frame.center() + half];
        let ([p, q], [a, b]) = (corners.map(|z| grid.at(z)), corners.map(|z| wide.at(z)));
        let scale = [0, 1].map(|k| (q[k] - p[k]) / (b[k] - a[k]));
        let shift = [0, 1].map(|k| (p[k] - scale[k] * a[k]) as f32);
        Ok(Self {
            texture,
            sampler: Sampler::new(texture, prepared.is_framed(), prepared.quality())?,
            scale: scale.map(|s| s as f32),
            shift,
            level: (grid.density() / wide.density()).log2() as f32,
            fades: level > 0,
        })
    }

    /// How much of a footprint around a point (in texels of the level, its diameter's logarithm `level`) the level covers: none
    /// of what reaches over its edge, all of what lies far enough inside, smooth between.
    fn share(&self, u: f32, v: f32, level: f32) -> f32 {
        if !self.fades {
            return 1.0;
        }
        let [width, height] = self.texture.size().map(|n| n as f32);
        let inside = u.min(width - u).min(v).min(height - v) - power_of_two(level.max(0.0));
        let t = (inside / (FEATHER * width.min(height))).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }
}

/// One layer's part of a row.
#[derive(Default)]
struct Scratch {
    u: Vec<f32>,
    v: Vec<f32>,
    level: Vec<f32>,
    jacobian: [Vec<f32>; 4],
    shares: Vec<f32>,
    pixels: Vec<u8>,
}

impl Scratch {
    /// Draws what the pixels of `line` still let through; returns whether they let through anything more.
    fn lay_under(&mut self, layer: &Layer, row: Row<'_>, line: &mut [u8]) -> bool {
        if self.place(layer, row, line) {
            let Self { u, v, level, jacobian, shares, pixels } = self;
            pixels.resize(line.len(), 0);
            let jacobian = jacobian.each_ref().map(|plane| &plane[..]);
            layer.sampler.row(layer.texture, Row { u, v, level, jacobian }, pixels);
            let pixels = line.as_chunks_mut::<4>().0.iter_mut().zip(pixels.as_chunks::<4>().0);
            for ((above, below), &share) in pixels.zip(shares.iter()).filter(|(_, share)| **share > 0.0) {
                *above = over(*above, *below, share);
            }
        }
        line.as_chunks::<4>().0.iter().any(|pixel| pixel[3] < 255)
    }

    /// The row's footprints in the layer's texels, where it shows something that is not hidden; returns whether it does anywhere.
    fn place(&mut self, layer: &Layer, row: Row<'_>, line: &[u8]) -> bool {
        let Self { u, v, level, jacobian, shares, .. } = self;
        let moved = |plane: &mut Vec<f32>, from: &[f32], scale: f32, shift: f32| {
            plane.clear();
            plane.extend(from.iter().map(|t| t * scale + shift));
        };
        moved(u, row.u, layer.scale[0], layer.shift[0]);
        moved(v, row.v, layer.scale[1], layer.shift[1]);
        moved(level, row.level, 1.0, layer.level);
        for (k, plane) in jacobian.iter_mut().enumerate() {
            moved(plane, row.jacobian[k], layer.scale[k % 2], 0.0);
        }
        shares.clear();
        let mut any = false;
        for (k, pixel) in line.as_chunks::<4>().0.iter().enumerate() {
            let hidden = pixel[3] == 255;
            let share = if hidden { 0.0 } else { layer.share(u[k], v[k], level.get(k).copied().unwrap_or(0.0)) };
            any |= share > 0.0;
            if share <= 0.0 {
                u[k] = f32::NAN;
            }
            shares.push(share);
        }
        any
    }
}

/// 2^x for 0 ≤ x < 128, linear between whole x: at most 6 % more, and much faster.
fn power_of_two(x: f32) -> f32 {
    f32::from_bits(((x + 127.0) * (1 << 23) as f32) as u32)
}

/// Straight alpha: `above` over a share of `below`.
fn over(above: [u8; 4], below: [u8; 4], share: f32) -> [u8; 4] {
    if above[3] == 0 && share == 1.0 {
        return below;
    }
    let top = f32::from(above[3]) / 255.0;
    let rest = (1.0 - top) * f32::from(below[3]) / 255.0 * share;
    let total = top + rest;
    if total <= 0.0 {
        return [0; 4];
    }
    let mix = |a: u8, b: u8| ((top * f32::from(a) + rest * f32::from(b)) / total + 0.5) as u8;
    let [r, g, b] = [0, 1, 2].map(|k| mix(above[k], below[k]));
    [r, g, b, (255.0 * total + 0.5) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::FormulaMap;
    use crate::warp::Quality;

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
        let pixels = |(_, level): &(_, Frame)| (level.width() / frame.pixel_size()).round();
        // The level of 768 holds all of 700 × 500, although the crops are not centered on it.
        assert_eq!(stack.levels().iter().rev().map(pixels).collect::<Vec<_>>(), [96.0, 192.0, 384.0, 768.0]);
        let texels: usize = stack.levels().iter().map(|(texture, _)| texture.size().iter().product::<usize>()).sum();
        assert_eq!(texels, 4 * 96 * 96);
    }

    #[test]
    fn a_hundred_megapixels_take_less_than_fifty_megabytes() {
        let picture = Frame::new(Complex64::ZERO, 3.0, [12_000, 8_400]).unwrap();
        for (side, quality, limit) in [(896, Quality::Trilinear, 25_000_000), (768, Quality::Best, 50_000_000)] {
            let crops = FoveatedTexture::crops(&picture, Complex64::new(0.3, -0.2), side).unwrap();
            assert!((crops[crops.len() - 1].pixel_size() / picture.pixel_size() - 1.0).abs() < 1e-12);
            assert!(crops[0].width() >= picture.width() && crops[0].height() >= picture.height());
            let level = vec![0; 4 * side * side];
            let level = Texture::new(&level, side, side, Wrap::Transparent, Light::Linear).unwrap();
            // Drawn once, it has all that the quality needs.
            let view = Frame::new(Complex64::ZERO, 1.0, [8, 8]).unwrap();
            let options = WarpOptions { quality, ..WarpOptions::new(crops[0], view) };
            FormulaMap::new("z").unwrap().warp(&level, &options).unwrap();
            let bytes = crops.len() * level.bytes();
            assert!(bytes < limit && bytes > limit / 2, "{} levels take {bytes} bytes", crops.len());
        }
        let (_, _, stack) = stack(96);
        assert_eq!(stack.bytes(), stack.levels().len() * stack.levels()[0].0.bytes());
    }

    /// A scene that is red far out, and green and blue in two closer pictures: none shows an edge where it ends.
    #[test]
    fn pictures_fade_into_each_other() {
        let solid =
            |color: [u8; 4]| Texture::new(&color.repeat(64 * 64), 64, 64, Wrap::Transparent, Light::Plain).unwrap();
        let place = |width| Frame::new(Complex64::ZERO, width, [64, 64]).unwrap();
        let colors = [[200, 0, 0, 255], [0, 200, 0, 255], [0, 0, 200, 255]];
        let levels = colors.into_iter().zip([8.0, 4.0, 2.0]).map(|(color, width)| (solid(color), place(width)));
        let stack = FoveatedTexture::new(levels.collect()).unwrap();
        let view = Frame::new(Complex64::ZERO, 8.0, [512, 1]).unwrap();
        for quality in [Quality::Bilinear, Quality::Trilinear, Quality::Best] {
            let options = WarpOptions { quality, ..WarpOptions::new(view, view) };
            let line = stack.warp(&FormulaMap::new("z").unwrap(), &options).unwrap();
            let at = |x: usize| <[u8; 4]>::try_from(&line[4 * x..4 * x + 4]).unwrap();
            // The middle, within the second, and at the very edge of the second.
            assert_eq!([at(256), at(170), at(128)], [colors[2], colors[1], colors[0]], "{quality:?}");
            let steps = (32..255_usize).map(|x| at(x).iter().zip(at(x + 1)).map(|(a, b)| a.abs_diff(b)).max().unwrap());
            let largest = steps.max().unwrap();
            assert!((1..=32).contains(&largest), "{quality:?}: a step of {largest} levels");
        }
    }

    #[test]
    fn a_prepared_stack_draws_what_the_stack_draws() {
        let (_, frame, stack) = stack(96);
        let map = FormulaMap::with_params("c + exp(z)", &[("c", frame.center())]).unwrap();
        let view = Frame::new(Complex64::new(-1.0, 0.0), 3.0, [90, 70]).unwrap();
        let options = WarpOptions::new(frame, view);
        let prepared = stack.prepare(&map, &options).unwrap();
        let (mut again, expected) = (vec![3; 4 * 90 * 70], stack.warp(&map, &options).unwrap());
        stack.draw(&prepared, &mut again).unwrap();
        assert!(again == expected && expected.iter().any(|&byte| byte > 0));
        let other = FoveatedTexture::new(stack_of_one()).unwrap();
        assert_eq!(other.draw(&prepared, &mut again).unwrap_err().code(), "other-texture");
    }

    fn stack_of_one() -> Vec<(Texture, Frame)> {
        let texture = Texture::new(&[9; 16], 2, 2, Wrap::Transparent, Light::Linear).unwrap();
        vec![(texture, Frame::new(Complex64::ZERO, 1.0, [2, 2]).unwrap())]
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
        let view = Frame::new(Complex64::ZERO, 10.0, [100, 100]).unwrap();
        let mut out = vec![7; 40_000];
        stack.warp_into(&FormulaMap::new("z").unwrap(), &WarpOptions::new(view, view), &mut out).unwrap();
        let at = |x: usize, y: usize| &out[4 * (100 * y + x)..][..4];
        assert_eq!((at(25, 50), at(50, 50), at(0, 0)[3]), (&[200, 0, 0, 255][..], &[0, 100, 0, 255][..], 0));
        assert_eq!(FoveatedTexture::new(Vec::new()).unwrap_err().code(), "wrong-length");
        let frame = Frame::new(Complex64::ZERO, 1.0, [4, 4]).unwrap();
        let bad = FoveatedTexture::around(&[0; 64], &frame, Complex64::ZERO, 3, Light::Plain);
        assert_eq!(bad.unwrap_err().code(), "invalid-option");
    }
}
