//! The logarithmic potential of one panel: which quadrature serves which target.
//!
//! A panel with a corner variable is cut dyadically towards its corner: piece l is [2^(−l−1), 2^(−l)], union l is
//! [0, 2^(−l)]. On a piece the density is smooth in s and interpolated at m Gauss nodes; on a union only its first m
//! moments count, for targets far from it. A target walks outwards in: while the union is near, it takes the piece (by
//! Gauss's rule, or by exact moments when that is near too), then looks at the next union.
//! A regular panel is one piece whose density is the polynomial itself.
//! Most targets are so far away that half the moments do: they are asked first.

use super::fast_log;
use super::legendre::MAX_NODES;
use super::log_moments::{log_moments, log_moments_with_slopes, outside_ellipse};
use super::order::Order;
use super::panel::Panel;
use super::panel_blocks::{far_block, graded_blocks, regular_blocks};
use super::rows::add_scaled;
use crate::plane::Complex64;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// How the node masses of a panel with a given exponent act, on the panel scaled to [0, 1].
#[derive(Clone, Debug)]
pub struct PanelRule {
    p: usize,
    m: usize,
    /// Dyadic levels; 0 for a regular panel.
    levels: usize,
    /// Blocks of m × p: what the node masses become on the nodes (or in the Legendre coefficients) of each part.
    /// The last one is m/2 × p: the far nodes of the whole panel.
    blocks: Vec<f64>,
}

/// One contribution to the potential at a target: a block of the rule, and the interval it stands for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub block: usize,
    pub center: f64,
    pub half: f64,
    /// What the rows of the block are.
    pub rows: Rows,
}

/// What the rows of a block are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rows {
    /// Masses on the nodes of `Order::piece`.
    Nodes,
    /// Masses on the nodes of `Order::far`.
    FarNodes,
    /// Legendre coefficients, for exact moments.
    Coefficients,
}

impl Rows {
    pub fn nodes(self, order: &Order) -> &[f64] {
        if self == Self::FarNodes { &order.far.nodes } else { &order.piece.nodes }
    }
}

impl PanelRule {
    fn new(order: &Order, exponent: f64) -> Self {
        let (p, m) = (order.p(), order.piece.len());
        let mut rule = Self { p, m, levels: 0, blocks: Vec::new() };
        if exponent == 1.0 {
            rule.blocks = regular_blocks(order);
        } else {
            // Targets, also those that check the solution, come closer to the corner than the first node, but not
            // closer than a hundredth of its distance: three more halvings keep the last union far from all of them.
            let closest = (0.005 * (order.panel.nodes[0] + 1.0)).powf(exponent);
            rule.levels = (-closest.log2()).ceil() as usize + 3;
            rule.blocks = graded_blocks(order, exponent, rule.levels);
        }
        let far = far_block(order, rule.block(0));
        rule.blocks.extend(far);
        rule
    }

    /// Points of the scaled panel nearer to its corner than this are too near for the quadrature.
    #[must_use]
    pub fn blind_radius(&self) -> f64 {
        if self.levels == 0 { 0.0 } else { (2.0 - self.levels as f64).exp2() }
    }

    fn block(&self, index: usize) -> &[f64] {
        &self.blocks[index * self.m * self.p..][..self.m * self.p]
    }

    /// The whole panel as seen from far, and from not so far.
    pub(super) fn whole(&self, far: bool) -> Part {
        let (block, rows) = if far { (self.far_block(), Rows::FarNodes) } else { (Self::union_block(0), Rows::Nodes) };
        Part { block, center: 0.5, half: 0.5, rows }
    }

    /// The part whose nodes carry the density that `part` has as Legendre coefficients.
    pub(super) fn on_nodes(&self, part: Part) -> Part {
        // Pieces stand as many blocks before their coefficients as there are levels.
        let block = if self.levels == 0 { 0 } else { part.block - self.levels };
        Part { block, rows: Rows::Nodes, ..part }
    }

    /// How many blocks it has.
    pub(super) fn block_count(&self) -> usize {
        self.far_block() + 1
    }

