//! B as a function, a million points at a time: power series in squares of the domain, and one in 1/z far away.

use super::super::atlas::accuracy::Accuracy;
use super::super::atlas::quadtree::square_around;
use super::super::atlas::walls::Walls;
use super::curve_squares::CurveSquares;
use super::cuts::Cuts;
use super::edge_squares::EdgeSquares;
use super::far_series::FarSeries;
use super::inside::{Ground, Inside};
use super::polygon_squares::PolygonSquares;
use crate::Result;
use crate::plane::{Complex64, Domain};
use crate::symm::curved::field::CurvedField;
use crate::symm::field::Field;
use crate::symm::options::Progress;
use crate::symm::problem::Source;
use crate::symm::smooth_field::SmoothField;
use std::sync::Arc;

/// Expansions that cover a domain, in scaled units.
#[derive(Debug)]
pub struct Evaluator {
    squares: Squares,
    /// Of an unbounded domain, beyond the squares.
    far: Option<FarSeries>,
    source: Source,
    /// Of L,
    cuts: Cuts,
    /// and of B.
    cuts_with_source: Cuts,
}

#[derive(Debug)]
enum Squares {
    Polygons(PolygonSquares),
    Curves(CurveSquares),
    Edges(EdgeSquares),
}

/// What the expansions say of a point.
pub enum Found {
    /// (B, B'), B on some branch.
    Known(Complex64, Complex64),
    /// No expansion reaches it: it lies on a wall, beside one, or outside.
    Unknown,
    /// It lies clearly outside.
    Outside,
}

/// Of an unbounded domain, the squares reach this many times as far as the bodies.
const REACH: f64 = 2.5;

impl Evaluator {
    /// Of a polygon's field; of no use once `progress` has returned false. Points as near to the boundary as `thickness` are on it.
    #[must_use]
    pub fn of_polygons(field: &Field, thickness: f64, accuracy: Accuracy, progress: Progress) -> Self {
        let boundary = field.boundary();
        let (walls, series) = (Walls::new(boundary, thickness), field.series());
        let (ground, far) = ground(&boundary.vertices, boundary.bounded, &|z| {
            let mut coefficients = [Complex64::ZERO; 2];
            let radius = 0.1 * walls.nearest_of_all(z).distance;
            series.expand(z, radius, &mut coefficients);
            coefficients[1] / radius
        });
        let squares = Squares::Polygons(PolygonSquares::new(field, walls, series, ground, accuracy, progress));
        Self::new(squares, far, &field.source, field.charges().collect())
    }

    /// Of a smooth curve's field on `domain`, whose coordinates are (z − origin) × unit.
    #[must_use]
    pub fn of_curves(field: &SmoothField, domain: &Arc<Domain>, (origin, unit): (Complex64, f64)) -> Self {
        let corners = corners_of(domain, (origin, unit));
        let (ground, far) = ground(&corners, domain.is_bounded(), &|z| field.log_slope(z));
        let squares = Squares::Curves(CurveSquares::new(field, domain, (origin, unit), ground));
        let charges = field.charged_holes().map(|(charge, point)| (point, charge)).collect();
        Self::new(squares, far, &field.source, charges)
    }

    /// Of a field on `domain`, bounded by analytic edges, whose coordinates are (z − origin) × unit.
    #[must_use]
    pub fn of_edges(field: &CurvedField, domain: &Domain, scale: (Complex64, f64), solve_error: f64) -> Self {
        let (ground, far) = ground(&corners_of(domain, scale), domain.is_bounded(), &|z| field.log_slope(z));
        let squares = Squares::Edges(EdgeSquares::new(field, ground, solve_error));
        Self::new(squares, far, &field.source, field.charged_holes().collect())
    }

