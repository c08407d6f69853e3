//! `JointTriangulation` in JavaScript.

use super::error::Failure;
use super::memory;
use super::options::{self, FrameOptions};
use super::points;
use super::progress::Progress;
use super::reading::fields;
use super::riemann::RiemannMap;
use super::warp;
use super::words::words;
use super::writing::written;
use crate::mesh::{self, Density, MeshOptions, MeshStop, Route};
use crate::warp::Direction;
use js_sys::Function;
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPESCRIPT: &str = r"
/** How densely the regions are sampled: by `spacing`, or by `frame` and `maxErrorPixels`. */
export type MeshOptions =
    | (Omit<SamplingOptions, 'spacing' | 'frame' | 'maxErrorPixels'> & { spacing: number; frame?: undefined; maxErrorPixels?: undefined })
    | (Omit<SamplingOptions, 'spacing' | 'frame'> & { spacing?: undefined; frame: Frame });
";

words! {
    /// How a sample of the first region finds its place in the second.
    Route { Exact = "exact", Located = "located" }

    /// Why a mesh has no more nodes.
    MeshStop { Density = "density", Crowded = "crowded", MaxNodes = "max-nodes" }
}

/// How densely the regions are sampled: either `spacing`, or `maxErrorPixels` and `frame`.
#[derive(Debug, Default, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct SamplingOptions {
    /// The paper's rectangular grid over the source, with this distance between samples in plane units.
    #[tsify(optional)]
    pub spacing: Option<f64>,
    /// As few nodes as keep the affine pieces within this many pixels of the map itself; 0.25 by default.
    #[tsify(optional)]
    pub max_error_pixels: Option<f64>,
    /// Whose pixels these are: the frame that the target will be drawn in.
    #[tsify(optional)]
    pub frame: Option<FrameOptions>,
    /// How samples get from region to region: "exact", by both maps, or "located", as the paper did, by finding the
    /// triangle of the second region around each.
    #[tsify(optional)]
    pub route: Option<Route>,
    /// Told the stage and the fraction of it that is done; `false` cancels, and the call throws "cancelled".
    #[tsify(optional, type = "(stage: string, fraction: number) => boolean | void")]
    pub on_progress: Option<Function>,
}
fields!(SamplingOptions: spacing, max_error_pixels, frame, route, on_progress);

impl TryFrom<SamplingOptions> for Density {
    type Error = Failure;

    fn try_from(given: SamplingOptions) -> Result<Self, Failure> {
        match (given.spacing, given.frame, given.max_error_pixels) {
            (Some(spacing), None, None) => Ok(Self::Spacing(spacing)),
            (None, Some(frame), pixels) => {
                Ok(Self::MaxError { pixels: pixels.unwrap_or(0.25), frame: frame.try_into()? })
            }
            _ => Err(Failure::option("spacing", "A mesh needs either spacing, or frame and maxErrorPixels.")),
        }
    }
}

impl SamplingOptions {
    fn into_mesh_options(mut self) -> Result<(MeshOptions, Progress), Failure> {
        let (route, progress) = (self.route.unwrap_or_default(), Progress::new(self.on_progress.take()));
        Ok((MeshOptions { density: self.try_into()?, route }, progress))
    }
}

/// The same triangles over two copies of the nodes, affine in each: source region → target region.
#[derive(Debug)]
#[wasm_bindgen]
pub struct JointTriangulation(mesh::JointTriangulation);

/// Mesh pictures show the source's texture in the target.
const USUAL: Direction = Direction::PushForward;

