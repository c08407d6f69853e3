//! Pictures from and to files, for the examples.

use conformal_warp::{Complex64, Frame, Light, Texture, Wrap};
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

/// A JPEG as a texture, and a frame of the given width around 0 that has its shape.
pub fn open(path: &str, width: f64, wrap: Wrap) -> Result<(Texture, Frame), Box<dyn Error>> {
    let mut decoder = jpeg_decoder::Decoder::new(File::open(path)?);
    let rgb = decoder.decode()?;
    let info = decoder.info().ok_or("The picture has no size.")?;
    let rgba: Vec<u8> = rgb.as_chunks().0.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
    let size = [info.width.into(), info.height.into()];
    let texture = Texture::new(&rgba, size[0], size[1], wrap, Light::Linear)?;
    Ok((texture, Frame::new(Complex64::ZERO, width, size)?))
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
