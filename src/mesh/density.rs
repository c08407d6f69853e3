//! Graded density: nodes where the affine pieces would leave the map.

use super::draft::Draft;
use super::ring::RingNode;
use crate::Result;
use crate::plane::Complex64;
use std::collections::HashMap;

/// Each round halves the edges that are too long, so that this many reach 2^-24 of the first spacing.
const MOST_ROUNDS: usize = 24;
/// The first, coarse grid has about this many samples across a region.
const COARSE: f64 = 10.0;

/// Spacing of the grid that a graded mesh starts from, for a region of this area.
pub(super) fn first_spacing(area: f64) -> f64 {
    area.sqrt() / COARSE
}

/// A place where the map is compared with the affine pieces.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Piece {
    /// The middle of an inner edge, its nodes in rising order.
    Edge(u32, u32),
    /// The middle of a boundary edge, by its place in the ring.
    Boundary(u32, u32),
    /// The centroid of a triangle.
    Triangle([u32; 3]),
}

/// The map at the middles of pieces, kept from round to round: most pieces stay as they are.
#[derive(Default)]
pub(super) struct Middles {
    inner: HashMap<Piece, Complex64>,
    boundary: HashMap<Piece, Option<RingNode>>,
}

impl Draft<'_> {
    /// Adds nodes until the map is within `bound` (plane units of the target) of its affine pieces, at the middles of
    /// edges and triangles.
    pub(super) fn refine_to(&mut self, bound: f64, middles: &mut Middles) -> Result<()> {
        for _ in 0..MOST_ROUNDS {
            self.connect()?;
            let pieces = self.pieces();
            self.evaluate(&pieces, middles);
            if self.add_where(&pieces, middles, bound) == 0 {
                break;
            }
        }
        Ok(())
    }

    /// The largest distance, in plane units of the target, between the map and its affine pieces.
    pub(super) fn largest_error(&self, middles: &mut Middles) -> f64 {
        let pieces = self.pieces();
        self.evaluate(&pieces, middles);
        pieces.iter().map(|&piece| self.error(piece, middles)).fold(0.0, f64::max)
    }

    fn pieces(&self) -> Vec<Piece> {
        let mut pieces = Vec::with_capacity(3 * self.triangles.len());
        let next_on_ring = self.next_on_ring();
        for &t in &self.triangles {
            for (p, q) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                if next_on_ring[p as usize] == q {
                    pieces.push(Piece::Boundary(p, q));
                } else if p < q {
                    pieces.push(Piece::Edge(p, q));
                }
            }
            pieces.push(Piece::Triangle(t));
        }
        pieces
    }

    /// Computes the middles that are not known yet.
    fn evaluate(&self, pieces: &[Piece], middles: &mut Middles) {
        let mut new = Vec::new();
        for &piece in pieces {
            match piece {
                Piece::Boundary(p, q) => {
                    middles
                        .boundary
                        .entry(piece)
                        .or_insert_with(|| self.between(self.places[p as usize]?, self.places[q as usize]?));
                }
                _ if middles.inner.contains_key(&piece) => {}
                _ => new.push(piece),
            }
        }
        let points: Vec<_> = new.iter().map(|&piece| mean(&self.source, piece)).collect();
        middles.inner.extend(new.into_iter().zip(self.forward(&points)));
    }

    /// How far the map is from the affine piece at its middle; 0 where the map has no value there.
    fn error(&self, piece: Piece, middles: &Middles) -> f64 {
        let Piece::Boundary(p, q) = piece else {
            let distance = (middles.inner[&piece] - mean(&self.target, piece)).norm();
            return if distance.is_finite() { distance } else { 0.0 };
        };
        let Some(middle) = middles.boundary[&piece] else { return 0.0 };
        let at = |points: &[Complex64], k: u32| points[k as usize];
        let share =
            (middle.source.point - at(&self.source, p)).norm() / (at(&self.source, q) - at(&self.source, p)).norm();
        let affine = at(&self.target, p) + (at(&self.target, q) - at(&self.target, p)) * share;
        (middle.target.point - affine).norm()
    }

    /// Adds the middles of edges that are off by more than `bound`, and of triangles whose edges are all good.
    fn add_where(&mut self, pieces: &[Piece], middles: &Middles, bound: f64) -> usize {
        let off: HashMap<Piece, ()> =
            pieces.iter().filter(|&&piece| self.error(piece, middles) > bound).map(|&piece| (piece, ())).collect();
        let edge_off = |p: u32, q: u32| {
            off.contains_key(&Piece::Edge(p.min(q), p.max(q))) || off.contains_key(&Piece::Boundary(p, q))
        };
        let mut starts = Vec::new();
        let mut nodes = Vec::new();
        for &piece in off.keys() {
            match piece {
                Piece::Boundary(p, _) => starts.push(p),
                Piece::Triangle([a, b, c]) if edge_off(a, b) || edge_off(b, c) || edge_off(c, a) => {}
                _ => nodes.push((mean(&self.source, piece), middles.inner[&piece])),
            }
        }
        nodes.sort_by(|(p, _), (q, _)| (p.re, p.im).partial_cmp(&(q.re, q.im)).unwrap_or(std::cmp::Ordering::Equal));
        starts.sort_unstable();
        self.add_pairs(&nodes) + self.split_boundary(&starts)
    }
}

/// The middle of a piece in one copy.
fn mean(points: &[Complex64], piece: Piece) -> Complex64 {
    let at = |k: u32| points[k as usize];
    match piece {
        Piece::Edge(p, q) | Piece::Boundary(p, q) => 0.5 * (at(p) + at(q)),
        Piece::Triangle([a, b, c]) => (at(a) + at(b) + at(c)) / 3.0,
    }
}
