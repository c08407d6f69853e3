//! ∫ log(z − y) dμ(y) as a power series around any point off the boundary.
//!
//! Far clusters of panels act through multipole expansions (as in [`super::fast_multipole`]), panels that are near through
//! Gauss's rule on pieces short against their distance. The argument of z − y is continuous along the boundary and
//! principal at the first vertex of each component: the branch of [`LogPotential::at`](super::potential::LogPotential::at).

use super::clusters::{Cluster, ClusterTree};
use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::legendre::{GaussRule, MAX_NODES, legendre};
use super::multipole::shift_multipole;
use super::series_sum::{MAX_TERMS, Piece, Sum, expansion_factors};
use crate::plane::Complex64;
use std::ops::Range;

/// A cluster is far when its radius is at most this share of its distance from the disk of the series.
const FAR: f64 = 0.4;
/// The same for half the length of a piece and Gauss's rule.
const FAR_PIECE: f64 = 0.4;
/// Levels of a graded panel that are told apart for its multipole expansion.
const TOLD_APART: usize = 3;

/// The sources of a solved potential, ready to be expanded anywhere.
#[derive(Clone, Debug)]
pub struct LocalSeries {
    clusters: Vec<Cluster>,
    /// Where the walk in boundary order goes on when a cluster is done with.
    skips: Vec<usize>,
    /// Total mass, then the coefficients of (radius/(z − center))^k, k = 1 …: `terms` a cluster.
    multipoles: Vec<Complex64>,
    terms: usize,
    panels: Vec<PanelSource>,
    gauss: GaussRule,
    factors: Vec<f64>,
    /// How near, relative to its half length, moments alone may stand for a graded interval.
    far_union: f64,
    /// log of the accuracy wanted.
    log_accuracy: f64,
    /// The first cluster of each component, and the component's first vertex.
    starts: Vec<(usize, Complex64)>,
}

/// One panel, from its corner outwards.
#[derive(Clone, Debug)]
struct PanelSource {
    /// Its near end.
    origin: Complex64,
    /// The vector from the near to the far end.
    span: Complex64,
    /// Its end in boundary order.
    end: Complex64,
    exponent: f64,
    /// Legendre coefficients of dμ/dτ.
    density: Vec<f64>,
    /// Masses on the Gauss nodes of [0, 2^(−l)].
    unions: Vec<f64>,
    /// Masses on the Gauss nodes of [2^(−l−1), 2^(−l)].
    pieces: Vec<f64>,
    levels: usize,
    /// Whether it holds no mass at all.
    is_empty: bool,
}

impl LocalSeries {
    /// Prepares the potential of node masses, scaled to total mass 1, and of their correspondence.
    #[must_use]
    pub fn new(discretisation: &Discretisation, masses: &[f64], correspondence: &BoundaryCorrespondence) -> Self {
        Self::with(discretisation, masses, correspondence, masses.iter().sum())
    }

    /// Of masses of any sign, as they are.
    #[must_use]
    pub fn signed(discretisation: &Discretisation, masses: &[f64], correspondence: &BoundaryCorrespondence) -> Self {
        Self::with(discretisation, masses, correspondence, 1.0)
    }

    fn with(
        discretisation: &Discretisation,
        masses: &[f64],
        correspondence: &BoundaryCorrespondence,
        total: f64,
    ) -> Self {
        let order = &discretisation.order;
        let digits = order.digits;
        let terms = (digits * std::f64::consts::LN_10 / -FAR.ln()).ceil() as usize + 2;
        let terms = terms.min(MAX_TERMS + 1);
        let clusters = ClusterTree::of_components(discretisation, 1).clusters;
        let boundary = &discretisation.boundary;
        let first = |panels: &Range<usize>| clusters.iter().position(|cluster| cluster.panels.start == panels.start);
        let roots = discretisation.components.iter().filter_map(first);
        let starts = roots.zip(&boundary.loops).map(|(root, own)| (root, boundary.vertices[own.start])).collect();
        let mut series = Self {
            skips: skips(&clusters),
            multipoles: vec![Complex64::ZERO; clusters.len() * terms],
            clusters,
            terms,
            panels: panel_sources(discretisation, masses, correspondence, total),
            gauss: order.piece.clone(),
            factors: expansion_factors(),
            far_union: 10f64.powf(-digits / order.piece.len() as f64).min(FAR_PIECE),
            log_accuracy: -digits * std::f64::consts::LN_10,
            starts,
        };
        series.gather_multipoles();
        series
    }

