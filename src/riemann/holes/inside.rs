//! What squares of a domain are cut from, and what they say of a point.

use crate::plane::Complex64;

/// The square that is cut.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// Its middle.
    pub center: Complex64,
    /// Half its side.
    pub half: f64,
}

/// What squares say of a point.
pub enum Inside {
    /// (L, L').
    Log(Complex64, Complex64),
    /// (B, B').
    Whole(Complex64, Complex64),
    /// It lies on a wall, beside one, or outside.
    Unknown,
    /// It lies clearly outside of the domain.
    Outside,
    /// It lies outside of all squares.
    Beyond,
}
