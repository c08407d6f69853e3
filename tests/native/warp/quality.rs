//! The samplers against 24 × 24 supersampling: four pictures, four maps, in plain and in linear light.

use crate::support::golden;
use crate::support::picture::{self, Picture, fixture_photo, noise};
use conformal_warp::{Complex64, Frame, Jet, Light, PlaneMap, Quality, Texture, Warp, WarpOptions, Wrap};

const SIDE: usize = 512;

/// A map with its derivative.
struct Analytic(&'static str, fn(Complex64) -> (Complex64, Complex64));

const MAPS: [Analytic; 4] = [
    Analytic("4z^2", |z| (4.0 * z * z, 8.0 * z)),
    Analytic("1/(2z)", |z| (0.5 / z, -0.5 / (z * z))),
    Analytic("exp(3z)/4", |z| ((3.0 * z).exp() / 4.0, 0.75 * (3.0 * z).exp())),
    Analytic("(z-1)/(z+1)", |z| ((z - 1.0) / (z + 1.0), 2.0 / ((z + 1.0) * (z + 1.0)))),
];

impl PlaneMap for Analytic {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        for (&z, jet) in points.iter().zip(jets) {
            let (value, derivative) = self.1(z);
            *jet = Jet::analytic(value, derivative);
        }
    }
}

/// What the design promises in plain light, in dB: checker, zone plate, noise; a decibel less still passes.
const PROMISED: [(Quality, [[f64; 3]; 3]); 2] = [
    (Quality::Trilinear, [[25.0, 30.0, 33.0], [32.0, 26.0, 38.0], [31.0, 30.0, 37.0]]),
    (Quality::Best, [[26.0, 33.0, 37.0], [33.0, 34.0, 45.0], [31.0, 36.0, 42.0]]),
];

/// Checker, zone plate and noise in the three channels.
fn hard_picture() -> Picture {
    let noise = noise(1024);
    Picture::new(1024, |x, y| {
        let checker = if (x / 8 + y / 8) % 2 == 1 { 255 } else { 0 };
        let (dx, dy) = (x as f64 - 512.0, y as f64 - 512.0);
        let zone = 127.5 + 127.5 * ((dx * dx + dy * dy) * std::f64::consts::PI / 1400.0).cos();
        [checker, zone.round() as u8, noise[1024 * y + x]]
    })
}

/// Every fifth pixel, spread evenly: the same figures to a tenth of a decibel, in a fifth of the time.
fn is_compared(pixel: usize) -> bool {
    (pixel % SIDE + 2 * (pixel / SIDE)).is_multiple_of(5)
}

/// A texel's channels in plain light, then in linear light.
type Both = [f32; 6];

/// The exact pixels in plain and in linear light (0..=255, unrounded) of a picture that repeats.
fn truth(picture: &Picture, frame: &Frame, view: &Frame, map: &Analytic) -> Vec<Both> {
    let texels: Vec<Both> = picture.rgba.as_chunks::<4>().0.iter().map(|&[r, g, b, _]| both([r, g, b])).collect();
    let size = picture.size as f64;
    let texel = |x: f64, y: f64| &texels[picture.size * (y.rem_euclid(size) as usize) + x.rem_euclid(size) as usize];
    let mut pixels = Vec::with_capacity(SIDE * SIDE);
    for pixel in 0..SIDE * SIDE {
        let mut sum = [0.0; 6];
        if !is_compared(pixel) {
            pixels.push(sum);
            continue;
        }
        for sample in 0..24 * 24 {
            let x = (pixel % SIDE) as f64 + ((sample % 24) as f64 + 0.5) / 24.0;
            let y = (pixel / SIDE) as f64 + ((sample / 24) as f64 + 0.5) / 24.0;
            let (u, v) = frame.to_pixels(map.1(view.to_plane(x, y)).0);
            let (x0, y0) = ((u - 0.5).floor(), (v - 0.5).floor());
            let (fx, fy) = ((u - 0.5 - x0) as f32, (v - 0.5 - y0) as f32);
            let taps = [texel(x0, y0), texel(x0 + 1.0, y0), texel(x0, y0 + 1.0), texel(x0 + 1.0, y0 + 1.0)];
            let weights = [(1.0 - fx) * (1.0 - fy), fx * (1.0 - fy), (1.0 - fx) * fy, fx * fy];
            for (tap, weight) in taps.into_iter().zip(weights) {
                for (sum, value) in sum.iter_mut().zip(tap) {
                    *sum += weight * value;
                }
            }
        }
        let [r, g, b, lr, lg, lb] = sum.map(|s| s / 576.0);
        let [lr, lg, lb] = [lr, lg, lb].map(|s| picture::to_byte(f64::from(s), Light::Linear) as f32);
        pixels.push([r, g, b, lr, lg, lb]);
    }
    pixels
}

