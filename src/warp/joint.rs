//! Warping by a joint triangulation.

use super::{PreparedWarp, Texture, TriangleMesh, Warp, WarpOptions};
use crate::Result;
use crate::mesh::JointTriangulation;

impl Warp for JointTriangulation {
    /// Source → target, affine in each triangle; the mip level follows the magnification at the nodes.
    fn warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        triangles(self).warp_into(texture, options, out)
    }

    fn prepare(&self, texture: &Texture, options: &WarpOptions) -> Result<PreparedWarp> {
        triangles(self).prepare(texture, options)
    }
}

fn triangles(mesh: &JointTriangulation) -> TriangleMesh<'_> {
    TriangleMesh {
        source: mesh.source(),
        target: mesh.target(),
        triangles: mesh.triangles(),
        stretch: Some(mesh.magnification()),
    }
}
