//! Meshes and pictures, native: `cargo bench --bench native_picture`.
#![allow(missing_docs)]

#[cfg(not(target_arch = "wasm32"))]
#[path = "native/picture.rs"]
mod picture;

#[cfg(not(target_arch = "wasm32"))]
criterion::criterion_main!(picture::benches);

/// Nothing is measured there.
#[cfg(target_arch = "wasm32")]
fn main() {}
