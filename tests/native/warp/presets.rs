//! Every preset, pulled back and pushed forward: no hole, no fringe, no seam.
//!
//! The truth is dense supersampling. What a point of a push-forward shows is found by closed forms: candidates for f⁻¹(w),
//! of which those count that the formula itself takes back to w.

use crate::support::picture::{Picture, Truth};
use crate::support::{c, golden};
use conformal_warp::presets::{PRESETS, Preset};
use conformal_warp::{Complex64, FormulaMap, Frame};
use conformal_warp::{Direction, Light, Quality, Texture, Warp, WarpOptions, Wrap};
use std::f64::consts::{PI, TAU};

const SIDE: usize = 160;
/// Samples along each side of a pixel.
const SAMPLES: usize = 6;

/// Candidates for the points that the preset's formula takes to w: all of them, and perhaps others.
fn candidates(preset: &Preset, w: Complex64) -> Vec<Complex64> {
    let both = |root: Complex64| vec![root, -root];
    let turns = |z: Complex64, period: Complex64| (-3..=3).map(|k| z + period * f64::from(k)).collect::<Vec<_>>();
    match preset.formula {
        "cos(z)" => [w.acos(), -w.acos()].into_iter().flat_map(|z| turns(z, c(TAU, 0.0))).collect(),
        "exp(z)" => turns(w.ln(), c(0.0, TAU)),
        "(1 + z)/(1 - z)" => vec![(w - 1.0) / (w + 1.0)],
        "((1+z)^2 - i(1-z)^2) / ((1+z)^2 + i(1-z)^2)" => {
            // With s = (1 + z)/(1 − z): w = (s² − i)/(s² + i).
            let s = (c(0.0, 1.0) * (1.0 + w) / (1.0 - w)).sqrt();
            both(s).into_iter().map(|s| (s - 1.0) / (s + 1.0)).collect()
        }
        "log(z)" => vec![w.exp()],
        "z^2" => both(w.sqrt()),
        "z^a" => (-2..=2).map(|k| ((w.ln() + c(0.0, TAU * f64::from(k))) / 1.5).exp()).collect(),
        "sqrt(z)" => vec![w * w],
        "1/z" => vec![1.0 / w],
        "tan(z)" => turns(w.atan(), c(PI, 0.0)),
        "z + 1/z" => both((w * w - 4.0).sqrt()).into_iter().map(|root| 0.5 * (w + root)).collect(),
        "i(1 + z)/(1 - z)" => vec![(w - c(0.0, 1.0)) / (w + c(0.0, 1.0))],
        "(n - m i) log(z) / pi" => vec![(PI * w / c(3.0, -1.0)).exp()],
        "iterate(w, z, 3, w^2 + t)" => {
            let roots = |w: Complex64| both((w - c(-0.4, 0.6)).sqrt());
            roots(w).into_iter().flat_map(roots).flat_map(roots).collect()
        }
        other => panic!("no inverse of {other} is known here"),
    }
}

/// The point of the texture's frame that a push-forward shows at w: of those there are, the lowest.
fn preimage(preset: &Preset, map: &FormulaMap, frame: &Frame, w: Complex64) -> Option<Complex64> {
    let found = candidates(preset, w);
    let back = map.eval(&found);
    let [columns, rows] = frame.pixels().map(|n| n as f64);
    let shown = found.into_iter().zip(back).filter(|&(z, image)| {
        let (u, v) = frame.to_pixels(z);
        let inside = (0.0..=columns).contains(&u) && (0.0..=rows).contains(&v);
        inside && (image - w).norm() <= 1e-9 * (1.0 + w.norm())
    });
    shown.map(|(z, _)| z).min_by(|a, b| a.im.total_cmp(&b.im))
}

/// Ramps: every filter keeps them, so that all that shows is where a texel came from.
fn ramps() -> Picture {
    let ramp = |t: usize| (255 * t / (SIDE - 1)) as u8;
    Picture::new(SIDE, |x, y| [ramp(x), ramp(y), ramp((x + y) / 2)])
}

/// The texture's frame, with as many pixels, and the view of a preset.
fn frames(preset: &Preset) -> [Frame; 2] {
    // Off the preset's own center by a part of a pixel: nothing lies on the lattice of blocks by chance.
    let view = Frame::new(preset.view.center + c(0.0031, 0.0017), preset.view.width, [SIDE, SIDE]).unwrap();
    [preset.texture.frame([SIDE, SIDE]).unwrap(), view]
}

fn options(preset: &Preset, direction: Direction, quality: Quality) -> WarpOptions {
    let [texture, view] = frames(preset);
    WarpOptions { direction, quality, ..WarpOptions::new(texture, view) }
}

/// What `shows` makes of each pixel, and whether it is smooth there: wholly shown or wholly empty, with its neighbours.
fn truth(picture: &Picture, wrap: Wrap, preset: &Preset, shows: impl Fn(Complex64) -> Complex64) -> Vec<[f64; 4]> {
    let [texture, view] = frames(preset);
    Truth { picture, wrap, light: Light::Plain, samples: SAMPLES }.render(&texture, &view, shows)
}

/// Pixels within `radius` of this one.
fn around(pixel: usize, radius: usize) -> impl Iterator<Item = usize> {
    let range = move |t: usize| t.saturating_sub(radius)..(t + radius + 1).min(SIDE);
    range(pixel / SIDE).flat_map(move |y| range(pixel % SIDE).map(move |x| SIDE * y + x))
}

