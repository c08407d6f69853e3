//! Lines on which the imaginary part of an analytic function of a domain has given values: traced from point to point by the
//! function itself, so that every point lies on its line as exactly as the function is known.

use super::super::polyline::TURN;
use super::field::DomainField;
use crate::plane::{Complex64, distance_to_segment};
use rustc_hash::FxHashSet;
use std::f64::consts::TAU;

/// A line on which a function has one value: a polyline fine enough to look smooth.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelLine {
    /// The value.
    pub level: f64,
    /// Its points in order; the fluid, or the field, runs that way along streamlines and lines of force.
    pub points: Vec<Complex64>,
    /// Whether the last point is joined to the first.
    pub closed: bool,
}

/// F = factor · B + shift; the lines are those of Im F.
#[derive(Clone, Copy, Debug)]
pub struct Function<'a> {
    /// B.
    pub field: &'a DomainField,
    /// Of B.
    pub factor: Complex64,
    /// What is added.
    pub shift: Complex64,
}

/// A box of the plane: its lower left and upper right corner.
pub type Window = (Complex64, Complex64);

/// Cells along the window's longer side: lines are found where they cross their edges.
const CELLS: f64 = 72.0;
/// Points of a line are not farther apart than this share of a cell,
const LONGEST: f64 = 0.9;
/// nor nearer than this unless the line ends.
const SHORTEST: f64 = 1e-4;
/// Points of a line, at most.
const MOST_POINTS: usize = 20_000;
/// Lines leave a point of rest from a circle of this share of a cell, and end at singular points in such a one.
const CIRCLE: f64 = 0.02;
/// Directions that are tried there.
const DIRECTIONS: usize = 96;
/// A level is that of a point of rest if it differs by less than this share of what F changes by over a cell.
const SAME_LEVEL: f64 = 1e-6;

impl Function<'_> {
    /// (Im F, F') at a point; `None` outside the closed domain.
    #[must_use]
    pub fn at(&self, z: Complex64) -> Option<(f64, Complex64)> {
        let (value, slope) = self.field.branched(z)?;
        Some(((self.factor * value + self.shift).im, self.factor * slope))
    }

    /// By how much Im F jumps where the straight way from one point to another crosses cuts.
    fn jump(&self, from: Complex64, to: Complex64) -> f64 {
        (self.factor * self.field.jump(from, to)).im
    }

    /// All lines of the levels in a window. `rests` are the points where F' is 0: lines that meet there do so exactly.
    #[must_use]
    pub fn lines(&self, levels: &[f64], window: Window, rests: &[Complex64]) -> Vec<LevelLine> {
        let lattice = Lattice::new(self, window);
        let Some(lattice) = lattice else { return Vec::new() };
        levels.iter().filter(|level| level.is_finite()).flat_map(|&level| lattice.lines(level, rests)).collect()
    }

    /// The line through a point, forwards along F' > 0, until it ends.
    #[must_use]
    pub fn line_from(&self, start: Complex64, window: Window) -> Option<LevelLine> {
        let lattice = Lattice::empty(self, window)?;
        let (_, slope) = self.at(start)?;
        // On a wall the branch is another.
        let point = start + slope.conj() / slope.norm() * (SHORTEST * lattice.cell);
        let (level, _) = self.at(point)?;
        let mut line = lattice.trace(Start { point, level, forwards: true }, &[]);
        line.points.insert(0, start);
        Some(LevelLine { level, points: line.points, closed: line.closed })
    }

    /// Points of a window inside the domain where F' is 0.
    #[must_use]
    pub fn rests_inside(&self, window: Window) -> Vec<Complex64> {
        let Some(lattice) = Lattice::new(self, window) else { return Vec::new() };
        lattice.rests()
    }
}

