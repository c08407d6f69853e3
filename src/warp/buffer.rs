//! Bytes of pixels: how many there must be, and room for them.

use crate::{Error, Result};

/// Whether `bytes` are RGBA pixels in so many columns and rows; `what` names them.
///
/// # Errors
/// [`Error::WrongLength`] unless there are 4 · columns · rows.
pub(crate) fn check(what: &'static str, bytes: usize, [columns, rows]: [usize; 2]) -> Result<()> {
    if columns.checked_mul(rows).and_then(|pixels| pixels.checked_mul(4)) == Some(bytes) {
        return Ok(());
    }
    Err(Error::WrongLength { what, expected: format!("4 x {columns} x {rows}"), found: bytes })
}

/// Bytes of RGBA pixels in so many columns and rows.
///
/// # Errors
/// [`Error::OutOfMemory`] for more than can be counted.
pub(crate) fn len([columns, rows]: [usize; 2]) -> Result<usize> {
    let bytes = (columns as u64).saturating_mul(rows as u64).saturating_mul(4);
    isize::try_from(bytes).map(isize::unsigned_abs).map_err(|_| Error::OutOfMemory { bytes })
}

/// Transparent RGBA pixels in so many columns and rows.
///
/// # Errors
/// [`Error::OutOfMemory`].
pub(crate) fn blank(size: [usize; 2]) -> Result<Vec<u8>> {
    let bytes = len(size)?;
    let mut rgba = Vec::new();
    rgba.try_reserve_exact(bytes).map_err(|_| Error::OutOfMemory { bytes: bytes as u64 })?;
    rgba.resize(bytes, 0);
    Ok(rgba)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_counted_or_held_is_refused_with_its_size() {
        // 65536 × 16385 × 4 is 262144 modulo 2³².
        assert_eq!(check("The overlay", 262_144, [65_536, 16_385]).unwrap_err().code(), "wrong-length");
        assert_eq!(blank([1 << 30, 1 << 30]), Err(Error::OutOfMemory { bytes: 1 << 62 }));
        assert_eq!(blank([1 << 31, 1 << 31]), Err(Error::OutOfMemory { bytes: u64::MAX }));
    }
}
