//! Values at a block of points, as separate rows of real and imaginary parts, so that loops over points vectorise.

use crate::plane::Complex64;

/// A value and, after it, its derivatives (∂/∂z, then ∂/∂z̄) at a block of points.
pub struct Lanes {
    width: usize,
    numbers: Vec<f64>,
}

/// One complex number a point.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    re: &'a [f64],
    im: &'a [f64],
}

impl Lanes {
    /// Zeros: `rows` complex numbers at each of `width` points.
    pub fn new(width: usize, rows: usize) -> Self {
        Self { width, numbers: vec![0.0; 2 * width * rows] }
    }

    /// Number of points.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The value (row 0) or a derivative.
    #[inline(always)]
    pub fn row(&self, index: usize) -> Row<'_> {
        let start = 2 * index * self.width;
        let (re, im) = self.numbers[start..start + 2 * self.width].split_at(self.width);
        Row { re, im }
    }

    #[inline(always)]
    fn row_mut(&mut self, index: usize) -> (&mut [f64], &mut [f64]) {
        let start = 2 * index * self.width;
        self.numbers[start..start + 2 * self.width].split_at_mut(self.width)
    }

    /// row[k] = value.
    #[inline(always)]
    pub fn set(&mut self, index: usize, k: usize, value: Complex64) {
        let (re, im) = self.row_mut(index);
        (re[k], im[k]) = (value.re, value.im);
    }

    /// row[k] = f(k).
    #[inline(always)]
    pub fn fill(&mut self, index: usize, f: impl Fn(usize) -> Complex64) {
        let (re, im) = self.row_mut(index);
        for (k, (re, im)) in re.iter_mut().zip(im).enumerate() {
            let value = f(k);
            (*re, *im) = (value.re, value.im);
        }
    }

    /// row[k] = f(a[k]).
    pub fn map(&mut self, index: usize, a: Row, f: impl Fn(Complex64) -> Complex64) {
        let a = a.trimmed(self.width);
        self.fill(index, |k| f(a.at(k)));
    }

    /// row[k] = f(a[k], b[k]).
    pub fn map2(&mut self, index: usize, a: Row, b: Row, f: impl Fn(Complex64, Complex64) -> Complex64) {
        let (a, b) = (a.trimmed(self.width), b.trimmed(self.width));
        self.fill(index, |k| f(a.at(k), b.at(k)));
    }

    /// row[k] = a[k]·b[k] + c[k]·d[k]: a product's derivative.
    pub fn products(&mut self, index: usize, [a, b, c, d]: [Row; 4]) {
        let [a, b, c, d] = [a, b, c, d].map(|row| row.trimmed(self.width));
        self.fill(index, |k| a.at(k) * b.at(k) + c.at(k) * d.at(k));
    }
}

impl<'a> Row<'a> {
    /// The number at point k.
    #[inline(always)]
    pub fn at(self, k: usize) -> Complex64 {
        Complex64::new(self.re[k], self.im[k])
    }

    /// The first `width` points: tells the compiler the length once, outside the loop.
    #[inline(always)]
    fn trimmed(self, width: usize) -> Self {
        Self { re: &self.re[..width], im: &self.im[..width] }
    }
}
