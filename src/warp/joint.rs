//! Warping by a joint triangulation.

use super::{PreparedWarp, Texture, TriangleMesh, Warp, WarpOptions};
use crate::Result;
use crate::mesh::JointTriangulation;

impl Warp for JointTriangulation {
    /// Source → target, affine in each triangle; the mip level follows the magnification at the nodes.
    fn warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        nodes(self, &self.magnification()).warp_into(texture, options, out)
    }

    fn prepare(&self, texture: &Texture, options: &WarpOptions) -> Result<PreparedWarp> {
        nodes(self, &self.magnification()).prepare(texture, options)
    }
}

fn nodes<'a>(mesh: &'a JointTriangulation, magnification: &'a [f64]) -> TriangleMesh<'a> {
    TriangleMesh {
        source: mesh.source(),
        target: mesh.target(),
        triangles: mesh.triangles(),
        stretch: Some(magnification),
    }
}
