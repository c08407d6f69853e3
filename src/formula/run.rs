//! Runs a program over blocks of points, with exact derivatives beside the values.
//!
//! Forward mode: every register holds f, and the chain rule carries ∂f/∂z (and ∂f/∂z̄ where the formula is not
//! analytic) along. The const parameter `D` is the number of derivatives: 0, 1 or 2.

use super::functions::{divide, log, pow, pow_with_slope};
use super::lanes::Lanes;
use super::operation::{Binary, Unary};
use super::program::{Operation, Program, Source};
use crate::plane::Complex64;

/// Points in a block: long enough to hide the dispatch, short enough for the first-level cache.
const BLOCK: usize = 64;

/// Calls `emit(k, value and derivatives at points[k])` for each point.
pub fn run<const D: usize>(
    program: &Program,
    fixed: &[Complex64],
    points: &[Complex64],
    mut emit: impl FnMut(usize, [Complex64; 3]),
) {
    let width = BLOCK.min(points.len());
    let mut machine = Machine::<D>::new(program, fixed, width);
    for (block, points) in points.chunks(BLOCK).enumerate() {
        machine.load(points);
        machine.execute(program);
        for k in 0..points.len() {
            emit(block * BLOCK + k, machine.result(program.result, k));
        }
    }
}

struct Machine<'a, const D: usize> {
    fixed: &'a [Complex64],
    registers: Vec<Lanes>,
    /// Instructions write here; the register of the target is then exchanged for it, so that it may be an operand's.
    target: Lanes,
    /// Partial derivatives of an operation at its operands.
    slopes: Lanes,
}

/// An operand at run time.
#[derive(Clone, Copy)]
enum Operand<'a> {
    Fixed(Complex64),
    Lanes(&'a Lanes),
}

impl<'a, const D: usize> Machine<'a, D> {
    fn new(program: &Program, fixed: &'a [Complex64], width: usize) -> Self {
        let lanes = || Lanes::new(width, 1 + D);
        let registers = (0..program.registers).map(|_| lanes()).collect();
        Self { fixed, registers, target: lanes(), slopes: Lanes::new(width, 2) }
    }

    /// z into register 0: ∂z/∂z = 1. A short last block repeats its last point.
    fn load(&mut self, points: &[Complex64]) {
        let z = &mut self.registers[0];
        z.fill(0, |k| points[k.min(points.len() - 1)]);
        (1..=D).for_each(|d| z.fill(d, |_| if d == 1 { Complex64::ONE } else { Complex64::ZERO }));
    }

    fn result(&self, source: Source, k: usize) -> [Complex64; 3] {
        let mut result = [Complex64::ZERO; 3];
        match self.operand(source) {
            Operand::Fixed(value) => result[0] = value,
            Operand::Lanes(lanes) => (0..=D).for_each(|d| result[d] = lanes.row(d).at(k)),
        }
        result
    }

    fn operand(&self, source: Source) -> Operand<'_> {
        match source {
            Source::Fixed(index) => Operand::Fixed(self.fixed[index]),
            Source::Register(index) => Operand::Lanes(&self.registers[index]),
        }
    }

    fn execute(&mut self, program: &Program) {
        for instruction in &program.code {
            // Taken out, so that operands can be borrowed while they are written.
            let mut target = std::mem::replace(&mut self.target, Lanes::new(0, 0));
            let mut slopes = std::mem::replace(&mut self.slopes, Lanes::new(0, 0));
            match instruction.operation {
                Operation::Unary(operation, a) => {
                    unary::<D>(operation, &self.registers[a], &mut target, &mut slopes);
                }
                Operation::Binary(operation, a, b) => {
                    binary::<D>(operation, self.operand(a), self.operand(b), &mut target, &mut slopes);
                }
            }
            self.target = std::mem::replace(&mut self.registers[instruction.target], target);
            self.slopes = slopes;
        }
    }
}

fn unary<const D: usize>(operation: Unary, a: &Lanes, target: &mut Lanes, slopes: &mut Lanes) {
    match operation {
        Unary::Negate => (0..=D).for_each(|d| target.map(d, a.row(d), |z| -z)),
        Unary::Conjugate => {
            target.map(0, a.row(0), |z| z.conj());
            // ∂f̄/∂z is the conjugate of ∂f/∂z̄.
            (1..=D).for_each(|d| target.map(d, a.row(D + 1 - d), |z| z.conj()));
        }
        Unary::Real(real) => {
            target.map(0, a.row(0), |z| real.value(z));
            if D == 2 {
                // du = Re(w df), so ∂u/∂z = (w ∂f/∂z + conj(w ∂f/∂z̄)) / 2, and ∂u/∂z̄ is its conjugate.
                slopes.fill(0, |k| {
                    let w = real.weight(a.row(0).at(k));
                    0.5 * (times_differential(w, a.row(1).at(k)) + times_differential(w, a.row(2).at(k)).conj())
                });
                target.map(1, slopes.row(0), |slope| slope);
                target.map(2, slopes.row(0), |slope| slope.conj());
            }
        }
        Unary::Analytic(analytic) => apply::<D>(a, target, slopes, analytic.function()),
    }
}

/// An analytic function of one varying operand, and the chain rule.
fn apply<const D: usize>(
    a: &Lanes,
    target: &mut Lanes,
    slopes: &mut Lanes,
    f: impl Fn(Complex64) -> (Complex64, Complex64),
) {
    for k in 0..a.width() {
        let (value, slope) = f(a.row(0).at(k));
        target.set(0, k, value);
        slopes.set(0, k, slope);
    }
    (1..=D).for_each(|d| target.map2(d, slopes.row(0), a.row(d), times_differential));
}

