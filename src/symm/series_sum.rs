//! The sums of [`super::local_series`]: what one piece of a panel, or one cluster of panels, adds to a power series.

use super::clusters::Cluster;
use super::fast_log::half_ln;
use super::legendre::{GaussRule, MAX_NODES};
use super::multipole::binomials;
use crate::plane::Complex64;
use std::f64::consts::TAU;

/// A power series in a disk under construction, while the boundary is walked.
pub struct Sum<'a> {
    /// The disk's center.
    pub center: Complex64,
    /// Its radius.
    pub radius: f64,
    /// Coefficients of ((z − center)/radius)ᵏ.
    pub coefficients: &'a mut [Complex64],
    /// Argument of center − y at the end of the boundary walked so far.
    pub argument: f64,
}

/// A straight piece of the boundary.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// Its middle.
    pub middle: Complex64,
    /// The vector from there to its end.
    pub half: Complex64,
}

/// This many times the disk's radius: pieces that are far from a disk of nine tenths of the distance to the boundary are longer.
const SHORTEST_IN_DISK: f64 = 0.01;

impl Sum<'_> {
    /// Goes on along the boundary to `end`.
    pub fn walk_to(&mut self, end: Complex64) {
        self.argument = nearest_turn((self.center - end).arg(), self.argument);
    }

    /// Whether half the piece is at most `share` of its distance from the disk.
    #[must_use]
    pub fn is_far(&self, piece: Piece, share: f64) -> bool {
        piece.half.norm_sqr().sqrt() <= share * ((self.center - piece.middle).norm_sqr().sqrt() - self.radius)
    }

    /// Whether the piece is so short that only a disk which crosses the boundary would ask for less.
    #[must_use]
    pub fn need_not_halve(&self, piece: Piece) -> bool {
        piece.half.norm_sqr().sqrt() <= SHORTEST_IN_DISK * self.radius
    }

    /// Adds the field of masses at the nodes of a piece.
    pub fn add_nodes(&mut self, piece: Piece, gauss: &GaussRule, masses: &[f64]) {
        let m = masses.len();
        let middle = self.center - piece.middle;
        let inverse = middle.inv();
        let q = piece.half * inverse;
        let unit = inverse * self.radius;
        let (mut logs, mut angles) = ([1.0; MAX_NODES], [0.0; MAX_NODES]);
        let (mut ure, mut uim) = ([0.0; MAX_NODES], [0.0; MAX_NODES]);
        for j in 0..m {
            // center − y over center − middle.
            let (re, im) = (1.0 - gauss.nodes[j] * q.re, -gauss.nodes[j] * q.im);
            logs[j] = re * re + im * im;
            angles[j] = small_atan(im / re);
            let scale = 1.0 / logs[j];
            ure[j] = (unit.re * re + unit.im * im) * scale;
            uim[j] = (unit.im * re - unit.re * im) * scale;
        }
        half_ln(&mut logs[..m]);
        let total: f64 = masses.iter().sum();
        let log = Complex64::new(0.5 * middle.norm_sqr().ln(), nearest_turn(middle.arg(), self.argument));
        let mut constant = log * total;
        for j in 0..m {
            constant += Complex64::new(logs[j], angles[j]) * masses[j];
        }
        self.coefficients[0] += constant;
        let (mut pre, mut pim) = ([0.0; MAX_NODES], [0.0; MAX_NODES]);
        pre[..m].copy_from_slice(masses);
        let lanes = m.next_multiple_of(LANES);
        for coefficient in &mut self.coefficients[1..] {
            // Several sums side by side, which the compiler keeps in vectors.
            let (mut re, mut im) = ([0.0; LANES], [0.0; LANES]);
            for j in (0..lanes).step_by(LANES) {
                for i in 0..LANES {
                    let (a, b) = (pre[j + i], pim[j + i]);
                    let (c, d) = (ure[j + i], uim[j + i]);
                    pre[j + i] = a * c - b * d;
                    pim[j + i] = a * d + b * c;
                    re[i] += pre[j + i];
                    im[i] += pim[j + i];
                }
            }
            *coefficient += Complex64::new(re.iter().sum(), im.iter().sum());
        }
    }

    /// Adds the field of a far cluster. `factors` are those of [`expansion_factors`].
    pub fn add_multipole(&mut self, cluster: &Cluster, multipole: &[Complex64], factors: &[f64]) {
        let apart = self.center - cluster.center;
        let inverse = apart.inv();
        let (near, unit) = (inverse * cluster.radius, inverse * self.radius);
        let (mut re, mut im) = ([0.0; MAX_TERMS], [0.0; MAX_TERMS]);
        let charge = multipole[0].re;
        let log = Complex64::new(0.5 * apart.norm_sqr().ln(), nearest_turn(apart.arg(), self.argument));
        let mut constant = log * charge;
        let mut power = Complex64::ONE;
        for (k, a) in multipole[1..].iter().enumerate() {
            power *= near;
            let u = a * power;
            constant += u;
            (re[k], im[k]) = (u.re, u.im);
        }
        self.coefficients[0] += constant;
        // A few more than are wanted, so that they fill vectors.
        let orders = (self.coefficients.len() - 1).next_multiple_of(LANES);
        let (mut sum_re, mut sum_im) = ([0.0; MAX_COEFFICIENTS], [0.0; MAX_COEFFICIENTS]);
        let (sum_re, sum_im) = (&mut sum_re[..orders], &mut sum_im[..orders]);
        for (k, row) in factors.chunks_exact(MAX_COEFFICIENTS).take(multipole.len() - 1).enumerate() {
            let (re, im) = (re[k], im[k]);
            for ((sum_re, sum_im), factor) in sum_re.iter_mut().zip(&mut *sum_im).zip(&row[..orders]) {
                *sum_re += factor * re;
                *sum_im += factor * im;
            }
        }
        let mut power = Complex64::ONE;
        for (l, coefficient) in self.coefficients[1..].iter_mut().enumerate() {
            power *= unit;
            *coefficient += power * (charge - Complex64::new(sum_re[l], sum_im[l]));
        }
    }
}

