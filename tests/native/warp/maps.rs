//! Maps pulled back and pushed forward: cuts, poles, sheets, edges of the domain, bands.

use crate::support::golden;
use crate::support::picture::{Picture, Truth, psnr};
use conformal_warp::{
    Complex64, Compose, CorticalModel, Curve, Degrees, Direction, FormulaMap, FoveatedTexture, Frame, Gaze,
    HalfDiskMap, Hemisphere, Inverse, InvertibleMap, Jet, Landmark, Light, Mirrored, Moebius, PlaneMap, Quality,
    Region, RegionMap, RetinoCorticalMap, RiemannMap, SolveOptions, Texture, VisualCortex, Warp, WarpOptions, Wrap,
};
use std::f64::consts::PI;

const SIDE: usize = 256;

/// A map given by its jets.
struct Map<F>(F);

impl<F: Fn(Complex64) -> Jet> PlaneMap for Map<F> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        points.iter().zip(jets).for_each(|(&z, jet)| *jet = self.0(z));
    }
}

fn analytic(f: impl Fn(Complex64) -> (Complex64, Complex64)) -> impl PlaneMap {
    Map(move |z| {
        let (value, derivative) = f(z);
        Jet::analytic(value, derivative)
    })
}

fn frame(x: f64, y: f64, width: f64, side: usize) -> Frame {
    Frame::new(Complex64::new(x, y), width, [side, side]).unwrap()
}

/// A smooth picture, different everywhere: its PSNR measures where a texel came from.
fn gradient() -> Picture {
    let wave = |t: f64| (127.5 + 127.5 * (t * 0.011).sin()) as u8;
    Picture::new(SIDE, |x, y| [x as u8, y as u8, wave((x * y) as f64 / 10.0)])
}

fn texture(picture: &Picture, wrap: Wrap) -> Texture {
    Texture::new(&picture.rgba, picture.size, picture.size, wrap, Light::Plain).unwrap()
}

fn options(texture: Frame, view: Frame, direction: Direction, quality: Quality) -> WarpOptions {
    WarpOptions { direction, quality, ..WarpOptions::new(texture, view) }
}

/// Alpha of the two pictures differs only next to pixels where the truth is partly transparent.
fn assert_same_alpha(pixels: &[u8], truth: &[[f64; 4]], side: usize, what: &str) {
    let solid = |x: usize, y: usize, full: f64| {
        let near = |t: usize| t.saturating_sub(1)..(t + 2).min(side);
        near(y).all(|y| near(x).all(|x| (truth[side * y + x][3] - full).abs() < 0.01))
    };
    for y in 0..side {
        for x in 0..side {
            for full in [0.0, 255.0] {
                let alpha = pixels[4 * (side * y + x) + 3];
                if solid(x, y, full) {
                    assert!(
                        (f64::from(alpha) - full).abs() <= 1.0,
                        "{what}: alpha {alpha} at ({x}, {y}), not {full}; {}",
                        golden::keep_exact(what, side, pixels, truth)
                    );
                }
            }
        }
    }
}

#[test]
fn a_branch_cut_is_sharp() {
    // log has its cut on the negative axis, which the view's middle row of pixel edges follows.
    let picture = gradient();
    let (shown, view) = (frame(0.0, 0.0, 7.0, SIDE), frame(-0.6, 0.0, 2.0, 200));
    let map = analytic(|z| (z.ln(), 1.0 / z));
    let truth = Truth { picture: &picture, wrap: Wrap::Clamp, light: Light::Plain, samples: 8 };
    let exact = truth.render(&shown, &view, |z| z.ln());
    let pixels =
        map.warp(&texture(&picture, Wrap::Clamp), &options(shown, view, Direction::PullBack, Quality::Bilinear));
    let pixels = pixels.unwrap();
    for channel in 0..3 {
        let near_cut = psnr(&pixels, &exact, channel, |k| (98..102).contains(&(k / 200)) && k % 200 < 150);
        let all = psnr(&pixels, &exact, channel, |_| true);
        assert!(
            near_cut > 45.0 && all > 45.0,
            "channel {channel}: {near_cut} dB at the cut, {all} dB in all; {}",
            golden::keep_exact("branch cut", 200, &pixels, &exact)
        );
    }
}