    /// All parts that are masses on nodes.
    pub(super) fn node_parts(&self) -> impl Iterator<Item = Part> + '_ {
        let rows = Rows::Nodes;
        let union = move |l: usize| {
            let half = 0.5 * (-(l as f64)).exp2();
            Part { block: Self::union_block(l), center: half, half, rows }
        };
        let piece = move |l: usize| {
            let quarter = 0.25 * (-(l as f64)).exp2();
            Part { block: self.piece_block(l), center: 3.0 * quarter, half: quarter, rows }
        };
        (0..=self.levels).map(union).chain((0..self.levels).map(piece)).chain([self.whole(true)])
    }

    /// What unit masses at the panel's nodes become on the rows of `part`, row by row.
    pub(super) fn rows_of(&self, part: Part) -> impl Iterator<Item = &[f64]> {
        self.blocks[part.block * self.m * self.p..].chunks_exact(self.p).take(self.row_count(part.rows))
    }

    /// Of [`PanelRule::charges`], those on the rows of `part`.
    pub(super) fn charges_of<'a>(&self, part: Part, charges: &'a [f64]) -> &'a [f64] {
        &charges[part.block * self.m..][..self.row_count(part.rows)]
    }

    fn union_block(l: usize) -> usize {
        l
    }

    fn piece_block(&self, l: usize) -> usize {
        self.levels + 1 + l
    }

    fn moment_block(&self, l: usize) -> usize {
        2 * self.levels + 1 + l
    }

    fn far_block(&self) -> usize {
        if self.levels == 0 { 2 } else { 3 * self.levels + 1 }
    }

    /// How many rows of a block count.
    pub(super) fn row_count(&self, rows: Rows) -> usize {
        match rows {
            Rows::Nodes => self.m,
            Rows::FarNodes => self.m / 2,
            Rows::Coefficients if self.levels == 0 => self.p,
            Rows::Coefficients => self.m,
        }
    }

    /// Calls `visit` for the parts that make up the panel as seen from `target` (scaled so that the panel is [0, 1]).
    pub(super) fn for_each_part(&self, order: &Order, target: Complex64, mut visit: impl FnMut(Part)) {
        let whole = self.whole(true);
        if outside_ellipse(2.0 * target - 1.0, order.far_ellipse) {
            return visit(whole);
        }
        let mut reach = 1.0;
        for l in 0..=self.levels {
            let union = Part { block: Self::union_block(l), center: 0.5 * reach, half: 0.5 * reach, rows: Rows::Nodes };
            let regular = self.levels == 0;
            let ellipse = if regular { order.piece_ellipse } else { order.union_ellipse };
            let last_union = l == self.levels && !regular;
            if last_union || outside_ellipse((target - union.center) / union.half, ellipse) {
                return visit(union);
            }
            if regular {
                return visit(Part { block: 1, rows: Rows::Coefficients, ..union });
            }
            let piece =
                Part { block: self.piece_block(l), center: 0.75 * reach, half: 0.25 * reach, rows: Rows::Nodes };
            if outside_ellipse((target - piece.center) / piece.half, order.piece_ellipse) {
                visit(piece);
            } else {
                visit(Part { block: self.moment_block(l), rows: Rows::Coefficients, ..piece });
            }
            reach *= 0.5;
        }
    }

    /// Adds to `row` (length p) the potential ∫ log|x − y| dμ(y) at the target of a unit mass at each node.
    /// `log_scale` is the logarithm of the panel's length.
    pub fn add_row(&self, order: &Order, target: Complex64, log_scale: f64, row: &mut [f64]) {
        self.for_each_part(order, target, |part| {
            let mut logs = [0.0; MAX_NODES];
            let logs = &mut logs[..self.row_count(part.rows)];
            if part.rows == Rows::Coefficients {
                exact_logs(target, part, log_scale, logs, |moment| moment.re);
            } else {
                let height = target.im * target.im;
                for (log, t) in logs.iter_mut().zip(part.rows.nodes(order)) {
                    let along = target.re - part.center - part.half * t;
                    *log = along * along + height;
                }
                fast_log::half_ln(logs);
                logs.iter_mut().for_each(|log| *log += log_scale);
            }
            for (log, weights) in logs.iter().zip(self.blocks[part.block * self.m * self.p..].chunks_exact(self.p)) {
                add_scaled(row, *log, weights);
            }
        });
    }

    /// What given node masses become in every block: the input of [`PanelRule::potential`].
    #[must_use]
    pub fn charges(&self, masses: &[f64]) -> Vec<f64> {
        self.blocks.chunks_exact(self.p).map(|row| row.iter().zip(masses).map(|(w, x)| w * x).sum()).collect()
    }

    /// Dyadic levels towards the corner; 0 for a regular panel.
    #[must_use]
    pub fn levels(&self) -> usize {
        self.levels
    }

    /// Of [`PanelRule::charges`]: the masses on the nodes of `Order::piece` in [0, 2^(−l)], which have the moments of what
    /// lies there. `l` is at most the number of levels.
    #[must_use]
    pub fn union_charges<'a>(&self, l: usize, charges: &'a [f64]) -> &'a [f64] {
        &charges[Self::union_block(l) * self.m..][..self.m]
    }

    /// The same in [2^(−l−1), 2^(−l)], `l` below the number of levels.
    #[must_use]
    pub fn piece_charges<'a>(&self, l: usize, charges: &'a [f64]) -> &'a [f64] {
        &charges[self.piece_block(l) * self.m..][..self.m]
    }

    /// ∫ log(u − s) dμ(s), principal logarithm, at a target u (panel scaled to [0, 1]) of the given charges;
    /// `log_scale` is added to every logarithm.
    #[must_use]
    pub fn potential(&self, order: &Order, target: Complex64, log_scale: f64, charges: &[f64]) -> Complex64 {
        let mut sum = Complex64::ZERO;
        self.for_each_part(order, target, |part| {
            let charges = &charges[part.block * self.m..][..self.row_count(part.rows)];
            if part.rows == Rows::Coefficients {
                let mut logs = [Complex64::ZERO; MAX_NODES];
                let logs = &mut logs[..charges.len()];
                exact_logs(target, part, log_scale, logs, |moment| moment);
                sum += logs.iter().zip(charges).map(|(log, charge)| log * charge).sum::<Complex64>();
            } else {
                for (charge, t) in charges.iter().zip(part.rows.nodes(order)) {
                    sum += ((target - (part.center + part.half * t)).ln() + log_scale) * charge;
                }
            }
        });
        sum
    }

    /// [`PanelRule::potential`], and its derivative by the target.
    #[must_use]
    pub fn potential_with_slope(
        &self,
        order: &Order,
        target: Complex64,
        log_scale: f64,
        charges: &[f64],
    ) -> (Complex64, Complex64) {
        let (mut sum, mut slope) = (Complex64::ZERO, Complex64::ZERO);
        self.for_each_part(order, target, |part| {
            let charges = &charges[part.block * self.m..][..self.row_count(part.rows)];
            if part.rows == Rows::Coefficients {
                let (mut logs, mut slopes) = ([Complex64::ZERO; MAX_NODES], [Complex64::ZERO; MAX_NODES]);
                let (logs, slopes) = (&mut logs[..charges.len()], &mut slopes[..charges.len()]);
                log_moments_with_slopes((target - part.center) / part.half, logs, slopes);
                logs[0] += 2.0 * (part.half.ln() + log_scale);
                sum += logs.iter().zip(charges).map(|(log, charge)| log * charge).sum::<Complex64>();
                slope += slopes.iter().zip(charges).map(|(s, charge)| s * charge).sum::<Complex64>() / part.half;
            } else {
                for (charge, t) in charges.iter().zip(part.rows.nodes(order)) {
                    let away = target - (part.center + part.half * t);
                    sum += (away.ln() + log_scale) * charge;
                    slope += away.inv() * charge;
                }
            }
        });
        (sum, slope)
    }

    /// Calls `visit` with the place in [0, 1] of each of the m nodes that stand for the whole panel in the far field, and
    /// the mass there for a unit mass at each of the panel's p nodes.
    pub fn for_each_source(&self, order: &Order, mut visit: impl FnMut(f64, &[f64])) {
        for (t, masses) in order.piece.nodes.iter().zip(self.block(Self::union_block(0)).chunks_exact(self.p)) {
            visit(0.5 + 0.5 * t, masses);
        }
    }
}

