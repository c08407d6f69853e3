//! Chains of edges as they are drawn: closed, as polygons, and as what is inside of what.

use super::edge_pieces::flatten;
use super::svg_path::Chain;
use super::{Complex64, Edge};

/// Ends that miss the start by less than this share of a curve's size are meant to meet it.
const RESIDUE: f64 = 1e-3;

/// The straight edges from each of some points to the next, and from the last to the first.
pub(crate) fn lines_through(points: &[Complex64]) -> Vec<Edge> {
    let next = |k: usize| points[(k + 1) % points.len()];
    (0..points.len()).map(|k| Edge::line(points[k], next(k))).collect()
}

/// The polygon of a subpath; of one point if it draws nothing.
#[inline(never)]
pub(super) fn contour(chain: &[Edge], tolerance: f64) -> Vec<Complex64> {
    let tolerance_here = attainable(tolerance, size(chain));
    let mut contour: Vec<Complex64> = chain.first().map(Edge::from).into_iter().collect();
    for edge in chain {
        contour.extend_from_slice(&flatten(edge, tolerance_here));
    }
    contour.dedup();
    close(&mut contour, tolerance);
    contour
}

/// The tolerance, or what the digits of something so large tell apart: to ask for less would only ask for memory.
fn attainable(tolerance: f64, size: f64) -> f64 {
    tolerance.max(1e-9 * size)
}

/// The larger side of the box around a chain.
#[inline(never)]
pub(super) fn size(chain: &[Edge]) -> f64 {
    let side = |coordinate: fn(Complex64) -> f64| {
        let bounds = chain.iter().map(Edge::bounds);
        let (low, high) = bounds.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (a, b)| {
            (coordinate(a).min(low), coordinate(b).max(high))
        });
        (high - low).max(0.0)
    };
    side(|z| z.re).max(side(|z| z.im))
}

/// Takes away a last vertex that is the first, or that misses it by what rounded relative commands leave: no more than the
/// tolerance, and little beside the edges around it.
fn close(contour: &mut Vec<Complex64>, tolerance: f64) {
    while let [first, second, .., before, last] = contour[..] {
        let residue = (last - first).norm();
        if residue > tolerance.min(0.25 * (second - first).norm()).min(0.25 * (last - before).norm()) {
            break;
        }
        contour.pop();
    }
    if contour.len() > 1 && contour.first() == contour.last() {
        contour.pop();
    }
}

/// The closed chain without edges that draw nothing: its end is moved onto its start if it was meant to be there, and joined
/// with it by a line if not.
#[inline(never)]
pub(super) fn closed(chain: &[Edge]) -> Chain {
    let size = size(chain);
    let mut chain: Chain = chain.iter().filter(|edge| edge.size() > 1e-14 * size).copied().collect();
    let (Some(first), Some(last)) = (chain.first().copied(), chain.last().copied()) else { return chain };
    let (start, end) = (first.from(), last.to());
    let near = (RESIDUE * size).min(0.25 * first.size()).min(0.25 * last.size());
    if (end - start).norm() > near {
        chain.push(Edge::line(end, start));
    } else if end != start && last.from() != end {
        // Turned about where it starts; chains of one edge are closed as they are.
        if let (Some(edge), true) = (chain.last_mut(), last.from() != start) {
            *edge = turned_onto(&last, start);
        }
    }
    chain
}

/// An edge turned and stretched about its start, so that it ends at `to`.
fn turned_onto(edge: &Edge, to: Complex64) -> Edge {
    let from = edge.from();
    match edge {
        Edge::Line { .. } => Edge::line(from, to),
        _ => edge.moved(-from).scaled((to - from) / (edge.to() - from)).moved(from),
    }
}

/// Twice the area of a polygon.
pub(super) fn area(polygon: &[Complex64]) -> f64 {
    let next = |k: usize| polygon[(k + 1) % polygon.len()] - polygon[0];
    (0..polygon.len()).map(|k| ((polygon[k] - polygon[0]).conj() * next(k)).im).sum::<f64>().abs()
}

/// Whether a point is inside a polygon, which may cross itself, by the even-odd rule.
pub(super) fn surrounds(polygon: &[Complex64], z: Complex64) -> bool {
    let edges = (0..polygon.len()).map(|k| (polygon[k], polygon[(k + 1) % polygon.len()]));
    let crossed = edges.filter(|(a, b)| {
        (a.im <= z.im) != (b.im <= z.im) && a.re + (b.re - a.re) * ((z.im - a.im) / (b.im - a.im)) > z.re
    });
    crossed.count() % 2 == 1
}
