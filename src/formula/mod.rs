//! Maps given as a formula in z.
//!
//! Text → tokens (`lexer`) → postfix steps (`parser`) → a graph without repetitions (`graph`, `expansion`) →
//! a flat program (`program`) → values and exact derivatives at blocks of points (`run`).

mod expansion;
mod functions;
mod graph;
mod lanes;
mod lexer;
mod names;
mod operation;
mod parser;
mod program;
mod run;
mod special;

use crate::map::{Jet, PlaneMap};
use crate::plane::Complex64;
use crate::stored::{Kind, read, written};
use crate::{Error, Result};
use program::Program;

/// A map plane → plane given by a formula in z, compiled once.
///
/// # The language
/// - `z`; `i`, `e`, `pi` or `π`, `tau` or `τ`; numbers; parameters, named when the map is made.
/// - `+ − * / ^`, parentheses, `|z|`; multiplication may be left out (`2z`, `3(z+1)`, `z sin(z)`, `2πi`). Typed
///   niceties: `−`, `·`, `×`, `z²`, `z⁻¹`, `√`, `z̄`.
/// - `exp log sqrt pow`; `sin cos tan sec csc cot`, the same with `h`, and the inverses of all with `a` or `arc`
///   before the name; `gamma`; `conj re im arg abs`.
/// - `x` and `y` are re(z) and im(z), `Z` is z and `I` is i, unless a parameter has the name; `f(z) =` may stand before
///   all. `sin z`, `sin 2πz` and `sin²(z)` are read as in textbooks.
/// - `erf`, `erfc`; `zeta`; `lambertw(z)` and `lambertw(z, k)`, the branches of Lambert's W; `besselj(n, z)`, |n| ≤ 500;
///   Jacobi's `sn(z, k)`, `cn(z, k)`, `dn(z, k)` of modulus k, where some have m = k²; Weierstrass's `wp(z, t)` or `℘(z, t)`
///   of the lattice with periods 1 and t, and `wpp`, its derivative. Branch, order, modulus and lattice may be parameters,
///   but must not depend on z; a parameter that is not whole, where it must be, leaves the map undefined.
/// - `log10`; `sinc(z)` = sin z / z; `floor`, of both parts; `mod(z, m)` = z − m floor(z/m).
/// - Branches: `log(z, k)` = log z + 2πik, `sqrt(z, k)` = e^{iπk} √z, `pow(z, a, k)` = e^{2πiak} z^a.
/// - `sum(n, 1, 10, z^n/n)`, `prod(n, from, to, …)` and `iterate(w, z, 8, w^2 + z)`, whose bounds are whole numbers.
///
/// Branches are principal, cuts as in C99 and mpmath: (−∞, 0] for `log`, `sqrt` and powers, (−∞, −1] and [1, ∞) for
/// `asin`, `acos`, `atanh`, (−∞, 1] for `acosh`, the imaginary axis beyond ±i for `asinh` and `atan`. On a cut the sign
/// of a zero is ignored: `sqrt(-4)` is 2i.
///
/// Derivatives are exact (forward differentiation), not differences. A value that is not finite (a pole) makes the
/// whole jet undefined. Text of any kind gives a map or an error, in bounded time.
///
/// ```
/// use conformal_warp::{Complex64, FormulaMap};
/// let mut map = FormulaMap::with_params("z^2 + 2t z", &[("t", Complex64::I)])?;
/// let z = [Complex64::new(1.0, 1.0)];
/// assert_eq!(map.eval(&z), [Complex64::new(-2.0, 4.0)]);
/// assert_eq!(map.derivative(&z), [Complex64::new(2.0, 4.0)]);
/// map.set_param("t", Complex64::ONE)?;
/// assert_eq!(map.eval(&z), [Complex64::new(2.0, 4.0)]);
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct FormulaMap {
    text: String,
    names: Vec<String>,
    values: Vec<Complex64>,
    program: Program,
    /// The program's fixed values for the present parameters.
    fixed: Vec<Complex64>,
}

/// A formula of the largest length names fewer.
const MOST_STORED_PARAMETERS: usize = 5000;

impl FormulaMap {
    /// A map from a formula in z alone.
    ///
    /// # Errors
    /// [`Error::Syntax`] where the text cannot be read; [`Error::FormulaTooLarge`] beyond 10 000 characters, 200 levels of
    /// nesting or 20 000 operations.
    pub fn new(text: &str) -> Result<Self> {
        Self::with_params(text, &[])
    }

    /// A map from a formula in z and parameters, with their first values.
    ///
    /// # Errors
    /// As [`FormulaMap::new`]; [`Error::InvalidParameter`] for a name that means something else, and
    /// [`Error::NotFinite`] for a value.
    pub fn with_params(text: &str, params: &[(&str, Complex64)]) -> Result<Self> {
        let mut names: Vec<String> = Vec::with_capacity(params.len());
        for &(name, value) in params {
            check_name(name, &names)?;
            check_value(name, value)?;
            names.push(name.to_string());
        }
        let (graph, result) = expansion::expand(&parser::parse(text, &names)?)?;
        let program = Program::new(&graph, result);
        let values: Vec<Complex64> = params.iter().map(|&(_, value)| value).collect();
        let fixed = program.bind(&values);
        Ok(Self { text: text.to_string(), names, values, program, fixed })
    }

