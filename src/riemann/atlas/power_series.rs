//! Truncated power series.

use crate::plane::Complex64;

/// More coefficients than any cell has.
pub const MAX_COEFFICIENTS: usize = 32;

/// Σ cₖ tᵏ.
#[inline]
#[must_use]
pub fn value(coefficients: &[Complex64], t: Complex64) -> Complex64 {
    coefficients.iter().rev().fold(Complex64::ZERO, |sum, c| sum * t + c)
}

/// Σ cₖ tᵏ and Σ k cₖ tᵏ⁻¹.
#[inline]
#[must_use]
pub fn value_and_slope(coefficients: &[Complex64], t: Complex64) -> (Complex64, Complex64) {
    coefficients.iter().rev().fold((Complex64::ZERO, Complex64::ZERO), |(sum, slope), c| (sum * t + c, slope * t + sum))
}

/// Σ cₖ ((z − center)/radius)ᵏ.
#[derive(Clone, Debug)]
pub struct Series {
    /// The middle of the circle in which it serves,
    pub center: Complex64,
    /// and its radius.
    pub radius: f64,
    /// The cₖ.
    pub coefficients: Box<[Complex64]>,
}

impl Series {
    /// The value and its derivative.
    #[inline]
    #[must_use]
    pub fn at(&self, z: Complex64) -> (Complex64, Complex64) {
        let (value, slope) = value_and_slope(&self.coefficients, (z - self.center) / self.radius);
        (value, slope / self.radius)
    }
}

/// Σ cₖ tᵏ⁺¹ for real coefficients. The imaginary part keeps its relative accuracy beside the real axis: it is Im t times
/// a sum (Goertzel's recurrence).
#[inline]
#[must_use]
pub fn real_value(coefficients: &[f64], t: Complex64) -> Complex64 {
    let (twice, square) = (2.0 * t.re, t.norm_sqr());
    let (mut here, mut above) = (0.0, 0.0);
    for c in coefficients.iter().rev() {
        (here, above) = (c + twice * here - square * above, here);
    }
    t * here - square * above
}

/// Σ cₖ tᵏ⁺¹ and its derivative, for real coefficients.
#[inline]
#[must_use]
pub fn real_value_and_slope(coefficients: &[f64], t: Complex64) -> (Complex64, Complex64) {
    let start = (Complex64::ZERO, Complex64::ZERO);
    let (sum, slope) = coefficients.iter().rev().fold(start, |(sum, slope), c| (sum * t + c, slope * t + sum));
    (sum * t, slope * t + sum)
}

/// Replaces the series in t by one in t/`factor`.
pub fn rescale(coefficients: &mut [Complex64], factor: f64) {
    let mut power = 1.0;
    for c in coefficients {
        *c *= power;
        power *= factor;
    }
}

/// Replaces the series a by exp(a − a₀).
pub fn exp_without_constant(a: &[Complex64], result: &mut [Complex64]) {
    result[0] = Complex64::ONE;
    for k in 1..a.len() {
        let sum: Complex64 = (1..=k).map(|j| a[j] * result[k - j] * j as f64).sum();
        result[k] = sum / k as f64;
    }
}

/// The inverse of y = Σ cₖ xᵏ⁺¹ near 0, as coefficients of y, y², …: as many as c has. By Lagrange's formula
/// k·bₖ = [xᵏ⁻¹] (x/y)ᵏ.
pub fn revert(c: &[Complex64], inverse: &mut [Complex64]) {
    let n = c.len();
    let scale = c[0].inv();
    // h = x/y.
    let mut h = [Complex64::ZERO; MAX_COEFFICIENTS];
    h[0] = scale;
    for k in 1..n {
        let sum: Complex64 = (1..=k).map(|j| c[j] * h[k - j]).sum();
        h[k] = -sum * scale;
    }
    let mut power = h;
    for k in 1..=n {
        inverse[k - 1] = power[k - 1] / k as f64;
        // Times h, from the highest coefficient down.
        for l in (0..n).rev() {
            power[l] = (0..=l).map(|j| power[j] * h[l - j]).sum();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn real_series_agree_with_complex_ones() {
        let real = [0.5, -1.25, 0.75, 2.0, -0.1];
        let complex: Vec<Complex64> = std::iter::once(0.0).chain(real).map(|c| Complex64::new(c, 0.0)).collect();
        for t in [Complex64::new(0.3, 0.8), Complex64::new(-0.9, 1e-12), Complex64::new(1.0, 0.0)] {
            let (exact, slope) = value_and_slope(&complex, t);
            let (sum, real_slope) = real_value_and_slope(&real, t);
            assert!((real_value(&real, t) - exact).norm() < 1e-14 && (sum - exact).norm() < 1e-14);
            assert!((real_slope - slope).norm() < 1e-14);
            assert!((value(&complex, t) - exact).norm() < 1e-14);
        }
        let beside = real_value(&real, Complex64::new(0.5, 1e-13));
        assert!((beside.im / 1e-13 / real_value_and_slope(&real, Complex64::new(0.5, 0.0)).1.re - 1.0).abs() < 1e-13);
    }

    #[test]
    fn exponential_and_inverse() {
        // exp(log(1 + t)) = 1 + t.
        let log: Vec<Complex64> =
            (0..9).map(|k| Complex64::new(if k == 0 { 7.0 } else { -(-1f64).powi(k) / f64::from(k) }, 0.0)).collect();
        let mut exp = vec![Complex64::ZERO; 9];
        exp_without_constant(&log, &mut exp);
        for (k, e) in exp.iter().enumerate() {
            assert!((e - if k < 2 { 1.0 } else { 0.0 }).norm() < 1e-15, "{k}: {e}");
        }
        // y = x/(1−x) has the inverse y/(1+y).
        let mut inverse = [Complex64::ZERO; 6];
        revert(&[Complex64::ONE; 6], &mut inverse);
        assert_eq!(inverse.map(|b| b.re), [1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
        // y = 2i (e^x − 1) has the inverse log(1 − iy/2).
        let mut factorial = 1.0;
        let c: Vec<Complex64> = (1..20)
            .map(|k| {
                factorial *= f64::from(k);
                Complex64::new(0.0, 2.0 / factorial)
            })
            .collect();
        let mut inverse = [Complex64::ZERO; 19];
        revert(&c, &mut inverse);
        for (k, b) in (1..).zip(inverse) {
            let exact = -Complex64::new(0.0, 0.5).powi(k) / f64::from(k);
            assert!((b - exact).norm() < 1e-13 * exact.norm(), "{k}: {b} {exact}");
        }
    }
}
