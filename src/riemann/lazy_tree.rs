//! A quadtree whose squares are decided when a point of them is first asked for. What is decided depends on the square and on
//! what its parents knew, so that nothing depends on the order of questions.

use crate::Result;
use crate::error::Error;
use crate::plane::Complex64;
use crate::symm::options::Progress;
use std::sync::OnceLock;

/// A square of the plane.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    /// Its middle.
    pub center: Complex64,
    /// Half its side.
    pub half: f64,
    /// Splits below the root.
    pub level: u32,
}

/// What becomes of a square.
pub enum Decision<D, L> {
    /// This is known of it.
    Leaf(L),
    /// Its quarters are to be asked, and should know this.
    Split(D),
}

/// Decides about squares.
pub type Decide<'a, D, L> = &'a dyn Fn(&Square, &D) -> Decision<D, L>;

/// The tree: `D` is what squares know when they are decided, `L` what is known of them then.
#[derive(Debug)]
pub struct LazyTree<D, L> {
    root: Node<D, L>,
}

#[derive(Debug)]
struct Node<D, L> {
    square: Square,
    data: D,
    state: OnceLock<State<D, L>>,
}

#[derive(Debug)]
enum State<D, L> {
    Leaf(L),
    /// Lower left, lower right, upper left, upper right.
    Split(Box<[Node<D, L>; 4]>),
}

/// Squares between two reports.
const SQUARES_PER_REPORT: usize = 64;

impl<D: Clone, L> LazyTree<D, L> {
    /// Nothing decided yet.
    #[must_use]
    pub fn new(center: Complex64, half: f64, data: D) -> Self {
        Self { root: Node { square: Square { center, half, level: 0 }, data, state: OnceLock::new() } }
    }

    /// What is known of the smallest square that holds `z`; `None` outside of all and for NaN.
    #[inline]
    #[must_use]
    pub fn find(&self, z: Complex64, decide: Decide<D, L>) -> Option<&L> {
        let Square { center, half, .. } = self.root.square;
        let from = z - center;
        let holds = from.re.abs() <= half && from.im.abs() <= half;
        if !holds {
            return None;
        }
        let mut node = &self.root;
        loop {
            match node.state(decide) {
                State::Leaf(leaf) => return Some(leaf),
                State::Split(quarters) => {
                    let middle = node.square.center;
                    node = &quarters[2 * usize::from(z.im >= middle.im) + usize::from(z.re >= middle.re)];
                }
            }
        }
    }

    /// Decides all squares.
    ///
    /// # Errors
    /// [`Error::Cancelled`]; what was decided by then is kept.
    pub fn fill(&self, stage: &'static str, decide: Decide<D, L>, progress: Progress) -> Result<()> {
        let (mut open, mut seen, mut done) = (vec![&self.root], 0_usize, 0.0);
        while let Some(node) = open.pop() {
            if seen.is_multiple_of(SQUARES_PER_REPORT) && !progress(stage, done) {
                return Err(Error::Cancelled);
            }
            seen += 1;
            match node.state(decide) {
                State::Leaf(_) => done += 0.25f64.powi(node.square.level as i32),
                State::Split(quarters) => open.extend(quarters.iter()),
            }
        }
        Ok(())
    }
}

impl<D: Clone, L> Node<D, L> {
    #[inline]
    fn state(&self, decide: Decide<D, L>) -> &State<D, L> {
        self.state.get_or_init(|| match decide(&self.square, &self.data) {
            Decision::Leaf(leaf) => State::Leaf(leaf),
            Decision::Split(data) => {
                let Square { center, half, level } = self.square;
                let half = 0.5 * half;
                let quarter = |x: f64, y: f64| {
                    let square = Square { center: center + Complex64::new(x * half, y * half), half, level: level + 1 };
                    Node { square, data: data.clone(), state: OnceLock::new() }
                };
                State::Split(Box::new([quarter(-1.0, -1.0), quarter(1.0, -1.0), quarter(-1.0, 1.0), quarter(1.0, 1.0)]))
            }
        })
    }
}
