//! What the residual says of the map where the outside of the region is thin.
//!
//! The density is the jump of the normal derivative between the potential's inside and outside. Inside, the residual's
//! conjugate function is an error of the map of about its size. Outside, between the two faces of a wall of width w, residuals
//! r₊ and r₋ make a field (r₊ − r₋)/w, that is an error of θ by ∫ (r₊ − r₋)/w ds along the wall: masses that are opposite on its two
//! faces hardly show in the potential.

use super::panel::{Boundary, Panel};

/// How the wall behind each panel amplifies the panel's residual.
#[derive(Clone, Debug)]
pub struct ThinWalls {
    /// Length over width of the wall; 0 where there is none or a thick one. Negative where the boundary comes back along it.
    signed_slenderness: Vec<f64>,
}

/// Walls less slender than this do no harm: the estimate without them has a margin.
const SLENDER: f64 = 0.5;
/// Walls more slender than this are taken for cuts: their two faces mirror each other's panels, and the residuals cancel.
const MOST_SLENDER: f64 = 1000.0;
/// The two faces may add up.
const FACES: f64 = 2.0;

impl ThinWalls {
    /// Looks behind every panel.
    #[must_use]
    pub fn new(boundary: &Boundary, panels: &[Panel]) -> Self {
        let behind = |panel: &Panel| (panel.edge, panel.length(), boundary.behind(panel, panel.length() / SLENDER));
        Self::of(panels.iter().map(behind))
    }

    /// From the edge and length of each panel, and the edge behind it with its distance, if there is one within
    /// [`ThinWalls::reach`].
    #[must_use]
    pub fn of(panels: impl Iterator<Item = (usize, f64, Option<(usize, f64)>)>) -> Self {
        let slenderness = |(own, length, behind): (usize, f64, Option<(usize, f64)>)| match behind {
            Some((edge, width)) if length <= MOST_SLENDER * width => {
                length / width * if edge >= own { 1.0 } else { -1.0 }
            }
            _ => 0.0,
        };
        Self { signed_slenderness: panels.map(slenderness).collect() }
    }

    /// Walls wider than this do a panel of the given length no harm.
    #[must_use]
    pub fn reach(length: f64) -> Option<f64> {
        Some(length / SLENDER).filter(|reach| reach.is_finite())
    }

    /// Looks nowhere: for measures whose residuals are not asked for.
    #[must_use]
    pub fn unseen() -> Self {
        Self { signed_slenderness: Vec::new() }
    }

    /// The largest error of θ that residuals (one a panel) make along a wall.
    #[must_use]
    pub fn error(&self, residuals: &[f64]) -> f64 {
        let (mut here, mut largest) = (0.0, 0.0);
        let mut sign = 1.0;
        for (slenderness, residual) in self.signed_slenderness.iter().zip(residuals) {
            if *slenderness == 0.0 {
                continue;
            }
            if slenderness * sign < 0.0 {
                (sign, here) = (-sign, 0.0);
            }
            here += FACES * slenderness.abs() * residual;
            if here > largest || here.is_nan() {
                largest = here;
            }
        }
        largest
    }

    /// The factor of panel `q`'s residual, 1 where there is no thin wall.
    #[must_use]
    pub fn weight(&self, q: usize) -> f64 {
        1.0 + self.signed_slenderness[q].abs()
    }

    /// The largest of these factors.
    #[must_use]
    pub fn largest_weight(&self) -> f64 {
        1.0 + self.signed_slenderness.iter().fold(0.0, |largest, s| f64::max(largest, s.abs()))
    }
}