#[test]
fn a_moving_branch_cut_is_sharp_too() {
    // The cut of sqrt(z² + ½) runs along the imaginary axis, ends inside the view, and crosses blocks off their lattice.
    let picture = gradient();
    let (shown, view) = (frame(0.0, 0.0, 3.0, SIDE), frame(0.013, 0.027, 2.0, 200));
    let root = |z: Complex64| (z * z + 0.5).sqrt();
    let map = analytic(move |z| (root(z), z / root(z)));
    let pixels = map
        .warp(&texture(&picture, Wrap::Clamp), &options(shown, view, Direction::PullBack, Quality::Nearest))
        .unwrap();
    let off: usize = (0..200 * 200)
        .filter(|k| {
            let (u, v) = shown.to_pixels(root(view.to_plane((k % 200) as f64 + 0.5, (k / 200) as f64 + 0.5)));
            let [x, y] = [u, v].map(|t| t.floor().clamp(0.0, 255.0) as usize);
            // Within 1/32 texel of a texel's side either neighbour is right.
            let clear = [u, v].iter().all(|t| (t - t.round()).abs() > 1.0 / 32.0);
            clear && pixels[4 * k..4 * k + 2] != picture.rgba[4 * (SIDE * y + x)..][..2]
        })
        .count();
    assert_eq!(off, 0, "pixels that show another texel than the map's");
}

#[test]
fn poles_leave_no_hole_and_end_in_the_mean() {
    let picture = Picture::checker(SIDE, 8);
    let (shown, view) = (frame(0.0, 0.0, 2.0, SIDE), frame(0.0, 0.0, 0.5, 101));
    let map = analytic(|z| (1.0 / (z * z), -2.0 / (z * z * z)));
    for quality in [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best] {
        let setting = options(shown, view, Direction::PullBack, quality);
        for wrap in [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp] {
            let pixels = map.warp(&texture(&picture, wrap), &setting).unwrap();
            let holes = pixels.iter().skip(3).step_by(4).filter(|&&alpha| alpha != 255).count();
            assert_eq!(holes, 0, "{quality:?}, {wrap:?}");
        }
        if matches!(quality, Quality::Trilinear | Quality::Best) {
            let pixels = map.warp(&texture(&picture, Wrap::Repeat), &setting).unwrap();
            let next = 4 * (101 * 50 + 51);
            assert!(pixels[next].abs_diff(128) <= 2, "beside the pole: {}", pixels[next]);
        }
    }
}

#[test]
fn the_edge_of_the_domain_is_covered_by_area() {
    let map =
        Map(|z: Complex64| if z.norm() <= 0.8 { Jet::analytic(z, Complex64::new(1.0, 0.0)) } else { Jet::UNDEFINED });
    let white = texture(&Picture::new(4, |_, _| [255; 3]), Wrap::Repeat);
    for quality in [Quality::Nearest, Quality::Trilinear, Quality::Best] {
        let setting = options(frame(0.0, 0.0, 2.0, 4), frame(0.01, 0.02, 2.0, 200), Direction::PullBack, quality);
        let pixels = map.warp(&white, &setting).unwrap();
        let area: f64 = pixels.iter().skip(3).step_by(4).map(|&alpha| f64::from(alpha) / 255.0).sum();
        assert!((area - PI * 80.0 * 80.0).abs() < 20.0, "{quality:?}: {area}");
        let partial = pixels.iter().skip(3).step_by(4).filter(|&&alpha| alpha > 0 && alpha < 255).count();
        assert!(partial > 300, "{quality:?}: only {partial} pixels are partly covered");
    }
}

