//! The proof that a joint triangulation is one.

use super::joint::{Evidence, JointTriangulation, Shape};
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
        let outline = outlines.swap_remove(0);
        let polygon = |points: &[Complex64]| {
            let corners: Vec<_> = outline.iter().map(|&k| points[k as usize]).collect();
            Polygon::new(&corners).map(Shape::Polygon)
        };
        let shapes = [polygon(&source)?, polygon(&target)?];
        let magnification = quality::magnification(&source, &target, &triangles);
        let mesh = Self { source, target, triangles, outline, shapes, magnification, evidence: Evidence::default() };
        mesh.validate()?;
        Ok(mesh)
    }

    /// Proves that both copies are triangulations of their outlines: every triangle anticlockwise, every inner edge
    /// shared by exactly two triangles, the outline complete and simple, areas equal to the outlines' areas.
    ///
    /// # Errors
    /// [`crate::Error::InvalidMesh`] with the first thing that is wrong.
    pub fn validate(&self) -> Result<()> {
        // Anticlockwise triangles, glued edge to edge into a disk whose boundary is a simple curve, cannot overlap: the
        // affine pieces make a local homeomorphism that is one-to-one on the boundary, hence everywhere. The area sums
        // say the same a second way.
        check_indices(&self.source, &self.target, &self.triangles)?;
        check_edges(self)?;
        check_copy("source", &self.source, &self.shapes[0], self)?;
        check_copy("target", &self.target, &self.shapes[1], self)
    }
}

/// Every inner edge has two triangles, and the others make the outline: one closed curve around a disk.
fn check_edges(mesh: &JointTriangulation) -> Result<()> {
    let next = boundary_edges(&mesh.triangles)?;
    let ring = &mesh.outline;
    let missing = (0..ring.len()).map(|k| (ring[k], ring[(k + 1) % ring.len()])).find(|(a, b)| next.get(a) != Some(b));
    if let Some(edge) = missing {
        return invalid(format!("edge {edge:?} of the outline is not on the boundary of the triangles"));
    }
    if next.len() != ring.len() {
        return invalid(format!(
            "{} edges have a triangle on one side only; the outline has {}",
            next.len(),
            ring.len()
        ));
    }
    // Euler: a disk has V − E + F = 1, with E = (3F + boundary) / 2.
    let (v, f, b) = (mesh.source.len() as i64, mesh.triangles.len() as i64, ring.len() as i64);
    if 2 * v - (3 * f + b) + 2 * f == 2 {
        Ok(())
    } else {
        invalid(format!("{v} nodes, {f} triangles and {b} boundary edges do not make a disk"))
    }
}

fn check_copy(name: &str, points: &[Complex64], shape: &Shape, mesh: &JointTriangulation) -> Result<()> {
    if let Some(k) = points.iter().position(|z| !z.is_finite()) {
        return invalid(format!("node {k} of the {name} is not finite"));
    }
    if let Some(t) = mesh.triangles.iter().find(|t| orientation(points, **t) <= 0.0) {
        return invalid(format!("triangle {t:?} is flipped or degenerate in the {name}"));
    }
    let outline: Vec<_> = mesh.outline.iter().map(|&k| points[k as usize]).collect();
    let area = match shape {
        Shape::Polygon(polygon) => {
            check_outline(name, &outline, polygon)?;
            polygon.area()
        }
        Shape::Curve => Polygon::new(&outline)?.area(),
        Shape::Disk => {
            check_circle(name, &outline)?;
            outline_area(&outline)
        }
    };
    let sum: f64 = mesh.triangles.iter().map(|t| 0.5 * orientation(points, *t)).sum();
    if (sum - area).abs() > AREA_TOLERANCE * area {
        return invalid(format!("the triangles of the {name} have area {sum}, its outline {area}"));
    }
    Ok(())
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

fn outline_area(outline: &[Complex64]) -> f64 {
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
        mesh.shapes[1] =
            Shape::Polygon(Polygon::new(&points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.1)])).unwrap());
        assert!(mesh.validate().unwrap_err().to_string().contains("of the target"));
        mesh.shapes[1] = Shape::Polygon(Polygon::new(&points(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)])).unwrap());
        assert!(mesh.validate().unwrap_err().to_string().contains("of the target"));
        mesh.shapes[1] = Shape::Disk;
        assert!(mesh.validate().unwrap_err().to_string().contains("leaves the circle"));
    }
}