/// Away from edges, the alpha of the picture is the truth's.
fn assert_alpha(what: &str, pixels: &[u8], exact: &[[f64; 4]], radius: usize) {
    let (mut full, mut empty) = (0, 0);
    for k in 0..SIDE * SIDE {
        for (alpha, count) in [(0.0, &mut empty), (255.0, &mut full)] {
            if around(k, radius).all(|k| (exact[k][3] - alpha).abs() < 1e-6) {
                *count += 1;
                let found = pixels[4 * k + 3];
                let place = (k % SIDE, k / SIDE);
                assert!(
                    (f64::from(found) - alpha).abs() <= 1.0,
                    "{what}: alpha {found} at {place:?}, not {alpha}; {}",
                    golden::keep_exact(what, SIDE, pixels, exact)
                );
            }
        }
    }
    assert!(full > SIDE, "{what}: only {full} pixels are full, {empty} empty");
}

const QUALITIES: [Quality; 4] = [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best];

#[test]
fn figures_pulled_back_have_the_alpha_of_the_truth() {
    // A disk on nothing, so that there are edges inside the picture too.
    let mut disk = Picture::new(SIDE, |_, _| [200, 100, 50]);
    for (k, pixel) in disk.rgba.as_chunks_mut::<4>().0.iter_mut().enumerate() {
        let (x, y) = (k % SIDE, k / SIDE);
        let half = SIDE as f64 / 2.0;
        if (x as f64 + 0.5 - half).hypot(y as f64 + 0.5 - half) > 0.42 * SIDE as f64 {
            *pixel = [0; 4];
        }
    }
    for preset in &PRESETS {
        let map = preset.map().unwrap();
        let exact = truth(&disk, preset.wrap, preset, |z| map.eval(&[z])[0]);
        let texture = Texture::new(&disk.rgba, SIDE, SIDE, preset.wrap, Light::Plain).unwrap();
        for quality in QUALITIES {
            let pixels = map.warp(&texture, &options(preset, Direction::PullBack, quality)).unwrap();
            // A level of the pyramid spreads an edge over two of its texels, each up to two pixels wide.
            let radius = if matches!(quality, Quality::Nearest | Quality::Bilinear) { 1 } else { 4 };
            assert_alpha(&format!("{}, {quality:?}", preset.name), &pixels, &exact, radius);
        }
    }
}

#[test]
fn presets_pushed_forward_have_the_alpha_of_the_truth_and_no_seam() {
    let picture = ramps();
    let texture = Texture::new(&picture.rgba, SIDE, SIDE, Wrap::Clamp, Light::Plain).unwrap();
    let nowhere = c(f64::NAN, f64::NAN);
    for preset in &PRESETS {
        let map = preset.map().unwrap();
        let [frame, _] = frames(preset);
        let exact = truth(&picture, Wrap::Clamp, preset, |w| preimage(preset, &map, &frame, w).unwrap_or(nowhere));
        let smooth = smooth_pixels(preset, &map);
        for quality in QUALITIES {
            let what = format!("{} pushed forward, {quality:?}", preset.name);
            let pixels = map.warp(&texture, &options(preset, Direction::PushForward, quality)).unwrap();
            assert_alpha(&what, &pixels, &exact, 1);
            assert_smooth(&what, &pixels, &exact, &smooth);
        }
    }
}

/// The pixels around which a push-forward shows one sheet of the map, and nothing else.
fn smooth_pixels(preset: &Preset, map: &FormulaMap) -> Vec<bool> {
    let [frame, view] = frames(preset);
    let center = |k: usize| view.to_plane((k % SIDE) as f64 + 0.5, (k / SIDE) as f64 + 0.5);
    let shown: Vec<_> = (0..SIDE * SIDE).map(|k| preimage(preset, map, &frame, center(k))).collect();
    let is_smooth = |k: usize| {
        let Some(z) = shown[k] else { return false };
        let derivative = map.derivative(&[z])[0];
        around(k, 1).all(|n| {
            let step = (center(n) - center(k)) / derivative;
            shown[n].is_some_and(|other| (other - z - step).norm() <= 0.3 * step.norm())
        })
    };
    (0..SIDE * SIDE).map(is_smooth).collect()
}

/// Where the truth is smooth, the picture follows it to a fraction of a pixel: a seam at a mesh's edge would stand out.
fn assert_smooth(what: &str, pixels: &[u8], exact: &[[f64; 4]], smooth: &[bool]) {
    let mut count = 0;
    for k in (0..SIDE * SIDE).filter(|&k| smooth[k]) {
        for channel in 0..3 {
            let values = || around(k, 1).map(|k| exact[k][channel]);
            let (low, high) = values().fold((f64::MAX, f64::MIN), |(low, high), t| (low.min(t), high.max(t)));
            if high - low < 24.0 {
                count += 1;
                let (found, place) = (pixels[4 * k + channel], (k % SIDE, k / SIDE));
                let error = (f64::from(found) - exact[k][channel]).abs();
                let limit = 2.0 + 0.1 * (high - low);
                assert!(
                    error < limit,
                    "{what}: {found} at {place:?}, not {:.1} ± {limit:.1}; {}",
                    exact[k][channel],
                    golden::keep_exact(what, SIDE, pixels, exact)
                );
            }
        }
    }
    assert!(count > SIDE, "{what}: only {count} smooth values");
}