#[test]
fn footprints_of_non_analytic_maps_come_from_the_whole_jacobian() {
    // x + iy → 6x + iy/6: six texels wide. A sampler that used ∂f/∂z alone would alias the stripes.
    let stripes = Picture::new(SIDE, |x, _| [if x % 4 < 2 { 0 } else { 255 }; 3]);
    let squash = Map(|z: Complex64| Jet {
        value: Complex64::new(6.0 * z.re, z.im / 6.0),
        dz: Complex64::new(3.0 + 1.0 / 12.0, 0.0),
        dzbar: Complex64::new(3.0 - 1.0 / 12.0, 0.0),
    });
    for (quality, most) in [(Quality::Trilinear, 1), (Quality::Best, 12)] {
        let setting = options(frame(0.0, 0.0, 2.0, SIDE), frame(0.003, 0.0, 2.0, SIDE), Direction::PullBack, quality);
        let pixels = squash.warp(&texture(&stripes, Wrap::Repeat), &setting).unwrap();
        let worst = pixels.iter().step_by(4).map(|r| r.abs_diff(128)).max();
        assert!(worst <= Some(most), "{quality:?}: {worst:?} levels from gray");
    }
}

#[test]
fn bands_make_the_same_pixels_as_the_whole() {
    let picture = gradient();
    let texture = texture(&picture, Wrap::Mirror);
    let map = analytic(|z| (1.0 / (z * z), -2.0 / (z * z * z)));
    for direction in [Direction::PullBack, Direction::PushForward] {
        let whole = options(frame(0.3, 0.1, 2.0, SIDE), frame(0.0, 0.0, 3.0, 150), direction, Quality::Best);
        let pixels = map.warp(&texture, &whole).unwrap();
        assert!(pixels.iter().any(|&byte| byte > 0));
        for rows in [0..33, 33..34, 47..150] {
            let band = WarpOptions { rows: Some(rows.clone()), ..whole.clone() };
            let expected = &pixels[600 * rows.start..600 * rows.end];
            assert!(map.warp(&texture, &band).unwrap() == expected, "{direction:?}: rows {rows:?} differ");
        }
    }
}

/// Push-forward of the gradient by `f` against supersampling of its inverse.
fn check_push(
    what: &str,
    map: &impl PlaneMap,
    shown: Frame,
    view: Frame,
    least: f64,
    inverse: impl Fn(Complex64) -> Complex64,
) {
    let picture = gradient();
    let truth = Truth { picture: &picture, wrap: Wrap::Transparent, light: Light::Plain, samples: 8 };
    // The picture ends at its frame; half a texel of interpolation beyond does not count.
    let exact = truth.render(&shown, &view, |w| {
        let z = inverse(w);
        let (u, v) = shown.to_pixels(z);
        let inside = (0.0..=SIDE as f64).contains(&u) && (0.0..=SIDE as f64).contains(&v);
        if inside { shown.to_plane(u.clamp(0.5, 255.5), v.clamp(0.5, 255.5)) } else { Complex64::new(f64::NAN, 0.0) }
    });
    let [side, _] = view.pixels();
    for quality in [Quality::Bilinear, Quality::Trilinear, Quality::Best] {
        let setting = options(shown, view, Direction::PushForward, quality);
        let pixels = map.warp(&texture(&picture, Wrap::Clamp), &setting).unwrap();
        assert_same_alpha(&pixels, &exact, side, what);
        for channel in 0..3 {
            let ratio = psnr(&pixels, &exact, channel, |k| exact[k][3] > 254.9);
            assert!(
                ratio > least,
                "{what}, {quality:?}, channel {channel}: {ratio:.1} dB; {}",
                golden::keep_exact(what, view.pixels()[0], &pixels, &exact)
            );
        }
        // Partly covered pixels too.
        let covered: f64 = pixels.iter().skip(3).step_by(4).map(|&alpha| f64::from(alpha) / 255.0).sum();
        let area: f64 = exact.iter().map(|pixel| pixel[3] / 255.0).sum();
        assert!(
            (covered - area).abs() < 0.0005 * area + 8.0,
            "{what}, {quality:?}: {covered} pixels covered, not {area}"
        );
    }
}

