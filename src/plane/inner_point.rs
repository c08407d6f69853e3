//! A point well inside a closed curve.

use super::Complex64;

/// The point with the largest signed distance, positive inside, among those of a grid in the box around the curve, and of others.
pub fn inner_point(
    (low, high): (Complex64, Complex64),
    others: &[Complex64],
    signed_distance: &dyn Fn(Complex64) -> f64,
) -> Complex64 {
    const STEPS: u32 = 12;
    let size = high - low;
    let share = |k: u32| (f64::from(k) + 0.5) / f64::from(STEPS);
    let grid = (0..STEPS * STEPS).map(|k| low + Complex64::new(size.re * share(k % STEPS), size.im * share(k / STEPS)));
    let middle = 0.5 * (low + high);
    grid.chain([middle])
        .chain(others.iter().copied())
        .map(|z| (z, signed_distance(z)))
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(middle, |(z, _)| z)
}
