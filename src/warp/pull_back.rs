//! Pull-back: the output point p shows the texture at f(p), for any map f of the plane.

use super::coons_patch::{CoonsPatch, log2};
use super::node::{Node, Pair, Scale};
use super::options::{WarpOptions, Wrap};
use super::refine::{LARGEST, SMALLEST, Sight, Square};
use super::render::{Footprints, TexelGrid, each_strip};
use super::strip::{self, Strip};
use super::texture::Texture;
use crate::Result;
use crate::map::PlaneMap;

// A strip is a row of blocks.
const _: () = assert!(strip::ROWS == LARGEST);

/// The footprints of the pull-back of the texture by the map, as if its wrap mode were `wrap`.
pub(super) fn pull_back<M: PlaneMap + ?Sized>(
    map: &M,
    texture: &Texture,
    wrap: Wrap,
    options: &WarpOptions,
    each: &mut dyn FnMut(&Strip),
) -> Result<()> {
    let scale = Scale::new(TexelGrid::new(options.texture, texture), &options.view);
    let sight = Sight { map, view: options.view, scale };
    each_strip(options, &mut PullBack { sight, period: period(texture, wrap) }, each)
}

/// After how many texels a texture of this wrap mode comes back; infinite if it does not.
fn period(texture: &Texture, wrap: Wrap) -> Pair {
    let factor = match wrap {
        Wrap::Transparent | Wrap::Clamp => f64::INFINITY,
        Wrap::Repeat => 1.0,
        Wrap::Mirror => 2.0,
    };
    texture.size().map(|size| factor * size as f64)
}

struct PullBack<'a, M: ?Sized> {
    sight: Sight<'a, M>,
    period: Pair,
}

impl<M: PlaneMap + ?Sized> Footprints for PullBack<'_, M> {
    fn fill(&mut self, strip: &mut Strip) {
        let blocks = self.sight.blocks(strip.first_row / LARGEST * LARGEST);
        for (square, patch) in &blocks.smooth {
            self.draw_patch(strip, patch, square);
        }
        let Sides { mut inside, mut edge } = self.sides(&blocks.ragged, strip);
        inside.extend(pixels_of(&blocks.rough, strip));
        edge.extend(self.draw_pixels(strip, &inside));
        self.draw_edge_pixels(strip, &edge);
    }
}

/// Pixels (column, row of the view) by where they lie.
struct Sides {
    /// Within the domain.
    inside: Vec<(usize, usize)>,
    /// At its edge.
    edge: Vec<(usize, usize)>,
}

/// Samples along each side of a pixel at the edge of the domain. None lies on the pixel's centre or sides, where the
/// singular points of formulas like to be.
const EDGE_SAMPLES: usize = 4;