/// Every invertible map says that it is one, and pushes a picture, once, as its inverse pulls it back: whatever the wrap mode.
#[test]
fn every_invertible_map_pushes_by_its_inverse() {
    fn check(what: &str, map: &impl InvertibleMap, shown: Frame, view: Frame) {
        let picture = gradient();
        for wrap in [Wrap::Transparent, Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
            let (wrapped, once) = (texture(&picture, wrap), texture(&picture, Wrap::Transparent));
            for quality in [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best] {
                let push = options(shown, view, Direction::PushForward, quality);
                let pull = WarpOptions { direction: Direction::PullBack, ..push.clone() };
                let expected = Inverse(map).warp(&once, &pull).unwrap();
                assert!(expected.iter().any(|&byte| byte > 0), "{what}: nothing is seen");
                let what = format!("{what}, {wrap:?}, {quality:?}");
                assert!(map.warp(&wrapped, &push).unwrap() == expected, "{what}");
                assert!(Inverse(Inverse(map)).warp(&wrapped, &push).unwrap() == expected, "{what}, inverted twice");
                let prepared = map.prepare(&wrapped, &push).unwrap();
                assert!(prepared.warp(&wrapped).unwrap() == expected, "{what}, prepared");
                let mut stacked = vec![7; expected.len()];
                let stack = FoveatedTexture::new(vec![(wrapped.clone(), shown)]).unwrap();
                stack.warp_into(map, &push, &mut stacked).unwrap();
                assert!(stacked == expected, "{what}, stacked");
            }
        }
    }
    let c = Complex64::new;
    let shift = Moebius::new(Complex64::ONE, c(0.3, 0.0), Complex64::ZERO, Complex64::ONE).unwrap();
    let (unit, wide) = (frame(0.0, 0.0, 2.0, SIDE), frame(0.0, 0.0, 3.0, 90));
    check("Moebius", &Moebius::cayley(), frame(0.0, 1.0, 2.0, SIDE), wide);
    check("Compose", &Compose { outer: Moebius::cayley(), inner: shift }, frame(0.0, 1.0, 2.0, SIDE), wide);
    check("HalfDiskMap", &HalfDiskMap::new(c(0.3, 0.1), 0.4).unwrap(), unit, wide);
    let (field, cortex) = (frame(0.0, 0.0, 60.0, SIDE), frame(20.0, 0.0, 80.0, 90));
    let model = CorticalModel::POLIMENI_2006;
    check("CorticalModel", &model, field, cortex);
    check("Mirrored", &Mirrored(model), field, frame(-20.0, 0.0, 80.0, 90));
    let visual = VisualCortex::from_model(model, Hemisphere::Right);
    check("VisualCortex", &visual, field, frame(-20.0, 0.0, 80.0, 90));
    check("Degrees", &Degrees, unit, frame(0.0, 0.0, 120.0, 90));
    let gaze = Gaze::new(&unit, 70.0, c(0.2, 0.1)).unwrap();
    check("Gaze", &gaze, unit, frame(0.0, 0.0, 1.0, 90));
    check("CorticalImage", &visual.seeing(gaze), frame(-20.0, 0.0, 80.0, SIDE), wide);
    let square = [c(-1.0, -1.0), c(1.0, -1.0), c(1.0, 1.0), c(-1.0, 1.0)];
    let solved = |corners: &[Complex64]| {
        let region = Region::new(corners, Curve::Polygon, Complex64::ZERO, corners[0]).unwrap();
        RiemannMap::solve(&region, &SolveOptions { tolerance: 1e-6, ..SolveOptions::default() }, &mut |_, _| true)
    };
    let (first, second) = (solved(&square).unwrap(), solved(&square.map(|z| c(1.4 * z.re, z.im))).unwrap());
    check("RiemannMap", &first, unit, wide);
    check("RegionMap", &RegionMap::between(&first, &second), unit, wide);
    let landmark = Landmark { field: c(0.3, 0.1), cortex: Complex64::ZERO, direction: 0.2 };
    check("RetinoCorticalMap", &RetinoCorticalMap::new(first, landmark).unwrap(), unit, wide);
}

