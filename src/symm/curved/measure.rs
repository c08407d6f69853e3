//! A measure on a boundary of analytic edges: on every panel a polynomial in its corner variable, continued beside it.

use super::super::log_moments::bernstein;
use super::super::panel::Panel;
use super::super::panel_measure::{PanelMeasure, Part};
use super::discretisation::CurvedDiscretisation;
use super::kernel::CurvedPanel;
use crate::plane::Complex64;
use std::f64::consts::TAU;
use std::ops::Deref;
use std::sync::Arc;

/// The measure along the boundary, from vertex 0 of the first component on.
#[derive(Clone, Debug)]
pub struct CurvedMeasure {
    /// The panels it lives on.
    pub discretisation: Arc<CurvedDiscretisation>,
    along: PanelMeasure,
}

impl Deref for CurvedMeasure {
    type Target = PanelMeasure;

    fn deref(&self) -> &PanelMeasure {
        &self.along
    }
}

/// A point beside a panel, or on it.
#[derive(Clone, Copy, Debug)]
pub struct Beside {
    /// The panel.
    pub q: usize,
    /// Complex parameter of the arm.
    pub s: Complex64,
    /// And of the panel.
    pub tau: Complex64,
    /// Distance from the nearest point of the panel.
    pub distance: f64,
    /// Whether it lies on the side of the panel where the region is not.
    pub outside: bool,
    /// Whether the nearest point is an end of the panel.
    pub at_end: bool,
}

impl Beside {
    /// Whether it lies in the region, and the panel's density goes on to it.
    #[must_use]
    pub fn is_continued(&self) -> bool {
        !self.outside && bernstein(2.0 * self.tau - 1.0) < CONTINUED
    }
}

/// A panel's density goes on so far beyond it: Bernstein's ρ.
const CONTINUED: f64 = 1.1;
/// As far beside a corner, in parameters, its derivative is told.
const BESIDE: f64 = 1e-14;
/// Points as near to the curve as this are on it, in units of the region's size.
const THICKNESS: f64 = 4e-15;

impl CurvedMeasure {
    /// From node masses over a `total`; `grows` says by how much a panel of some mass makes the measure grow.
    #[must_use]
    #[inline(never)]
    pub fn new(
        discretisation: Arc<CurvedDiscretisation>,
        masses: &[f64],
        total: f64,
        grows: &dyn Fn(f64) -> f64,
    ) -> Self {
        let gauss = &discretisation.order.panel;
        let parts = masses.chunks_exact(gauss.len()).map(|own| {
            let own: Vec<f64> = own.iter().map(|mass| mass / total).collect();
            let density = own.iter().zip(&gauss.weights).map(|(mass, w)| 2.0 * mass / w).collect();
            Part { density, mass: own.iter().sum() }
        });
        let outgoing = discretisation.panels.iter().map(|curved| curved.panel.outgoing).collect();
        let along = PanelMeasure::new(gauss, outgoing, parts, grows);
        Self { discretisation, along }
    }

    /// One of the panels.
    #[must_use]
    pub fn panel(&self, q: usize) -> &Panel {
        &self.discretisation.panels[q].panel
    }

    /// The panels of half an edge.
    #[must_use]
    #[inline(never)]
    pub fn panels_of(&self, edge: usize, outgoing: bool) -> std::ops::Range<usize> {
        let key = |curved: &CurvedPanel| (curved.panel.edge, !curved.panel.outgoing);
        let panels = &self.discretisation.panels;
        let first = panels.partition_point(|panel| key(panel) < (edge, !outgoing));
        first..panels.partition_point(|panel| key(panel) <= (edge, !outgoing))
    }

    /// Edge of the outline of a component and its parameter → panel, and parameter of its arm.
    #[must_use]
    #[inline(never)]
    pub fn place(&self, component: usize, edge: usize, t: f64) -> (usize, f64) {
        let (edge, t) = self.discretisation.boundary.inner(component, edge, t);
        let outgoing = t < 0.5;
        let s = if outgoing { t } else { 1.0 - t };
        let panels = self.panels_of(edge, outgoing);
        let here = panels.clone().find(|&q| (self.panel(q).start..=self.panel(q).end).contains(&s));
        (here.unwrap_or(panels.start), s)
    }

