//! The names that every formula knows.

use super::operation::{Analytic, Real, Unary};
use crate::plane::Complex64;
use std::f64::consts::{E, PI, TAU};

/// The variable.
pub const VARIABLE: &str = "z";

/// A named constant's value.
pub fn constant(name: &str) -> Option<Complex64> {
    match name {
        "i" => Some(Complex64::I),
        "e" => Some(Complex64::new(E, 0.0)),
        "pi" | "π" => Some(Complex64::new(PI, 0.0)),
        "tau" | "τ" => Some(Complex64::new(TAU, 0.0)),
        _ => None,
    }
}

/// What follows a function's name in parentheses, and what becomes of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Call {
    /// One argument.
    Unary(Unary),
    /// `log(z)`, `log(z, k)`: the k-th branch adds 2πik.
    Log,
    /// `sqrt(z)`, `sqrt(z, k)`: the k-th branch is turned by e^{iπk}.
    Sqrt,
    /// `pow(z, a)`, `pow(z, a, k)`: the k-th branch is turned by e^{2πiak}.
    Power,
    /// `name(n, from, to, body)` or `iterate(w, start, count, body)`.
    Loop(Loop),
}

/// The bounded repetitions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loop {
    /// Σ over n = from … to.
    Sum,
    /// Π over n = from … to.
    Product,
    /// `count` times w → body(w), from `start`.
    Iterate,
}

impl Call {
    /// Fewest and most arguments (a loop has its own grammar).
    pub fn arguments(self) -> (usize, usize) {
        match self {
            Self::Unary(_) => (1, 1),
            Self::Log | Self::Sqrt => (1, 2),
            Self::Power => (2, 3),
            Self::Loop(_) => (4, 4),
        }
    }
}

/// The function of that name. Textbooks' capitals (`Log`, `Arg`) are the principal branches, which is what these are.
pub fn function(name: &str) -> Option<Call> {
    use Analytic::*;
    let lower = name.to_lowercase();
    let analytic = match lower.as_str() {
        "exp" => Exp,
        "sin" => Sin,
        "cos" => Cos,
        "tan" => Tan,
        "sec" => Sec,
        "csc" | "cosec" => Csc,
        "cot" => Cot,
        "sinh" => Sinh,
        "cosh" => Cosh,
        "tanh" => Tanh,
        "sech" => Sech,
        "csch" => Csch,
        "coth" => Coth,
        "asin" | "arcsin" => Asin,
        "acos" | "arccos" => Acos,
        "atan" | "arctan" => Atan,
        "asec" | "arcsec" => Asec,
        "acsc" | "arccsc" => Acsc,
        "acot" | "arccot" => Acot,
        "asinh" | "arsinh" | "arcsinh" => Asinh,
        "acosh" | "arcosh" | "arccosh" => Acosh,
        "atanh" | "artanh" | "arctanh" => Atanh,
        "asech" | "arsech" | "arcsech" => Asech,
        "acsch" | "arcsch" | "arccsch" => Acsch,
        "acoth" | "arcoth" | "arccoth" => Acoth,
        "gamma" => Gamma,
        // A small gamma is free to be a parameter.
        "γ" if name == "Γ" => Gamma,
        other => return other_function(other),
    };
    Some(Call::Unary(Unary::Analytic(analytic)))
}

fn other_function(lower: &str) -> Option<Call> {
    let real = |real| Some(Call::Unary(Unary::Real(real)));
    match lower {
        "re" => real(Real::Part),
        "im" => real(Real::Imaginary),
        "abs" => real(Real::Modulus),
        "arg" => real(Real::Argument),
        "conj" => Some(Call::Unary(Unary::Conjugate)),
        "log" | "ln" => Some(Call::Log),
        "sqrt" => Some(Call::Sqrt),
        "pow" => Some(Call::Power),
        "sum" => Some(Call::Loop(Loop::Sum)),
        "prod" | "product" => Some(Call::Loop(Loop::Product)),
        "iterate" => Some(Call::Loop(Loop::Iterate)),
        _ => None,
    }
}

/// Whether a formula's own name would hide one of these.
pub fn is_taken(name: &str) -> bool {
    name == VARIABLE || constant(name).is_some() || function(name).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn textbook_capitals_and_greek_are_understood() {
        assert_eq!(function("Log"), Some(Call::Log));
        assert_eq!(function("Γ"), Some(Call::Unary(Unary::Analytic(Analytic::Gamma))));
        assert_eq!(constant("τ"), constant("tau"));
        assert!(is_taken("z") && is_taken("sum") && !is_taken("w"));
    }
}
