//! The map beside the boundary: one real power series in the variable of a zone.

use super::arc_sampler::ArcSampler;
use super::charts::Chart;
use super::fit::Fit;
use super::power_series::{real_value, real_value_and_slope, revert, value};
use super::zone::{Place, Zone};
use crate::plane::Complex64;
use crate::symm::panel::Boundary;
use std::f64::consts::TAU;

/// log f = i(θ₀ + Σ cₖ τᵏ) in a zone. As the coefficients are real, the boundary goes to the circle exactly (Schwarz's
/// reflection), and points beside it keep the relative accuracy of their distances.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Which chart's map it is.
    pub chart: usize,
    /// Where it is used.
    pub zone: Zone,
    /// θ at the zone's middle.
    theta: f64,
    /// Images of the zone are not farther from iθ than this, in log w.
    farthest: f64,
    coefficients: Vec<f64>,
    /// Coefficients of τ as a series in −i log w − θ₀.
    first_guess: [f64; 6],
}

/// The image of the zone is no farther from its middle than this times what samples on the arc are.
const SLACK: f64 = 1.1;

impl Patch {
    /// Fits the map of a chart, the boundary correspondence on the diameter and the potential on the arc.
    #[must_use]
    pub fn new(boundary: &Boundary, chart: &Chart, index: usize, zone: Zone, fit: &Fit) -> Self {
        let start = chart.measure(zone.on_edge(boundary, 0.0));
        let turned = |x: &f64| {
            let measure = chart.measure(zone.on_edge(boundary, *x)) - start;
            TAU * (measure - measure.round())
        };
        let on_diameter: Vec<f64> = fit.diameter.iter().map(turned).collect();
        let theta = TAU * start;
        let mut previous = turned(&1.0);
        let expand = |center, radius, coefficients: &mut [Complex64]| chart.expand(center, radius, coefficients);
        let mut sampler = ArcSampler::new(&expand, fit.accuracy);
        let on_arc: Vec<Complex64> = fit
            .arc
            .iter()
            .map(|&tau| {
                let (w, _) = sampler.at(&zone, tau);
                let turn = w.arg() - theta - previous;
                previous += turn - TAU * (turn / TAU).round();
                Complex64::new(previous, -0.5 * w.norm_sqr().ln())
            })
            .collect();
        let coefficients = fit.coefficients(&on_diameter, &on_arc);
        let first: [Complex64; 6] = std::array::from_fn(|k| coefficients[k].into());
        let mut first_guess = [Complex64::ZERO; 6];
        revert(&first, &mut first_guess);
        let farthest = fit.arc.iter().map(|&tau| real_value(&coefficients, tau).norm_sqr()).fold(0.0, f64::max).sqrt();
        Self {
            chart: index,
            zone,
            theta,
            farthest: SLACK * farthest,
            coefficients,
            first_guess: first_guess.map(|b| b.re),
        }
    }

    /// z → w; `None` outside the region.
    #[inline]
    #[must_use]
    pub fn value(&self, z: Complex64) -> Option<Complex64> {
        match self.zone.place(z) {
            Place::At(tau) => Some(self.on_disk(real_value(&self.coefficients, tau))),
            Place::Outside => None,
        }
    }

    /// The same with f'.
    #[must_use]
    pub fn value_and_slope(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let Place::At(tau) = self.zone.place(z) else { return None };
        let w = self.on_disk(real_value(&self.coefficients, tau));
        let (_, slope) = real_value_and_slope(&self.coefficients, tau);
        Some((w, Complex64::i() * w * slope * self.zone.slope(tau)))
    }

    /// −i log(w/w₀), w₀ being the image of a vertex and w that of z, with the relative accuracy of z's distance from it: `None`
    /// unless this is the patch around that vertex, or if z lies outside.
    #[must_use]
    pub fn beside(&self, vertex: usize, z: Complex64) -> Option<Complex64> {
        match self.zone.place(z) {
            Place::At(tau) if self.is_around(vertex) => Some(real_value(&self.coefficients, tau)),
            _ => None,
        }
    }

    /// The place for a value of [`Patch::beside`], and its derivative by that; `None` beyond the zone.
    #[must_use]
    pub fn from_beside(&self, vertex: usize, angle: Complex64) -> Option<(Complex64, Complex64)> {
        if !self.is_around(vertex) {
            return None;
        }
        let mut tau = angle / self.coefficients[0];
        for _ in 0..MOST_STEPS {
            let (value, slope) = real_value_and_slope(&self.coefficients, tau);
            let step = (value - angle) / slope;
            tau -= step;
            if step.norm_sqr() <= STEP * STEP * tau.norm_sqr() {
                break;
            }
        }
        if angle.im == 0.0 {
            tau.im = 0.0;
        }
        let (value, slope) = real_value_and_slope(&self.coefficients, tau);
        let missed = (value - angle).norm() > MISSED * angle.norm();
        // Written so that NaN is beyond.
        if missed || !(tau.norm_sqr() <= 1.0 && tau.im >= 0.0) {
            return None;
        }
        Some((self.zone.point(tau), (slope * self.zone.slope(tau)).inv()))
    }

