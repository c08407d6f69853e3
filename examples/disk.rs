//! A region of a photo on the unit disk: `cargo run --release --example disk -- photo.jpg out.png`.

mod picture;

use conformal_warp::{Complex64, Curve, Direction, Frame, Region, RiemannMap, SolveOptions, Warp, WarpOptions, Wrap};
use std::env::args;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = args().skip(1).collect();
    let [photo, out] = given.as_slice() else { return Err("Give a JPEG and a PNG to write.".into()) };
    let (texture, frame) = picture::open(photo, 4.0, Wrap::Transparent)?;
    // An L on the photo, whose middle goes to the disk's, and whose corner to 1.
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)];
    let boundary = corners.map(|(x, y)| Complex64::new(x, y));
    let region = Region::new(&boundary, Curve::Polygon, Complex64::new(-0.4, -0.4), boundary[1])?;
    let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
    println!("{} unknowns, error below {:.0e}", map.unknowns(), map.error_estimate());
    let view = Frame::new(Complex64::ZERO, 2.0, [512, 512])?;
    let options = WarpOptions { direction: Direction::PushForward, ..WarpOptions::new(frame, view) };
    picture::save(out, &map.warp(&texture, &options)?, &view)
}
