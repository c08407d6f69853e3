//! Points of a domain with their keys, from which the way back starts.

use crate::plane::{Complex64, Curve, Domain, sort_by_number};
use std::f64::consts::TAU;

/// Pairs (key, z), found by their keys.
#[derive(Clone, Debug)]
pub struct Seeds {
    pairs: Vec<(Complex64, Complex64)>,
    /// Whether keys count modulo 2πi.
    periodic: bool,
    low: Complex64,
    high: Complex64,
    /// Columns and rows a unit of the key.
    scale: Complex64,
    /// The pairs of each bin, row by row.
    bins: Vec<Vec<u32>>,
}

/// Bins along each side.
const BINS: i64 = 48;
/// Points along each side of the box around the domain.
const GRID: u32 = 40;
/// Places on an edge, as shares of it,
const ALONG: [f64; 9] = [0.001, 0.02, 0.12, 0.3, 0.5, 0.7, 0.88, 0.98, 0.999];
/// how far beside them, as shares of the outline's size,
const BESIDE: [f64; 2] = [1e-3, 0.02];
/// of which places there are about so many at most.
const MOST_ON_BOUNDARY: usize = 6000;

impl Seeds {
    /// Samples a domain, and close to its boundary if the two sides of that are to be told apart; `key` gives the key of a point
    /// of it.
    #[must_use]
    pub fn new(domain: &Domain, periodic: bool, beside: bool, key: &dyn Fn(Complex64) -> Option<Complex64>) -> Self {
        let reduced = |key: Complex64| {
            if periodic { Complex64::new(key.re, key.im.rem_euclid(TAU)) } else { key }
        };
        Self::of(samples(domain, beside).into_iter().filter_map(|z| Some((reduced(key(z)?), z))).collect(), periodic)
    }

    /// Pairs (key, z), where periodic keys' imaginary parts lie in [0, 2π).
    #[must_use]
    pub fn of(pairs: Vec<(Complex64, Complex64)>, periodic: bool) -> Self {
        let ([left, right], [lower, upper]) =
            (core(pairs.iter().map(|(key, _)| key.re)), core(pairs.iter().map(|(key, _)| key.im)));
        let (mut low, mut high) = (Complex64::new(left, lower), Complex64::new(right, upper));
        if periodic {
            (low.im, high.im) = (0.0, TAU);
        }
        let per_unit = |size: f64| if size > 0.0 { BINS as f64 / size } else { 1.0 };
        let scale = Complex64::new(per_unit(high.re - low.re), per_unit(high.im - low.im));
        let mut seeds = Self { pairs, periodic, low, high, scale, bins: vec![Vec::new(); (BINS * BINS) as usize] };
        for index in 0..seeds.pairs.len() {
            let (column, row) = seeds.bin(seeds.pairs[index].0);
            seeds.bins[(row * BINS + column) as usize].push(index as u32);
        }
        seeds
    }

    /// The corners of the box around all keys but those far away from most.
    #[must_use]
    pub fn bounds(&self) -> (Complex64, Complex64) {
        (self.low, self.high)
    }

    fn bin(&self, key: Complex64) -> (i64, i64) {
        let place = key - self.low;
        let along = |x: f64, scale: f64| ((x * scale) as i64).clamp(0, BINS - 1);
        (along(place.re, self.scale.re), along(place.im, self.scale.im))
    }

    /// How far the nearest known key is.
    #[must_use]
    pub fn distance(&self, key: Complex64) -> f64 {
        self.near(key, 1).first().map_or(f64::INFINITY, |(near, _)| self.apart(*near, key).norm())
    }

    fn apart(&self, a: Complex64, b: Complex64) -> Complex64 {
        let mut apart = a - b;
        if self.periodic {
            apart.im -= TAU * (apart.im / TAU).round();
        }
        apart
    }

    /// A few pairs near a key, nearest first.
    #[must_use]
    pub fn near(&self, key: Complex64, count: usize) -> Vec<(Complex64, Complex64)> {
        self.near_where(key, count, &|_| true)
    }

