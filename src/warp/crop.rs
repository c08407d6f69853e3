//! Crops of a picture around a point, each twice as wide as the one before it at the same number of pixels.

use super::light::Tables;
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};
use std::ops::Range;

/// A square of a picture, in blocks of `block`² pixels that become one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crop {
    /// First column and row; may lie outside the picture.
    start: [isize; 2],
    side: usize,
    block: usize,
}

impl Crop {
    /// The crops around the point `fixation` of the plane of a picture that lies in `picture`: from the one that holds it all to
    /// the one of its own pixels, `side` along each side.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for a side below 16; [`Error::NotFinite`] for the fixation point.
    pub fn all(picture: &Frame, fixation: Complex64, side: usize) -> Result<Vec<Self>> {
        if !(16..=1 << 14).contains(&side) {
            return Err(Error::InvalidOption { name: "side", expected: "16 to 16384 pixels", value: side as f64 });
        }
        if !fixation.is_finite() {
            return Err(Error::NotFinite { what: "The fixation point".into() });
        }
        let size = picture.pixels();
        let (x, y) = picture.to_pixels(fixation);
        let center = [x.clamp(0.0, size[0] as f64), y.clamp(0.0, size[1] as f64)];
        let doublings = size[0].max(size[1]).div_ceil(side).next_power_of_two().ilog2();
        let crop = |doublings: u32| Self::new(center, size, side, 1 << doublings);
        Ok((0..=doublings).rev().map(crop).collect())
    }

    fn new(center: [f64; 2], size: [usize; 2], side: usize, block: usize) -> Self {
        let extent = side * block;
        let start = std::array::from_fn(|axis| {
            let start = (center[axis] - 0.5 * extent as f64).round() as isize;
            // One that is large enough holds the whole picture, wherever the center lies.
            let room = extent as isize - size[axis] as isize;
            if size.iter().all(|&size| size <= extent) { start.clamp(-room, 0) } else { start }
        });
        Self { start, side, block }
    }

    /// Where it lies in the plane.
    pub fn frame(&self, picture: &Frame) -> Result<Frame> {
        let half = 0.5 * (self.side * self.block) as f64;
        let center = picture.to_plane(self.start[0] as f64 + half, self.start[1] as f64 + half);
        Frame::new(center, 2.0 * half * picture.pixel_size(), [self.side, self.side])
    }

    /// Its pixels, each the mean of a block's light, from those of the picture: `read` writes the RGBA bytes of the row that it is
    /// asked for.
    pub fn pixels(&self, size: [usize; 2], read: &mut dyn FnMut(usize, &mut [u8]), tables: &Tables) -> Vec<u8> {
        let mut line = vec![0; 4 * size[0]];
        let mut sums = vec![Sum::default(); self.side];
        let mut pixels = Vec::with_capacity(4 * self.side * self.side);
        for row in 0..self.side {
            sums.fill(Sum::default());
            for y in self.inside(1, row, size) {
                read(y, &mut line);
                for (column, sum) in sums.iter_mut().enumerate() {
                    let columns = self.inside(0, column, size);
                    sum.add(&line[4 * columns.start..4 * columns.end], tables);
                }
            }
            pixels.extend(sums.iter().flat_map(|sum| sum.mean((self.block * self.block) as u64, tables)));
        }
        pixels
    }

    /// The columns or rows of the picture that one of the crop is made of.
    #[inline(always)]
    fn inside(&self, axis: usize, place: usize, size: [usize; 2]) -> Range<usize> {
        let first = self.start[axis] + (place * self.block) as isize;
        let inside = |at: isize| at.clamp(0, size[axis] as isize) as usize;
        inside(first)..inside(first + self.block as isize)
    }
}

/// The light of pixels, weighted by alpha.
#[derive(Clone, Copy, Default)]
struct Sum {
    light: [u64; 3],
    alphas: u64,
}

impl Sum {
    fn add(&mut self, rgba: &[u8], tables: &Tables) {
        for pixel in rgba.as_chunks::<4>().0 {
            let alpha = u64::from(pixel[3]);
            for (sum, &byte) in self.light.iter_mut().zip(pixel) {
                *sum += alpha * tables.decode[usize::from(byte)] as u64;
            }
            self.alphas += alpha;
        }
    }

    /// The pixel that `count` pixels become, some of which may lie beyond the picture.
    fn mean(&self, count: u64, tables: &Tables) -> [u8; 4] {
        let alphas = self.alphas;
        if alphas == 0 {
            return [0; 4];
        }
        let [r, g, b] = self.light.map(|sum| tables.encode[((sum + alphas / 2) / alphas) as usize]);
        [r, g, b, ((alphas + count / 2) / count) as u8]
    }
}