/// Numbers that are worked on side by side.
const LANES: usize = 4;
/// More terms of a multipole expansion than 16 digits need.
pub const MAX_TERMS: usize = 48;
/// More coefficients than anybody asks for.
pub const MAX_COEFFICIENTS: usize = 40;

/// Row k − 1, column l − 1: l·C(k+l−1, l). Around a center at distance D, (z − b)^(−k) has the coefficients
/// (−1)ˡ C(k+l−1, l)/D^(k+l).
#[must_use]
pub fn expansion_factors() -> Vec<f64> {
    let mut rows = binomials(MAX_TERMS, MAX_COEFFICIENTS + 1);
    rows.iter_mut().enumerate().for_each(|(index, choose)| *choose *= (index % (MAX_COEFFICIENTS + 1)) as f64);
    rows.chunks_exact(MAX_COEFFICIENTS + 1).flat_map(|row| &row[1..]).copied().collect()
}

/// `angle` plus the multiple of 2π that brings it closest to `to`.
fn nearest_turn(angle: f64, to: f64) -> f64 {
    angle + TAU * ((to - angle) / TAU).round()
}

/// atan x for |x| ≤ 7/16, branch-free (fdlibm's s_atan.c).
fn small_atan(x: f64) -> f64 {
    const SERIES: [f64; 11] = [
        3.333_333_333_333_293_18e-1,
        -1.999_999_999_987_648_32e-1,
        1.428_571_427_250_346_64e-1,
        -1.111_111_040_546_235_58e-1,
        9.090_887_133_436_507e-2,
        -7.691_876_205_044_83e-2,
        6.661_073_137_387_531e-2,
        -5.833_570_133_790_573_5e-2,
        4.976_877_994_615_932e-2,
        -3.653_157_274_421_691_6e-2,
        1.628_582_011_536_578_2e-2,
    ];
    let z = x * x;
    x - x * z * SERIES.iter().rev().fold(0.0, |sum, c| sum * z + c)
}