    /// A few pairs near a key, nearest first, of those with keys that will do.
    #[must_use]
    pub fn near_where(
        &self,
        key: Complex64,
        count: usize,
        will_do: &dyn Fn(Complex64) -> bool,
    ) -> Vec<(Complex64, Complex64)> {
        let key = if self.periodic { Complex64::new(key.re, key.im.rem_euclid(TAU)) } else { key };
        let (column, row) = self.bin(key);
        let distance = |other: Complex64| self.apart(other, key).norm_sqr();
        let mut found: Vec<(f64, u32)> = Vec::new();
        let mut last = false;
        for reach in 0..BINS {
            for (dx, dy) in ring(reach) {
                let x = column + dx;
                let y = if self.periodic { (row + dy).rem_euclid(BINS) } else { row + dy };
                if (0..BINS).contains(&x) && (0..BINS).contains(&y) {
                    let bin = &self.bins[(y * BINS + x) as usize];
                    let known = bin.iter().map(|&index| (self.pairs[index as usize].0, index));
                    found.extend(known.filter(|(key, _)| will_do(*key)).map(|(key, index)| (distance(key), index)));
                }
            }
            // One ring more: its bins may hold nearer ones.
            if last {
                break;
            }
            last = found.len() >= count;
        }
        sort_by_number(&mut found, |found| found.0);
        found.dedup_by_key(|(_, index)| *index);
        found.truncate(count);
        found.into_iter().map(|(_, index)| self.pairs[index as usize]).collect()
    }
}

/// Between what numbers lie, but those farther outside of the middle 96 % than these are apart.
fn core(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let mut sorted: Vec<f64> = numbers.collect();
    sort_by_number(&mut sorted, |x| *x);
    let Some((&least, &most)) = sorted.first().zip(sorted.last()) else { return [0.0, 1.0] };
    let [low, high] = [sorted.len() / 50, sorted.len() - 1 - sorted.len() / 50].map(|k| sorted[k]);
    [(2.0 * low - high).max(least), (2.0 * high - low).min(most)]
}

/// The bins that are `reach` away.
fn ring(reach: i64) -> impl Iterator<Item = (i64, i64)> {
    let side = -reach..=reach;
    side.clone()
        .flat_map(move |y| side.clone().map(move |x| (x, y)))
        .filter(move |(x, y)| x.abs().max(y.abs()) == reach)
}

/// Points all over a domain and on its boundary, and `beside` it.
fn samples(domain: &Domain, beside: bool) -> Vec<Complex64> {
    let outlines: Vec<_> = domain.contours().iter().map(|contour| contour.polygon()).collect();
    let (mut low, mut high) = outlines[0].bounds();
    for outline in &outlines {
        let (l, h) = outline.bounds();
        low = Complex64::new(low.re.min(l.re), low.im.min(l.im));
        high = Complex64::new(high.re.max(h.re), high.im.max(h.im));
    }
    let edges: usize = outlines.iter().map(|outline| outline.len()).sum();
    let stride = (edges * ALONG.len() / MOST_ON_BOUNDARY).max(1);
    let mut points = Vec::new();
    for (contour, outline) in domain.contours().iter().zip(&outlines) {
        for edge in 0..outline.len() {
            for t in ALONG.iter().step_by(stride) {
                let (a, b) = outline.edge(edge);
                let z = a + (b - a) * t;
                let z = if contour.curve() == Curve::Polygon { z } else { contour.nearest(z).point };
                points.push(z);
                if beside {
                    // On both sides: what lies outside has no key.
                    let across = Complex64::i() * (b - a) / (b - a).norm() * outline.size();
                    points.extend(BESIDE.iter().flat_map(|share| [z + across * share, z - across * share]));
                }
            }
        }
    }
    let (middle, size) = (0.5 * (low + high), high - low);
    let share = |k: u32| (f64::from(k) + 0.5) / f64::from(GRID) - 0.5;
    let reach = if domain.is_bounded() { 1.0 } else { 2.0 };
    for k in 0..GRID * GRID {
        points.push(middle + Complex64::new(size.re * share(k % GRID), size.im * share(k / GRID)) * reach);
    }
    if let Some(center) = domain.center() {
        // Maps are singular there, or take it to 0.
        const AROUND: u32 = 12;
        const RINGS: i32 = 12;
        let room = (domain.nearest(center).place.point - center).norm();
        for ring in 0..RINGS {
            let at = |k: u32| {
                center + Complex64::from_polar(0.7 * room * 2f64.powi(-ring), TAU * f64::from(k) / f64::from(AROUND))
            };
            points.extend((0..AROUND).map(at));
        }
    }
    if !domain.is_bounded() {
        const AROUND: u32 = 32;
        for ring in 0..12 {
            let radius = size.norm() * 2f64.powi(ring);
            let at = |k: u32| middle + Complex64::from_polar(radius, TAU * f64::from(k) / f64::from(AROUND));
            points.extend((0..AROUND).map(at));
        }
    }
    points
}
