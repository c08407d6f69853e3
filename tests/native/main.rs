//! Every native integration test, in one binary: a room for each part of the library, `support` for what they share.
//!
//! `cargo test --test native symm::exact` runs one file of them.
#![cfg(not(target_arch = "wasm32"))]
#![allow(clippy::unwrap_used, reason = "a test that cannot be set up has failed")]

mod architecture;
mod cortex;
mod evaluate;
mod formula;
mod holes;
mod hostile;
mod marked;
mod mesh;
mod support;
mod symm;
mod warp;
