//! A strip of rows of the view with, for each pixel, the point of the texture that it shows and its footprint there.
//!
//! This is the one interface between maps and samplers: pull-backs and triangle meshes write strips, samplers read them.

use super::options::Quality;

/// Rows of a strip. Strips start at multiples of it, so that a band of rows is cut as the whole view would be.
pub(super) const ROWS: usize = 32;

/// The footprints of up to [`ROWS`] rows, each quantity in an array of its own.
#[derive(Debug)]
pub struct Strip {
    /// The view's row of the strip's first row.
    pub first_row: usize,
    /// Rows in use.
    pub rows: usize,
    /// The view's columns.
    pub width: usize,
    /// Numbers from one row to the next: `width`, rounded up to whole groups of four.
    pub stride: usize,
    /// Columns of the texture, in texels from its left edge; NaN where the pixel shows nothing.
    pub u: Vec<f32>,
    /// Rows of the texture, in texels from its top edge.
    pub v: Vec<f32>,
    /// log₂ of the footprint's diameter in texels; empty if the quality has no use for it.
    pub level: Vec<f32>,
    /// ∂u/∂x, ∂v/∂x, ∂u/∂y, ∂v/∂y over the view's pixels; empty if the quality has no use for them.
    pub jacobian: [Vec<f32>; 4],
    /// Pixels (row, column) of which only a share shows something, with that share.
    pub shares: Vec<(usize, usize, f32)>,
}

impl Strip {
    pub fn new(width: usize, quality: Quality) -> Self {
        let stride = width.next_multiple_of(4);
        let plane = |wanted: bool| if wanted { vec![0.0; stride * ROWS] } else { Vec::new() };
        let jacobian = std::array::from_fn(|_| plane(quality == Quality::Best));
        let level = plane(matches!(quality, Quality::Trilinear | Quality::Best));
        Self {
            first_row: 0,
            rows: 0,
            width,
            stride,
            u: plane(true),
            v: plane(true),
            level,
            jacobian,
            shares: Vec::new(),
        }
    }

    /// Moves the strip to other rows, where no pixel shows anything yet.
    pub fn reset(&mut self, first_row: usize, rows: usize) {
        self.first_row = first_row;
        self.rows = rows;
        self.u.fill(f32::NAN);
        self.shares.clear();
    }

    /// Index of the first pixel of the strip's row `row`.
    pub fn start(&self, row: usize) -> usize {
        row * self.stride
    }

    pub fn has_levels(&self) -> bool {
        !self.level.is_empty()
    }

    pub fn has_jacobian(&self) -> bool {
        !self.jacobian[0].is_empty()
    }
}