/// F at the corners of square cells.
struct Lattice<'a> {
    function: &'a Function<'a>,
    window: Window,
    cell: f64,
    columns: usize,
    rows: usize,
    /// (Im F, F') at the corners, row by row.
    values: Vec<Option<(f64, Complex64)>>,
    /// Where lines end that come near: what wells up or turns there has all levels.
    ends: Vec<Complex64>,
}

/// Where a line begins.
struct Start {
    point: Complex64,
    level: f64,
    /// Along F' > 0, or against it.
    forwards: bool,
}

struct Traced {
    points: Vec<Complex64>,
    closed: bool,
}

/// A point of rest whose level is that of the line.
struct Node {
    at: Complex64,
    /// Radius of the circle that lines leave from.
    radius: f64,
}

impl<'a> Lattice<'a> {
    fn empty(function: &'a Function<'a>, window: Window) -> Option<Self> {
        let size = window.1 - window.0;
        let cell = size.re.max(size.im) / CELLS;
        if !(size.re > 0.0 && size.im > 0.0 && cell.is_finite()) {
            return None;
        }
        let count = |length: f64| (length / cell).ceil() as usize + 1;
        let (columns, rows) = (count(size.re), count(size.im));
        let ends = function.field.singularities();
        Some(Self { function, window, cell, columns, rows, values: Vec::new(), ends })
    }

    fn new(function: &'a Function<'a>, window: Window) -> Option<Self> {
        let mut lattice = Self::empty(function, window)?;
        let places = 0..lattice.columns * lattice.rows;
        lattice.values = places.map(|k| function.at(lattice.place(k))).collect();
        Some(lattice)
    }

    fn place(&self, k: usize) -> Complex64 {
        // Not where polygons on round numbers have their edges.
        const OFF: f64 = 0.137;
        self.window.0 + Complex64::new((k % self.columns) as f64 - OFF, (k / self.columns) as f64 - OFF) * self.cell
    }

