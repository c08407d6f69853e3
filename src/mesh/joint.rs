//! The joint triangulation: two point sets, one connectivity.

use super::{quality, triangles};
use crate::plane::{Complex64, Polygon};
use crate::{Error, Result};

/// Source region → target region, affine in each triangle: the same triangles over two copies of the nodes.
///
/// Both copies are covered once, without overlap, and have the outlines that were drawn (the circle is replaced by
/// the polygon of its nodes). Triangles are anticlockwise in both.
#[derive(Clone, Debug, PartialEq)]
pub struct JointTriangulation {
    pub(super) source: Vec<Complex64>,
    pub(super) target: Vec<Complex64>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Closed curves with the triangles on their left.
    pub(super) outlines: Vec<Vec<u32>>,
    /// What each of them must be, in each copy.
    pub(super) shapes: [Vec<Shape>; 2],
    pub(super) magnification: Vec<f64>,
    pub(super) evidence: MeshEvidence,
}

/// The outline that a copy must have.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Shape {
    Polygon(Polygon),
    /// A smooth curve, replaced by the polygon of the nodes on it.
    Curve,
    /// The unit disk, replaced by the polygon of the nodes on its circle.
    Disk,
}

/// Why a mesh has no more nodes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MeshStop {
    /// It has the density that was asked for: the spacing, or an error within the bound.
    #[default]
    Density,
    /// The error is above the bound, if only where parts of the source show one colour, and more nodes do not help: double
    /// precision has no room for them. A picture drawn by the map itself, without a mesh, has no such limit.
    Crowded,
    /// The error is above the bound, and there are as many nodes as a mesh may have.
    MaxNodes,
}

/// What the making of a joint triangulation found out about it. Lengths are in plane units of the target, and in pixels
/// where a method says so.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct MeshEvidence {
    /// Triangles of the first connectivity that were flipped or degenerate in the target.
    pub flipped_at_first: usize,
    /// Nodes added to undo those flips.
    pub added: usize,
    /// Triangles that no refinement could turn back, because double precision has no room for them in one of the copies: their
    /// surroundings are connected without folds, but not conformally.
    pub mended: usize,
    /// Boundary nodes moved along an outline because the maps crowd them together beyond double precision.
    pub moved: usize,
    /// Largest distance between the map and its affine pieces, measured at the middles of edges and triangles and towards
    /// corners, in what was mended too; infinite if the map has no value there. What is so small in the source that it shows
    /// one colour does not count.
    pub largest_error: f64,
    /// The same for what is so small in the source that it shows one colour, be it large in the target: parts that the maps
    /// crowd together beyond double precision.
    pub crowded_error: f64,
    /// Why there are no more nodes.
    pub stop: MeshStop,
    /// Largest distance between where the paper's route puts the samples and where the
    /// exact one does; 0 for the exact route.
    pub route_difference: f64,
    /// Size of a pixel of the frame that the density was asked for in, in plane units of the target.
    pub pixel_size: Option<f64>,
}

impl MeshEvidence {
    /// [`MeshEvidence::largest_error`] in pixels, if a frame was given.
    #[must_use]
    pub fn largest_error_pixels(&self) -> Option<f64> {
        self.pixel_size.map(|pixel| self.largest_error / pixel)
    }

    /// [`MeshEvidence::crowded_error`] in pixels, if a frame was given.
    #[must_use]
    pub fn crowded_error_pixels(&self) -> Option<f64> {
        self.pixel_size.map(|pixel| self.crowded_error / pixel)
    }

    /// [`MeshEvidence::route_difference`] in pixels, if a frame was given.
    #[must_use]
    pub fn route_difference_pixels(&self) -> Option<f64> {
        self.pixel_size.map(|pixel| self.route_difference / pixel)
    }
}

impl JointTriangulation {
    /// The same mesh with |f'| at its nodes as given; where a number is not finite and positive, the triangles' stays.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one number a node.
    pub fn with_magnification(mut self, exact: &[f64]) -> Result<Self> {
        let nodes = self.source.len();
        if exact.len() != nodes {
            let what = "The magnification";
            return Err(Error::WrongLength { what, expected: nodes.to_string(), found: exact.len() });
        }
        for (own, &exact) in self.magnification.iter_mut().zip(exact) {
            if exact.is_normal() && exact > 0.0 {
                *own = exact;
            }
        }
        Ok(self)
    }

    /// Target → source: the same triangles, the copies exchanged. The evidence stays that of the making.
    #[must_use]
    pub fn reversed(self) -> Self {
        let [source, target] = self.shapes;
        let magnification = self.magnification.iter().map(|factor| 1.0 / factor).collect();
        Self { source: self.target, target: self.source, shapes: [target, source], magnification, ..self }
    }

    /// The nodes in the source region, plane units.
    #[must_use]
    pub fn source(&self) -> &[Complex64] {
        &self.source
    }

    /// The nodes in the target region, plane units.
    #[must_use]
    pub fn target(&self) -> &[Complex64] {
        &self.target
    }

    /// Three nodes each, anticlockwise in both copies.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The nodes on the boundary, anticlockwise, from the one that goes to `toward`.
    #[must_use]
    pub fn outline(&self) -> &[u32] {
        &self.outlines[0]
    }

    /// How much the map magnifies at each node, target over source: |f'|, and at corners, where that is 0 or infinite, what
    /// the triangles around them do.
    #[must_use]
    pub fn magnification(&self) -> &[f64] {
        &self.magnification
    }

    /// The largest change of an angle by an affine piece, in radians: the mesh's quasi-conformal distortion.
    ///
    /// It does not fall as the mesh gets finer where a corner's angle changes: the triangles there share the change.
    #[must_use]
    pub fn largest_angle_error(&self) -> f64 {
        quality::angle_errors(&self.source, &self.target, &self.triangles).largest
    }

    /// The mean change of an angle over the target's area, in radians: what the picture shows of the distortion.
    #[must_use]
    pub fn mean_angle_error(&self) -> f64 {
        quality::angle_errors(&self.source, &self.target, &self.triangles).mean
    }

    /// Number of triangles that are flipped or degenerate in either copy: 0 unless something went wrong.
    #[must_use]
    pub fn flipped(&self) -> usize {
        triangles::flipped(&self.source, &self.target, &self.triangles)
    }

    /// What the making of the mesh found out.
    #[must_use]
    pub fn evidence(&self) -> MeshEvidence {
        self.evidence
    }
}
