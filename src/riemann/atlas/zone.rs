//! Zones of the boundary: half-disks on edges and sectors at corners, in which one real power series gives the map.

use super::super::rounding::ON_BOUNDARY;
use super::walls::{Nearest, Walls};
use crate::plane::Complex64;
use crate::symm::panel::Boundary;

/// A half-disk or sector of the region around a boundary point, and the variable τ that straightens it: τ = (ζ/reach)^(1/α)
/// in the upper half of the unit disk, real on the boundary and positive on the side where the boundary leaves.
#[derive(Clone, Copy, Debug)]
pub struct Zone {
    /// The edge that leaves the point, or on which it lies.
    pub edge: usize,
    /// Distance of the point from the start of that edge; 0 at a corner.
    pub along: f64,
    /// The point (scaled units).
    pub origin: Complex64,
    /// Radius.
    pub reach: f64,
    /// Interior angle divided by π; 1 on an edge.
    pub alpha: f64,
    /// Unit vector along the edge that leaves the point.
    direction: Complex64,
    /// Unit vector along the edge that arrives.
    arriving: Complex64,
    /// direction · e^{iαπ/2}: into the region.
    inward: Complex64,
}

/// Where a point lies with respect to a zone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// It lies in the closed region, at τ.
    At(Complex64),
    Outside,
}

/// The next singularity is at |τ| = 1/SHARE or farther.
pub const SHARE: f64 = 0.4;
/// Zones on an edge meet where they are still this much of their reach from their middles.
const OVERLAP: f64 = 0.75;
/// No zone is smaller than this share of its edge.
const SMALLEST: f64 = 1e-12;

impl Zone {
    fn new(boundary: &Boundary, edge: usize, along: f64, room: f64) -> Self {
        let alpha = if along == 0.0 { boundary.alpha[edge] } else { 1.0 };
        let direction = boundary.directions[edge];
        let arriving = if along == 0.0 { boundary.directions[boundary.previous(edge)] } else { direction };
        Self {
            edge,
            along,
            origin: boundary.vertices[edge] + direction * along,
            reach: room * SHARE.powf(alpha),
            alpha,
            direction,
            arriving,
            inward: direction * Complex64::cis(0.5 * alpha * std::f64::consts::PI),
        }
    }

    /// z → τ, for z within about twice the reach.
    #[inline]
    #[must_use]
    pub fn place(&self, z: Complex64) -> Place {
        let from = z - self.origin;
        let leaving = from * self.direction.conj();
        if self.alpha == 1.0 {
            let tau = leaving / self.reach;
            return match leaving.im {
                height if height > ON_BOUNDARY => Place::At(tau),
                height if height >= -ON_BOUNDARY => Place::At(Complex64::new(tau.re, 0.0)),
                _ => Place::Outside,
            };
        }
        let height = leaving.im;
        let arriving = (from * self.arriving.conj()).im;
        let depth = if self.alpha < 1.0 { height.min(arriving) } else { height.max(arriving) };
        if depth > ON_BOUNDARY {
            return Place::At(self.straighten(from));
        }
        if depth < -ON_BOUNDARY {
            return Place::Outside;
        }
        let size = (from.norm() / self.reach).powf(1.0 / self.alpha);
        let on_leaving = height.abs() <= ON_BOUNDARY && leaving.re >= 0.0;
        Place::At(Complex64::new(if on_leaving { size } else { -size }, 0.0))
    }

    fn straighten(&self, from: Complex64) -> Complex64 {
        let upright = from * self.inward.conj() / self.reach;
        let (log_size, angle) = (0.5 * upright.norm_sqr().ln(), upright.arg());
        Complex64::i() * Complex64::from_polar((log_size / self.alpha).exp(), angle / self.alpha)
    }

    /// dτ/dz at τ = `tau`.
    #[must_use]
    pub fn slope(&self, tau: Complex64) -> Complex64 {
        if self.alpha == 1.0 {
            return self.direction.conj() / self.reach;
        }
        if tau == Complex64::ZERO {
            return Complex64::new(if self.alpha < 1.0 { 0.0 } else { f64::INFINITY }, 0.0);
        }
        // dz/dτ = α (z − origin)/τ.
        tau / (self.offset(tau) * self.alpha)
    }

    /// τ → z.
    #[inline]
    #[must_use]
    pub fn point(&self, tau: Complex64) -> Complex64 {
        self.origin + self.offset(tau)
    }

    /// τ → z − origin.
    #[inline]
    #[must_use]
    pub fn offset(&self, tau: Complex64) -> Complex64 {
        if self.alpha == 1.0 {
            return self.direction * tau * self.reach;
        }
        if tau.im == 0.0 {
            let along = if tau.re >= 0.0 { self.direction } else { -self.arriving };
            return along * (self.reach * tau.re.abs().powf(self.alpha));
        }
        let size = (0.5 * self.alpha * tau.norm_sqr().ln()).exp() * self.reach;
        let angle = (Complex64::new(tau.im, -tau.re)).arg() * self.alpha;
        self.inward * Complex64::from_polar(size, angle)
    }

