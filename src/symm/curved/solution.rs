//! A solved boundary of analytic edges: θ along it, and the map region → disk inside.

use super::super::options::{Progress, Stop};
use super::super::stored::is_seen_from;
use super::super::system::System;
use super::cauchy::{self, CauchyPart, Evaluated, Sample, Sampled};
use super::discretisation::CurvedDiscretisation;
use super::measure::{Beside, CurvedMeasure};
use crate::plane::Complex64;
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

/// A solved equation, with its evidence.
#[derive(Clone, Debug)]
pub struct CurvedSolution {
    measure: CurvedMeasure,
    /// Ready for another center; of a stored solution, assembled when first asked for.
    system: OnceLock<Arc<System<CurvedDiscretisation>>>,
    /// In scaled units.
    pub(super) center: Complex64,
    /// Mass at each node, as solved.
    pub masses: Vec<f64>,
    /// What quadratures need of them, panel by panel.
    charges: Vec<Vec<f64>>,
    /// For Cauchy's formula; made when first asked for.
    parts: OnceLock<Vec<Arc<CauchyPart>>>,
    /// Largest violation of the equation where it was not imposed.
    pub residual: f64,
    /// Estimate of the largest error of the map.
    pub error_estimate: f64,
    /// Why the solve ended.
    pub stop: Stop,
}

/// Cauchy's formula at a point: the value, its derivative, and what the formula gives for 1.
pub type Cauchy<'a> = &'a dyn Fn(Complex64) -> Option<Evaluated>;

/// (f, f') at a point of the region (scaled units).
pub type Map<'a> = &'a dyn Fn(Complex64) -> Option<(Complex64, Complex64)>;

/// Maps with estimates above this are none.
const WORST_ESTIMATE: f64 = 1.0;
/// Cauchy's formula is trusted where it gives the constant 1 so well,
const WHOLE: f64 = 1e-12;
/// or to this share of the estimate.
const WHOLE_SHARE: f64 = 0.01;
/// Where a measure is looked for first on a panel.
pub(super) const MIDDLE: f64 = 0.5;

impl Deref for CurvedSolution {
    type Target = CurvedMeasure;

    fn deref(&self) -> &CurvedMeasure {
        &self.measure
    }
}

impl CurvedSolution {
    /// From node masses.
    #[must_use]
    pub fn new(
        discretisation: Arc<CurvedDiscretisation>,
        center: Complex64,
        masses: Vec<f64>,
        residual: f64,
        error_estimate: f64,
        stop: Stop,
    ) -> Self {
        // Where the measure is below rounding its sign is noise: angles must not run backwards there.
        let total: f64 = masses.iter().sum();
        let measure = CurvedMeasure::new(discretisation, &masses, total, &|mass| mass.max(0.0));
        let panels = measure.discretisation.rules.iter().zip(masses.chunks_exact(measure.discretisation.order.p()));
        let charges = panels.map(|(rule, own)| rule.charges(&own.iter().map(|mass| mass / total).collect::<Vec<_>>()));
        let charges = charges.collect();
        let (system, parts) = (OnceLock::new(), OnceLock::new());
        Self { measure, system, center, masses, charges, parts, residual, error_estimate, stop }
    }

    /// With the system that gave it.
    #[must_use]
    pub fn with_system(self, system: Arc<System<CurvedDiscretisation>>) -> Self {
        Self { system: OnceLock::from(system), ..self }
    }

    /// The system, ready for another center.
    ///
    /// # Errors
    /// [`Error::Cancelled`], if it must be assembled.
    pub fn system(&self, progress: Progress) -> Result<Arc<System<CurvedDiscretisation>>> {
        System::kept_in(&self.system, &self.discretisation, progress)
    }

    /// The panels in Cauchy's formula.
    #[must_use]
    pub fn parts(&self) -> &[Arc<CauchyPart>] {
        self.parts.get_or_init(|| cauchy::parts(self, self.discretisation.panels.len()))
    }

    /// The solution, unless its masses show that it is none.
    ///
    /// # Errors
    /// [`Error::NegativeMass`], [`Error::Inaccurate`].
    pub fn checked(self) -> Result<Self> {
        let (mass, q) = self.smallest_mass();
        if mass < -self.error_estimate || !(mass + self.residual).is_finite() {
            let edge = self.panel(q).edge;
            return Err(Error::NegativeMass { mass, estimate: self.error_estimate, edge });
        }
        if self.error_estimate.is_nan() || self.error_estimate > WORST_ESTIMATE {
            return Err(Error::Inaccurate { estimate: self.error_estimate });
        }
        Ok(self)
    }

    /// Whether the measure attracts points around the region as all of it at the center would, which is false for another region
    /// or another center.
    #[must_use]
    pub fn is_seen_from_center(&self) -> bool {
        const AROUND: usize = 16;
        let vertices = &self.discretisation.boundary.vertices;
        let radius = 4.0 + 2.0 * vertices.iter().map(|v| (v - self.center).norm()).fold(0.0, f64::max);
        let miss = 10.0 * self.error_estimate + 1e-12;
        is_seen_from((self.center, radius), AROUND, miss, &|z| self.potential(z).0.re)
    }

