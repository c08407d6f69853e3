//! Complex numbers ↔ `Float64Array`: two consecutive numbers each, `[x0, y0, x1, y1, …]`.

use crate::plane::Complex64;
use crate::{Error, Result};
use js_sys::Array;

/// Consecutive pairs → complex numbers.
///
/// # Errors
/// [`Error::WrongLength`] for an odd count, naming the array `what`.
pub fn from_flat(what: &'static str, flat: &[f64]) -> Result<Vec<Complex64>> {
    let (pairs, rest) = flat.as_chunks::<2>();
    if !rest.is_empty() {
        let expected = "an even count of".to_string();
        return Err(Error::WrongLength { what, expected, found: flat.len() });
    }
    Ok(pairs.iter().map(|&[x, y]| Complex64::new(x, y)).collect())
}

/// Consecutive triples → triangles.
///
/// # Errors
/// [`Error::WrongLength`] for a count that is not a multiple of 3, naming the array `what`.
pub fn triples_from_flat(what: &'static str, flat: &[u32]) -> Result<Vec<[u32; 3]>> {
    match flat.as_chunks::<3>() {
        (triples, []) => Ok(triples.to_vec()),
        _ => Err(Error::WrongLength { what, expected: "three times as many".to_string(), found: flat.len() }),
    }
}

/// What `map` makes of consecutive pairs.
///
/// # Errors
/// [`Error::WrongLength`] for an odd count.
pub fn mapped(flat: &[f64], map: impl FnOnce(&[Complex64]) -> Vec<Complex64>) -> Result<Vec<f64>> {
    Ok(to_flat(&map(&from_flat("The points", flat)?)))
}

/// Complex numbers → consecutive pairs.
#[must_use]
pub fn to_flat(points: &[Complex64]) -> Vec<f64> {
    points.iter().flat_map(|z| [z.re, z.im]).collect()
}

/// A complex number → `[x, y]`.
#[must_use]
pub fn pair(z: Complex64) -> Array {
    Array::of2(&z.re.into(), &z.im.into())
}