    /// Bytes of memory, about.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let panels: usize =
            self.panels.iter().map(|panel| 8 * (panel.density.len() + panel.unions.len() + panel.pieces.len())).sum();
        panels + 16 * self.multipoles.len() + std::mem::size_of::<Cluster>() * self.clusters.len()
    }

    /// Writes the coefficients of tᵏ, k = 0 …, of the potential at `center` + `radius`·t (scaled units). The disk lies in the
    /// region; of one that crosses the boundary they mean nothing.
    pub fn expand(&self, center: Complex64, radius: f64, coefficients: &mut [Complex64]) {
        coefficients.fill(Complex64::ZERO);
        let mut sum = Sum { center, radius, coefficients, argument: 0.0 };
        let mut starts = self.starts.iter().peekable();
        let mut at = 0;
        while at < self.clusters.len() {
            if let Some((_, start)) = starts.next_if(|(root, _)| *root == at) {
                sum.argument = (center - start).arg();
            }
            let cluster = &self.clusters[at];
            let leaf = cluster.children.is_none();
            let room = (center - cluster.center).norm_sqr().sqrt() - radius;
            let end = self.panels[cluster.panels.end - 1].end;
            if cluster.radius <= FAR * room {
                let share = cluster.radius / room;
                let terms = (self.log_accuracy / share.ln()).ceil() as usize + 2;
                let multipole = &self.multipoles[at * self.terms..][..terms.clamp(2, self.terms)];
                sum.add_multipole(cluster, multipole, &self.factors);
            } else if leaf {
                self.add_panel(&self.panels[cluster.panels.start], &mut sum);
            } else {
                at += 1;
                continue;
            }
            sum.walk_to(end);
            at = self.skips[at];
        }
        // So far: Σ mass·(radius/(center − y))ᵏ; the logarithm wants (−1)^(k−1)/k of it.
        for (k, value) in sum.coefficients.iter_mut().enumerate().skip(1) {
            *value *= if k % 2 == 1 { 1.0 } else { -1.0 } / k as f64;
        }
    }

    fn add_panel(&self, panel: &PanelSource, sum: &mut Sum) {
        if panel.is_empty {
            // A target may lie on one of its nodes.
            return;
        }
        let m = self.gauss.len();
        let mut reach = 1.0;
        for l in 0..panel.levels {
            let union = Interval { middle: 0.5 * reach, half: 0.5 * reach };
            if sum.is_far(panel.piece(union), self.far_union) {
                return sum.add_nodes(panel.piece(union), &self.gauss, &panel.unions[l * m..][..m]);
            }
            let piece = Interval { middle: 0.75 * reach, half: 0.25 * reach };
            self.add_piece(panel, piece, Some(&panel.pieces[l * m..][..m]), sum);
            reach *= 0.5;
        }
        let rest = Interval { middle: 0.5 * reach, half: 0.5 * reach };
        let masses = &panel.unions[panel.levels * m..][..m];
        if panel.levels == 0 {
            self.add_piece(panel, rest, Some(masses), sum);
        } else {
            sum.add_nodes(panel.piece(rest), &self.gauss, masses);
        }
    }

    /// A piece on which the density is smooth, halved until it is short against its distance.
    fn add_piece(&self, panel: &PanelSource, piece: Interval, masses: Option<&[f64]>, sum: &mut Sum) {
        let place = panel.piece(piece);
        if piece.half < SHORTEST || sum.need_not_halve(place) || sum.is_far(place, FAR_PIECE) {
            let mut own = [0.0; MAX_NODES];
            let masses = masses.unwrap_or_else(|| {
                panel.masses_in(piece, &self.gauss, &mut own);
                &own[..self.gauss.len()]
            });
            return sum.add_nodes(place, &self.gauss, masses);
        }
        let half = 0.5 * piece.half;
        self.add_piece(panel, Interval { middle: piece.middle - half, half }, None, sum);
        self.add_piece(panel, Interval { middle: piece.middle + half, half }, None, sum);
    }

    fn gather_multipoles(&mut self) {
        let mut own = vec![Complex64::ZERO; self.terms];
        for index in (0..self.clusters.len()).rev() {
            own.fill(Complex64::ZERO);
            let cluster = &self.clusters[index];
            match cluster.children {
                Some(children) => {
                    for child in children {
                        let from = &self.multipoles[child * self.terms..][..self.terms];
                        shift_multipole(&self.clusters[child], from, cluster, &mut own);
                    }
                }
                None => self.panel_multipole(&self.panels[cluster.panels.start], cluster, &mut own),
            }
            self.multipoles[index * self.terms..][..self.terms].copy_from_slice(&own);
        }
    }

    fn panel_multipole(&self, panel: &PanelSource, cluster: &Cluster, own: &mut [Complex64]) {
        let m = self.gauss.len();
        let told_apart = panel.levels.min(TOLD_APART);
        let mut add = |interval: Interval, masses: &[f64]| {
            for (t, mass) in self.gauss.nodes.iter().zip(masses) {
                let place = panel.origin + panel.span * (interval.middle + interval.half * t);
                let shift = (place - cluster.center) / cluster.radius;
                own[0] += mass;
                let mut power = Complex64::new(-mass, 0.0);
                for (k, a) in own.iter_mut().enumerate().skip(1) {
                    power *= shift;
                    *a += power / k as f64;
                }
            }
        };
        for l in 0..told_apart {
            let reach = (-(l as f64)).exp2();
            add(Interval { middle: 0.75 * reach, half: 0.25 * reach }, &panel.pieces[l * m..][..m]);
        }
        let reach = (-(told_apart as f64)).exp2();
        add(Interval { middle: 0.5 * reach, half: 0.5 * reach }, &panel.unions[told_apart * m..][..m]);
    }
}

