//! Warping by a joint triangulation.

use super::mesh::TriangleMesh;
use super::options::WarpOptions;
use super::strip::Strip;
use super::texture::Texture;
use super::warping::Warp;
use crate::Result;
use crate::mesh::JointTriangulation;

impl Warp for JointTriangulation {
    /// Source → target, affine in each triangle; the mip level follows the magnification at the nodes.
    fn footprints(&self, texture: &Texture, options: &WarpOptions, each: &mut dyn FnMut(&Strip)) -> Result<()> {
        let mesh = TriangleMesh {
            source: self.source(),
            target: self.target(),
            triangles: self.triangles(),
            stretch: Some(self.magnification()),
        };
        mesh.footprints(texture, options, each)
    }
}
