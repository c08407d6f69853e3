//! Edges as bytes.

use super::edge::Edge;
use super::elliptic_arc::EllipticArc;
use crate::stored::{Reader, Writer};
use crate::{Error, Result};

const LINE: u8 = 0;
const ARC: u8 = 1;
const QUADRATIC: u8 = 2;
const CUBIC: u8 = 3;
/// The fewest bytes that an edge takes: a line.
const LEAST: usize = 1 + 4 * size_of::<f64>();

/// Writes what [`restore`] reads.
pub(super) fn store(edges: &[Edge], to: &mut Writer) {
    to.count(edges.len());
    for edge in edges {
        match edge {
            Edge::Line { from, to: end } => {
                to.case(LINE);
                [from, end].into_iter().for_each(|z| to.point(*z));
            }
            Edge::Arc(arc) => {
                let (points, angles) = arc.parts();
                to.case(ARC);
                points.into_iter().for_each(|z| to.point(z));
                to.numbers(&angles);
            }
            Edge::Quadratic(points) => {
                to.case(QUADRATIC);
                points.iter().for_each(|z| to.point(*z));
            }
            Edge::Cubic(points) => {
                to.case(CUBIC);
                points.iter().for_each(|z| to.point(*z));
            }
        }
    }
}

/// The same edges, to the bit.
///
/// # Errors
/// [`Error::Damaged`].
pub(super) fn restore(from: &mut Reader) -> Result<Vec<Edge>> {
    let count = from.count(LEAST)?;
    (0..count).map(|_| edge(from)).collect()
}

fn edge(from: &mut Reader) -> Result<Edge> {
    Ok(match from.case()? {
        LINE => Edge::Line { from: from.point()?, to: from.point()? },
        ARC => {
            let points = [from.point()?, from.point()?, from.point()?, from.point()?];
            let arc = EllipticArc::from_parts(points, [from.number()?, from.number()?]);
            Edge::Arc(arc.ok_or(Error::Damaged { reason: "an arc in it does not reach its ends" })?)
        }
        QUADRATIC => Edge::Quadratic([from.point()?, from.point()?, from.point()?]),
        CUBIC => Edge::Cubic([from.point()?, from.point()?, from.point()?, from.point()?]),
        _ => return Err(Error::Damaged { reason: "an edge in it is of no kind" }),
    })
}
