//! A picture made ready for filtering: a mip pyramid, built once, read by every warp.

use super::buffer;
use super::light::Light;
use super::options::Wrap;
use super::pyramid::{self, Level};
use super::texel::{ByteTexel, LightTexel, premultiplied};
use crate::{Error, Result};
use std::sync::OnceLock;

/// A picture as a pyramid of premultiplied texels, each level averaged from the one above it.
///
/// Building costs one pass over the picture; a warp only reads it. A texel takes 4 bytes, the pyramid 4/3 as many texels
/// as the picture. Only [`Quality::Best`](super::Quality::Best) in linear light needs more: its first picture adds a
/// pyramid of light, 8 bytes a texel.
#[derive(Clone, Debug)]
pub struct Texture {
    texels: Vec<ByteTexel>,
    light_texels: OnceLock<Vec<LightTexel>>,
    levels: Vec<Level>,
    wrap: Wrap,
    light: Light,
}

/// What errors call the bytes of a picture.
pub(super) const PICTURE: &str = "The picture's RGBA bytes";

/// A pyramid must fit into 32-bit memory beside the picture it came from.
const MAX_TEXELS: usize = 1 << 28;

impl Texture {
    /// RGBA bytes (straight alpha, row-major, 4 · `width` · `height` of them) → texture. Any size from 1 × 1.
    ///
    /// ```
    /// use conformal_warp::{Light, Texture, Wrap};
    /// let gray = vec![128; 4 * 3 * 5];
    /// let texture = Texture::new(&gray, 3, 5, Wrap::Clamp, Light::Linear)?;
    /// assert_eq!(texture.size(), [3, 5]);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless `rgba` has exactly 4 · `width` · `height` bytes and there is a pixel;
    /// [`Error::TextureTooLarge`] if the pyramid would not fit into 32-bit memory; [`Error::OutOfMemory`] if there is no
    /// room for it.
    pub fn new(rgba: &[u8], width: usize, height: usize, wrap: Wrap, light: Light) -> Result<Self> {
        Self::from_rows(rgba.len(), [width, height], wrap, light, &mut |row, line| copy_row(rgba, row, line))
    }

    /// [`Texture::new`] of `bytes` RGBA bytes that are somewhere else: `read` writes those of the row that it is asked for.
    /// Nothing but the pyramid is held.
    pub(crate) fn from_rows(
        bytes: usize,
        [width, height]: [usize; 2],
        wrap: Wrap,
        light: Light,
        read: &mut dyn FnMut(usize, &mut [u8]),
    ) -> Result<Self> {
        let too_large = Error::TextureTooLarge { width, height };
        if width == 0 || height == 0 {
            let expected = format!("4 x {width} x {height} (at least one pixel)");
            return Err(Error::WrongLength { what: PICTURE, expected, found: bytes });
        }
        buffer::check(PICTURE, bytes, [width, height])?;
        if width > 1 << 16 || height > 1 << 16 {
            return Err(too_large);
        }
        let levels = pyramid::levels(width, height);
        if pyramid::total(&levels) > MAX_TEXELS {
            return Err(too_large);
        }
        let mut texture = Self { texels: empty(&levels)?, light_texels: OnceLock::new(), levels, wrap, light };
        texture.fill(read);
        Ok(texture)
    }

    /// Shows another picture of the same size, in the same memory: a camera's next frame.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless `rgba` has as many bytes as the first picture.
    pub fn replace(&mut self, rgba: &[u8]) -> Result<()> {
        self.replace_rows(rgba.len(), &mut |row, line| copy_row(rgba, row, line))
    }

    /// [`Texture::replace`] by bytes that are somewhere else, as in [`Texture::from_rows`].
    pub(crate) fn replace_rows(&mut self, bytes: usize, read: &mut dyn FnMut(usize, &mut [u8])) -> Result<()> {
        buffer::check(PICTURE, bytes, self.size())?;
        self.fill(read);
        Ok(())
    }

    fn fill(&mut self, read: &mut dyn FnMut(usize, &mut [u8])) {
        self.light_texels.take();
        for row in 0..self.levels[0].height {
            let line = &mut self.texels[self.levels[0].row(row)];
            read(row, line.as_flattened_mut());
            if line.iter().fold(255, |alpha, texel| alpha & texel[3]) < 255 {
                line.iter_mut().for_each(|texel| *texel = premultiplied(*texel));
            }
        }
        pyramid::build(&mut self.texels, &self.levels, self.wrap, self.light.tables());
    }

