//! The same maps solved natively and in wasm give the same numbers.
//!
//! Runs in both. `REGENERATE=1 cargo test --test wasm_same_numbers` stores the native numbers anew.
#![allow(clippy::unwrap_used)]

mod common;

use common::{angle_error, case, largest, points, solve};
use conformal_warp::plane::Complex64;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test;

const CASES: [&str; 7] = ["sc_4_101", "sc_6_102", "sc_9_103", "sc_15_104", "sc_24_105", "neck", "blob100"];
const STORED: &str = include_str!("fixtures/native_numbers.json");

/// What a solved map says.
#[derive(Deserialize, Serialize)]
struct Numbers {
    conformal_radius: f64,
    angles: Vec<f64>,
    /// Images of the case's interior points; one without any takes the midpoints between the center and its vertices,
    /// as far as they lie inside.
    images: Vec<[f64; 2]>,
}

fn numbers(name: &str) -> Numbers {
    let case = case(name);
    let region = case.region();
    let mut interior = points(&case.interior_z);
    if interior.is_empty() {
        interior = region.boundary().iter().map(|v| 0.5 * (v + region.center())).collect();
        interior.retain(|&z| region.contains(z));
    }
    let map = solve(&region, 1e-8);
    Numbers {
        conformal_radius: map.conformal_radius(),
        angles: map.angles().to_vec(),
        images: map.to_disk(&interior).iter().map(|w| [w.re, w.im]).collect(),
    }
}

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
fn wasm_gives_the_native_numbers() {
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("REGENERATE").is_some() {
        let all: BTreeMap<_, _> = CASES.iter().map(|name| (name, numbers(name))).collect();
        std::fs::write("tests/fixtures/native_numbers.json", serde_json::to_string(&all).unwrap()).unwrap();
        return;
    }
    let stored: BTreeMap<String, Numbers> = serde_json::from_str(STORED).unwrap();
    assert_eq!(stored.len(), CASES.len());
    for name in CASES {
        let (found, expected) = (numbers(name), &stored[name]);
        assert!((found.conformal_radius / expected.conformal_radius - 1.0).abs() <= 1e-12, "{name}: conformal radius");
        assert_eq!((found.angles.len(), found.images.len()), (expected.angles.len(), expected.images.len()), "{name}");
        let angles = largest(found.angles.iter().zip(&expected.angles).map(|(a, b)| angle_error(*a, *b)));
        assert!(angles <= 1e-12, "{name}: angles differ by {angles:e}");
        let pairs = points(&found.images).into_iter().zip(points(&expected.images));
        let images = largest(pairs.map(|(a, b): (Complex64, Complex64)| (a - b).norm()));
        assert!(images <= 1e-12, "{name}: images differ by {images:e}");
    }
}
