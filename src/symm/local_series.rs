//! ∫ log(z − y) dμ(y) as a power series around any point off the boundary.
//!
//! Far clusters of panels act through multipole expansions (as in [`super::fast_multipole`]), panels that are near through
//! Gauss's rule on pieces short against their distance. The argument of z − y is continuous along the boundary and
//! principal at vertex 0: the branch of [`LogPotential::at`](super::potential::LogPotential::at).

use super::clusters::{Cluster, ClusterTree};
use super::correspondence::BoundaryCorrespondence;
use super::discretisation::Discretisation;
use super::fast_log::half_ln;
use super::legendre::{GaussRule, MAX_NODES, legendre};
use super::solve::Solution;
use crate::plane::Complex64;
use std::f64::consts::TAU;

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
    binomials: Vec<f64>,
    /// How near, relative to its half length, moments alone may stand for a graded interval.
    far_union: f64,
    /// log of the accuracy wanted.
    log_accuracy: f64,
    /// Vertex 0.
    start: Complex64,
}

/// One panel, from its corner outwards.
#[derive(Clone, Debug)]
struct PanelSource {
    /// Its near end.
    origin: Complex64,
    /// From the near to the far end.
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
}

/// The series under construction.
struct Sum<'a> {
    center: Complex64,
    radius: f64,
    coefficients: &'a mut [Complex64],
    /// Argument of center − y at the end of the boundary walked so far.
    argument: f64,
}

