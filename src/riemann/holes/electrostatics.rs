//! Electrostatics between conductors of any cross-section.

use super::super::evidence::{Evidence, evidence_methods};
use super::field::DomainField;
use super::level_lines::{Function, LevelLine};
use super::solved::Solved;
use crate::plane::{Complex64, Domain, NOWHERE};
use crate::symm::options::{Progress, SolveOptions};
use crate::symm::problem::Problem;
use crate::{Error, Result};
use std::f64::consts::TAU;

/// What is known of the conductors, one number for each: the outer boundary first if there is one, then the holes or bodies.
#[derive(Clone, Debug, PartialEq)]
pub enum Conductors {
    /// Their potentials.
    Potentials(Vec<f64>),
    /// Their charges a unit of length, divided by ε₀. They must add up to 0.
    Charges(Vec<f64>),
}

/// The field between conductors: cylinders whose cross-section are the components of a domain's boundary.
///
/// Potential and charges are linear in each other, λ = K·V, by Maxwell's capacitance matrix. For a unit charge on each conductor
/// in turn ∫ log|x − y| σ + cⱼ = 0 gives the potentials cⱼ/2π; K is the inverse of these. All are a unit of length, with ε₀ = 1.
///
/// ```
/// use conformal_warp::{Complex64, Conductors, Curve, Domain, Electrostatics, SolveOptions};
/// let square = |half: f64| [(-half, -half), (half, -half), (half, half), (-half, half)].map(|(x, y)| Complex64::new(x, y));
/// let line = Domain::new(&square(1.0), &[square(0.5).to_vec()], Curve::Polygon)?;
/// let given = Conductors::Potentials(vec![0.0, 1.0]);
/// let field = Electrostatics::solve(&line, &given, &SolveOptions::default(), &mut |_, _| true)?;
/// assert!((field.capacitance()[1][1] - 10.234_092_569_368).abs() < 1e-7);
/// assert!((field.impedance().unwrap_or(0.0) - 36.811_306_020_4).abs() < 1e-6, "of a square coaxial line, in ohms");
/// # Ok::<(), conformal_warp::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Electrostatics {
    field: DomainField,
    /// The potential is this − Re B/2π.
    level: f64,
    capacitance: Vec<Vec<f64>>,
    potentials: Vec<f64>,
    charges: Vec<f64>,
    logarithmic_capacity: Option<f64>,
    evidence: Evidence,
}

/// The impedance of free space, in ohms: the line's is this over its capacitance/ε₀.
const FREE_SPACE: f64 = 376.730_313_412;

impl Electrostatics {
    /// Solves for the field. Of given charges the potential is fixed by that of the first conductor, which is 0.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one number for each component; [`Error::InvalidOption`] for charges that do not
    /// add up to 0; [`Error::WrongRegion`] for a single conductor; [`Error::Cancelled`], [`Error::Inaccurate`],
    /// [`Error::TooFewPoints`].
    pub fn solve(domain: &Domain, given: &Conductors, options: &SolveOptions, progress: Progress) -> Result<Self> {
        let count = domain.contours().len();
        if count < 2 {
            let found = "one".to_string();
            return Err(Error::WrongRegion { what: "An electric field", needed: "two conductors or more", found });
        }
        let (Conductors::Potentials(numbers) | Conductors::Charges(numbers)) = given;
        if numbers.len() != count {
            let expected = count.to_string();
            return Err(Error::WrongLength { what: "What is given of the conductors", expected, found: numbers.len() });
        }
        if let Some(value) = numbers.iter().copied().find(|number| !number.is_finite()) {
            let name = if matches!(given, Conductors::Charges(_)) { "charges" } else { "potentials" };
            return Err(Error::InvalidOption { name, expected: "finite numbers", value });
        }
        let first = usize::from(domain.is_bounded());
        let unit_charge = |k: usize| {
            let mut charges = vec![0.0; count];
            charges[k] = 1.0;
            if first == 1 {
                charges[0] = -1.0;
            }
            Problem::charged(charges)
        };
        let problems = |_| (first..count).map(unit_charge).collect();
        let solved = Solved::solve(domain, &problems, options, progress)?;
        let response: Vec<&[f64]> = (0..count - first).map(|k| solved.constants(k)).collect();
        let capacitance = capacitance(&response, count, first);
        let (charges, potentials) = match given {
            Conductors::Potentials(potentials) => (product(&capacitance, potentials), potentials.clone()),
            Conductors::Charges(charges) => {
                let (total, size) = charges.iter().fold((0.0, 0.0), |(sum, size), q| (sum + q, size + f64::abs(*q)));
                let is_balanced = f64::abs(total) <= 1e-12 * size;
                if !is_balanced {
                    let expected = "such that all add up to 0";
                    return Err(Error::InvalidOption { name: "charges", expected, value: total });
                }
                let potential = |j: usize| {
                    let sum = |j: usize| (first..count).map(|k| charges[k] * response[k - first][j]).sum::<f64>();
                    (sum(j) - sum(0)) / TAU
                };
                (charges.clone(), (0..count).map(potential).collect())
            }
        };
        let field = solved.field(&charges[first..]);
        let level = potentials[0] - field.constants()[0] / TAU;
        let logarithmic_capacity = (first == 0).then(|| logarithmic_capacity(&response) / solved.scale().unit);
        let evidence = solved.evidence;
        Ok(Self { field, level, capacitance, potentials, charges, logarithmic_capacity, evidence })
    }

