//! The names that every formula knows.

use super::functions::Jacobi;
use super::operation::{Analytic, Real, Unary};
use super::special::Special;
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

/// What a name means where nothing else has it: coordinates, and capitals as some write them.
pub fn fallback(name: &str) -> Option<Fallback> {
    match name {
        "x" => Some(Fallback::Part(Real::Part)),
        "y" => Some(Fallback::Part(Real::Imaginary)),
        "Z" => Some(Fallback::Variable),
        "I" => Some(Fallback::Constant(Complex64::I)),
        _ => None,
    }
}

/// The meaning of a name that a formula may also take for itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fallback {
    /// re(z) or im(z).
    Part(Real),
    /// z.
    Variable,
    /// A number.
    Constant(Complex64),
}

/// Every function's usual name.
pub const FUNCTIONS: [&str; 56] = [
    "exp", "log", "ln", "log10", "sqrt", "pow", "sin", "cos", "tan", "sec", "csc", "cot", "sinh", "cosh", "tanh",
    "sech", "csch", "coth", "asin", "acos", "atan", "asec", "acsc", "acot", "asinh", "acosh", "atanh", "asech",
    "acsch", "acoth", "gamma", "sinc", "floor", "mod", "conj", "re", "im", "abs", "arg", "sum", "prod", "iterate",
    "arcsin", "arccos", "arctan", "product", "erf", "erfc", "zeta", "lambertw", "besselj", "sn", "cn", "dn", "wp",
    "wpp",
];

/// The function that a misspelt name may mean: one that differs by a letter, or by two that changed places.
pub fn suggestion(name: &str) -> Option<&'static str> {
    let lower = name.to_lowercase();
    let count = lower.chars().count();
    let near = FUNCTIONS.into_iter().filter(|known| count >= 2 && known.len() >= 3 && is_one_slip_apart(&lower, known));
    // The first letter is seldom wrong.
    near.min_by_key(|known| (known.chars().next() != lower.chars().next(), known.len().abs_diff(count)))
}

/// Whether one letter more, less or another, or two neighbours exchanged, make one word the other.
fn is_one_slip_apart(a: &str, b: &str) -> bool {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let same = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
    let (a, b) = (&a[same..], &b[same..]);
    match (a, b) {
        ([], [_]) | ([_], []) => true,
        ([p, q, a @ ..], [r, s, b @ ..]) if p == s && q == r && a == b => true,
        ([_, a @ ..], [_, b @ ..]) if a == b => true,
        ([_, rest @ ..], b) if rest == b => true,
        (a, [_, rest @ ..]) => a == rest,
        _ => false,
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
    /// `log10(z)`.
    LogTen,
    /// `mod(z, m)` = z − m floor(z/m).
    Modulo,
    /// `lambertw(z)`, `lambertw(z, k)`, `besselj(n, z)`, `sn(z, k)`, `wp(z, τ)` and their kin.
    Special(Special),
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
            Self::Unary(_) | Self::LogTen => (1, 1),
            Self::Special(Special::LambertW) => (1, 2),
            Self::Modulo | Self::Special(_) => (2, 2),
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
        "sinc" => Sinc,
        "erf" => Erf,
        "erfc" => Erfc,
        "zeta" => Zeta,
        "floor" => Floor,
        // A small gamma is free to be a parameter.
        "γ" if name == "Γ" => Gamma,
        other => return other_function(other),
    };
    Some(Call::Unary(Unary::Analytic(analytic)))
}

fn other_function(lower: &str) -> Option<Call> {
    let special = |special| Some(Call::Special(special));
    let real = |real| Some(Call::Unary(Unary::Real(real)));
    match lower {
        "re" => real(Real::Part),
        "im" => real(Real::Imaginary),
        "abs" => real(Real::Modulus),
        "arg" => real(Real::Argument),
        "conj" => Some(Call::Unary(Unary::Conjugate)),
        "log" | "ln" => Some(Call::Log),
        "log10" | "lg" => Some(Call::LogTen),
        "mod" => Some(Call::Modulo),
        "lambertw" => special(Special::LambertW),
        "besselj" => special(Special::BesselJ),
        "sn" => special(Special::Jacobi(Jacobi::Sn)),
        "cn" => special(Special::Jacobi(Jacobi::Cn)),
        "dn" => special(Special::Jacobi(Jacobi::Dn)),
        "wp" | "℘" => special(Special::Weierstrass),
        "wpp" => special(Special::WeierstrassPrime),
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
        assert!(FUNCTIONS.into_iter().all(|name| function(name).is_some()));
        assert_eq!(
            ["sni", "cosn", "sqr", "expp", "acrtan", "blub"].map(suggestion),
            [Some("sin"), Some("cosh"), Some("sqrt"), Some("exp"), Some("arctan"), None]
        );
        assert!(is_taken("z") && is_taken("sum") && !is_taken("w"));
    }
}
