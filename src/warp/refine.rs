//! Blocks of the view, subdivided until a patch through each one's corners is the map to 1/32 pixel.
//!
//! A block is checked at its centre and the middles of its edges, in value and derivative. A branch cut, a pole or the
//! edge of the domain fails the check at any size, so that what is left over is small and evaluated pixel by pixel.

use super::coons_patch::CoonsPatch;
use super::node::{Node, Pair, Scale};
use crate::map::{Jet, PlaneMap};
use crate::plane::{Complex64, Frame};

/// Side of the largest blocks.
pub(super) const LARGEST: usize = 32;
/// Side of the smallest ones.
pub(super) const SMALLEST: usize = 4;
/// The largest distance between patch and map where it is checked, in texels or in diameters of the footprint, whichever
/// is larger: below 1/32, because the checks need not meet the worst point.
const TOLERANCE: f64 = 1.0 / 48.0;
/// The largest error of the patch's derivatives, likewise: a tenth of a mip level.
const SLOPE_TOLERANCE: f64 = 1.0 / 16.0;

/// A square of pixels of the view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    /// Column of its left side.
    pub x: usize,
    /// Row of its top.
    pub y: usize,
    /// Pixels along each side.
    pub side: usize,
}

/// A square with the nodes at its corners, the middles of its edges and its centre, row by row.
struct Block {
    square: Square,
    nodes: [Node; 9],
}

/// What became of a row of blocks.
#[derive(Default)]
pub(super) struct Blocks {
    /// Squares over which a patch is the map.
    pub smooth: Vec<(Square, CoonsPatch)>,
    /// Squares whose pixels are to be evaluated one by one.
    pub rough: Vec<Square>,
    /// Such squares, all of the smallest size, that reach over the edge of the domain.
    pub ragged: Vec<Square>,
}

impl Block {
    fn patch(&self) -> CoonsPatch {
        CoonsPatch::new([&self.nodes[0], &self.nodes[2], &self.nodes[6], &self.nodes[8]], self.square.side as f64)
    }

    /// The patch, if it agrees with the map at all nodes.
    fn smooth_patch(&self) -> Option<CoonsPatch> {
        if !self.nodes.iter().all(Node::is_regular) {
            return None;
        }
        let patch = self.patch();
        let half = 0.5 * self.square.side as f64;
        let agrees = |k: usize| {
            let (x, y) = (half * (k % 3) as f64, half * (k / 3) as f64);
            close(&patch.node(x, y), &self.nodes[k])
        };
        [1, 3, 4, 5, 7].into_iter().all(agrees).then_some(patch)
    }

    fn is_outside(&self) -> bool {
        !self.nodes.iter().any(Node::is_defined)
    }
}

/// Whether a patch's node is the map's within the tolerances.
fn close(patch: &Node, map: &Node) -> bool {
    let unit = map.stretch().max(1.0);
    let near = |a: Pair, b: Pair, limit: f64| {
        let [x, y] = [a[0] - b[0], a[1] - b[1]];
        x * x + y * y <= limit * limit
    };
    near(patch.at, map.at, TOLERANCE * unit)
        && near(patch.dx, map.dx, SLOPE_TOLERANCE * unit)
        && near(patch.dy, map.dy, SLOPE_TOLERANCE * unit)
}

/// A map seen through a view: points of the view in pixels → nodes.
pub(super) struct Sight<'a, M: ?Sized> {
    pub map: &'a M,
    pub view: Frame,
    pub scale: Scale,
}

impl<M: PlaneMap + ?Sized> Sight<'_, M> {
    /// The map's nodes at points of the view (pixels), all in one call.
    pub fn nodes(&self, points: &[(f64, f64)]) -> Vec<Node> {
        let points: Vec<Complex64> = points.iter().map(|&(x, y)| self.view.to_plane(x, y)).collect();
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.map.jets(&points, &mut jets);
        jets.iter().map(|jet| self.scale.node(jet)).collect()
    }

    /// The row of blocks whose top is row `y` of the view, sorted; nothing where the map has no values.
    pub fn blocks(&self, y: usize) -> Blocks {
        let mut blocks = self.largest_blocks(y);
        let mut sorted = Blocks::default();
        while !blocks.is_empty() {
            let mut unresolved = Vec::new();
            for block in blocks {
                if let Some(patch) = block.smooth_patch() {
                    sorted.smooth.push((block.square, patch));
                } else if block.square.side > SMALLEST {
                    unresolved.push(block);
                } else if block.nodes.iter().all(Node::is_defined) {
                    sorted.rough.push(block.square);
                } else if !block.is_outside() {
                    sorted.ragged.push(block.square);
                }
            }
            blocks = self.quarters(&unresolved);
        }
        sorted
    }

    /// One row of blocks of the largest size: their nodes are a lattice of half that spacing.
    fn largest_blocks(&self, y: usize) -> Vec<Block> {
        let count = self.view.pixels()[0].div_ceil(LARGEST);
        let (columns, half) = (2 * count + 1, LARGEST / 2);
        let point = |k: usize| ((half * (k % columns)) as f64, (y + half * (k / columns)) as f64);
        let lattice = self.nodes(&(0..3 * columns).map(point).collect::<Vec<_>>());
        let block = |k: usize| Block {
            square: Square { x: LARGEST * k, y, side: LARGEST },
            nodes: std::array::from_fn(|n| lattice[columns * (n / 3) + 2 * k + n % 3]),
        };
        (0..count).map(block).collect()
    }

    /// The four quarters of each block, those outside the view left out.
    fn quarters(&self, blocks: &[Block]) -> Vec<Block> {
        let [width, height] = self.view.pixels();
        let mut quarters = Vec::with_capacity(4 * blocks.len());
        for block in blocks {
            let side = block.square.side / 2;
            for quarter in 0..4 {
                let (right, down) = (quarter % 2, quarter / 2);
                let (x, y) = (block.square.x + right * side, block.square.y + down * side);
                if x < width && y < height {
                    // The corners are nodes of the whole block; the others are filled in below.
                    let nodes = std::array::from_fn(|n| block.nodes[3 * (down + n / 6) + right + n % 3 / 2]);
                    quarters.push(Block { square: Square { x, y, side }, nodes });
                }
            }
        }
        const NEW: [usize; 5] = [1, 3, 4, 5, 7];
        let points: Vec<_> = quarters
            .iter()
            .flat_map(|Block { square, .. }| {
                let half = 0.5 * square.side as f64;
                NEW.map(|n| (square.x as f64 + half * (n % 3) as f64, square.y as f64 + half * (n / 3) as f64))
            })
            .collect();
        let nodes = self.nodes(&points);
        for (block, new) in quarters.iter_mut().zip(nodes.chunks_exact(NEW.len())) {
            NEW.iter().zip(new).for_each(|(&n, node)| block.nodes[n] = *node);
        }
        quarters
    }
}
