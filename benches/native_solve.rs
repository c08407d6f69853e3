//! Whole solves and evaluation, native: `cargo bench --bench native_solve`.
#![allow(missing_docs)]

#[cfg(not(target_arch = "wasm32"))]
#[path = "native/solve.rs"]
mod solve;

#[cfg(not(target_arch = "wasm32"))]
criterion::criterion_main!(solve::benches);

/// Nothing is measured there.
#[cfg(target_arch = "wasm32")]
fn main() {}
