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
//! Each module uses only those above it in this list: [`error`], [`plane`], [`symm`], [`map`], [`mesh`], [`warp`],
//! [`presets`], `wasm`.
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

pub mod error;
pub mod map;
pub mod mesh;
pub mod plane;
pub mod presets;
pub mod symm;
pub mod warp;
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use error::{Error, Result};
