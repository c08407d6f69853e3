//! Postfix steps → graph: calls become operations, loops are unrolled.

use super::graph::{Graph, NodeId};
use super::names::{Call, Loop};
use super::operation::{Analytic, Binary, Unary};
use super::parser::Step;
use super::special::Special;
use crate::plane::Complex64;
use crate::{Error, Result};
use std::f64::consts::{LN_10, TAU};

/// Most operations of a formula, its loops written out: what bounds the time that a point can take.
pub const MOST_OPERATIONS: usize = 20_000;

/// Below this, every whole number is a double of its own.
const MOST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// The graph of a formula and the node of its value.
pub fn expand(steps: &[Step]) -> Result<(Graph, NodeId)> {
    let mut expansion = Expansion { graph: Graph::default(), stack: Vec::new(), bound: Vec::new(), spent: 0 };
    expansion.run(steps)?;
    let value = expansion.pop();
    Ok((expansion.graph, value))
}

struct Expansion {
    graph: Graph,
    stack: Vec<NodeId>,
    /// Values of the running variables, outermost first.
    bound: Vec<NodeId>,
    spent: usize,
}

impl Expansion {
    fn run(&mut self, steps: &[Step]) -> Result<()> {
        let mut at = 0;
        while at < steps.len() {
            self.spend()?;
            let step = steps[at];
            at += 1;
            if let Step::Loop { kind, body, positions } = step {
                self.repeat(kind, &steps[at..at + body], positions)?;
                at += body;
            } else if let Step::Special(special, arguments, position) = step {
                self.special(special, arguments, position)?;
            } else {
                self.step(step);
            }
        }
        Ok(())
    }

    fn spend(&mut self) -> Result<()> {
        self.spent += 1;
        if self.spent > MOST_OPERATIONS {
            return Err(Error::FormulaTooLarge { what: "operations", limit: MOST_OPERATIONS });
        }
        Ok(())
    }

    /// The parser pushes an operand for every one that is popped.
    fn pop(&mut self) -> NodeId {
        self.stack.pop().unwrap_or_default()
    }

    fn step(&mut self, step: Step) {
        let node = match step {
            Step::Constant(value) => self.graph.constant(value),
            Step::Variable => self.graph.variable(),
            Step::Parameter(index) => self.graph.parameter(index),
            Step::Bound(slot) => self.bound[slot],
            Step::Unary(operation) => {
                let a = self.pop();
                self.graph.unary(operation, a)
            }
            Step::Binary(operation) => {
                let (b, a) = (self.pop(), self.pop());
                self.graph.binary(operation, a, b)
            }
            Step::Call(call, arguments) => self.call(call, arguments),
            Step::Loop { .. } | Step::Special(..) => return,
        };
        self.stack.push(node);
    }

    fn call(&mut self, call: Call, arguments: usize) -> NodeId {
        // The last argument, if it is one that may be left out, or mod's second one.
        let branch = (arguments == call.arguments().1 && arguments > 1).then(|| self.pop());
        match call {
            Call::Unary(operation) => {
                let a = self.pop();
                self.graph.unary(operation, a)
            }
            Call::Log => {
                let a = self.pop();
                let log = self.graph.unary(Unary::Analytic(Analytic::Log), a);
                let Some(k) = branch else { return log };
                let turn = self.graph.constant(Complex64::new(0.0, TAU));
                let turns = self.graph.binary(Binary::Multiply, turn, k);
                self.graph.binary(Binary::Add, log, turns)
            }
            Call::LogTen => {
                let a = self.pop();
                let log = self.graph.unary(Unary::Analytic(Analytic::Log), a);
                let ten = self.graph.constant(LN_10.into());
                self.graph.binary(Binary::Divide, log, ten)
            }
            Call::Modulo => {
                let a = self.pop();
                let quotient = self.graph.binary(Binary::Divide, a, branch.unwrap_or(a));
                let whole = self.graph.unary(Unary::Analytic(Analytic::Floor), quotient);
                let taken = self.graph.binary(Binary::Multiply, whole, branch.unwrap_or(a));
                self.graph.binary(Binary::Subtract, a, taken)
            }
            Call::Sqrt => {
                let a = self.pop();
                let root = self.graph.unary(Unary::Analytic(Analytic::Sqrt), a);
                self.turned(root, branch)
            }
            Call::Power => {
                let (exponent, base) = (self.pop(), self.pop());
                let power = self.graph.binary(Binary::Power, base, exponent);
                let half_turns = branch.map(|k| {
                    let twice = self.graph.binary(Binary::Add, exponent, exponent);
                    self.graph.binary(Binary::Multiply, twice, k)
                });
                self.turned(power, half_turns)
            }
            // These are steps of their own.
            Call::Loop(_) | Call::Special(_) => self.pop(),
        }
    }

