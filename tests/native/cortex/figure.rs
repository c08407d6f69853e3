//! Figure 7 in small, held by a picture: a scene as both hemispheres of V1 receive it, through Symm's map of an outline, and
//! what they recover of it.
//!
//! `REGENERATE=1 cargo test --test native cortex::figure` draws tests/fixtures/figure-7.png anew. Look at it then.

use crate::support::picture::fixture_photo;
use crate::support::{golden, solve};
use conformal_warp::warp::recovery;
use conformal_warp::{
    Complex64, CorticalImage, CorticalModel, Curve, FieldPoint, FoveatedTexture, Frame, Gaze, Hemisphere, Light,
    Region, RetinoCorticalMap, Texture, VisualCortex, WarpOptions, Wrap,
};

/// Pixels of a hemisphere, and of the recovered scene.
const HEMISPHERE: [usize; 2] = [160, 96];
const SCENE: [usize; 2] = [96, 96];
const WIDTH: usize = 2 * HEMISPHERE[0] + SCENE[0];

/// The outline of a dipole with human V1's mean area, and the blind spot where corners of the field go to its corners.
fn human(hemisphere: Hemisphere) -> VisualCortex {
    let dipole = CorticalModel::POLIMENI_2006.with_area(2643.0).unwrap();
    let landmark = dipole.landmark(FieldPoint::BLIND_SPOT.coordinate());
    let outline = dipole.outline(120);
    let region = Region::new(&outline, Curve::Polygon, landmark.cortex, outline[0]).unwrap();
    let map = RetinoCorticalMap::new(solve(&region, 1e-7), landmark).unwrap();
    VisualCortex::from_outline(map, &region, hemisphere)
}

/// Puts a picture of `width` columns into the figure, from column `left`.
fn put(figure: &mut [u8], pixels: &[u8], width: usize, left: usize) {
    for (row, line) in pixels.chunks_exact(4 * width).enumerate() {
        figure[4 * (row * WIDTH + left)..][..line.len()].copy_from_slice(line);
    }
}

fn draw() -> Vec<u8> {
    let photo = fixture_photo("astronaut.jpg");
    let picture = Frame::new(Complex64::ZERO, 2.0, [photo.size, photo.size]).unwrap();
    let fixation = Complex64::new(-0.125, 0.6);
    let gaze = Gaze::new(&picture, 80.0, fixation).unwrap();
    let stack = FoveatedTexture::around(&photo.rgba, &picture, fixation, 128, Light::Linear).unwrap();
    let texture = Texture::new(&photo.rgba, photo.size, photo.size, Wrap::Transparent, Light::Linear).unwrap();
    let scene = WarpOptions::new(picture, Frame::new(Complex64::ZERO, 2.0, SCENE).unwrap());
    let (mut figure, mut recovered) = (vec![0; 4 * WIDTH * SCENE[1]], vec![0; 4 * SCENE[0] * SCENE[1]]);
    for (k, hemisphere) in [Hemisphere::Right, Hemisphere::Left].into_iter().enumerate() {
        let cortex = human(hemisphere);
        let image: CorticalImage = cortex.seeing(gaze);
        let view = Frame::new(Complex64::new([-43.0, 43.0][k], 0.0), 90.0, HEMISPHERE).unwrap();
        let half = stack.warp(&image, &WarpOptions::new(picture, view)).unwrap();
        put(&mut figure, &half, HEMISPHERE[0], k * (HEMISPHERE[0] + SCENE[0]));
        let half = recovery::recover(&image, &cortex.frame(1.5).unwrap(), &texture, &scene).unwrap();
        recovery::add(&mut recovered, &half).unwrap();
    }
    put(&mut figure, &recovered, SCENE[0], HEMISPHERE[0]);
    figure
}

#[test]
fn figure_7_is_the_picture_that_was_looked_at() {
    golden::check("figure-7", WIDTH, &draw());
}