/// Writes ∫ Pₖ(t) log(half·(ζ − t)) dt + scale for the interval of `part` as seen from `target`.
pub(super) fn exact_logs<T: std::ops::AddAssign<f64>>(
    target: Complex64,
    part: Part,
    log_scale: f64,
    logs: &mut [T],
    take: impl Fn(Complex64) -> T,
) {
    let mut moments = [Complex64::ZERO; MAX_NODES];
    let moments = &mut moments[..logs.len()];
    log_moments((target - part.center) / part.half, moments);
    logs.iter_mut().zip(moments).for_each(|(log, moment)| *log = take(*moment));
    logs[0] += 2.0 * (part.half.ln() + log_scale);
}

/// The rules of all exponents met so far: equal corners, and the halves of split panels, share one.
#[derive(Clone, Debug)]
pub struct Rules {
    /// What they have in common.
    pub order: Order,
    by_exponent: FxHashMap<u64, Arc<PanelRule>>,
}

impl Rules {
    /// No rules yet.
    #[must_use]
    pub fn new(order: Order) -> Self {
        Self { order, by_exponent: FxHashMap::default() }
    }

    /// With the rules that panels have already.
    #[must_use]
    pub fn from_panels(order: Order, panels: &[Panel], rules: &[Arc<PanelRule>]) -> Self {
        let known = panels.iter().zip(rules).map(|(panel, rule)| (panel.exponent.to_bits(), Arc::clone(rule)));
        Self { order, by_exponent: known.collect() }
    }

