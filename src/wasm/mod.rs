//! The JavaScript interface: convert, call, convert.
//!
//! One file a class; its documentation is written for JavaScript, where it becomes the package's types and their help.
//! What the classes share: [`error`] (an error → `Error` with a `code`), [`options`] (plain objects → Rust structs,
//! with errors in words: by [`reading`] and, back, [`writing`]; `words` are the values of enums), [`points`] (`Float64Array` ↔ complex numbers), [`progress`] (the caller's `onProgress`),
//! [`memory`] (room made at once), [`warp`] (the methods `warp` and `paint`), [`prepared`] (the method `prepareWarp`),
//! [`overlay`] (the method `overlay`), [`drawn`] (the ways to give a boundary), [`level_lines`] (lines of maps, fields and flows).

#[cfg(feature = "regions")]
pub mod annulus;
#[cfg(feature = "regions")]
pub mod canonical;
#[cfg(feature = "regions")]
pub mod channel;
#[cfg(feature = "regions")]
pub mod circles;
#[cfg(feature = "regions")]
pub mod cortex;
#[cfg(feature = "regions")]
mod drawn;
#[cfg(feature = "regions")]
pub mod electrostatics;
pub mod error;
#[cfg(feature = "regions")]
pub mod exterior;
#[cfg(feature = "regions")]
pub mod flow;
pub mod formula;
pub mod foveated;
pub mod frame;
#[cfg(feature = "regions")]
pub mod half_plane;
#[cfg(feature = "regions")]
pub mod level_lines;
pub mod memory;
#[cfg(feature = "regions")]
pub mod mesh;
pub mod options;
pub mod overlay;
pub mod points;
pub mod prepared;
pub mod presets;
pub mod progress;
pub mod reading;
#[cfg(feature = "regions")]
pub mod rectangle;
#[cfg(feature = "regions")]
pub mod region;
#[cfg(feature = "regions")]
pub mod region_map;
#[cfg(feature = "regions")]
pub mod riemann;
#[cfg(feature = "regions")]
pub mod slits;
#[cfg(feature = "regions")]
mod solved;
#[cfg(feature = "regions")]
pub mod strip;
pub mod texture;
pub mod warp;
mod words;
pub mod writing;

use wasm_bindgen::prelude::wasm_bindgen;

/// Runs when the module is loaded: a panic, which would be a bug of ours, reaches the console with its message.
#[wasm_bindgen(start, skip_typescript)]
fn start() {
    console_error_panic_hook::set_once();
}
