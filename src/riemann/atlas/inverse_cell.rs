//! Polynomials of the inverse of one chart's map.

use super::super::rounding::is_on_circle;
use super::accuracy::Accuracy;
use super::charts::Atlas;
use super::power_series::{MAX_COEFFICIENTS, rescale, revert};
use super::region_side::{Found, RegionSide};
use crate::plane::Complex64;
use std::f64::consts::TAU;
use std::sync::LazyLock;

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
}

/// Samples on a cell's circle.
const SAMPLES: usize = 32;
/// Roots of unity.
static TURNS: LazyLock<[Complex64; SAMPLES]> =
    LazyLock::new(|| std::array::from_fn(|k| Complex64::cis(TAU * k as f64 / SAMPLES as f64)));
/// A series of the map is taken in this share of the distance to the wall,
const SHARE_OF_WALL: f64 = 0.9;
/// around a point whose image is as near to the middle of the cell as this share of its radius.
const NEAR_MIDDLE: f64 = 0.05;

const MOST_STEPS: usize = 5;
/// Steps of a walk; from the center to the last numbers before the circle there are about 100.
const MOST_WALKED: usize = 200;

/// Where a walk ended.
struct Walk {
    at: Complex64,
    /// The point over `at`.
    z: Complex64,
    /// dz/dw there.
    slope: Complex64,
    reached: bool,
}

