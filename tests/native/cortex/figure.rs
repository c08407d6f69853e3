//! Figure 7 in small, held by a picture: a scene as both hemispheres of V1 receive it, through Symm's map of an outline, and
//! what they recover of it.
//!
//! `REGENERATE=1 cargo test --test native cortex::figure` draws tests/fixtures/figure-7.png anew. Look at it then.

use crate::support::picture::fixture_photo;
use crate::support::{fixture, solve};
use conformal_warp::warp::recovery;
use conformal_warp::{
    Complex64, CorticalImage, CorticalModel, Curve, FieldPoint, FoveatedTexture, Frame, Gaze, Hemisphere, Light,
    Region, RetinoCorticalMap, Texture, VisualCortex, WarpOptions, Wrap,
};
use std::path::PathBuf;

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
    VisualCortex::from_outline(RetinoCorticalMap::new(solve(&region, 1e-7), landmark).unwrap(), hemisphere)
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

fn golden() -> PathBuf {
    fixture("figure-7.png")
}

fn save(pixels: &[u8]) {
    let file = std::fs::File::create(golden()).unwrap();
    let mut encoder = png::Encoder::new(file, WIDTH as u32, SCENE[1] as u32);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().unwrap().write_image_data(pixels).unwrap();
}

fn load() -> Vec<u8> {
    let file = std::io::BufReader::new(std::fs::File::open(golden()).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    pixels
}

#[test]
fn figure_7_is_the_picture_that_was_looked_at() {
    let found = draw();
    if std::env::var_os("REGENERATE").is_some() {
        save(&found);
    }
    let expected = load();
    assert_eq!(found.len(), expected.len());
    // What is seen: colours as far as alpha lets them through.
    let seen = |pixels: &[u8], k: usize| {
        let alpha = f64::from(pixels[k | 3]);
        if k % 4 == 3 { alpha } else { f64::from(pixels[k]) * alpha / 255.0 }
    };
    let differences: Vec<f64> = (0..found.len()).map(|k| (seen(&found, k) - seen(&expected, k)).abs()).collect();
    let mean = differences.iter().sum::<f64>() / differences.len() as f64;
    let far = differences.iter().filter(|&&difference| difference > 16.0).count();
    assert!(mean < 0.5 && far < found.len() / 500, "{mean:.2} levels on average, {far} bytes differ by more than 16");
}
