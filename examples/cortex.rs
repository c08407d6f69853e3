//! A photo as the left half of the brain receives it: `cargo run --release --example cortex -- photo.jpg out.png`.

mod picture;

use conformal_warp::{Complex64, CorticalModel, Frame, Gaze, Hemisphere, VisualCortex, Warp, WarpOptions, Wrap};
use std::env::args;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = args().skip(1).collect();
    let [photo, out] = given.as_slice() else { return Err("Give a JPEG and a PNG to write.".into()) };
    let (texture, frame) = picture::open(photo, 4.0, Wrap::Transparent)?;
    // The photo spans 60 degrees of the field, and its middle is looked at.
    let gaze = Gaze::new(&frame, 60.0, Complex64::ZERO)?;
    let cortex = VisualCortex::from_model(CorticalModel::POLIMENI_2006, Hemisphere::Left);
    println!("{:.0} mm² of cortex", cortex.area());
    let around = cortex.frame(8.0)?;
    let view = Frame::new(around.center(), around.width().max(around.height()), [512, 512])?;
    picture::save(out, &cortex.seeing(gaze).warp(&texture, &WarpOptions::new(frame, view))?, &view)
}
