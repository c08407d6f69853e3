//! Power series of an analytic function in squares of its domain, each made when a point of it is first asked for.

use crate::plane::fourier::transform;
use crate::plane::{Complex64, Domain};
use std::collections::HashMap;
use std::f64::consts::{SQRT_2, TAU};
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// A tree of squares; the squares that lie well inside the domain have a power series.
pub struct Cells {
    low: Complex64,
    size: f64,
    /// Points that no series may come near.
    singular: Vec<Complex64>,
    known: Mutex<HashMap<Place, Square>>,
}

/// Level, column and row.
type Place = (u8, u32, u32);

#[derive(Clone, Debug)]
enum Square {
    /// Its quarters know.
    Split,
    /// Too near to the boundary, and small.
    Near,
    /// In it the function is this series in (z − center)/radius.
    Series(Arc<Series>),
}

#[derive(Debug)]
struct Series {
    center: Complex64,
    radius: f64,
    coefficients: Vec<Complex64>,
}

/// Squares are not smaller than the root's size by more than 2 to this.
const DEEPEST: u8 = 7;
/// The half diagonal of a square is at most this share of the distance from its middle to the boundary,
const SHARE: f64 = 0.4;
/// and samples are taken on a circle of this share, so many:
const SAMPLED: f64 = 0.5;
const SAMPLES: usize = 64;
/// 0.8ᵏ of the samples' rounding and 0.4ᵏ of the function is left of what comes after so many terms.
const TERMS: usize = 38;

impl Cells {
    /// None yet.
    #[must_use]
    pub fn new(domain: &Domain, singular: Vec<Complex64>) -> Self {
        let (mut low, mut high) = domain.contours()[0].outline().bounds();
        for contour in domain.contours() {
            let (l, h) = contour.outline().bounds();
            low = Complex64::new(low.re.min(l.re), low.im.min(l.im));
            high = Complex64::new(high.re.max(h.re), high.im.max(h.im));
        }
        let reach = if domain.is_bounded() { 1.0 } else { 3.0 };
        let size = reach * (high.re - low.re).max(high.im - low.im);
        let corner = 0.5 * (low + high) - Complex64::new(0.5 * size, 0.5 * size);
        Self { low: corner, size, singular, known: Mutex::default() }
    }

    /// (f, f') by the series of the square that holds `z`; `None` beside the boundary and outside. `directly` gives f and f' of
    /// points inside.
    #[must_use]
    pub fn at(
        &self,
        domain: &Domain,
        z: Complex64,
        directly: &dyn Fn(Complex64) -> (Complex64, Complex64),
    ) -> Option<(Complex64, Complex64)> {
        let place = (z - self.low) / self.size;
        let within = |x: f64| (0.0..1.0).contains(&x);
        if !within(place.re) || !within(place.im) {
            return None;
        }
        for level in 0..=DEEPEST {
            let count = f64::from(1u32 << level);
            let square = (level, (place.re * count) as u32, (place.im * count) as u32);
            match self.square(domain, square, directly) {
                Square::Split => {}
                Square::Near => return None,
                Square::Series(series) => return Some(series.at(z)),
            }
        }
        None
    }

    fn square(&self, domain: &Domain, place: Place, directly: &dyn Fn(Complex64) -> (Complex64, Complex64)) -> Square {
        // Whoever panicked while holding it left whole squares.
        let known = self.known.lock().unwrap_or_else(PoisonError::into_inner).get(&place).cloned();
        known.unwrap_or_else(|| {
            let made = self.make(domain, place, directly);
            self.known.lock().unwrap_or_else(PoisonError::into_inner).insert(place, made.clone());
            made
        })
    }

    fn make(
        &self,
        domain: &Domain,
        (level, column, row): Place,
        directly: &dyn Fn(Complex64) -> (Complex64, Complex64),
    ) -> Square {
        let side = self.size / f64::from(1u32 << level);
        let center = self.low + Complex64::new(f64::from(column) + 0.5, f64::from(row) + 0.5) * side;
        let radius = 0.5 * SQRT_2 * side;
        if domain.contains(center) {
            let wall = (domain.nearest(center).place.point - center).norm();
            let room = self.singular.iter().map(|a| (a - center).norm()).fold(wall, f64::min);
            if radius <= SHARE * room {
                return Square::Series(Arc::new(Series::new(center, SAMPLED * room, directly)));
            }
        }
        if level == DEEPEST { Square::Near } else { Square::Split }
    }
}

impl Series {
    /// From samples of f' on a circle, which are single-valued whatever the branch of f.
    fn new(center: Complex64, radius: f64, directly: &dyn Fn(Complex64) -> (Complex64, Complex64)) -> Self {
        let at = |j: usize| directly(center + Complex64::from_polar(radius, TAU * j as f64 / SAMPLES as f64)).1;
        let slopes: Vec<Complex64> = (0..SAMPLES).map(at).collect();
        let spectrum = transform(&slopes);
        let integrated = (1..TERMS).map(|k| spectrum[k - 1] * (radius / (SAMPLES * k) as f64));
        let coefficients = std::iter::once(directly(center).0).chain(integrated).collect();
        Self { center, radius, coefficients }
    }

    fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        let t = (z - self.center) / self.radius;
        let (mut value, mut slope) = (Complex64::ZERO, Complex64::ZERO);
        for c in self.coefficients.iter().rev() {
            slope = slope * t + value;
            value = value * t + c;
        }
        (value, slope / self.radius)
    }
}

impl fmt::Debug for Cells {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Cells").field("low", &self.low).field("size", &self.size).finish_non_exhaustive()
    }
}
