//! Crops of a picture around a point, each twice as wide as the one before it at the same number of pixels.

use super::light::Tables;
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};

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

    /// Its pixels, from those of the picture.
    pub fn pixels(&self, rgba: &[u8], size: [usize; 2], tables: &Tables) -> Vec<u8> {
        let places = (0..self.side).flat_map(|row| (0..self.side).map(move |column| [column, row]));
        places.flat_map(|place| self.average(place, rgba, size, tables)).collect()
    }

    /// The mean of a block's light, weighted by alpha.
    fn average(&self, place: [usize; 2], rgba: &[u8], size: [usize; 2], tables: &Tables) -> [u8; 4] {
        let range = |axis: usize| {
            let first = self.start[axis] + (place[axis] * self.block) as isize;
            let inside = |at: isize| at.clamp(0, size[axis] as isize) as usize;
            inside(first)..inside(first + self.block as isize)
        };
        let mut light = [0u64; 3];
        let mut alphas = 0u64;
        for y in range(1) {
            let row = range(0);
            for pixel in rgba[4 * (y * size[0] + row.start)..4 * (y * size[0] + row.end)].as_chunks::<4>().0 {
                let alpha = u64::from(pixel[3]);
                for (sum, &byte) in light.iter_mut().zip(pixel) {
                    *sum += alpha * tables.decode[usize::from(byte)] as u64;
                }
                alphas += alpha;
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