    /// Bytes that its pyramids take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(&self.texels[..]) + self.light_texels.get().map_or(0, |texels| size_of_val(&texels[..]))
    }

    /// [columns, rows] of the picture.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.levels[0].width, self.levels[0].height]
    }

    /// The wrap mode: what lies beyond the picture's edges.
    #[must_use]
    pub fn wrap(&self) -> Wrap {
        self.wrap
    }

    /// The light in which it is filtered.
    #[must_use]
    pub fn light(&self) -> Light {
        self.light
    }

    pub(super) fn texels(&self) -> &[ByteTexel] {
        &self.texels
    }

    /// Makes the pyramid of light, if there is none yet.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if there is no memory for it.
    pub(super) fn make_light(&self) -> Result<()> {
        if self.light_texels.get().is_none() {
            // Another thread may be as quick; then one's work is dropped.
            let _ = self.light_texels.set(self.lit(empty(&self.levels)?));
        }
        Ok(())
    }

    /// The pyramid of light.
    pub(super) fn light_texels(&self) -> &[LightTexel] {
        self.light_texels.get_or_init(|| self.lit(vec![[0; 4]; pyramid::total(&self.levels)]))
    }

    /// `texels`, filled with the pyramid of light.
    fn lit(&self, mut texels: Vec<LightTexel>) -> Vec<LightTexel> {
        pyramid::build_light(&mut texels, &self.levels, &self.texels, self.wrap, self.light.tables());
        texels
    }

    pub(super) fn levels(&self) -> &[Level] {
        &self.levels
    }
}

/// The row of RGBA bytes that fits into `line`.
pub(super) fn copy_row(rgba: &[u8], row: usize, line: &mut [u8]) {
    line.copy_from_slice(&rgba[row * line.len()..(row + 1) * line.len()]);
}

/// Room for all texels of a pyramid.
fn empty<T: Copy + Default>(levels: &[Level]) -> Result<Vec<[T; 4]>> {
    let total = pyramid::total(levels);
    let bytes = total as u64 * size_of::<[T; 4]>() as u64;
    let mut texels = Vec::new();
    texels.try_reserve_exact(total).map_err(|_| Error::OutOfMemory { bytes })?;
    texels.resize(total, [T::default(); 4]);
    Ok(texels)
}

#[cfg(test)]
mod tests {
    use super::super::light::FULL;
    use super::*;

    /// The level's inner texels, row by row.
    fn inner<T: Copy>(texture: &Texture, texels: &[T], level: usize) -> Vec<T> {
        let level = texture.levels[level];
        (0..level.height).flat_map(|row| texels[level.row(row)].to_vec()).collect()
    }

    /// The level's texels with the border.
    fn all<T: Copy>(texels: &[T], level: &Level) -> Vec<T> {
        let rows = (0..level.height + 2).map(|row| level.offset + row * level.stride);
        rows.flat_map(|start| texels[start..start + level.width + 2].to_vec()).collect()
    }

    #[test]
    fn levels_average_light_not_bytes() {
        let checker = [[0, 0, 0, 255], [255, 255, 255, 255], [255, 255, 255, 255], [0, 0, 0, 255]].concat();
        let half = FULL / 2;
        let texture = Texture::new(&checker, 2, 2, Wrap::Clamp, Light::Linear).unwrap();
        assert_eq!(inner(&texture, texture.light_texels(), 1), [[half, half, half, FULL]]);
        assert_eq!(inner(&texture, texture.texels(), 1), [[188, 188, 188, 255]], "half the light of white is sRGB 188");
    }

    #[test]
    fn transparent_texels_lend_no_color() {
        let pixels = [[255, 0, 0, 255], [0, 255, 0, 0]].concat();
        let texture = Texture::new(&pixels, 2, 1, Wrap::Clamp, Light::Plain).unwrap();
        assert_eq!(inner(&texture, texture.light_texels(), 1), [[FULL / 2, 0, 0, FULL / 2]]);
        assert_eq!(inner(&texture, texture.texels(), 1), [[128, 0, 0, 128]]);
    }

    #[test]
    fn a_constant_picture_is_constant_at_every_level_and_size() {
        for (width, height) in [(1, 1), (1, 9), (7, 5), (64, 33)] {
            let pixels = [10, 200, 90, 255].repeat(width * height);
            for wrap in [Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
                let texture = Texture::new(&pixels, width, height, wrap, Light::Linear).unwrap();
                for level in texture.levels() {
                    let (bytes, light) = (all(texture.texels(), level), all(texture.light_texels(), level));
                    let same = bytes.iter().all(|texel| *texel == [10, 200, 90, 255]);
                    assert!(same && light.iter().all(|texel| *texel == light[0]), "{width} x {height}, {wrap:?}");
                }
            }
        }
    }

    #[test]
    fn borders_follow_the_wrap_mode() {
        let pixels = [[1, 0, 0, 255], [2, 0, 0, 255], [3, 0, 0, 255]].concat();
        let border = |wrap| {
            let texture = Texture::new(&pixels, 3, 1, wrap, Light::Plain).unwrap();
            let row = &all(texture.texels(), &texture.levels[0])[5..10];
            [row[0][0], row[4][0]]
        };
        assert_eq!(border(Wrap::Transparent), [0, 0]);
        assert_eq!(border(Wrap::Clamp), [1, 3]);
        assert_eq!(border(Wrap::Repeat), [3, 1]);
        assert_eq!(border(Wrap::Mirror), [1, 3]);
    }

    #[test]
    fn refuses_bytes_that_do_not_fit() {
        for (length, width, height) in [(0, 0, 4), (15, 2, 2), (17, 2, 2), (4, usize::MAX, 2)] {
            let error = Texture::new(&vec![0; length], width, height, Wrap::Clamp, Light::Plain).unwrap_err();
            assert_eq!(error.code(), "wrong-length");
        }
    }
}
