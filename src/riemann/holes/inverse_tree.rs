//! The way back: power series of z in squares of the key's plane, and known pairs to start from where no series serves. Each
//! square is decided when a key in it is first asked for.

use super::super::atlas::accuracy::Accuracy;
use super::super::atlas::power_series::Series;
use super::super::lazy_tree::{Decision, LazyTree, Square};
use super::barriers::Barriers;
use super::seeds::Seeds;
use crate::Result;
use crate::plane::Complex64;
use crate::symm::options::Progress;
use std::f64::consts::{SQRT_2, TAU};
use std::sync::LazyLock;

/// A known pair, and dz/dk there.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// k.
    pub key: Complex64,
    /// z.
    pub z: Complex64,
    /// dz/dk.
    pub slope: Complex64,
}

impl Pair {
    /// About where another key leads.
    #[must_use]
    pub fn guess(&self, key: Complex64) -> Complex64 {
        self.z + (key - self.key) * self.slope
    }
}

/// Squares of the plane of keys.
#[derive(Debug)]
pub struct InverseTree {
    /// A square knows a pair near it.
    tree: LazyTree<Option<Pair>, InverseLeaf>,
    /// No key's imaginary part is larger.
    top: f64,
    deepest: u32,
}

#[derive(Debug)]
enum InverseLeaf {
    /// z, as a function of k.
    Series(Series),
    /// A pair not too far away.
    Near(Pair),
    /// No key lies there, as far as anybody knows.
    Nothing,
}

/// What the tree says of a key.
pub enum Origin {
    /// (z, dz/dk).
    Known(Complex64, Complex64),
    /// Newton's method finds it from here.
    Near(Pair),
    /// Nothing is known.
    Unknown,
}

/// What is inverted.
pub struct Inverted<'a> {
    /// Pairs all over the domain.
    pub seeds: &'a Seeds,
    /// What keys lie on two sides of.
    pub barriers: &'a Barriers,
    /// The keys' real parts lie between these.
    pub strip: (f64, f64),
    /// The pair of a key by Newton's method from a point.
    pub newton: &'a dyn Fn(Complex64, Complex64) -> Option<Pair>,
    /// Of the series.
    pub accuracy: Accuracy,
    /// The size of the domain.
    pub size: f64,
}

/// A series is tried in squares of this share of the distance to the strip's edges.
const SHARE_OF_STRIP: f64 = 0.6;
/// Squares are not smaller than the range of the keys' real parts by more than 2 to this,
const DEEPEST: u32 = 6;
/// nor than the whole by more than 2 to these.
const DEEPEST_OF_ALL: (u32, u32) = (9, 12);
/// Squares are empty whose middle is no key, with no known one nearer to it than this many half diagonals.
const EMPTY: f64 = 2.0;
/// Samples on a square's circle.
const SAMPLES: usize = 32;
/// Terms that they tell.
const TERMS: usize = 20;
/// Seeds that are tried.
const CANDIDATES: usize = 2;
static TURNS: LazyLock<[Complex64; SAMPLES]> =
    LazyLock::new(|| std::array::from_fn(|k| Complex64::cis(TAU * k as f64 / SAMPLES as f64)));

impl InverseTree {
    /// Nothing decided yet.
    #[must_use]
    pub fn new(seeds: &Seeds) -> Self {
        let (low, high) = seeds.bounds();
        let size = high - low;
        let half = 0.5 * size.re.max(size.im) * (1.0 + 1e-9);
        let narrow = if size.re > 0.0 { (2.0 * half / size.re).log2().ceil() as u32 } else { 0 };
        let deepest = (narrow + DEEPEST).clamp(DEEPEST_OF_ALL.0, DEEPEST_OF_ALL.1);
        Self { tree: LazyTree::new(low + Complex64::new(half, half), half, None), top: high.im, deepest }
    }