/// slope · da; what does not change stays so where the slope is infinite, as in asin(z/z).
fn times_differential(slope: Complex64, da: Complex64) -> Complex64 {
    if da == Complex64::ZERO { Complex64::ZERO } else { slope * da }
}

fn binary<const D: usize>(operation: Binary, a: Operand, b: Operand, target: &mut Lanes, slopes: &mut Lanes) {
    use Operand::{Fixed, Lanes as Varying};
    match (operation, a, b) {
        (_, Fixed(_), Fixed(_)) => {}
        (Binary::Add, Varying(a), Varying(b)) => {
            (0..=D).for_each(|d| target.map2(d, a.row(d), b.row(d), |a, b| a + b));
        }
        (Binary::Add, Varying(a), Fixed(c)) | (Binary::Add, Fixed(c), Varying(a)) => {
            target.map(0, a.row(0), |a| a + c);
            (1..=D).for_each(|d| target.map(d, a.row(d), |da| da));
        }
        (Binary::Subtract, Varying(a), Varying(b)) => {
            (0..=D).for_each(|d| target.map2(d, a.row(d), b.row(d), |a, b| a - b));
        }
        (Binary::Subtract, Varying(a), Fixed(c)) => {
            target.map(0, a.row(0), |a| a - c);
            (1..=D).for_each(|d| target.map(d, a.row(d), |da| da));
        }
        (Binary::Subtract, Fixed(c), Varying(b)) => {
            target.map(0, b.row(0), |b| c - b);
            (1..=D).for_each(|d| target.map(d, b.row(d), |db| -db));
        }
        (Binary::Multiply, Varying(a), Varying(b)) => {
            target.map2(0, a.row(0), b.row(0), |a, b| a * b);
            (1..=D).for_each(|d| target.products(d, [a.row(d), b.row(0), a.row(0), b.row(d)]));
        }
        (Binary::Multiply, Varying(a), Fixed(c)) | (Binary::Multiply, Fixed(c), Varying(a)) => {
            (0..=D).for_each(|d| target.map(d, a.row(d), |a| a * c));
        }
        (Binary::Divide, a, b) => quotient::<D>(a, b, target, slopes),
        (Binary::Power, a, b) => power::<D>(a, b, target, slopes),
        (Binary::Special(special), Fixed(parameter), Varying(b)) => {
            apply::<D>(b, target, slopes, special.function(parameter));
        }
        // A parameter that depends on z was refused.
        (Binary::Special(_), Varying(_), _) => {}
    }
}

/// q = a/b, q' = (a' − q b')/b.
fn quotient<const D: usize>(a: Operand, b: Operand, target: &mut Lanes, slopes: &mut Lanes) {
    match (a, b) {
        (Operand::Lanes(a), Operand::Lanes(b)) => {
            slopes.map2(0, a.row(0), b.row(0), divide);
            for d in 1..=D {
                let (q, da, db, b) = (slopes.row(0), a.row(d), b.row(d), b.row(0));
                target.fill(d, |k| divide(da.at(k) - q.at(k) * db.at(k), b.at(k)));
            }
            target.map(0, slopes.row(0), |q| q);
        }
        (Operand::Lanes(a), Operand::Fixed(c)) if c.im == 0.0 => {
            (0..=D).for_each(|d| target.map(d, a.row(d), |a| a / c.re));
        }
        (Operand::Lanes(a), Operand::Fixed(c)) => {
            (0..=D).for_each(|d| target.map(d, a.row(d), |a| divide(a, c)));
        }
        (Operand::Fixed(c), Operand::Lanes(b)) => apply::<D>(b, target, slopes, |b| {
            let value = divide(c, b);
            (value, -divide(value, b))
        }),
        (Operand::Fixed(_), Operand::Fixed(_)) => {}
    }
}

/// p = a^b, dp = b a^(b−1) da + p log a db.
fn power<const D: usize>(a: Operand, b: Operand, target: &mut Lanes, slopes: &mut Lanes) {
    match (a, b) {
        (Operand::Lanes(a), Operand::Fixed(exponent)) => {
            apply::<D>(a, target, slopes, |a| pow_with_slope(a, exponent));
        }
        (Operand::Fixed(base), Operand::Lanes(b)) => {
            let log = if base == Complex64::ZERO { base } else { log(base).0 };
            apply::<D>(b, target, slopes, |b| {
                let value = pow(base, b);
                (value, value * log)
            });
        }
        (Operand::Lanes(a), Operand::Lanes(b)) => {
            for k in 0..a.width() {
                let (base, exponent) = (a.row(0).at(k), b.row(0).at(k));
                let (value, slope) = pow_with_slope(base, exponent);
                let by_exponent = if base == Complex64::ZERO { base } else { value * log(base).0 };
                target.set(0, k, value);
                slopes.set(0, k, slope);
                slopes.set(1, k, by_exponent);
            }
            for d in 1..=D {
                let (by_base, da, by_exponent, db) = (slopes.row(0), a.row(d), slopes.row(1), b.row(d));
                target.fill(d, |k| {
                    times_differential(by_base.at(k), da.at(k)) + times_differential(by_exponent.at(k), db.at(k))
                });
            }
        }
        (Operand::Fixed(_), Operand::Fixed(_)) => {}
    }
}
