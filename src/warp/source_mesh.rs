//! A mesh of the texture's frame, fine where a map bends: what push-forward draws the image of.
//!
//! A quadtree over the frame, split until the map is affine on each cell to ⅛ pixel of the view. Cells whose corners
//! lie on different sheets of the map (a branch cut, a pole) stay inconsistent at any size; they are split until their
//! image is below a pixel and then drawn once for each sheet, so that every sheet reaches up to its cut.

use super::node::Pair;
use crate::map::{Jet, PlaneMap};
use crate::plane::{Complex64, Frame};
use rustc_hash::FxHashMap;

/// The largest distance in the view between the map and its affine pieces, in pixels; also the image of a cell that is
/// not worth splitting.
const TOLERANCE: f64 = 0.125;
/// Cells along each side of the frame before any is split.
const ROOTS: u32 = 16;
/// How often a cell may be split in half.
const DEPTH: u32 = 14;
/// Cells at most: the end of refinement for maps that are wild everywhere.
const MAX_CELLS: usize = 1 << 19;

/// A point of the frame on the lattice of the smallest cells: (0, 0) is the top left corner, (SPAN, SPAN) the bottom
/// right one.
type Spot = [u32; 2];
const SPAN: u32 = ROOTS << DEPTH;

/// A node: what the map makes of a point of the frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertex {
    /// The point of the frame, as shares of its width and height.
    pub share: Pair,
    /// Its image in the view, in pixels.
    pub at: Pair,
    /// Pixels of the view per width of the frame, across it, and per height, down it.
    dx: Pair,
    dy: Pair,
    /// The smaller singular value of the map's Jacobian.
    pub least_stretch: f64,
}

impl Vertex {
    fn is_regular(&self) -> bool {
        self.at.iter().chain(&self.dx).chain(&self.dy).all(|t| t.is_finite())
    }

    /// The same sheet of the map, continued to another point of the frame.
    fn continued(&self, share: Pair) -> Self {
        let (x, y) = (share[0] - self.share[0], share[1] - self.share[1]);
        let at = std::array::from_fn(|k| self.at[k] + x * self.dx[k] + y * self.dy[k]);
        Self { share, at, ..*self }
    }
}

/// Nodes and triangles.
#[derive(Debug, Default)]
pub(super) struct SourceMesh {
    pub vertices: Vec<Vertex>,
    pub triangles: Vec<[u32; 3]>,
}

/// A square of the lattice.
#[derive(Clone, Copy, Debug)]
struct Cell {
    spot: Spot,
    side: u32,
}

impl Cell {
    /// Its nine points: corners, middles of edges, centre, row by row.
    fn points(&self) -> [Spot; 9] {
        let half = self.side / 2;
        std::array::from_fn(|k| [self.spot[0] + half * (k as u32 % 3), self.spot[1] + half * (k as u32 / 3)])
    }
}

/// Meshes the frame for a map as the view shows it.
pub(super) fn source_mesh<M: PlaneMap + ?Sized>(map: &M, frame: &Frame, view: &Frame) -> SourceMesh {
    let mut lattice =
        Lattice { map, frame: *frame, view: *view, mesh: SourceMesh::default(), index: FxHashMap::default() };
    let side = 1 << DEPTH;
    let root = |k: u32| Cell { spot: [k % ROOTS * side, k / ROOTS * side], side };
    let mut cells: Vec<Cell> = (0..ROOTS * ROOTS).map(root).collect();
    let (mut leaves, mut torn) = (Vec::new(), Vec::new());
    let mut total = cells.len();
    while !cells.is_empty() {
        lattice.evaluate(cells.iter().flat_map(Cell::points));
        let mut next = Vec::new();
        for cell in cells {
            match lattice.verdict(&cell, total < MAX_CELLS) {
                Verdict::Affine => leaves.push(cell),
                Verdict::Torn => torn.push(cell),
                Verdict::Hidden => {}
                Verdict::Split => {
                    total += 4;
                    let [_, middle, _, left, centre, ..] = cell.points();
                    let side = cell.side / 2;
                    next.extend([cell.spot, middle, left, centre].map(|spot| Cell { spot, side }));
                }
            }
        }
        cells = next;
    }
    for cell in leaves {
        lattice.add_fan(&cell);
    }
    for cell in torn {
        lattice.add_sheets(&cell);
    }
    lattice.mesh
}

