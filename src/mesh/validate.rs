//! The proof that a joint triangulation is one.

use super::joint::{JointTriangulation, MeshEvidence, Shape};
use super::quality;
use super::triangles::{boundary_edges, check_indices, invalid, orientation, outlines_of};
use crate::Result;
use crate::plane::{Complex64, Polygon};
use std::f64::consts::TAU;

/// Areas of a mesh and of its outline agree to this share.
const AREA_TOLERANCE: f64 = 1e-9;

impl JointTriangulation {
    /// A joint triangulation from its parts: two copies of the nodes, and triangles anticlockwise in both.
    ///
    /// ```
    /// use conformal_warp::JointTriangulation;
    /// use conformal_warp::Complex64;
    /// let source = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y)).to_vec();
    /// let target = source.iter().map(|z| z * Complex64::i()).collect();
    /// let mesh = JointTriangulation::from_parts(source, target, vec![[0, 1, 2]])?;
    /// assert_eq!(mesh.outline(), [0, 1, 2]);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// The magnification is that of the triangles; [`JointTriangulation::with_magnification`] gives it exactly.
    ///
    /// # Errors
    /// As [`JointTriangulation::validate`].
    pub fn from_parts(source: Vec<Complex64>, target: Vec<Complex64>, triangles: Vec<[u32; 3]>) -> Result<Self> {
        check_indices(&source, &target, &triangles)?;
        let mut outlines = outlines_of(&triangles)?;
        if let Some(outer) = outlines.iter().position(|outline| signed_area(&at(&source, outline)) > 0.0) {
            outlines.swap(0, outer);
        }
        let polygons = |points: &[Complex64]| -> Result<Vec<_>> {
            outlines.iter().map(|outline| Polygon::new(&at(points, outline)).map(Shape::Polygon)).collect()
        };
        let shapes = [polygons(&source)?, polygons(&target)?];
        let magnification = quality::magnification(&source, &target, &triangles);
        let mesh =
            Self { source, target, triangles, outlines, shapes, magnification, evidence: MeshEvidence::default() };
        mesh.validate()?;
        Ok(mesh)
    }

    /// Proves that both copies are triangulations of their outlines: every triangle anticlockwise, every inner edge
    /// shared by exactly two triangles, the outlines complete and simple, areas equal to what the outlines enclose. There may be
    /// holes: outlines that go clockwise.
    ///
    /// # Errors
    /// [`crate::Error::InvalidMesh`] with the first thing that is wrong.
    pub fn validate(&self) -> Result<()> {
        // Anticlockwise triangles, glued edge to edge, cover each point as often as their outlines wind around it. With
        // one simple curve that winds once, and others that wind back, that is once or not at all: less is impossible. The
        // area sums say the same a second way.
        check_indices(&self.source, &self.target, &self.triangles)?;
        check_edges(self)?;
        check_copy("source", &self.source, &self.shapes[0], self)?;
        check_copy("target", &self.target, &self.shapes[1], self)
    }
}

/// Every inner edge has two triangles, and the others make the outlines.
fn check_edges(mesh: &JointTriangulation) -> Result<()> {
    let next = boundary_edges(&mesh.triangles)?;
    let around = |ring: &[u32]| (0..ring.len()).map(|k| (ring[k], ring[(k + 1) % ring.len()])).collect::<Vec<_>>();
    let edges: Vec<_> = mesh.outlines.iter().flat_map(|ring| around(ring)).collect();
    if let Some(edge) = edges.iter().find(|(a, b)| next.get(a) != Some(b)) {
        return invalid(format!("edge {edge:?} of the outline is not on the boundary of the triangles"));
    }
    if next.len() != edges.len() {
        return invalid(format!(
            "{} edges have a triangle on one side only; the outline has {}",
            next.len(),
            edges.len()
        ));
    }
    // Euler: a disk with h holes has V − E + F = 1 − h, with E = (3F + boundary) / 2.
    let (v, f, b) = (mesh.source.len() as i64, mesh.triangles.len() as i64, edges.len() as i64);
    let holes = mesh.outlines.len() as i64 - 1;
    if 2 * v - (3 * f + b) + 2 * f == 2 * (1 - holes) {
        Ok(())
    } else {
        invalid(format!("{v} nodes, {f} triangles and {b} boundary edges do not make a disk with {holes} holes"))
    }
}

