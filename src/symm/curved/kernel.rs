//! The logarithmic potential of one panel on a curve.
//!
//! With t₀ the complex parameter of the target, log(z₀ − z(t)) = log(t₀ − t) + log((z₀ − z(t))/(t₀ − t)): the first has exact
//! moments, the second is smooth near the panel and left to Gauss's rule.

use super::super::fast_log;
use super::super::legendre::MAX_NODES;
use super::super::log_moments::log_moments_with_slopes;
use super::super::order::Order;
use super::super::panel::Panel;
use super::super::rows::add_scaled;
use super::super::rule::{PanelRule, Part, Rows, exact_logs};
use super::boundary::CurvedBoundary;
use crate::plane::{Complex64, Edge};

/// A panel with its rule and its curve, and where its nodes lie.
#[derive(Clone, Debug)]
pub struct CurvedPanel {
    /// Its piece of the arm.
    pub panel: Panel,
    curve: Edge,
    /// How far it is from straight.
    bend: f64,
    /// Whether the parameter stands still where it starts.
    slow: bool,
    middle: Complex64,
    /// Size of half of it.
    half: f64,
    /// Points of the nodes of each part, from the corner, by its block.
    points: Vec<Complex64>,
    m: usize,
}

/// Where a target lies as seen from a panel.
#[derive(Clone, Copy, Debug)]
pub(super) enum Seen {
    /// So far that the panel acts as one part.
    Whole(Part),
    /// At this parameter of the arm.
    Near(Complex64),
}

/// The potential of one part, on its own continuous branch.
#[derive(Clone, Copy, Debug)]
pub struct PartPotential {
    /// ∫ log(z₀ − y) dμ(y).
    pub sum: Complex64,
    /// ∫ dμ(y)/(z₀ − y).
    pub slope: Complex64,
    /// The part's mass.
    pub mass: f64,
    /// arg(z₀ − y) at its ends nearer to and farther from the corner.
    pub arguments: [f64; 2],
}

impl CurvedPanel {
    /// Places the nodes of all parts of a panel.
    #[must_use]
    pub fn new(boundary: &CurvedBoundary, panel: &Panel, rule: &PanelRule, order: &Order) -> Self {
        let curve = boundary.arm(panel).curve;
        let middle = Complex64::from(0.5 * (panel.start + panel.end));
        let m = order.piece.len();
        let mut own = Self {
            panel: *panel,
            curve,
            bend: boundary.bend(panel),
            slow: boundary.is_slow(panel),
            middle: curve.from_start(middle),
            half: curve.tangent(middle).norm() * 0.5 * panel.length(),
            points: vec![Complex64::ZERO; rule.block_count() * m],
            m,
        };
        for part in rule.node_parts() {
            for (i, t) in part.rows.nodes(order).iter().enumerate() {
                let s = own.parameter(part.center + part.half * t);
                own.points[part.block * m + i] = curve.from_start(s.into());
            }
        }
        own
    }

    /// Share of the panel → parameter of the arm.
    fn parameter(&self, share: f64) -> f64 {
        self.panel.start + share * self.panel.length()
    }

    /// Parameter of the arm → share of the panel.
    #[must_use]
    pub fn share(&self, s: Complex64) -> Complex64 {
        (s - self.panel.start) / self.panel.length()
    }

    /// How a target is seen, `step` from the corner, at the known parameter if there is one; `None` if its parameter is not
    /// found although it is near.
    #[must_use]
    pub(super) fn see(&self, rule: &PanelRule, order: &Order, known: Option<f64>, step: Complex64) -> Option<Seen> {
        let distance = self.distance_from_middle(step);
        // In a circle of radius r around the panel's middle in its parameter the curve strays by r + bend·r²/2 at most.
        let reach = if self.bend > 1e-3 {
            ((1.0 + 2.0 * self.bend * distance).sqrt() - 1.0) / self.bend
        } else {
            distance / (1.0 + 0.5 * self.bend * distance)
        };
        if reach >= order.far_ellipse {
            return Some(Seen::Whole(rule.whole(true)));
        }
        if reach >= if rule.levels() == 0 { order.piece_ellipse } else { order.union_ellipse } {
            return Some(Seen::Whole(rule.whole(false)));
        }
        if let Some(s) = known {
            let share = 2.0 * (s - self.panel.start) / self.panel.length() - 1.0;
            if share.abs() < 4.0 {
                return Some(Seen::Near(s.into()));
            }
        }
        self.parameter_of(step).map(Seen::Near)
    }

    /// Distance from the middle of the panel of the point `step` from the corner, in halves of its length.
    #[must_use]
    pub fn distance_from_middle(&self, step: Complex64) -> f64 {
        // Without the care for sizes that do not occur here.
        (step - self.middle).norm_sqr().sqrt() / self.half
    }

    /// The complex parameter near the panel of the point `step` from the corner.
    #[must_use]
    pub fn parameter_of(&self, step: Complex64) -> Option<Complex64> {
        let middle = Complex64::from(0.5 * (self.panel.start + self.panel.end));
        let guess = if self.slow {
            (2.0 * step / self.curve.bend(Complex64::ZERO)).sqrt()
        } else {
            middle + (step - self.middle) / self.curve.tangent(middle)
        };
        self.curve.preimage_from_start(step, guess)
    }

    /// Calls `visit` for the parts of the panel as seen.
    fn for_each_part(&self, rule: &PanelRule, order: &Order, seen: Seen, mut visit: impl FnMut(Part)) {
        match seen {
            Seen::Whole(part) => visit(part),
            Seen::Near(s) => rule.for_each_part(order, self.share(s), visit),
        }
    }

