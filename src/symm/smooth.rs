//! Symm's equation on a smooth closed curve: spectral accuracy from equally spaced nodes.
//!
//! With z(t) the curve and dμ = σ(t) dt, the kernel splits into log|2 sin((t−s)/2)|, whose action on waves is exact, and
//! log|z(t) − z(s)| − log|2 sin((t−s)/2)|, which is smooth and left to the trapezoidal rule
//! (R. Kress, *Linear Integral Equations*, section 12.3).

use super::options::{Progress, SolveOptions, Stop};
use super::smooth_system::{LEAST_NODES, MOST_NODES, ROUNDING_PER_NODE, Samples, SmoothOutcome, SmoothSystem};
use super::solution::ERROR_PER_RESIDUAL;
use crate::plane::fourier::transform;
use crate::plane::{Complex64, SmoothCurve};
use crate::{Error, Result};
use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

/// A solved smooth region.
#[derive(Clone, Debug)]
pub struct SmoothSolution {
    samples: Arc<Samples>,
    /// Ready for another center; of a stored solution, assembled when first asked for.
    system: OnceLock<Arc<SmoothSystem>>,
    center: Complex64,
    /// Mass of harmonic measure at each node.
    masses: Vec<f64>,
    /// Fourier coefficients σ₁ … of dμ/dt = (1 + 2 Re Σ σₖ e^{ikt})/2π.
    waves: Vec<Complex64>,
    /// f at the nodes, with vertex 0 at 1.
    values: Vec<Complex64>,
    /// df/dt at the nodes.
    slopes: Vec<Complex64>,
    /// Largest violation of the equation halfway between the nodes, or |c| if that is larger.
    pub residual: f64,
    /// What of the error the curve has from its points.
    curve_error: f64,
    /// Estimate of the largest error of the map.
    pub error_estimate: f64,
    /// Why the solve ended.
    pub stop: Stop,
}

/// Maps with estimates above this are none.
pub(super) const WORST_ESTIMATE: f64 = 1.0;
/// What points should be enough for that leave a curve open.
const USEFUL_ESTIMATE: f64 = 1e-3;

