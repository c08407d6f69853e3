//! Complex functions of a complex variable, each with its derivative.
//!
//! `num_complex` has most of them, but by their textbook formulas, which lose every digit where a picture has interesting
//! places (`log` near 1, `asin` far out, `tanh` past 355 is NaN) and give no derivative. Here they follow W. Kahan,
//! *Branch cuts for complex elementary functions* (1987): a few units in the last place of the result's modulus.
//!
//! # Branches
//! Principal values and cuts are those of C99 and mpmath:
//!
//! | function | cut | function | cut |
//! |---|---|---|---|
//! | log, sqrt, z^a | (−∞, 0] | asin, acos, atanh | (−∞, −1], [1, ∞) |
//! | acosh | (−∞, 1] | asinh, atan | (−i∞, −i], [i, i∞) |
//! | W₀ | (−∞, −1/e] | other W | (−∞, 0] |
//!
//! On a cut the value is C99's for positive zeros. The sign of a zero is ignored, so that `sqrt(-1)` and
//! `sqrt(-(1))` are both i.

mod arithmetic;
mod bessel;
mod circular;
mod erf;
mod exponential;
mod gamma;
mod inverse;
mod jacobi;
mod lambert;
mod power;
mod reciprocal;
mod weierstrass;
mod zeta;

pub use arithmetic::{UNDEFINED, ValueAndSlope, divide};
pub use bessel::{LARGEST_ORDER, bessel_j};
pub use circular::{cos, cosh, floor, sin, sinc, sinh, tan, tanh};
pub use erf::{erf, erfc};
pub use exponential::{cis_pi, exp, log, sqrt};
pub use gamma::gamma;
pub use inverse::{acos, acosh, asin, asinh, atan, atanh};
pub use jacobi::{Jacobi, Modulus};
pub use lambert::lambert_w;
pub use power::{LARGEST_MULTIPLIED_EXPONENT, pow, pow_with_slope};
pub use reciprocal::{acot, acoth, acsc, acsch, asec, asech, cot, coth, csc, csch, sec, sech};
pub use weierstrass::Lattice;
pub use zeta::zeta;