    /// A function whose parameter must not depend on z; it is 0 where it is left out.
    fn special(&mut self, special: Special, arguments: usize, position: usize) -> Result<()> {
        let last = if arguments == 1 { self.graph.constant(Complex64::ZERO) } else { self.pop() };
        let first = self.pop();
        let (parameter, variable) = if special.place_of_parameter() == 0 { (first, last) } else { (last, first) };
        let refused = |found| Err(Error::Syntax { position, expected: special.expected().into(), found });
        match self.graph.constant_at(parameter) {
            Some(value) if !special.accepts(value) => return refused(format!("{value}")),
            None if self.graph.depends_on_variable(parameter) => return refused("a varying value".into()),
            _ => {}
        }
        let node = self.graph.binary(Binary::Special(special), parameter, variable);
        self.stack.push(node);
        Ok(())
    }

    /// value · e^{iπ·half_turns}
    fn turned(&mut self, value: NodeId, half_turns: Option<NodeId>) -> NodeId {
        let Some(half_turns) = half_turns else { return value };
        let turn = self.graph.unary(Unary::Analytic(Analytic::CisPi), half_turns);
        self.graph.binary(Binary::Multiply, value, turn)
    }

    fn repeat(&mut self, kind: Loop, body: &[Step], positions: [usize; 2]) -> Result<()> {
        let (second, first) = (self.pop(), self.pop());
        let value = match kind {
            Loop::Iterate => {
                let count = self.whole(second, positions[1])?;
                self.iterate(body, first, count)?
            }
            Loop::Sum | Loop::Product => {
                let (from, to) = (self.whole(first, positions[0])?, self.whole(second, positions[1])?);
                self.accumulate(kind, body, from, to)?
            }
        };
        self.stack.push(value);
        Ok(())
    }

    fn iterate(&mut self, body: &[Step], start: NodeId, count: i64) -> Result<NodeId> {
        let mut value = start;
        for _ in 0..count {
            value = self.round(body, value)?;
        }
        Ok(value)
    }

    fn accumulate(&mut self, kind: Loop, body: &[Step], from: i64, to: i64) -> Result<NodeId> {
        let (operation, neutral) = match kind {
            Loop::Product => (Binary::Multiply, 1.0),
            _ => (Binary::Add, 0.0),
        };
        let mut total = self.graph.constant(neutral.into());
        for n in from..=to {
            let running = self.graph.constant((n as f64).into());
            let term = self.round(body, running)?;
            total = self.graph.binary(operation, total, term);
        }
        Ok(total)
    }

    /// The body with the running variable at `value`.
    fn round(&mut self, body: &[Step], value: NodeId) -> Result<NodeId> {
        self.bound.push(value);
        self.run(body)?;
        self.bound.pop();
        Ok(self.pop())
    }

    /// A bound must be known when the loop is written out.
    fn whole(&self, node: NodeId, position: usize) -> Result<i64> {
        match self.graph.constant_at(node) {
            Some(value) if value.im == 0.0 && value.re.trunc() == value.re && value.re.abs() < MOST_WHOLE => {
                Ok(value.re as i64)
            }
            found => Err(Error::Syntax {
                position,
                expected: "a whole number that depends neither on z nor on a parameter".into(),
                found: found.map_or("a varying value".into(), |value| format!("{value}")),
            }),
        }
    }
}