/// A map is pushed forward alike, whether it knows its inverse or not.
#[test]
fn push_forward_ends_at_the_frame_with_and_without_an_inverse() {
    let c = Complex64::new;
    let known = Moebius::new(Complex64::ONE, c(-0.3, 0.0), c(0.5, 0.0), Complex64::ONE).unwrap();
    let formula = FormulaMap::new("(z - 0.3)/(1 + 0.5z)").unwrap();
    assert!(formula.inverse_map().is_none());
    let (shown, view, side) = (frame(0.0, 0.0, 2.0, SIDE), frame(0.0, 0.0, 6.0, 200), 200);
    let truth = Truth { picture: &gradient(), wrap: Wrap::Transparent, light: Light::Plain, samples: 8 };
    let exact = truth.render(&shown, &view, |w| (w + 0.3) / (1.0 - 0.5 * w));
    for wrap in [Wrap::Transparent, Wrap::Clamp, Wrap::Repeat, Wrap::Mirror] {
        let texture = texture(&gradient(), wrap);
        for quality in [Quality::Nearest, Quality::Bilinear, Quality::Trilinear, Quality::Best] {
            let setting = options(shown, view, Direction::PushForward, quality);
            let by_inverse = known.warp(&texture, &setting).unwrap();
            let by_mesh = formula.warp(&texture, &setting).unwrap();
            assert_same_alpha(&by_inverse, &exact, side, &format!("by the inverse, {wrap:?}, {quality:?}"));
            assert_same_alpha(&by_mesh, &exact, side, &format!("by a mesh, {wrap:?}, {quality:?}"));
        }
    }
}

#[test]
fn push_forward_is_the_pull_back_of_the_inverse() {
    let map = analytic(|z| ((z - 0.3) / (1.0 + 0.5 * z), (1.0 + 0.15) / ((1.0 + 0.5 * z) * (1.0 + 0.5 * z))));
    check_push("moebius", &map, frame(0.0, 0.0, 2.0, SIDE), frame(0.0, 0.0, 3.0, 200), 38.0, |w| {
        (w + 0.3) / (1.0 - 0.5 * w)
    });
}

#[test]
fn push_forward_stops_at_branch_cuts() {
    let map = analytic(|z| (z.ln(), 1.0 / z));
    check_push("log", &map, frame(0.05, 0.03, 2.0, SIDE), frame(-1.0, 0.0, 7.0, 200), 30.0, |w| {
        if w.im.abs() < PI { w.exp() } else { Complex64::new(f64::NAN, 0.0) }
    });
    let map = analytic(|z| (z.sqrt(), 0.5 / z.sqrt()));
    check_push("sqrt", &map, frame(0.05, 0.03, 2.0, SIDE), frame(0.6, 0.0, 2.6, 200), 30.0, |w| {
        if w.re > 0.0 { w * w } else { Complex64::new(f64::NAN, 0.0) }
    });
}

#[test]
fn push_forward_leaves_no_hole_at_a_pole() {
    let map = analytic(|z| (1.0 / z, -1.0 / (z * z)));
    check_push("1/z", &map, frame(0.02, 0.01, 2.0, SIDE), frame(0.0, 0.0, 8.0, 200), 30.0, |w| 1.0 / w);
}

#[test]
fn where_sheets_overlap_the_lowest_point_of_the_texture_is_seen() {
    let map = analytic(|z| (z * z, 2.0 * z));
    check_push("z^2", &map, frame(0.0, 0.0, 2.0, SIDE), frame(0.0, 0.0, 2.2, 200), 30.0, |w| {
        let root = w.sqrt();
        if root.im < 0.0 { root } else { -root }
    });
}
