//! A checkerboard through triangle meshes of maps known in closed form, against supersampled truth.

use crate::support::golden;
use crate::support::picture::{Picture, Truth, psnr};
use conformal_warp::{Complex64, Direction, Frame, Light, Quality, Texture, TriangleMesh, Warp, WarpOptions, Wrap};
use std::f64::consts::TAU;

/// The unit disk as rings of 6, 12, 18, … nodes around the centre.
fn disk_mesh(rings: usize) -> (Vec<Complex64>, Vec<[u32; 3]>) {
    let mut nodes = vec![Complex64::new(0.0, 0.0)];
    let mut triangles = Vec::new();
    for ring in 1..=rings {
        let (inner, outer) = (3 * (ring - 1) * ring.saturating_sub(2) + 1, nodes.len());
        let radius = ring as f64 / rings as f64;
        nodes.extend((0..6 * ring).map(|k| Complex64::from_polar(radius, TAU * k as f64 / (6 * ring) as f64)));
        let node = |start: usize, ring: usize, k: usize| {
            if ring == 0 { 0 } else { (start + k % (6 * ring)) as u32 }
        };
        for sector in 0..6 {
            for k in 0..ring {
                let (i, o) = (sector * (ring - 1) + k, sector * ring + k);
                let first_inner = node(inner, ring - 1, i);
                triangles.push([first_inner, node(outer, ring, o), node(outer, ring, o + 1)]);
                if k + 1 < ring {
                    triangles.push([first_inner, node(outer, ring, o + 1), node(inner, ring - 1, i + 1)]);
                }
            }
        }
    }
    (nodes, triangles)
}

/// The automorphism of the disk that takes a to 0.
fn moebius(z: Complex64, a: Complex64) -> Complex64 {
    (z - a) / (1.0 - a.conj() * z)
}

const A: Complex64 = Complex64::new(0.4, -0.3);

fn frame(width: f64, side: usize) -> Frame {
    Frame::new(Complex64::new(0.0, 0.0), width, [side, side]).unwrap()
}

fn options(quality: Quality, direction: Direction) -> WarpOptions {
    WarpOptions { direction, quality, ..WarpOptions::new(frame(2.2, 512), frame(2.2, 300)) }
}

/// Output pixels whose centre is at least `margin` pixels inside the unit disk.
fn inside_disk(view: &Frame, margin: f64) -> impl Fn(usize) -> bool + use<> {
    let (side, size, view) = (view.pixels()[0], view.pixel_size(), *view);
    move |pixel| {
        let z = view.to_plane((pixel % side) as f64 + 0.5, (pixel / side) as f64 + 0.5);
        z.norm() < 1.0 - margin * size
    }
}

/// Draws a checkerboard through a Möbius mesh, both ways, in each quality with its least PSNR in dB.
fn check_checkerboard(light: Light, bounds: &[(Quality, f64)]) {
    let picture = Picture::checker(512, 16);
    let texture = Texture::new(&picture.rgba, 512, 512, Wrap::Repeat, light).unwrap();
    let (source, triangles) = disk_mesh(60);
    let target: Vec<_> = source.iter().map(|&z| moebius(z, A)).collect();
    let mesh = TriangleMesh { source: &source, target: &target, triangles: &triangles, stretch: None };
    let truth = Truth { picture: &picture, wrap: Wrap::Repeat, light, samples: 12 };
    for direction in [Direction::PushForward, Direction::PullBack] {
        let a = if direction == Direction::PushForward { -A } else { A };
        let setting = options(Quality::Trilinear, direction);
        let exact = truth.render(&setting.texture, &setting.view, |p| moebius(p, a));
        let mut last = 0.0;
        for &(quality, bound) in bounds {
            let pixels = mesh.warp(&texture, &options(quality, direction)).unwrap();
            let inside = inside_disk(&setting.view, 2.0);
            let ratio = psnr(&pixels, &exact, 0, &inside);
            assert!(
                ratio > bound && ratio > last,
                "{light:?} {quality:?}: {ratio} dB, after {last}; {}",
                golden::keep_exact("moebius", setting.view.pixels()[0], &pixels, &exact)
            );
            last = ratio;
            let holes = (0..exact.len()).filter(|&k| inside(k) && pixels[4 * k + 3] != 255).count();
            assert_eq!(holes, 0, "{quality:?} leaves holes");
        }
    }
}

#[test]
fn a_checkerboard_through_a_moebius_mesh_is_the_supersampled_truth() {
    use Quality::{Best, Bilinear, Nearest, Trilinear};
    check_checkerboard(Light::Plain, &[(Nearest, 17.5), (Bilinear, 24.0), (Trilinear, 35.0), (Best, 41.0)]);
    // Only the best quality interpolates light; black against white shows that like nothing else.
    check_checkerboard(Light::Linear, &[(Nearest, 14.0), (Bilinear, 17.5), (Trilinear, 19.0), (Best, 33.5)]);
}

#[test]
fn given_stretch_and_averaged_stretch_agree() {
    let picture = Picture::checker(512, 16);
    let texture = Texture::new(&picture.rgba, 512, 512, Wrap::Clamp, Light::Linear).unwrap();
    let (source, triangles) = disk_mesh(60);
    let target: Vec<_> = source.iter().map(|&z| moebius(z, A)).collect();
    let stretch: Vec<_> = source.iter().map(|z| (1.0 - A.norm_sqr()) / (1.0 - A.conj() * z).norm_sqr()).collect();
    for direction in [Direction::PushForward, Direction::PullBack] {
        let draw = |stretch| {
            let mesh = TriangleMesh { source: &source, target: &target, triangles: &triangles, stretch };
            mesh.warp(&texture, &options(Quality::Trilinear, direction)).unwrap()
        };
        let (averaged, given) = (draw(None), draw(Some(&stretch[..])));
        let exact: Vec<_> = given.as_chunks().0.iter().map(|p: &[u8; 4]| p.map(f64::from)).collect();
        let ratio = psnr(&averaged, &exact, 0, |_| true);
        let [width, _] = options(Quality::Trilinear, direction).view.pixels();
        assert!(ratio > 38.0, "{ratio} dB; {}", golden::keep("averaged stretch", width, &averaged, &given));
    }
}