impl LocalSeries {
    /// Prepares the potential of a solution.
    #[must_use]
    pub fn new(solution: &Solution) -> Self {
        let discretisation = solution.discretisation();
        let order = &discretisation.order;
        let digits = order.digits;
        let terms = (digits * std::f64::consts::LN_10 / -FAR.ln()).ceil() as usize + 2;
        let terms = terms.min(MAX_TERMS + 1);
        let clusters = ClusterTree::new(discretisation, 1).clusters;
        let mut series = Self {
            skips: skips(&clusters),
            multipoles: vec![Complex64::ZERO; clusters.len() * terms],
            clusters,
            terms,
            panels: panel_sources(discretisation, &solution.masses, &solution.correspondence),
            gauss: order.piece.clone(),
            binomials: binomials(),
            far_union: 10f64.powf(-digits / order.piece.len() as f64).min(FAR_PIECE),
            log_accuracy: -digits * std::f64::consts::LN_10,
            start: discretisation.boundary.vertices[0],
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
    /// region.
    pub fn expand(&self, center: Complex64, radius: f64, coefficients: &mut [Complex64]) {
        coefficients.fill(Complex64::ZERO);
        let argument = (center - self.start).arg();
        let mut sum = Sum { center, radius, coefficients, argument };
        let mut at = 0;
        while at < self.clusters.len() {
            let cluster = &self.clusters[at];
            let leaf = cluster.children.is_none();
            let room = (center - cluster.center).norm_sqr().sqrt() - radius;
            let end = self.panels[cluster.panels.end - 1].end;
            if cluster.radius <= FAR * room {
                let share = cluster.radius / room;
                let terms = (self.log_accuracy / share.ln()).ceil() as usize + 2;
                let multipole = &self.multipoles[at * self.terms..][..terms.clamp(2, self.terms)];
                sum.add_multipole(cluster, multipole, &self.binomials);
            } else if leaf {
                self.add_panel(&self.panels[cluster.panels.start], &mut sum);
            } else {
                at += 1;
                continue;
            }
            sum.argument = nearest_turn((center - end).arg(), sum.argument);
            at = self.skips[at];
        }
        // So far: Σ mass·(radius/(center − y))ᵏ; the logarithm wants (−1)^(k−1)/k of it.
        for (k, value) in sum.coefficients.iter_mut().enumerate().skip(1) {
            *value *= if k % 2 == 1 { 1.0 } else { -1.0 } / k as f64;
        }
    }

    fn add_panel(&self, panel: &PanelSource, sum: &mut Sum) {
        let m = self.gauss.len();
        let mut reach = 1.0;
        for l in 0..panel.levels {
            let union = Interval { middle: 0.5 * reach, half: 0.5 * reach };
            if sum.is_far(panel, union, self.far_union) {
                return sum.add_nodes(panel, union, &self.gauss, &panel.unions[l * m..][..m]);
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
            sum.add_nodes(panel, rest, &self.gauss, masses);
        }
    }

    /// A piece on which the density is smooth, halved until it is short against its distance.
    fn add_piece(&self, panel: &PanelSource, piece: Interval, masses: Option<&[f64]>, sum: &mut Sum) {
        if piece.half < SHORTEST || sum.is_far(panel, piece, FAR_PIECE) {
            let mut own = [0.0; MAX_NODES];
            let masses = masses.unwrap_or_else(|| {
                panel.masses_in(piece, &self.gauss, &mut own);
                &own[..self.gauss.len()]
            });
            return sum.add_nodes(panel, piece, &self.gauss, masses);
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

impl Sum<'_> {
    fn is_far(&self, panel: &PanelSource, part: Interval, share: f64) -> bool {
        let middle = panel.origin + panel.span * part.middle;
        let half = panel.span.norm_sqr().sqrt() * part.half;
        half <= share * ((self.center - middle).norm_sqr().sqrt() - self.radius)
    }

    /// Adds the field of masses at the nodes of a part of a panel.
    fn add_nodes(&mut self, panel: &PanelSource, part: Interval, gauss: &GaussRule, masses: &[f64]) {
        let m = masses.len();
        let middle = self.center - (panel.origin + panel.span * part.middle);
        let inverse = middle.inv();
        let q = panel.span * part.half * inverse;
        let unit = inverse * self.radius;
        let (mut logs, mut angles) = ([1.0; MAX_NODES], [0.0; MAX_NODES]);
        let (mut ure, mut uim) = ([0.0; MAX_NODES], [0.0; MAX_NODES]);
        for j in 0..m {
            // center − y over center − middle.
            let (re, im) = (1.0 - gauss.nodes[j] * q.re, -gauss.nodes[j] * q.im);
            logs[j] = re * re + im * im;
            angles[j] = small_atan(im / re);
            let scale = 1.0 / logs[j];
            ure[j] = (unit.re * re + unit.im * im) * scale;
            uim[j] = (unit.im * re - unit.re * im) * scale;
        }
        half_ln(&mut logs[..m]);
        let total: f64 = masses.iter().sum();
        let log = Complex64::new(0.5 * middle.norm_sqr().ln(), nearest_turn(middle.arg(), self.argument));
        let mut constant = log * total;
        for j in 0..m {
            constant += Complex64::new(logs[j], angles[j]) * masses[j];
        }
        self.coefficients[0] += constant;
        let (mut pre, mut pim) = ([0.0; MAX_NODES], [0.0; MAX_NODES]);
        pre[..m].copy_from_slice(masses);
        let lanes = m.next_multiple_of(LANES);
        for coefficient in &mut self.coefficients[1..] {
            // Several sums side by side, which the compiler keeps in vectors.
            let (mut re, mut im) = ([0.0; LANES], [0.0; LANES]);
            for j in (0..lanes).step_by(LANES) {
                for i in 0..LANES {
                    let (a, b) = (pre[j + i], pim[j + i]);
                    let (c, d) = (ure[j + i], uim[j + i]);
                    pre[j + i] = a * c - b * d;
                    pim[j + i] = a * d + b * c;
                    re[i] += pre[j + i];
                    im[i] += pim[j + i];
                }
            }
            *coefficient += Complex64::new(re.iter().sum(), im.iter().sum());
        }
    }

    /// Adds the field of a far cluster. `binomials` are those of [`binomials`].
    fn add_multipole(&mut self, cluster: &Cluster, multipole: &[Complex64], binomials: &[f64]) {
        let apart = self.center - cluster.center;
        let inverse = apart.inv();
        let (near, unit) = (inverse * cluster.radius, inverse * self.radius);
        let (mut re, mut im) = ([0.0; MAX_TERMS], [0.0; MAX_TERMS]);
        let charge = multipole[0].re;
        let log = Complex64::new(0.5 * apart.norm_sqr().ln(), nearest_turn(apart.arg(), self.argument));
        let mut constant = log * charge;
        let mut power = Complex64::ONE;
        for (k, a) in multipole[1..].iter().enumerate() {
            power *= near;
            let u = a * power;
            constant += u;
            (re[k], im[k]) = (u.re, u.im);
        }
        self.coefficients[0] += constant;
        // A few more than are wanted, so that they fill vectors.
        let orders = (self.coefficients.len() - 1).next_multiple_of(LANES);
        let (mut sum_re, mut sum_im) = ([0.0; MAX_COEFFICIENTS], [0.0; MAX_COEFFICIENTS]);
        let (sum_re, sum_im) = (&mut sum_re[..orders], &mut sum_im[..orders]);
        for (k, row) in binomials.chunks_exact(MAX_COEFFICIENTS).take(multipole.len() - 1).enumerate() {
            let (re, im) = (re[k], im[k]);
            for ((sum_re, sum_im), binomial) in sum_re.iter_mut().zip(&mut *sum_im).zip(&row[..orders]) {
                *sum_re += binomial * re;
                *sum_im += binomial * im;
            }
        }
        let mut power = Complex64::ONE;
        for (l, coefficient) in self.coefficients[1..].iter_mut().enumerate() {
            power *= unit;
            *coefficient += power * (charge - Complex64::new(sum_re[l], sum_im[l]));
        }
    }
}

/// Numbers that are worked on side by side.
const LANES: usize = 4;
/// More terms of a multipole expansion than 16 digits need.
const MAX_TERMS: usize = 48;
/// More coefficients than anybody asks for.
const MAX_COEFFICIENTS: usize = 40;

/// Row k − 1, column l − 1: l·C(k+l−1, l). Around a center at distance D, (z − b)^(−k) has the coefficients
/// (−1)ˡ C(k+l−1, l)/D^(k+l).
fn binomials() -> Vec<f64> {
    let mut rows = Vec::with_capacity(MAX_TERMS * MAX_COEFFICIENTS);
    for k in 1..=MAX_TERMS {
        let mut choose = 1.0;
        for l in 1..=MAX_COEFFICIENTS {
            choose *= (k + l - 1) as f64 / l as f64;
            rows.push(l as f64 * choose);
        }
    }
    rows
}

/// `angle` plus the multiple of 2π that brings it closest to `to`.
fn nearest_turn(angle: f64, to: f64) -> f64 {
    angle + TAU * ((to - angle) / TAU).round()
}

/// atan x for |x| ≤ 7/16, branch-free (fdlibm's s_atan.c).
fn small_atan(x: f64) -> f64 {
    const SERIES: [f64; 11] = [
        3.333_333_333_333_293_18e-1,
        -1.999_999_999_987_648_32e-1,
        1.428_571_427_250_346_64e-1,
        -1.111_111_040_546_235_58e-1,
        9.090_887_133_436_507e-2,
        -7.691_876_205_044_83e-2,
        6.661_073_137_387_531e-2,
        -5.833_570_133_790_573_5e-2,
        4.976_877_994_615_932e-2,
        -3.653_157_274_421_691_6e-2,
        1.628_582_011_536_578_2e-2,
    ];
    let z = x * x;
    x - x * z * SERIES.iter().rev().fold(0.0, |sum, c| sum * z + c)
}

/// Adds a child's expansion to its parent's: aₗ += Σₖ C(l−1, k−1) aₖ d^(l−k) − Q dˡ/l, d = child − parent.
fn shift_multipole(child: &Cluster, from: &[Complex64], parent: &Cluster, to: &mut [Complex64]) {
    let shift = (child.center - parent.center) / parent.radius;
    let shrink = child.radius / parent.radius;
    to[0] += from[0];
    let mut work: Vec<Complex64> = Vec::with_capacity(from.len());
    let mut power = 1.0;
    for a in &from[1..] {
        power *= shrink;
        work.push(a * power);
    }
    let mut shift_power = Complex64::ONE;
    for l in 1..from.len() {
        shift_power *= shift;
        // C(l−1, k−1) d^(l−k) by the ratio of neighbours.
        let mut factor = Complex64::ONE;
        let mut sum = -from[0] * shift_power / l as f64;
        for k in (1..=l).rev() {
            sum += work[k - 1] * factor;
            factor *= shift * ((k - 1) as f64 / (l - k + 1) as f64);
        }
        to[l] += sum;
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
) -> Vec<PanelSource> {
    let p = discretisation.order.p();
    let total: f64 = masses.iter().sum();
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
        }
    };
    masses.chunks_exact(p).enumerate().map(source).collect()
}

#[cfg(test)]
mod tests {
    use super::super::solve::{SolveOptions, solve};
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
                let series = LocalSeries::new(&solution);
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
