//! The maps of one region for several centers, and how they are linked.

use super::link::Link;
use super::position::Position;
use super::power_series::{MAX_COEFFICIENTS, exp_without_constant};
use super::walls::Walls;
use super::zone::Zones;
use crate::plane::Complex64;
use crate::symm::far_center::solve_far;
use crate::symm::local_series::LocalSeries;
use crate::symm::measure::Measure;
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::solution::Solution;
use std::sync::Arc;

/// One center's map region → disk, with vertex 0 ↦ 1 (scaled units).
#[derive(Clone, Debug)]
pub struct Chart {
    measure: Measure,
    series: LocalSeries,
    /// Where its boundary has one power series.
    pub zones: Zones,
}

impl Chart {
    fn new(measure: Measure, series: LocalSeries, walls: &Walls) -> Self {
        let boundary = &measure.discretisation.boundary;
        let zones = Zones::new(boundary, walls, &[measure.center], |zone| measure.on_edge(zone.on_edge(boundary, 0.0)));
        Self { series, zones, measure }
    }

    /// The point that goes to 0.
    #[must_use]
    pub fn center(&self) -> Complex64 {
        self.measure.center
    }

    /// Where on the boundary a harmonic measure from vertex 0 is reached.
    #[must_use]
    pub fn boundary_point(&self, measure: f64) -> Complex64 {
        let (edge, share) = self.measure.locate(measure);
        let boundary = &self.measure.discretisation.boundary;
        let (a, b) = (boundary.vertices[edge], boundary.vertices[boundary.next(edge)]);
        a + (b - a) * share
    }

    /// Writes the coefficients of tᵏ of the map at `center` + `radius`·t.
    pub fn expand(&self, center: Complex64, radius: f64, coefficients: &mut [Complex64]) {
        let mut log = [Complex64::ZERO; MAX_COEFFICIENTS];
        let log = &mut log[..coefficients.len()];
        self.series.expand(center, radius, log);
        log.iter_mut().for_each(|b| *b = -*b);
        exp_without_constant(log, coefficients);
        // Times (z − z₀) e^{log₀}.
        let scale = log[0].exp();
        let (constant, linear) = (scale * (center - self.measure.center), scale * radius);
        for k in (1..coefficients.len()).rev() {
            coefficients[k] = coefficients[k] * constant + coefficients[k - 1] * linear;
        }
        coefficients[0] *= constant;
    }

    /// The map by direct summation, anywhere in the region.
    #[must_use]
    pub fn direct(&self, z: Complex64) -> Complex64 {
        self.measure.map(z)
    }

    /// Harmonic measure from vertex 0 to the point of `edge` at the given distances from its ends.
    #[must_use]
    pub fn measure(&self, place: (usize, f64, f64)) -> f64 {
        self.measure.on_edge(place)
    }

    fn bytes(&self) -> usize {
        self.series.bytes() + self.measure.bytes() + std::mem::size_of_val(&self.zones.list[..])
    }
}

/// Whether other charts serve a part of a disk better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taken {
    /// They do not.
    Not,
    /// A part of it.
    Partly,
    /// All of it, this one best.
    Whole(usize),
}

/// Charts, the first of which belongs to the region's own center.
#[derive(Clone, Debug)]
pub struct Atlas {
    /// The charts.
    pub charts: Vec<Arc<Chart>>,
    /// `links[i][j]`: chart j → chart i.
    links: Vec<Vec<Link>>,
    /// Chart i → chart 0, in polar form.
    pub positions: Vec<Position>,
    /// For each chart but the first its parent, where it lies there, and where that lies in it.
    steps: Vec<(usize, [Complex64; 2])>,
    /// The boundary, asked for distances.
    pub walls: Walls,
    options: SolveOptions,
}

/// No chart is added when all have as many masses together as this
const UNKNOWNS: usize = 100_000;
/// and this times those of the first, so that large regions do not run out of memory over their small bays.
const UNKNOWNS_PER_FIRST: usize = 4;
/// Disk → region, another chart takes over where it stretches by this much more; well beyond the middle between two centers.
const TAKE_OVER: f64 = 40.0;
/// Region → disk, a neighbouring chart serves better where it stretches by this much more.
pub const BETTER: f64 = 1.2;

