//! Points along a curve, near enough to each other to look smooth.

use crate::plane::Complex64;

/// A line turns by no more than this from a point to the next, in radians.
pub const TURN: f64 = 0.12;

/// Points of a curve, t from 0 to 1, that look smooth when joined: as many `pieces` of the same length in t, and halves of those that
/// turn. `None` if one of the points is nowhere.
#[must_use]
pub fn polyline(pieces: usize, at: &dyn Fn(f64) -> Option<Complex64>) -> Option<Vec<Complex64>> {
    const ROUNDS: usize = 14;
    let first = (0..=pieces).map(|k| k as f64 / pieces as f64);
    let mut points: Vec<(f64, Complex64)> = first.map(|t| Some((t, at(t)?))).collect::<Option<_>>()?;
    for _ in 0..ROUNDS {
        let turns: Vec<bool> = points
            .windows(3)
            .map(|three| ((three[2].1 - three[1].1) * (three[1].1 - three[0].1).conj()).arg().abs() > TURN)
            .collect();
        let rough = |k: usize| turns.get(k).is_some_and(|turn| *turn) || k > 0 && turns[k - 1];
        let mut finer = Vec::with_capacity(2 * points.len());
        for (k, pair) in points.windows(2).enumerate() {
            finer.push(pair[0]);
            if rough(k) {
                let t = 0.5 * (pair[0].0 + pair[1].0);
                finer.push((t, at(t)?));
            }
        }
        finer.push(points[points.len() - 1]);
        if finer.len() == points.len() {
            break;
        }
        points = finer;
    }
    Some(points.into_iter().map(|(_, z)| z).collect())
}
