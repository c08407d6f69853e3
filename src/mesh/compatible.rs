//! Two polygons whose corners correspond → one connectivity that triangulates both (Aronov, Seidel & Souvaine, 1993).
//!
//! Triangulate each by chords, draw both sets of chords into one regular polygon, and cut at their crossings: each face
//! lies in one triangle of either, so that two piecewise affine maps carry it to the one copy and the other. Nothing here
//! shrinks exponentially, as harmonic and conformal maps do behind narrow necks: a crossing is a point of a chord in
//! either copy, and regular polygons have their corners far apart.

use super::connect::{connect, triangulate};
use crate::plane::{Complex64, sort_by, sort_by_number};
use rustc_hash::FxHashSet;
use std::f64::consts::TAU;

/// A polygon, and which of its corners lie on the straight line between their neighbours.
pub(super) struct Corners<'a> {
    pub(super) places: &'a [Complex64],
    pub(super) straight: &'a [bool],
}

/// Nodes beyond the corners, in both copies, and triangles over corners and nodes.
pub(super) struct Compatible {
    pub(super) source: Vec<Complex64>,
    pub(super) target: Vec<Complex64>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// A crossing of a chord of the source and one of the target: how far along each.
#[derive(Clone, Copy)]
struct Crossing {
    source: (usize, f64),
    target: (usize, f64),
}

/// How much straight corners are pushed inwards while chords are chosen, as slopes: what the polygon's shape allows.
const PUSHES: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-8];

