//! Another center far from the first, solved for where the first cannot tell what it sees.
//!
//! Seen from a new center c = f⁻¹(w), a part of the boundary with measure dμ₀ at e^{iθ} has the measure
//! (1 − |w|²)/|e^{iθ} − w|² dμ₀. That is accurate where e^{iθ} is not too near to w. The rest, of which the first center sees next
//! to nothing, is solved for; what lies far beyond it and is seen neither from c nor from the first center is left out, and
//! the solution tells whether it matters: there the potential does not vanish.

use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::known::Known;
use super::local_series::LocalSeries;
use super::measure::Measure;
use super::options::{Progress, SolveOptions};
use super::panel::{Boundary, Panel, halved_towards};
use super::panelled::Panelled;
use super::potential::LogPotential;
use super::rule::Rules;
use super::solution::{ERROR_PER_RESIDUAL, Solution};
use super::solve::{Effort, seen_from};
use super::system::System;
use crate::Result;
use crate::plane::Complex64;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// A panel of one center's seen from another.
struct Sight {
    /// At its nodes.
    masses: Vec<f64>,
    mass: f64,
    /// Distance in the first center's disk.
    away: f64,
    /// Length in the first center's circle.
    extent: f64,
}

/// Panels of less measure than this share of the tolerance are as coarse as they were at first.
const NEGLIGIBLE: f64 = 1e-3;
/// The error that the known part of the measure may cause, as a share of the tolerance.
const SHARE_OF_KNOWN: f64 = 0.003;
/// What is known lies at least this many times as far from the new center as that is from the circle,
const LEAST_AWAY: f64 = 10.0;
/// and is at most this share of that distance long, for the kernel to be smooth on it.
const LONGEST_KNOWN: f64 = 0.5;
/// Decades of measure beyond the tolerance within which walls are solved for at once.
const DECADES_BEYOND: f64 = 6.0;
/// Errors of masses that are seen are smaller than this share of the estimate times the kernel.
const NOISE: f64 = 0.5;

/// The error that what is left out may cause, as a share of the tolerance.
const SHARE_OF_UNSEEN: f64 = 0.03;
/// Walls that are no farther away than this times the nearest are seen.
const BESIDE: f64 = 3.0;
/// Attempts with something left out,
const MOST_ATTEMPTS: usize = 6;
/// each of which solves for this times as far.
const FARTHER: f64 = 2.0;
/// An attempt is given up where it takes more than this times the unknowns that it began with,
const MOST_GROWTH: usize = 2;
/// and this many.
const LEAST_UNKNOWNS: usize = 200;
/// More unknowns than these are not solved for: usual are a few hundred, and each attempt's matrices take memory beside those of the
/// region's own center, by a hundred megabytes for so many.
const MOST_UNKNOWNS: usize = 4000;

/// What is done about a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    /// Its masses are known: those of this panel of the nearer center.
    Known(usize),
    /// Nothing of it is seen.
    Unseen,
    /// It is solved for.
    Solved,
    /// It is solved for if that turns out to matter: nothing of it is seen, but nobody could know.
    Doubtful,
}

/// The region for `center` (scaled units), from what a center `near` it sees; `first` is the coarsest that panels get. `None` if
/// that takes too many unknowns.
///
/// # Errors
/// As [`solve`](super::solve::solve).
pub fn solve_far(
    first: &Measure,
    near: &Measure,
    center: Complex64,
    options: &SolveOptions,
    progress: Progress,
) -> Result<Option<(Measure, LocalSeries)>> {
    let w = near.map(center);
    let sights: Vec<Sight> = (0..near.discretisation.panels.len()).map(|q| sight(near, q, w)).collect();
    let mut far = Far { near, center, sights, tolerance: options.tolerance, reach: 0.0, away: 0.0 };
    (far.reach, far.away) = (far.first_reach(), far.first_away(w));
    let mut tried = Vec::new();
    for _ in 0..MOST_ATTEMPTS {
        let panels = far.panels(&first.discretisation.panels, &far.roles(w));
        // Going farther need not change anything.
        if panels != tried && panels.iter().any(|(_, role)| *role == Role::Solved) {
            let all_solved = panels.iter().all(|(_, role)| *role == Role::Solved);
            let effort = if all_solved { Effort::Whole } else { Effort::Trial };
            let Some(found) = far.solve(&panels, (options, effort), progress)? else { return Ok(None) };
            if all_solved || found.0.estimate <= options.tolerance && !far.overlooks(&panels, &found.1) {
                return Ok(Some(found));
            }
            tried = panels;
        }
        far.reach *= FARTHER;
        far.away *= FARTHER;
    }
    (far.reach, far.away) = (f64::INFINITY, f64::INFINITY);
    far.solve(&far.panels(&first.discretisation.panels, &far.roles(w)), (options, Effort::Whole), progress)
}

