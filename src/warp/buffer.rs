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

/// Transparent RGBA pixels in so many columns and rows.
pub(crate) fn blank([columns, rows]: [usize; 2]) -> Result<Vec<u8>> {
    Ok(vec![0; 4 * columns * rows])
}
