//! Region → disk: joint triangulations of the fixtures' regions.

use crate::support::{case, largest, solve};
use conformal_warp::{Complex64, Curve, Frame, JointTriangulation, MeshOptions, Region, RiemannMap, SolveOptions};

fn solved(name: &str) -> RiemannMap {
    solve(&case(name).region(), 1e-8)
}

fn spacing_of(map: &RiemannMap, across: f64) -> f64 {
    map.region().polygon().area().sqrt() / across
}

#[test]
fn meshes_onto_the_disk_are_valid() {
    for name in ["sc_4_101", "sc_6_102", "sc_9_103", "sc_15_104", "sc_24_105", "spike", "blob100"] {
        let map = solved(name);
        let mesh =
            JointTriangulation::region_to_disk(&map, &MeshOptions::with_spacing(spacing_of(&map, 16.0))).unwrap();
        mesh.validate().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(mesh.flipped(), 0, "{name}");
        let images: Vec<_> = map.angles().iter().map(|&angle| Complex64::cis(angle)).collect();
        for (k, vertex) in map.region().boundary().iter().enumerate() {
            let node = mesh.source().iter().position(|z| z == vertex).unwrap();
            assert!((mesh.target()[node] - images[k]).norm() < 2e-6, "{name}: vertex {k} is not where its angle says");
        }
    }
}

/// Their far ends have a harmonic measure below rounding: on the circle they are one point, around which the nodes are
/// spread out and connected without folds.
#[test]
fn long_regions_have_valid_meshes_onto_the_disk_and_each_other() {
    let maps = ["neck", "rect10", "rect20", "slot"].map(solved);
    for map in &maps {
        let mesh = JointTriangulation::region_to_disk(map, &MeshOptions::with_spacing(spacing_of(map, 12.0))).unwrap();
        mesh.validate().unwrap();
        assert!(map.region().boundary().iter().all(|vertex| mesh.source().contains(vertex)));
    }
    for (from, to) in [(0, 2), (2, 0), (0, 0), (3, 1)] {
        let options = MeshOptions::with_spacing(spacing_of(&maps[from], 12.0));
        let mesh = JointTriangulation::region_to_region(&maps[from], &maps[to], &options).unwrap();
        mesh.validate().unwrap();
        if from == to {
            let moved = largest(mesh.source().iter().zip(mesh.target()).map(|(z, w)| (z - w).norm()));
            assert!(moved < 1e-6, "a region's own far end moves by {moved}");
        }
    }
}

#[test]
fn a_graded_mesh_keeps_its_bound() {
    let map = solved("sc_9_103");
    let frame = Frame::new(Complex64::ZERO, 2.0, [400, 400]).unwrap();
    let mesh = JointTriangulation::region_to_disk(&map, &MeshOptions::quarter_pixel(frame)).unwrap();
    mesh.validate().unwrap();
    assert!(mesh.evidence().largest_error <= 0.25 * frame.pixel_size());
    // Independent of the builder's own account: the map at other points of the triangles than it looked at.
    let (mut points, mut affine) = (Vec::new(), Vec::new());
    for t in mesh.triangles() {
        let blend = |points: &[Complex64]| {
            let [a, b, c] = t.map(|k| points[k as usize]);
            0.55 * a + 0.25 * b + 0.2 * c
        };
        points.push(blend(mesh.source()));
        affine.push(blend(mesh.target()));
    }
    let worst = largest(map.to_disk(&points).iter().zip(&affine).map(|(w, v)| (w - v).norm()));
    assert!(worst < 0.4 * frame.pixel_size(), "{} pixels", worst / frame.pixel_size());
}

#[test]
fn where_the_map_is_smooth_the_error_falls_as_the_square_of_the_spacing() {
    let map = solved("sc_6_102");
    let rms = |across: f64| {
        let options = MeshOptions::with_spacing(spacing_of(&map, across));
        let mesh = JointTriangulation::region_to_disk(&map, &options).unwrap();
        let middle =
            |points: &[Complex64], t: &[u32; 3]| t.iter().map(|&k| points[k as usize]).sum::<Complex64>() / 3.0;
        let (points, affine): (Vec<_>, Vec<_>) = mesh
            .triangles()
            .iter()
            .map(|t| (middle(mesh.source(), t), middle(mesh.target(), t)))
            .filter(|(_, w)| w.norm() < 0.7)
            .unzip();
        let sum: f64 = map.to_disk(&points).iter().zip(&affine).map(|(w, v)| (w - v).norm_sqr()).sum();
        (sum / points.len() as f64).sqrt()
    };
    let errors = [16.0, 32.0, 64.0].map(rms);
    let order = 0.5 * (errors[0] / errors[2]).log2();
    assert!((order - 2.0).abs() < 0.15, "order {order}, errors {errors:?}");
}

#[test]
fn a_smooth_curve_is_followed_by_its_nodes() {
    let ellipse = |t: f64| Complex64::new(2.0 * t.cos(), t.sin());
    let points: Vec<_> = (0..40).map(|k| ellipse(std::f64::consts::TAU * f64::from(k) / 40.0)).collect();
    let region = Region::new(&points, Curve::Smooth, Complex64::new(0.3, 0.1), ellipse(1.0)).unwrap();
    let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true).unwrap();
    let mesh = JointTriangulation::region_to_disk(&map, &MeshOptions::with_spacing(0.1)).unwrap();
    mesh.validate().unwrap();
    for &node in mesh.outline() {
        let z = mesh.source()[node as usize];
        assert!((0.25 * z.re * z.re + z.im * z.im - 1.0).abs() < 1e-9, "{z} is not on the ellipse");
    }
}
