//! What a caller may choose about a joint triangulation.

use crate::plane::Frame;
use crate::{Error, Result};

/// How densely the two regions are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Density {
    /// The paper's rectangular grid over the source region, with this distance between samples, in plane units.
    Spacing(f64),
    /// Graded: as few nodes as keep the affine pieces within `pixels` of the map itself.
    MaxError {
        /// Largest allowed distance between the map and its affine pieces, in pixels of `frame`.
        pixels: f64,
        /// The pixels that the target copy will be drawn with.
        frame: Frame,
    },
}

impl Density {
    /// A quarter of a pixel of `frame`: a difference that nobody sees.
    #[must_use]
    pub fn quarter_pixel(frame: Frame) -> Self {
        Self::MaxError { pixels: 0.25, frame }
    }
}

/// How a sample of the first region finds its place in the second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Route {
    /// Through the disk by both Riemann maps.
    #[default]
    Exact,
    /// As the paper did: the second region is triangulated too, the sample's image in the disk is located among those
    /// triangles, and the affine map of the triangle carries it on.
    Located,
}

/// Options of a joint triangulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshOptions {
    /// How many samples there are, and where.
    pub density: Density,
    /// How samples travel from region to region; of no effect on region → disk.
    pub route: Route,
}

impl MeshOptions {
    /// The paper's grid with `spacing` plane units between samples, nodes mapped exactly.
    #[must_use]
    pub fn with_spacing(spacing: f64) -> Self {
        Self { density: Density::Spacing(spacing), route: Route::Exact }
    }

    /// A graded mesh within a quarter pixel of the map, in the pixels of `frame`.
    #[must_use]
    pub fn quarter_pixel(frame: Frame) -> Self {
        Self { density: Density::quarter_pixel(frame), route: Route::Exact }
    }

    pub(crate) fn check(&self) -> Result<()> {
        let (name, value) = match self.density {
            Density::Spacing(spacing) => ("spacing", spacing),
            Density::MaxError { pixels, .. } => ("max_error_pixels", pixels),
        };
        if value.is_finite() && value > 0.0 {
            Ok(())
        } else {
            Err(Error::InvalidOption { name, expected: "a positive number", value })
        }
    }
}
