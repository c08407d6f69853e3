//! A solved problem as an analytic function, B = L − G, in the closed region, for smooth curves.
//!
//! H = L − Σ qⱼ log(z − pⱼ), with a point pⱼ in each hole, is analytic and single-valued. Its values on the curves are known up to
//! a phase of each, which follows from ∮ H/(z − pⱼ) dz = 0 around the whole region; inside it is Cauchy's formula.

use super::problem::{Problem, Source};
use super::smooth_system::SmoothSystem;
use crate::plane::fourier::transform;
use crate::plane::{Complex64, inner_point};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The function B of a [`Problem`], in scaled units.
#[derive(Clone, Debug)]
pub struct SmoothField {
    system: Arc<SmoothSystem>,
    bounded: bool,
    /// G.
    pub source: Source,
    charges: Vec<f64>,
    /// cⱼ.
    pub constants: Vec<f64>,
    /// Of each curve, Fourier coefficients σ₁ … of dμ/dt = (q + 2 Re Σ σₖ e^{ikt})/2π.
    waves: Vec<Vec<Complex64>>,
    /// Im B at t = 0.
    phases: Vec<f64>,
    /// A point in each hole; for an outer curve it is of no use.
    inner_points: Vec<Complex64>,
    /// H at the nodes.
    values: Vec<Complex64>,
}

/// g of a problem at the nodes and at the checks.
#[must_use]
pub fn boundary_values(system: &SmoothSystem, problem: &Problem) -> (Vec<f64>, Vec<f64>) {
    let level = |z: &Complex64| problem.source.level_at(*z, Complex64::ZERO);
    let (mut nodes, mut checks): (Vec<f64>, Vec<f64>) =
        (system.nodes.iter().map(level).collect(), system.checks.iter().map(level).collect());
    for (a, factor) in problem.source.turning() {
        for own in &system.loops {
            let arguments = continuous_arguments(&system.nodes[own.clone()], a);
            for (i, argument) in own.clone().zip(arguments) {
                nodes[i] += factor * argument;
                checks[i] += factor * (argument + turned(system.nodes[i] - a, system.checks[i] - a));
            }
        }
    }
    (nodes, checks)
}

impl SmoothField {
    /// From what solves a problem with the given charges.
    #[must_use]
    pub fn new(
        system: &Arc<SmoothSystem>,
        bounded: bool,
        source: Source,
        charges: Vec<f64>,
        masses: &[f64],
        constants: Vec<f64>,
    ) -> Self {
        let waves_of = |own: &std::ops::Range<usize>| {
            let masses: Vec<Complex64> = masses[own.clone()].iter().map(|mass| Complex64::from(*mass)).collect();
            transform(&masses)[1..own.len().div_ceil(2)].to_vec()
        };
        let waves = system.loops.iter().map(waves_of).collect();
        let inner_points = system
            .curves
            .iter()
            .map(|curve| inner_point(curve.outline().bounds(), &[], &|z| curve.signed_distance(z)) * system.unit)
            .collect();
        let mut field = Self {
            system: Arc::clone(system),
            bounded,
            source,
            charges,
            constants,
            waves,
            phases: vec![0.0; system.loops.len()],
            inner_points,
            values: Vec::new(),
        };
        field.find_values();
        field
    }

    fn is_outer(&self, curve: usize) -> bool {
        self.bounded && curve == 0
    }

    /// H at the nodes, and the phases that make it one analytic function.
    fn find_values(&mut self) {
        let system = Arc::clone(&self.system);
        let problem = Problem { source: self.source.clone(), charges: self.charges.clone() };
        let (g, _) = boundary_values(&system, &problem);
        let mut values: Vec<Complex64> = Vec::with_capacity(system.len());
        for (curve, own) in system.loops.iter().enumerate() {
            let nodes = &system.nodes[own.clone()];
            let mut along: Vec<Complex64> = (0..own.len())
                .map(|j| self.on_curve(curve, TAU * j as f64 / own.len() as f64) + g[own.start + j])
                .collect();
            let rest = Source { logs: Vec::new(), ..self.source.clone() };
            add(&mut along, 1.0, nodes.iter().map(|z| rest.at(*z).0.im));
            for (a, factor) in &self.source.logs {
                if factor.re != 0.0 {
                    add(&mut along, factor.re, continuous_arguments(nodes, *a));
                }
                if factor.im != 0.0 {
                    add(&mut along, factor.im, nodes.iter().map(|z| (z - a).norm().ln()));
                }
            }
            for (charge, p) in self.charged_holes() {
                along.iter_mut().zip(nodes).for_each(|(value, z)| value.re -= charge * (z - p).norm().ln());
                add(&mut along, -charge, continuous_arguments(nodes, p));
            }
            values.extend(along);
        }
        for curve in usize::from(self.bounded)..system.loops.len() {
            let (p, mut sum) = (self.inner_points[curve], Complex64::ZERO);
            for (i, weight) in self.weights() {
                sum += values[i] * weight / (system.nodes[i] - p);
            }
            // The weights are those of dz/2πi, backwards around holes.
            self.phases[curve] = sum.im;
            for i in system.loops[curve].clone() {
                values[i].im += self.phases[curve];
            }
        }
        self.values = values;
    }