struct Far<'a> {
    near: &'a Measure,
    center: Complex64,
    /// Of the nearer center's panels.
    sights: Vec<Sight>,
    tolerance: f64,
    /// What is doubtful is solved for along the boundary from what is seen, as far as this.
    reach: f64,
    /// What is nearer than this in the nearer center's disk is solved for.
    away: f64,
}

impl Far<'_> {
    fn boundary(&self) -> &Arc<Boundary> {
        &self.near.discretisation.boundary
    }

    /// In a corridor, measure falls by e^π over each width.
    fn first_reach(&self) -> f64 {
        2.0 * self.clear() * (1.0 + (DECADES_BEYOND - self.tolerance.log10()) * std::f64::consts::LN_10 / PI)
    }

    /// Distance of the center from the walls.
    fn clear(&self) -> f64 {
        let panels = &self.near.discretisation.panels;
        panels.iter().map(|panel| panel.distance(self.boundary(), self.center)).fold(f64::INFINITY, f64::min)
    }

    /// Where the error of the nearer center's map, times the kernel, seen through the kernel, is a share of the tolerance.
    fn first_away(&self, w: Complex64) -> f64 {
        let depth = 1.0 - w.norm_sqr();
        let cube = depth * depth * self.error() / (3.0 * PI * SHARE_OF_KNOWN * self.tolerance);
        cube.cbrt().max(LEAST_AWAY * depth)
    }

    /// Of the nearer center's map.
    fn error(&self) -> f64 {
        self.near.estimate.max(0.1 * self.tolerance)
    }

    fn roles(&self, w: Complex64) -> Vec<Role> {
        let panels = &self.near.discretisation.panels;
        let noise = NOISE * self.error() * 4.0 / (1.0 - w.norm_sqr());
        let least = NEGLIGIBLE * self.tolerance / panels.len() as f64;
        let mut solved: Vec<bool> = self
            .sights
            .iter()
            .map(|sight| sight.away < self.away || sight.extent > LONGEST_KNOWN * sight.away)
            .collect();
        // Both panels of a corner: no quadrature should have to come to it from one side alone.
        for q in 0..panels.len() {
            let next = (q + 1) % panels.len();
            if panels[q].corner == panels[next].corner && panels[q].start == 0.0 && panels[next].start == 0.0 {
                let either = solved[q] || solved[next];
                (solved[q], solved[next]) = (either, either);
            }
        }
        let beside = BESIDE * self.clear();
        let is_seen = |q: usize, mass: f64| mass > noise || panels[q].distance(self.boundary(), self.center) <= beside;
        // Of what is long and not near, noise is no measure: it is known roughly how much of it is seen.
        let is_felt = |sight: &Sight| sight.away >= self.away && sight.mass.abs() > NEGLIGIBLE * self.tolerance;
        let role = |(q, sight): (usize, &Sight)| match solved[q] {
            true if is_seen(q, sight.mass) || is_felt(sight) => Role::Solved,
            true => Role::Doubtful,
            false if sight.mass.abs() > least => Role::Known(q),
            false => Role::Unseen,
        };
        self.sights.iter().enumerate().map(role).collect()
    }

    /// Of every panel whether it is doubtful, and so are those between it and one that is seen, which is within reach.
    fn reached(&self, roles: &[Role]) -> Vec<bool> {
        let (boundary, panels) = (self.boundary(), &self.near.discretisation.panels);
        let mut reached = vec![false; panels.len()];
        let mut walk = |order: &mut dyn Iterator<Item = usize>| {
            let mut last_seen = None;
            for q in order {
                let panel = &panels[q];
                match (roles[q], last_seen) {
                    (Role::Solved, _) => {
                        last_seen =
                            Some(boundary.vertices[panel.corner] + panel.direction * (0.5 * (panel.start + panel.end)));
                    }
                    (Role::Doubtful, Some(from)) if panel.distance(boundary, from) <= self.reach => reached[q] = true,
                    _ => last_seen = None,
                }
            }
        };
        // Twice around, for what lies beyond vertex 0.
        walk(&mut (0..panels.len()).chain(0..panels.len()));
        walk(&mut (0..panels.len()).rev().chain((0..panels.len()).rev()));
        reached
    }

    /// The panels, in boundary order, and what is done about each: known ones are the nearer center's, those solved for are as
    /// fine as it needed them where the new center sees them and at least short against their distance, others are coarse.
    fn panels(&self, coarse: &[Panel], roles: &[Role]) -> Vec<(Panel, Role)> {
        let boundary = self.boundary();
        let least = NEGLIGIBLE * self.tolerance;
        let reached = self.reached(roles);
        let fine: Vec<Seen> = (self.near.discretisation.panels.iter().zip(&self.sights).zip(roles.iter().zip(reached)))
            .map(|((panel, sight), (role, reached))| match role {
                Role::Doubtful if reached => (*panel, sight.mass.abs(), Role::Solved),
                role => (*panel, sight.mass.abs(), *role),
            })
            .collect();
        let counts = |mass: f64, role: Role| match role {
            Role::Known(_) => true,
            Role::Solved => mass > least,
            Role::Unseen | Role::Doubtful => false,
        };
        let mut panels = Vec::new();
        for (panel, role) in coarsened(coarse, &fine, &counts) {
            if role == Role::Solved {
                panels.extend(
                    halved_towards(self.center, LONGEST, boundary, vec![panel]).into_iter().map(|half| (half, role)),
                );
            } else {
                panels.push((panel, role));
            }
        }
        panels
    }

    fn solve(
        &self,
        panels: &[(Panel, Role)],
        (options, effort): (&SolveOptions, Effort),
        progress: Progress,
    ) -> Result<Option<(Measure, LocalSeries)>> {
        let boundary = self.boundary();
        let near = &self.near.discretisation;
        let mut rules = Rules::from_panels(near.order.clone(), &near.panels, &near.rules);
        let known_ones = panels.iter().filter_map(|(panel, role)| match role {
            Role::Known(q) => Some((*panel, &self.sights[*q].masses)),
            _ => None,
        });
        let (known_panels, known_masses): (Vec<Panel>, Vec<&Vec<f64>>) = known_ones.unzip();
        let known_masses: Vec<f64> = known_masses.into_iter().flatten().copied().collect();
        let known = Discretisation::of_known(Arc::clone(boundary), known_panels, &mut rules);
        let known = Arc::new(Known::new(&known, &known_masses));
        let asked = panels.iter().filter(|(_, role)| *role == Role::Solved).map(|(panel, _)| *panel).collect();
        let discretisation = Discretisation::new(Arc::clone(boundary), asked, &mut rules);
        if discretisation.unknowns() > MOST_UNKNOWNS {
            return Ok(None);
        }
        // Where it does not end soon, too much was taken for known, or for unseen.
        let most = MOST_GROWTH * discretisation.unknowns() + LEAST_UNKNOWNS;
        let options = SolveOptions { max_unknowns: most.min(options.max_unknowns), ..options.clone() };
        let system = Arc::new(System::new(discretisation, progress)?.with_known(&known));
        let solution = seen_from(self.center, system, rules.clone(), None, (&options, effort), progress)?;
        Ok(Some(self.merged(panels, &solution, &mut rules)))
    }

    /// What was solved for among what was known.
    fn merged(&self, panels: &[(Panel, Role)], solution: &Solution, rules: &mut Rules) -> (Measure, LocalSeries) {
        let p = rules.order.p();
        let mut all = Vec::with_capacity(panels.len());
        let mut masses = Vec::with_capacity(panels.len() * p);
        let mut solved = &solution.discretisation().panels[..];
        let mut solved_masses = &solution.masses[..];
        for (panel, role) in panels {
            match role {
                Role::Known(q) => {
                    all.push(*panel);
                    masses.extend_from_slice(&self.sights[*q].masses);
                }
                Role::Unseen | Role::Doubtful => {
                    all.push(*panel);
                    masses.extend(std::iter::repeat_n(0.0, p));
                }
                Role::Solved => {
                    let count = solved.iter().take_while(|part| part.is_within(panel)).count();
                    let (own, rest) = solved.split_at(count);
                    let (own_masses, other_masses) = solved_masses.split_at(count * p);
                    all.extend_from_slice(own);
                    masses.extend_from_slice(own_masses);
                    (solved, solved_masses) = (rest, other_masses);
                }
            }
        }
        let discretisation = Discretisation::of_known(Arc::clone(self.boundary()), all, rules);
        let correspondence = BoundaryCorrespondence::new(&discretisation, &masses);
        let measure = Measure {
            potential: LogPotential::new(&masses),
            discretisation,
            center: self.center,
            masses,
            correspondence,
            estimate: solution.error_estimate,
        };
        let series = measure.series();
        (measure, series)
    }

    /// Whether the potential says that something doubtful is seen after all.
    fn overlooks(&self, panels: &[(Panel, Role)], series: &LocalSeries) -> bool {
        let acceptable = SHARE_OF_UNSEEN * self.tolerance / ERROR_PER_RESIDUAL;
        let doubtful = panels.iter().filter(|(_, role)| *role == Role::Doubtful);
        let sees = |panel: &Panel| {
            let x = self.boundary().vertices[panel.corner] + panel.direction * panel.distance_at(0.5);
            let mut potential = [Complex64::ZERO];
            series.expand(x, 0.0, &mut potential);
            let missed = (potential[0].re - (x - self.center).norm().ln()).abs();
            missed > acceptable || missed.is_nan()
        };
        doubtful.map(|(panel, _)| panel).any(sees)
    }
}

