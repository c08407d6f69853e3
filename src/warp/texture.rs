//! A picture made ready for filtering: a mip pyramid, built once, read by every warp.

use super::light::{FULL, Light, Tables};
use super::pyramid::{self, Level, Texel};
use crate::{Error, Result};

/// What lies beyond the edges of a texture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(
    target_arch = "wasm32",
    derive(serde::Deserialize, serde::Serialize, tsify::Tsify),
    serde(rename_all = "lowercase")
)]
pub enum Wrap {
    /// Nothing.
    #[default]
    Transparent,
    /// The nearest edge texel.
    Clamp,
    /// The picture again.
    Repeat,
    /// The picture, reflected at each edge.
    Mirror,
}

/// A picture as a pyramid of premultiplied texels, each level averaged from the one above it.
///
/// Building costs one pass over the picture; a warp only reads it. A texel takes 8 bytes, the pyramid 4/3 as many texels
/// as the picture.
#[derive(Clone, Debug)]
pub struct Texture {
    texels: Vec<Texel>,
    levels: Vec<Level>,
    wrap: Wrap,
    light: Light,
}

/// A pyramid must fit into 32-bit memory beside the picture it came from.
const MAX_TEXELS: usize = 1 << 28;

impl Texture {
    /// RGBA bytes (straight alpha, row-major, 4 · `width` · `height` of them) → texture. Any size from 1 × 1.
    ///
    /// ```
    /// use conformal_warp::warp::{Light, Texture, Wrap};
    /// let gray = vec![128; 4 * 3 * 5];
    /// let texture = Texture::new(&gray, 3, 5, Wrap::Clamp, Light::Linear)?;
    /// assert_eq!(texture.size(), [3, 5]);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless `rgba` has exactly 4 · `width` · `height` bytes and there is a pixel;
    /// [`Error::TextureTooLarge`] if the pyramid would not fit into 32-bit memory.
    pub fn new(rgba: &[u8], width: usize, height: usize, wrap: Wrap, light: Light) -> Result<Self> {
        let too_large = Error::TextureTooLarge { width, height };
        if width == 0 || height == 0 || width.checked_mul(height).and_then(|n| n.checked_mul(4)) != Some(rgba.len()) {
            let expected = format!("4 x {width} x {height} (at least one pixel)");
            return Err(Error::WrongLength { what: "The picture's RGBA bytes", expected, found: rgba.len() });
        }
        if width > 1 << 16 || height > 1 << 16 {
            return Err(too_large);
        }
        let levels = pyramid::levels(width, height);
        let total = pyramid::total(&levels);
        let mut texels: Vec<Texel> = Vec::new();
        if total > MAX_TEXELS || texels.try_reserve_exact(total).is_err() {
            return Err(too_large);
        }
        texels.resize(total, [0; 4]);
        let mut texture = Self { texels, levels, wrap, light };
        texture.fill(rgba);
        Ok(texture)
    }

    /// Shows another picture of the same size, in the same memory: a camera's next frame.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless `rgba` has as many bytes as the first picture.
    pub fn replace(&mut self, rgba: &[u8]) -> Result<()> {
        let [width, height] = self.size();
        if rgba.len() != 4 * width * height {
            let expected = format!("4 x {width} x {height}");
            return Err(Error::WrongLength { what: "The picture's RGBA bytes", expected, found: rgba.len() });
        }
        self.fill(rgba);
        Ok(())
    }

    fn fill(&mut self, rgba: &[u8]) {
        let tables = self.light.tables();
        for (row, bytes) in rgba.chunks_exact(4 * self.levels[0].width).enumerate() {
            let line = pyramid::row_mut(&mut self.texels, &self.levels[0], row);
            for (texel, pixel) in line.iter_mut().zip(bytes.as_chunks().0) {
                *texel = premultiplied(*pixel, tables);
            }
        }
        pyramid::build(&mut self.texels, &self.levels, self.wrap);
    }

    /// Bytes that its pyramid takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(&self.texels[..])
    }

    /// [columns, rows] of the picture.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.levels[0].width, self.levels[0].height]
    }

    /// What lies beyond its edges.
    #[must_use]
    pub fn wrap(&self) -> Wrap {
        self.wrap
    }

    /// The light in which it is filtered.
    #[must_use]
    pub fn light(&self) -> Light {
        self.light
    }

    pub(super) fn texels(&self) -> &[Texel] {
        &self.texels
    }

    pub(super) fn levels(&self) -> &[Level] {
        &self.levels
    }
}

/// A pixel with straight alpha → a texel.
fn premultiplied([r, g, b, alpha]: [u8; 4], tables: &Tables) -> Texel {
    let [r, g, b] = [r, g, b].map(|byte| tables.decode[usize::from(byte)]);
    match alpha {
        255 => [r, g, b, FULL],
        _ => {
            let a = i32::from(alpha);
            let [r, g, b] = [r, g, b].map(|value| ((i32::from(value) * a + 127) / 255) as i16);
            [r, g, b, (128 * a) as i16]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The level's inner texels, row by row.
    fn inner(texture: &Texture, level: usize) -> Vec<Texel> {
        let Level { offset, stride, width, height, .. } = texture.levels[level];
        (1..=height).flat_map(|row| texture.texels[offset + row * stride + 1..][..width].to_vec()).collect()
    }

    #[test]
    fn levels_average_light_not_bytes() {
        let checker = [[0, 0, 0, 255], [255, 255, 255, 255], [255, 255, 255, 255], [0, 0, 0, 255]].concat();
        let half = FULL / 2;
        let texture = Texture::new(&checker, 2, 2, Wrap::Clamp, Light::Linear).unwrap();
        assert_eq!(inner(&texture, 1), [[half, half, half, FULL]]);
        assert_eq!(Light::Linear.tables().encode[half as usize], 188, "half the light of white is sRGB 188");
    }

    #[test]
    fn transparent_texels_lend_no_color() {
        let pixels = [[255, 0, 0, 255], [0, 255, 0, 0]].concat();
        let texture = Texture::new(&pixels, 2, 1, Wrap::Clamp, Light::Plain).unwrap();
        assert_eq!(inner(&texture, 1), [[FULL / 2, 0, 0, FULL / 2]]);
    }

    #[test]
    fn a_constant_picture_is_constant_at_every_level_and_size() {
        for (width, height) in [(1, 1), (1, 9), (7, 5), (64, 33)] {
            let pixels = [10, 200, 90, 255].repeat(width * height);
            for wrap in [Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
                let texture = Texture::new(&pixels, width, height, wrap, Light::Linear).unwrap();
                let first = texture.texels[0];
                assert!(texture.texels.iter().all(|texel| *texel == first), "{width} x {height}, {wrap:?}");
            }
        }
    }

    #[test]
    fn borders_follow_the_wrap_mode() {
        let pixels = [[1, 0, 0, 255], [2, 0, 0, 255], [3, 0, 0, 255]].concat();
        let border = |wrap| {
            let texture = Texture::new(&pixels, 3, 1, wrap, Light::Plain).unwrap();
            let row = &texture.texels[5..10];
            [row[0][0] / 128, row[4][0] / 128]
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
