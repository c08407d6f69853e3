//! Warping by a joint triangulation: the same triangles on two sets of points, affine on each.

use super::options::{Direction, WarpOptions};
use super::outline::{Coverage, OutlineEdge, outline};
use super::raster::{Corner, Overlap, Triangle, span_of};
use super::render::{Footprints, TexelGrid, each_strip};
use super::strip::{self, Strip};
use super::texture::Texture;
use super::warping::Warp;
use crate::plane::{Complex64, Frame};
use crate::{Error, Result};

/// A piecewise affine map source → target: triangles whose corners are given in both.
///
/// Where triangles overlap in the view, later ones cover earlier ones. Either orientation of a triangle is drawn; one
/// with a corner that is not finite is left out.
///
/// ```
/// use conformal_warp::{Complex64, Direction, Frame, Light, Texture, TriangleMesh, Warp, WarpOptions, Wrap};
///
/// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let turned = square.map(|z| z * Complex64::i());
/// let mesh = TriangleMesh { source: &square, target: &turned, triangles: &[[0, 1, 2], [0, 2, 3]], stretch: None };
///
/// let red_over_blue = [[255, 0, 0, 255], [0, 0, 255, 255]].concat();
/// let texture = Texture::new(&red_over_blue, 1, 2, Wrap::Clamp, Light::Linear)?;
/// let frame = Frame::new(Complex64::new(0.0, 0.0), 2.0, [2, 2])?;
/// let mut options = WarpOptions::new(frame, frame);
/// options.direction = Direction::PushForward;
/// let turned_left = mesh.warp(&texture, &options)?;
/// assert_eq!(turned_left[..8], [255, 0, 0, 255, 0, 0, 255, 255]);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TriangleMesh<'a> {
    /// The nodes before the map.
    pub source: &'a [Complex64],
    /// The nodes after the map.
    pub target: &'a [Complex64],
    /// Three nodes each.
    pub triangles: &'a [[u32; 3]],
    /// |f'| at the nodes, if it is known. Otherwise it is averaged from the triangles around each node. Either way
    /// the mip level is interpolated between nodes, so that it has no step at an edge.
    pub stretch: Option<&'a [f64]>,
}

impl Warp for TriangleMesh<'_> {
    fn footprints(&self, texture: &Texture, options: &WarpOptions, each: &mut dyn FnMut(&Strip)) -> Result<()> {
        self.validate()?;
        let (view, shown, towards_view) = match options.direction {
            Direction::PushForward => (self.target, self.source, 1.0),
            Direction::PullBack => (self.source, self.target, -1.0),
        };
        let grid = TexelGrid::new(options.texture, texture);
        let mut corners = corners(view, shown, &options.view, &grid);
        match self.stretch {
            Some(stretch) => {
                let unit = (grid.density() * options.view.pixel_size()).log2();
                let levels = stretch.iter().map(|s| unit - towards_view * s.log2());
                corners.iter_mut().zip(levels).for_each(|(corner, level)| corner.level = level);
            }
            None => set_levels_from_triangles(&mut corners, self.triangles),
        }
        let mut raster = MeshRaster::new(&corners, self.triangles, &options.view, Overlap::Later);
        each_strip(options, &mut raster, each)
    }
}

impl TriangleMesh<'_> {
    /// Checks lengths and node numbers.
    fn validate(&self) -> Result<()> {
        let nodes = self.source.len();
        let lengths =
            [("The target nodes", self.target.len()), ("The stretch", self.stretch.map_or(nodes, <[_]>::len))];
        for (what, found) in lengths {
            if found != nodes {
                return Err(Error::WrongLength { what, expected: nodes.to_string(), found });
            }
        }
        for (triangle, ends) in self.triangles.iter().enumerate() {
            if let Some(&node) = ends.iter().find(|&&node| node as usize >= nodes) {
                return Err(Error::InvalidTriangle { triangle, node, nodes });
            }
        }
        Ok(())
    }
}

/// The nodes in pixels and texels, their levels still 0.
fn corners(view: &[Complex64], shown: &[Complex64], frame: &Frame, grid: &TexelGrid) -> Vec<Corner> {
    let corner = |(&p, &z): (&Complex64, &Complex64)| {
        let ((x, y), [u, v]) = (frame.to_pixels(p), grid.at(z));
        Corner { x, y, u, v, level: 0.0 }
    };
    view.iter().zip(shown).map(corner).collect()
}

/// Sets each node's level to the mean stretch of the triangles around it, weighted by their area in the view.
fn set_levels_from_triangles(corners: &mut [Corner], triangles: &[[u32; 3]]) {
    let mut sums = vec![(0.0, 0.0); corners.len()];
    for ends in triangles {
        let [a, b, c] = ends.map(|node| corners[node as usize]);
        let area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).abs();
        if let Some(triangle) = Triangle::new([a, b, c]) {
            let stretch = largest_stretch(triangle.jacobian());
            for node in ends {
                let (weighted, weight) = &mut sums[*node as usize];
                *weighted += area * stretch;
                *weight += area;
            }
        }
    }
    for (corner, (weighted, weight)) in corners.iter_mut().zip(sums) {
        corner.level = (weighted / weight).log2();
    }
}

