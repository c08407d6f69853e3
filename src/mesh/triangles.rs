//! Triangles as triples of node numbers: which way round they go, whether they fit together, what bounds them.

use crate::plane::Complex64;
use crate::{Error, Result};
use robust::{Coord, orient2d};
use std::collections::BTreeMap;

/// Twice the signed area of a triangle; the sign is exact.
pub(super) fn orientation(points: &[Complex64], [a, b, c]: [u32; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|k| points[k as usize]).map(|z| Coord { x: z.re, y: z.im });
    orient2d(a, b, c)
}

/// The directed edges of a triangle.
pub(super) fn edges([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}

/// Triangles that are not anticlockwise in both copies.
pub(super) fn flipped(source: &[Complex64], target: &[Complex64], triangles: &[[u32; 3]]) -> usize {
    let upright = |t: &&[u32; 3]| orientation(source, **t) > 0.0 && orientation(target, **t) > 0.0;
    triangles.len() - triangles.iter().filter(upright).count()
}

/// Both copies have all nodes, and each belongs to a triangle.
pub(super) fn check_indices(source: &[Complex64], target: &[Complex64], triangles: &[[u32; 3]]) -> Result<()> {
    if target.len() != source.len() {
        return invalid(format!("it has {} source nodes but {} target nodes", source.len(), target.len()));
    }
    let mut used = vec![false; source.len()];
    for &k in triangles.iter().flatten() {
        match used.get_mut(k as usize) {
            Some(used) => *used = true,
            None => return invalid(format!("a triangle names node {k} of {}", source.len())),
        }
    }
    match used.iter().position(|used| !used) {
        Some(k) => invalid(format!("node {k} belongs to no triangle")),
        None => Ok(()),
    }
}

/// The closed curves that bound the triangles, each with the triangles on its left: anticlockwise around them,
/// clockwise around a hole. Each starts at its lowest node, and they are in the order of these.
///
/// # Errors
/// [`Error::InvalidMesh`] if two triangles lie on one side of an edge, or boundary curves touch.
pub(super) fn outlines_of(triangles: &[[u32; 3]]) -> Result<Vec<Vec<u32>>> {
    let mut next = boundary_edges(triangles)?;
    let mut outlines = Vec::new();
    while let Some((first, mut node)) = next.pop_first() {
        let mut outline = vec![first];
        while node != first {
            outline.push(node);
            match next.remove(&node) {
                Some(following) => node = following,
                None => return invalid(format!("its boundary ends at node {node}")),
            }
        }
        outlines.push(outline);
    }
    if outlines.is_empty() { invalid("it has no boundary".to_string()) } else { Ok(outlines) }
}

/// The directed edges that have a triangle on their left only, end by start. No edge may have two there.
pub(super) fn boundary_edges(triangles: &[[u32; 3]]) -> Result<BTreeMap<u32, u32>> {
    let nodes = triangles.iter().flatten().max().map_or(0, |&k| k as usize + 1);
    // The ends of the edges that start at each node: few, so that looking through them is fast.
    let mut first = vec![0; nodes + 1];
    triangles.iter().flatten().for_each(|&k| first[k as usize + 1] += 1);
    (0..nodes).for_each(|k| first[k + 1] += first[k]);
    let mut ends = vec![0; 3 * triangles.len()];
    let mut filled = first.clone();
    for (a, b) in triangles.iter().flat_map(|&t| edges(t)) {
        let before = &ends[first[a as usize]..filled[a as usize]];
        if before.contains(&b) {
            return invalid(format!("two triangles lie on the same side of edge {:?}", (a, b)));
        }
        ends[filled[a as usize]] = b;
        filled[a as usize] += 1;
    }
    let ends_of = |k: u32| &ends[first[k as usize]..first[k as usize + 1]];
    let boundary: Vec<_> =
        triangles.iter().flat_map(|&t| edges(t)).filter(|&(a, b)| !ends_of(b).contains(&a)).collect();
    // Not collected: that would compile one more sort.
    let mut next = BTreeMap::new();
    for &(from, to) in &boundary {
        next.insert(from, to);
    }
    if next.len() == boundary.len() { Ok(next) } else { invalid("its boundary touches itself at a node".to_string()) }
}

/// The error of a mesh that is none.
pub(super) fn invalid<T>(reason: String) -> Result<T> {
    Err(Error::InvalidMesh { reason })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ring_of_triangles_has_two_outlines() {
        // A square hole (nodes 0 to 3) in a square (nodes 4 to 7).
        let ring: Vec<_> =
            (0..4).flat_map(|k| [[k + 4, (k + 1) % 4 + 4, k], [(k + 1) % 4 + 4, (k + 1) % 4, k]]).collect();
        assert_eq!(outlines_of(&ring).unwrap(), [vec![0, 3, 2, 1], vec![4, 5, 6, 7]]);
    }

    #[test]
    fn a_closed_surface_has_no_outline() {
        let tetrahedron = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
        assert!(outlines_of(&tetrahedron).unwrap_err().to_string().contains("no boundary"));
    }
}
