//! [`SlitShapes`](super::slit_shapes::SlitShapes) of a disk with round holes, by Laurent series around the holes.
//!
//! In the plane of u = 1/w the domain is what lies outside the unit circle and the circles |u − cⱼ| = rⱼ. With M = (f₀ + f₁)/2
//! and D = (f₀ − f₁)/2, e^{-iθ}M + e^{iθ}D has a constant imaginary part on every circle, whatever θ. Hence
//! ```text
//! M(u) = u + Σ sⱼ(u) + conj dⱼ(1/ū),    D(u) = 1/u + Σ dⱼ(u) + conj sⱼ(1/ū),    sⱼ = Σ aⱼₘ qᵐ,  dⱼ = Σ bⱼₘ qᵐ,  q = rⱼ/(u − cⱼ)
//! ```
//! satisfy this on the unit circle, and on the others where aⱼₘ and bⱼₘ are the conjugates of the Taylor coefficients of what else
//! D and M are there.

use super::circle::Circle;
use super::peak::peak;
use crate::Result;
use crate::plane::{Complex64, fourier::transform};
use crate::symm::gmres::gmres;
use crate::symm::options::Progress;
use std::f64::consts::{PI, TAU};

/// The series of a hole: (aₘ, bₘ) from m = 1.
type Terms = Vec<[Complex64; 2]>;

/// The solution.
#[derive(Clone, Debug)]
pub struct RoundShapes {
    holes: Vec<(Circle, Terms)>,
    /// About its largest error.
    pub error: f64,
}

/// Most terms of a hole,
const MOST_TERMS: usize = 480;
/// and more than are thought to be needed.
const SPARE_TERMS: usize = 4;
/// Terms are left out that are less than this share of the first.
const LEAST_TERM: f64 = 1e-17;
/// Iterations for the coefficients.
const MOST_ITERATIONS: usize = 200;
/// Angles of slits that are looked at.
const ANGLES: usize = 4;
/// Places on a circle among which the ends of slits are looked for.
const PLACES: usize = 32;

impl RoundShapes {
    /// Solves to about an error; `known` is a solution for circles not far away.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn solve(circles: &[Circle], known: Option<&Self>, error: f64, progress: Progress) -> Result<Self> {
        let sampled = Sampled::new(circles, error);
        let starts: Vec<usize> = sampled.starts();
        let mut right = vec![0.0; starts[circles.len()]];
        let images = |holes: &[(Circle, Terms)], driven: bool, y: &mut [f64]| {
            for hole in 0..circles.len() {
                let found = sampled.reflected(holes, hole, driven);
                y[starts[hole]..starts[hole + 1]].copy_from_slice(&flat(&found));
            }
        };
        let holes = |x: &[f64]| -> Vec<(Circle, Terms)> {
            circles.iter().enumerate().map(|(k, circle)| (*circle, terms(&x[starts[k]..starts[k + 1]]))).collect()
        };
        let nothing = holes(&right);
        images(&nothing, true, &mut right);
        let mut x = right.clone();
        for (hole, (_, terms)) in known.map_or(&[][..], |known| &known.holes).iter().enumerate() {
            let own = &mut x[starts[hole]..starts[hole + 1]];
            own.iter_mut().zip(flat(terms).into_iter().chain(std::iter::repeat(0.0))).for_each(|(x, known)| *x = known);
        }
        let apply = |x: &[f64], y: &mut [f64]| {
            images(&holes(x), false, y);
            y.iter_mut().zip(x).for_each(|(y, x)| *y = x - *y);
        };
        let same = |r: &[f64], z: &mut [f64]| z.copy_from_slice(r);
        let end = gmres(apply, same, &right, &mut x, error, MOST_ITERATIONS, progress)?;
        let holes = holes(&x);
        let last = |terms: &Terms| terms.iter().rev().take(2).flatten().map(|c| c.norm()).sum::<f64>();
        let tail = holes.iter().map(|(_, terms)| last(terms)).fold(0.0, f64::max);
        Ok(Self { holes, error: end.residual + tail })
    }

    /// What the unit circle becomes, about: the slits' middle, and a quarter of their length, which is the radius of a circle.
    #[must_use]
    pub fn outer(&self) -> Circle {
        mean_slit(&|turn| turn + self.rest(turn.conj()).0)
    }

    /// The same of every hole.
    #[must_use]
    pub fn circles(&self) -> Vec<Circle> {
        let shape = |(circle, terms): &(Circle, Terms)| {
            let along = |turn: Complex64| {
                let sum =
                    |c: usize| terms.iter().rev().fold(Complex64::ZERO, |sum, term| (sum + term[c].conj()) * turn);
                sum(1) + sum(0).conj()
            };
            let found = mean_slit(&along);
            let own = |hole: &Circle| std::ptr::eq(hole, circle);
            let others = self.holes.iter().filter(|(hole, _)| !own(hole));
            let direct: Complex64 = others.map(|(hole, terms)| series(terms, hole.share(circle.center))[0]).sum();
            let mirrored = circle.center.conj().inv();
            let images = self.holes.iter().map(|(hole, terms)| series(terms, hole.share(mirrored))[1].conj());
            Circle { center: found.center + circle.center + direct + images.sum::<Complex64>(), ..found }
        };
        self.holes.iter().map(shape).collect()
    }

    /// R = M(u) − u and dR/du at 1/u.
    #[inline]
    #[must_use]
    pub fn rest(&self, w: Complex64) -> (Complex64, Complex64) {
        let (mut value, mut slope) = (Complex64::ZERO, Complex64::ZERO);
        for (Circle { center, radius }, terms) in &self.holes {
            // Of s at u, and of d at 1/ū.
            let below = (1.0 - center * w).inv();
            let image = (w - center.conj()).inv();
            let [q, p] = [w * below, image].map(|x| x * *radius);
            let (sums, slopes) = sums(terms, q, p);
            value += sums[0] + sums[1];
            slope += w * (w * image * slopes[1] - below * slopes[0]);
        }
        (value, slope)
    }
}

