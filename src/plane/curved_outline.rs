//! A closed chain of analytic edges.

use super::{Complex64, Edge};
use crate::{Error, Result};
use std::f64::consts::PI;

/// Edges that each start where the last one ends, around a region on their left.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvedOutline {
    edges: Vec<Edge>,
    /// Interior angle where each edge starts, divided by π, in (0, 2).
    alpha: Vec<f64>,
    size: f64,
}

/// Corners of angles nearer to 0 or 2π than this are cusps, in radians.
const CUSP: f64 = 1e-6;
/// Ends that are apart less than this share of the outline's size are one point.
const JOINED: f64 = 1e-9;

impl CurvedOutline {
    /// A chain of edges around a region, in either orientation; one that runs clockwise is turned around.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::InvalidOutline`] for gaps between edges and edges of no length; [`Error::Cusp`].
    pub fn new(edges: &[Edge]) -> Result<Self> {
        let n = edges.len();
        let corners: Vec<(Complex64, Complex64)> = edges.iter().map(Edge::bounds).collect();
        if n == 0 || corners.iter().any(|(low, high)| !low.is_finite() || !high.is_finite()) {
            return Err(Error::NotFinite { what: "The outline".to_string() });
        }
        let low = corners.iter().fold(corners[0].0, |a, (b, _)| Complex64::new(a.re.min(b.re), a.im.min(b.im)));
        let high = corners.iter().fold(corners[0].1, |a, (_, b)| Complex64::new(a.re.max(b.re), a.im.max(b.im)));
        let size = (high.re - low.re).max(high.im - low.im);
        for (k, edge) in edges.iter().enumerate() {
            if (edge.to() - edges[(k + 1) % n].from()).norm() > JOINED * size {
                return Err(wrong(format!("edge {k} does not end where the next one starts")));
            }
            if !edge.start_direction().is_finite() || !edge.end_direction().is_finite() {
                return Err(wrong(format!("edge {k} has no length")));
            }
        }
        let mut edges = edges.to_vec();
        if area(&edges, 0.5 * (low + high)) < 0.0 {
            edges = edges.iter().rev().map(Edge::reversed).collect();
        }
        let mut alpha = Vec::with_capacity(n);
        for k in 0..n {
            let turn = (edges[k].start_direction() * edges[(k + n - 1) % n].end_direction().conj()).arg();
            if turn.abs() > PI - CUSP {
                return Err(Error::Cusp { edge: k, at: edges[k].from() });
            }
            alpha.push(1.0 - turn / PI);
        }
        Ok(Self { edges, alpha, size })
    }

    /// The edges, counter-clockwise.
    #[must_use]
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Interior angle where edge `k` starts, divided by π.
    #[must_use]
    pub fn alpha(&self, k: usize) -> f64 {
        self.alpha[k]
    }

    /// The larger side of the box around it.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The same outline, `by` plane units away.
    #[must_use]
    pub fn moved(&self, by: Complex64) -> Self {
        Self { edges: self.edges.iter().map(|edge| edge.moved(by)).collect(), ..self.clone() }
    }
}

fn wrong(reason: String) -> Error {
    Error::InvalidOutline { reason }
}

/// Twice the area within, positive if counter-clockwise, by 16 chords of each edge.
fn area(edges: &[Edge], middle: Complex64) -> f64 {
    const CHORDS: u32 = 16;
    let chords = edges.iter().flat_map(|edge| {
        (0..CHORDS).map(move |j| {
            let at = |j: u32| edge.point(f64::from(j) / f64::from(CHORDS)) - middle;
            (at(j).conj() * at(j + 1)).im
        })
    });
    chords.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_disk() -> [Edge; 2] {
        let one = Complex64::ONE;
        [Edge::line(-one, one), Edge::circular(Complex64::ZERO, 1.0, 0.0, PI)]
    }

    #[test]
    fn corners_of_a_half_disk_are_right_angles_either_way_around() {
        for edges in [half_disk(), half_disk().map(|edge| edge.reversed())] {
            let edges = if edges[0].from().re < 0.0 { edges } else { [edges[0], edges[1]] };
            let outline = CurvedOutline::new(&edges).unwrap();
            for k in 0..2 {
                assert!((outline.alpha(k) - 0.5).abs() < 1e-15);
            }
            assert_eq!(outline.size(), 2.0);
        }
    }

    #[test]
    fn gaps_and_cusps_are_refused() {
        let [line, arc] = half_disk();
        let gap = [line, arc.moved(Complex64::new(0.0, 0.1))];
        assert!(CurvedOutline::new(&gap).is_err());
        let inner = Edge::circular(Complex64::new(0.5, 0.0), 0.5, PI, -PI);
        let small = Edge::circular(Complex64::new(-0.5, 0.0), 0.5, PI, -PI);
        // Three half circles: the arbelos has cusps.
        let arbelos = [small, inner, arc];
        let error = CurvedOutline::new(&arbelos).unwrap_err();
        assert!(error.to_string().contains("cusp"), "{error}");
    }
}
