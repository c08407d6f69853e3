//! A solved problem as an analytic function, B = L − G, in the closed region, for boundaries of analytic edges.
//!
//! H = L − Σ qⱼ log(z − pⱼ), with a point pⱼ in each hole, is analytic and single-valued. On the boundary it is known from the
//! measure up to a phase of each component, which follows from ∮ H/(z − pⱼ) dz = 0 around the whole region; inside it is Cauchy's
//! formula, and beside an edge the measure continued.

use super::super::legendre::{MAX_NODES, legendre};
use super::super::lu::small_solve;
use super::super::panelled::Panelled;
use super::super::problem::{Problem, Source, whole_turns};
use super::arguments::Arguments;
use super::cauchy::{self, CauchyPart, Sample, Sampled, Side, Sums};
use super::discretisation::CurvedDiscretisation;
use super::measure::CurvedMeasure;
use super::solution::Cauchy;
use crate::plane::{Complex64, NOWHERE};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The function B of a [`Problem`], in scaled units.
#[derive(Clone, Debug)]
pub struct CurvedField {
    measure: CurvedMeasure,
    /// G.
    pub source: Source,
    /// The logarithms that make L − H: points and charges, with their arguments along the boundary.
    logs: Vec<(Complex64, f64, Arguments)>,
    /// Those of G, with their factors.
    source_logs: Vec<(Complex64, Complex64, Arguments)>,
    /// cⱼ.
    pub constants: Vec<f64>,
    /// On component j, Im B is this − 2π × the measure from vertex 0 of all.
    phases: Vec<f64>,
    /// For Cauchy's formula.
    parts: Vec<Arc<CauchyPart>>,
}

impl CurvedField {
    /// From what solves a problem, and a point in each component that is around a hole.
    #[must_use]
    pub fn new(
        discretisation: &Arc<CurvedDiscretisation>,
        Problem { source, charges }: Problem,
        masses: &[f64],
        constants: Vec<f64>,
        inner_points: &[Complex64],
    ) -> Self {
        let measure = CurvedMeasure::new(Arc::clone(discretisation), masses, 1.0, &|mass| mass);
        let arguments = |z: Complex64| Arguments::new(discretisation.as_ref(), z);
        let first = usize::from(discretisation.boundary.bounded);
        let holes = || inner_points.iter().zip(&charges).skip(first);
        let logs = holes().filter(|(_, charge)| **charge != 0.0).map(|(p, charge)| (*p, *charge, arguments(*p)));
        let source_logs = source.logs.iter().map(|(a, factor)| (*a, *factor, arguments(*a))).collect();
        let phases = vec![0.0; charges.len()];
        let mut field =
            Self { measure, source, logs: logs.collect(), source_logs, constants, phases, parts: Vec::new() };
        let parts = field.new_parts();
        let phase = |p: &Complex64| {
            let sums = cauchy::sums_from(Sums::default(), &field, &parts, *p, Side::Region);
            sums.map_or(f64::NAN, |sums| sums.above.im)
        };
        let of_holes: Vec<f64> = holes().map(|(p, _)| phase(p)).collect();
        field.phases[first..].copy_from_slice(&of_holes);
        field.parts = field.new_parts();
        field
    }

    /// Parts on which H is resolved.
    #[inline(never)]
    fn new_parts(&self) -> Vec<Arc<CauchyPart>> {
        let parts = cauchy::parts(self, self.measure.discretisation.panels.len());
        let points: Vec<Complex64> = self.logs.iter().map(|(p, ..)| *p).collect();
        cauchy::resolved(self, parts, &points)
    }

    /// The panels in Cauchy's formula.
    #[must_use]
    pub fn parts(&self) -> &[Arc<CauchyPart>] {
        &self.parts
    }

    /// What the formula gives for 1 outside of the boundary.
    #[must_use]
    pub fn around(&self) -> Complex64 {
        if self.measure.discretisation.boundary.bounded { Complex64::ZERO } else { Complex64::ONE }
    }

