//! Joint triangulation → files of other tools: SVG pictures and Wavefront OBJ.

use super::JointTriangulation;
use crate::plane::{Complex64, Frame, svg_path};
use std::fmt::Write;

/// Side of the square that each copy is drawn into, and the space around it, in SVG units.
const PANEL: f64 = 1000.0;
const MARGIN: f64 = 20.0;

impl JointTriangulation {
    /// Both copies side by side as an SVG document, source on the left, each scaled to a square: inner edges thin, the
    /// outline strong. The groups have the classes `source` and `target`.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let (width, height) = (2.0 * PANEL + 3.0 * MARGIN, PANEL + 2.0 * MARGIN);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" fill=\"none\" stroke=\"#204060\" \
             stroke-linejoin=\"round\">\n"
        );
        let inner = self.inner_edges();
        for (class, points, left) in [("source", &self.source, MARGIN), ("target", &self.target, PANEL + 2.0 * MARGIN)]
        {
            let place = fit(points, left);
            let at = |k: u32| place(points[k as usize]);
            let mut lines = String::new();
            for &(a, b) in &inner {
                let ((x1, y1), (x2, y2)) = (at(a), at(b));
                let _ = write!(lines, "M{x1:.2} {y1:.2}L{x2:.2} {y2:.2}");
            }
            let outline: String =
                self.outlines.iter().map(|ring| svg_path::polyline(ring.iter().map(|&node| at(node)), true)).collect();
            let _ = writeln!(
                svg,
                "<g class=\"{class}\"><path stroke-width=\"0.6\" d=\"{lines}\"/><path stroke-width=\"2.5\" d=\"{outline}\"/></g>"
            );
        }
        svg.push_str("</svg>\n");
        svg
    }

    /// The target copy as a Wavefront OBJ in the plane z = 0, with the source copy as texture coordinates: (0, 0) at the
    /// lower left of `texture`, (1, 1) at its upper right.
    #[must_use]
    pub fn to_obj(&self, texture: &Frame) -> String {
        let mut obj =
            format!("# {} nodes, {} triangles\no joint_triangulation\n", self.source.len(), self.triangles.len());
        let lower_left = texture.center() - 0.5 * Complex64::new(texture.width(), texture.height());
        for w in &self.target {
            let _ = writeln!(obj, "v {} {} 0", w.re, w.im);
        }
        for z in &self.source {
            let from_corner = z - lower_left;
            let _ = writeln!(obj, "vt {} {}", from_corner.re / texture.width(), from_corner.im / texture.height());
        }
        for t in &self.triangles {
            let [a, b, c] = t.map(|k| k + 1);
            let _ = writeln!(obj, "f {a}/{a} {b}/{b} {c}/{c}");
        }
        obj
    }

    /// Each edge between two triangles once.
    fn inner_edges(&self) -> Vec<(u32, u32)> {
        let mut edges: Vec<_> =
            self.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).filter(|(a, b)| a < b).collect();
        let mut next = vec![u32::MAX; self.source.len()];
        for ring in &self.outlines {
            for (k, &node) in ring.iter().enumerate() {
                next[node as usize] = ring[(k + 1) % ring.len()];
            }
        }
        edges.retain(|&(a, b)| next[a as usize] != b && next[b as usize] != a);
        edges
    }
}

/// Plane → SVG units: the points' bounding box into the square panel at `left`, y downwards.
fn fit(points: &[Complex64], left: f64) -> impl Fn(Complex64) -> (f64, f64) {
    let (mut low, mut high) = (points[0], points[0]);
    for z in points {
        low = Complex64::new(low.re.min(z.re), low.im.min(z.im));
        high = Complex64::new(high.re.max(z.re), high.im.max(z.im));
    }
    let size = high - low;
    let scale = PANEL / size.re.max(size.im);
    let middle = 0.5 * (low + high);
    move |z| {
        let d = (z - middle) * scale;
        (left + 0.5 * PANEL + d.re, MARGIN + 0.5 * PANEL - d.im)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh() -> JointTriangulation {
        let square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
        let turned = square.iter().map(|z| z * Complex64::i()).collect();
        let fan = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        JointTriangulation::from_parts(square.to_vec(), turned, fan).unwrap()
    }

    #[test]
    fn svg_draws_each_edge_once_in_both_copies() {
        let svg = mesh().to_svg();
        assert_eq!(svg.matches("<g class").count(), 2);
        assert_eq!(svg.matches('M').count(), 2 * (4 + 1), "{svg}");
        assert!(svg.contains("M20.00 1020.00L1020.00 1020.00L1020.00 20.00L20.00 20.00Z"), "{svg}");
    }

    #[test]
    fn obj_has_the_target_as_vertices_and_the_source_as_texture_coordinates() {
        let frame = Frame::new(Complex64::new(1.0, 1.0), 4.0, [400, 200]).unwrap();
        let obj = mesh().to_obj(&frame);
        let lines: Vec<_> = obj.lines().filter(|line| !line.starts_with('#')).collect();
        assert_eq!(lines[3], "v -2 2 0");
        assert_eq!(lines[1 + 5 + 2], "vt 0.75 1");
        assert_eq!(lines[lines.len() - 4], "f 1/1 2/2 5/5");
    }
}
