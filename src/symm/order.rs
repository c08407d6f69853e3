//! How finely a panel is resolved, and from which distance each of its quadratures serves.

use super::legendre::{GaussRule, coefficients_of_masses, restrictions};

/// Degrees and distances of a discretisation; all follow from the accuracy wanted.
#[derive(Clone, Debug)]
pub struct Order {
    /// Nodes of a panel: p unknowns, density of degree p − 1 in τ.
    pub panel: GaussRule,
    /// Digits that the quadrature keeps.
    pub digits: f64,
    /// Nodes of a piece or union.
    pub piece: GaussRule,
    /// Gauss's rule serves a piece outside the Bernstein ellipse with this semi-axis.
    pub piece_ellipse: f64,
    /// The moments serve a union outside this one.
    pub union_ellipse: f64,
    /// Half as many nodes, for whole panels far away.
    pub far: GaussRule,
    /// The far moments serve a panel outside this one.
    pub far_ellipse: f64,
    /// m × m: masses on the nodes of [0, ½] → on those of [0, 1], with the same first m moments.
    pub to_inner_half: Vec<f64>,
    /// The same from [½, 1].
    pub to_outer_half: Vec<f64>,
    /// m × m: masses on the nodes of a piece → the Legendre coefficients of their density.
    pub to_piece_coefficients: Vec<f64>,
}

impl Order {
    /// p unknowns a panel, and quadrature good to `10^-digits`.
    #[must_use]
    pub fn new(p: usize, digits: f64) -> Self {
        let m = if digits > 9.0 {
            16
        } else if digits > 6.0 {
            12
        } else {
            8
        };
        // Errors fall like ρ^−power: the semi-axis at which that is 10^−digits.
        let semi_axis = |power: usize| (digits * std::f64::consts::LN_10 / power as f64).cosh();
        let piece = GaussRule::new(m);
        let [to_inner_half, to_outer_half] = restrictions(&piece);
        Self {
            panel: GaussRule::new(p),
            digits,
            to_inner_half,
            to_outer_half,
            to_piece_coefficients: coefficients_of_masses(&piece),
            piece,
            piece_ellipse: semi_axis(2 * m - p.min(m)),
            union_ellipse: semi_axis(m),
            far: GaussRule::new(m / 2),
            far_ellipse: semi_axis(m / 2),
        }
    }

    /// Unknowns a panel.
    #[must_use]
    pub fn p(&self) -> usize {
        self.panel.len()
    }
}
