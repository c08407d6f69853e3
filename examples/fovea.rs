//! The complex logarithm of a photo around a point, from a stack of small pictures that hold all it shows:
//! `cargo run --release --example fovea -- photo.jpg out.png`.

mod picture;

use conformal_warp::{Complex64, FormulaMap, FoveatedTexture, Frame, Light, WarpOptions};
use std::env::args;
use std::error::Error;
use std::f64::consts::TAU;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = args().skip(1).collect();
    let [photo, out] = given.as_slice() else { return Err("Give a JPEG and a PNG to write.".into()) };
    let (rgba, frame) = picture::read(photo, 4.0)?;
    let fixation = Complex64::new(0.2, 0.4);
    let stack = FoveatedTexture::around(&rgba, &frame, fixation, 128, Light::Linear)?;
    println!("{} levels in {} bytes, of {} in the photo", stack.levels().len(), stack.bytes(), rgba.len());
    // Directions run down the picture, distances from the point grow by e^2π across it.
    let map = FormulaMap::with_params("c + exp(z)", &[("c", fixation)])?;
    let view = Frame::new(Complex64::new(-2.0, 0.0), TAU, [512, 512])?;
    picture::save(out, &stack.warp(&map, &WarpOptions::new(frame, view))?, &view)
}
