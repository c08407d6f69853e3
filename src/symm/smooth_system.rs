//! Symm's equation at equally spaced nodes of smooth curves, one or several: the matrix, factored or, if it is large, iterated.

use super::circle_iteration::CircleIteration;
use super::influence::room;
use super::lu::Lu;
use super::options::Progress;
use super::rows::dot;
use crate::plane::{Complex64, SmoothCurve};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::ops::{Deref, Range};
use std::sync::Arc;

/// What rounding leaves, per node: differences of nearby nodes are only known to that.
pub(super) const ROUNDING_PER_NODE: f64 = 2e-16;
/// Fewest nodes of a curve.
pub(super) const LEAST_NODES: usize = 64;
/// Most nodes: two matrices of this size take 270 MB.
pub(super) const MOST_NODES: usize = 4096;

/// Curves sampled at equally spaced nodes.
#[derive(Debug)]
pub struct Samples {
    /// The curves in plane units, all counter-clockwise.
    pub curves: Vec<Arc<SmoothCurve>>,
    /// Plane units × `unit` = units used here.
    pub unit: f64,
    /// The nodes of each curve.
    pub loops: Vec<Range<usize>>,
    /// z(2πj/N), curve by curve.
    pub nodes: Vec<Complex64>,
    /// z'(2πj/N).
    pub tangents: Vec<Complex64>,
    /// Points halfway between nodes, where the equation is checked.
    pub checks: Vec<Complex64>,
}

/// Samples with the factored equation: ready for any right-hand side.
#[derive(Debug)]
pub struct SmoothSystem {
    samples: Arc<Samples>,
    /// Entries at the checks, row-major.
    check_rows: Vec<f64>,
    inverse: Inverse,
}

#[derive(Debug)]
enum Inverse {
    Factored(Lu),
    Iterated(CircleIteration),
}

/// Up to so many nodes a factorisation beats iterating (measured).
const FACTOR_UP_TO: usize = 1024;

/// What one right-hand side gave.
#[derive(Clone, Debug)]
pub struct SmoothOutcome {
    /// Mass of each node.
    pub masses: Vec<f64>,
    /// The constant of each curve.
    pub constants: Vec<f64>,
    /// Largest violation of the equation halfway between the nodes of each curve.
    pub residuals: Vec<f64>,
    /// Largest of all, or |c| of a single curve if that is larger.
    pub residual: f64,
}

impl Deref for SmoothSystem {
    type Target = Samples;

    fn deref(&self) -> &Samples {
        &self.samples
    }
}

impl Samples {
    /// With so many nodes on each curve.
    #[must_use]
    pub fn new(curves: Vec<Arc<SmoothCurve>>, counts: &[usize]) -> Self {
        let unit = (-size_of(&curves).log2().round()).exp2();
        let mut loops: Vec<Range<usize>> = Vec::with_capacity(curves.len());
        let (mut nodes, mut tangents, mut checks) = (Vec::new(), Vec::new(), Vec::new());
        for (curve, &count) in curves.iter().zip(counts) {
            let at = |shift: f64| move |j: usize| TAU * (j as f64 + shift) / count as f64;
            loops.push(nodes.len()..nodes.len() + count);
            nodes.extend((0..count).map(at(0.0)).map(|t| curve.point(t) * unit));
            tangents.extend((0..count).map(at(0.0)).map(|t| curve.tangent(t) * unit));
            checks.extend((0..count).map(at(0.5)).map(|t| curve.point(t) * unit));
        }
        Self { curves, unit, loops, nodes, tangents, checks }
    }

    /// Number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// What of the map's error the curves have from their points: a boundary moved by δ moves its image by |f'| δ =
    /// 2π (dμ/dt)/|z'| δ.
    #[must_use]
    pub fn curve_error(&self, masses: &[f64]) -> f64 {
        let of = |(curve, own): (&Arc<SmoothCurve>, &Range<usize>)| {
            let count = own.len() as f64;
            let slopes = own.clone().map(|j| masses[j].abs() * count / self.tangents[j].norm());
            curve.uncertainty() * self.unit * slopes.fold(0.0, f64::max)
        };
        self.curves.iter().zip(&self.loops).map(of).fold(0.0, f64::max)
    }
}