    /// Maxwell's capacitance matrix divided by ε₀, a unit of length: charges = matrix · potentials. Rows and columns are the
    /// components, the outer one first; every row adds up to 0.
    #[must_use]
    pub fn capacitance(&self) -> &[Vec<f64>] {
        &self.capacitance
    }

    /// The potential of each conductor.
    #[must_use]
    pub fn potentials(&self) -> &[f64] {
        &self.potentials
    }

    /// The charge of each conductor a unit of length, divided by ε₀.
    #[must_use]
    pub fn charges(&self) -> &[f64] {
        &self.charges
    }

    /// The characteristic impedance in ohms of the line that two conductors in vacuum make; `None` for more of them.
    #[must_use]
    pub fn impedance(&self) -> Option<f64> {
        (self.capacitance.len() == 2).then(|| FREE_SPACE / self.capacitance[1][1])
    }

    /// The logarithmic capacity of all bodies together, in plane units; `None` within an outer boundary.
    #[must_use]
    pub fn logarithmic_capacity(&self) -> Option<f64> {
        self.logarithmic_capacity
    }

    /// The potential at points; NaN inside conductors.
    #[must_use]
    pub fn potential(&self, points: &[Complex64]) -> Vec<f64> {
        points.iter().map(|&z| self.field.fast(z).map_or(f64::NAN, |(b, _)| self.level - b.re / TAU)).collect()
    }

    /// Lines on which the potential has given values, in the box from `low` to `high`, traced by the field itself. A closed line
    /// smaller than 1/72 of the box may be missed.
    #[must_use]
    pub fn level_lines(&self, levels: &[f64], [low, high]: [Complex64; 2]) -> Vec<LevelLine> {
        // The imaginary part of i(level − B/2π).
        let i = Complex64::i();
        let function = Function { field: &self.field, factor: -i / TAU, shift: i * self.level };
        let rests = function.rests_inside((low, high));
        function.lines(levels, (low, high), &rests)
    }

    /// Lines of force, in the box from `low` to `high`: `count` leave the conductor with the largest charge, and from every
    /// other with a positive one as many as it has of it. The same flux lies between neighbours. The `level` of each is the
    /// number of the conductor that it leaves.
    #[must_use]
    pub fn force_lines(&self, count: usize, [low, high]: [Complex64; 2]) -> Vec<LevelLine> {
        // E = conj F' with F = B/2π.
        let function = Function { field: &self.field, factor: Complex64::from(1.0 / TAU), shift: Complex64::ZERO };
        let largest = self.charges.iter().fold(0.0, |most: f64, charge| most.max(charge.abs()));
        let mut lines = Vec::new();
        if largest <= self.rounding_of_charges() {
            return lines;
        }
        for (component, charge) in self.charges.iter().enumerate() {
            let own = (count as f64 * charge / largest).round();
            // None of what is negative or NaN.
            for start in self.places_of_flux(component, own as usize) {
                let line = function.line_from(start, (low, high));
                lines.extend(line.map(|line| LevelLine { level: component as f64, ..line }));
            }
        }
        lines
    }

