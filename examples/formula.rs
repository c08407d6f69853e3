//! A photo through a formula: `cargo run --release --example formula -- photo.jpg out.png "(z - 1)/(z + 1)"`.

mod picture;

use conformal_warp::{Complex64, FormulaMap, Frame, Quality, Warp, WarpOptions, Wrap};
use std::env::args;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = args().skip(1).collect();
    let [photo, out, formula] = given.as_slice() else {
        return Err("Give a JPEG, a PNG to write and a formula.".into());
    };
    let (texture, frame) = picture::open(photo, 4.0, Wrap::Mirror)?;
    let view = Frame::new(Complex64::ZERO, 4.0, [512, 512])?;
    let options = WarpOptions { quality: Quality::Best, ..WarpOptions::new(frame, view) };
    picture::save(out, &FormulaMap::new(formula)?.warp(&texture, &options)?, &view)
}