#[wasm_bindgen]
impl JointTriangulation {
    /// Region → disk: the nodes of the region and their images under its Riemann map.
    ///
    /// Throws "invalid-option", "cancelled", or "crowded" where double precision cannot keep nodes apart. `evidence.stop` says
    /// whether the mesh is as near to the map as asked; `RegionMap` and `RiemannMap` warp without a mesh where it is not.
    #[wasm_bindgen(js_name = regionToDisk)]
    pub fn region_to_disk(
        map: &RiemannMap,
        #[wasm_bindgen(unchecked_param_type = "MeshOptions")] options: Ts<SamplingOptions>,
    ) -> Result<Self, Failure> {
        let (options, mut progress) = options::read(&options)?.into_mesh_options()?;
        memory::reserve(0);
        let made = mesh::JointTriangulation::region_to_disk_with(map.inner(), &options, &mut |stage, fraction| {
            progress.report(stage, fraction)
        });
        progress.finish(made).map(Self)
    }

    /// Region → region through the disk: center to center, `toward` to `toward`, outline to outline.
    ///
    /// Throws "invalid-option", "cancelled", or "crowded" where double precision cannot keep nodes apart. `evidence.stop` says
    /// whether the mesh is as near to the map as asked; `RegionMap` and `RiemannMap` warp without a mesh where it is not.
    #[wasm_bindgen(js_name = regionToRegion)]
    pub fn region_to_region(
        from: &RiemannMap,
        to: &RiemannMap,
        #[wasm_bindgen(unchecked_param_type = "MeshOptions")] options: Ts<SamplingOptions>,
    ) -> Result<Self, Failure> {
        let (options, mut progress) = options::read(&options)?.into_mesh_options()?;
        memory::reserve(0);
        let made = mesh::JointTriangulation::region_to_region_with(
            from.inner(),
            to.inner(),
            &options,
            &mut |stage, fraction| progress.report(stage, fraction),
        );
        progress.finish(made).map(Self)
    }

    /// Target → source: the same triangles, the copies exchanged.
    pub fn reversed(&self) -> Self {
        Self(self.0.clone().reversed())
    }

    /// A mesh from its arrays, as a worker receives them: `source`, `target`, `triangles` and `magnification` of another
    /// one. Without the last, the triangles tell the magnification.
    ///
    /// Throws "wrong-length" or "invalid-mesh".
    #[wasm_bindgen(js_name = fromParts)]
    pub fn from_parts(
        source: &[f64],
        target: &[f64],
        triangles: &[u32],
        magnification: Option<Vec<f64>>,
    ) -> Result<Self, Failure> {
        let [source, target] =
            [points::from_flat("The source nodes", source)?, points::from_flat("The target nodes", target)?];
        let triangles = points::triples_from_flat("The triangles", triangles)?;
        let mesh = mesh::JointTriangulation::from_parts(source, target, triangles)?;
        if let Some(k) = magnification.iter().flatten().position(|factor| factor.is_nan() || *factor <= 0.0) {
            let reason = format!("magnification {k} is not a positive number");
            return Err(crate::Error::InvalidMesh { reason }.into());
        }
        Ok(Self(match magnification {
            Some(exact) => mesh.with_magnification(&exact)?,
            None => mesh,
        }))
    }

    /// |f'| at each node, target over source: what the mip level of a picture follows.
    #[wasm_bindgen(getter)]
    pub fn magnification(&self) -> Vec<f64> {
        self.0.magnification().to_vec()
    }

    /// The nodes in the source region `[x0, y0, x1, y1, …]`.
    #[wasm_bindgen(getter)]
    pub fn source(&self) -> Vec<f64> {
        points::to_flat(self.0.source())
    }

    /// The nodes in the target region `[x0, y0, x1, y1, …]`.
    #[wasm_bindgen(getter)]
    pub fn target(&self) -> Vec<f64> {
        points::to_flat(self.0.target())
    }

    /// Three nodes each, counter-clockwise in both copies.
    #[wasm_bindgen(getter)]
    pub fn triangles(&self) -> Vec<u32> {
        self.0.triangles().as_flattened().to_vec()
    }

    /// The nodes on the boundary, counter-clockwise.
    #[wasm_bindgen(getter)]
    pub fn outline(&self) -> Vec<u32> {
        self.0.outline().to_vec()
    }