    /// Around which points B grows by 2πi times a charge: cuts run from there to the left.
    pub fn charged_holes(&self) -> impl Iterator<Item = (Complex64, f64)> + '_ {
        self.logs.iter().map(|(p, charge, _)| (*p, *charge))
    }

    /// B at τ of panel `q`, continuous along its component.
    #[inline(never)]
    fn on_panel(&self, q: usize, tau: Complex64) -> Complex64 {
        let boundary = &self.measure.discretisation.boundary;
        let component = boundary.loop_of(self.measure.panel(q).edge);
        let measure = self.measure.complex_measure(q, tau);
        Complex64::new(-self.constants[component], self.phases[component]) - Complex64::new(0.0, TAU) * measure
    }

    /// What takes B as [`CurvedField::on_panel`] has it, near the parameter s of panel `q`'s arm, to B with principal logarithms.
    #[inline(never)]
    fn turns(&self, q: usize, s: f64, z: Complex64) -> Complex64 {
        let discretisation = self.measure.discretisation.as_ref();
        let foot = discretisation.point(q, s);
        let continuous = |p: Complex64, arguments: &Arguments| {
            arguments.at(discretisation, q, s) + ((z - p) * (foot - p).conj()).arg()
        };
        let turn = |p: Complex64, arguments: &Arguments| whole_turns(continuous(p, arguments) - (z - p).arg());
        let own: f64 = self.logs.iter().map(|(p, charge, arguments)| charge * turn(*p, arguments)).sum();
        let of_source = self.source_logs.iter().map(|(a, factor, arguments)| factor * turn(*a, arguments));
        Complex64::i() * (of_source.sum::<Complex64>() - own)
    }

    /// What takes B at a point of an edge from [`CurvedField::on_edge`] to the arguments of [`CurvedField::at`].
    #[must_use]
    pub fn turn(&self, component: usize, edge: usize, t: f64) -> f64 {
        let (q, s) = self.measure.place(component, edge, t);
        let discretisation = self.measure.discretisation.as_ref();
        let z = discretisation.point(q, s);
        let along = |k: usize, _| {
            let mut turning = self.source_logs.iter().filter(|(_, factor, _)| factor.im != 0.0);
            turning.nth(k).map_or(f64::NAN, |(.., arguments)| arguments.at(discretisation, q, s))
        };
        self.source.turn(z, &along)
    }

    /// (B, B') at a point of an edge of a component's outline, B continuous along the component.
    #[must_use]
    pub fn on_edge(&self, component: usize, edge: usize, t: f64) -> (Complex64, Complex64) {
        let (q, s) = self.measure.place(component, edge, t);
        let (_, slope) = self.measure.at(q, s);
        (self.on_panel(q, self.measure.panel(q).tau_at(s).into()), Complex64::new(0.0, -TAU) * slope)
    }

    /// (B, B') at a point of the region; logarithms are principal ones.
    #[must_use]
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        let sums = Sums { below: self.around(), ..Sums::default() };
        self.at_by(z, &|z| cauchy::sums_from(sums, self, &self.parts, z, Side::Region).map(|sums| sums.evaluated()))
    }

    /// The same with Cauchy's formula as `cauchy` sums it up.
    #[must_use]
    #[inline(never)]
    pub fn at_by(&self, z: Complex64, cauchy: Cauchy) -> (Complex64, Complex64) {
        let beside = self.measure.beside(z);
        if let Some(beside) = beside.filter(|beside| beside.is_continued()) {
            let value = self.on_panel(beside.q, beside.tau);
            let panel = self.measure.panel(beside.q);
            let foot = beside.s.re.clamp(panel.start, panel.end);
            let slope = self.measure.measure_slope(beside.q, beside.s, beside.tau);
            return (value + self.turns(beside.q, foot, z), Complex64::new(0.0, -TAU) * slope);
        }
        cauchy(z).map_or((NOWHERE, NOWHERE), |(value, slope, _)| self.of_single_valued(z, (value, slope)))
    }

    /// (H, H') → (B, B').
    #[must_use]
    #[inline(never)]
    pub fn of_single_valued(&self, z: Complex64, known: (Complex64, Complex64)) -> (Complex64, Complex64) {
        let ((value, slope), (source, source_slope)) = (self.with_logs(z, known), self.source.at(z));
        (value - source, slope - source_slope)
    }

    /// (H, H') → (L, L').
    fn with_logs(&self, z: Complex64, (mut value, mut slope): (Complex64, Complex64)) -> (Complex64, Complex64) {
        for (p, charge) in self.charged_holes() {
            value += (z - p).ln() * charge;
            slope += charge / (z - p);
        }
        (value, slope)
    }

    /// L' at a point of the region, not beside the boundary.
    #[must_use]
    pub fn log_slope(&self, z: Complex64) -> Complex64 {
        let sums = Sums { below: self.around(), ..Sums::default() };
        let sums = cauchy::sums_from(sums, self, &self.parts, z, Side::Region);
        sums.map_or(NOWHERE, |sums| {
            let (value, slope, _) = sums.evaluated();
            self.with_logs(z, (value, slope)).1
        })
    }

    /// The density at the vertex where an edge of a component's outline starts, over that of another field there, whose density
    /// does not vanish near the vertex.
    ///
    /// The quotient is analytic in the other field's measure: a polynomial in that, fitted on the vertex' panel, tells it well where both
    /// densities are nearly 0 or infinite.
    #[must_use]
    pub fn strength(&self, other: &Self, component: usize, edge: usize) -> f64 {
        let (q, _) = self.measure.place(component, edge, 0.0);
        let taus: Vec<f64> = self.measure.discretisation.node_taus();
        let density = |field: &Self, tau: f64| field.measure.density(q, tau);
        let measure = |tau: f64| other.measure.measure(q, tau);
        let (start, end) = (measure(0.0), measure(1.0));
        let count = (taus.len() * 3).div_ceil(4);
        let row = |tau: &f64| {
            let mut row = [0.0; MAX_NODES];
            legendre(2.0 * (measure(*tau) - start) / (end - start) - 1.0, &mut row[..count]);
            row.map(|value| value * density(other, *tau))
        };
        let rows: Vec<[f64; MAX_NODES]> = taus.iter().map(row).collect();
        let (mut matrix, mut rhs) = (vec![0.0; count * count], vec![0.0; count]);
        for (row, tau) in rows.iter().zip(&taus) {
            for i in 0..count {
                rhs[i] += row[i] * density(self, *tau);
                for j in 0..count {
                    matrix[i * count + j] += row[i] * row[j];
                }
            }
        }
        // Legendre's polynomials are ±1 at −1.
        let fitted = small_solve(matrix, rhs);
        fitted.iter().enumerate().map(|(k, c)| if k % 2 == 0 { *c } else { -c }).sum()
    }
}

impl Sampled for CurvedField {
    fn sample(&self, q: usize, tau: f64, dtau: f64) -> Sample {
        let (s, z, dz) = self.measure.step(q, tau, dtau);
        let (mut value, (source, _)) = (self.on_panel(q, tau.into()) + self.turns(q, s, z), self.source.at(z));
        value += source;
        for (p, charge) in self.charged_holes() {
            value -= (z - p).ln() * charge;
        }
        Sample { z, w: value, dz, dw: Complex64::ZERO }
    }

    fn exponents(&self, q: usize) -> (f64, f64) {
        self.measure.exponents(q)
    }
}