/// Σ aₘqᵐ and Σ conj bₘ pᵐ, and the same with m times each.
#[inline]
fn sums(terms: &Terms, q: Complex64, p: Complex64) -> ([Complex64; 2], [Complex64; 2]) {
    let (mut sums, mut slopes) = ([Complex64::ZERO; 2], [Complex64::ZERO; 2]);
    for (k, x) in [q, p].into_iter().enumerate() {
        let mut power = Complex64::ONE;
        for (m, term) in terms.iter().enumerate() {
            power *= x;
            if power.norm_sqr() < LEAST_TERM * LEAST_TERM {
                break;
            }
            let part = power * if k == 0 { term[0] } else { term[1].conj() };
            sums[k] += part;
            slopes[k] += part * (m + 1) as f64;
        }
    }
    (sums, slopes)
}

/// (s, d) where q has a value.
fn series(terms: &[[Complex64; 2]], q: Complex64) -> [Complex64; 2] {
    let step = |[a, b]: [Complex64; 2], term: &[Complex64; 2]| [(a + term[0]) * q, (b + term[1]) * q];
    terms.iter().rev().fold([Complex64::ZERO; 2], step)
}

/// The mean of the slits of a component, on which X/2 + conj is what M is but for a constant.
fn mean_slit(along: &dyn Fn(Complex64) -> Complex64) -> Circle {
    let at = |place: f64| along(Complex64::cis(TAU * place / PLACES as f64));
    let samples: Vec<Complex64> = (0..PLACES).map(|k| at(k as f64)).collect();
    let mut mean = Circle { center: Complex64::ZERO, radius: 0.0 };
    for turn in (0..ANGLES).map(|k| Complex64::cis(PI * k as f64 / ANGLES as f64)) {
        let [low, high] = [-1.0, 1.0].map(|sign| {
            let value = |x: Complex64| sign * (x * turn.conj()).re;
            let best = (0..PLACES).max_by(|&a, &b| value(samples[a]).total_cmp(&value(samples[b]))).unwrap_or(0) as f64;
            sign * value(at(peak(&|place| value(at(place)), best - 1.0, best + 1.0)))
        });
        mean.center += turn * ((low + high) / ANGLES as f64);
        mean.radius += 0.5 * (high - low) / ANGLES as f64;
    }
    mean
}

impl Circle {
    /// r/(z − c).
    fn share(&self, z: Complex64) -> Complex64 {
        self.radius / (z - self.center)
    }

