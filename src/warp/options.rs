//! How a picture is to be warped: frames, direction, quality, wrap mode, rows.

use super::buffer;
use crate::plane::Frame;
use crate::{Error, Result};
use std::ops::Range;

/// Which way a map is used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Direction {
    /// The view's point p shows the texture at f(p).
    #[default]
    PullBack,
    /// The points z of the texture's frame, once, each shown at f(z). What lies beyond the frame is not drawn, whatever the
    /// texture's [`Wrap`] mode, which speaks of pull-back.
    ///
    /// A map that knows its inverse ([`PlaneMap::inverse_map`](crate::PlaneMap::inverse_map)), as every invertible one does,
    /// is pulled back by that, from a texture with nothing around it. Of any other, a formula say, the image of the frame is
    /// drawn in triangles, at whose edge the wrap mode says only how the outermost texels are filtered; where sheets
    /// overlap, the lowest point of the texture is seen.
    PushForward,
}

/// How texels become a pixel, from fast to good.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quality {
    /// The nearest texel.
    Nearest,
    /// The four nearest texels of the picture, weighted. Aliases where the picture shrinks.
    Bilinear,
    /// Bilinear in the two pyramid levels whose texels are nearest to the pixel's footprint, blended. The levels are
    /// averages of light; between texels it is bytes that are interpolated, as in [`Quality::Bilinear`].
    #[default]
    Trilinear,
    /// Four samples on a rotated grid in the pixel, each trilinear with half the footprint, of the texture's light
    /// throughout.
    Best,
}

/// What lies beyond the edges of a texture that is pulled back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
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

/// Everything about a warp but the map and the texture.
#[derive(Clone, Debug, PartialEq)]
pub struct WarpOptions {
    /// Where the texture lies in the plane. Its pixel counts say only the shape: the texture is stretched over it.
    pub texture: Frame,
    /// Which part of the plane the output shows, and how many pixels it has.
    pub view: Frame,
    /// Which way the map is used.
    pub direction: Direction,
    /// How texels become a pixel.
    pub quality: Quality,
    /// The rows of the view to draw; `None` for all. Bands drawn apart make the same pixels as the whole.
    pub rows: Option<Range<usize>>,
}

impl WarpOptions {
    /// The texture in its frame, seen through the map in another: pull-back, trilinear, all rows.
    #[must_use]
    pub fn new(texture: Frame, view: Frame) -> Self {
        Self { texture, view, direction: Direction::default(), quality: Quality::default(), rows: None }
    }

    /// The rows that will be drawn.
    ///
    /// # Errors
    /// [`Error::InvalidRows`] unless the rows are some of the view's, in order.
    pub fn checked_rows(&self) -> Result<Range<usize>> {
        let [_, height] = self.view.pixels();
        match self.rows.clone() {
            None => Ok(0..height),
            Some(rows) if rows.start <= rows.end && rows.end <= height => Ok(rows),
            Some(rows) => Err(Error::InvalidRows { start: rows.start, end: rows.end, height }),
        }
    }

    /// Columns and rows that will be drawn.
    ///
    /// # Errors
    /// As [`WarpOptions::checked_rows`].
    pub fn output_size(&self) -> Result<[usize; 2]> {
        Ok([self.view.pixels()[0], self.checked_rows()?.len()])
    }

    /// Bytes that the output needs: 4 a pixel.
    ///
    /// # Errors
    /// As [`WarpOptions::checked_rows`], and [`Error::OutOfMemory`] for more than can be counted.
    pub fn output_len(&self) -> Result<usize> {
        buffer::len(self.output_size()?)
    }
}
