//! The area that overlapping sheets cover together, along one row of pixels.

/// Lines across a row on which outlines are cut: between them, what is covered hardly changes.
const LINES: usize = 16;

use crate::plane::sort_by_number;

/// The part of an outline's edge that lies in a row of pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgePiece {
    pub row: usize,
    /// Heights at which it begins and ends, 0 at the row's top and 1 at its bottom.
    pub heights: [f64; 2],
    /// Columns there.
    pub columns: [f64; 2],
    /// +1 or −1: by how many it changes the number of sheets.
    pub sheets: i32,
}

impl EdgePiece {
    /// Where it crosses a height, if it does: half-open, so that a vertex counts once.
    fn crossing(&self, height: f64) -> Option<(f64, i32)> {
        let ([top, bottom], [start, end]) = (self.heights, self.columns);
        let share = (height - top) / (bottom - top);
        (top <= height && height < bottom).then_some((start + share * (end - start), self.sheets))
    }
}

/// What is covered by any sheet, for a row of `width` pixels: the share of those cells in which sheets overlap, and `None` for
/// all others.
pub(super) fn shares(pieces: &[EdgePiece], width: usize) -> Vec<Option<f32>> {
    let mut cells = vec![0.0; width + 2];
    let mut shared = vec![false; width];
    let mut crossings: Vec<(f64, i32)> = Vec::new();
    for line in 0..LINES {
        let height = (line as f64 + 0.5) / LINES as f64;
        crossings.clear();
        crossings.extend(pieces.iter().filter_map(|piece| piece.crossing(height)));
        sort_by_number(&mut crossings, |crossing| crossing.0);
        let (mut sheets, mut last) = (0_i32, 0.0);
        for &(x, change) in &crossings {
            let before = sheets;
            sheets += change;
            if before.abs() > 1 {
                let cell = |x: f64| x.clamp(0.0, width as f64) as usize;
                shared[cell(last)..cell(x.ceil())].fill(true);
            }
            last = x;
            if (before == 0) != (sheets == 0) {
                let sign = if before == 0 { 1.0 } else { -1.0 };
                add_upright(&mut cells, x, sign / LINES as f64);
            }
        }
    }
    let sums = cells.iter().scan(0.0_f32, |sum, cell| {
        *sum += cell;
        Some(*sum)
    });
    shared.into_iter().zip(sums).map(|(shared, sum)| shared.then_some(sum)).collect()
}

/// Adds an upright edge at column x, `height` high, to a row of cells: to its own cell the part on its right, to the next
/// one the rest, and so to the running sum of all further ones.
pub(super) fn add_upright(cells: &mut [f32], x: f64, height: f64) {
    let x = x.max(0.0);
    let cell = x as usize;
    if cell + 2 < cells.len() {
        let inside = x.floor() + 1.0 - x;
        cells[cell] += (height * inside) as f32;
        cells[cell + 1] += (height * (1.0 - inside)) as f32;
    }
}
