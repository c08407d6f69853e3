//! The levels of a mip pyramid: each half as wide and high as the one before, averaged exactly over texel areas.

use super::light::Tables;
use super::options::Wrap;
use super::texel::{ByteTexel, LightTexel, decoded, encoded};

/// One level: where its texels lie in the pyramid's single array.
///
/// Every level has a border of one texel on each side, filled as the wrap mode says, so that a sampler may read the
/// two neighbours of any point of the level without asking where it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Level {
    /// Index of its first texel, the border's top left corner.
    pub offset: usize,
    /// Texels from one row to the next: at least `width` + 2.
    pub stride: usize,
    /// Columns without the border.
    pub width: usize,
    /// Rows without the border.
    pub height: usize,
    /// Texels of this level per texel of level 0, across and down: ½, ¼, … up to the rounding of odd sizes.
    pub scale: [f32; 2],
}

impl Level {
    /// Index of texel (column, row), the border's included: (0, 0) is its corner, (1, 1) the first inner texel.
    fn index(&self, column: usize, row: usize) -> usize {
        self.offset + row * self.stride + column
    }

    /// Texels with the border.
    fn area(&self) -> usize {
        self.stride * (self.height + 2)
    }

    /// Where the inner texels of a row lie.
    pub fn row(&self, row: usize) -> std::ops::Range<usize> {
        let start = self.index(1, row + 1);
        start..start + self.width
    }
}

/// The levels from `width` × `height` down to 1 × 1.
pub(crate) fn levels(width: usize, height: usize) -> Vec<Level> {
    let mut levels: Vec<Level> = Vec::new();
    let (mut w, mut h) = (width, height);
    loop {
        let offset = levels.last().map_or(0, |last| last.offset + last.area());
        let scale = [w as f32 / width as f32, h as f32 / height as f32];
        levels.push(Level { offset, stride: stride(w + 2), width: w, height: h, scale });
        if w == 1 && h == 1 {
            return levels;
        }
        (w, h) = ((w / 2).max(1), (h / 2).max(1));
    }
}

/// Texels from one row to the next: an odd number of cache lines, so that a column of the picture is spread over the whole
/// first-level cache. (Rows of 1024 + 2 texels of four bytes would meet in an eighth of it.)
fn stride(texels: usize) -> usize {
    /// Texels of four bytes in a cache line.
    const LINE: usize = 16;
    LINE * (texels.div_ceil(LINE) | 1)
}

/// Texels that the levels need together.
pub(crate) fn total(levels: &[Level]) -> usize {
    levels.iter().map(Level::area).sum()
}

/// Fills every level but the first from the first one, and the borders of all.
pub(super) fn build(texels: &mut [ByteTexel], levels: &[Level], wrap: Wrap, tables: &Tables) {
    if let [first, second, ..] = levels {
        let (fine, coarse) = texels.split_at_mut(second.offset);
        let decode = |row: usize, line: &mut [LightTexel]| {
            line.iter_mut().zip(&fine[first.row(row)]).for_each(|(light, &bytes)| *light = decoded(bytes, tables));
        };
        each_coarser(levels, decode, |level, row, line| {
            let range = level.row(row);
            let target = &mut coarse[range.start - second.offset..range.end - second.offset];
            target.iter_mut().zip(line).for_each(|(bytes, &light)| *bytes = encoded(light, tables));
        });
    }
    levels.iter().for_each(|level| fill_border(texels, level, wrap));
}

/// The whole pyramid as light: exactly averaged, where the levels of bytes are rounded. `texels` has room for all.
pub(super) fn build_light(
    texels: &mut [LightTexel],
    levels: &[Level],
    bytes: &[ByteTexel],
    wrap: Wrap,
    tables: &Tables,
) {
    let decode = |row: usize, line: &mut [LightTexel]| {
        line.iter_mut().zip(&bytes[levels[0].row(row)]).for_each(|(light, &bytes)| *light = decoded(bytes, tables));
    };
    (0..levels[0].height).for_each(|row| decode(row, &mut texels[levels[0].row(row)]));
    each_coarser(levels, decode, |level, row, line| texels[level.row(row)].copy_from_slice(line));
    levels.iter().for_each(|level| fill_border(texels, level, wrap));
}

/// Averages each level from the one above it: `first` reads a row of the first, `emit` receives every row of the others.
/// No level is held on the way, but for the last rows of each.
fn each_coarser(
    levels: &[Level],
    first: impl Fn(usize, &mut [LightTexel]),
    mut emit: impl FnMut(&Level, usize, &[LightTexel]),
) {
    let mut stages: Vec<Stage> = levels.windows(2).map(|pair| Stage::new(&pair[0], &pair[1])).collect();
    let mut line = vec![[0; 4]; levels[0].width];
    for row in 0..levels[0].height {
        first(row, &mut line);
        pass_on(&mut stages, &line, &mut emit);
    }
}

/// Hands a row of a level to the stages below it, as far as it completes rows of theirs.
fn pass_on(stages: &mut [Stage], line: &[LightTexel], emit: &mut impl FnMut(&Level, usize, &[LightTexel])) {
    let Some((stage, rest)) = stages.split_first_mut() else { return };
    stage.receive(line);
    while stage.is_complete() {
        stage.average();
        emit(stage.level, stage.made, &stage.line);
        stage.made += 1;
        pass_on(rest, &stage.line, emit);
    }
}

/// The making of a level, row by row.
struct Stage<'a> {
    level: &'a Level,
    columns: Halving,
    rows: Halving,
    /// The last rows of the level above, at their numbers modulo 3: a row is made of three at most.
    above: [Vec<LightTexel>; 3],
    received: usize,
    made: usize,
    line: Vec<LightTexel>,
    /// Sums over rows, for sizes that are odd.
    sums: Vec<[f32; 4]>,
}