    /// Number of triangles that are flipped or degenerate in either copy: 0 unless something went wrong.
    #[wasm_bindgen(getter)]
    pub fn flipped(&self) -> usize {
        self.0.flipped()
    }

    /// What the making of the mesh found out about it.
    #[wasm_bindgen(getter)]
    pub fn evidence(&self) -> Result<Ts<MeshEvidence>, Failure> {
        let found = self.0.evidence();
        Ok(options::write(MeshEvidence {
            flipped_at_first: found.flipped_at_first,
            added: found.added,
            mended: found.mended,
            moved: found.moved,
            largest_error: found.largest_error,
            stop: found.stop,
            largest_error_pixels: found.largest_error_pixels(),
            crowded_error: found.crowded_error,
            crowded_error_pixels: found.crowded_error_pixels(),
            route_difference: found.route_difference,
            route_difference_pixels: found.route_difference_pixels(),
            largest_angle_error: self.0.largest_angle_error(),
            mean_angle_error: self.0.mean_angle_error(),
        }))
    }

    /// Proves that both copies are triangulations of their outlines: every triangle counter-clockwise, no overlap, the
    /// outlines complete, the areas equal.
    ///
    /// Throws "invalid-mesh" with the first thing that is wrong.
    pub fn validate(&self) -> Result<(), Failure> {
        Ok(self.0.validate()?)
    }

    /// Both copies side by side as an SVG document.
    #[wasm_bindgen(js_name = toSVG)]
    pub fn to_svg(&self) -> String {
        self.0.to_svg()
    }

    /// The target copy as a Wavefront OBJ, with the source as texture coordinates in the given frame.
    #[wasm_bindgen(js_name = toOBJ)]
    pub fn to_obj(&self, texture: Ts<FrameOptions>) -> Result<String, Failure> {
        Ok(self.0.to_obj(&options::read(&texture)?.try_into()?))
    }
}

warp::warp_methods! {
    JointTriangulation, USUAL,
    " The texture as the mesh carries it, by default to the target: RGBA bytes with straight alpha."
}

/// What the making of a joint triangulation found out about it.
#[derive(Debug, Tsify)]
#[serde(rename_all = "camelCase")]
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
    /// The largest distance between the map and its affine pieces, in plane units of the target, in what was mended too; not
    /// finite if the map has no value somewhere. What is so small in the source that it shows one colour does not count.
    pub largest_error: f64,
    /// Why there are no more nodes: "density" if it is as asked; "crowded" if an error is above the bound but double precision
    /// has no room for more nodes; "max-nodes" if there are as many as there may be.
    pub stop: MeshStop,
    /// The same in pixels of the frame, if one was given.
    #[tsify(optional)]
    pub largest_error_pixels: Option<f64>,
    /// The same for what is so small in the source that it shows one colour, be it large in the target: parts that the maps
    /// crowd together beyond double precision. In plane units of the target.
    pub crowded_error: f64,
    /// The same in pixels of the frame, if one was given.
    #[tsify(optional)]
    pub crowded_error_pixels: Option<f64>,
    /// The largest distance between where the route "located" puts samples and where the exact one does, in plane units of
    /// the target.
    pub route_difference: f64,
    /// The same in pixels of the frame, if one was given.
    #[tsify(optional)]
    pub route_difference_pixels: Option<f64>,
    /// The largest change of an angle by an affine piece, in radians. It stays large where a corner's angle changes: the
    /// triangles there share the change, however small they are.
    pub largest_angle_error: f64,
    /// The mean change of an angle over the target's area, in radians: what the picture shows of the distortion.
    pub mean_angle_error: f64,
}
written!(
    MeshEvidence: flipped_at_first, added, mended, moved, largest_error, stop, largest_error_pixels, crowded_error,
    crowded_error_pixels, route_difference, route_difference_pixels, largest_angle_error, mean_angle_error
);
