//! Polynomials of the inverse of one chart's map.

use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::power_series::{MAX_COEFFICIENTS, rescale, revert};
use super::region_side::RegionSide;
use crate::plane::Complex64;
use std::f64::consts::TAU;

/// A point w of the disk and the z it comes from.
pub type Pair = (Complex64, Complex64);

/// Σ cₖ ((w − center)/radius)ᵏ.
pub struct InverseCell {
    pub center: Complex64,
    pub radius: f64,
    coefficients: [Complex64; MAX_COEFFICIENTS],
    count: usize,
}

impl InverseCell {
    #[must_use]
    pub fn coefficients(&self) -> &[Complex64] {
        &self.coefficients[..self.count]
    }
}

/// Why samples give no polynomial.
enum Unsampled {
    /// They are not all of one chart.
    Foreign,
    /// One was not found.
    Lost,
}

/// Inverts one chart's map around points of its disk.
pub struct Inverter<'a> {
    atlas: &'a Atlas,
    region: &'a RegionSide,
    chart: usize,
    accuracy: Accuracy,
    /// Roots of unity.
    turns: [Complex64; SAMPLES],
}

/// Samples on a cell's circle.
const SAMPLES: usize = 32;
/// A series of the map is taken in this share of the distance to the wall,
const SHARE_OF_WALL: f64 = 0.9;
/// around a point whose image is as near to the middle of the cell as this share of its radius.
const NEAR_MIDDLE: f64 = 0.05;

const MOST_STEPS: usize = 5;
/// Solves with errors above this are linked about as exactly as they are.
const LOOSE: f64 = 1e-7;

/// What the charts' own region sides know of a point.
struct Forward {
    w: Complex64,
    slope: Complex64,
    /// Another chart's cells had to be asked: between two charts lies the error of two solves.
    foreign: bool,
}

impl<'a> Inverter<'a> {
    #[must_use]
    pub fn new(atlas: &'a Atlas, region: &'a RegionSide, chart: usize, accuracy: Accuracy) -> Self {
        let turns = std::array::from_fn(|k| Complex64::cis(TAU * k as f64 / SAMPLES as f64));
        Self { atlas, region, chart, accuracy, turns }
    }

    /// The inverse in the disk around `center`, from a pair not too far away, if one polynomial is accurate there.
    #[must_use]
    pub fn cell(&self, center: Complex64, radius: f64, seed: Pair) -> Option<InverseCell> {
        let (middle, slope) = self.walk(seed, center)?;
        let mut cell = match self.sampled(center, radius, middle, slope) {
            Ok(cell) => cell,
            Err(Unsampled::Foreign) => self.reverted(center, radius, middle)?,
            Err(Unsampled::Lost) => return None,
        };
        let tolerance = self.accuracy.tolerance;
        let noise = self.accuracy.solve_error * slope.norm();
        let coefficients = &cell.coefficients[..cell.count];
        cell.count = self
            .accuracy
            .terms_needed(coefficients, tolerance)
            .or_else(|| self.accuracy.terms_above_noise(coefficients, noise))?;
        Some(cell)
    }

    /// By Fourier's formula from preimages of the circle.
    fn sampled(
        &self,
        center: Complex64,
        radius: f64,
        middle: Complex64,
        slope: Complex64,
    ) -> Result<InverseCell, Unsampled> {
        if self.forward(middle).ok_or(Unsampled::Lost)?.foreign {
            return Err(Unsampled::Foreign);
        }
        let mut z = middle + slope * radius;
        let mut samples = [Complex64::ZERO; SAMPLES];
        for (sample, direction) in samples.iter_mut().zip(self.turns) {
            let w = center + direction * radius;
            let (exact, slope, foreign) = match self.newton(w, z) {
                Some(found) => found,
                None => {
                    let (z, slope) = self.walk((center, middle), w).ok_or(Unsampled::Lost)?;
                    (z, slope, self.forward(z).ok_or(Unsampled::Lost)?.foreign)
                }
            };
            if foreign {
                return Err(Unsampled::Foreign);
            }
            *sample = exact;
            z = exact + slope * direction * (self.turns[1] - 1.0) * radius;
        }
        let count = self.accuracy.cell_terms().min(SAMPLES / 2 + 4);
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        for (k, coefficient) in coefficients[..count].iter_mut().enumerate() {
            let turn = |j: usize| self.turns[(j * k) % SAMPLES].conj();
            let sum: Complex64 = samples.iter().enumerate().map(|(j, z)| (z - middle) * turn(j)).sum();
            *coefficient = sum / SAMPLES as f64;
        }
        coefficients[0] += middle;
        Ok(InverseCell { center, radius, coefficients, count })
    }

