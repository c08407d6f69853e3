//! Where a map is compared with its affine pieces: in their middles, and towards the corners where it is singular.

use super::draft::Draft;
use super::ring::RingNode;
use super::triangles::edges;
use crate::plane::Complex64;

/// A part of a mesh that one affine map covers.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Facet {
    /// An inner edge, its nodes in rising order.
    Edge(u32, u32),
    /// A boundary edge, in the order of the ring.
    Boundary(u32, u32),
    Triangle([u32; 3]),
}

/// A point of a facet: its middle, or, towards a corner of an outline, a third of the way there. A map that opens or closes
/// a corner is a power of the distance, which leaves its chord farthest near the corner.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Probe {
    pub(super) facet: Facet,
    pub(super) towards: Option<u32>,
}

/// How far towards a corner probes lie, as a share of the distance from a facet's middle.
const NEAR: f64 = 1.0 / 3.0;

impl Facet {
    /// The middle in one copy.
    pub(super) fn middle(self, points: &[Complex64]) -> Complex64 {
        let at = |k: u32| points[k as usize];
        match self {
            Self::Edge(p, q) | Self::Boundary(p, q) => 0.5 * (at(p) + at(q)),
            Self::Triangle([a, b, c]) => (at(a) + at(b) + at(c)) / 3.0,
        }
    }

    /// Length of the longest edge in one copy.
    pub(super) fn extent(self, points: &[Complex64]) -> f64 {
        let length = |p: u32, q: u32| (points[p as usize] - points[q as usize]).norm();
        match self {
            Self::Edge(p, q) | Self::Boundary(p, q) => length(p, q),
            Self::Triangle(t) => edges(t).map(|(p, q)| length(p, q)).into_iter().fold(0.0, f64::max),
        }
    }
}

impl Probe {
    fn middle(facet: Facet) -> Self {
        Self { facet, towards: None }
    }

    /// The point in one copy.
    pub(super) fn place(self, points: &[Complex64]) -> Complex64 {
        let middle = self.facet.middle(points);
        match self.towards {
            None => middle,
            Some(corner) => points[corner as usize] + NEAR * (middle - points[corner as usize]),
        }
    }
}

impl Draft<'_> {
    pub(super) fn probes(&self) -> Vec<Probe> {
        let mut probes = Vec::with_capacity(3 * self.triangles.len());
        let next_on_ring = self.next_on_ring();
        let is_corner: Vec<bool> = self.places.iter().map(|place| place.is_some_and(|p| self.is_corner(p))).collect();
        let mut add = |facet: Facet, nodes: &[u32]| {
            probes.push(Probe::middle(facet));
            let corners = nodes.iter().filter(|&&k| is_corner[k as usize]);
            probes.extend(corners.map(|&corner| Probe { facet, towards: Some(corner) }));
        };
        for &t in &self.triangles {
            for (p, q) in edges(t) {
                if next_on_ring[p as usize] == q {
                    add(Facet::Boundary(p, q), &[p, q]);
                } else if p < q {
                    add(Facet::Edge(p, q), &[p, q]);
                }
            }
            add(Facet::Triangle(t), &t);
        }
        probes
    }

    /// A corner of either outline, where the map may be singular.
    fn is_corner(&self, node: RingNode) -> bool {
        [node.source, node.target].iter().zip(&self.outlines).any(|(place, outline)| outline.is_corner(*place))
    }

    /// A probe's point of the boundary, if it is one of a boundary edge that can be split.
    pub(super) fn on_boundary(&self, probe: Probe) -> Option<RingNode> {
        let Facet::Boundary(p, q) = probe.facet else { return None };
        let share = match probe.towards {
            None => 0.5,
            Some(corner) if corner == p => 0.5 * NEAR,
            Some(_) => 1.0 - 0.5 * NEAR,
        };
        self.between(self.places[p as usize]?, self.places[q as usize]?, share)
    }

    /// The map at probes inside. Where a chord of a curved outline, or rounding, leaves the region, the boundary nearest
    /// to the probe stands in.
    pub(super) fn images(&self, probes: &[Probe]) -> Vec<Complex64> {
        let points: Vec<_> = probes.iter().map(|probe| probe.place(&self.source)).collect();
        let mut images = self.map.forward(&points);
        for (image, &z) in images.iter_mut().zip(&points).filter(|(image, _)| !image.is_finite()) {
            if let Some(point) = self.outlines[0].nearest_outside(z) {
                *image = self.map.boundary_forward(point).point;
            }
        }
        images
    }

    /// How far the map, which takes a probe inside to `image`, is from the affine piece; infinite where it has no value.
    pub(super) fn error_inside(&self, probe: Probe, image: Complex64) -> f64 {
        let distance = (image - probe.place(&self.target)).norm();
        if distance.is_nan() { f64::INFINITY } else { distance }
    }

    /// The same on the boundary; 0 where that cannot be split.
    pub(super) fn error_on_boundary(&self, probe: Probe, point: Option<RingNode>) -> f64 {
        let (Facet::Boundary(p, q), Some(point)) = (probe.facet, point) else { return 0.0 };
        let at = |points: &[Complex64], k: u32| points[k as usize];
        let share =
            (point.source.point - at(&self.source, p)).norm() / (at(&self.source, q) - at(&self.source, p)).norm();
        let affine = at(&self.target, p) + (at(&self.target, q) - at(&self.target, p)) * share;
        (point.target.point - affine).norm()
    }

    /// Whether all of a facet lies within this share of the source's outline.
    pub(super) fn is_shorter(&self, facet: Facet, share: f64) -> bool {
        let bound = share * self.outlines[0].length();
        let at = |k: u32| self.source[k as usize];
        // Most are longer by far, which takes no square root to see.
        let is_longer = |p: u32, q: u32| {
            let d = at(p) - at(q);
            d.re.abs() >= bound || d.im.abs() >= bound
        };
        let is_long = match facet {
            Facet::Edge(p, q) | Facet::Boundary(p, q) => is_longer(p, q),
            Facet::Triangle([a, b, c]) => is_longer(a, b) || is_longer(b, c) || is_longer(c, a),
        };
        !is_long && facet.extent(&self.source) < bound
    }
}