/// `None` if a polygon is not simple and anticlockwise.
pub(super) fn compatible(source: &Corners, target: &Corners) -> Option<Compatible> {
    let n = source.places.len();
    let chords = [chords_of(source)?, chords_of(target)?];
    let corners: Vec<_> = (0..n).map(|k| Complex64::cis(TAU * k as f64 / n as f64)).collect();
    let crossings = crossings(&corners, &chords);
    let mut points = corners.clone();
    points.extend(crossings.iter().map(|c| along(&corners, chords[0][c.source.0], c.source.1)));
    let mut edges: FxHashSet<[usize; 2]> = (0..n).map(|k| sorted([k, (k + 1) % n])).collect();
    for (copy, chords) in chords.iter().enumerate() {
        for (index, &[a, b]) in chords.iter().enumerate() {
            let place = |c: &Crossing| if copy == 0 { c.source } else { c.target };
            let mut stops: Vec<_> = (0..crossings.len())
                .filter(|&k| place(&crossings[k]).0 == index)
                .map(|k| (place(&crossings[k]).1, n + k))
                .collect();
            sort_by_number(&mut stops, |stop| stop.0);
            let path: Vec<_> = [a].into_iter().chain(stops.into_iter().map(|(_, node)| node)).chain([b]).collect();
            edges.extend(path.windows(2).map(|pair| sorted([pair[0], pair[1]])));
        }
    }
    let mut edges: Vec<_> = edges.into_iter().collect();
    sort_by(&mut edges, Ord::cmp);
    let triangles = triangulate(&points, edges).ok()?;
    Some(Compatible {
        source: crossings.iter().map(|c| along(source.places, chords[0][c.source.0], c.source.1)).collect(),
        target: crossings.iter().map(|c| along(target.places, chords[1][c.target.0], c.target.1)).collect(),
        triangles,
    })
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

fn along(corners: &[Complex64], [a, b]: [usize; 2], share: f64) -> Complex64 {
    corners[a] + (corners[b] - corners[a]) * share
}

/// The chords of a triangulation of the polygon in which no triangle has three corners on a straight line.
fn chords_of(ring: &Corners) -> Option<Vec<[usize; 2]>> {
    let n = ring.places.len();
    let indices: Vec<u32> = (0..n as u32).collect();
    PUSHES.iter().find_map(|&push| {
        let corners = pushed(ring, push);
        let area: f64 = (0..n).map(|k| (corners[k].conj() * corners[(k + 1) % n]).im).sum();
        let triangles = connect(&corners, &indices).ok().filter(|t| area > 0.0 && t.len() + 2 == n)?;
        let edges = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        Some(
            edges
                .map(|(a, b)| [a as usize, b as usize])
                .filter(|[a, b]| a < b && b - a > 1 && (*a, *b) != (0, n - 1))
                .collect(),
        )
    })
}

/// The polygon with its straight runs bent inwards: the direction turns a little at each of their corners, however close
/// together they are.
fn pushed(ring: &Corners, push: f64) -> Vec<Complex64> {
    let n = ring.places.len();
    let mut corners = ring.places.to_vec();
    for start in (0..n).filter(|&k| !ring.straight[k] && ring.straight[(k + 1) % n]) {
        let mut run = vec![start];
        while run.len() <= n && (run.len() == 1 || ring.straight[run[run.len() - 1]]) {
            run.push((run[run.len() - 1] + 1) % n);
        }
        let place = |k: usize| ring.places[run[k]];
        let pieces = run.len() - 1;
        let lengths: Vec<_> = (0..pieces).map(|k| (place(k + 1) - place(k)).norm()).collect();
        let slope = |k: usize| push * (1.0 - (2 * k + 1) as f64 / pieces as f64);
        let rise: f64 = (0..pieces).map(|k| slope(k) * lengths[k]).sum();
        let level = rise / lengths.iter().sum::<f64>();
        let inwards = (place(pieces) - place(0)) * Complex64::i() / (place(pieces) - place(0)).norm();
        let mut height = 0.0;
        for k in 1..pieces {
            height += (slope(k - 1) - level) * lengths[k - 1];
            corners[run[k]] += inwards * height;
        }
    }
    corners
}

/// Where chords of one copy cross chords of the other in the regular polygon.
fn crossings(corners: &[Complex64], [source, target]: &[Vec<[usize; 2]>; 2]) -> Vec<Crossing> {
    let cross = |u: Complex64, v: Complex64| (u.conj() * v).im;
    let mut found = Vec::new();
    for (s, &[a, b]) in source.iter().enumerate() {
        for (t, &[c, d]) in target.iter().enumerate() {
            if !(a < c && c < b && b < d || c < a && a < d && d < b) {
                continue;
            }
            let (p, q) = (corners[b] - corners[a], corners[d] - corners[c]);
            let (between, area) = (corners[c] - corners[a], cross(p, q));
            found.push(Crossing { source: (s, cross(between, q) / area), target: (t, cross(between, p) / area) });
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::triangles::orientation;
    use super::*;

    fn check(source: &[(f64, f64)], target: &[(f64, f64)], straight: [&[usize]; 2]) -> usize {
        let points = |xy: &[(f64, f64)]| xy.iter().map(|&(x, y)| Complex64::new(x, y)).collect::<Vec<_>>();
        let flags = |list: &[usize]| (0..source.len()).map(|k| list.contains(&k)).collect::<Vec<_>>();
        let (mut source, mut target) = (points(source), points(target));
        let flags = straight.map(flags);
        let ring = |places, straight| Corners { places, straight };
        let found = compatible(&ring(&source, &flags[0]), &ring(&target, &flags[1])).unwrap();
        source.extend(found.source);
        target.extend(found.target);
        for t in &found.triangles {
            assert!(orientation(&source, *t) > 0.0 && orientation(&target, *t) > 0.0, "{t:?}");
        }
        found.triangles.len()
    }

    const COMB: [(f64, f64); 8] =
        [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (3.0, 3.0), (3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)];
    const ROOF: [(f64, f64); 8] =
        [(0.0, 0.0), (1e-9, 0.0), (2e-9, 0.0), (3e-9, 0.0), (4e-9, 0.0), (5e-9, 0.0), (6e-9, 0.0), (3e-9, 1e-7)];

    #[test]
    fn unlike_polygons_get_one_connectivity() {
        assert_eq!(check(&COMB, &COMB, [&[], &[]]), 6);
        let mut turned = COMB;
        turned.rotate_left(3);
        assert!(check(&COMB, &turned, [&[], &[]]) > 6);
    }

    #[test]
    fn a_pocket_fits_onto_one_edge() {
        check(&COMB, &ROOF, [&[], &[1, 2, 3, 4, 5]]);
        check(&ROOF, &COMB, [&[1, 2, 3, 4, 5], &[]]);
    }

    #[test]
    fn a_polygon_that_is_not_simple_is_refused() {
        let mut crossed = COMB;
        crossed.swap(2, 6);
        let corners = crossed.map(|(x, y)| Complex64::new(x, y));
        let straight = [false; 8];
        let ring = || Corners { places: &corners, straight: &straight };
        assert!(compatible(&ring(), &ring()).is_none());
    }
}