    #[inline(never)]
    fn new(squares: Squares, far: Option<FarSeries>, source: &Source, charges: Vec<(Complex64, f64)>) -> Self {
        let charges: Vec<_> = charges.into_iter().map(|(point, charge)| (point, Complex64::from(charge))).collect();
        let mut with_source = charges.clone();
        with_source.extend(source.logs.iter().map(|(point, factor)| (*point, -factor)));
        let (cuts, cuts_with_source) = (Cuts::new(charges), Cuts::new(with_source));
        Self { squares, far, source: source.clone(), cuts, cuts_with_source }
    }

    /// (B, B') beside a wall, if the squares know it there.
    #[must_use]
    pub fn beside(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        if let Squares::Edges(squares) = &self.squares { squares.beside(z) } else { None }
    }

    /// Makes what would be made when it is first asked for.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was made by then is kept.
    pub fn fill(&self, progress: Progress) -> Result<()> {
        match &self.squares {
            Squares::Polygons(_) => Ok(()),
            Squares::Curves(squares) => squares.fill(progress),
            Squares::Edges(squares) => squares.fill(progress),
        }
    }

    /// (B, B') at a point (scaled units).
    #[inline]
    #[must_use]
    pub fn at(&self, z: Complex64) -> Found {
        match (self.inside(z), &self.far) {
            (Inside::Log(value, slope), _) => self.less_source(z, (value, slope)),
            (Inside::Whole(value, slope), _) => Found::Known(value, slope),
            (Inside::Unknown, _) => Found::Unknown,
            (Inside::Beyond, Some(far)) => self.less_source(z, far.at(z)),
            (Inside::Outside | Inside::Beyond, _) => Found::Outside,
        }
    }

    /// What is to be added to B as [`Evaluator::at`] has it, to have it on the branch of direct summation.
    #[must_use]
    pub fn branch(&self, z: Complex64) -> Complex64 {
        match (self.inside(z), &self.far, &self.squares) {
            (Inside::Beyond, Some(far), _) => self.cuts.differing(far.middle(), z),
            (_, _, Squares::Polygons(squares)) => squares.branch(z, [&self.cuts, &self.cuts_with_source]),
            (_, _, Squares::Curves(squares)) => squares.branch(z, &self.cuts),
            // Logarithms are principal ones.
            (_, _, Squares::Edges(_)) => Complex64::ZERO,
        }
    }

    /// By how much that branch jumps on the straight way between two points.
    #[must_use]
    pub fn jump(&self, from: Complex64, to: Complex64) -> Complex64 {
        self.cuts_with_source.jump(from, to)
    }

    /// What the squares say of a point.
    #[inline]
    fn inside(&self, z: Complex64) -> Inside {
        match &self.squares {
            Squares::Polygons(squares) => squares.at(z),
            Squares::Curves(squares) => squares.at(z),
            Squares::Edges(squares) => squares.at(z),
        }
    }

    #[inline]
    fn less_source(&self, z: Complex64, (value, slope): (Complex64, Complex64)) -> Found {
        let (source, source_slope) = self.source.at(z);
        Found::Known(value - source, slope - source_slope)
    }
}

/// The corners of the boxes around a domain's contours, as (z − origin) × unit.
fn corners_of(domain: &Domain, (origin, unit): (Complex64, f64)) -> Vec<Complex64> {
    let boxes = domain.contours().iter().map(|contour| contour.outline().bounds());
    let corners =
        boxes.flat_map(|(low, high)| [low, high, Complex64::new(low.re, high.im), Complex64::new(high.re, low.im)]);
    corners.map(|z| (z - origin) * unit).collect()
}

/// The square to be cut, and what holds beyond it; `slope` gives L'.
fn ground(points: &[Complex64], bounded: bool, slope: &dyn Fn(Complex64) -> Complex64) -> (Ground, Option<FarSeries>) {
    let (middle, half) = square_around(points);
    if bounded {
        return (Ground { center: middle, half }, None);
    }
    let reach = points.iter().map(|z| (z - middle).norm()).fold(0.0, f64::max);
    (Ground { center: middle, half: REACH * reach }, Some(FarSeries::new(middle, reach, slope)))
}
