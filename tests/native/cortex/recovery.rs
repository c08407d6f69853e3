//! The scene as it can be recovered from the cortex: sharp where it was looked at, and blurred elsewhere as the cortical
//! magnification says.

use crate::support::golden;
use conformal_warp::warp::recovery;
use conformal_warp::{
    Complex64, CorticalModel, Frame, Gaze, Hemisphere, Light, Texture, VisualCortex, WarpOptions, Wrap,
};

const MODEL: CorticalModel = CorticalModel::POLIMENI_2006;

/// What both hemispheres recover of a picture that is fixated in its middle.
fn recovered(rgba: &[u8], frame: &Frame, field_of_view: f64, dots: f64) -> Vec<u8> {
    let [width, height] = frame.pixels();
    let texture = Texture::new(rgba, width, height, Wrap::Clamp, Light::Plain).expect("the sizes fit");
    let gaze = Gaze::new(frame, field_of_view, frame.center()).expect("a field of view");
    let mut sum = vec![0; rgba.len()];
    for hemisphere in [Hemisphere::Left, Hemisphere::Right] {
        let cortex = VisualCortex::from_model(MODEL, hemisphere);
        let dots = cortex.frame(dots).expect("a resolution");
        let half = recovery::recover(&cortex.seeing(gaze), &dots, &texture, &WarpOptions::new(*frame, *frame));
        recovery::add(&mut sum, &half.expect("a picture")).expect("as many pixels");
    }
    sum
}

/// Eccentricity of a pixel, in degrees.
fn eccentricity(frame: &Frame, field_of_view: f64, pixel: usize) -> f64 {
    let [width, _] = frame.pixels();
    let point = frame.to_plane((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5);
    Gaze::new(frame, field_of_view, frame.center()).expect("a field of view").direction(point).eccentricity
}

#[test]
fn the_fovea_comes_back_sharper_than_the_periphery() {
    let frame = Frame::new(Complex64::ZERO, 2.0, [320, 240]).expect("a frame");
    // Patches of 8 pixels, each of its own shade.
    let shade = |x: usize, y: usize| (((x / 8) * 73 + (y / 8) * 151 + (x / 8) * (y / 8) * 29) % 256) as u8;
    let rgba: Vec<u8> = (0..320 * 240).flat_map(|k| [shade(k % 320, k / 320); 3].into_iter().chain([255])).collect();
    let found = recovered(&rgba, &frame, 40.0, 3.0);
    assert!(found.as_chunks::<4>().0.iter().all(|pixel| pixel[3] == 255), "the halves meet without a gap");
    let psnr = |from: f64, to: f64| {
        let within = (0..320 * 240).filter(|&k| (from..to).contains(&eccentricity(&frame, 40.0, k)));
        let squares: Vec<f64> = within.map(|k| f64::from(rgba[4 * k].abs_diff(found[4 * k])).powi(2)).collect();
        10.0 * (255.0 * 255.0 * squares.len() as f64 / squares.iter().sum::<f64>()).log10()
    };
    let [fovea, near, far] = [psnr(0.0, 2.0), psnr(2.0, 8.0), psnr(8.0, 20.0)];
    assert!(
        fovea > near + 3.0 && near > far + 3.0 && fovea > 25.0,
        "{fovea} {near} {far}; {}",
        golden::keep("recovered", 320, &found, &rgba)
    );
}

/// Width of the rise from 10 to 90 % along the right horizontal meridian around an eccentricity, in degrees.
fn blur(line: &[(f64, f64)], at: f64) -> f64 {
    let crossing = |level: f64| {
        // Downwards from well beyond the edge, so that the last crossing counts.
        let pairs = line.windows(2).filter(|pair| (0.72 * at..1.38 * at).contains(&pair[0].0));
        let cross = |pair: &&[(f64, f64)]| (pair[0].1 - level) * (pair[1].1 - level) <= 0.0 && pair[0].1 != pair[1].1;
        let pair = pairs.into_iter().find(cross).expect("the edge is crossed");
        pair[0].0 + (pair[1].0 - pair[0].0) * (level - pair[0].1) / (pair[1].1 - pair[0].1)
    };
    (crossing(0.9 * 255.0) - crossing(0.1 * 255.0)).abs()
}

#[test]
fn edges_blur_in_proportion_to_the_inverse_of_the_magnification() {
    const EDGES: [f64; 5] = [2.0, 4.0, 8.0, 16.0, 32.0];
    let (field_of_view, dots) = (84.0, 2.0);
    let frame = Frame::new(Complex64::ZERO, 2.0, [4096, 64]).expect("a frame");
    let bands = |e: f64| if EDGES.iter().filter(|&&edge| e > edge).count() % 2 == 0 { 0 } else { 255 };
    let shades: Vec<u8> = (0..4096 * 64).map(|k| bands(eccentricity(&frame, field_of_view, k))).collect();
    let rgba: Vec<u8> = shades.iter().flat_map(|&s| [s, s, s, 255]).collect();
    let found = recovered(&rgba, &frame, field_of_view, dots);
    let meridian = (2048..4096).map(|x| 32 * 4096 + x);
    let line: Vec<(f64, f64)> =
        meridian.map(|k| (eccentricity(&frame, field_of_view, k), f64::from(found[4 * k]))).collect();
    let in_dots = EDGES.map(|edge| blur(&line, edge) * MODEL.magnification(edge) * dots);
    // Two interpolations, each about a dot wide.
    assert!(in_dots.iter().all(|width| (1.2..2.2).contains(width)), "{in_dots:?}");
    // In degrees the blur grows twelvefold.
    assert!(blur(&line, 32.0) > 8.0 * blur(&line, 2.0));
}

#[test]
fn resolutions_that_no_picture_has_are_refused() {
    let cortex = VisualCortex::from_model(MODEL, Hemisphere::Right);
    for dots in [0.0, -1.0, f64::NAN, 1e4] {
        assert_eq!(cortex.frame(dots).expect_err("no such frame").code(), "invalid-option");
    }
    let frame = cortex.frame(3.0).expect("a frame");
    assert!((frame.pixel_size() - 1.0 / 3.0).abs() < 1e-12 && frame.center().re < 0.0);
    assert_eq!(recovery::add(&mut [0; 4], &[0; 8]).expect_err("too many").code(), "wrong-length");
}
