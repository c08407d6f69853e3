//! Region → region: how near the picture of a mesh comes to the map itself, on the regions of the README's figures.

use crate::support::picture::{fixture_photo, psnr};
use crate::support::{golden, largest};
use conformal_warp::{
    Complex64, Curve, Density, Direction, Frame, JointTriangulation, Light, MeshOptions, Quality, Region, RegionMap,
    RiemannMap, Route, SolveOptions, Texture, Warp, WarpOptions, Wrap,
};

/// Corners in pixels of the photo, y down.
const HEAD: &str = "146 148, 128 96, 142 44, 176 14, 226 4, 276 16, 306 56, 312 104, 292 150, 300 182, 330 214, 322 260, \
                    290 292, 236 306, 180 300, 132 276, 104 236, 106 196, 130 172";
const LEAF: &str = "256 20, 318 92, 412 120, 486 196, 470 286, 398 330, 330 312, 300 330, 318 400, 366 474, 286 446, \
                    250 490, 226 440, 150 470, 196 398, 212 330, 180 312, 112 330, 40 286, 28 196, 100 120, 194 92";

fn point(x: f64, y: f64) -> Complex64 {
    Complex64::new(x, -y)
}

fn solved(corners: &str, center: Complex64, toward: Complex64) -> RiemannMap {
    let corner = |pair: &str| {
        let (x, y) = pair.trim().split_once(' ').unwrap();
        point(x.parse().unwrap(), y.parse().unwrap())
    };
    let vertices: Vec<_> = corners.split(',').map(corner).collect();
    let region = Region::new(&vertices, Curve::Polygon, center, toward).unwrap();
    RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true).unwrap()
}

fn head_and_leaf() -> [RiemannMap; 2] {
    [solved(HEAD, point(225.0, 125.0), point(226.0, 4.0)), solved(LEAF, point(250.0, 220.0), point(256.0, 20.0))]
}

/// One plane unit a pixel.
fn photo_frame() -> Frame {
    Frame::new(point(256.0, 256.0), 512.0, [512, 512]).unwrap()
}

/// |map − affine piece| at points inside the triangles that the builder did not look at, and the triangles' sizes in the
/// source.
fn errors(mesh: &JointTriangulation, map: &RegionMap) -> Vec<(f64, f64)> {
    let corners = |points: &[Complex64], t: &[u32; 3]| t.map(|k| points[k as usize]);
    let blend = |[a, b, c]: [Complex64; 3]| 0.55 * a + 0.25 * b + 0.2 * c;
    let (points, rest): (Vec<_>, Vec<_>) = mesh
        .triangles()
        .iter()
        .map(|t| {
            let [a, b, c] = corners(mesh.source(), t);
            let size = (a - b).norm().max((b - c).norm()).max((c - a).norm());
            (blend([a, b, c]), (blend(corners(mesh.target(), t)), size))
        })
        .unzip();
    map.forward(&points).iter().zip(rest).map(|(w, (affine, size))| ((w - affine).norm(), size)).collect()
}

/// The leaf has tails of 40°, which the map draws out of straight parts of the head's outline: the error falls there only
/// as the fifth root of the distance.
#[test]
fn a_graded_mesh_keeps_its_bound_up_to_the_tips() {
    let [from, to] = head_and_leaf();
    let map = RegionMap::between(&from, &to);
    for (pixels, angle) in [(0.25, 0.1), (1.0, 0.2)] {
        let density = Density::MaxError { pixels, frame: photo_frame() };
        let options = MeshOptions { density, route: Route::Exact };
        let mesh = JointTriangulation::region_to_region(&from, &to, &options).unwrap();
        mesh.validate().unwrap();
        let evidence = mesh.evidence();
        assert!(evidence.largest_error_pixels().unwrap() <= pixels, "{evidence:?}");
        assert!(mesh.source().len() < 5000, "{} nodes", mesh.source().len());
        // Triangles of less than a millionth of a pixel show one colour.
        let errors = errors(&mesh, &map);
        let worst = largest(errors.iter().filter(|(_, size)| *size > 1e-6).map(|(error, _)| *error));
        assert!(worst < 1.6 * pixels, "{worst} pixels");
        let (mean, largest) = (mesh.mean_angle_error(), mesh.largest_angle_error());
        assert!(mean < angle && largest < 2.8, "angles change by {mean}, at most {largest}");
    }
}