enum Verdict {
    /// The map is affine here to the tolerance.
    Affine,
    /// It may be on smaller cells.
    Split,
    /// It is not on any.
    Torn,
    /// Nothing of it is in the view, or the map is not defined here.
    Hidden,
}

struct Lattice<'a, M: ?Sized> {
    map: &'a M,
    frame: Frame,
    view: Frame,
    mesh: SourceMesh,
    /// Where the vertex of each spot is.
    index: FxHashMap<Spot, u32>,
}

impl<M: PlaneMap + ?Sized> Lattice<'_, M> {
    /// Evaluates the map at those of the spots that are new, all in one call.
    fn evaluate(&mut self, spots: impl Iterator<Item = Spot>) {
        let first = self.mesh.vertices.len();
        let mut shares: Vec<Pair> = Vec::new();
        for spot in spots {
            let next = (first + shares.len()) as u32;
            self.index.entry(spot).or_insert_with(|| {
                shares.push(spot.map(|t| f64::from(t) / f64::from(SPAN)));
                next
            });
        }
        let [columns, rows] = self.frame.pixels().map(|n| n as f64);
        let points: Vec<Complex64> =
            shares.iter().map(|share| self.frame.to_plane(share[0] * columns, share[1] * rows)).collect();
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.map.jets(&points, &mut jets);
        let vertices: Vec<Vertex> = shares.iter().zip(&jets).map(|(&share, jet)| self.vertex(share, jet)).collect();
        self.mesh.vertices.extend(vertices);
    }

    fn vertex(&self, share: Pair, jet: &Jet) -> Vertex {
        let size = self.view.pixel_size();
        let (x, y) = self.view.to_pixels(jet.value);
        let step = |dz: Complex64| [dz.re / size, -dz.im / size];
        // A step down the frame is a step of −i in the plane.
        let dx = step((jet.dz + jet.dzbar) * self.frame.width());
        let dy = step((jet.dzbar - jet.dz) * Complex64::i() * self.frame.height());
        Vertex { share, at: [x, y], dx, dy, least_stretch: (jet.dz.norm() - jet.dzbar.norm()).abs() }
    }

    fn vertex_at(&self, spot: Spot) -> &Vertex {
        &self.mesh.vertices[self.index[&spot] as usize]
    }

    fn verdict(&self, cell: &Cell, may_split: bool) -> Verdict {
        let nodes = cell.points().map(|spot| *self.vertex_at(spot));
        let regular = nodes.iter().filter(|node| node.is_regular()).count();
        let may_split = may_split && cell.side > 2;
        if regular < nodes.len() {
            // Undefined at one of nine points, or at all: the edge of the domain may still pass between them.
            let coarse = cell.side > 1 << (DEPTH - 4);
            let worth = may_split && (if regular == 0 { coarse } else { self.image_size(&nodes, cell) > TOLERANCE });
            return if worth { Verdict::Split } else { Verdict::Hidden };
        }
        let seen = self.may_be_seen(&nodes);
        match bend(&nodes) <= TOLERANCE {
            true if seen => Verdict::Affine,
            true => Verdict::Hidden,
            false if may_split && seen && self.image_size(&nodes, cell) > TOLERANCE => Verdict::Split,
            false if seen => Verdict::Torn,
            false => Verdict::Hidden,
        }
    }

    /// How large the image of the cell is by its largest regular derivative, in pixels.
    fn image_size(&self, nodes: &[Vertex; 9], cell: &Cell) -> f64 {
        let share = f64::from(cell.side) / f64::from(SPAN);
        let stretch = |node: &Vertex| node.dx[0].hypot(node.dx[1]).max(node.dy[0].hypot(node.dy[1]));
        share * nodes.iter().filter(|node| node.is_regular()).map(stretch).fold(0.0, f64::max)
    }

    /// False if the cell's image lies outside the view with room to spare: a box around its nodes, as much again on
    /// each side.
    fn may_be_seen(&self, nodes: &[Vertex; 9]) -> bool {
        let pixels = self.view.pixels();
        (0..2).all(|k| {
            let ends = nodes.iter().map(|node| node.at[k]);
            let (low, high) = ends.fold((f64::MAX, f64::MIN), |(low, high), t| (low.min(t), high.max(t)));
            let room = high - low + 1.0;
            high + room >= 0.0 && low - room <= pixels[k] as f64
        })
    }

    /// Triangles from the cell's centre to all vertices on its sides, those of smaller neighbours included, so that
    /// no edge has a gap.
    fn add_fan(&mut self, cell: &Cell) {
        let points = cell.points();
        let centre = self.index[&points[4]];
        let corners = [points[0], points[2], points[8], points[6]];
        let mut rim = Vec::new();
        for k in 0..4 {
            self.walk_edge(corners[k], corners[(k + 1) % 4], &mut rim);
        }
        for k in 0..rim.len() {
            self.mesh.triangles.push([centre, rim[k], rim[(k + 1) % rim.len()]]);
        }
    }

    /// Appends the vertices from `a` to before `b`.
    fn walk_edge(&self, a: Spot, b: Spot, rim: &mut Vec<u32>) {
        let middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        let length = a[0].abs_diff(b[0]).max(a[1].abs_diff(b[1]));
        if length > 1 && self.index.contains_key(&middle) {
            self.walk_edge(a, middle, rim);
            self.walk_edge(middle, b, rim);
        } else {
            rim.push(self.index[&a]);
        }
    }

    /// Draws a cell that is torn apart once for each sheet that its corners lie on, continued over the cell. At a pole
    /// no continuation holds: its image is out of sight.
    fn add_sheets(&mut self, cell: &Cell) {
        let points = cell.points();
        let size = self.image_size(&points.map(|spot| *self.vertex_at(spot)), cell);
        if size > 1.0 {
            return;
        }
        let reach = TOLERANCE + size;
        let corners = [points[0], points[2], points[8], points[6]].map(|spot| *self.vertex_at(spot));
        let mut sheets: Vec<[Vertex; 4]> = Vec::new();
        for (place, corner) in corners.iter().enumerate() {
            let passes = |sheet: &[Vertex; 4]| {
                let (p, q) = (sheet[place].at, corner.at);
                (p[0] - q[0]).hypot(p[1] - q[1]) <= reach
            };
            if !sheets.iter().any(passes) {
                sheets.push(corners.map(|other| corner.continued(other.share)));
            }
        }
        for sheet in sheets {
            let first = self.mesh.vertices.len() as u32;
            self.mesh.vertices.extend(sheet);
            self.mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
}

/// How far the middles lie from where the corners would have them, in pixels.
fn bend(nodes: &[Vertex; 9]) -> f64 {
    let gap = |k: usize, ends: &[usize]| {
        let mean = |axis: usize| ends.iter().map(|&e| nodes[e].at[axis]).sum::<f64>() / ends.len() as f64;
        (nodes[k].at[0] - mean(0)).hypot(nodes[k].at[1] - mean(1))
    };
    let edges = [gap(1, &[0, 2]), gap(3, &[0, 6]), gap(5, &[2, 8]), gap(7, &[6, 8]), gap(4, &[0, 2, 6, 8])];
    edges.into_iter().fold(0.0, f64::max)
}
