//! Either kind of region's map, both ways, in plane units.

use super::super::solved::Solved;
use super::disk_point::DiskPoint;
use super::expansions::{BEYOND_CIRCLE, Expansions};
use super::passage::Compass;
use super::position::Position;
use crate::plane::{Complex64, Region};
use crate::symm::options::SolveOptions;
use crate::symm::smooth::SmoothSolution;
use std::f64::consts::TAU;

/// Region ↔ disk with vertex 0 ↦ 1.
#[derive(Debug)]
pub enum Evaluator {
    /// Expansions around many points.
    Polygon {
        /// In scaled units.
        expansions: Box<Expansions>,
        /// Plane units × unit = scaled units.
        unit: f64,
    },
    /// Cauchy's formula, which needs nothing built.
    Smooth {
        /// The curve.
        region: Box<Region>,
        /// Values on it.
        solution: Box<SmoothSolution>,
    },
}

/// In units of the disk, or of the region's size: nearer to the boundary than this is on it.
const ON_BOUNDARY: f64 = 4.0 * f64::EPSILON;

static ONE_POSITION: [Position; 1] = [Position::FIRST];

impl Evaluator {
    /// Builds what the kind of region needs.
    #[must_use]
    pub(in super::super) fn new(region: &Region, solved: &Solved, options: &SolveOptions) -> Self {
        match solved {
            Solved::Polygon(solution) => Self::Polygon {
                expansions: Box::new(Expansions::new(solution, options)),
                unit: solution.discretisation().boundary.unit,
            },
            Solved::Smooth(solution) => {
                Self::Smooth { region: Box::new(region.clone()), solution: Box::new(solution.clone()) }
            }
        }
    }

    /// Region → disk; `None` outside the closed region.
    #[inline]
    #[must_use]
    pub fn to_disk(&self, z: Complex64) -> Option<DiskPoint> {
        match self {
            Self::Polygon { expansions, unit } => expansions.to_disk(z * unit),
            Self::Smooth { .. } => self.to_disk_with_slope(z).map(|(point, _)| point),
        }
    }

    /// Region → disk, with the derivative in the point's chart.
    #[inline]
    #[must_use]
    pub fn to_disk_with_slope(&self, z: Complex64) -> Option<(DiskPoint, Complex64)> {
        match self {
            Self::Polygon { expansions, unit } => {
                let (point, slope) = expansions.to_disk_with_slope(z * unit)?;
                Some((point, slope * unit))
            }
            Self::Smooth { region, solution } => {
                if !region.contains(z) {
                    return None;
                }
                let (w, slope) = solution.to_disk(z);
                let nearest = region.nearest(z);
                if (nearest.point - z).norm() > ON_BOUNDARY * region.polygon().size() {
                    return Some((DiskPoint::flat(w), slope));
                }
                let measure = solution.measure(solution.curve().parameter(nearest));
                Some((DiskPoint::flat(Complex64::cis(TAU * measure)), slope))
            }
        }
    }

    /// The point as a number.
    #[inline]
    #[must_use]
    pub fn flat(&self, point: DiskPoint) -> Complex64 {
        match self {
            Self::Polygon { expansions, .. } => expansions.flat(point),
            Self::Smooth { .. } => point.w,
        }
    }

    /// The derivative of [`Evaluator::flat`].
    #[inline]
    #[must_use]
    pub fn flat_slope(&self, point: DiskPoint) -> Complex64 {
        match self {
            Self::Polygon { expansions, .. } => expansions.flat_slope(point),
            Self::Smooth { .. } => Complex64::ONE,
        }
    }

    /// Where the charts lie, `toward` being a point of the boundary that goes to 1 when the disk is turned by
    /// −`toward_measure`.
    #[must_use]
    pub fn compass(&self, toward: Complex64, toward_measure: f64) -> Compass<'_> {
        let positions = match self {
            Self::Polygon { expansions, .. } => expansions.positions(),
            Self::Smooth { .. } => &ONE_POSITION,
        };
        let flat = Position::FIRST.direction_of(TAU * toward_measure);
        // Its own chart knows best where a far one is.
        let seen = |point: DiskPoint| positions[point.chart].direction_of(point.w.arg());
        let known = self.to_disk(toward).filter(|point| point.chart != 0);
        Compass { positions, toward: known.map_or(flat, seen) }
    }

    /// Disk → region; `None` outside the closed disk.
    #[inline]
    #[must_use]
    pub fn to_region(&self, point: DiskPoint) -> Option<Complex64> {
        match self {
            Self::Polygon { expansions, unit } => expansions.to_region(point).map(|z| z / unit),
            Self::Smooth { .. } => self.smooth_from_disk(point.w),
        }
    }

    /// Disk → region, with the derivative by the point's number in its chart.
    #[inline]
    #[must_use]
    pub fn to_region_with_slope(&self, point: DiskPoint) -> Option<(Complex64, Complex64)> {
        match self {
            Self::Polygon { expansions, unit } => {
                let (z, slope) = expansions.to_region_with_slope(point)?;
                Some((z / unit, slope / unit))
            }
            Self::Smooth { solution, .. } => {
                let z = self.smooth_from_disk(point.w)?;
                Some((z, solution.to_disk(z).1.inv()))
            }
        }
    }

    fn smooth_from_disk(&self, w: Complex64) -> Option<Complex64> {
        let Self::Smooth { solution, .. } = self else { return None };
        let square = w.norm_sqr();
        if square.is_nan() || square > BEYOND_CIRCLE {
            return None;
        }
        if (square - 1.0).abs() <= 2.0 * ON_BOUNDARY {
            return Some(solution.curve().place(solution.parameter(w.arg() / TAU)).point);
        }
        Some(solution.from_disk(w))
    }

    /// Builds now what is otherwise built when it is first asked for.
    pub fn prepare(&self) {
        if let Self::Polygon { expansions, .. } = self {
            expansions.prepare();
        }
    }

    /// Number of centers whose maps are linked.
    #[must_use]
    pub fn charts(&self) -> usize {
        match self {
            Self::Polygon { expansions, .. } => expansions.charts(),
            Self::Smooth { .. } => 1,
        }
    }

    /// Bytes of memory beyond the solution, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        match self {
            Self::Polygon { expansions, .. } => expansions.bytes(),
            Self::Smooth { .. } => 0,
        }
    }
}
