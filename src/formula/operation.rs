//! The operations that a compiled formula is made of.

use super::functions::{self, ValueAndSlope};
use super::special::Special;
use crate::plane::Complex64;

/// An analytic function of one variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Analytic {
    Exp,
    Log,
    Sqrt,
    /// e^{iπz}
    CisPi,
    Sin,
    Cos,
    Tan,
    Sec,
    Csc,
    Cot,
    Sinh,
    Cosh,
    Tanh,
    Sech,
    Csch,
    Coth,
    Asin,
    Acos,
    Atan,
    Asec,
    Acsc,
    Acot,
    Asinh,
    Acosh,
    Atanh,
    Asech,
    Acsch,
    Acoth,
    Gamma,
    Sinc,
    Erf,
    Erfc,
    Zeta,
    /// The whole number below, of both parts: constant but where it jumps.
    Floor,
}

impl Analytic {
    /// z → (f(z), f'(z)).
    pub fn function(self) -> fn(Complex64) -> ValueAndSlope {
        match self {
            Self::Exp => functions::exp,
            Self::Log => functions::log,
            Self::Sqrt => functions::sqrt,
            Self::CisPi => functions::cis_pi,
            Self::Sin => functions::sin,
            Self::Cos => functions::cos,
            Self::Tan => functions::tan,
            Self::Sec => functions::sec,
            Self::Csc => functions::csc,
            Self::Cot => functions::cot,
            Self::Sinh => functions::sinh,
            Self::Cosh => functions::cosh,
            Self::Tanh => functions::tanh,
            Self::Sech => functions::sech,
            Self::Csch => functions::csch,
            Self::Coth => functions::coth,
            Self::Asin => functions::asin,
            Self::Acos => functions::acos,
            Self::Atan => functions::atan,
            Self::Asec => functions::asec,
            Self::Acsc => functions::acsc,
            Self::Acot => functions::acot,
            Self::Asinh => functions::asinh,
            Self::Acosh => functions::acosh,
            Self::Atanh => functions::atanh,
            Self::Asech => functions::asech,
            Self::Acsch => functions::acsch,
            Self::Acoth => functions::acoth,
            Self::Gamma => functions::gamma,
            Self::Sinc => functions::sinc,
            Self::Erf => functions::erf,
            Self::Erfc => functions::erfc,
            Self::Zeta => functions::zeta,
            Self::Floor => functions::floor,
        }
    }
}

/// A real-valued function, or the conjugate: differentiable, but not analytic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Real {
    Part,
    Imaginary,
    Modulus,
    Argument,
}

impl Real {
    /// The value, as a complex number with imaginary part 0.
    pub fn value(self, z: Complex64) -> Complex64 {
        let value = match self {
            Self::Part => z.re,
            Self::Imaginary => z.im,
            Self::Modulus => z.re.hypot(z.im),
            Self::Argument => (z.im + 0.0).atan2(z.re + 0.0),
        };
        Complex64::new(value, 0.0)
    }

    /// The w for which the differential is Re(w dz). At 0, where |z| has none, a direction is chosen, so that the
    /// stretch is 1 there too.
    pub fn weight(self, z: Complex64) -> Complex64 {
        match self {
            Self::Part => Complex64::ONE,
            Self::Imaginary => -Complex64::I,
            Self::Modulus if z == Complex64::ZERO => Complex64::ONE,
            Self::Modulus => z.conj() / z.re.hypot(z.im),
            Self::Argument => functions::divide(-Complex64::I, z),
        }
    }
}

/// An operation with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unary {
    Negate,
    Conjugate,
    Real(Real),
    Analytic(Analytic),
}

impl Unary {
    /// Its value at a point.
    pub fn value(self, z: Complex64) -> Complex64 {
        match self {
            Self::Negate => -z,
            Self::Conjugate => z.conj(),
            Self::Real(real) => real.value(z),
            Self::Analytic(analytic) => analytic.function()(z).0,
        }
    }

    /// Whether it spoils analyticity.
    pub fn is_analytic(self) -> bool {
        matches!(self, Self::Negate | Self::Analytic(_))
    }
}

/// An operation with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    /// f(b) for the parameter a, which does not depend on z.
    Special(Special),
}

impl Binary {
    /// Its value at a pair of points.
    pub fn value(self, a: Complex64, b: Complex64) -> Complex64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => functions::divide(a, b),
            Self::Power => functions::pow(a, b),
            Self::Special(special) => special.value(a, b),
        }
    }

    /// Whether the order of the operands does not matter.
    pub fn commutes(self) -> bool {
        matches!(self, Self::Add | Self::Multiply)
    }
}
