//! Pictures from and to files, for the examples.

use conformal_warp::{Complex64, Frame, Light, Texture, Wrap};
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

/// A JPEG as a texture, and a frame of the given width around 0 that has its shape.
#[allow(dead_code, reason = "an example needs this or `read`")]
pub fn open(path: &str, width: f64, wrap: Wrap) -> Result<(Texture, Frame), Box<dyn Error>> {
    let (rgba, frame) = read(path, width)?;
    let [columns, rows] = frame.pixels();
    Ok((Texture::new(&rgba, columns, rows, wrap, Light::Linear)?, frame))
}

/// A JPEG as RGBA pixels, and such a frame.
pub fn read(path: &str, width: f64) -> Result<(Vec<u8>, Frame), Box<dyn Error>> {
    let mut decoder = jpeg_decoder::Decoder::new(File::open(path)?);
    let rgb = decoder.decode()?;
    let info = decoder.info().ok_or("The picture has no size.")?;
    let rgba: Vec<u8> = rgb.as_chunks().0.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
    let frame = Frame::new(Complex64::ZERO, width, [info.width.into(), info.height.into()])?;
    Ok((rgba, frame))
}

/// RGBA pixels as a PNG.
pub fn save(path: &str, rgba: &[u8], frame: &Frame) -> Result<(), Box<dyn Error>> {
    let [width, height] = frame.pixels().map(|n| n as u32);
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(rgba)?;
    println!("{path}: {width} x {height} pixels");
    Ok(())
}
