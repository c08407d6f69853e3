//! Warping by a joint triangulation.

use super::{Texture, TriangleMesh, Warp, WarpOptions};
use crate::Result;
use crate::mesh::JointTriangulation;

impl Warp for JointTriangulation {
    /// Source → target, affine in each triangle; the mip level follows the magnification at the nodes.
    fn warp_into(&self, texture: &Texture, options: &WarpOptions, out: &mut [u8]) -> Result<()> {
        let magnification = self.magnification();
        let mesh = TriangleMesh {
            source: self.source(),
            target: self.target(),
            triangles: self.triangles(),
            stretch: Some(&magnification),
        };
        mesh.warp_into(texture, options, out)
    }
}
