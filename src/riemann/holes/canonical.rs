//! A map onto a canonical region, both ways.

use super::super::both_ways::Pointwise;
use super::barriers::Barriers;
use super::field::DomainField;
use super::inverse_tree::{InverseTree, Inverted, Origin, Pair};
use super::seeds::Seeds;
use crate::Result;
use crate::plane::{Complex64, Domain, DomainPoint};
use crate::symm::options::Progress;
use std::f64::consts::TAU;
use std::iter;
use std::sync::{Arc, OnceLock};

/// What a map is of its function B: with k(z) = aB(z) + b, the map is k or its exponential.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Form {
    /// a.
    pub factor: Complex64,
    /// b.
    pub shift: Complex64,
    /// Whether the map is eᵏ.
    pub exponential: bool,
    /// The point that goes to 0, if there is one.
    pub zero: Option<Complex64>,
}

impl Form {
    /// What keys are measured in: where nothing goes to 0 or infinity by a logarithm, plane units or their inverse.
    fn unit(&self) -> f64 {
        if self.exponential { 1.0 } else { self.factor.norm() }
    }
}

/// A map domain → canonical region.
#[derive(Clone, Debug)]
pub struct Canonical {
    field: Arc<DomainField>,
    /// If there is one, with its function C: k(z) = −log(aB(z) + iaC(z) + b).
    partner: Option<Arc<DomainField>>,
    form: Form,
    /// The real parts of k lie between these.
    strip: (f64, f64),
    /// What is left of k when Newton's method has converged as far as it can.
    reached: f64,
    /// Below this a step that does not come nearer ends it.
    satisfied: f64,
    /// The larger side of the first component's box.
    size: f64,
    /// The slits that components go to.
    barriers: Barriers,
    /// Made at the first use of the way back.
    back: Arc<OnceLock<Back>>,
}

/// What the way back needs.
#[derive(Debug)]
struct Back {
    /// Known pairs.
    seeds: Seeds,
    tree: InverseTree,
}

/// Newton's method ends after so many steps.
const MOST_STEPS: usize = 80;
/// So much is left of k, in its units, if nothing else is said.
const REACHED: f64 = 1e-10;
/// It is satisfied with so much if nothing else is said,
const SATISFIED: f64 = 1e-13;
/// and below this nothing more is to be had.
const ROUNDING: f64 = 2e-16;
/// How often a step is shortened.
const MOST_TRIALS: usize = 12;
/// Seeds that are tried.
const CANDIDATES: usize = 16;
/// Steps on the straight way from a seed, if Newton's method alone does not find it.
const LONGEST_WAY: usize = 64;

impl Canonical {
    /// A map in a given form.
    #[must_use]
    pub fn new(field: DomainField, form: Form, strip: (f64, f64)) -> Self {
        let size = field.domain().contours()[0].polygon().size();
        let unit = form.unit();
        let coherence = field.coherence().unwrap_or(0.0);
        let [reached, satisfied] = [REACHED, SATISFIED].map(|least| unit * coherence.max(least));
        let barriers = Barriers::default();
        Self {
            field: Arc::new(field),
            partner: None,
            form,
            strip,
            reached,
            satisfied,
            size,
            barriers,
            back: Arc::default(),
        }
    }

    /// 1/(aB(z) + iaC(z) + b) with B and C of two fields of one domain.
    #[must_use]
    pub fn reciprocal([field, partner]: [DomainField; 2], form: Form) -> Self {
        let map = Self::new(field, form, (f64::NEG_INFINITY, f64::INFINITY));
        Self { partner: Some(Arc::new(partner)), ..map }
    }

    /// The same map, whose way back takes images as far outside as `reach` for images of the boundary: those of a map onto this
    /// one's image that is only so accurate.
    #[must_use]
    pub fn reaching(self, reach: f64) -> Self {
        Self { reached: reach.max(self.reached), ..self }
    }

    /// The same map, whose way back does not look through these slits, given by the keys of their ends.
    #[must_use]
    pub fn around(self, slits: Vec<[Complex64; 2]>) -> Self {
        Self { barriers: Barriers::new(slits, self.form.exponential, self.reached), ..self }
    }

    /// Makes now what evaluation makes at its first use, either way.
    ///
    /// # Errors
    /// [`Error::Cancelled`](crate::Error::Cancelled); what was finished by then is kept.
    pub fn prepare(&self, progress: Progress) -> Result<()> {
        for field in iter::once(&self.field).chain(&self.partner) {
            field.prepare(progress)?;
        }
        let back = self.back();
        self.inverting(back, |inverted| back.tree.fill(inverted, progress))
    }

    fn back(&self) -> &Back {
        self.back.get_or_init(|| {
            let key = |z| self.key(z).map(|(key, _)| key).filter(|key| key.is_finite());
            let seeds = Seeds::new(self.domain(), self.form.exponential, !self.barriers.is_empty(), &key);
            let tree = InverseTree::new(&seeds);
            Back { seeds, tree }
        })
    }