    /// The text and the parameters' present values as bytes, from which [`FormulaMap::from_bytes`] makes the same map.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        written(Kind::Formula, |to| {
            to.text(&self.text);
            to.count(self.names.len());
            for (name, value) in self.params() {
                to.text(name);
                to.point(value);
            }
        })
    }

    /// The map that [`FormulaMap::to_bytes`] stored.
    ///
    /// # Errors
    /// [`Error::NotStored`], [`Error::OtherFormat`], [`Error::Damaged`], and those of [`FormulaMap::with_params`] for bytes that
    /// somebody made up.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self> {
        read(Kind::Formula, bytes, |from| {
            let text = from.text()?;
            let count = from.count(size_of::<u32>() + size_of::<Complex64>())?;
            if count > MOST_STORED_PARAMETERS {
                return Err(Error::Damaged { reason: "it has more parameters than a formula can name" });
            }
            let params = (0..count).map(|_| Ok((from.text()?, from.point()?))).collect::<Result<Vec<_>>>()?;
            Self::with_params(text, &params)
        })
    }

    /// The names that a formula uses and that mean nothing by themselves, in the order in which they first appear: what
    /// [`FormulaMap::with_params`] must be given. Names that `sum`, `prod` and `iterate` bind are not among them.
    ///
    /// ```
    /// use conformal_warp::FormulaMap;
    /// assert_eq!(FormulaMap::parameters("t z + iterate(w, z, 3, w^2 + c) + x")?, ["t", "c"]);
    /// # Ok::<(), conformal_warp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Syntax`] and [`Error::FormulaTooLarge`], as [`FormulaMap::new`].
    pub fn parameters(text: &str) -> Result<Vec<String>> {
        parser::parameters(text)
    }

    /// Gives a parameter another value. Nothing is compiled again.
    ///
    /// # Errors
    /// [`Error::UnknownParameter`], [`Error::NotFinite`].
    pub fn set_param(&mut self, name: &str, value: Complex64) -> Result<()> {
        check_value(name, value)?;
        let Some(index) = self.names.iter().position(|known| known == name) else {
            let known = if self.names.is_empty() { "none".to_string() } else { self.names.join(", ") };
            return Err(Error::UnknownParameter { name: name.to_string(), known });
        };
        self.values[index] = value;
        self.fixed = self.program.bind(&self.values);
        Ok(())
    }

    /// The parameters and their present values.
    pub fn params(&self) -> impl Iterator<Item = (&str, Complex64)> {
        self.names.iter().map(String::as_str).zip(self.values.iter().copied())
    }

    /// The formula as it was given.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether the map is analytic where it is defined: no `conj`, `re`, `im`, `abs` or `arg` of anything that depends
    /// on z.
    #[must_use]
    pub fn is_analytic(&self) -> bool {
        self.program.is_analytic
    }

    /// f at each point; NaN where it is not defined.
    #[must_use]
    pub fn eval(&self, points: &[Complex64]) -> Vec<Complex64> {
        let mut values = Vec::with_capacity(points.len());
        run::run::<0>(&self.program, &self.fixed, points, |_, [value, ..]| {
            values.push(if value.is_finite() { value } else { Jet::UNDEFINED.value });
        });
        values
    }

    /// ∂f/∂z at each point, which is f' where the map is analytic; NaN where f is not defined.
    #[must_use]
    pub fn derivative(&self, points: &[Complex64]) -> Vec<Complex64> {
        let mut jets = vec![Jet::UNDEFINED; points.len()];
        self.jets(points, &mut jets);
        jets.into_iter().map(|jet| jet.dz).collect()
    }
}

impl PlaneMap for FormulaMap {
    fn jets(&self, points: &[Complex64], jets: &mut [Jet]) {
        let emit = |k: usize, [value, dz, dzbar]: [Complex64; 3]| {
            jets[k] = if value.is_finite() { Jet { value, dz, dzbar } } else { Jet::UNDEFINED };
        };
        if self.is_analytic() {
            run::run::<1>(&self.program, &self.fixed, points, emit);
        } else {
            run::run::<2>(&self.program, &self.fixed, points, emit);
        }
    }
}

fn check_name(name: &str, earlier: &[String]) -> Result<()> {
    use lexer::Token;
    let spelled = lexer::tokens(name)
        .is_ok_and(|tokens| matches!(&tokens[..], [word, _] if word.token == Token::Word(name.to_string())));
    let reason = if !spelled {
        "a name is letters, and digits after the first"
    } else if names::is_taken(name) {
        "it already has a meaning in formulas"
    } else if earlier.iter().any(|known| known == name) {
        "it is given twice"
    } else {
        return Ok(());
    };
    Err(Error::InvalidParameter { name: name.to_string(), reason })
}

fn check_value(name: &str, value: Complex64) -> Result<()> {
    if value.is_finite() { Ok(()) } else { Err(Error::NotFinite { what: format!("Parameter {name}") }) }
}