#[test]
fn the_outline_is_covered_by_area() {
    let white = vec![255; 4];
    let texture = Texture::new(&white, 1, 1, Wrap::Clamp, Light::Linear).unwrap();
    let (nodes, triangles) = disk_mesh(40);
    let mesh = TriangleMesh { source: &nodes, target: &nodes, triangles: &triangles, stretch: None };
    for quality in [Quality::Nearest, Quality::Trilinear, Quality::Best] {
        let setting = options(quality, Direction::PullBack);
        let pixels = mesh.warp(&texture, &setting).unwrap();
        let area: f64 = pixels.iter().skip(3).step_by(4).map(|&alpha| f64::from(alpha) / 255.0).sum();
        let polygon = 0.5 * 240.0 * (TAU / 240.0).sin() / setting.view.pixel_size().powi(2);
        assert!((area - polygon).abs() < 0.5, "{quality:?}: {area} pixels covered, not {polygon}");
        let tinted = pixels.as_chunks::<4>().0.iter().filter(|p| p[3] > 0 && p[..3] != [255; 3]).count();
        assert_eq!(tinted, 0, "{quality:?}: the outline's pixels are as white as the rest");
    }
}

#[test]
fn bands_make_the_same_pixels_as_the_whole() {
    let picture = Picture::checker(256, 8);
    let texture = Texture::new(&picture.rgba, 256, 256, Wrap::Mirror, Light::Linear).unwrap();
    let (source, triangles) = disk_mesh(20);
    let target: Vec<_> = source.iter().map(|&z| moebius(z, A)).collect();
    let mesh = TriangleMesh { source: &source, target: &target, triangles: &triangles, stretch: None };
    let whole = mesh.warp(&texture, &options(Quality::Best, Direction::PushForward)).unwrap();
    for rows in [0..1, 17..53, 250..300, 64..64] {
        let band = WarpOptions { rows: Some(rows.clone()), ..options(Quality::Best, Direction::PushForward) };
        let expected = &whole[4 * 300 * rows.start..4 * 300 * rows.end];
        assert!(mesh.warp(&texture, &band).unwrap() == expected, "rows {rows:?} differ");
    }
}

#[test]
fn later_triangles_cover_earlier_ones() {
    let texture =
        Texture::new(&[[255, 0, 0, 255], [0, 0, 255, 255]].concat(), 2, 1, Wrap::Clamp, Light::Plain).unwrap();
    let at = |x: f64, y: f64| Complex64::new(x, y);
    // One triangle over the red half and one over the blue half, both shown at the same place.
    let source = [at(-2.0, -1.0), at(-1.0, -1.0), at(-1.0, 1.0), at(2.0, -1.0), at(1.0, -1.0), at(1.0, 1.0)];
    let target = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0)];
    let setting = WarpOptions {
        direction: Direction::PushForward,
        quality: Quality::Nearest,
        ..WarpOptions::new(Frame::new(at(0.0, 0.0), 4.0, [2, 1]).unwrap(), frame(2.0, 8))
    };
    for (triangles, color) in [([[0, 1, 2], [3, 4, 5]], [0, 0, 255]), ([[3, 4, 5], [0, 1, 2]], [255, 0, 0])] {
        let mesh = TriangleMesh { source: &source, target: &target, triangles: &triangles, stretch: None };
        let pixels = mesh.warp(&texture, &setting).unwrap();
        let pixel = 4 * (8 * 5 + 6);
        assert_eq!(pixels[pixel..pixel + 4], [color[0], color[1], color[2], 255]);
    }
}

#[test]
fn input_that_does_not_fit_is_refused() {
    let texture = Texture::new(&[0; 4], 1, 1, Wrap::Clamp, Light::Plain).unwrap();
    let points = [Complex64::new(0.0, 0.0), Complex64::new(1.0, 0.0), Complex64::new(0.0, 1.0)];
    let good = TriangleMesh { source: &points, target: &points, triangles: &[[0, 1, 2]], stretch: None };
    let setting = options(Quality::Trilinear, Direction::PullBack);
    let code = |mesh: TriangleMesh<'_>, setting: &WarpOptions| mesh.warp(&texture, setting).unwrap_err().code();
    assert_eq!(code(TriangleMesh { target: &points[..2], ..good }, &setting), "wrong-length");
    assert_eq!(code(TriangleMesh { stretch: Some(&[1.0]), ..good }, &setting), "wrong-length");
    assert_eq!(code(TriangleMesh { triangles: &[[0, 1, 3]], ..good }, &setting), "invalid-triangle");
    assert_eq!(code(good, &WarpOptions { rows: Some(7..301), ..setting.clone() }), "invalid-rows");
    assert_eq!(good.warp_into(&texture, &setting, &mut [0; 12]).unwrap_err().code(), "wrong-length");
    let nan = [Complex64::new(f64::NAN, 0.0), points[1], points[2]];
    let pixels = TriangleMesh { target: &nan, ..good }.warp(&texture, &setting).unwrap();
    assert!(pixels.iter().all(|&byte| byte == 0), "a triangle without a place is not drawn");
}