/// Solves for `center` (plane units), doubling the nodes until the estimate meets the tolerance.
///
/// # Errors
/// [`Error::InvalidOption`], [`Error::Cancelled`]; [`Error::NegativeMass`] or [`Error::Inaccurate`] if even the most nodes
/// allowed do not resolve the curve, [`Error::TooFewPoints`] if its points leave it open.
pub fn solve_smooth(
    curve: &Arc<SmoothCurve>,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<SmoothSolution> {
    options.validate()?;
    let most = options.max_unknowns.min(MOST_NODES);
    let mut nodes = (2 * curve.waves() + 2).clamp(LEAST_NODES, most.max(LEAST_NODES));
    let mut previous = f64::INFINITY;
    loop {
        let system = Arc::new(SmoothSystem::new(vec![Arc::clone(curve)], &[nodes], progress)?);
        let mut solution = SmoothSolution::new(&system, center, options.tolerance);
        solution.stop = if solution.error_estimate <= options.tolerance {
            Stop::Tolerance
        } else if !solution.needs_nodes(options.tolerance) {
            Stop::TooFewPoints
        } else if solution.residual > 0.5 * previous && solution.residual < 1e-10 {
            Stop::Stagnation
        } else if 2 * nodes > most {
            Stop::MaxUnknowns
        } else {
            previous = solution.residual;
            nodes *= 2;
            continue;
        };
        return solution.checked();
    }
}

impl SmoothSolution {
    /// One more right-hand side of a system of one curve.
    #[must_use]
    pub fn new(system: &Arc<SmoothSystem>, center: Complex64, tolerance: f64) -> Self {
        let center = center * system.unit;
        let logs = |points: &[Complex64]| points.iter().map(|z| (z - center).norm().ln()).collect::<Vec<_>>();
        let (at_nodes, at_checks) = (logs(&system.nodes), logs(&system.checks));
        let SmoothOutcome { masses, residual, .. } = system.solve(at_nodes, &at_checks, &[1.0]);
        let solution = Self::of_masses(Arc::clone(system.samples()), center, masses, residual);
        let stop = if solution.error_estimate <= tolerance { Stop::Tolerance } else { Stop::SamePanels };
        Self { system: OnceLock::from(Arc::clone(system)), stop, ..solution }
    }

    /// The solution with the given masses and residual, for a center in scaled units; its system is not assembled.
    pub(super) fn of_masses(samples: Arc<Samples>, center: Complex64, masses: Vec<f64>, residual: f64) -> Self {
        let n = samples.len();
        let curve_error = samples.curve_error(&masses);
        let complex: Vec<Complex64> = masses.iter().map(|mass| Complex64::from(*mass)).collect();
        let waves = transform(&complex)[1..n.div_ceil(2)].to_vec();
        let mut solution = Self {
            samples,
            system: OnceLock::new(),
            center,
            waves,
            values: Vec::new(),
            slopes: Vec::new(),
            residual,
            curve_error,
            error_estimate: ERROR_PER_RESIDUAL * residual + ROUNDING_PER_NODE * n as f64 + curve_error,
            stop: Stop::SamePanels,
            masses,
        };
        for j in 0..n {
            let value = Complex64::cis(TAU * solution.measure(TAU * j as f64 / n as f64));
            solution.values.push(value);
            solution.slopes.push(Complex64::i() * value * (solution.masses[j] * n as f64));
        }
        solution
    }

    /// Another center on the same nodes.
    ///
    /// # Errors
    /// [`Error::Cancelled`], if the system must be assembled.
    pub fn moved(&self, center: Complex64, tolerance: f64, progress: Progress) -> Result<Self> {
        let system = match self.system.get() {
            Some(system) => system,
            None => {
                let system = Arc::new(SmoothSystem::of(&self.samples, progress)?);
                // If another thread was first, its is the same.
                self.system.get_or_init(|| system)
            }
        };
        Ok(Self::new(system, center, tolerance))
    }

    /// Mass of harmonic measure at each node.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// Whether more nodes would make it better: the estimate misses the tolerance, and not because of the curve's points.
    #[must_use]
    pub fn needs_nodes(&self, tolerance: f64) -> bool {
        let estimate = self.error_estimate - self.curve_error;
        estimate.is_nan() || estimate > tolerance
    }

    /// The solution, unless it shows that it is none.
    ///
    /// # Errors
    /// [`Error::NegativeMass`], [`Error::Inaccurate`], [`Error::TooFewPoints`].
    pub fn checked(self) -> Result<Self> {
        let estimate = self.error_estimate;
        let useless = estimate.is_nan() || estimate > WORST_ESTIMATE;
        if useless && self.curve_error > 0.5 * estimate {
            let (given, curve) = (self.curve().points().len(), self.curve());
            let needed = curve.points_for(curve.uncertainty() * USEFUL_ESTIMATE / self.curve_error);
            return Err(Error::TooFewPoints { given, needed });
        }
        let (density, node) = self.smallest_density();
        if density < -estimate || !self.residual.is_finite() {
            let edge = node * self.curve().points().len() / self.unknowns();
            return Err(Error::NegativeMass { mass: density, estimate, edge });
        }
        if useless {
            return Err(Error::Inaccurate { estimate });
        }
        Ok(self)
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &SmoothCurve {
        &self.samples.curves[0]
    }

    /// Number of unknowns.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        self.samples.len()
    }

    /// Measure from t = 0 to t: ∫ dμ = t/2π + Σ Im(σₖ(e^{ikt} − 1))/(πk).
    #[must_use]
    pub fn measure(&self, t: f64) -> f64 {
        let turn = Complex64::cis(t);
        let mut power = Complex64::new(1.0, 0.0);
        let mut sum = 0.0;
        for (k, wave) in self.waves.iter().enumerate() {
            power *= turn;
            sum += (wave * (power - 1.0)).im / (k + 1) as f64;
        }
        t / TAU + sum * 2.0 / TAU
    }

    /// dμ/dt.
    #[must_use]
    pub fn density(&self, t: f64) -> f64 {
        let turn = Complex64::cis(t);
        let sum = self.waves.iter().rev().fold(Complex64::ZERO, |sum, wave| (sum + wave) * turn);
        (1.0 + 2.0 * sum.re) / TAU
    }

    /// Measure → t in [0, 2π): the inverse of [`SmoothSolution::measure`], by Newton's method inside a bracket.
    #[must_use]
    pub fn parameter(&self, measure: f64) -> f64 {
        let measure = measure.rem_euclid(1.0);
        let (mut low, mut high) = (0.0, TAU);
        let mut t = measure * TAU;
        for _ in 0..100 {
            let miss = self.measure(t) - measure;
            if miss > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let newton = t - miss / self.density(t);
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - t).abs() <= 4.0 * f64::EPSILON * t.abs() {
                return next;
            }
            t = next;
        }
        t
    }

    /// Smallest mass between two nodes, and the first of them.
    fn smallest_density(&self) -> (f64, usize) {
        let n = self.samples.len();
        let mass = |slope: &Complex64| slope.norm();
        let signed = |(slope, value): (&Complex64, &Complex64)| {
            let along = (slope / (Complex64::i() * value)).re;
            if along < 0.0 { -mass(slope) } else { along }
        };
        let densities = self.slopes.iter().zip(&self.values).map(signed).enumerate();
        let least = |least: (f64, usize), (node, density)| if density < least.0 { (density, node) } else { least };
        let (density, node) = densities.fold((f64::INFINITY, 0), least);
        (density / n as f64, node)
    }

    /// Conformal radius in plane units: exp ∫ log|y − z₀| dμ.
    #[must_use]
    pub fn conformal_radius(&self) -> f64 {
        let n = self.samples.len() as f64;
        let masses =
            self.slopes.iter().zip(&self.values).map(|(slope, value)| (slope / (Complex64::i() * value)).re / n);
        let log: f64 = masses.zip(&self.samples.nodes).map(|(mass, y)| mass * (y - self.center).norm().ln()).sum();
        log.exp() / self.samples.unit
    }

    /// The image of z(t) on the circle, and the derivative of the map there in plane units.
    #[must_use]
    pub fn on_circle(&self, t: f64) -> (Complex64, Complex64) {
        let w = Complex64::cis(TAU * self.measure(t));
        (w, Complex64::i() * w * (TAU * self.density(t)) / self.curve().tangent(t))
    }

    /// Region → disk with vertex 0 ↦ 1, and its derivative in plane units, for a point strictly inside.
    ///
    /// Cauchy's formula divided by the same formula for 1: ∑ f_j z'_j/(z_j − z) / ∑ z'_j/(z_j − z). What the trapezoidal
    /// rule gets wrong near the curve cancels in the quotient.
    #[must_use]
    pub fn to_disk(&self, z: Complex64) -> (Complex64, Complex64) {
        let (value, slope) = cauchy(&self.samples.nodes, &self.samples.tangents, &self.values, z * self.samples.unit);
        (value, slope * self.samples.unit)
    }

    /// Disk → region, the inverse of [`SmoothSolution::to_disk`], by the same formula with the circle for the curve.
    #[must_use]
    pub fn from_disk(&self, w: Complex64) -> Complex64 {
        cauchy(&self.values, &self.slopes, &self.samples.nodes, w).0 / self.samples.unit
    }
}

