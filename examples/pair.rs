//! A region of a photo in the place of another one: `cargo run --release --example pair -- photo.jpg out.png`.

mod picture;

use conformal_warp::{
    Complex64, Curve, Direction, Frame, Region, RegionMap, RiemannMap, SolveOptions, Warp, WarpOptions, Wrap,
};
use std::env::args;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let given: Vec<String> = args().skip(1).collect();
    let [photo, out] = given.as_slice() else { return Err("Give a JPEG and a PNG to write.".into()) };
    let (texture, frame) = picture::open(photo, 4.0, Wrap::Transparent)?;
    // Centers go to centers, and what points up still does.
    let house = solved(&[(-1.0, -1.2), (1.0, -1.2), (1.0, 0.5), (0.0, 1.5), (-1.0, 0.5)], 3)?;
    let arrow = solved(&[(-0.5, -1.5), (0.5, -1.5), (0.5, 0.0), (1.2, 0.0), (0.0, 1.5), (-1.2, 0.0), (-0.5, 0.0)], 4)?;
    let map = RegionMap::between(&house, &arrow);
    let view = Frame::new(Complex64::ZERO, 3.2, [512, 512])?;
    let options = WarpOptions { direction: Direction::PushForward, ..WarpOptions::new(frame, view) };
    picture::save(out, &map.warp(&texture, &options)?, &view)
}

/// The map of a polygon around 0, whose corner `toward` goes to 1.
fn solved(corners: &[(f64, f64)], toward: usize) -> Result<RiemannMap, conformal_warp::Error> {
    let boundary: Vec<Complex64> = corners.iter().map(|&(x, y)| Complex64::new(x, y)).collect();
    let region = Region::new(&boundary, Curve::Polygon, Complex64::new(0.0, -0.2), boundary[toward])?;
    RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)
}
