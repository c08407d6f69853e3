//! Where a function along a boundary is largest.

/// Halves of an interval by golden section: the last is 1e-12 of the first.
const STEPS: usize = 60;
/// 1/φ.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Where a function that rises and then falls between two places is largest.
#[must_use]
pub fn peak(value: &dyn Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..STEPS {
        let [a, b] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        if value(a) > value(b) {
            high = b;
        } else {
            low = a;
        }
    }
    0.5 * (low + high)
}