    fn is_around(&self, vertex: usize) -> bool {
        self.zone.along == 0.0 && self.zone.edge == vertex
    }

    fn on_disk(&self, angle: Complex64) -> Complex64 {
        Complex64::from_polar((-angle.im).exp(), self.theta + angle.re)
    }

    /// −i log w − θ₀.
    fn angle(&self, w: Complex64) -> Complex64 {
        let turn = w.arg() - self.theta;
        Complex64::new(turn - TAU * (turn / TAU).round(), -0.5 * w.norm_sqr().ln())
    }

    /// Whether w is certainly no image of the zone.
    #[must_use]
    pub fn misses(&self, w: Complex64) -> bool {
        self.angle(w).norm_sqr() > self.farthest * self.farthest
    }

    /// How far images of the zone lie from its middle, in log w.
    #[must_use]
    pub fn farthest(&self) -> f64 {
        self.farthest
    }

    /// w → τ; points on the circle (and not more than rounding outside) give real τ.
    #[must_use]
    pub fn straightened(&self, w: Complex64) -> Complex64 {
        let mut angle = self.angle(w);
        let on_circle = angle.im.abs() <= 2.0 * f64::EPSILON;
        if on_circle {
            angle.im = 0.0;
        }
        let mut guess = [Complex64::ZERO; 7];
        guess[1..].iter_mut().zip(self.first_guess).for_each(|(g, c)| g.re = c);
        let mut tau = value(&guess, angle);
        if tau.is_nan() || tau.norm_sqr() > 1.0 {
            tau /= tau.norm();
        }
        tau = self.newton(angle, tau);
        // Far from the middle the first guess may lead to a root of the series that lies outside the zone.
        for start in STARTS {
            if tau.norm_sqr() <= ROOTS_WITHIN {
                break;
            }
            tau = self.newton(angle, start);
        }
        if tau.is_nan() {
            // Nothing is told apart here: the whole zone is the image of a point.
            return Complex64::ZERO;
        }
        if on_circle { Complex64::new(tau.re, 0.0) } else { tau }
    }

    /// Newton's method, in steps that stay small against the zone.
    fn newton(&self, angle: Complex64, mut tau: Complex64) -> Complex64 {
        for _ in 0..MOST_STEPS {
            let (miss, slope) = real_value_and_slope(&self.coefficients, tau);
            let step = (miss - angle) / slope;
            let size = step.norm_sqr().sqrt();
            tau -= if size > LONGEST_STEP { step * (LONGEST_STEP / size) } else { step };
            if size.is_nan() || size <= STEP * tau.norm_sqr().sqrt() {
                break;
            }
        }
        tau
    }

    /// Whether the patch takes τ to w: what Newton's method found is a solution.
    #[must_use]
    pub fn leads_to(&self, tau: Complex64, w: Complex64) -> bool {
        (self.on_disk(real_value(&self.coefficients, tau)) - w).norm() < 1e-12
    }

    /// Disk → region: the point z that goes to w, and dz/dw.
    #[must_use]
    pub fn preimage(&self, w: Complex64) -> (Complex64, Complex64) {
        let tau = self.straightened(w);
        (self.zone.point(tau), self.inverse_slope(tau, w))
    }

    /// dz/dw where τ is known.
    fn inverse_slope(&self, tau: Complex64, w: Complex64) -> Complex64 {
        let (_, slope) = real_value_and_slope(&self.coefficients, tau);
        (Complex64::i() * w * slope * self.zone.slope(tau)).inv()
    }

    /// The image of the top of the zone.
    #[must_use]
    pub fn top(&self) -> Complex64 {
        self.on_disk(real_value(&self.coefficients, Complex64::i()))
    }

    /// |f'| at the top of the zone.
    #[must_use]
    pub fn typical_slope(&self) -> f64 {
        let top = Complex64::i();
        let (_, slope) = real_value_and_slope(&self.coefficients, top);
        (slope * self.zone.slope(top)).norm() * (-real_value(&self.coefficients, top).im).exp()
    }

    /// Bytes of memory.
    #[must_use]
    pub fn bytes(&self) -> usize {
        std::mem::size_of::<Self>() + 8 * self.coefficients.len()
    }
}

/// Newton's method ends after a step this small, the next being below rounding.
const STEP: f64 = 1e-9;
const MOST_STEPS: usize = 20;
/// What Newton's method found is none if it misses by this share.
const MISSED: f64 = 1e-12;
const LONGEST_STEP: f64 = 0.3;
/// |τ|² of roots that belong to the zone, with some room.
const ROOTS_WITHIN: f64 = 1.3;
/// Where to start again.
const STARTS: [Complex64; 5] = [
    Complex64::new(0.0, 0.5),
    Complex64::new(0.7, 0.2),
    Complex64::new(-0.7, 0.2),
    Complex64::new(0.6, 0.7),
    Complex64::new(-0.6, 0.7),
];
