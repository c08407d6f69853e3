//! Joint triangulations of regions with curved edges.

use crate::support::{c, largest, polygon, solve};
use conformal_warp::{
    Complex64, Edge, Frame, JointTriangulation, MeshOptions, MeshStop, Region, RiemannMap, parse_path,
};
use std::f64::consts::PI;

fn half_disk() -> RiemannMap {
    let edges = [Edge::line(c(-1.0, 0.0), c(1.0, 0.0)), Edge::circular(Complex64::ZERO, 1.0, 0.0, PI)];
    solve(&Region::from_edges(&edges, c(0.1, 0.4), c(1.0, 0.0)).unwrap(), 1e-8)
}

/// A bowl of two arcs that are close to each other, with lines and a Bézier curve at its ends.
fn bowl() -> RiemannMap {
    let edges = parse_path("M -1 0 A 1 1 0 0 1 1 0 L 0.97 0 A 0.97 0.97 0 0 0 -0.97 0 C -0.98 0.02 -0.99 -0.02 -1 0 Z")
        .unwrap();
    solve(&Region::from_edges(&edges, c(0.0, -0.985), c(0.0, -1.0)).unwrap(), 1e-6)
}

/// The half disk onto the disk, up to a turn: ((1 + z)/(1 − z))² takes it onto the upper half plane.
fn half_disk_exactly(z: Complex64, center: Complex64) -> Complex64 {
    let half_plane = |z: Complex64| ((1.0 + z) / (1.0 - z)).powi(2);
    let (w, w0) = (half_plane(z), half_plane(center));
    (w - w0) / (w - w0.conj())
}

fn assert_on_the_outline(mesh: &JointTriangulation, map: &RiemannMap) {
    let outline = map.region().curved().unwrap();
    for &node in mesh.outline() {
        let z = mesh.source()[node as usize];
        assert!(outline.signed_distance(z).abs() < 1e-14, "{z} is not on the outline");
    }
    for edge in outline.edges() {
        assert!(mesh.source().contains(&edge.from()), "an edge does not start at a node");
    }
}

#[test]
fn a_half_disk_is_carried_onto_the_disk_as_the_map_does() {
    let map = half_disk();
    let frame = Frame::new(Complex64::ZERO, 2.0, [400, 400]).unwrap();
    let mesh = JointTriangulation::region_to_disk(&map, &MeshOptions::quarter_pixel(frame)).unwrap();
    mesh.validate().unwrap();
    assert_eq!((mesh.flipped(), mesh.evidence().stop, mesh.evidence().mended), (0, MeshStop::Density, 0));
    assert_on_the_outline(&mesh, &map);
    let center = map.region().center();
    let turn = half_disk_exactly(c(0.0, 0.0), center).conj() * map.to_disk(&[c(0.0, 0.0)])[0];
    let blend = |points: &[Complex64], t: &[u32; 3]| {
        let [a, b, c] = t.map(|k| points[k as usize]);
        0.55 * a + 0.25 * b + 0.2 * c
    };
    let off = mesh
        .triangles()
        .iter()
        .map(|t| (turn * half_disk_exactly(blend(mesh.source(), t), center) - blend(mesh.target(), t)).norm());
    let worst = largest(off);
    assert!(worst < 0.4 * frame.pixel_size(), "{} pixels", worst / frame.pixel_size());
}

#[test]
fn chords_of_walls_that_lie_close_to_each_other_do_not_cross() {
    let map = bowl();
    for options in [MeshOptions::with_spacing(0.5), MeshOptions::with_spacing(0.02)] {
        let mesh = JointTriangulation::region_to_disk(&map, &options).unwrap();
        mesh.validate().unwrap();
        assert_on_the_outline(&mesh, &map);
    }
}

#[test]
fn regions_of_curves_go_onto_each_other_and_onto_polygons() {
    let corners = [c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)];
    let ell = solve(&polygon(&corners, c(0.6, 0.6)), 1e-8);
    let half = half_disk();
    let leaf = parse_path("M 0 0 C 1 -1 2 0 2 2 Q 0 2 0 0 Z").unwrap();
    let leaf = solve(&Region::from_edges(&leaf, c(1.0, 0.9), c(0.0, 0.0)).unwrap(), 1e-8);
    for (from, to) in [(&half, &leaf), (&leaf, &half), (&ell, &leaf), (&leaf, &ell)] {
        let frame = Frame::new(to.region().center(), 2.5, [300, 300]).unwrap();
        let mesh = JointTriangulation::region_to_region(from, to, &MeshOptions::quarter_pixel(frame)).unwrap();
        mesh.validate().unwrap();
        assert_eq!((mesh.flipped(), mesh.evidence().stop), (0, MeshStop::Density));
        assert!(mesh.evidence().largest_error_pixels().unwrap() <= 0.25);
        let back = JointTriangulation::region_to_region(to, from, &MeshOptions::with_spacing(0.1)).unwrap();
        back.validate().unwrap();
    }
}

#[test]
fn regions_with_horns_are_triangulated_up_to_their_tips() {
    let arbelos = parse_path("M 1 0 A 1 1 0 0 1 -1 0 A 0.5 0.5 0 0 0 0 0 A 0.5 0.5 0 0 0 1 0 Z").unwrap();
    let arbelos = solve(&Region::from_edges(&arbelos, c(0.0, 0.7), c(0.0, 0.0)).unwrap(), 1e-8);
    let crescent =
        [Edge::circular(Complex64::ZERO, 1.0, 0.0, 2.0 * PI), Edge::circular(c(0.5, 0.0), 0.5, 0.0, -2.0 * PI)];
    let crescent = solve(&Region::from_edges(&crescent, c(-0.5, 0.0), c(-1.0, 0.0)).unwrap(), 1e-8);
    let frame = Frame::new(Complex64::ZERO, 2.0, [400, 400]).unwrap();
    let half = half_disk();
    let options = MeshOptions::quarter_pixel(frame);
    for mesh in [
        JointTriangulation::region_to_disk(&arbelos, &options),
        JointTriangulation::region_to_region(&arbelos, &half, &options),
    ] {
        let mesh = mesh.unwrap();
        mesh.validate().unwrap();
        assert_eq!((mesh.flipped(), mesh.evidence().stop), (0, MeshStop::Density));
        assert_on_the_outline(&mesh, &arbelos);
    }
    // Places in a horn cannot be told apart elsewhere, nor can the two that the crescent's tip is.
    for refused in [
        JointTriangulation::region_to_region(&half, &arbelos, &options),
        JointTriangulation::region_to_disk(&crescent, &options),
    ] {
        assert_eq!(refused.unwrap_err().code(), "crowded");
    }
}
