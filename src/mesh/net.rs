//! A net over crowded boundary nodes: inner points whose distance from the circle follows the gaps between the nodes.
//!
//! Conformal maps distort a piece of the disk little if it is small against its distance from the circle. So triangles
//! that shrink with that distance keep their orientation in every region, however deep its bays, and the number of
//! points grows only with the logarithm of the smallest gap.

use crate::plane::Complex64;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Gaps between neighbours on the circle differ at most by this factor.
const RATIO: f64 = 3.0;
/// The coarsest cells have an angle of 2π / 2^this.
const COARSEST: u32 = 4;

/// Angles to add between rising `angles` on the circle, the last gap closing at 2π, so that neighbouring gaps differ
/// by no more than a fixed factor. Gaps below `smallest` count as this. In rising order.
pub(super) fn grading(angles: &[f64], smallest: f64) -> Vec<f64> {
    let mut all: Vec<(f64, bool)> = angles.iter().map(|&angle| (angle, false)).collect();
    loop {
        let n = all.len();
        let gap = |k: usize| if k + 1 < n { all[k + 1].0 - all[k].0 } else { TAU - all[k].0 + all[0].0 };
        let mut next = Vec::with_capacity(2 * n);
        for k in 0..n {
            next.push(all[k]);
            let least = gap((k + n - 1) % n).min(gap((k + 1) % n)).max(smallest);
            if gap(k) > RATIO * least {
                next.push((all[k].0 + 0.5 * gap(k), true));
            }
        }
        if next.len() == n {
            return all.into_iter().filter(|(_, added)| *added).map(|(angle, _)| angle).collect();
        }
        all = next;
    }
}

/// Height of a cell's center over the circle, as a share of the cell's width. So low that the triangles between the
/// finest points and the gaps below are about as high as wide.
const HEIGHT: f64 = 0.9;

/// Points of the disk over graded `angles`: the centers of dyadic cells, as wide as they are high, from the size of
/// each gap, or `smallest`, up to the coarsest. Cells of one size lie in a ring, each half as far from the circle as
/// the one within.
pub(super) fn over(angles: &[f64], smallest: f64) -> Vec<Complex64> {
    let mut cells = BTreeSet::new();
    for k in 0..angles.len() {
        let next = if k + 1 < angles.len() { angles[k + 1] } else { TAU + angles[0] };
        let finest = (TAU / (next - angles[k]).max(smallest)).log2().ceil().max(0.0) as u32;
        let turn = (0.5 * (angles[k] + next) / TAU).fract();
        for level in COARSEST..=finest {
            cells.insert((level, (turn * f64::from(level).exp2()) as u64));
        }
    }
    let center = |&(level, cell): &(u32, u64)| {
        let width = TAU * (-f64::from(level)).exp2();
        Complex64::from_polar(1.0 - HEIGHT * width, (cell as f64 + 0.5) * width)
    };
    cells.iter().map(center).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gaps(angles: &[f64]) -> Vec<f64> {
        (0..angles.len())
            .map(|k| if k + 1 < angles.len() { angles[k + 1] - angles[k] } else { TAU - angles[k] + angles[0] })
            .collect()
    }

    #[test]
    fn graded_gaps_are_of_comparable_size() {
        let mut angles = vec![0.0, 1e-7, 2e-7, 1.0, 1.5, 1.500_01, 4.0];
        let added = grading(&angles, 1e-13);
        assert!(added.len() < 200, "{} angles added", added.len());
        angles.extend(added);
        angles.sort_by(f64::total_cmp);
        let gaps = gaps(&angles);
        for k in 0..gaps.len() {
            let ratio = gaps[k] / gaps[(k + 1) % gaps.len()];
            assert!(
                (1.0 / RATIO - 1e-6..=RATIO + 1e-6).contains(&ratio),
                "gaps {} and its neighbour: {ratio}",
                gaps[k]
            );
        }
    }

    #[test]
    fn every_gap_has_a_point_over_it_at_its_own_scale() {
        let mut angles = vec![0.0, 1e-6, 2.0, 4.0];
        angles.extend(grading(&angles.clone(), 1e-13));
        angles.sort_by(f64::total_cmp);
        let net = over(&angles, 1e-13);
        for (angle, gap) in angles.iter().zip(gaps(&angles)).filter(|(_, gap)| *gap < 0.3) {
            let middle = Complex64::cis(angle + 0.5 * gap);
            let nearest = net.iter().map(|w| (w - middle).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 2.0 * gap, "gap {gap}: nearest point at {nearest}");
        }
        assert!(net.iter().all(|w| w.norm() < 1.0));
    }
}
