//! Points of one copy → triangles: a Delaunay triangulation constrained by the outline.

use crate::plane::Complex64;
use crate::{Error, Result};
use spade::handles::{DirectedEdgeHandle, FaceHandle, FixedFaceHandle, InnerTag};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, Point2, Triangulation};

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Face<'a> = FaceHandle<'a, InnerTag, Point2<f64>, (), CdtEdge<()>, ()>;
type Edge<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), CdtEdge<()>, ()>;

/// The triangles inside the closed curve `ring` (indices into `points`, anticlockwise), whose corners are all of
/// `points`. Each triangle is anticlockwise.
///
/// Conformal maps keep angles, so that triangles that are well shaped in one copy are so in the other; the outline
/// as a constraint keeps this copy valid whatever the outline's shape.
///
/// # Errors
/// [`Error::Crowded`] if the curve crosses itself, or two points fall together, once rounded.
pub(super) fn connect(points: &[Complex64], ring: &[u32]) -> Result<Vec<[u32; 3]>> {
    let edges = (0..ring.len()).map(|k| [ring[k] as usize, ring[(k + 1) % ring.len()] as usize]).collect();
    triangulate(points, edges)
}

/// The same for any `edges` that must be there, those of the outline among them.
pub(super) fn triangulate(points: &[Complex64], edges: Vec<[usize; 2]>) -> Result<Vec<[u32; 3]>> {
    let scaling = Scaling::of(points);
    let positions: Vec<_> = points.iter().map(|&z| scaling.apply(z)).collect();
    let mut crossing = None;
    let cdt = Cdt::try_bulk_load_cdt(positions, edges, |[from, _]| crossing = Some(from))
        .map_err(|_| Error::Crowded { at: points[0] })?;
    if let Some(from) = crossing {
        return Err(Error::Crowded { at: points[from.min(points.len() - 1)] });
    }
    if cdt.num_vertices() != points.len() {
        return Err(Error::Crowded { at: first_lost(points, &cdt, scaling) });
    }
    Ok(inside(&cdt))
}

/// Powers of two and a shift that bring the points near the unit square, where predicates cannot overflow.
#[derive(Clone, Copy)]
struct Scaling {
    origin: Complex64,
    factor: f64,
}

impl Scaling {
    fn of(points: &[Complex64]) -> Self {
        let largest = points.iter().map(|z| z.re.abs().max(z.im.abs())).fold(0.0, f64::max);
        let factor = if (1e-20..1e20).contains(&largest) { 1.0 } else { (-largest.log2().floor()).exp2() };
        Self { origin: Complex64::ZERO, factor }
    }

    fn apply(self, z: Complex64) -> Point2<f64> {
        let scaled = (z - self.origin) * self.factor;
        // Smaller coordinates than this are zero beside ones of size 1, and spade does not take them.
        let flush = |x: f64| if x.abs() < 1e-40 { 0.0 } else { x };
        Point2::new(flush(scaled.re), flush(scaled.im))
    }
}

/// The first point that shares its position with an earlier one.
fn first_lost(points: &[Complex64], cdt: &Cdt, scaling: Scaling) -> Complex64 {
    let kept = cdt.vertices().map(|v| v.position());
    let lost = points.iter().zip(kept).find(|(z, kept)| scaling.apply(**z) != *kept);
    *lost.map_or(&points[points.len() - 1], |(z, _)| z)
}

/// The faces that the outline encloses: those that cannot be reached from outside without crossing it.
fn inside(cdt: &Cdt) -> Vec<[u32; 3]> {
    let mut outside = vec![false; cdt.num_all_faces()];
    let mut pending: Vec<Face> = Vec::new();
    let visit =
        |edge: Edge| if edge.is_constraint_edge() { None } else { edge.rev().face().as_inner().map(|f| f.fix()) };
    let mut reach = |face: FixedFaceHandle<InnerTag>| !std::mem::replace(&mut outside[face.index()], true);
    for edge in cdt.convex_hull() {
        // A hull edge has the outer face on its left.
        if let Some(face) = visit(edge).filter(|face| reach(*face)) {
            pending.push(cdt.face(face));
        }
    }
    while let Some(face) = pending.pop() {
        for edge in face.adjacent_edges() {
            if let Some(next) = visit(edge).filter(|face| reach(*face)) {
                pending.push(cdt.face(next));
            }
        }
    }
    cdt.inner_faces()
        .filter(|face| !outside[face.fix().index()])
        .map(|face| face.vertices().map(|v| v.fix().index() as u32))
        .collect()
}