    /// The edges that bound it.
    #[must_use]
    pub fn edges(&self, boundary: &Boundary) -> [usize; 2] {
        [self.edge, if self.along == 0.0 { boundary.previous(self.edge) } else { self.edge }]
    }

    /// Whether the disk around `center` lies within the reach.
    #[must_use]
    pub fn covers(&self, center: Complex64, radius: f64) -> bool {
        (center - self.origin).norm() + radius <= self.reach
    }

    /// The edge, and the distances from its start and end, of the boundary point at real τ.
    #[must_use]
    pub fn on_edge(&self, boundary: &Boundary, tau: f64) -> (usize, f64, f64) {
        let distance = self.reach * if self.alpha == 1.0 { tau.abs() } else { tau.abs().powf(self.alpha) };
        if tau < 0.0 && self.along == 0.0 {
            let edge = boundary.previous(self.edge);
            return (edge, boundary.lengths[edge] - distance, distance);
        }
        let from_start = self.along + distance.copysign(tau);
        (self.edge, from_start, boundary.lengths[self.edge] - from_start)
    }
}

/// All zones seen from one center, in boundary order.
#[derive(Clone, Debug)]
pub struct Zones {
    /// The corner zone of each edge's start, then the zones along it.
    pub list: Vec<Zone>,
    /// Harmonic measure from vertex 0 to the middle of each.
    pub measures: Vec<f64>,
    /// The first zone of each edge; one more entry at the end.
    starts: Vec<usize>,
}

impl Zones {
    /// Zones that cover the boundary. In the sector that the region has there, nothing comes nearer than `reach`/SHARE^α
    /// to a zone's origin: no vertex, no other wall, none of the points where log f is `singular`, as at the center. `measure`
    /// tells the measure at the middle of a zone.
    #[must_use]
    pub fn new(boundary: &Boundary, walls: &Walls, singular: &[Complex64], measure: impl Fn(&Zone) -> f64) -> Self {
        let n = boundary.len();
        let corners: Vec<Zone> = (0..n)
            .map(|k| {
                let room = walls.room(k, 0.0);
                Zone::new(boundary, k, 0.0, clear_of(singular, boundary.vertices[k], room))
            })
            .collect();
        let mut list = Vec::with_capacity(4 * n);
        let mut starts = vec![0];
        for edge in 0..n {
            list.push(corners[edge]);
            let length = boundary.lengths[edge];
            let begin = OVERLAP * corners[edge].reach;
            let end = length - OVERLAP * corners[boundary.next(edge)].reach;
            fill_edge(boundary, walls, singular, edge, begin, end, &mut list);
            starts.push(list.len());
        }
        let measures = list.iter().map(measure).collect();
        Self { list, measures, starts }
    }

    /// A zone that covers a disk and that no wall of others enters there: a zone may reach across a thin wall, where the region
    /// goes on. `nearest` is the boundary point nearest to the disk's center, `among` are edges that may be near.
    #[must_use]
    pub fn serving(
        &self,
        boundary: &Boundary,
        (walls, among): (&Walls, &[u32]),
        nearest: Nearest,
        center: Complex64,
        radius: f64,
    ) -> Option<usize> {
        let zone = self.covering(boundary, nearest.edge, nearest.along, center, radius)?;
        let own = self.list[zone].edges(boundary);
        (!walls.intrudes(center, radius, among, own)).then_some(zone)
    }

    /// A zone near the boundary point `along` an edge that covers the disk around `center`.
    fn covering(&self, boundary: &Boundary, edge: usize, along: f64, center: Complex64, radius: f64) -> Option<usize> {
        let zones = &self.list[self.starts[edge]..self.starts[edge + 1]];
        let after = self.starts[edge] + zones.partition_point(|zone| zone.along <= along);
        let next_corner = self.starts[boundary.next(edge)];
        let following = if after < self.starts[edge + 1] { after } else { next_corner };
        [after - 1, following, self.starts[edge], next_corner]
            .into_iter()
            .find(|&index| self.list[index].covers(center, radius))
    }
}

/// The room, or the distance to a singular point if that is less.
fn clear_of(singular: &[Complex64], origin: Complex64, room: f64) -> f64 {
    singular.iter().map(|a| (a - origin).norm()).fold(room, f64::min)
}

/// Adds zones for the part of an edge from `begin` to `end`: one, or those of its halves.
fn fill_edge(
    boundary: &Boundary,
    walls: &Walls,
    singular: &[Complex64],
    edge: usize,
    begin: f64,
    end: f64,
    list: &mut Vec<Zone>,
) {
    if end <= begin {
        return;
    }
    let middle = 0.5 * (begin + end);
    let length = boundary.lengths[edge];
    let origin = boundary.vertices[edge] + boundary.directions[edge] * middle;
    let room = walls.room(edge, middle);
    let zone = Zone::new(boundary, edge, middle, clear_of(singular, origin, room));
    if 0.5 * (end - begin) <= OVERLAP * zone.reach || end - begin < SMALLEST * length {
        list.push(zone);
    } else {
        fill_edge(boundary, walls, singular, edge, begin, middle, list);
        fill_edge(boundary, walls, singular, edge, middle, end, list);
    }
}