    /// Every node with its weight in ∮ dz/2πi, the region to the left.
    fn weights(&self) -> impl Iterator<Item = (usize, Complex64)> + '_ {
        self.system.loops.iter().enumerate().flat_map(move |(curve, own)| {
            let sign = if self.is_outer(curve) { 1.0 } else { -1.0 };
            let scale = Complex64::new(0.0, -sign / own.len() as f64);
            own.clone().map(move |i| (i, self.system.tangents[i] * scale))
        })
    }

    /// The holes' charges that are not 0, with a point in each, from which the cut of B's branch runs to the left.
    pub fn charged_holes(&self) -> impl Iterator<Item = (f64, Complex64)> + '_ {
        let all = self.charges.iter().copied().zip(self.inner_points.iter().copied());
        all.skip(usize::from(self.bounded)).filter(|(charge, _)| *charge != 0.0)
    }

    /// Writes the coefficients of tᵏ of L at `center` + `radius`·t; the disk lies in the region, and its middle not within
    /// twice the radius of the boundary.
    pub fn expand(&self, center: Complex64, radius: f64, coefficients: &mut [Complex64]) {
        const SAMPLES: usize = 64;
        let turn = |j: usize| Complex64::from_polar(radius, TAU * j as f64 / SAMPLES as f64);
        let samples: Vec<Complex64> = (0..SAMPLES).map(|j| self.single_valued(center + turn(j)).0).collect();
        let spectrum = transform(&samples);
        coefficients.iter_mut().zip(spectrum).for_each(|(c, wave)| *c = wave / SAMPLES as f64);
        for (charge, p) in self.charged_holes() {
            let share = -radius / (center - p);
            coefficients[0] += (center - p).ln() * charge;
            let mut power = Complex64::ONE;
            for (k, c) in coefficients.iter_mut().enumerate().skip(1) {
                power *= share;
                *c -= power * (charge / k as f64);
            }
        }
    }

    /// L' at a point of the region.
    #[must_use]
    pub fn log_slope(&self, z: Complex64) -> Complex64 {
        self.log_at(z).1
    }

    /// (L, L') at a point of the region.
    fn log_at(&self, z: Complex64) -> (Complex64, Complex64) {
        let (mut value, below) = self.single_valued(z);
        let mut slope = Complex64::ZERO;
        for (i, weight) in self.weights() {
            let apart = self.system.nodes[i] - z;
            slope += (self.values[i] - value) * weight / (apart * apart);
        }
        slope /= below;
        for (charge, p) in self.charged_holes() {
            value += (z - p).ln() * charge;
            slope += charge / (z - p);
        }
        (value, slope)
    }

    /// (B, B') at a point of the region.
    #[must_use]
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        let ((value, slope), (source, source_slope)) = (self.log_at(z), self.source.at(z));
        (value - source, slope - source_slope)
    }

    /// What takes B at the point t of a curve from [`SmoothField::on_curve`] to the arguments of [`SmoothField::at`].
    #[must_use]
    pub fn turn(&self, curve: usize, t: f64) -> f64 {
        if self.source.turning().next().is_none() {
            return 0.0;
        }
        let own = self.system.loops[curve].clone();
        let nearest = (t / TAU * own.len() as f64).round() as usize % own.len();
        let z = self.system.curves[curve].point(t) * self.system.unit;
        let nodes = &self.system.nodes[own];
        let along = |_, a| continuous_arguments(&nodes[..=nearest], a)[nearest] + turned(nodes[nearest] - a, z - a);
        self.source.turn(z, &along)
    }

    /// H at a point of the region by the barycentric form of Cauchy's formula, and what it was divided by.
    fn single_valued(&self, z: Complex64) -> (Complex64, Complex64) {
        let (mut above, mut below) = (Complex64::ZERO, if self.bounded { 0.0.into() } else { Complex64::ONE });
        for (i, weight) in self.weights() {
            let apart = self.system.nodes[i] - z;
            let weight = weight / apart;
            above += self.values[i] * weight;
            below += weight;
        }
        (above / below, below)
    }

    /// B at the point t of a curve.
    #[must_use]
    pub fn on_curve(&self, curve: usize, t: f64) -> Complex64 {
        let turn = Complex64::cis(t);
        let mut power = Complex64::ONE;
        let mut sum = 0.0;
        for (k, wave) in self.waves[curve].iter().enumerate() {
            power *= turn;
            sum += (wave * (power - 1.0)).im / (k + 1) as f64;
        }
        let mass = (self.charges[curve] * t + 2.0 * sum) * if self.is_outer(curve) { -1.0 } else { 1.0 };
        Complex64::new(-self.constants[curve], self.phases[curve] + mass)
    }

    /// The density dμ/dt at the point t of a curve.
    #[must_use]
    pub fn density(&self, curve: usize, t: f64) -> f64 {
        let turn = Complex64::cis(t);
        let sum = self.waves[curve].iter().rev().fold(Complex64::ZERO, |sum, wave| (sum + wave) * turn);
        (self.charges[curve] + 2.0 * sum.re) / TAU
    }

    /// (B, B') at the point t of a curve.
    #[must_use]
    pub fn on_curve_with_slope(&self, curve: usize, t: f64) -> (Complex64, Complex64) {
        let along = TAU * self.density(curve, t) * if self.is_outer(curve) { -1.0 } else { 1.0 };
        let tangent = self.system.curves[curve].tangent(t) * self.system.unit;
        (self.on_curve(curve, t), Complex64::new(0.0, along) / tangent)
    }
}

fn add(values: &mut [Complex64], factor: f64, imaginary: impl IntoIterator<Item = f64>) {
    values.iter_mut().zip(imaginary).for_each(|(value, im)| value.im += factor * im);
}

/// The angle from one direction to another.
fn turned(from: Complex64, to: Complex64) -> f64 {
    (to * from.conj()).arg()
}

/// arg(z − p) along nodes, continuous.
fn continuous_arguments(nodes: &[Complex64], p: Complex64) -> Vec<f64> {
    let mut previous = nodes[0] - p;
    let mut argument = previous.arg();
    nodes
        .iter()
        .map(|z| {
            let here = z - p;
            argument += turned(previous, here);
            previous = here;
            argument
        })
        .collect()
}
