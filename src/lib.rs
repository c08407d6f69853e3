//! Conformal image warping: compute a conformal map, then draw a picture through it without aliasing.
//!
//! After C. Frederick and E. L. Schwartz, *Conformal Image Warping* (NYU TR 408, 1988), and
//! G. T. Symm, *An integral equation method in conformal mapping* (Numer. Math. 9, 1966).
//!
//! # Data flows one way
//! ```text
//! image ─────────────────────────────► Texture (mip pyramid) ─────────────┐
//! region ─► Symm solve ─► RiemannMap ─┐                                    ▼
//! formula ─► FormulaMap ──────────────┼─► per-pixel pull-back ─────────► raster ─► RGBA
//! retina, cortex ─► RetinoCorticalMap ┴─► JointTriangulation (affine) ────┘
//! ```
//! A new image never re-solves a map; a moved camera never rebuilds a mesh; a warp never knows where its map came from.
//! Each module uses only those above it in this list: [`error`], [`plane`], [`symm`], [`map`]; [`formula`], [`riemann`] and
//! [`cortex`] side by side; [`mesh`], [`warp`], [`presets`], `wasm`. Names are those of the JavaScript package, and flat.
//!
//! ```
//! use conformal_warp::{
//!     Complex64, Curve, Direction, Frame, Light, Region, RiemannMap, SolveOptions, Texture, Warp, WarpOptions, Wrap,
//! };
//!
//! // A picture, here of two pixels, two units wide around 0 …
//! let texture = Texture::new(&[255, 0, 0, 255, 0, 0, 255, 255], 2, 1, Wrap::Clamp, Light::Linear)?;
//! let picture = Frame::new(Complex64::ZERO, 2.0, [2, 1])?;
//! // … a square on it, its conformal map to the unit disk …
//! let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(|(x, y)| Complex64::new(x, y));
//! let region = Region::new(&corners, Curve::Polygon, Complex64::ZERO, corners[0])?;
//! let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
//! // … and the square's part of the picture on the disk.
//! let view = Frame::new(Complex64::ZERO, 2.0, [64, 64])?;
//! let options = WarpOptions { direction: Direction::PushForward, ..WarpOptions::new(picture, view) };
//! let pixels = map.warp(&texture, &options)?;
//! assert_eq!(pixels[3], 0, "outside the disk");
//! assert_eq!(pixels[4 * (32 * 64 + 32) + 3], 255, "at its center");
//! # Ok::<(), conformal_warp::Error>(())
//! ```
//!
//! # Threads
//! Maps and textures may be shared between threads. With the feature `parallel`, which is off by default and does nothing in
//! wasm, `ParallelWarp` draws a picture and `par_points` evaluates many points over all threads of
//! [rayon](https://docs.rs/rayon), with the same bits as one thread.
//!
//! # Conventions
//! - The plane has y up and counter-clockwise angles. [`plane::Frame`] alone knows pixels: square pixels, centres at
//!   +0.5, rows counted downwards.
//! - A region is a simple closed curve with a `center` inside it, which goes to 0, and a `toward` point on its
//!   boundary, which goes to 1: the paper's inward vector. Vertices are kept counter-clockwise.
//! - Names tell direction. *Pull-back* by f: the output point p shows the texture at f(p). *Push-forward* by f: the
//!   output point f(z) shows the texture at z. Symm's map is region → disk.
//! - Pixels are RGBA8, row-major, straight alpha at the edge; filtering works on premultiplied values.
//! - Every approximation returns evidence beside its answer: residual, error estimate, flipped triangles.

/// The README's code in Rust, run with the examples above.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod cortex;
pub mod error;
pub mod formula;
pub mod map;
pub mod mesh;
pub mod plane;
pub mod presets;
pub mod riemann;
mod stored;
pub mod symm;
pub mod warp;
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use cortex::{
    CorticalImage, CorticalModel, Degrees, FieldPoint, Gaze, HalfDiskMap, Hemisphere, Landmark, Mirrored, OutlineView,
    Remembered, RetinoCorticalMap, VisualCortex,
};
pub use error::{Error, Result};
pub use formula::FormulaMap;
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
pub use map::par_points;
pub use map::{Compose, Inverse, InvertibleMap, Jet, Moebius, PlaneMap};
pub use mesh::{Density, JointTriangulation, MeshEvidence, MeshOptions, MeshStop, Route};
pub use plane::{
    ArcTo, BoundaryPoint, Complex64, Curve, CurvedOutline, Domain, Edge, EllipticArc, Frame, Polygon, Region, Shape,
    SmoothCurve, parse_outline, parse_path, parse_path_with_holes, parse_shape, path_data, smooth_edges, spline,
};
pub use riemann::{
    AnnulusMap, CanonicalMap, ChannelEnds, ChannelFlow, Circle, CircleMap, Circulation, Conductors, DiskPoint,
    Electrostatics, ExteriorMap, FlowLines, FlowPoints, HalfPlaneMap, JoinedMap, LevelLine, PotentialFlow,
    RectangleMap, RegionMap, RiemannMap, RingLines, Slit, SlitKind, SlitMap, StripMap,
};
pub use symm::options::{Progress, SolveOptions, Stop};
#[cfg(all(feature = "parallel", not(target_arch = "wasm32")))]
pub use warp::ParallelWarp;
pub use warp::{
    Direction, FoveatedTexture, Light, Overlay, PreparedWarp, Quality, Stroke, Texture, TriangleMesh, Warp,
    WarpOptions, Wrap,
};