    /// Calls `what` with what the tree has to know of the map.
    #[inline]
    fn inverting<T>(&self, back: &Back, what: impl FnOnce(&Inverted) -> T) -> T {
        let newton = |target: Complex64, z: Complex64| {
            let (z, slope) = self.newton(target, z)?;
            Some(Pair { key: target, z, slope: slope.inv() })
        };
        let (strip, accuracy, size) = (self.strip, self.field.accuracy(), self.size);
        what(&Inverted { seeds: &back.seeds, barriers: &self.barriers, strip, newton: &newton, accuracy, size })
    }

    /// The function B.
    #[must_use]
    pub fn field(&self) -> &DomainField {
        &self.field
    }

    /// The domain.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        self.field.domain()
    }

    /// (k, k') at a point; `None` outside the closed domain.
    fn key(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        let factor = self.form.factor;
        let (value, slope) = self.field.fast(z)?;
        let (key, slope) = (factor * value + self.form.shift, factor * slope);
        let Some(partner) = &self.partner else { return Some((key, slope)) };
        let factor = Complex64::i() * factor;
        let (value, partner_slope) = partner.fast(z)?;
        let sum = key + factor * value;
        Some((-sum.ln(), -(slope + factor * partner_slope) / sum))
    }

    /// f' where f is 0: the mean of f/(z − zero) over a small circle.
    fn slope_at_zero(&self, zero: Complex64) -> Complex64 {
        const POINTS: u32 = 8;
        let radius = 0.03 * (self.domain().nearest(zero).place.point - zero).norm();
        let turns = (0..POINTS).map(|k| Complex64::from_polar(radius, TAU * f64::from(k) / f64::from(POINTS)));
        let ratios = turns.filter_map(|turn| Some(self.at(zero + turn)?.0 / turn));
        ratios.sum::<Complex64>() / f64::from(POINTS)
    }

    /// w → (z, dz/dw); `None` where nothing goes to w.
    #[must_use]
    pub fn inverse(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        if !w.is_finite() {
            return None;
        }
        if self.form.exponential && w == Complex64::ZERO {
            let zero = self.form.zero?;
            return Some((zero, self.slope_at_zero(zero).inv()));
        }
        let mut target = if self.form.exponential { w.ln() } else { w };
        if target.im < 0.0 && self.form.exponential {
            target.im += TAU;
        }
        let back = self.back();
        let found = match self.inverting(back, |inverted| back.tree.at(target, inverted)) {
            Origin::Known(z, slope) => Some((z, slope)),
            Origin::Near(pair) if !self.barriers.part(pair.key, target) => {
                self.newton(target, pair.guess(target)).map(|(z, slope)| (z, slope.inv()))
            }
            Origin::Near(_) | Origin::Unknown => None,
        };
        let (z, slope) = found.or_else(|| {
            let (z, slope) = self.from_seeds(target)?;
            Some((z, slope.inv()))
        })?;
        Some((z, if self.form.exponential { slope / w } else { slope }))
    }

    /// (k, k') at a point of the boundary, k being continuous along a component around which it does not grow.
    #[must_use]
    pub fn key_on_boundary(&self, point: DomainPoint) -> (Complex64, Complex64) {
        let (value, slope) = self.field.on_boundary(point);
        (self.form.factor * value + self.form.shift, self.form.factor * slope)
    }

    /// The map at a point of the boundary, made of two fields.
    #[must_use]
    pub fn value_on_boundary(&self, point: DomainPoint) -> Complex64 {
        let (sum, _) = self.key_on_boundary(point);
        let partner = self.partner.as_ref().map_or(Complex64::ZERO, |partner| partner.on_boundary(point).0);
        (sum + Complex64::i() * self.form.factor * partner).inv()
    }

    /// (z, k') where k is `target`, by Newton's method from what lies near, on the same side of all slits.
    #[cold]
    fn from_seeds(&self, target: Complex64) -> Option<(Complex64, Complex64)> {
        let is_beside = |key: Complex64| !self.barriers.part(key, target);
        let candidates = self.back().seeds.near_where(target, CANDIDATES, &is_beside);
        let direct = candidates.iter().find_map(|&(_, z)| self.newton(target, z));
        direct.or_else(|| candidates.iter().find_map(|&(key, z)| self.walk(key, z, target)))
    }

    /// [`Canonical::inverse`] between the circles |w| = e^low and |w| = e^high, which belong to it up to rounding, and go to the
    /// boundary.
    #[must_use]
    pub fn within(&self, w: Complex64, low: f64, high: f64) -> Option<(Complex64, Complex64)> {
        let log = 0.5 * w.norm_sqr().ln();
        // Written so that NaN is outside.
        if !(log >= low - ON_CIRCLE && log <= high + ON_CIRCLE) {
            return None;
        }
        let near = |circle: f64| (log - circle).abs() <= ON_CIRCLE;
        if !near(low) && !near(high) {
            return self.inverse(w);
        }
        let circle = if near(low) { low } else { high };
        self.inverse_on_boundary(w * (circle - log).exp())
    }

    /// [`Canonical::inverse`] of an image of the boundary, up to rounding.
    #[must_use]
    pub fn inverse_on_boundary(&self, w: Complex64) -> Option<(Complex64, Complex64)> {
        let (z, slope) = self.inverse(w).or_else(|| self.vertex_at(w.ln()))?;
        Some((self.domain().nearest(z).place.point, slope))
    }

    /// The vertex that goes to `target`, and dz/dw there: where a slope is infinite, Newton's method does not arrive.
    #[cold]
    fn vertex_at(&self, target: Complex64) -> Option<(Complex64, Complex64)> {
        let cornered = self.domain().contours().iter().filter(|contour| contour.smooth().is_none());
        let mut vertices = cornered.flat_map(|contour| (0..contour.edge_count()).map(|edge| contour.end(edge)));
        let found =
            vertices.find(|&z| self.key(z).is_some_and(|(key, _)| self.miss(key, target).norm() <= self.reached))?;
        Some((found, Complex64::ZERO))
    }

    /// k − target, on the branch nearest to 0.
    fn miss(&self, key: Complex64, target: Complex64) -> Complex64 {
        let mut miss = key - target;
        if self.form.exponential {
            miss.im -= TAU * (miss.im / TAU).round();
        }
        miss
    }

    /// Newton's method for k(z) = target, with steps that stay in the domain and come nearer: z, and k' there.
    fn newton(&self, target: Complex64, z: Complex64) -> Option<(Complex64, Complex64)> {
        let (mut z, (key, mut slope)) = self.key_inside(z)?;
        let rounding = ROUNDING * (self.form.unit() + target.norm());
        let mut miss = self.miss(key, target);
        for _ in 0..MOST_STEPS {
            let mut step = -miss / slope;
            if !step.is_finite() {
                // On a corner itself: move off it.
                step = Complex64::new(1e-9 * self.size, 0.0);
            }
            let mut moved = None;
            // What is as good as it can be is not worth many trials.
            for _ in 0..if miss.norm() <= self.satisfied { 1 } else { MOST_TRIALS } {
                if let Some((next, (key, slope))) = self.key_inside(z + step) {
                    let next_miss = self.miss(key, target);
                    if next_miss.norm() < miss.norm() {
                        moved = Some((next, next_miss, slope));
                        break;
                    }
                }
                step *= 0.3;
            }
            let Some((next, next_miss, next_slope)) = moved else { break };
            let length = (next - z).norm();
            (z, miss, slope) = (next, next_miss, next_slope);
            if miss.norm() <= rounding || length <= 1e-16 * self.size {
                break;
            }
        }
        (miss.norm() <= self.reached).then_some((z, slope))
    }

    /// From a known pair along the straight way.
    fn walk(&self, key: Complex64, z: Complex64, target: Complex64) -> Option<(Complex64, Complex64)> {
        let way = -self.miss(key, target);
        let mut steps = 4;
        while steps <= LONGEST_WAY {
            let start = (z, Complex64::ZERO);
            let found = (1..=steps).try_fold(start, |(z, _), k| self.newton(key + way * (k as f64 / steps as f64), z));
            if found.is_some() {
                return found;
            }
            steps *= 4;
        }
        None
    }

    /// The point, or the nearest of the boundary if it lies outside, and (k, k') there.
    fn key_inside(&self, z: Complex64) -> Option<(Complex64, (Complex64, Complex64))> {
        if let Some(known) = self.key(z) {
            return Some((z, known));
        }
        let wall = self.domain().nearest(z).place.point;
        Some((wall, self.key(wall)?))
    }
}

impl Pointwise for Canonical {
    /// Infinite at the pole.
    fn at(&self, z: Complex64) -> Option<(Complex64, Complex64)> {
        if self.form.zero == Some(z) {
            return Some((Complex64::ZERO, self.slope_at_zero(z)));
        }
        let (key, slope) = self.key(z)?;
        if !self.form.exponential {
            return Some((key, slope));
        }
        let w = key.exp();
        Some((w, w * slope))
    }
}

/// log|w| differs by less than this from that of points on a circle.
const ON_CIRCLE: f64 = 1e-14;

/// Gives a class with a [`Canonical`] in `map` the method `prepare`.
macro_rules! prepared {
    ($class:ident) => {
        impl $class {
            /// Builds the evaluator now, both ways, instead of at its first use. `progress` as in solving.
            ///
            /// # Errors
            /// [`Error::Cancelled`]($crate::Error::Cancelled). What was finished by then is kept, and the map is as usable as
            /// before.
            pub fn prepare(&self, progress: $crate::symm::options::Progress) -> $crate::Result<()> {
                self.map.prepare(progress)
            }
        }
    };
}
pub(super) use prepared;