fn check_copy(name: &str, points: &[Complex64], shapes: &[Shape], mesh: &JointTriangulation) -> Result<()> {
    if let Some(k) = points.iter().position(|z| !z.is_finite()) {
        return invalid(format!("node {k} of the {name} is not finite"));
    }
    if let Some(t) = mesh.triangles.iter().find(|t| orientation(points, **t) <= 0.0) {
        return invalid(format!("triangle {t:?} is flipped or degenerate in the {name}"));
    }
    let mut area = 0.0;
    let mut around = 0;
    for (outline, shape) in mesh.outlines.iter().zip(shapes) {
        let mut outline = at(points, outline);
        // A hole's outline goes clockwise, its shape does not.
        let is_hole = signed_area(&outline) < 0.0;
        if is_hole {
            outline.reverse();
        }
        let enclosed = check_shape(name, &outline, shape)?;
        area += if is_hole { -enclosed } else { enclosed };
        around += usize::from(!is_hole);
    }
    if around != 1 {
        return invalid(format!("{around} outlines of the {name} go anticlockwise, where one should"));
    }
    let sum: f64 = mesh.triangles.iter().map(|t| 0.5 * orientation(points, *t)).sum();
    if (sum - area).abs() <= AREA_TOLERANCE * area {
        Ok(())
    } else {
        invalid(format!("the triangles of the {name} have area {sum}, its outline {area}"))
    }
}

/// An outline, anticlockwise, has the shape that it must have; returns the area enclosed.
fn check_shape(name: &str, outline: &[Complex64], shape: &Shape) -> Result<f64> {
    match shape {
        Shape::Polygon(polygon) => {
            check_outline(name, outline, polygon)?;
            Ok(polygon.area())
        }
        Shape::Curve => match Polygon::new(outline) {
            Ok(polygon) => Ok(polygon.area()),
            Err(error) => invalid(format!("the chords of the {name}'s outline are no outline: {error}")),
        },
        Shape::Disk => {
            check_circle(name, outline)?;
            Ok(signed_area(outline))
        }
    }
}

/// The nodes of an outline in one copy.
fn at(points: &[Complex64], outline: &[u32]) -> Vec<Complex64> {
    outline.iter().map(|&k| points[k as usize]).collect()
}

/// The outline passes through every corner of the polygon, in order, and its other nodes lie on the edges between, in
/// order, to rounding.
fn check_outline(name: &str, outline: &[Complex64], polygon: &Polygon) -> Result<()> {
    let corners = polygon.vertices();
    let Some(first) = outline.iter().position(|z| *z == corners[0]) else {
        return invalid(format!("vertex 0 of the {name} is not a node"));
    };
    let rounding = 8.0 * f64::EPSILON * (polygon.size() + corners[0].norm());
    let mut nodes = (1..=outline.len()).map(|k| outline[(first + k) % outline.len()]);
    for k in 0..corners.len() {
        let (a, b) = polygon.edge(k);
        let (length, direction) = ((b - a).norm(), (b - a) / (b - a).norm());
        let mut before = 0.0;
        loop {
            let Some(z) = nodes.next() else { return invalid(format!("vertex {k} of the {name} is not a node")) };
            let local = (z - a) * direction.conj();
            if local.im.abs() > rounding || local.re <= before || local.re > length + rounding {
                return invalid(format!("the outline of the {name} leaves edge {k} or turns back on it at ({z})"));
            }
            if z == b {
                break;
            }
            before = local.re;
        }
    }
    if nodes.next().is_some() { invalid(format!("the outline of the {name} goes round twice")) } else { Ok(()) }
}

/// The outline's nodes lie on the unit circle, anticlockwise, once round.
fn check_circle(name: &str, outline: &[Complex64]) -> Result<()> {
    let mut turned = 0.0;
    for k in 0..outline.len() {
        let (z, next) = (outline[k], outline[(k + 1) % outline.len()]);
        let step = (next * z.conj()).arg();
        if (z.norm() - 1.0).abs() > 8.0 * f64::EPSILON || step <= 0.0 {
            return invalid(format!("the outline of the {name} leaves the circle or turns back on it at ({z})"));
        }
        turned += step;
    }
    if (turned - TAU).abs() > 1e-9 {
        invalid(format!("the outline of the {name} does not go round once"))
    } else {
        Ok(())
    }
}