    /// Adds to `row` (length p) ∫ log|x − y| dμ(y) at the target for a unit mass at each node; false if its parameter was not
    /// found.
    pub fn add_row(
        &self,
        rule: &PanelRule,
        order: &Order,
        (known, step): (Option<f64>, Complex64),
        row: &mut [f64],
    ) -> bool {
        let Some(seen) = self.see(rule, order, known, step) else { return false };
        let mut logs = [0.0; MAX_NODES];
        self.for_each_part(rule, order, seen, |part| {
            let mut add = |part: Part, logs: &[f64]| {
                for (log, weights) in logs.iter().zip(rule.rows_of(part)) {
                    add_scaled(row, *log, weights);
                }
            };
            let count = rule.row_count(part.rows);
            if let (Rows::Coefficients, Seen::Near(s)) = (part.rows, seen) {
                exact_logs(self.share(s), part, self.panel.length().ln(), &mut logs[..count], |moment| moment.re);
                add(part, &logs[..count]);
                let nodes = rule.on_nodes(part);
                let taus = nodes.rows.nodes(order);
                for (log, t) in logs.iter_mut().zip(taus) {
                    let at = self.parameter(part.center + part.half * t);
                    *log = self.curve.chord(at.into(), s).norm_sqr();
                }
                fast_log::half_ln(&mut logs[..taus.len()]);
                add(nodes, &logs[..taus.len()]);
            } else {
                let points = &self.points[part.block * self.m..][..count];
                logs.iter_mut().zip(points).for_each(|(log, z)| *log = (step - z).norm_sqr());
                fast_log::half_ln(&mut logs[..count]);
                add(part, &logs[..count]);
            }
        });
        true
    }

    /// The potentials of the panel's parts at a point of the region `step` from the corner, from the corner outwards.
    #[must_use]
    pub fn potentials(&self, rule: &PanelRule, order: &Order, step: Complex64, charges: &[f64]) -> Vec<PartPotential> {
        let seen = self.see(rule, order, None, step).unwrap_or(Seen::Whole(rule.whole(false)));
        let mut parts = Vec::new();
        self.for_each_part(rule, order, seen, |part| {
            let ends = [-1.0, 1.0].map(|t| self.parameter(part.center + part.half * t));
            let own = rule.charges_of(part, charges);
            parts.push(match (part.rows, seen) {
                (Rows::Coefficients, Seen::Near(s)) => {
                    let nodes = rule.on_nodes(part);
                    self.near_part((part, own), rule.charges_of(nodes, charges), nodes.rows.nodes(order), s, ends)
                }
                _ => self.far_part(part, own, step, ends),
            });
        });
        parts.reverse();
        parts
    }

    fn far_part(&self, part: Part, charges: &[f64], step: Complex64, ends: [f64; 2]) -> PartPotential {
        let points = &self.points[part.block * self.m..][..charges.len()];
        let base = step - points[points.len() / 2];
        let (mut sum, mut slope, mut mass) = (Complex64::ZERO, Complex64::ZERO, 0.0);
        for (charge, z) in charges.iter().zip(points) {
            let away = step - z;
            sum += (away / base).ln() * charge;
            slope += away.inv() * charge;
            mass += charge;
        }
        sum += base.ln() * mass;
        let arguments = ends.map(|s| base.arg() + ((step - self.curve.from_start(s.into())) / base).arg());
        PartPotential { sum, slope, mass, arguments }
    }

    fn near_part(
        &self,
        (part, coefficients): (Part, &[f64]),
        charges: &[f64],
        nodes: &[f64],
        s: Complex64,
        ends: [f64; 2],
    ) -> PartPotential {
        let scale = part.half * self.panel.length();
        let mut zeta = (self.share(s) - part.center) / part.half;
        if zeta.im == 0.0 {
            // On the curve: what it is on the region's side.
            zeta.im = if self.panel.outgoing { 0.0 } else { -0.0 };
        }
        let (mut logs, mut slopes) = ([Complex64::ZERO; MAX_NODES], [Complex64::ZERO; MAX_NODES]);
        let (logs, slopes) = (&mut logs[..coefficients.len()], &mut slopes[..coefficients.len()]);
        log_moments_with_slopes(zeta, logs, slopes);
        logs[0] += 2.0 * scale.ln();
        let mut sum: Complex64 = logs.iter().zip(coefficients).map(|(log, c)| log * c).sum();
        let mut slope: Complex64 = slopes.iter().zip(coefficients).map(|(q, c)| q * c).sum::<Complex64>() / scale;
        let base = self.curve.chord(self.parameter(part.center).into(), s);
        let mut mass = 0.0;
        for (charge, t) in charges.iter().zip(nodes) {
            let at = Complex64::from(self.parameter(part.center + part.half * t));
            let chord = self.curve.chord(at, s);
            sum += (chord / base).ln() * charge;
            slope += self.curve.chord_slope(at, s) / chord * charge;
            mass += charge;
        }
        sum += base.ln() * mass;
        slope /= self.curve.tangent(s);
        let argument =
            |t: f64, end: f64| base.arg() + (self.curve.chord(end.into(), s) / base).arg() + (zeta - t).arg();
        let arguments = [argument(-1.0, ends[0]), argument(1.0, ends[1])];
        PartPotential { sum, slope, mass, arguments }
    }
}