/// The value and derivative at `z` of the function with the given values on a curve (nodes and tangents).
fn cauchy(nodes: &[Complex64], tangents: &[Complex64], values: &[Complex64], z: Complex64) -> (Complex64, Complex64) {
    let (mut above, mut below) = (Complex64::ZERO, Complex64::ZERO);
    for ((node, tangent), value) in nodes.iter().zip(tangents).zip(values) {
        if *node == z {
            return (*value, Complex64::new(f64::NAN, f64::NAN));
        }
        let weight = tangent / (node - z);
        above += value * weight;
        below += weight;
    }
    let value = above / below;
    let mut slope = Complex64::ZERO;
    for ((node, tangent), other) in nodes.iter().zip(tangents).zip(values) {
        let apart = node - z;
        slope += (other - value) * tangent / (apart * apart);
    }
    (value, slope / below)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(n: usize, at: impl Fn(f64) -> Complex64) -> Arc<SmoothCurve> {
        let points: Vec<_> = (0..n).map(|j| at(TAU * j as f64 / n as f64)).collect();
        Arc::new(SmoothCurve::new(&points).unwrap())
    }

    fn solve(curve: &Arc<SmoothCurve>, center: Complex64, tolerance: f64) -> SmoothSolution {
        let options = SolveOptions { tolerance, ..SolveOptions::default() };
        solve_smooth(curve, center, &options, &mut |_, _| true).unwrap()
    }

    /// z = 2pw/((1+p) − (1−p)w²) takes the disk to an inverted ellipse.
    #[test]
    fn inverted_ellipse_both_ways() {
        let p = 0.4;
        let exact = |w: Complex64| 2.0 * p * w / ((1.0 + p) - (1.0 - p) * w * w);
        // Points on it that are not images of equally spaced angles: |1/z| runs over an ellipse.
        let outline = curve(160, |t| 1.0 / Complex64::new(t.cos() / 1.0, -t.sin() / p));
        let solution = solve(&outline, Complex64::ZERO, 1e-12);
        assert_eq!(solution.stop, Stop::Tolerance);
        for radius in [0.1, 0.7, 0.99, 0.999_999] {
            for t in [0.0, 0.4, 1.9, 3.5] {
                let w = Complex64::from_polar(radius, t);
                let (value, slope) = solution.to_disk(exact(w));
                assert!((value - w).norm() < 1e-12, "{w}: {value}");
                assert!((solution.from_disk(w) - exact(w)).norm() < 1e-12);
                let h = 1e-5;
                let difference =
                    (solution.to_disk(exact(w) + h * 0.1).0 - solution.to_disk(exact(w) - h * 0.1).0) / (0.2 * h);
                if radius < 0.9 {
                    assert!((slope - difference).norm() < 1e-8, "{w}: {slope} {difference}");
                }
            }
        }
        assert!((solution.conformal_radius() - 2.0 * p / (1.0 + p)).abs() < 1e-12);
    }

    #[test]
    fn measure_and_parameter_are_inverse() {
        let solution = solve(&curve(100, |t| Complex64::new(2.0 * t.cos(), t.sin())), Complex64::new(0.7, 0.3), 1e-11);
        for t in [0.0, 0.1, 1.0, 2.5, 6.2] {
            assert!((solution.parameter(solution.measure(t)) - t).abs() < 1e-13);
        }
    }

    #[test]
    fn estimate_brackets_the_error_of_a_coarse_curve() {
        let fine = curve(30, |t| Complex64::new(3.0 * t.cos(), t.sin()));
        let reference = solve(&fine, Complex64::new(1.5, 0.0), 1e-13);
        for nodes in [60, 90, 120, 150] {
            let system = Arc::new(SmoothSystem::new(vec![Arc::clone(&fine)], &[nodes], &mut |_, _| true).unwrap());
            let solution = SmoothSolution::new(&system, Complex64::new(1.5, 0.0), 1e-13);
            let on_curve =
                (0..50).map(|j| f64::from(j) * 0.12).map(|t| TAU * (solution.measure(t) - reference.measure(t)).abs());
            let error = on_curve.fold(solution.residual, f64::max);
            let ratio = solution.error_estimate / error;
            assert!((1.0..100.0).contains(&ratio), "{nodes} nodes: error {error:e}, ratio {ratio}");
        }
    }
}
