//! Maps given by formulas.

mod accuracy;
mod language;
mod random;