/// Panels are halved at once until they are no longer than this times their distance from the center (measured: more of
/// them would be halved by their residuals anyway).
const LONGEST: f64 = 0.5;

/// What another center at `w` of the first's disk sees of panel `q`.
fn sight(first: &Measure, q: usize, w: Complex64) -> Sight {
    let nodes = &first.discretisation.order.panel.nodes;
    let p = nodes.len();
    let angle = |tau: f64| TAU * first.correspondence.measure(q, tau);
    let kernel = |theta: f64| (1.0 - w.norm_sqr()) / (Complex64::cis(theta) - w).norm_sqr();
    let moved = |(mass, t): (&f64, &f64)| mass * kernel(angle(0.5 * (t + 1.0)));
    let masses: Vec<f64> = first.masses[q * p..][..p].iter().zip(nodes).map(moved).collect();
    let [a, b] = [angle(0.0), angle(1.0)];
    // Between its ends where w looks at it.
    let middle = 0.5 * (a + b);
    let turn = w.arg() - middle;
    let facing = middle + (turn - TAU * (turn / TAU).round()).clamp(-0.5 * (a - b).abs(), 0.5 * (a - b).abs());
    let away = (Complex64::cis(facing) - w).norm();
    Sight { mass: masses.iter().sum(), masses, away, extent: (a - b).abs() }
}

