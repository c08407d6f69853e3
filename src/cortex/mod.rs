//! From a picture to the visual cortex, step by step: each step a map of its own with its inverse and exact derivatives.
//!
//! ```text
//! picture ─► Gaze ─► visual field ─► half disk ─► HalfDiskMap ─► disk ─► Symm's map, inverted ─► V1's outline
//!            (perspective)  (stereographic)        T = H∘G∘F                                      in millimetres
//!                                └─► Degrees ─► CorticalModel (monopole, dipole, wedge-dipole) ─► millimetres
//! ```
//! # Conventions
//! - The *field coordinate* s = tan(E/2)·e^{iθ} is the stereographic projection of the sphere of directions: E is the
//!   eccentricity, the angle from the line of sight; θ is the azimuth, 0 on the right horizontal meridian and
//!   counter-clockwise as the eye sees it. The right hemifield to 90° is the half disk |s| ≤ 1, Re s ≥ 0.
//! - The right hemifield goes to the left hemisphere. The right hemisphere is the mirror image of the left: it shows
//!   the left hemifield through the same map between two reflections ([`Mirrored`]).
//! - Angles are in degrees, lengths on the cortex in millimetres.
//!
//! Sources: C. Frederick and E. L. Schwartz (1988), appendix 3; M. Balasubramanian, J. Polimeni and E. L. Schwartz, *The
//! V1–V2–V3 complex* (Neural Networks 15, 2002), for the models.

mod field;
mod gaze;
mod half_disk;
mod landmark;
mod mirrored;
mod model;
mod outline;
mod remembered;
mod retino_cortical;
mod view;
mod visual_cortex;

pub use field::{Degrees, FieldPoint};
pub use gaze::Gaze;
pub use half_disk::HalfDiskMap;
pub use landmark::Landmark;
pub use mirrored::Mirrored;
pub use model::CorticalModel;
pub use remembered::Remembered;
pub use retino_cortical::RetinoCorticalMap;
pub use view::OutlineView;
pub use visual_cortex::{CorticalImage, Hemisphere, VisualCortex};