impl<'a> Stage<'a> {
    fn new(fine: &Level, level: &'a Level) -> Self {
        Self {
            level,
            columns: Halving::new(fine.width),
            rows: Halving::new(fine.height),
            above: std::array::from_fn(|_| vec![[0; 4]; fine.width]),
            received: 0,
            made: 0,
            line: vec![[0; 4]; level.width],
            sums: vec![[0.0; 4]; fine.width],
        }
    }

    fn receive(&mut self, line: &[LightTexel]) {
        self.above[self.received % 3].copy_from_slice(line);
        self.received += 1;
    }

    /// Whether all rows are there of which the next one is made.
    fn is_complete(&self) -> bool {
        self.made < self.rows.m && self.rows.taps(self.made).all(|(row, _)| row < self.received)
    }

    fn average(&mut self) {
        if self.columns.n.is_multiple_of(2) && self.rows.n.is_multiple_of(2) {
            self.average_evenly();
        } else {
            self.average_by_weights();
        }
    }

    /// [`Stage::average`] for even sizes: each texel is the mean of four.
    fn average_evenly(&mut self) {
        let [upper, lower] = [2 * self.made, 2 * self.made + 1].map(|row| &self.above[row % 3]);
        let pairs = upper.as_chunks::<2>().0.iter().zip(lower.as_chunks::<2>().0);
        for (texel, ([a, b], [c, d])) in self.line.iter_mut().zip(pairs) {
            let sum = |channel: usize| [a, b, c, d].into_iter().map(|tap| i32::from(tap[channel])).sum::<i32>();
            *texel = [0, 1, 2, 3].map(|channel| ((sum(channel) + 2) >> 2) as i16);
        }
    }

    /// [`Stage::average`] for any sizes: rows first, into a line of sums, then columns.
    fn average_by_weights(&mut self) {
        self.sums.fill([0.0; 4]);
        for (source, weight) in self.rows.taps(self.made) {
            for (sum, texel) in self.sums.iter_mut().zip(&self.above[source % 3]) {
                for channel in 0..4 {
                    sum[channel] += weight * f32::from(texel[channel]);
                }
            }
        }
        for (column, texel) in self.line.iter_mut().enumerate() {
            let mut sum = [0.5_f32; 4];
            for (source, weight) in self.columns.taps(column) {
                for channel in 0..4 {
                    sum[channel] += weight * self.sums[source][channel];
                }
            }
            *texel = sum.map(|s| s as i16);
        }
    }
}

/// Halving a length of n texels to m = ⌊n/2⌋ (at least 1) by area: output texel k is the mean over [k n/m, (k+1) n/m).
struct Halving {
    n: usize,
    m: usize,
}

impl Halving {
    fn new(n: usize) -> Self {
        Self { n, m: (n / 2).max(1) }
    }

    /// The source texels of output texel `k` with their weights, whose sum is 1. An odd n = 2m + 1 has three.
    fn taps(&self, k: usize) -> impl Iterator<Item = (usize, f32)> {
        let (n, m) = (self.n as f32, self.m as f32);
        let (count, weights) = match self.n {
            1 => (1, [1.0, 0.0, 0.0]),
            even if even % 2 == 0 => (2, [0.5, 0.5, 0.0]),
            _ => (3, [(m - k as f32) / n, m / n, (k as f32 + 1.0) / n]),
        };
        (0..count).map(move |i| (2 * k + i, weights[i]))
    }
}

/// Continues a level by one texel on each side.
fn fill_border<T: Copy + Default>(texels: &mut [[T; 4]], level: &Level, wrap: Wrap) {
    let (w, h) = (level.width, level.height);
    // Mirrored, the neighbour of the first texel is that texel itself, as when clamped.
    let (before, after) = match wrap {
        Wrap::Transparent => (None, None),
        Wrap::Clamp | Wrap::Mirror => (Some([1, 1]), Some([w, h])),
        Wrap::Repeat => (Some([w, h]), Some([1, 1])),
    };
    for row in 1..=h {
        let fetch =
            |from: Option<[usize; 2]>| from.map_or([T::default(); 4], |[column, _]| texels[level.index(column, row)]);
        let (left, right) = (fetch(before), fetch(after));
        texels[level.index(0, row)] = left;
        texels[level.index(w + 1, row)] = right;
    }
    for (row, from) in [(0, before), (h + 1, after)] {
        let to = level.index(0, row);
        match from {
            None => texels[to..to + level.stride].fill([T::default(); 4]),
            Some([_, source]) => {
                let start = level.index(0, source);
                texels.copy_within(start..start + level.stride, to);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halving_weights_sum_to_one_and_cover_every_texel_evenly() {
        for n in [1, 2, 3, 4, 5, 7, 8, 15, 1411] {
            let halving = Halving::new(n);
            let mut share = vec![0.0; n];
            for k in 0..halving.m {
                let sum: f32 = halving.taps(k).map(|(_, weight)| weight).sum();
                assert!((sum - 1.0).abs() < 1e-6, "{n} -> {}", halving.m);
                halving.taps(k).for_each(|(source, weight)| share[source] += weight);
            }
            let expected = halving.m as f32 / n as f32;
            assert!(share.iter().all(|s| (s - expected).abs() < 1e-6), "{n}: {share:?}");
        }
    }

    #[test]
    fn levels_end_at_one_texel() {
        for size in [(1, 1), (1, 37), (640, 3), (8192, 8192)] {
            let levels = levels(size.0, size.1);
            let last = levels[levels.len() - 1];
            assert_eq!((last.width, last.height), (1, 1));
            assert_eq!(total(&levels), last.offset + 3 * last.stride);
        }
    }
}
