//! What the leaves of the trees say, as numbers.

/// Bits of a number that tell the kind.
const KIND_BITS: u32 = 3;

/// What a leaf of a tree says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Leaf {
    /// The polynomial of this cell.
    Cell(u32),
    /// The series of this patch.
    Patch(u32),
    /// Nothing is here.
    Outside,
    /// Region → disk: no expansion; sum directly for this chart.
    Sum(u32),
    /// Disk → region: ask this chart.
    Chart(u32),
    /// Disk → region: no expansion; walk from this seed.
    Walk(u32),
    /// The first chart alone tells too little apart here.
    Crowded,
}

impl From<u32> for Leaf {
    #[inline]
    fn from(number: u32) -> Self {
        let index = number >> KIND_BITS;
        match number & ((1 << KIND_BITS) - 1) {
            0 => Self::Cell(index),
            1 => Self::Patch(index),
            2 => Self::Sum(index),
            3 => Self::Chart(index),
            4 => Self::Walk(index),
            6 => Self::Crowded,
            _ => Self::Outside,
        }
    }
}

impl From<Leaf> for u32 {
    fn from(leaf: Leaf) -> Self {
        let (index, kind) = match leaf {
            Leaf::Cell(index) => (index, 0),
            Leaf::Patch(index) => (index, 1),
            Leaf::Sum(chart) => (chart, 2),
            Leaf::Chart(chart) => (chart, 3),
            Leaf::Walk(seed) => (seed, 4),
            Leaf::Outside => (0, 5),
            Leaf::Crowded => (0, 6),
        };
        index << KIND_BITS | kind
    }
}