    /// dμ/dτ, continued; at real τ as it is summed along the panel.
    #[must_use]
    #[inline(never)]
    pub fn continued_density(&self, q: usize, tau: Complex64) -> Complex64 {
        if tau.im == 0.0 { self.density(q, tau.re).into() } else { self.complex_density(q, tau) }
    }

    /// Derivative of the complex measure by z.
    #[must_use]
    #[inline(never)]
    pub fn measure_slope(&self, q: usize, s: Complex64, tau: Complex64) -> Complex64 {
        let panel = self.panel(q);
        let by_s = if panel.exponent == 1.0 {
            Complex64::from(1.0 / panel.length())
        } else {
            tau / (panel.exponent * (s - panel.start))
        };
        let along = self.continued_density(q, tau) * by_s * if panel.outgoing { 1.0 } else { -1.0 };
        along / self.discretisation.boundary.arm(panel).curve.tangent(s)
    }

    /// The panel that is nearest to `z`, if its curve's parameter there is found.
    #[must_use]
    #[inline(never)]
    pub fn beside(&self, z: Complex64) -> Option<Beside> {
        let boundary = &self.discretisation.boundary;
        let mut best: Option<Beside> = None;
        for (q, curved) in self.discretisation.panels.iter().enumerate() {
            let panel = &curved.panel;
            let step = z - boundary.vertices[panel.corner];
            if curved.distance_from_middle(step) > 2.0 {
                continue;
            }
            let Some(s) = curved.parameter_of(step) else { continue };
            let foot = s.re.clamp(panel.start, panel.end);
            let at_end = foot != s.re;
            let curve = &boundary.arm(panel).curve;
            let distance = ((s - foot) * curve.chord(foot.into(), s)).norm();
            let thick = distance <= THICKNESS;
            let s = if thick { Complex64::from(foot) } else { s };
            let outside = !thick && (s.im < 0.0) == panel.outgoing && s.im != 0.0;
            let share = curved.share(s);
            let tau = if panel.exponent == 1.0 { share } else { share.powf(1.0 / panel.exponent) };
            let beside = Beside { q, s, tau, distance, outside, at_end };
            // At a corner both arms are as near: the one that has the point on the region's side serves.
            let better = best.is_none_or(|best| {
                distance < best.distance * (1.0 - 1e-9)
                    || distance <= best.distance * (1.0 + 1e-9) && best.outside && !outside
            });
            if better {
                best = Some(beside);
            }
        }
        best
    }

    /// [`PanelMeasure::measure`] at the parameter s of the arm of panel `q`, and its derivative by z; at a corner itself that
    /// is 0, infinite or none: it is told a little beside it.
    #[must_use]
    #[inline(never)]
    pub fn at(&self, q: usize, s: f64) -> (f64, Complex64) {
        let (panel, beside) = (self.panel(q), s.max(BESIDE));
        let measure = self.measure(q, panel.tau_at(s));
        (measure, self.measure_slope(q, beside.into(), panel.tau_at(beside).into()))
    }

    /// The parameter of the arm at τ of panel `q`, the point there, and dz/2πi for a step along the boundary.
    #[must_use]
    #[inline(never)]
    pub fn step(&self, q: usize, tau: f64, dtau: f64) -> (f64, Complex64, Complex64) {
        let panel = self.panel(q);
        let boundary = &self.discretisation.boundary;
        let curve = &boundary.arm(panel).curve;
        let s = panel.distance_at(tau);
        let ds = panel.exponent * tau.powf(panel.exponent - 1.0) * panel.length() * dtau;
        let along = if panel.outgoing { ds } else { -ds };
        let z = boundary.vertices[panel.corner] + curve.from_start(s.into());
        (s, z, curve.tangent(s.into()) * along / Complex64::new(0.0, TAU))
    }

    /// The powers of τ that z and an analytic function with real boundary values begin with on panel `q`.
    #[must_use]
    #[inline(never)]
    pub fn exponents(&self, q: usize) -> (f64, f64) {
        let panel = self.panel(q);
        let arm = self.discretisation.boundary.arm(panel);
        let slow = if self.discretisation.boundary.is_slow(panel) { 2.0 } else { 1.0 };
        let power = if panel.start == 0.0 { panel.exponent * arm.power } else { 1.0 };
        let exponent = panel.exponent * slow;
        (exponent, power)
    }
}
