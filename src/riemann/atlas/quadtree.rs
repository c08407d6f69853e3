//! A quadtree whose leaves are found in constant time.

use crate::plane::Complex64;
use crate::symm::options::Progress;

/// A square of the plane that is split into quarters until every part is something known: a leaf, which carries a number.
#[derive(Clone, Debug)]
pub struct Quadtree {
    corner: Complex64,
    per_side: f64,
    /// Four entries for each split square: a leaf's number with [`LEAF`] set, or where the four entries of a part begin.
    entries: Vec<u32>,
    /// Entries of the squares of a uniform grid with 2^`grid_level` columns: where a search starts.
    grid: Vec<u32>,
    grid_level: u32,
}

/// A square: center and half its side; `level` splits below the root.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    pub center: Complex64,
    pub half: f64,
    pub level: u32,
    /// Where its entry lies.
    pub entry: u32,
}

/// What becomes of a square, `T` being what its quarters should know.
pub enum Step<T> {
    Leaf(u32),
    Split(T),
    /// Decided later.
    Open,
}

const LEAF: u32 = 1 << 31;
/// Squares are not split more often.
pub const MAX_LEVEL: u32 = 30;
const MAX_GRID_LEVEL: u32 = 10;

/// Squares between two reports.
const SQUARES_PER_REPORT: usize = 128;

/// Tells how much of a tree is decided, and decides no more once nobody wants it.
#[derive(Debug, Default)]
pub struct Watch {
    seen: usize,
    /// The share of the whole that is decided.
    done: f64,
    stopped: bool,
}

impl Watch {
    /// What `decide` makes of a square; the leaf `rest` once `progress` has returned false.
    pub fn step<T>(
        &mut self,
        square: Square,
        rest: u32,
        progress: Progress,
        decide: impl FnOnce() -> Step<T>,
    ) -> Step<T> {
        self.stopped = self.stopped || (self.seen.is_multiple_of(SQUARES_PER_REPORT) && !progress("expand", self.done));
        self.seen += 1;
        if self.stopped {
            return Step::Leaf(rest);
        }
        let step = decide();
        if matches!(step, Step::Leaf(_)) {
            self.done += 0.25f64.powi(square.level as i32);
        }
        step
    }
}

/// The middle of the square around points, and half its side: a little more, so that none lies on its edge.
#[must_use]
pub fn square_around(points: &[Complex64]) -> (Complex64, f64) {
    let start = points[0];
    let (low, high) = points.iter().fold((start, start), |(low, high), v| {
        (Complex64::new(low.re.min(v.re), low.im.min(v.im)), Complex64::new(high.re.max(v.re), high.im.max(v.im)))
    });
    let size = high - low;
    (0.5 * (low + high), 0.507 * size.re.max(size.im))
}

impl Quadtree {
    /// A square with nothing decided. Call [`Quadtree::grow`] with its [`Quadtree::root`], then [`Quadtree::finish`].
    #[must_use]
    pub fn new(center: Complex64, half: f64) -> Self {
        let corner = center - Complex64::new(half, half);
        Self { corner, per_side: 0.5 / half, entries: vec![LEAF], grid: Vec::new(), grid_level: 0 }
    }

    /// The whole square.
    #[must_use]
    pub fn root(&self) -> Square {
        let half = 0.5 / self.per_side;
        Square { center: self.corner + Complex64::new(half, half), half, level: 0, entry: 0 }
    }

