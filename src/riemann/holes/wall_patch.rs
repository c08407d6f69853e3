//! B beside a straight wall: one real power series in the variable of a zone.

use super::super::atlas::arc_sampler::{ArcSampler, Expand};
use super::super::atlas::fit::Fit;
use super::super::atlas::power_series::real_value_and_slope;
use super::super::atlas::zone::{Place, Zone};
use super::cuts::Cuts;
use crate::plane::Complex64;
use crate::symm::field::Field;
use std::f64::consts::FRAC_PI_2;

/// B = b + iΣ cₖ τᵏ in a zone. As the coefficients are real, Re B is one number on the wall (Schwarz's reflection).
#[derive(Clone, Debug)]
pub struct WallPatch {
    zone: Zone,
    /// B at the zone's middle.
    base: Complex64,
    coefficients: Vec<f64>,
    /// The branch of B at the zone's top less that of the series.
    turn: Complex64,
}

/// What a patch says of a point.
pub enum Beside {
    /// (B, B').
    Known(Complex64, Complex64),
    /// It is the corner itself.
    Corner,
    /// It lies outside.
    Outside,
}

impl WallPatch {
    /// Fits −iB'·α(z − origin) = Σ k cₖ τᵏ, which has one value where B may have many: on the diameter from the density, on
    /// the arc from expansions of L.
    #[must_use]
    pub fn new(field: &Field, zone: Zone, expand: Expand, fit: &Fit) -> Self {
        let boundary = field.boundary();
        let turned = |tau: Complex64, slope: Complex64| -Complex64::i() * slope * zone.offset(tau) * zone.alpha;
        let on_diameter = |x: &f64| {
            let (edge, along, rest) = zone.on_edge(boundary, *x);
            turned(Complex64::from(*x), field.on_edge_between(edge, along, rest).1).re
        };
        let on_diameter: Vec<f64> = fit.diameter.iter().map(on_diameter).collect();
        let mut sampler = ArcSampler::new(expand, fit.accuracy);
        let on_arc = |tau: &Complex64| {
            let (_, slope) = sampler.at(&zone, *tau);
            turned(*tau, slope - field.source.at(zone.point(*tau)).1)
        };
        let on_arc: Vec<Complex64> = fit.arc.iter().map(on_arc).collect();
        let mut coefficients = fit.coefficients(&on_diameter, &on_arc);
        coefficients.iter_mut().enumerate().for_each(|(k, c)| *c /= (k + 1) as f64);
        let rest = boundary.lengths[zone.edge] - zone.along;
        let base = field.on_edge_between(zone.edge, zone.along, rest).0;
        let mut patch = Self { zone, base, coefficients, turn: Complex64::ZERO };
        let top = patch.top();
        let mut there = [Complex64::ZERO; 2];
        expand(top, 1e-3 * zone.reach, &mut there);
        if let Beside::Known(value, _) = patch.at(top) {
            let turn = (there[0] - field.source.at(top).0 - value).im;
            patch.turn = Complex64::new(field.turn(zone.edge, top), turn);
        }
        patch
    }

    fn top(&self) -> Complex64 {
        self.zone.point(Complex64::i())
    }

    /// What is to be added to B at a point of the zone to have it on the branch of direct summation.
    #[must_use]
    pub fn branch(&self, z: Complex64, cuts: &Cuts) -> Complex64 {
        let Place::At(tau) = self.zone.place(z) else { return Complex64::ZERO };
        // By the middle of the way, so that neither half goes around the corner outside.
        let middle = self.zone.point(Complex64::cis(0.5 * (tau.arg() + FRAC_PI_2)) * tau.norm().max(0.5));
        cuts.jump(self.top(), middle) + cuts.jump(middle, z) + self.turn
    }

    /// (B, B') at a point of the zone.
    #[inline]
    #[must_use]
    pub fn at(&self, z: Complex64) -> Beside {
        let tau = match self.zone.place(z) {
            Place::At(tau) => tau,
            Place::Outside => return Beside::Outside,
        };
        if tau == Complex64::ZERO && self.zone.alpha != 1.0 {
            return Beside::Corner;
        }
        let (sum, slope) = real_value_and_slope(&self.coefficients, tau);
        let i = Complex64::i();
        Beside::Known(self.base + i * sum, i * slope * self.zone.slope(tau))
    }
}