    /// What reflection in the unit circle makes of it.
    fn mirrored(self) -> Self {
        let Self { center, radius } = self.inverted();
        Self { center: center.conj(), radius }
    }

    /// r over the distance to the point in another circle that both circles' images converge to.
    fn decay_beside(&self, other: &Self) -> f64 {
        let apart = (self.center - other.center).norm();
        let sum = (apart * apart + self.radius * self.radius - other.radius * other.radius) / apart;
        let away = 0.5 * (sum + (sum * sum - 4.0 * self.radius * self.radius).max(0.0).sqrt());
        self.radius / away
    }
}

/// The places where the circles are sampled, and how many terms matter there.
struct Sampled<'a> {
    circles: &'a [Circle],
    /// Terms of each,
    counts: Vec<usize>,
    /// and those that matter on another circle, and on its image.
    reach: Vec<[usize; 2]>,
}

impl<'a> Sampled<'a> {
    fn new(circles: &'a [Circle], error: f64) -> Self {
        let unit = super::circle::UNIT;
        let others = |k: usize| circles.iter().enumerate().filter(move |(j, _)| *j != k).map(|(_, other)| other);
        let decays: Vec<f64> = circles
            .iter()
            .enumerate()
            .map(|(k, circle)| others(k).chain([&unit]).map(|other| circle.decay_beside(other)).fold(0.0, f64::max))
            .collect();
        let needed = |share: f64, most: usize| {
            let count = ((0.03 * error).ln() / share.ln()).ceil();
            if count >= 0.0 { (count as usize + SPARE_TERMS).min(most) } else { most }
        };
        let counts: Vec<usize> = decays.iter().map(|decay| needed(*decay, MOST_TERMS)).collect();
        let mut reach = Vec::new();
        for target in circles {
            for (k, circle) in circles.iter().enumerate() {
                reach.push([*target, target.mirrored()].map(|there| {
                    let share = circle.radius / ((circle.center - there.center).norm() - there.radius);
                    needed(share.clamp(0.0, 1.0) * decays[k], counts[k])
                }));
            }
        }
        Self { circles, counts, reach }
    }

    /// Where each hole's numbers begin among all, and their end.
    fn starts(&self) -> Vec<usize> {
        let mut starts = vec![0];
        for count in &self.counts {
            starts.push(starts[starts.len() - 1] + 4 * count);
        }
        starts
    }

    /// The conjugates of the Taylor coefficients around a hole of D and M without their own series; with or without u and 1/u.
    fn reflected(&self, holes: &[(Circle, Terms)], hole: usize, driven: bool) -> Terms {
        let (circle, count) = (self.circles[hole], self.counts[hole]);
        let places = (2 * count + 2).next_power_of_two();
        let reach = &self.reach[hole * self.circles.len()..];
        let mut values = [vec![Complex64::ZERO; places], vec![Complex64::ZERO; places]];
        for place in 0..places {
            let u = circle.center + Complex64::from_polar(circle.radius, TAU * place as f64 / places as f64);
            let mirrored = u.conj().inv();
            let mut sum = if driven { [u, mirrored.conj()] } else { [Complex64::ZERO; 2] };
            for (k, (other, terms)) in holes.iter().enumerate() {
                let [direct, image] = reach[k].map(|count| &terms[..count]);
                if k != hole {
                    let [s, d] = series(direct, other.share(u));
                    sum = [sum[0] + s, sum[1] + d];
                }
                let [s, d] = series(image, other.share(mirrored));
                sum = [sum[0] + d.conj(), sum[1] + s.conj()];
            }
            values[0][place] = sum[0];
            values[1][place] = sum[1];
        }
        let [m, d] = values.map(|values| transform(&values));
        (1..=count).map(|k| [d[k].conj() / places as f64, m[k].conj() / places as f64]).collect()
    }
}

fn flat(terms: &Terms) -> Vec<f64> {
    terms.iter().flatten().flat_map(|c| [c.re, c.im]).collect()
}

fn terms(x: &[f64]) -> Terms {
    x.chunks_exact(4).map(|x| [Complex64::new(x[0], x[1]), Complex64::new(x[2], x[3])]).collect()
}
