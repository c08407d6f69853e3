//! Many points over many threads.

use crate::plane::Complex64;
use rayon::prelude::*;

/// Points that a thread takes at a time: enough work to be worth handing on, little enough to share out evenly.
const PIECE: usize = 1024;

/// What `f` gives for pieces of the points, worked on by all threads of rayon's current pool and joined in order.
///
/// `f` is a method of a map for many points, or made of such: as what they say of a point depends on nothing but the point, the
/// answer is the same, to the bit, as that of one call with all points.
///
/// ```
/// use conformal_warp::{Complex64, Curve, FormulaMap, Jet, PlaneMap, Region, RiemannMap, SolveOptions, par_points};
/// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Complex64::new(x, y));
/// let region = Region::new(&square, Curve::Polygon, Complex64::ZERO, square[0])?;
/// let map = RiemannMap::solve(&region, &SolveOptions::default(), &mut |_, _| true)?;
/// let points: Vec<_> = (0..5000).map(|k| Complex64::new(f64::from(k) / 5000.0, 0.3)).collect();
/// assert_eq!(par_points(&points, |z| map.to_disk(z)), map.to_disk(&points));
///
/// let formula = FormulaMap::new("z^2 + 1")?;
/// let jets = par_points(&points, |z| {
///     let mut jets = vec![Jet::UNDEFINED; z.len()];
///     formula.jets(z, &mut jets);
///     jets
/// });
/// assert_eq!(jets[0].value, Complex64::new(0.91, 0.0));
/// # Ok::<(), conformal_warp::Error>(())
/// ```
pub fn par_points<T: Send>(points: &[Complex64], f: impl Fn(&[Complex64]) -> Vec<T> + Sync) -> Vec<T> {
    let pieces: Vec<Vec<T>> = points.par_chunks(PIECE).map(&f).collect();
    pieces.into_iter().flatten().collect()
}
