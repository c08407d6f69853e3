//! Graph → flat program: what is fixed is computed once, what varies gets registers.

use super::graph::{Graph, Node, NodeId};
use super::operation::{Binary, Unary};
use crate::plane::Complex64;

/// Where an instruction finds an operand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// The same value at all points: an index into the table of fixed values.
    Fixed(usize),
    /// One value a point: a register.
    Register(usize),
}

/// An operation on registers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// f(register).
    Unary(Unary, usize),
    /// a ∘ b, at least one of them a register.
    Binary(Binary, Source, Source),
}

/// An operation and the register that receives its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instruction {
    /// What to compute.
    pub operation: Operation,
    /// Where to put it; may be the register of an operand.
    pub target: usize,
}

/// A compiled formula. z is in register 0 when it starts.
#[derive(Clone, Debug)]
pub struct Program {
    /// Nodes that do not depend on z, their operands being indices into this list.
    fixed: Vec<Node>,
    /// The instructions, in order.
    pub code: Vec<Instruction>,
    /// Number of registers.
    pub registers: usize,
    /// Where the result is.
    pub result: Source,
    /// Whether only analytic operations are applied to what depends on z.
    pub is_analytic: bool,
}

impl Program {
    /// Compiles the part of `graph` that `result` needs.
    pub fn new(graph: &Graph, result: NodeId) -> Self {
        let needed = needed(graph, result);
        let last_use = last_uses(graph, &needed, result);
        let mut compiler = Compiler {
            program: Self {
                fixed: Vec::new(),
                code: Vec::new(),
                registers: 1,
                result: Source::Register(0),
                is_analytic: true,
            },
            places: vec![None; graph.nodes().len()],
            free: Vec::new(),
            last_use,
        };
        for (id, &node) in graph.nodes().iter().enumerate().filter(|&(id, _)| needed[id]) {
            compiler.place(id, node);
        }
        compiler.program.result = compiler.source(result);
        compiler.program
    }

    /// The values of everything that does not depend on z, for given parameters.
    pub fn bind(&self, parameters: &[Complex64]) -> Vec<Complex64> {
        let mut values: Vec<Complex64> = Vec::with_capacity(self.fixed.len());
        for &node in &self.fixed {
            let value = match node {
                Node::Variable => Complex64::ZERO,
                Node::Constant(re, im) => Complex64::new(f64::from_bits(re), f64::from_bits(im)),
                Node::Parameter(index) => parameters[index],
                Node::Unary(operation, a) => operation.value(values[a]),
                Node::Binary(operation, a, b) => operation.value(values[a], values[b]),
            };
            values.push(value);
        }
        values
    }
}

/// Which nodes the result depends on.
fn needed(graph: &Graph, result: NodeId) -> Vec<bool> {
    let mut needed = vec![false; graph.nodes().len()];
    needed[result] = true;
    for (id, &node) in graph.nodes().iter().enumerate().rev() {
        if needed[id] {
            operands(node).for_each(|operand| needed[operand] = true);
        }
    }
    needed
}

/// The last node that uses each node; the result is used by the caller.
fn last_uses(graph: &Graph, needed: &[bool], result: NodeId) -> Vec<NodeId> {
    let mut last: Vec<NodeId> = (0..graph.nodes().len()).collect();
    for (id, &node) in graph.nodes().iter().enumerate().filter(|&(id, _)| needed[id]) {
        operands(node).for_each(|operand| last[operand] = id);
    }
    last[result] = NodeId::MAX;
    last
}

fn operands(node: Node) -> impl Iterator<Item = NodeId> {
    let [a, b] = match node {
        Node::Unary(_, a) => [Some(a), None],
        Node::Binary(_, a, b) => [Some(a), Some(b)],
        _ => [None, None],
    };
    a.into_iter().chain(b)
}

struct Compiler {
    program: Program,
    places: Vec<Option<Source>>,
    free: Vec<usize>,
    last_use: Vec<NodeId>,
}

impl Compiler {
    /// Operands are placed before their users.
    fn source(&self, id: NodeId) -> Source {
        self.places[id].unwrap_or(Source::Register(0))
    }

    fn place(&mut self, id: NodeId, node: Node) {
        let place = match node {
            Node::Variable => Source::Register(0),
            Node::Constant(..) | Node::Parameter(_) => self.fix(node),
            Node::Unary(operation, a) => match self.source(a) {
                Source::Fixed(a) => self.fix(Node::Unary(operation, a)),
                Source::Register(register) => {
                    self.program.is_analytic &= operation.is_analytic();
                    self.emit(id, node, Operation::Unary(operation, register))
                }
            },
            Node::Binary(operation, a, b) => match (self.source(a), self.source(b)) {
                (Source::Fixed(a), Source::Fixed(b)) => self.fix(Node::Binary(operation, a, b)),
                (a, b) => self.emit(id, node, Operation::Binary(operation, a, b)),
            },
        };
        self.places[id] = Some(place);
    }

    fn fix(&mut self, node: Node) -> Source {
        self.program.fixed.push(node);
        Source::Fixed(self.program.fixed.len() - 1)
    }

    /// Appends an instruction. Registers that nobody reads afterwards become free before the target is chosen.
    fn emit(&mut self, id: NodeId, node: Node, operation: Operation) -> Source {
        for operand in operands(node).filter(|&operand| self.last_use[operand] == id) {
            if let Source::Register(register) = self.source(operand)
                && !self.free.contains(&register)
            {
                self.free.push(register);
            }
        }
        let target = self.free.pop().unwrap_or_else(|| {
            self.program.registers += 1;
            self.program.registers - 1
        });
        self.program.code.push(Instruction { operation, target });
        Source::Register(target)
    }
}