/// Pieces are not halved beyond this share of their panel.
const SHORTEST: f64 = 1e-14;

/// A part of a panel, which is [0, 1].
#[derive(Clone, Copy, Debug)]
struct Interval {
    middle: f64,
    half: f64,
}

impl PanelSource {
    /// A part of it in the plane.
    fn piece(&self, part: Interval) -> Piece {
        Piece { middle: self.origin + self.span * part.middle, half: self.span * part.half }
    }

    /// Masses on the Gauss nodes of a part away from the corner.
    fn masses_in(&self, part: Interval, gauss: &GaussRule, masses: &mut [f64]) {
        let mut p = [0.0; MAX_NODES];
        let p = &mut p[..self.density.len()];
        for ((t, weight), mass) in gauss.nodes.iter().zip(&gauss.weights).zip(masses) {
            let s = part.middle + part.half * t;
            let tau = if self.exponent == 1.0 { s } else { s.powf(1.0 / self.exponent) };
            legendre(2.0 * tau - 1.0, p);
            let density: f64 = p.iter().zip(&self.density).map(|(p, c)| p * c).sum();
            *mass = density * tau / (self.exponent * s) * part.half * weight;
        }
    }
}

/// Where a walk in boundary order continues after each cluster.
fn skips(clusters: &[Cluster]) -> Vec<usize> {
    let mut skips = vec![0; clusters.len()];
    for index in (0..clusters.len()).rev() {
        skips[index] = clusters[index].children.map_or(index + 1, |[_, second]| skips[second]);
    }
    skips
}