fn both(rgb: [u8; 3]) -> Both {
    let [r, g, b] = rgb.map(f32::from);
    let [lr, lg, lb] = rgb.map(|byte| picture::to_light(byte, Light::Linear) as f32);
    [r, g, b, lr, lg, lb]
}

/// PSNR of each channel in dB, poles left out.
fn ratios(pixels: &[u8], truth: &[Both], light: Light, select: &[bool]) -> [f64; 3] {
    let first = if light == Light::Plain { 0 } else { 3 };
    let mut sums = [0.0; 3];
    let selected = truth.iter().zip(pixels.as_chunks::<4>().0).zip(select).filter(|(_, select)| **select);
    let mut count = 0.0;
    for ((exact, pixel), _) in selected {
        for channel in 0..3 {
            sums[channel] += (f64::from(exact[first + channel]) - f64::from(pixel[channel])).powi(2);
        }
        count += 1.0;
    }
    sums.map(|sum| 10.0 * (255.0 * 255.0 * count / sum).log10())
}

/// Leaves the pictures to look at; pixels that are not compared are expected as found.
fn keep(name: &str, pixels: &[u8], truth: &[Both], light: Light) -> String {
    let first = if light == Light::Plain { 0 } else { 3 };
    let expected = |(k, (pixel, exact)): (usize, (&[u8; 4], &Both))| {
        let exact = [exact[first], exact[first + 1], exact[first + 2], 255.0];
        if is_compared(k) { exact.map(f64::from) } else { pixel.map(f64::from) }
    };
    let exact: Vec<_> = pixels.as_chunks::<4>().0.iter().zip(truth).enumerate().map(expected).collect();
    golden::keep_exact(name, SIDE, pixels, &exact)
}

/// Checks one picture through one map in both lights.
fn check(picture: &Picture, index: usize, names: [&str; 3]) {
    let map = &MAPS[index];
    let frame = |side| Frame::new(Complex64::new(0.0, 0.0), 2.0, [side, side]).unwrap();
    let (texture_frame, view) = (frame(picture.size), frame(SIDE));
    let exact = truth(picture, &texture_frame, &view, map);
    let shrink = view.pixel_size() / texture_frame.pixel_size();
    let select: Vec<bool> = (0..SIDE * SIDE)
        .map(|k| {
            let z = view.to_plane((k % SIDE) as f64 + 0.5, (k / SIDE) as f64 + 0.5);
            is_compared(k) && map.1(z).1.norm() * shrink < 0.5 * picture.size as f64
        })
        .collect();
    for light in [Light::Plain, Light::Linear] {
        let size = picture.size;
        let texture = Texture::new(&picture.rgba, size, size, Wrap::Repeat, light).unwrap();
        let mut last = [0.0; 3];
        for quality in [Quality::Bilinear, Quality::Trilinear, Quality::Best] {
            let options = WarpOptions { quality, ..WarpOptions::new(texture_frame, view) };
            let pixels = map.warp(&texture, &options).unwrap();
            let found = ratios(&pixels, &exact, light, &select);
            let promised = PROMISED.iter().find(|(q, _)| *q == quality).and_then(|(_, rows)| rows.get(index));
            for channel in 0..3 {
                let what = format!("{} {light:?} {quality:?} {}", map.0, names[channel]);
                let kept = || keep(&what, &pixels, &exact, light);
                assert!(found[channel] > last[channel], "{what}: no better than the quality before; {}", kept());
                if let (Some(row), Light::Plain, "checker") = (promised, light, names[0]) {
                    assert!(found[channel] > row[channel] - 1.0, "{what}: {:.2} dB; {}", found[channel], kept());
                }
            }
            last = found;
        }
    }
}

fn check_both_pictures(index: usize) {
    check(&hard_picture(), index, ["checker", "zone plate", "noise"]);
    check(&fixture_photo("astronaut.jpg"), index, ["photo r", "photo g", "photo b"]);
}

#[test]
fn square() {
    check_both_pictures(0);
}

#[test]
fn inverse() {
    check_both_pictures(1);
}

#[test]
fn exponential() {
    check_both_pictures(2);
}

#[test]
fn moebius() {
    check_both_pictures(3);
}
