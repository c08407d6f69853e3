//! Functions of a parameter and a variable: an order, a branch, a modulus or a lattice, and a point.

use super::functions::{Jacobi, LARGEST_ORDER, Lattice, Modulus, UNDEFINED, ValueAndSlope, bessel_j, lambert_w};
use crate::plane::Complex64;

/// A function of which the first operand must not depend on z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Special {
    /// W_k(z).
    LambertW,
    /// J_n(z).
    BesselJ,
    /// sn, cn or dn of modulus k.
    Jacobi(Jacobi),
    /// ℘ of the lattice ℤ + τℤ.
    Weierstrass,
    /// ℘'.
    WeierstrassPrime,
}

impl Special {
    /// z → (f(z), f'(z)) for one parameter; what depends on that alone is computed once.
    pub fn function(self, parameter: Complex64) -> Box<dyn Fn(Complex64) -> ValueAndSlope> {
        match self {
            Self::LambertW => Box::new(move |z| lambert_w(parameter, z)),
            Self::BesselJ => Box::new(move |z| bessel_j(parameter, z)),
            Self::Jacobi(function) => {
                let modulus = Modulus::new(parameter);
                Box::new(move |z| modulus.eval(function, z))
            }
            Self::Weierstrass | Self::WeierstrassPrime => {
                let Some(lattice) = Lattice::new(parameter) else { return Box::new(|_| UNDEFINED) };
                if self == Self::Weierstrass {
                    Box::new(move |z| lattice.wp(z))
                } else {
                    Box::new(move |z| lattice.wp_prime(z))
                }
            }
        }
    }

    /// f(z) for one parameter.
    pub fn value(self, parameter: Complex64, z: Complex64) -> Complex64 {
        self.function(parameter)(z).0
    }

    /// Where among the arguments the parameter stands, from 0.
    pub fn place_of_parameter(self) -> usize {
        usize::from(self != Self::BesselJ)
    }

    /// Whether the parameter may be that number.
    pub fn accepts(self, parameter: Complex64) -> bool {
        let whole = parameter.im == 0.0 && parameter.re.trunc() == parameter.re;
        match self {
            Self::LambertW => whole,
            Self::BesselJ => whole && parameter.re.abs() <= LARGEST_ORDER,
            Self::Jacobi(_) => true,
            Self::Weierstrass | Self::WeierstrassPrime => Lattice::new(parameter).is_some(),
        }
    }

    /// What the parameter must be.
    pub fn expected(self) -> &'static str {
        match self {
            Self::LambertW => "a whole number, the branch, that does not depend on z",
            Self::BesselJ => "a whole number up to 500, the order, that does not depend on z",
            Self::Jacobi(_) => "a modulus that does not depend on z",
            Self::Weierstrass | Self::WeierstrassPrime => {
                "a ratio of periods that is not real and does not depend on z"
            }
        }
    }
}