type Seen = (Panel, f64, Role);

/// `coarse` panels in the halves that hold what counts of the `fine` panels into which they were halved. All in boundary
/// order.
fn coarsened(coarse: &[Panel], fine: &[Seen], counts: &dyn Fn(f64, Role) -> bool) -> Vec<(Panel, Role)> {
    let mut panels = Vec::with_capacity(2 * coarse.len());
    let mut rest = fine;
    for &whole in coarse {
        let parts = rest.split_at(parts_within(whole, rest));
        rest = parts.1;
        coarsen(whole, parts.0, counts, &mut panels);
    }
    panels
}

fn coarsen(whole: Panel, parts: &[Seen], counts: &dyn Fn(f64, Role) -> bool, panels: &mut Vec<(Panel, Role)>) {
    if let [(panel, _, role)] = parts {
        return panels.push((*panel, *role));
    }
    if !parts.iter().any(|(_, mass, role)| counts(*mass, *role)) {
        let has = |wanted: Role| parts.iter().any(|(_, _, role)| *role == wanted);
        let role = [Role::Solved, Role::Doubtful].into_iter().find(|role| has(*role)).unwrap_or(Role::Unseen);
        return panels.push((whole, role));
    }
    let [before, after] = whole.halves();
    let (first, second) = parts.split_at(parts_within(before, parts));
    coarsen(before, first, counts, panels);
    coarsen(after, second, counts, panels);
}