fn panel_sources(
    discretisation: &Discretisation,
    masses: &[f64],
    correspondence: &BoundaryCorrespondence,
    total: f64,
) -> Vec<PanelSource> {
    let p = discretisation.order.p();
    let source = |(q, masses): (usize, &[f64])| {
        let panel = &discretisation.panels[q];
        let rule = &discretisation.rules[q];
        let corner = discretisation.boundary.vertices[panel.corner];
        let masses: Vec<f64> = masses.iter().map(|mass| mass / total).collect();
        let charges = rule.charges(&masses);
        let levels = rule.levels();
        PanelSource {
            origin: corner + panel.direction * panel.start,
            span: panel.direction * panel.length(),
            end: corner + panel.direction * if panel.outgoing { panel.end } else { panel.start },
            exponent: panel.exponent,
            density: correspondence.coefficients(q).to_vec(),
            unions: (0..=levels).flat_map(|l| rule.union_charges(l, &charges)).copied().collect(),
            pieces: (0..levels).flat_map(|l| rule.piece_charges(l, &charges)).copied().collect(),
            levels,
            is_empty: masses.iter().all(|mass| *mass == 0.0),
        }
    };
    masses.chunks_exact(p).enumerate().map(source).collect()
}

#[cfg(test)]
mod tests {
    use super::super::options::SolveOptions;
    use super::super::solve::solve;
    use super::*;
    use crate::plane::{Curve, Region};

    fn c(re: f64, im: f64) -> Complex64 {
        Complex64::new(re, im)
    }

    /// A spike, a re-entrant corner, and many vertices.
    fn regions() -> [Region; 3] {
        let region =
            |vertices: &[Complex64], center| Region::new(vertices, Curve::Polygon, center, vertices[0]).unwrap();
        let star: Vec<_> =
            (0..40).map(|k| Complex64::from_polar(1.0 + 0.4 * f64::from(k % 3), 0.157 * f64::from(k))).collect();
        [
            region(&[c(0.0, 0.0), c(3.0, 0.0), c(1.0, 0.3), c(0.9, 1.0), c(0.0, 1.0)], c(0.5, 0.5)),
            region(&[c(0.0, 0.0), c(2.0, 0.0), c(2.0, 1.0), c(1.0, 1.0), c(1.0, 2.0), c(0.0, 2.0)], c(0.5, 0.5)),
            region(&star, c(0.1, 0.0)),
        ]
    }

    #[test]
    fn agrees_with_the_direct_sum_up_to_the_walls() {
        for (tolerance, bound) in [(1e-5, 1e-7), (1e-8, 1e-10), (1e-11, 1e-12)] {
            for region in regions() {
                let options = SolveOptions { tolerance, ..SolveOptions::default() };
                let solution = solve(&region, &options, &mut |_, _| true).unwrap();
                let discretisation = solution.discretisation();
                let unit = discretisation.boundary.unit;
                let direct = &solution.potential;
                let series = LocalSeries::new(discretisation, &solution.masses, &solution.correspondence);
                let (low, high) = region.polygon().bounds();
                for k in 1..200 {
                    let share = |a: f64| (f64::from(k) * a).fract();
                    let z = c(low.re + (high.re - low.re) * share(0.618), low.im + (high.im - low.im) * share(0.7548));
                    if !region.contains(z) {
                        continue;
                    }
                    let distance = (region.polygon().nearest(z).point - z).norm() * unit;
                    let radius = 0.6 * distance;
                    let mut coefficients = [Complex64::ZERO; 32];
                    series.expand(z * unit, radius, &mut coefficients);
                    for turn in [0.0, 1.0, 2.5, 4.0] {
                        let t = Complex64::from_polar(0.6, turn);
                        let sum = coefficients.iter().rev().fold(Complex64::ZERO, |sum, b| sum * t + b);
                        let exact = direct.at(discretisation, z * unit + t * radius);
                        // The branch may differ by whole turns, as the total mass is 1.
                        let ratio = (sum - exact).exp();
                        assert!((ratio - 1.0).norm() < bound, "{tolerance:e} at {z}, {distance:e} away: {sum} {exact}");
                    }
                }
            }
        }
    }
}