    /// The lines of one level.
    fn lines(&self, level: f64, rests: &[Complex64]) -> Vec<LevelLine> {
        let nodes: Vec<Node> = rests
            .iter()
            .filter(|&&z| self.function.at(z).is_some_and(|(value, _)| (value - level).abs() <= self.same(z)))
            .map(|&at| {
                let others = rests.iter().map(|z| (z - at).norm()).filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min);
                Node { at, radius: (CIRCLE * self.cell).min(0.1 * others) }
            })
            .collect();
        let mut crossed = FxHashSet::default();
        let mut lines = Vec::new();
        for node in &nodes {
            for start in self.leaving(node, level) {
                let forwards = start.forwards;
                let mut line = self.trace(start, &nodes);
                line.points.insert(0, node.at);
                // Of a line between two nodes, the one that is found second is the same.
                let known = line.points.windows(2).any(|pair| self.crossings(pair).any(|edge| crossed.contains(&edge)));
                if known {
                    continue;
                }
                self.mark(&line, &mut crossed);
                if !forwards {
                    line.points.reverse();
                }
                lines.push(LevelLine { level, points: line.points, closed: line.closed });
            }
        }
        for edge in self.edges() {
            if crossed.contains(&edge) {
                continue;
            }
            let Some((point, level_here)) = self.crossing(edge, level) else { continue };
            if lines.iter().any(|line| self.holds(line, point)) {
                continue;
            }
            let forth = self.trace(Start { point, level: level_here, forwards: true }, &nodes);
            let mut line = forth;
            if !line.closed {
                let mut back = self.trace(Start { point, level: level_here, forwards: false }, &nodes);
                back.points.reverse();
                back.points.pop();
                back.points.append(&mut line.points);
                line.points = back.points;
            }
            self.mark(&line, &mut crossed);
            crossed.insert(edge);
            if line.points.len() > 1 {
                lines.push(LevelLine { level, points: line.points, closed: line.closed });
            }
        }
        lines
    }

    /// What counts as the same level at a point.
    fn same(&self, z: Complex64) -> f64 {
        let nearby = [1.0, -1.0].map(|side| self.function.at(z + Complex64::new(0.0, side * self.cell)));
        let change = nearby.into_iter().flatten().map(|(_, slope)| slope.norm()).fold(0.0, f64::max);
        SAME_LEVEL * self.cell * change
    }

    /// Lines of its level that leave a point of rest: where Im F changes its sign around it.
    fn leaving(&self, node: &Node, level: f64) -> Vec<Start> {
        let at = |k: usize| node.at + Complex64::from_polar(node.radius, TAU * (k as f64 + 0.31) / DIRECTIONS as f64);
        let above = |z: Complex64| {
            let (value, _) = self.function.at(z)?;
            Some(value + self.function.jump(z, node.at) - level)
        };
        let around: Vec<Option<f64>> = (0..DIRECTIONS).map(|k| above(at(k))).collect();
        let mut starts = Vec::new();
        for k in 0..DIRECTIONS {
            let (Some(a), Some(b)) = (around[k], around[(k + 1) % DIRECTIONS]) else { continue };
            if (a > 0.0) == (b > 0.0) {
                continue;
            }
            let z = at(k) + (at(k + 1) - at(k)) * (a / (a - b));
            let Some((point, slope)) = self.corrected(z, level + self.function.jump(node.at, z)) else { continue };
            let forwards = (slope * (point - node.at)).re > 0.0;
            starts.push(Start { point, level: level + self.function.jump(node.at, point), forwards });
        }
        starts
    }

    /// The point of the line nearest to one beside it, and F' there.
    fn corrected(&self, mut z: Complex64, level: f64) -> Option<(Complex64, Complex64)> {
        const STEPS: usize = 8;
        let mut slope = Complex64::ZERO;
        for _ in 0..STEPS {
            let (value, here) = self.function.at(z)?;
            slope = here;
            let step = Complex64::new(0.0, level - value) / slope;
            if !step.is_finite() || step.norm() > self.cell {
                break;
            }
            z += step;
            if step.norm() <= 1e-14 * self.cell.max(z.norm()) {
                break;
            }
        }
        Some((z, self.function.at(z).map_or(slope, |(_, slope)| slope)))
    }

    /// The line from a point on it, one way.
    fn trace(&self, start: Start, nodes: &[Node]) -> Traced {
        let sign = if start.forwards { 1.0 } else { -1.0 };
        let direction = |slope: Complex64| sign * slope.conj() / slope.norm();
        let mut level = start.level;
        let mut line = Traced { points: vec![start.point], closed: false };
        let Some((_, mut slope)) = self.function.at(start.point) else { return line };
        let (longest, shortest) = (LONGEST * self.cell, SHORTEST * self.cell);
        let mut length = 0.2 * self.cell;
        let mut z = start.point;
        // Of the node that it left.
        let mut away = nodes.iter().all(|node| (node.at - z).norm() > 1.5 * node.radius);
        while line.points.len() < MOST_POINTS {
            let along = direction(slope);
            if !along.is_finite() {
                return line;
            }
            let middle = z + along * (0.5 * length);
            let ahead = self.function.at(middle).map(|(_, slope)| z + direction(slope) * length);
            let next = ahead.filter(|next| next.is_finite()).and_then(|next| {
                let level = level + self.function.jump(z, next);
                let (next, slope) = self.corrected(next, level)?;
                self.function.at(next)?;
                Some((next, slope))
            });
            let turn = next.map(|(next, slope)| {
                let chord = next - z;
                (chord * along.conj()).arg().abs().max((direction(slope) * along.conj()).arg().abs())
            });
            match (next, turn) {
                (Some((next, next_slope)), Some(turn)) if turn <= TURN || length <= shortest => {
                    if let Some(node) = nodes.iter().find(|node| (node.at - next).norm() <= node.radius)
                        && away
                    {
                        line.points.push(node.at);
                        return line;
                    }
                    if let Some(end) = self.end_between(z, next) {
                        line.points.push(end);
                        return line;
                    }
                    away = away || nodes.iter().all(|node| (node.at - next).norm() > 1.5 * node.radius);
                    if turn > 1.0 {
                        // Past a point of rest that nobody named.
                        return line;
                    }
                    level += self.function.jump(z, next);
                    if let Some(edge) = self.leaves(z, next) {
                        line.points.push(edge);
                        return line;
                    }
                    let first = line.points[0];
                    let closes = line.points.len() > 3
                        && distance_to_segment(first, z, next) <= 0.05 * length.min((next - z).norm())
                        && (direction(next_slope) * (line.points[1] - first).conj()).re > 0.0;
                    if closes {
                        line.closed = true;
                        return line;
                    }
                    line.points.push(next);
                    (z, slope) = (next, next_slope);
                    if turn < 0.5 * TURN {
                        length = (1.4 * length).min(longest);
                    }
                }
                _ if length > shortest => length *= 0.5,
                _ => {
                    // At a wall.
                    line.points.push(self.function.field.domain().nearest(z).place.point);
                    return line;
                }
            }
        }
        line
    }

    /// The singular point that the way from one point to the next comes near.
    fn end_between(&self, from: Complex64, to: Complex64) -> Option<Complex64> {
        let near = |end: &Complex64| {
            let is_ahead = ((end - from) * (to - from).conj()).re > 0.0;
            is_ahead && distance_to_segment(*end, from, to) <= CIRCLE * self.cell
        };
        self.ends.iter().copied().find(near)
    }

    /// Where the way from one point to the next leaves the window.
    fn leaves(&self, from: Complex64, to: Complex64) -> Option<Complex64> {
        let (low, high) = self.window;
        let mut share: Option<f64> = None;
        for (a, b, low, high) in [(from.re, to.re, low.re, high.re), (from.im, to.im, low.im, high.im)] {
            for edge in [low, high] {
                if (b < low || b > high) && (a - edge) * (b - edge) <= 0.0 && a != b {
                    let here = (edge - a) / (b - a);
                    share = Some(share.map_or(here, |share| share.min(here)));
                }
            }
        }
        share.map(|share| from + (to - from) * share)
    }

    /// Edges between neighbouring corners: the number of the first, and whether it goes up.
    fn edges(&self) -> impl Iterator<Item = (usize, bool)> {
        (0..self.columns * self.rows).flat_map(|k| [(k, false), (k, true)])
    }

    fn ends(&self, (k, up): (usize, bool)) -> Option<(usize, usize)> {
        let there = if up { k + self.columns } else { k + 1 };
        let exists = if up { there < self.values.len() } else { (k + 1) % self.columns != 0 };
        exists.then_some((k, there))
    }

    /// Where a line of a level crosses an edge, and its level there.
    fn crossing(&self, edge: (usize, bool), level: f64) -> Option<(Complex64, f64)> {
        let (first, second) = self.ends(edge)?;
        let (Some((a, slope_a)), Some((b, slope_b))) = (self.values[first], self.values[second]) else { return None };
        let (from, to) = (self.place(first), self.place(second));
        let b = b - self.function.jump(from, to);
        let crosses = (a - level) * (b - level) < 0.0;
        if !crosses {
            return None;
        }
        // The change must be what the slopes say: else a body lies between.
        let expected = (0.5 * (slope_a + slope_b) * (to - from)).im;
        if (b - a - expected).abs() > 0.5 * self.cell * (slope_a.norm() + slope_b.norm()) {
            return None;
        }
        let z = from + (to - from) * ((level - a) / (b - a));
        let level = level + self.function.jump(from, z);
        let (z, _) = self.corrected(z, level)?;
        self.function.at(z)?;
        let (low, high) = self.window;
        let within = z.re >= low.re && z.re <= high.re && z.im >= low.im && z.im <= high.im;
        within.then_some((z, level))
    }

    /// Whether a point of the level lies on a line that was traced: where that passes a corner of a cell, it may cross another
    /// edge than its pieces do.
    fn holds(&self, line: &LevelLine, point: Complex64) -> bool {
        // A piece turns by little, so that its line is near.
        const NEAR: f64 = 0.03;
        let near = |a: Complex64, b: Complex64| distance_to_segment(point, a, b) <= NEAR * self.cell;
        let joined = line.closed && near(line.points[line.points.len() - 1], line.points[0]);
        joined || line.points.windows(2).any(|pair| near(pair[0], pair[1]))
    }

    fn mark(&self, line: &Traced, crossed: &mut FxHashSet<(usize, bool)>) {
        for pair in line.points.windows(2) {
            crossed.extend(self.crossings(pair));
        }
        if let (true, Some(&last), Some(&first)) = (line.closed, line.points.last(), line.points.first()) {
            crossed.extend(self.crossings(&[last, first]));
        }
    }

    /// The edges that a piece of a line crosses, itself shorter than a cell.
    fn crossings(&self, pair: &[Complex64]) -> impl Iterator<Item = (usize, bool)> {
        let origin = self.place(0);
        let [p, q] = [0, 1].map(|k| (pair[k] - origin) / self.cell);
        let (columns, count) = (self.columns as f64, self.columns * self.rows);
        let number = move |x: f64, y: f64| {
            let known = x >= 0.0 && y >= 0.0 && x < columns;
            (known && (y * columns + x) < count as f64).then_some((y * columns + x) as usize)
        };
        let share = |a: f64, b: f64, edge: f64| (edge - a) / (b - a);
        let upright = (p.re.floor() != q.re.floor()).then(|| {
            let x = p.re.floor().max(q.re.floor());
            let y = p.im + (q.im - p.im) * share(p.re, q.re, x);
            number(x, y.floor()).map(|k| (k, true))
        });
        let level = (p.im.floor() != q.im.floor()).then(|| {
            let y = p.im.floor().max(q.im.floor());
            let x = p.re + (q.re - p.re) * share(p.im, q.im, y);
            number(x.floor(), y).map(|k| (k, false))
        });
        [upright.flatten(), level.flatten()].into_iter().flatten()
    }

    /// Points where F' is 0: its argument turns around their cells.
    fn rests(&self) -> Vec<Complex64> {
        let mut found: Vec<Complex64> = Vec::new();
        for k in 0..self.columns * (self.rows - 1) {
            if (k + 1).is_multiple_of(self.columns) {
                continue;
            }
            let corners = [k, k + 1, k + self.columns + 1, k + self.columns].map(|k| self.values[k]);
            let [Some((_, a)), Some((_, b)), Some((_, c)), Some((_, d))] = corners else { continue };
            let turn: f64 = [(a, b), (b, c), (c, d), (d, a)].iter().map(|(p, q)| (q * p.conj()).arg()).sum();
            if turn > 0.5 * TAU
                && let Some(z) = self.rest(self.place(k) + Complex64::new(0.5, 0.5) * self.cell)
                && found.iter().all(|other| (other - z).norm() > 1e-6 * self.cell)
            {
                found.push(z);
            }
        }
        found
    }

    /// Newton's method for F' = 0.
    fn rest(&self, mut z: Complex64) -> Option<Complex64> {
        let h = 1e-4 * self.cell;
        for _ in 0..30 {
            let slope = |z: Complex64| self.function.at(z).map(|(_, slope)| slope);
            let curvature = (slope(z + h)? - slope(z - h)?) / (2.0 * h);
            let step = slope(z)? / curvature;
            if step.is_nan() || step.norm() > 4.0 * self.cell {
                return None;
            }
            z -= step;
            if step.norm() <= 1e-13 * self.cell.max(z.norm()) {
                break;
            }
        }
        Some(z)
    }
}