/// The larger singular value of [∂u/∂x, ∂v/∂x, ∂u/∂y, ∂v/∂y].
pub(super) fn largest_stretch([ux, vx, uy, vy]: [f64; 4]) -> f64 {
    // `hypot` is ten times slower, for the sake of numbers that no picture has.
    let length = |x: f64, y: f64| (x * x + y * y).sqrt();
    0.5 * (length(ux + vy, vx - uy) + length(ux - vy, vx + uy))
}

/// The triangles of a view, ready to be drawn strip by strip.
pub(super) struct MeshRaster<'a> {
    corners: &'a [Corner],
    triangles: Vec<[u32; 3]>,
    edges: Vec<OutlineEdge>,
    /// Triangles of each strip, in drawing order: those of strip s are `order[starts[s]..starts[s + 1]]`.
    order: Vec<u32>,
    starts: Vec<usize>,
    overlap: Overlap,
}

impl<'a> MeshRaster<'a> {
    pub fn new(corners: &'a [Corner], triangles: &[[u32; 3]], view: &Frame, overlap: Overlap) -> Self {
        let triangles: Vec<_> = triangles.iter().filter_map(|&ends| oriented(corners, ends)).collect();
        let edges = outline(corners.len(), &triangles);
        let (order, starts) = sorted_into_strips(corners, &triangles, view.pixels()[1]);
        Self { corners, triangles, edges, order, starts, overlap }
    }
}

/// The triangle with its corners in the order that gives it positive area; `None` if a corner is not finite.
fn oriented(corners: &[Corner], [a, b, c]: [u32; 3]) -> Option<[u32; 3]> {
    let [p, q, r] = [a, b, c].map(|node| &corners[node as usize]);
    let area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    let shown = [p, q, r].iter().all(|corner| corner.u.is_finite() && corner.v.is_finite());
    (area.is_finite() && shown).then_some(if area < 0.0 { [a, c, b] } else { [a, b, c] })
}

/// Which triangles reach into each strip of the view, by counting sort, which keeps their order.
fn sorted_into_strips(corners: &[Corner], triangles: &[[u32; 3]], height: usize) -> (Vec<u32>, Vec<usize>) {
    let strips = height.div_ceil(strip::ROWS);
    let strips_of = |ends: &[u32; 3]| {
        let ys = ends.map(|node| corners[node as usize].y);
        let (low, high) = span_of(ys);
        let strip = |y: f64| (y.clamp(0.0, height as f64) as usize / strip::ROWS).min(strips);
        if high < 0.0 || low >= height as f64 { 0..0 } else { strip(low)..(strip(high) + 1).min(strips) }
    };
    let mut starts = vec![0; strips + 1];
    for ends in triangles {
        strips_of(ends).for_each(|strip| starts[strip + 1] += 1);
    }
    for strip in 0..strips {
        starts[strip + 1] += starts[strip];
    }
    let mut next = starts.clone();
    let mut order = vec![0; starts[strips]];
    for (index, ends) in triangles.iter().enumerate() {
        for strip in strips_of(ends) {
            order[next[strip]] = index as u32;
            next[strip] += 1;
        }
    }
    (order, starts)
}

impl Footprints for MeshRaster<'_> {
    fn fill(&mut self, strip: &mut Strip) {
        let at = strip.first_row / strip::ROWS;
        for &index in &self.order[self.starts[at]..self.starts[at + 1]] {
            let corners = self.triangles[index as usize].map(|node| self.corners[node as usize]);
            if let Some(triangle) = Triangle::new(corners) {
                triangle.draw(strip, self.overlap);
            }
        }
        let mut coverage = Coverage::new(strip);
        for edge in &self.edges {
            let [a, b] = [edge.from, edge.to].map(|node| self.corners[node as usize]);
            coverage.add_edge([a.x, a.y], [b.x, b.y], |row, columns| {
                for column in columns {
                    if strip.u[strip.start(row) + column].is_nan() {
                        self.fill_fringe(strip, row, column, edge);
                    }
                }
            });
        }
        coverage.partial(&mut strip.shares);
    }
}

impl MeshRaster<'_> {
    /// Gives a pixel whose centre lies just outside what the nearest point of the outline's edge shows.
    fn fill_fringe(&self, strip: &mut Strip, row: usize, column: usize, edge: &OutlineEdge) {
        let [a, b] = [edge.from, edge.to].map(|node| self.corners[node as usize]);
        let (x, y) = (column as f64 + 0.5 - a.x, (strip.first_row + row) as f64 + 0.5 - a.y);
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let share = ((x * dx + y * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        let between = |of: fn(&Corner) -> f64| (of(&a) + share * (of(&b) - of(&a))) as f32;
        let pixel = strip.start(row) + column;
        strip.u[pixel] = between(|corner| corner.u);
        strip.v[pixel] = between(|corner| corner.v);
        if strip.has_levels() {
            strip.level[pixel] = between(|corner| corner.level);
        }
        if strip.has_jacobian() {
            let corners = self.triangles[edge.triangle as usize].map(|node| self.corners[node as usize]);
            let jacobian = Triangle::new(corners).map_or([0.0; 4], |triangle| triangle.jacobian());
            for (plane, slope) in strip.jacobian.iter_mut().zip(jacobian) {
                plane[pixel] = slope as f32;
            }
        }
    }
}