fn signed_area(outline: &[Complex64]) -> f64 {
    (0..outline.len()).map(|k| 0.5 * (outline[k].conj() * outline[(k + 1) % outline.len()]).im).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(xy: &[(f64, f64)]) -> Vec<Complex64> {
        xy.iter().map(|&(x, y)| Complex64::new(x, y)).collect()
    }

    fn reason(source: &[(f64, f64)], target: &[(f64, f64)], triangles: &[[u32; 3]]) -> String {
        JointTriangulation::from_parts(points(source), points(target), triangles.to_vec()).unwrap_err().to_string()
    }

    const SQUARE: [(f64, f64); 5] = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)];
    const FAN: [[u32; 3]; 4] = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];

    #[test]
    fn each_defect_is_named() {
        let fan = |k: usize, t: [u32; 3]| {
            let mut triangles = FAN;
            triangles[k] = t;
            triangles
        };
        let mut outside = SQUARE;
        outside[4] = (3.0, 1.0);
        let mut on_edge = SQUARE;
        on_edge[4] = (1.0, 0.0);
        assert!(JointTriangulation::from_parts(points(&SQUARE), points(&SQUARE), FAN.to_vec()).is_ok());
        assert!(reason(&SQUARE, &outside, &FAN).contains("flipped or degenerate in the target"));
        assert!(reason(&on_edge, &SQUARE, &FAN).contains("flipped or degenerate in the source"));
        assert!(reason(&SQUARE, &SQUARE, &fan(0, [0, 1, 7])).contains("names node 7"));
        assert!(reason(&SQUARE, &SQUARE, &fan(0, [1, 2, 4])).contains("same side of edge"));
        assert!(reason(&SQUARE, &SQUARE[..4], &FAN).contains("5 source nodes but 4"));
        assert!(reason(&SQUARE, &SQUARE, &[[0, 1, 2], [0, 2, 3]]).contains("node 4 belongs to no triangle"));
    }

    #[test]
    fn an_outline_that_leaves_its_polygon_is_found() {
        let mut mesh = JointTriangulation::from_parts(points(&SQUARE), points(&SQUARE), FAN.to_vec()).unwrap();
        let polygon = |xy: &[(f64, f64)]| vec![Shape::Polygon(Polygon::new(&points(xy)).unwrap())];
        mesh.shapes[1] = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.1)]);
        assert!(mesh.validate().unwrap_err().to_string().contains("of the target"));
        mesh.shapes[1] = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)]);
        assert!(mesh.validate().unwrap_err().to_string().contains("of the target"));
        mesh.shapes[1] = vec![Shape::Disk];
        assert!(mesh.validate().unwrap_err().to_string().contains("leaves the circle"));
    }

    /// A square hole (nodes 0 to 3) in a square (nodes 4 to 7).
    fn ring() -> (Vec<Complex64>, Vec<[u32; 3]>) {
        let square = |r: f64| [(-r, -r), (r, -r), (r, r), (-r, r)];
        let strip = |k: u32| [[k + 4, (k + 1) % 4 + 4, k], [(k + 1) % 4 + 4, (k + 1) % 4, k]];
        (points(&[square(1.0), square(2.0)].concat()), (0..4).flat_map(strip).collect())
    }

    #[test]
    fn a_mesh_around_a_hole_is_one() {
        let (source, triangles) = ring();
        let mesh = JointTriangulation::from_parts(source.clone(), source.clone(), triangles.clone()).unwrap();
        assert_eq!(mesh.outline(), [4, 5, 6, 7]);
        // Turned inside out: what was around the hole is around everything.
        let turned: Vec<_> = source.iter().map(|z| 1.0 / (z * Complex64::new(0.1, 0.0))).collect();
        JointTriangulation::from_parts(source.clone(), turned, triangles.clone()).unwrap();
        // A hole that is filled is none, and neither is one that two triangles make where they touch.
        let filled = [&triangles[..], &[[0, 1, 2], [0, 2, 3]]].concat();
        assert_eq!(JointTriangulation::from_parts(source.clone(), source.clone(), filled).unwrap().outlines.len(), 1);
        let moved: Vec<_> = source.iter().enumerate().map(|(k, z)| if k < 4 { z + 5.0 } else { *z }).collect();
        assert!(JointTriangulation::from_parts(source, moved, triangles).is_err());
    }

    #[test]
    fn a_node_that_is_no_point_is_found() {
        let mut lost = points(&SQUARE);
        lost[4] = Complex64::new(f64::NAN, 1.0);
        assert!(JointTriangulation::from_parts(points(&SQUARE), lost, FAN.to_vec()).is_err());
    }
}
