//! A solved region of either kind: what `RiemannMap` asks of a polygon and of a smooth curve alike.
//!
//! Here vertex 0 goes to 1; `RiemannMap` turns that so that `toward` does.

use crate::Result;
use crate::plane::{BoundaryPoint, Complex64, Region};
use crate::symm::center::move_center;
use crate::symm::options::{Progress, SolveOptions, Stop};
use crate::symm::smooth::{SmoothSolution, solve_smooth};
use crate::symm::solution::Solution;
use crate::symm::solve::solve;
use std::f64::consts::TAU;

/// The solution of Symm's equation on panels or on a smooth curve.
#[derive(Clone, Debug)]
pub(super) enum Solved {
    Polygon(Solution),
    Smooth(SmoothSolution),
}

impl Solved {
    pub fn new(region: &Region, options: &SolveOptions, progress: Progress) -> Result<Self> {
        Ok(match region.smooth() {
            Some(curve) => Self::Smooth(solve_smooth(curve, region.center(), options, progress)?),
            None => Self::Polygon(solve(region, options, progress)?),
        })
    }

    pub fn with_center(&self, center: Complex64, options: &SolveOptions, progress: Progress) -> Result<Self> {
        Ok(match self {
            Self::Polygon(solution) => Self::Polygon(move_center(solution, center, options, progress)?),
            Self::Smooth(solution) => Self::Smooth(solution.system.solve(center, options.tolerance)),
        })
    }

    pub fn residual(&self) -> f64 {
        match self {
            Self::Polygon(solution) => solution.residual,
            Self::Smooth(solution) => solution.residual,
        }
    }

    pub fn error_estimate(&self) -> f64 {
        match self {
            Self::Polygon(solution) => solution.error_estimate,
            Self::Smooth(solution) => solution.error_estimate,
        }
    }

    pub fn stop(&self) -> Stop {
        match self {
            Self::Polygon(solution) => solution.stop,
            Self::Smooth(solution) => solution.stop,
        }
    }

    pub fn unknowns(&self) -> usize {
        match self {
            Self::Polygon(solution) => solution.masses.len(),
            Self::Smooth(solution) => solution.unknowns(),
        }
    }

    /// In plane units.
    pub fn conformal_radius(&self) -> f64 {
        match self {
            Self::Polygon(solution) => {
                let unit = solution.discretisation().boundary.unit;
                solution.potential.at(solution.discretisation(), solution.center).re.exp() / unit
            }
            Self::Smooth(solution) => solution.conformal_radius(),
        }
    }

    /// Measure from vertex 0 to each vertex.
    pub fn vertex_measures(&self) -> Vec<f64> {
        match self {
            Self::Polygon(solution) => solution.correspondence.vertex_measures(),
            Self::Smooth(solution) => {
                let count = solution.curve().points().len();
                (0..count).map(|k| solution.measure(TAU * k as f64 / count as f64)).collect()
            }
        }
    }

    /// Measure from vertex 0 to a boundary point.
    pub fn measure_at(&self, point: BoundaryPoint) -> f64 {
        match self {
            Self::Polygon(solution) => solution.measure_at(point),
            Self::Smooth(solution) => solution.measure(solution.curve().parameter(point)),
        }
    }

    /// The boundary point where a measure from vertex 0 is reached; the inverse of [`Solved::measure_at`].
    pub fn boundary_point(&self, region: &Region, measure: f64) -> BoundaryPoint {
        match self {
            Self::Polygon(solution) => {
                let (edge, t) = solution.locate(measure);
                let (a, b) = region.polygon().edge(edge);
                match t {
                    t if t < 1.0 => BoundaryPoint { edge, t, point: a + (b - a) * t },
                    _ => BoundaryPoint { edge: (edge + 1) % region.polygon().len(), t: 0.0, point: b },
                }
            }
            Self::Smooth(solution) => solution.curve().place(solution.parameter(measure)),
        }
    }

    /// Region → disk for a point of the closed region.
    pub fn to_disk(&self, region: &Region, z: Complex64) -> Complex64 {
        let nearest = region.nearest(z);
        if (nearest.point - z).norm() < 4.0 * f64::EPSILON * region.polygon().size() {
            return Complex64::cis(TAU * self.measure_at(nearest));
        }
        match self {
            Self::Polygon(solution) => solution.to_disk(nearest, z),
            Self::Smooth(solution) => solution.to_disk(z).0,
        }
    }
}
