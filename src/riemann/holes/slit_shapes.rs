//! Where the two maps onto parallel slits, along and across, take each component; their mean has no slits.
//!
//! With f₀(z) and f₁(z) = 1/(z − center) + … onto slits along the real and the imaginary axis, (f₀ + f₁)/2 is one-to-one, and takes
//! every component to a convex curve (Grunsky, Koebe). Of a disk about the center without holes it is 1/z exactly; a small round
//! hole stays nearly round.

use super::super::evidence::Evidence;
use super::canonical::{Canonical, Form};
use super::circle::Circle;
use super::field::DomainField;
use super::peak::peak;
use super::solved::Solved;
use crate::plane::{Complex64, Domain};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::problem::{Problem, Source};
use crate::{Error, Result};
use std::f64::consts::PI;

/// A domain seen through its slit maps.
#[derive(Debug)]
pub struct SlitShapes {
    /// 1/((f₀ + f₁)/2 − b) in units in which the outer boundary goes to about the unit circle. Center ↦ 0.
    pub map: Canonical,
    /// About what each hole becomes in the reciprocal of that picture.
    pub circles: Vec<Circle>,
    /// The estimate is of that map.
    pub evidence: Evidence,
}

/// Between two vertices, or two points of a smooth curve, slits' ends are looked for at so many places.
const SAMPLES: usize = 4;
/// Angles of slits that are looked at.
const ANGLES: usize = 4;

impl SlitShapes {
    /// Solves for both slit maps.
    ///
    /// # Errors
    /// [`Error::WrongRegion`] without an outer boundary or a center; as [`Solved::solve`].
    pub fn solve(domain: &Domain, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let wrong = |needed| Error::WrongRegion { what: "A circle map", needed, found: "none".to_string() };
        if !domain.is_bounded() {
            return Err(wrong("an outer boundary"));
        }
        let center = domain.center().ok_or_else(|| wrong("a center"))?;
        let charges = vec![0.0; domain.contours().len()];
        let factors = [Complex64::i(), Complex64::ONE];
        let problem = |factor, at| Problem { source: Source::pole(at, factor), charges: charges.clone() };
        let solved = Solved::solve(
            domain,
            &|scale| factors.map(|factor| problem(factor, scale.scaled(center))).to_vec(),
            options,
            progress,
        )?;
        let fields = along_and_across(&solved);
        let unit = solved.scale().unit;
        let slits: Vec<(Complex64, f64)> = (0..charges.len()).map(|k| slit(&fields, unit, k)).collect();
        let (middle, size) = slits[0];
        let circles =
            slits[1..].iter().map(|&(m, r)| Circle { center: (m - middle) / size, radius: r / size }).collect();
        let form = Form {
            factor: 0.5 * unit / size * Complex64::i(),
            shift: -middle / size,
            exponential: true,
            zero: Some(center),
        };
        let mut evidence = solved.evidence;
        evidence.error_estimate *= (unit / size).max(1.0);
        Ok(Self { map: Canonical::reciprocal(fields, form), circles, evidence })
    }
}

/// B of the slits along the real axis, f₀ = iB + …, and across it, f₁ = −B + ….
fn along_and_across(solved: &Solved) -> [DomainField; 2] {
    [[1.0, 0.0], [0.0, 1.0]].map(|weights| solved.field(&weights))
}

/// The mean of a component's slits at several angles: their middle, and a quarter of their length, which is the radius that a
/// round hole would have.
fn slit(fields: &[DomainField; 2], unit: f64, component: usize) -> (Complex64, f64) {
    let contour = &fields[0].domain().contours()[component];
    let per_edge = SAMPLES * contour.detail();
    // e^{-iθ} times the map at the angle θ has the real part x cos θ + y sin θ.
    let at = |place: f64| {
        let [x, y] = [0, 1].map(|k| fields[k].on_boundary(fields[k].domain().place_along(component, place)).0.im);
        Complex64::new(x, y) * -unit
    };
    let samples: Vec<Complex64> =
        (0..contour.edge_count() * per_edge).map(|k| at(k as f64 / per_edge as f64)).collect();
    let (mut middle, mut length) = (Complex64::ZERO, 0.0);
    for turn in (0..ANGLES).map(|k| Complex64::cis(PI * k as f64 / ANGLES as f64)) {
        let along = |z: Complex64| (z * turn.conj()).re;
        let [low, high] = [-1.0, 1.0].map(|sign| {
            let value = |k: usize| sign * along(samples[k]);
            let best = (0..samples.len()).max_by(|&a, &b| value(a).total_cmp(&value(b))).unwrap_or(0);
            let place = |k: f64| (best as f64 + k) / per_edge as f64;
            along(at(peak(&|place| sign * along(at(place)), place(-1.0), place(1.0))))
        });
        middle += turn * ((low + high) / ANGLES as f64);
        length += (high - low) / ANGLES as f64;
    }
    let [along, across] = [0, 1].map(|k| fields[k].constants()[component]);
    (0.5 * (middle + Complex64::new(across, -along) * unit), length / 4.0)
}