    /// Plane units × unit = scaled units.
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.discretisation.boundary.unit
    }

    /// A boundary point (scaled units) whose neighbourhood is crowded together most, if an error in the disk is more than twenty
    /// times as large in the region there: the middle of the panel of the least measure for its length.
    #[must_use]
    pub fn crowded(&self) -> Option<Complex64> {
        const OFTEN: f64 = 20.0;
        let boundary = &self.discretisation.boundary;
        // Ends of panels at corners are crowded by the corner alone.
        let whole = (0..self.discretisation.panels.len()).filter(|&q| self.panel(q).start > 0.0);
        let stretch = |q: usize| boundary.length(self.panel(q)) / (TAU * (self.starts[q + 1] - self.starts[q]));
        let (q, worst) = whole.map(|q| (q, stretch(q))).max_by(|a, b| a.1.total_cmp(&b.1))?;
        let panel = self.panel(q);
        let middle = Complex64::from(0.5 * (panel.start + panel.end));
        (worst > OFTEN).then(|| boundary.vertices[panel.corner] + boundary.arm(panel).curve.from_start(middle))
    }

    /// |f'(center)|⁻¹ in plane units.
    #[must_use]
    pub fn conformal_radius(&self) -> f64 {
        self.potential(self.center).0.re.exp() / self.unit()
    }

    /// Measure from vertex 0 to each vertex.
    #[must_use]
    pub fn vertex_measures(&self) -> Vec<f64> {
        (0..self.discretisation.boundary.outline_edges())
            .map(|edge| self.starts[self.panels_of(edge, true).start])
            .collect()
    }

    /// Measure from vertex 0 to a boundary point, given by its edge and parameter.
    #[must_use]
    pub fn measure_at(&self, edge: usize, t: f64) -> f64 {
        let (q, s) = self.place(0, edge, t);
        self.measure(q, self.panel(q).tau_at(s))
    }

    /// The image of a boundary point, and f' there (scaled units).
    #[must_use]
    pub fn on_circle(&self, edge: usize, t: f64) -> (Complex64, Complex64) {
        let (q, s) = self.place(0, edge, t);
        let (measure, slope) = self.measure.at(q, s);
        let w = Complex64::cis(TAU * measure);
        (w, w * Complex64::i() * TAU * slope)
    }

    /// Measure from vertex 0 → the edge and the parameter where that is reached.
    #[must_use]
    pub fn locate(&self, measure: f64) -> (usize, f64) {
        let (q, tau) = self.locate_on_panel(measure);
        let panel = self.panel(q);
        let s = panel.distance_at(tau);
        self.discretisation.boundary.outer(panel.edge, if panel.outgoing { s } else { 1.0 - s })
    }

    /// Measure → panel and τ.
    pub(super) fn locate_on_panel(&self, measure: f64) -> (usize, f64) {
        let measure = measure.rem_euclid(1.0);
        let q = self.panel_of(measure);
        (q, self.tau_of(q, measure, MIDDLE))
    }

    /// (∫ log(z − y) dμ, ∫ dμ/(z − y), turns of the boundary around z) at a point off the boundary (scaled units); the
    /// argument is continuous along the boundary and principal at vertex 0.
    fn potential(&self, z: Complex64) -> (Complex64, Complex64, f64) {
        let boundary = &self.discretisation.boundary;
        let first = (z - boundary.vertices[0]).arg();
        let mut argument = first;
        let (mut sum, mut slope) = (Complex64::ZERO, Complex64::ZERO);
        for (q, panel) in self.discretisation.panels.iter().enumerate() {
            let (own, rule) = (&panel.panel, &self.discretisation.rules[q]);
            let step = z - boundary.vertices[own.corner];
            let mut parts = panel.potentials(rule, &self.discretisation.order, step, &self.charges[q]);
            if !own.outgoing {
                parts.reverse();
            }
            for part in parts {
                let [near, far] = part.arguments;
                let (start, end) = if own.outgoing { (near, far) } else { (far, near) };
                let turns = TAU * ((argument - start) / TAU).round();
                sum += part.sum + Complex64::new(0.0, turns * part.mass);
                slope += part.slope;
                argument = end + turns;
            }
        }
        (sum, slope, ((argument - first) / TAU).round())
    }

    /// Region → disk with vertex 0 ↦ 1, and the derivative, both in scaled units; `None` outside the closed region.
    #[must_use]
    pub fn to_disk(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        self.to_disk_by(z, &|z| cauchy::to_disk(self, self.parts(), z))
    }

    /// The same with Cauchy's formula as `cauchy` sums it up.
    #[must_use]
    pub fn to_disk_by(&self, z: Complex64, cauchy: Cauchy) -> Option<(Complex64, Complex64)> {
        if !z.is_finite() {
            return None;
        }
        if let Some(beside) = self.beside(z) {
            if beside.outside && !beside.at_end {
                return None;
            }
            if beside.is_continued() {
                return Some(self.continued(&beside));
            }
        }
        if let Some((w, slope, one)) = cauchy(z) {
            if (one - 1.0).norm() < self.whole() {
                return Some((w, slope));
            }
            if one.norm() < self.whole() {
                return None;
            }
        }
        let (log, slope, turns) = self.potential(z);
        if turns != 1.0 {
            return None;
        }
        let factor = (-log).exp();
        Some(((z - self.center) * factor, factor * (1.0 - (z - self.center) * slope)))
    }

    pub(super) fn whole(&self) -> f64 {
        WHOLE.max(WHOLE_SHARE * self.error_estimate)
    }

    /// f and f' by continuing the boundary correspondence from a panel.
    fn continued(&self, beside: &Beside) -> (Complex64, Complex64) {
        let Beside { q, s, tau, .. } = *beside;
        let f = (Complex64::i() * TAU * self.complex_measure(q, tau)).exp();
        (f, f * Complex64::i() * TAU * self.measure_slope(q, s, tau))
    }
}

impl Sampled for CurvedSolution {
    fn sample(&self, q: usize, tau: f64, dtau: f64) -> Sample {
        let (_, z, dz) = self.step(q, tau, dtau);
        let w = Complex64::cis(TAU * self.measure(q, tau));
        Sample { z, w, dz, dw: w * self.density(q, tau) * dtau }
    }

    fn exponents(&self, q: usize) -> (f64, f64) {
        self.measure.exponents(q)
    }
}