/// Region → disk.
type Forwards<'f> = dyn Fn(Complex64) -> Option<Forward> + 'f;

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
        Self { atlas, region, chart, accuracy }
    }

    /// The inverse in the disk around `center`, from a pair not too far away, if one polynomial is accurate there.
    #[must_use]
    pub fn cell(&self, center: Complex64, radius: f64, seed: Pair) -> Option<InverseCell> {
        let Walk { z: middle, slope, reached: true, .. } = self.walk(seed, center) else { return None };
        let mut cell = match self.sampled(center, radius, middle, slope) {
            Ok(cell) => cell,
            Err(Unsampled::Foreign) => self.reverted(center, radius, middle)?,
            Err(Unsampled::Lost) => return None,
        };
        // Of z, but where the map stretches of w.
        let tolerance = self.accuracy.tolerance * slope.norm().min(1.0);
        let noise = self.accuracy.solve_error * slope.norm();
        let coefficients = &cell.coefficients[..cell.count];
        cell.count = self
            .accuracy
            .terms_needed(coefficients, tolerance)
            .or_else(|| self.accuracy.terms_above_noise(coefficients, noise))?;
        Some(cell)
    }

    /// The polynomial by Fourier's formula from preimages of the circle.
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
        for (sample, direction) in samples.iter_mut().zip(*TURNS) {
            let w = center + direction * radius;
            let (exact, slope, foreign) = match self.newton(w, z, &|z| self.forward(z)) {
                Some(found) => found,
                None => {
                    let Walk { z, slope, reached: true, .. } = self.walk((center, middle), w) else {
                        return Err(Unsampled::Lost);
                    };
                    (z, slope, self.forward(z).ok_or(Unsampled::Lost)?.foreign)
                }
            };
            if foreign {
                return Err(Unsampled::Foreign);
            }
            *sample = exact;
            z = exact + slope * direction * (TURNS[1] - 1.0) * radius;
        }
        let count = self.accuracy.cell_terms().min(SAMPLES / 2 + 4);
        let mut coefficients = [Complex64::ZERO; MAX_COEFFICIENTS];
        for (k, coefficient) in coefficients[..count].iter_mut().enumerate() {
            let turn = |j: usize| TURNS[(j * k) % SAMPLES].conj();
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
            let wall = self.atlas.walls.nearest_of_all(middle);
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

    /// Whether the first chart alone tells too little apart over `w`, as far as a walk from a known pair can say.
    #[must_use]
    pub fn is_crowded(&self, seed: Pair, w: Complex64) -> bool {
        let walk = self.walk_by(seed, w, &|z| self.own(z));
        matches!(self.region.with_slope(self.atlas, walk.z), Found::Crowded)
    }

    /// w of the closed disk → (z, dz/dw), from a pair not too far away. Where the region is too crowded to be told apart, the
    /// last point that was found on the way.
    #[must_use]
    pub fn point(&self, seed: Pair, w: Complex64) -> (Complex64, Complex64) {
        if is_on_circle(w) {
            return self.boundary_point(w);
        }
        let found = self.walk(seed, w);
        match self.region.patch_at(found.z) {
            Some(patch) if patch.chart == self.chart && found.reached => patch.preimage(w),
            _ => (found.z, found.slope),
        }
    }

    fn boundary_point(&self, w: Complex64) -> (Complex64, Complex64) {
        let z = self.atlas.charts[self.chart].boundary_point(w.arg() / TAU);
        match self.region.patch_at(z) {
            // Beside a corner the patch knows better than numbers that count from vertex 0.
            Some(patch) if patch.chart == self.chart => patch.preimage(w),
            _ => (z, self.forward(z).map_or(Complex64::ZERO, |value| value.slope.inv())),
        }
    }

    /// From a known pair to the point over `w`: by what the region's side knows, or, where the expansions that meet there
    /// differ too much, by the chart's own sum.
    fn walk(&self, seed: Pair, w: Complex64) -> Walk {
        let walk = self.walk_by(seed, w, &|z| self.forward(z));
        if walk.reached { walk } else { self.walk_by((walk.at, walk.z), w, &|z| self.own(z)) }
    }

    /// The same in steps over which the inverse is nearly linear.
    fn walk_by(&self, (at, z): Pair, w: Complex64, forward: &Forwards) -> Walk {
        let mut walk = Walk { at, z, slope: Complex64::ZERO, reached: false };
        let Some(start) = forward(z) else { return walk };
        walk.slope = start.slope.inv();
        for _ in 0..MOST_WALKED {
            let room = 0.3 * (1.0 - walk.at.norm_sqr()).min(1.0);
            let step = w - walk.at;
            let length = step.norm();
            let at = if length <= room { w } else { walk.at + step * (room / length) };
            let Some((z, slope, _)) = self.newton(at, walk.z + (at - walk.at) * walk.slope, forward) else { break };
            walk = Walk { at, z, slope, reached: at == w };
            if walk.reached {
                break;
            }
        }
        walk
    }

    /// Newton's method for f(z) = w; returns z, dz/dw, and whether the last value was another chart's.
    fn newton(&self, w: Complex64, mut z: Complex64, forward: &Forwards) -> Option<(Complex64, Complex64, bool)> {
        let mut last = f64::INFINITY;
        let noise = self.accuracy.solve_error;
        for _ in 0..20 {
            let value = forward(z)?;
            let inverse = value.slope.inv();
            let step = (w - value.w) * inverse;
            let size = step.norm_sqr().sqrt();
            z += step;
            // Quadratic convergence, measured in the disk where the map stretches: the next step would be below rounding. Or
            // rounding is all there is, or two expansions that meet here differ by more.
            let scale = inverse.norm().min(1.0);
            let converged = size <= 1e-9 * scale && size < 1e-4 * last;
            let stagnates = size >= 0.5 * last && size <= noise.max(1e-12) * inverse.norm().max(1.0);
            if converged || stagnates || size <= (1e-15 * scale).max(0.5 * f64::EPSILON * z.norm()) {
                return Some((z, inverse, value.foreign));
            }
            if size > 4.0 * last {
                return None;
            }
            last = size;
        }
        None
    }

    /// The map by the chart's own sum.
    fn own(&self, z: Complex64) -> Option<Forward> {
        let wall = self.atlas.walls.nearest_of_all(z);
        if !wall.inside {
            return None;
        }
        let mut series = [Complex64::ZERO; 2];
        let reach = 0.1 * wall.distance;
        self.atlas.charts[self.chart].expand(z, reach, &mut series);
        Some(Forward { w: series[0], slope: series[1] / reach, foreign: false })
    }

    fn forward(&self, z: Complex64) -> Option<Forward> {
        let (own, w, slope) = self.region.with_slope(self.atlas, z).image()?;
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