    /// The rule for a panel.
    pub fn of(&mut self, panel: &Panel) -> Arc<PanelRule> {
        let order = &self.order;
        let make = || Arc::new(PanelRule::new(order, panel.exponent));
        Arc::clone(self.by_exponent.entry(panel.exponent.to_bits()).or_insert_with(make))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫₀¹ log(u − τ^a) Σⱼ gⱼ(τ) dτ for unit masses at the nodes, by the trapezoidal rule after τ = the error-function-like
    /// substitution of double-exponential quadrature.
    fn by_quadrature(order: &Order, exponent: f64, u: Complex64, masses: &[f64]) -> Complex64 {
        let mut basis = vec![0.0; order.p()];
        let mut sum = Complex64::ZERO;
        // Break at the foot of the target, where the kernel varies fastest.
        let foot = u.re.clamp(0.0, 1.0).powf(1.0 / exponent);
        for (a, b) in [(0.0, foot), (foot, 1.0)] {
            let step = 1.0 / 64.0;
            for k in -300..=300 {
                let x = f64::from(k) * step;
                let q = std::f64::consts::FRAC_PI_2 * x.sinh();
                let share = 1.0 / (1.0 + (-2.0 * q).exp());
                let weight = step * std::f64::consts::PI * x.cosh() * share * (1.0 - share) * (b - a);
                let tau = a + (b - a) * share;
                if weight < 1e-300 {
                    continue;
                }
                order.panel.lagrange(2.0 * tau - 1.0, &mut basis);
                let density: f64 =
                    basis.iter().zip(masses).zip(&order.panel.weights).map(|((b, x), w)| b * x * 2.0 / w).sum();
                sum += (u - tau.powf(exponent)).ln() * (weight * density);
            }
        }
        sum
    }

    #[test]
    fn potential_matches_quadrature_at_all_distances() {
        let order = Order::new(12, 15.0);
        let density = |t: f64| (1.0 + 0.5 * t).recip();
        let masses: Vec<f64> =
            order.panel.nodes.iter().zip(&order.panel.weights).map(|(t, w)| 0.5 * w * density(*t)).collect();
        let targets = [(0.4, 1e-3), (1.02, 0.01), (0.01, 0.002), (-0.05, 0.01), (0.7, 0.4), (3.0, 1.0), (-8.0, 0.5)];
        for exponent in [1.0, 0.55, 0.9, 1.3, 1.98] {
            let rule = PanelRule::new(&order, exponent);
            let charges = rule.charges(&masses);
            for (re, im) in targets {
                let u = Complex64::new(re, im);
                let value = rule.potential(&order, u, 0.0, &charges);
                let exact = by_quadrature(&order, exponent, u, &masses);
                assert!((value - exact).norm() < 3e-13, "a = {exponent}, u = {u}: {value} against {exact}");
                let mut row = [0.0; 12];
                rule.add_row(&order, u, 0.0, &mut row);
                let real: f64 = row.iter().zip(&masses).map(|(r, x)| r * x).sum();
                assert!((real - exact.re).abs() < 3e-13, "row, a = {exponent}, u = {u}: {real} against {exact}");
            }
        }
    }
}
