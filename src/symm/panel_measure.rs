//! A measure along panels, straight and curved alike: on every panel a polynomial in its corner variable.

use super::legendre::{GaussRule, MAX_NODES, complex_integral, complex_sum, legendre};
use crate::plane::Complex64;

/// The measure along a boundary, from vertex 0 on.
#[derive(Clone, Debug)]
pub struct PanelMeasure {
    /// Unknowns a panel.
    p: usize,
    /// Legendre coefficients of dμ/dτ on [0, 1], p a panel.
    coefficients: Vec<f64>,
    /// Measure from vertex 0 to where each panel begins in boundary order, and the whole.
    pub starts: Vec<f64>,
    /// Whether τ runs along the boundary, for every panel.
    outgoing: Vec<bool>,
    /// And its panel.
    smallest_mass: (f64, usize),
}

/// What a panel has of a measure: the values of dμ/dτ at its nodes, and its mass.
pub struct Part {
    /// dμ/dτ.
    pub density: Vec<f64>,
    /// Mass.
    pub mass: f64,
}

impl PanelMeasure {
    /// From what each panel has of it; `outgoing` tells which panels begin where τ is 0, and `grows` by how much a panel of some mass
    /// makes the measure grow.
    #[must_use]
    #[inline(never)]
    pub fn new(
        gauss: &GaussRule,
        outgoing: Vec<bool>,
        parts: impl Iterator<Item = Part>,
        grows: &dyn Fn(f64) -> f64,
    ) -> Self {
        let p = gauss.len();
        let (mut coefficients, mut starts) = (Vec::with_capacity(p * outgoing.len()), vec![0.0]);
        let mut smallest_mass = (f64::INFINITY, 0);
        for (q, Part { density, mass }) in parts.enumerate() {
            for k in 0..p {
                coefficients.push(gauss.coefficient_row(k).iter().zip(&density).map(|(t, g)| t * g).sum());
            }
            if mass < smallest_mass.0 || mass.is_nan() {
                smallest_mass = (mass, q);
            }
            starts.push(starts[q] + grows(mass));
        }
        Self { p, coefficients, starts, outgoing, smallest_mass }
    }

    /// The smallest mass of a panel, negative or NaN if the discretisation failed, and that panel.
    #[must_use]
    pub fn smallest_mass(&self) -> (f64, usize) {
        self.smallest_mass
    }

    /// Legendre coefficients of dμ/dτ on panel `q`.
    #[must_use]
    pub fn coefficients(&self, q: usize) -> &[f64] {
        &self.coefficients[q * self.p..][..self.p]
    }

    /// Measure from vertex 0 to the point at τ of panel `q`.
    #[must_use]
    pub fn measure(&self, q: usize, tau: f64) -> f64 {
        self.complex_measure(q, tau.into()).re
    }

    /// The same, continued analytically to complex τ: 2π times it is −i log f beside the boundary.
    #[must_use]
    #[inline(never)]
    pub fn complex_measure(&self, q: usize, tau: Complex64) -> Complex64 {
        let within = 0.5 * complex_integral(self.coefficients(q), 2.0 * tau - 1.0);
        if self.outgoing[q] { self.starts[q] + within } else { self.starts[q + 1] - within }
    }

    /// dμ/dτ at τ of panel `q`.
    #[must_use]
    #[inline(never)]
    pub fn density(&self, q: usize, tau: f64) -> f64 {
        let mut values = [0.0; MAX_NODES];
        legendre(2.0 * tau - 1.0, &mut values[..self.p]);
        values.iter().zip(self.coefficients(q)).map(|(value, c)| value * c).sum()
    }

    /// The same, continued analytically to complex τ.
    #[must_use]
    pub fn complex_density(&self, q: usize, tau: Complex64) -> Complex64 {
        complex_sum(self.coefficients(q), 2.0 * tau - 1.0)
    }

    /// Measure of a boundary that has 1 → the panel where it is reached.
    #[must_use]
    pub fn panel_of(&self, measure: f64) -> usize {
        (self.starts.partition_point(|&start| start <= measure).max(1) - 1).min(self.starts.len() - 2)
    }

    /// Where a measure is reached on panel `q` if that is seen evenly: a guess for [`PanelMeasure::tau_of`].
    #[must_use]
    pub fn guess_of(&self, q: usize, measure: f64) -> f64 {
        let share = (measure - self.starts[q]) / (self.starts[q + 1] - self.starts[q]);
        if self.outgoing[q] { share } else { 1.0 - share }
    }

    /// The τ where a measure is reached on panel `q`, from a `guess`; the middle of a panel that has none.
    #[must_use]
    #[inline(never)]
    pub fn tau_of(&self, q: usize, measure: f64, guess: f64) -> f64 {
        if self.starts[q + 1] == self.starts[q] {
            return 0.5;
        }
        let outgoing = self.outgoing[q];
        let (mut low, mut high) = (0.0, 1.0);
        let mut tau = guess;
        // Newton's method, kept inside the bracket by bisection.
        for _ in 0..80 {
            let miss = self.measure(q, tau) - measure;
            if (miss > 0.0) == outgoing {
                high = tau;
            } else {
                low = tau;
            }
            let density = self.density(q, tau) * if outgoing { 1.0 } else { -1.0 };
            let newton = tau - miss / density;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - tau).abs() <= 2.0 * f64::EPSILON * tau.abs() {
                return next;
            }
            tau = next;
        }
        tau
    }
}
