//! A map that remembers what it was asked: an eye that moves asks the same pixels of the cortex again and again.

use crate::map::{InvertibleMap, Jet, PlaneMap};
use crate::plane::Complex64;
use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;

/// What was found out: sets of [`WAYS`] points, the newest first; clones share it. Empty before the first question.
#[derive(Clone, Default)]
pub struct Memory(Rc<RefCell<Vec<(Key, Jet)>>>);

/// The bits of a point.
type Key = [u64; 2];

/// A map with a memory of its jets, which are the same to the bit whether they were remembered or not.
#[derive(Clone, Debug)]
pub struct Remembered<M> {
    map: M,
    memory: Memory,
}

/// Points of a set: of more that fall into one the oldest is forgotten.
const WAYS: usize = 4;
/// Sets, as a power of two. Altogether that is 4 MB, more than twice the points of a picture while an eye moves.
const LOG_SETS: u32 = 14;
/// No point has such bits: two different kinds of NaN.
const NO_KEY: Key = [u64::MAX, u64::MAX - 1];

impl<M> Remembered<M> {
    /// The map, of which nothing else may have used the memory.
    #[must_use]
    pub fn new(map: M, memory: Memory) -> Self {
        Self { map, memory }
    }
}

impl fmt::Debug for Memory {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Memory").finish_non_exhaustive()
    }
}

fn key(z: Complex64) -> Key {
    [z.re.to_bits(), z.im.to_bits()]
}

/// Where the set of a point begins.
fn set(key: Key) -> usize {
    let mixed =
        (key[0].wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(26) ^ key[1]).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    WAYS * (mixed >> (u64::BITS - LOG_SETS)) as usize
}

impl<M: PlaneMap> PlaneMap for Remembered<M> {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let mut memory = self.memory.0.borrow_mut();
        if memory.is_empty() {
            memory.resize(WAYS << LOG_SETS, (NO_KEY, Jet::UNDEFINED));
        }
        let (mut places, mut open) = (Vec::new(), Vec::new());
        for (k, (z, jet)) in points.iter().zip(&mut *jets).enumerate() {
            let key = key(*z);
            if let Some((_, known)) = memory[set(key)..][..WAYS].iter().find(|known| known.0 == key) {
                *jet = *known;
            } else {
                places.push(k);
                open.push(*z);
            }
        }
        let mut found = vec![Jet::UNDEFINED; open.len()];
        self.map.jets(&open, &mut found);
        for ((k, z), jet) in places.into_iter().zip(open).zip(found) {
            jets[k] = jet;
            let key = key(z);
            let ways = &mut memory[set(key)..][..WAYS];
            ways.rotate_right(1);
            ways[0] = (key, jet);
        }
    }

    fn inverse_map(&self) -> Option<Box<dyn PlaneMap + '_>> {
        self.map.inverse_map()
    }
}

impl<M: InvertibleMap> InvertibleMap for Remembered<M> {
    fn inverse_jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        self.map.inverse_jets(points, jets);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::map::pointwise;
    use std::cell::Cell;

    /// 1/z, and how many points it was asked for.
    #[derive(Default)]
    struct Counting(Cell<usize>);

    impl PlaneMap for Counting {
        fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
            self.0.set(self.0.get() + points.len());
            pointwise(points, jets, |z| (z != Complex64::ONE).then(|| Jet::analytic(z.inv(), -(z * z).inv())));
        }
    }

    fn bits(jets: &[Jet]) -> Vec<[u64; 6]> {
        let numbers = |jet: &Jet| [jet.value, jet.dz, jet.dzbar].map(|z| [z.re.to_bits(), z.im.to_bits()]);
        jets.iter().map(numbers).map(|[a, b, c]| [a[0], a[1], b[0], b[1], c[0], c[1]]).collect()
    }

    #[test]
    fn what_was_asked_is_not_asked_again() {
        let map = Remembered::new(Counting::default(), Memory::default());
        let points: Vec<_> = (0..100).map(|k| Complex64::new(f64::from(k % 10), -0.0)).collect();
        let ask = |points: &[Complex64]| {
            let (mut found, mut expected) = (vec![Jet::UNDEFINED; points.len()], vec![Jet::UNDEFINED; points.len()]);
            map.jets(points, &mut found);
            Counting::default().jets(points, &mut expected);
            assert_eq!(bits(&found), bits(&expected));
            map.map.0.replace(0)
        };
        assert_eq!(ask(&points[..10]), 10);
        assert_eq!(ask(&points), 0);
        // Beside −0 lies 0, where this map gives other bits.
        assert_eq!(ask(&[Complex64::new(3.0, 0.0)]), 1);
        // A picture's pixels, most of which find room.
        let pixels: Vec<_> =
            (0..20_000).map(|k| Complex64::new(f64::from(k % 200) + 0.5, 0.3 * f64::from(k / 200))).collect();
        assert_eq!(ask(&pixels), pixels.len());
        assert!(ask(&pixels) < pixels.len() / 10);
        let many: Vec<_> = (0..200_000).map(|k| Complex64::new(f64::from(k), 1.0)).collect();
        assert_eq!(ask(&many), many.len());
        assert!(ask(&many) > many.len() / 2);
    }
}