    /// Decides all squares.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was decided by then is kept.
    pub fn fill(&self, inverted: &Inverted, progress: Progress) -> Result<()> {
        self.tree.fill("invert", &|square, known| self.decide(inverted, square, *known), progress)
    }

    /// What is known of a key.
    #[must_use]
    pub fn at(&self, key: Complex64, inverted: &Inverted) -> Origin {
        match self.tree.find(key, &|square, known| self.decide(inverted, square, *known)) {
            Some(InverseLeaf::Series(series)) => {
                let (z, slope) = series.at(key);
                Origin::Known(z, slope)
            }
            Some(InverseLeaf::Near(pair)) => Origin::Near(*pair),
            Some(InverseLeaf::Nothing) | None => Origin::Unknown,
        }
    }

    fn decide(&self, inverted: &Inverted, square: &Square, known: Option<Pair>) -> Decision<Option<Pair>, InverseLeaf> {
        let radius = square.half * SQRT_2;
        let (low, high) = inverted.strip;
        let room = (square.center.re - low).min(high - square.center.re);
        if room < -radius || square.center.im - square.half > self.top {
            return Decision::Leaf(InverseLeaf::Nothing);
        }
        let found = if room > 0.0 { inverted.pair(square.center, known) } else { None };
        if radius <= SHARE_OF_STRIP * room
            && let Some(coefficients) = found.and_then(|pair| inverted.series(&pair, radius))
        {
            return Decision::Leaf(InverseLeaf::Series(Series { center: square.center, radius, coefficients }));
        }
        let known = found.or(known);
        // In a hole there is nothing to be found.
        let is_empty = || found.is_none() && inverted.seeds.distance(square.center) > EMPTY * radius;
        if square.level < self.deepest && !is_empty() {
            return Decision::Split(known);
        }
        Decision::Leaf(known.map_or(InverseLeaf::Nothing, InverseLeaf::Near))
    }
}

impl Inverted<'_> {
    /// The pair of a key, from one not too far away.
    fn pair(&self, key: Complex64, known: Option<Pair>) -> Option<Pair> {
        let is_beside = |other: Complex64| !self.barriers.part(other, key);
        let near = || self.seeds.near_where(key, CANDIDATES, &is_beside).into_iter();
        known
            .filter(|pair| is_beside(pair.key))
            .and_then(|pair| (self.newton)(key, pair.guess(key)))
            .or_else(|| near().find_map(|(_, z)| (self.newton)(key, z)))
    }

    /// The series around a pair, from samples on a circle, if it is accurate: across a slit it is not.
    fn series(&self, middle: &Pair, radius: f64) -> Option<Box<[Complex64]>> {
        if self.barriers.distance(middle.key, 2.0 * radius) < radius {
            return None;
        }
        let mut samples = [Complex64::ZERO; SAMPLES];
        let mut last = *middle;
        for (sample, turn) in samples.iter_mut().zip(*TURNS) {
            let key = middle.key + turn * radius;
            last = (self.newton)(key, last.guess(key))?;
            *sample = last.z - middle.z;
        }
        let mut coefficients = [Complex64::ZERO; TERMS];
        for (k, coefficient) in coefficients.iter_mut().enumerate() {
            let sum: Complex64 = samples.iter().enumerate().map(|(j, z)| z * TURNS[(j * k) % SAMPLES].conj()).sum();
            *coefficient = sum / SAMPLES as f64;
        }
        let (tolerance, noise) = (self.accuracy.tolerance * self.size, self.accuracy.solve_error * middle.slope.norm());
        // What lies inside must be what the circle says.
        let is_whole = coefficients[0].norm() <= tolerance.max(noise);
        if !is_whole {
            return None;
        }
        coefficients[0] += middle.z;
        let count = self
            .accuracy
            .terms_needed(&coefficients, tolerance)
            .or_else(|| self.accuracy.terms_above_noise(&coefficients, noise))?;
        Some(coefficients[..count].into())
    }
}