/// How many of the first panels lie within `whole`.
fn parts_within(whole: Panel, parts: &[Seen]) -> usize {
    parts.iter().take_while(|(part, _, _)| part.is_within(&whole)).count()
}

#[cfg(test)]
mod tests {
    use super::super::panel::initial_panels;
    use super::super::solve::solve;
    use super::*;
    use crate::plane::{Curve, Region};

    /// From the fourth width of a corridor of ten: what is known, what is solved for and what is left out give together what
    /// solving for everything gives.
    #[test]
    fn a_part_is_solved_for_and_the_whole_is_right() {
        let corridor = [(0.0, 0.0), (10.0, 0.0), (10.0, 4.0), (9.0, 4.0), (9.0, 1.0), (0.0, 1.0)];
        let vertices = corridor.map(|(x, y)| Complex64::new(x, y));
        let options = SolveOptions { tolerance: 1e-8, ..SolveOptions::default() };
        let solved = |center: Complex64| {
            let region = Region::new(&vertices, Curve::Polygon, center, vertices[0]).unwrap();
            Measure::from(&solve(&region, &options, &mut |_, _| true).unwrap())
        };
        let first = solved(Complex64::new(0.5, 0.5));
        let unit = first.discretisation.boundary.unit;
        let mut near = first.clone();
        for x in [2.0, 4.0] {
            let center = Complex64::new(x, 0.5);
            near = solve_far(&first, &near, center * unit, &options, &mut |_, _| true).unwrap().unwrap().0;
            let whole = solved(center);
            let bound = near.estimate + whole.estimate;
            for edge in 0..6 {
                for share in [0.1, 0.5, 0.9] {
                    let length = whole.discretisation.boundary.lengths[edge];
                    let place = (edge, share * length, (1.0 - share) * length);
                    let away = (near.on_edge(place) - whole.on_edge(place)).abs() * TAU;
                    assert!(away <= bound, "from {center}, edge {edge}: {away:e} against {bound:e}");
                }
            }
        }
    }

    #[test]
    fn panels_that_count_stay_fine_and_others_become_coarse() {
        let vertices = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
        let region = Region::new(&vertices, Curve::Polygon, Complex64::new(0.5, 0.5), vertices[0]).unwrap();
        let boundary = Boundary::new(region.polygon());
        let coarse = initial_panels(&boundary, 1.0);
        let fine: Vec<Panel> =
            coarse.iter().flat_map(|panel| panel.halves()).flat_map(|panel| panel.halves()).collect();
        let fine: Vec<_> = fine
            .into_iter()
            .enumerate()
            .map(|(q, panel)| (panel, if q == 5 { 1.0 } else { 0.0 }, Role::Solved))
            .collect();
        let panels = coarsened(&coarse, &fine, &|mass, _| mass > 0.5);
        let panels: Vec<Panel> = panels.into_iter().map(|(panel, _)| panel).collect();
        assert_eq!(panels.len(), coarse.len() + 2);
        assert_eq!(panels[0], coarse[0]);
        assert_eq!(panels[1..3], [fine[4].0, fine[5].0]);
        assert_eq!(panels[3], coarse[1].halves()[1]);
        assert_eq!(panels[4..], coarse[2..]);
    }
}