    /// By reversion of the chart's own power series around a point near the middle of the preimage, which is improved by
    /// Newton's method because `middle` is only as exact as other charts agree with this one.
    fn reverted(&self, center: Complex64, radius: f64, mut middle: Complex64) -> Option<InverseCell> {
        let count = self.accuracy.cell_terms();
        let mut series = [Complex64::ZERO; MAX_COEFFICIENTS];
        for _ in 0..MOST_STEPS {
            let wall = self.atlas.walls.nearest(middle, &self.atlas.walls.all());
            if !wall.inside {
                return None;
            }
            let reach = SHARE_OF_WALL * wall.distance;
            self.atlas.charts[self.chart].expand(middle, reach, &mut series[..count]);
            let away = (series[0] - center).norm();
            if away <= NEAR_MIDDLE * radius {
                return Some(inverse_of(&series[..count], middle, reach, radius + away));
            }
            middle -= (series[0] - center) / series[1] * reach;
        }
        None
    }

    /// The point over `w`, from a pair not too far away; `None` where another chart had to be asked that is not as exact.
    #[must_use]
    pub fn point(&self, seed: Pair, w: Complex64) -> Option<Complex64> {
        let (z, _) = self.walk(seed, w)?;
        match self.region.patch_at(z) {
            Some(patch) if patch.chart == self.chart => Some(patch.zone.point(patch.straightened(w))),
            _ if !self.forward(z)?.foreign || self.accuracy.solve_error > LOOSE => Some(z),
            _ => None,
        }
    }

    /// From a known pair to the point over `w`, in steps over which the inverse is nearly linear; also dz/dw there.
    fn walk(&self, (mut at, mut z): Pair, w: Complex64) -> Option<(Complex64, Complex64)> {
        let mut slope = self.forward(z)?.slope.inv();
        for _ in 0..200 {
            let room = 0.3 * (1.0 - at.norm_sqr()).min(1.0);
            let step = w - at;
            let length = step.norm();
            let next = if length <= room { w } else { at + step * (room / length) };
            (z, slope, _) = self.newton(next, z + (next - at) * slope)?;
            at = next;
            if next == w {
                return Some((z, slope));
            }
        }
        None
    }

    /// Newton's method for f(z) = w; returns z, dz/dw, and whether the last value was another chart's.
    fn newton(&self, w: Complex64, mut z: Complex64) -> Option<(Complex64, Complex64, bool)> {
        let mut last = f64::INFINITY;
        let noise = self.accuracy.solve_error;
        for _ in 0..20 {
            let value = self.forward(z)?;
            let inverse = value.slope.inv();
            let step = (w - value.w) * inverse;
            let size = step.norm_sqr().sqrt();
            z += step;
            // Quadratic convergence: the next step would be below rounding. Or rounding is all there is, or two expansions
            // that meet here differ by more.
            let converged = size <= 1e-9 && size < 1e-4 * last;
            let stagnates = size >= 0.5 * last && size <= noise.max(1e-12) * inverse.norm().max(1.0);
            if converged || stagnates || size <= 1e-15 {
                return Some((z, inverse, value.foreign));
            }
            if size > 4.0 * last {
                return None;
            }
            last = size;
        }
        None
    }

    fn forward(&self, z: Complex64) -> Option<Forward> {
        let (own, w, slope) = self.region.with_slope(self.atlas, z)?;
        if own == self.chart {
            return Some(Forward { w, slope, foreign: false });
        }
        let link = self.atlas.link(self.chart, own);
        Some(Forward { w: link.apply(w), slope: slope * link.slope(w), foreign: true })
    }
}

/// The inverse of Σ `series`ₖ ((z − middle)/reach)ᵏ around the image of `middle`.
fn inverse_of(series: &[Complex64], middle: Complex64, reach: f64, radius: f64) -> InverseCell {
    let count = series.len();
    let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
    revert(&series[1..], &mut coefficients[1..count]);
    coefficients[1..count].iter_mut().for_each(|c| *c *= reach);
    coefficients[0] = middle;
    rescale(&mut coefficients[..count], radius);
    InverseCell { center: series[0], radius, coefficients, count }
}