    /// What charges are by rounding alone: those of equal potentials, which no field lies between.
    fn rounding_of_charges(&self) -> f64 {
        let terms =
            self.capacitance.iter().flat_map(|row| row.iter().zip(&self.potentials).map(|(c, v)| (c * v).abs()));
        1e3 * f64::EPSILON * terms.fold(0.0, f64::max)
    }

    /// Places of a wall between which the same flux leaves it.
    fn places_of_flux(&self, component: usize, count: usize) -> Vec<Complex64> {
        const SAMPLES: usize = 24;
        let domain = self.field.domain();
        let contour = &domain.contours()[component];
        let per_edge = SAMPLES * contour.detail();
        let samples = contour.edge_count() * per_edge;
        let at = |k: usize| domain.place_along(component, k as f64 / per_edge as f64);
        let phases: Vec<f64> = (0..samples).map(|k| self.field.on_boundary(at(k)).0.im).collect();
        // Around the wall Im B grows or falls by 2π times the charge.
        let whole = TAU * self.charges[component];
        let outward = if domain.is_bounded() && component == 0 { -1.0 } else { 1.0 };
        let mut sums = vec![0.0];
        for k in 0..samples {
            let mut change = outward * (phases[(k + 1) % samples] - phases[k]);
            if k + 1 == samples {
                change += whole;
            }
            // What runs back enters the wall.
            sums.push(sums[k] + change.max(0.0));
        }
        let place = |n: usize| {
            let wanted = (n as f64 + 0.5) / count as f64 * sums[samples];
            let k = sums.partition_point(|sum| *sum < wanted).clamp(1, samples) - 1;
            let share = (wanted - sums[k]) / (sums[k + 1] - sums[k]);
            domain.point_along(component, (k as f64 + share) / per_edge as f64)
        };
        (0..count).map(place).collect()
    }

    /// The electric field E, as x + iy, at points; NaN inside conductors.
    #[must_use]
    pub fn field(&self, points: &[Complex64]) -> Vec<Complex64> {
        points.iter().map(|&z| self.field.fast(z).map_or(NOWHERE, |(_, slope)| slope.conj() / TAU)).collect()
    }
}

evidence_methods!(Electrostatics, "of the potentials of unit charges.");

/// K, from the constants that unit charges give: `response[k][j]` of component j for the charge on component k + first.
fn capacitance(response: &[&[f64]], count: usize, first: usize) -> Vec<Vec<f64>> {
    let free = response.len();
    let mut matrix = vec![vec![0.0; count]; count];
    for driven in 0..count {
        // Charges and a level, such that the potentials are 1 on `driven` and 0 elsewhere.
        let size = free + 1;
        let mut system = vec![0.0; size * size];
        let mut rhs = vec![0.0; size];
        for j in 0..count {
            for k in 0..free {
                system[j * size + k] = response[k][j] / TAU;
            }
            system[j * size + free] = 1.0;
        }
        if first == 0 {
            // The charge of an outer boundary follows from the others; without one they must add up to 0.
            system[count * size..count * size + free].fill(1.0);
        }
        rhs[driven] = 1.0;
        let charges = crate::symm::small_solve(system, rhs);
        for k in 0..free {
            matrix[k + first][driven] = charges[k];
        }
        if first == 1 {
            matrix[0][driven] = -charges[..free].iter().sum::<f64>();
        }
    }
    matrix
}

/// exp(−c) for the unit charge that gives all bodies the same constant c.
fn logarithmic_capacity(response: &[&[f64]]) -> f64 {
    let count = response.len();
    let size = count + 1;
    let mut system = vec![0.0; size * size];
    for j in 0..count {
        for k in 0..count {
            system[j * size + k] = response[k][j];
        }
        system[j * size + count] = -1.0;
        system[count * size + j] = 1.0;
    }
    let mut rhs = vec![0.0; size];
    rhs[count] = 1.0;
    (-crate::symm::small_solve(system, rhs)[count]).exp()
}

fn product(matrix: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum()).collect()
}
