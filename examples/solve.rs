//! Solves the regions of JSON files to 1e-10 and prints what their maps say, as JSON: `cargo run --example solve -- FILE …`
//!
//! A file has `vertices`, `center` and `toward`, points as `[x, y]`, as those of `tests/fixtures` do.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let maps = std::env::args().skip(1).map(|file| native::solve(&file)).collect::<Result<Vec<_>, _>>()?;
    println!("{}", serde_json::to_string(&maps)?);
    Ok(())
}

/// There are no files in wasm.
#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
mod native {
    use conformal_warp::{Complex64, Curve, Region, RiemannMap, SolveOptions};
    use serde::{Deserialize, Serialize};
    use std::error::Error;

    #[derive(Deserialize)]
    struct Given {
        vertices: Vec<[f64; 2]>,
        center: [f64; 2],
        toward: [f64; 2],
    }

    /// What a map says; `images` are those of the midpoints between the center and the vertices, null outside.
    #[derive(Serialize)]
    #[serde(rename_all = "camelCase")]
    pub struct Answer {
        conformal_radius: f64,
        error_estimate: f64,
        unknowns: usize,
        angles: Vec<f64>,
        images: Vec<f64>,
    }

    pub fn solve(file: &str) -> Result<Answer, Box<dyn Error>> {
        let given: Given = serde_json::from_str(&std::fs::read_to_string(file)?)?;
        let boundary: Vec<_> = given.vertices.into_iter().map(point).collect();
        let region = Region::new(&boundary, Curve::Polygon, point(given.center), point(given.toward))?;
        let options = SolveOptions { tolerance: 1e-10, ..SolveOptions::default() };
        let map = RiemannMap::solve(&region, &options, &mut |_, _| true)?;
        let midpoints: Vec<_> = region.boundary().iter().map(|v| 0.5 * (v + region.center())).collect();
        Ok(Answer {
            conformal_radius: map.conformal_radius(),
            error_estimate: map.error_estimate(),
            unknowns: map.unknowns(),
            angles: map.angles().to_vec(),
            images: map.to_disk(&midpoints).iter().flat_map(|w| [w.re, w.im]).collect(),
        })
    }

    fn point([x, y]: [f64; 2]) -> Complex64 {
        Complex64::new(x, y)
    }
}