impl Atlas {
    /// With the region's own center only. Points as near to the boundary as `thickness` are on it.
    #[must_use]
    pub fn new(solution: &Solution, thickness: f64, options: &SolveOptions) -> Self {
        let walls = Walls::new(&solution.discretisation().boundary, thickness);
        let measure = Measure::from(solution);
        let series = measure.series();
        let charts = vec![Arc::new(Chart::new(measure, series, &walls))];
        Self {
            charts,
            links: vec![vec![Link::IDENTITY]],
            positions: vec![Position::FIRST],
            steps: Vec::new(),
            walls,
            options: options.clone(),
        }
    }

    /// Chart `from` → chart `to`.
    #[must_use]
    pub fn link(&self, to: usize, from: usize) -> &Link {
        &self.links[to][from]
    }

    /// Adds a chart around `center`, where chart `parent` is still good. False if there are too many, or no map was found.
    pub fn add(&mut self, center: Complex64, parent: usize, progress: Progress) -> bool {
        let first = &self.charts[0].measure;
        let near = &self.charts[parent];
        let unknowns: usize = self.charts.iter().map(|chart| chart.measure.masses.len()).sum();
        let affordable = UNKNOWNS + UNKNOWNS_PER_FIRST * first.masses.len();
        if self.charts.len() >= self.options.max_charts || unknowns >= affordable {
            return false;
        }
        let Ok(Some((measure, series))) = solve_far(first, &near.measure, center, &self.options, progress) else {
            return false;
        };
        let chart = Chart::new(measure, series, &self.walls);
        let (mut there, mut back) = ([Complex64::ZERO; 2], [Complex64::ZERO; 2]);
        near.expand(center, TINY, &mut there);
        chart.expand(near.measure.center, TINY, &mut back);
        let from_parent = Link::new(there[0], back[0]);
        let mut row: Vec<Link> =
            (0..self.charts.len()).map(|from| from_parent.after(&self.links[parent][from])).collect();
        for (to, links) in self.links.iter_mut().enumerate() {
            links.push(row[to].inverse());
        }
        row.push(Link::IDENTITY);
        self.links.push(row);
        self.positions.push(self.positions[parent].next(there[0], back[0]));
        self.steps.push((parent, [there[0], back[0]]));
        self.charts.push(Arc::new(chart));
        true
    }

    /// The positions of all charts, if the first one's is `first`.
    #[must_use]
    pub fn positions_from(&self, first: Position) -> Vec<Position> {
        let mut positions = vec![first];
        for (parent, [there, back]) in &self.steps {
            positions.push(positions[*parent].next(*there, *back));
        }
        positions
    }

    /// Expands the map of the chart that serves best around `center`, tried from `hint` on; returns which it is.
    pub fn expand_best(&self, hint: usize, center: Complex64, radius: f64, coefficients: &mut [Complex64]) -> usize {
        let mut best = hint;
        self.charts[best].expand(center, radius, coefficients);
        for _ in 1..self.charts.len() {
            let Some(next) = self.better_chart(best, coefficients[0], BETTER) else { break };
            best = next;
            self.charts[best].expand(center, radius, coefficients);
        }
        best
    }

    /// The chart that stretches most at `w` of `chart`'s disk, if by more than `by`.
    #[must_use]
    pub fn better_chart(&self, chart: usize, w: Complex64, by: f64) -> Option<usize> {
        let stretch = |to: usize| self.links[to][chart].stretch(w);
        let others = (0..self.charts.len()).filter(|&to| to != chart);
        others.max_by(|&i, &j| stretch(i).total_cmp(&stretch(j))).filter(|&best| stretch(best) > by)
    }

    /// Whether chart `to` stretches more than `chart` at `w` of its disk.
    #[must_use]
    pub fn serves_better(&self, to: usize, chart: usize, w: Complex64) -> bool {
        let stretch = self.links[to][chart].stretch(w);
        // Of what is NaN nothing is known.
        to != chart && (stretch > BETTER || stretch.is_nan())
    }

    /// Whether others should be asked for what lies within `radius` of `w` in `chart`'s disk.
    #[must_use]
    pub fn taken_over(&self, chart: usize, w: Complex64, radius: f64) -> Taken {
        let center = w / w.norm().max(1.0);
        let mut best = (TAKE_OVER, Taken::Not);
        for to in (0..self.charts.len()).filter(|&to| to != chart) {
            let (least, most) = self.links[to][chart].stretch_within(center, radius);
            if least > best.0 {
                best = (least, Taken::Whole(to));
            } else if most > TAKE_OVER.max(4.0 * least) && best.1 == Taken::Not {
                best.1 = Taken::Partly;
            }
        }
        best.1
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.charts.iter().map(|chart| chart.bytes()).sum()
    }
}

/// Radius of a series of which only the value counts.
const TINY: f64 = 1e-30;