#[test]
fn where_the_map_is_smooth_the_error_falls_as_the_square_of_the_spacing() {
    let [from, to] = head_and_leaf();
    let map = RegionMap::between(&from, &to);
    let inner = |mesh: &JointTriangulation| {
        let errors = errors(mesh, &map);
        let center = |t: &[u32; 3]| t.iter().map(|&k| mesh.source()[k as usize]).sum::<Complex64>() / 3.0;
        let centers: Vec<_> = mesh.triangles().iter().map(center).collect();
        let kept = from.to_disk(&centers).into_iter().zip(errors).filter(|(w, _)| w.norm() < 0.7);
        let squares: Vec<_> = kept.map(|(_, (error, _))| error * error).collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
    };
    for route in [Route::Exact, Route::Located] {
        let rms = [16.0, 8.0, 4.0].map(|spacing| {
            let options = MeshOptions { density: Density::Spacing(spacing), route };
            inner(&JointTriangulation::region_to_region(&from, &to, &options).unwrap())
        });
        let order = 0.5 * (rms[0] / rms[2]).log2();
        assert!((order - 2.0).abs() < 0.25, "{route:?}: order {order}, errors {rms:?}");
    }
}

#[test]
fn the_routes_differ_by_what_the_evidence_says() {
    let [from, to] = head_and_leaf();
    let located = |density| {
        let options = MeshOptions { density, route: Route::Located };
        JointTriangulation::region_to_region(&from, &to, &options).unwrap().evidence()
    };
    let [coarse, fine] = [17.0, 8.5].map(|spacing| located(Density::Spacing(spacing)));
    assert!(
        coarse.route_difference > 0.1 && fine.route_difference < 0.7 * coarse.route_difference,
        "{coarse:?} {fine:?}"
    );
    assert_eq!(coarse.route_difference_pixels(), None);
    let frame = Frame::new(point(256.0, 256.0), 512.0, [1024, 1024]).unwrap();
    let evidence = located(Density::quarter_pixel(frame));
    let pixels = evidence.route_difference_pixels().unwrap();
    assert!(pixels > 0.0 && (pixels - 2.0 * evidence.route_difference).abs() < 1e-9 * pixels, "{evidence:?}");
}

/// |f'| at inner nodes and along edges, not what the triangles around make of it.
#[test]
fn magnification_is_that_of_the_map() {
    let [from, to] = head_and_leaf();
    let mesh = JointTriangulation::region_to_region(&from, &to, &MeshOptions::with_spacing(17.0)).unwrap();
    let exact = RegionMap::between(&from, &to).derivative(mesh.source());
    let mut compared = 0;
    let is_corner = |k: usize| {
        from.region().boundary().contains(&mesh.source()[k]) || to.region().boundary().contains(&mesh.target()[k])
    };
    for (k, (own, exact)) in mesh.magnification().iter().zip(&exact).enumerate() {
        assert!(own.is_finite() && *own > 0.0);
        if exact.is_finite() && !is_corner(k) {
            assert!((own / exact.norm() - 1.0).abs() < 1e-4, "{own} for {exact}");
            compared += 1;
        }
    }
    assert!(compared + 60 > mesh.source().len(), "{compared} of {}", mesh.source().len());
    let back = mesh.clone().reversed();
    assert!(mesh.magnification().iter().zip(back.magnification()).all(|(m, n)| (m * n - 1.0).abs() < 1e-12));
}

#[test]
fn the_picture_of_the_mesh_is_that_of_the_map() {
    let photo = fixture_photo("astronaut.jpg");
    let texture = Texture::new(&photo.rgba, photo.size, photo.size, Wrap::Clamp, Light::Linear).unwrap();
    let [from, to] = head_and_leaf();
    let map = RegionMap::between(&from, &to);
    let view = photo_frame();
    let options = |direction| WarpOptions { direction, quality: Quality::Trilinear, ..WarpOptions::new(view, view) };
    let exact = map.warp(&texture, &options(Direction::PushForward)).unwrap();
    let exact: Vec<[f64; 4]> = exact.as_chunks().0.iter().map(|p: &[u8; 4]| p.map(f64::from)).collect();
    // The outline's own pixels are covered in part by the mesh, and judged by their centers by the map.
    let inside = |pixel: usize| {
        let z = view.to_plane((pixel % 512) as f64 + 0.5, (pixel / 512) as f64 + 0.5);
        to.region().contains(z) && (to.region().nearest(z).point - z).norm() > 1.0
    };
    let ratio = |density, route, bound: f64| {
        let mesh = JointTriangulation::region_to_region(&from, &to, &MeshOptions { density, route }).unwrap();
        let pixels = mesh.warp(&texture, &options(Direction::PushForward)).unwrap();
        assert!((0..512 * 512).filter(|&k| inside(k)).all(|k| pixels[4 * k + 3] == 255));
        let least = -largest((0..3).map(|channel| -psnr(&pixels, &exact, channel, inside)));
        assert!(least >= bound, "{least} dB; {}", golden::keep_exact("mesh", 512, &pixels, &exact));
        least
    };
    let quarter = ratio(Density::quarter_pixel(view), Route::Exact, 40.0);
    let coarse = ratio(Density::Spacing(17.0), Route::Exact, 20.0);
    assert!(coarse < quarter - 5.0, "{coarse} dB: the picture does not tell coarse from fine");
}