impl<M: PlaneMap + ?Sized> PullBack<'_, M> {
    fn draw_patch(&self, strip: &mut Strip, patch: &CoonsPatch, square: &Square) {
        let shift = self.shift(patch.corner());
        let count = square.side.min(strip.width - square.x);
        for row in rows_of(square, strip) {
            let y = (row - square.y) as f64 + 0.5;
            patch.draw_row(strip, strip.start(row - strip.first_row) + square.x, count, y, shift);
        }
    }

    /// Whole periods that bring a point of the texture near the origin.
    fn shift(&self, at: Pair) -> Pair {
        std::array::from_fn(|k| {
            let period = self.period[k];
            if period.is_finite() { period * (at[k] / period).floor() } else { 0.0 }
        })
    }

    /// Sorts the pixels of squares by their corners. Of those without a corner inside, what is thinner than they are may still
    /// show something.
    fn sides(&self, squares: &[Square], strip: &Strip) -> Sides {
        const CORNERS: usize = SMALLEST + 1;
        let corner = |square: &Square, k: usize| ((square.x + k % CORNERS) as f64, (square.y + k / CORNERS) as f64);
        let lattice = squares.iter().flat_map(|square| (0..CORNERS * CORNERS).map(move |k| corner(square, k)));
        let nodes = self.sight.nodes(&lattice.collect::<Vec<_>>());
        let mut sides = Sides { inside: Vec::new(), edge: Vec::new() };
        for (square, nodes) in squares.iter().zip(nodes.chunks_exact(CORNERS * CORNERS)) {
            for (column, row) in pixels_of(std::slice::from_ref(square), strip) {
                let first = CORNERS * (row - square.y) + column - square.x;
                let corners = [first, first + 1, first + CORNERS, first + CORNERS + 1];
                let is_inside = corners.iter().all(|k| nodes[*k].is_defined());
                if is_inside { &mut sides.inside } else { &mut sides.edge }.push((column, row));
            }
        }
        sides
    }

    /// Evaluates each pixel at its centre; returns those where that fails.
    fn draw_pixels(&self, strip: &mut Strip, pixels: &[(usize, usize)]) -> Vec<(usize, usize)> {
        let centres: Vec<_> = pixels.iter().map(|&(x, y)| (x as f64 + 0.5, y as f64 + 0.5)).collect();
        let mut failed = Vec::new();
        for (&(column, row), node) in pixels.iter().zip(self.sight.nodes(&centres)) {
            if node.is_regular() {
                self.put(strip, column, row, &node);
            } else {
                failed.push((column, row));
            }
        }
        failed
    }

    /// Takes many samples in each pixel: the best of them is what it shows, their share its alpha.
    fn draw_edge_pixels(&self, strip: &mut Strip, pixels: &[(usize, usize)]) {
        const COUNT: usize = EDGE_SAMPLES * EDGE_SAMPLES;
        let offset = |k: usize| (k as f64 + 0.5) / EDGE_SAMPLES as f64;
        let samples_of = |&(x, y): &(usize, usize)| {
            (0..COUNT).map(move |k| (x as f64 + offset(k % EDGE_SAMPLES), y as f64 + offset(k / EDGE_SAMPLES)))
        };
        let nodes = self.sight.nodes(&pixels.iter().flat_map(samples_of).collect::<Vec<_>>());
        for (&(column, row), nodes) in pixels.iter().zip(nodes.chunks_exact(COUNT)) {
            let inside = nodes.iter().filter(|node| node.is_defined()).count();
            // The samples next to the centre first.
            let order = [5, 6, 9, 10, 1, 2, 4, 7, 8, 11, 13, 14, 0, 3, 12, 15].map(|k| &nodes[k]);
            let shown = order.into_iter().find(|n| n.is_regular()).or(order.into_iter().find(|n| n.is_defined()));
            if let Some(node) = shown {
                self.put(strip, column, row, node);
                // One sample without a value is a point that the map leaves out, not an edge.
                if inside + 1 < COUNT {
                    strip.shares.push((row - strip.first_row, column, inside as f32 / COUNT as f32));
                }
            }
        }
    }

    /// Writes one pixel of the strip.
    fn put(&self, strip: &mut Strip, column: usize, row: usize, node: &Node) {
        let pixel = strip.start(row - strip.first_row) + column;
        let shift = self.shift(node.at);
        strip.u[pixel] = (node.at[0] - shift[0]) as f32;
        strip.v[pixel] = (node.at[1] - shift[1]) as f32;
        if strip.has_levels() {
            strip.level[pixel] = log2(node.stretch() as f32);
        }
        if strip.has_jacobian() {
            let slopes = [node.dx[0], node.dx[1], node.dy[0], node.dy[1]];
            strip.jacobian.iter_mut().zip(slopes).for_each(|(plane, slope)| plane[pixel] = slope as f32);
        }
    }
}

/// The pixels (column, row of the view) of squares, as far as they lie in the strip.
fn pixels_of(squares: &[Square], strip: &Strip) -> Vec<(usize, usize)> {
    let mut pixels = Vec::new();
    for square in squares {
        for row in rows_of(square, strip) {
            pixels.extend((square.x..strip.width.min(square.x + square.side)).map(|column| (column, row)));
        }
    }
    pixels
}

/// Rows of the view that square and strip share.
fn rows_of(square: &Square, strip: &Strip) -> std::ops::Range<usize> {
    square.y.max(strip.first_row)..(square.y + square.side).min(strip.first_row + strip.rows)
}
