//! The slits of a canonical region, as the way back has to go around them.

use crate::plane::{Complex64, distance_to_segment};
use std::f64::consts::TAU;

/// Straight slits in the plane of keys. What lies on two sides of one has keys that are near, and nothing else in common; but the
/// rest of a strip, or of the plane, is crossed by straight ways.
#[derive(Clone, Debug, Default)]
pub struct Barriers {
    slits: Vec<[Complex64; 2]>,
    /// Whether keys count modulo 2πi.
    periodic: bool,
    /// So near to a slit nobody knows on which side of it a key lies.
    blur: f64,
}

impl Barriers {
    /// Slits by the keys of their ends, where keys are known but for `blur`.
    #[must_use]
    pub fn new(slits: Vec<[Complex64; 2]>, periodic: bool, blur: f64) -> Self {
        Self { slits, periodic, blur }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.slits.is_empty()
    }

    /// Whether the straight way between two keys, the shortest if they are periodic, leads through a slit, or begins on one. It may
    /// end on one.
    #[must_use]
    pub fn part(&self, mut from: Complex64, to: Complex64) -> bool {
        if self.periodic {
            from.im += TAU * ((to.im - from.im) / TAU).round();
        }
        let (low, high) = (from.im.min(to.im), from.im.max(to.im));
        let blur = self.blur;
        self.copies(low, high).any(|[a, b]| {
            distance_to_segment(from, a, b) < blur
                || crosses([a, b], [from, to]) && distance_to_segment(to, a, b) > blur
        })
    }

    /// How far a key is from the nearest slit.
    #[must_use]
    pub fn distance(&self, key: Complex64, at_most: f64) -> f64 {
        let near = self.copies(key.im - at_most, key.im + at_most);
        near.map(|[a, b]| distance_to_segment(key, a, b)).fold(at_most, f64::min)
    }

    /// The slits that have imaginary parts between these, all copies of each.
    fn copies(&self, low: f64, high: f64) -> impl Iterator<Item = [Complex64; 2]> {
        self.slits.iter().flat_map(move |&[a, b]| {
            let (bottom, top) = (a.im.min(b.im), a.im.max(b.im));
            let turns = if self.periodic {
                ((low - top) / TAU).ceil() as i64..=((high - bottom) / TAU).floor() as i64
            } else {
                0..=0
            };
            turns.map(move |turn| [a, b].map(|end| end + Complex64::new(0.0, TAU * turn as f64)))
        })
    }
}

/// Whether two segments meet. Parallel ones do not.
fn crosses([a, b]: [Complex64; 2], [from, to]: [Complex64; 2]) -> bool {
    let (slit, way) = (b - a, to - from);
    let cross = |u: Complex64, v: Complex64| (u.conj() * v).im;
    let across = cross(slit, way);
    let (along_way, along_slit) = (cross(a - from, slit) / -across, cross(a - from, way) / -across);
    (0.0..=1.0).contains(&along_way) && (0.0..=1.0).contains(&along_slit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_through_slits_are_told_from_ways_around_them() {
        let at = Complex64::new;
        let barriers = Barriers::new(vec![[at(-1.0, 6.0), at(-1.0, 7.0)], [at(-3.0, 2.0), at(-2.0, 2.0)]], true, 1e-9);
        assert!(barriers.part(at(-2.0, 6.5), at(0.0, 6.5)));
        assert!(barriers.part(at(-2.0, 6.5 - TAU), at(0.0, 6.4 - TAU)), "one turn below");
        assert!(barriers.part(at(-2.0, 6.5 + 2.0 * TAU), at(0.0, 6.4 + 2.0 * TAU)), "two above");
        assert!(!barriers.part(at(-2.0, 5.9), at(0.0, 5.9)) && !barriers.part(at(-2.0, 6.5), at(-1.1, 6.5)));
        assert!(barriers.part(at(-2.5, 1.0), at(-2.4, 3.0)) && !barriers.part(at(-1.9, 1.0), at(-1.9, 3.0)));
        assert!(barriers.part(at(-2.5, 2.0), at(-2.5, 3.0)), "who knows on which side");
        assert!(!barriers.part(at(-2.5, 3.0), at(-2.5, 2.0)) && !barriers.part(at(-2.5, 3.0), at(-2.5, 2.0 - 1e-10)));
        assert!((barriers.distance(at(-0.5, 0.4), 9.0) - 0.5).abs() < 1e-12);
        assert_eq!(barriers.distance(at(5.0, 0.4), 0.1), 0.1);
        let plain = Barriers::new(vec![[at(-1.0, 6.0), at(-1.0, 7.0)]], false, 1e-9);
        assert!(!plain.part(at(-2.0, 6.5 - TAU), at(0.0, 6.4 - TAU)) && plain.part(at(-2.0, 6.5), at(0.0, 6.5)));
        assert!(!Barriers::default().part(at(-2.0, 6.5), at(0.0, 6.5)));
    }
}
