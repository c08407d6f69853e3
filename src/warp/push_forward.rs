//! Push-forward: the output point f(z) shows the texture at z, for a map whose inverse nobody gives.

use super::mesh::MeshRaster;
use super::options::WarpOptions;
use super::raster::{Corner, Overlap};
use super::render::{TexelGrid, each_strip};
use super::source_mesh::source_mesh;
use super::strip::Strip;
use super::texture::Texture;
use crate::Result;
use crate::map::PlaneMap;

/// The footprints of the image under the map of the texture's frame: of the picture once, whatever its wrap mode.
///
/// Where sheets overlap, the point that is lowest in the texture is seen.
pub(super) fn push_forward<M: PlaneMap + ?Sized>(
    map: &M,
    texture: &Texture,
    options: &WarpOptions,
    each: &mut dyn FnMut(&Strip),
) -> Result<()> {
    let mesh = source_mesh(map, &options.texture, &options.view);
    let [width, height] = texture.size().map(|n| n as f64);
    let unit = TexelGrid::new(options.texture, texture).density() * options.view.pixel_size();
    let corner = |vertex: &super::source_mesh::Vertex| Corner {
        x: vertex.at[0],
        y: vertex.at[1],
        u: vertex.share[0] * width,
        v: vertex.share[1] * height,
        // Where the map is critical the footprint is unbounded: the coarsest level.
        level: (unit / vertex.least_stretch).log2().clamp(-30.0, 30.0),
    };
    let corners: Vec<Corner> = mesh.vertices.iter().map(corner).collect();
    let mut raster = MeshRaster::new(&corners, &mesh.triangles, &options.view, Overlap::Lowest);
    each_strip(options, &mut raster, each)
}
