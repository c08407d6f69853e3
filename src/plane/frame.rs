//! Where a picture lies in the plane.

use super::Complex64;
use crate::{Error, Result};

/// A rectangle of the plane with a pixel grid over it: the only place where pixels and the plane meet.
///
/// Pixels are square; the centre of pixel (i, j) is at (i + ½, j + ½); rows are counted downwards, y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    center: Complex64,
    width: f64,
    pixels: [usize; 2],
}

impl Frame {
    /// A frame around `center`, `width` plane units wide; its height follows from `pixels` = [columns, rows].
    ///
    /// # Errors
    /// [`Error::InvalidFrame`] if a number is not finite, the width or a pixel count is not positive, or pixels are too small or
    /// too far away for numbers.
    pub fn new(center: Complex64, width: f64, pixels: [usize; 2]) -> Result<Self> {
        let reason = if !center.is_finite() {
            Some("the center is not finite")
        } else if !(width.is_finite() && width > 0.0) {
            Some("the width is not a positive number")
        } else if pixels.contains(&0) {
            Some("a pixel count is 0")
        } else if pixels.iter().any(|&n| n > 1 << 16) {
            Some("a pixel count is above 65536")
        } else {
            None
        };
        if let Some(reason) = reason {
            return Err(Error::InvalidFrame { reason });
        }
        let frame = Self { center, width, pixels };
        let [near, far] = [frame.to_plane(0.0, 0.0), frame.to_plane(pixels[0] as f64, pixels[1] as f64)];
        // Beyond them neither a pixel's size nor its reciprocal is a number.
        let has_numbers = frame.pixel_size().recip().is_finite() && near.is_finite() && far.is_finite();
        if has_numbers {
            Ok(frame)
        } else {
            Err(Error::InvalidFrame { reason: "its pixels lie beyond the range of numbers" })
        }
    }

    /// The middle of the frame, in the plane.
    #[must_use]
    pub fn center(&self) -> Complex64 {
        self.center
    }

    /// Width in plane units.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Height in plane units.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.pixel_size() * self.pixels[1] as f64
    }

    /// The frame's pixel counts, [columns, rows].
    #[must_use]
    pub fn pixels(&self) -> [usize; 2] {
        self.pixels
    }

    /// Side of a pixel in plane units.
    #[must_use]
    pub fn pixel_size(&self) -> f64 {
        self.width / self.pixels[0] as f64
    }

    /// Pixel coordinates → plane. The centre of pixel (i, j) is at `(i + 0.5, j + 0.5)`.
    ///
    /// ```
    /// use conformal_warp::{Complex64, Frame};
    /// let frame = Frame::new(Complex64::new(1.0, 2.0), 4.0, [400, 200]).unwrap();
    /// assert_eq!(frame.to_plane(0.0, 0.0), Complex64::new(-1.0, 3.0)); // the top left corner
    /// ```
    #[must_use]
    pub fn to_plane(&self, x: f64, y: f64) -> Complex64 {
        let size = self.pixel_size();
        let [columns, rows] = self.pixels.map(|n| n as f64);
        self.center + Complex64::new((x - 0.5 * columns) * size, (0.5 * rows - y) * size)
    }

    /// Plane → pixel coordinates (x, y), also outside the frame; the inverse of [`Frame::to_plane`].
    #[must_use]
    pub fn to_pixels(&self, z: Complex64) -> (f64, f64) {
        let size = self.pixel_size();
        let [columns, rows] = self.pixels.map(|n| n as f64);
        let d = z - self.center;
        (d.re / size + 0.5 * columns, 0.5 * rows - d.im / size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_directions_are_inverse() {
        let frame = Frame::new(Complex64::new(-3.25, 0.7), 5.5, [640, 480]).unwrap();
        for (x, y) in [(0.0, 0.0), (0.5, 0.5), (639.5, 479.5), (-12.0, 700.25)] {
            let (u, v) = frame.to_pixels(frame.to_plane(x, y));
            assert!((u - x).abs() < 1e-10 && (v - y).abs() < 1e-10, "({x}, {y}) came back as ({u}, {v})");
        }
        assert_eq!(frame.to_plane(320.0, 240.0), frame.center());
    }

    #[test]
    fn refuses_unusable_frames() {
        for (width, pixels) in [(0.0, [4, 4]), (-1.0, [4, 4]), (f64::NAN, [4, 4]), (1.0, [0, 4]), (1.0, [4, 1 << 17])] {
            let error = Frame::new(Complex64::ZERO, width, pixels).unwrap_err();
            assert_eq!(error.code(), "invalid-frame");
        }
    }
}
