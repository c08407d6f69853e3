//! Room for long computations, made at once.
//!
//! The allocator grows the memory by as little as a page of 64 kB, and at each step the engine makes a new buffer and collects
//! garbage, which took longer than the solve itself. Pages that are never touched cost nothing.

use super::error::Failure;
use crate::Error;
use wasm_bindgen::prelude::wasm_bindgen;

/// What a solve, an evaluator or a mesh may take.
const LEAST: usize = 32 << 20;
/// A larger need than this is met as it arises.
const MOST: usize = 1 << 30;
/// What a solve takes for each vertex, about, when there are thousands (measured).
const SOLVE_BYTES_PER_VERTEX: usize = 64 << 10;

/// Whether so many bytes are to be had at once, for a computation that is about to ask for them piece by piece.
///
/// # Errors
/// "out-of-memory".
#[wasm_bindgen(js_name = roomFor, skip_typescript)]
pub fn room_for(bytes: f64) -> Result<(), Failure> {
    let wanted = bytes.min(f64::from(u32::MAX)) as usize;
    let mut room = Vec::<u8>::new();
    let found = room.try_reserve_exact(wanted);
    std::hint::black_box(room);
    Ok(found.map_err(|_| Error::OutOfMemory { bytes: bytes as u64 })?)
}

/// Grows the memory, unless that much is free, by what a computation over so many vertices may ask for.
pub fn reserve(vertices: usize) {
    let bytes = vertices.saturating_mul(SOLVE_BYTES_PER_VERTEX).clamp(LEAST, MOST);
    let mut room = Vec::<u8>::new();
    // Where there is no such room, the computation itself will say so, if it does need it.
    let _ = room.try_reserve_exact(bytes);
    std::hint::black_box(room);
}