impl SmoothSystem {
    /// Assembles and factors, with so many nodes on each curve.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn new(curves: Vec<Arc<SmoothCurve>>, counts: &[usize], progress: Progress) -> Result<Self> {
        Self::of(&Arc::new(Samples::new(curves, counts)), progress)
    }

    /// Assembles and factors.
    ///
    /// # Errors
    /// [`Error::Cancelled`].
    pub fn of(samples: &Arc<Samples>, progress: Progress) -> Result<Self> {
        let Samples { loops, nodes, tangents, checks, .. } = samples.as_ref();
        let (n, m) = (nodes.len(), loops.len());
        let (mut matrix, mut check_rows) = (room((n + m) * (n + m))?, room(n * n)?);
        for (curve, own) in loops.iter().enumerate() {
            let count = own.len();
            let sine_weights = SineWeights::new(count);
            let inverse_chords: Vec<f64> = (0..2 * count).map(|h| chord(h, count).powi(-2)).collect();
            let log_ratio = |z: Complex64, half_steps: usize| 0.5 * (z.norm_sqr() * inverse_chords[half_steps]).ln();
            for i in own.clone() {
                for j in 0..n {
                    if !own.contains(&j) {
                        matrix.push((nodes[i] - nodes[j]).norm().ln());
                        check_rows.push((checks[i] - nodes[j]).norm().ln());
                        continue;
                    }
                    let apart = if i >= j { i - j } else { i + count - j };
                    let log = if i == j { tangents[i].norm().ln() } else { log_ratio(nodes[i] - nodes[j], 2 * apart) };
                    matrix.push(log + sine_weights.at(2 * apart));
                    let log = log_ratio(checks[i] - nodes[j], 2 * apart + 1);
                    check_rows.push(log + sine_weights.at(2 * apart + 1));
                }
                matrix.extend((0..m).map(|k| f64::from(u8::from(k == curve))));
                if i % 32 == 0 && !progress("assemble", i as f64 / n as f64) {
                    return Err(Error::Cancelled);
                }
            }
        }
        for own in loops {
            matrix.extend((0..n).map(|j| f64::from(u8::from(own.contains(&j)))));
            matrix.resize(matrix.len() + m, 0.0);
        }
        let inverse = if n <= FACTOR_UP_TO {
            Inverse::Factored(Lu::new(n + m, matrix))
        } else {
            Inverse::Iterated(CircleIteration::new(loops.clone(), matrix))
        };
        Ok(Self { samples: Arc::clone(samples), check_rows, inverse })
    }

    /// What it was assembled from.
    #[must_use]
    pub fn samples(&self) -> &Arc<Samples> {
        &self.samples
    }

    /// Solves for boundary values at the nodes and at the checks, and charges of the curves.
    #[must_use]
    pub fn solve(&self, at_nodes: Vec<f64>, at_checks: &[f64], charges: &[f64]) -> SmoothOutcome {
        let n = self.len();
        let mut x = at_nodes;
        x.extend_from_slice(charges);
        match &self.inverse {
            Inverse::Factored(lu) => lu.solve(&mut x),
            Inverse::Iterated(iteration) => x = iteration.solve(&x),
        }
        let constants = x.split_off(n);
        let worse = |worst: f64, r: f64| if r > worst || r.is_nan() { r } else { worst };
        let residual_of = |(own, c): (&Range<usize>, &f64)| {
            let misses = own.clone().map(|i| {
                let row = &self.check_rows[i * n..][..n];
                (dot(row, &x) + c - at_checks[i]).abs()
            });
            misses.fold(0.0, worse)
        };
        let residuals: Vec<f64> = self.loops.iter().zip(&constants).map(residual_of).collect();
        let constant = if constants.len() == 1 && charges[0] != 0.0 { constants[0].abs() } else { 0.0 };
        let residual = residuals.iter().copied().fold(constant, worse);
        SmoothOutcome { masses: x, constants, residuals, residual }
    }
}

/// The larger side of the box around all curves.
fn size_of(curves: &[Arc<SmoothCurve>]) -> f64 {
    let (mut low, mut high) = curves[0].outline().bounds();
    for curve in &curves[1..] {
        let (l, h) = curve.outline().bounds();
        low = Complex64::new(low.re.min(l.re), low.im.min(l.im));
        high = Complex64::new(high.re.max(h.re), high.im.max(h.im));
    }
    (high.re - low.re).max(high.im - low.im)
}

/// |2 sin| of half the parameter between two points that are `half_steps` half steps apart.
fn chord(half_steps: usize, n: usize) -> f64 {
    2.0 * (0.25 * TAU * half_steps as f64 / n as f64).sin().abs()
}

/// How masses at the nodes act through log|2 sin((t−s)/2)|, by the distance in half steps: the waves e^{ikt} are
/// multiplied by −1/(2|k|).
struct SineWeights {
    weights: Vec<f64>,
}

impl SineWeights {
    fn new(n: usize) -> Self {
        let cosine: Vec<f64> = (0..2 * n).map(|j| (TAU * j as f64 / (2 * n) as f64).cos()).collect();
        let weight = |half_steps: usize| -> f64 {
            let mut sum = 0.0;
            for k in 1..n.div_ceil(2) {
                sum -= cosine[half_steps * k % (2 * n)] / k as f64;
            }
            if n.is_multiple_of(2) {
                sum -= cosine[half_steps * (n / 2) % (2 * n)] / n as f64;
            }
            sum
        };
        Self { weights: (0..2 * n).map(weight).collect() }
    }

    fn at(&self, half_steps: usize) -> f64 {
        self.weights[half_steps]
    }
}