    /// Asks `decide` about a square, then about the quarters of every square it splits.
    pub fn grow<T: Clone>(&mut self, square: Square, data: T, decide: &mut dyn FnMut(Square, T) -> Step<T>) {
        let mut open = vec![(square, data)];
        while let Some((square, data)) = open.pop() {
            match decide(square, data) {
                Step::Leaf(number) => self.entries[square.entry as usize] = LEAF | number,
                Step::Open => {}
                Step::Split(data) => {
                    let first = self.entries.len() as u32;
                    self.entries[square.entry as usize] = first;
                    self.entries.extend([LEAF; 4]);
                    let half = 0.5 * square.half;
                    for (k, (x, y)) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].into_iter().enumerate() {
                        let center = square.center + Complex64::new(x * half, y * half);
                        let entry = first + k as u32;
                        open.push((Square { center, half, level: square.level + 1, entry }, data.clone()));
                    }
                }
            }
        }
    }

    /// Puts a leaf where a square is.
    pub fn set(&mut self, square: Square, number: u32) {
        self.entries[square.entry as usize] = LEAF | number;
    }

    /// Builds the grid that searches start from.
    pub fn finish(&mut self) {
        self.grid_level = (self.entries.len().max(4).ilog2() / 2 + 1).min(MAX_GRID_LEVEL);
        let side = 1 << self.grid_level;
        let step = 1 << (MAX_LEVEL - self.grid_level);
        self.grid = vec![0; side * side];
        for y in 0..side as u32 {
            for x in 0..side as u32 {
                self.grid[y as usize * side + x as usize] =
                    self.descend(self.entries[0], MAX_LEVEL, x * step, y * step, MAX_LEVEL - self.grid_level);
            }
        }
    }

    /// The number of the leaf that holds `z`; `None` outside the square and for NaN.
    #[inline]
    #[must_use]
    pub fn find(&self, z: Complex64) -> Option<u32> {
        let place = (z - self.corner) * self.per_side;
        let inside = place.re >= 0.0 && place.re < 1.0 && place.im >= 0.0 && place.im < 1.0;
        if !inside {
            return None;
        }
        let scale = (1u32 << MAX_LEVEL) as f64;
        let (x, y) = ((place.re * scale) as u32, (place.im * scale) as u32);
        let shift = MAX_LEVEL - self.grid_level;
        let start = self.grid[(((y >> shift) << self.grid_level) | (x >> shift)) as usize];
        Some(self.descend(start, shift, x, y, 0) & !LEAF)
    }

    /// Follows the bits of x and y below `shift` down to a leaf, or to the bit `last`.
    #[inline]
    fn descend(&self, mut entry: u32, mut shift: u32, x: u32, y: u32, last: u32) -> u32 {
        while entry & LEAF == 0 && shift > last {
            shift -= 1;
            let quarter = (((y >> shift) & 1) << 1) | ((x >> shift) & 1);
            entry = self.entries[(entry + quarter) as usize];
        }
        entry
    }

    /// How many squares were looked at.
    #[must_use]
    pub fn squares(&self) -> usize {
        self.entries.len()
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        4 * (self.entries.len() + self.grid.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_leaf_that_holds_a_point() {
        let mut tree = Quadtree::new(Complex64::new(1.0, -2.0), 3.0);
        let mut squares: Vec<Square> = Vec::new();
        // Fine towards one point.
        let fine = Complex64::new(1.7, -3.1);
        tree.grow(tree.root(), (), &mut |square, ()| {
            let away = (square.center - fine).norm();
            if square.level < 9 && away < 3.0 * square.half {
                return Step::Split(());
            }
            squares.push(square);
            Step::Leaf(squares.len() as u32 - 1)
        });
        tree.finish();
        for k in 0..5000 {
            let share = |a: f64| (f64::from(k) * a).fract();
            let z = Complex64::new(-2.0 + 6.0 * share(0.618_034), -5.0 + 6.0 * share(0.754_878));
            let square = squares[tree.find(z).unwrap() as usize];
            let d = z - square.center;
            assert!(d.re.abs() <= square.half && d.im.abs() <= square.half, "{z} in {square:?}");
        }
        assert_eq!(tree.find(Complex64::new(4.1, 0.0)), None);
        assert_eq!(tree.find(Complex64::new(0.0, f64::NAN)), None);
    }
}
