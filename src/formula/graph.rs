//! The formula as a graph of operations in which every value is computed once.

use super::functions::LARGEST_MULTIPLIED_EXPONENT;
use super::operation::{Analytic, Binary, Unary};
use crate::plane::Complex64;
use std::collections::BTreeMap;

/// Index of a node; operands come before the operations that use them.
pub type NodeId = usize;

/// A value in the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Node {
    /// z.
    Variable,
    /// A number, as the bits of its parts.
    Constant(u64, u64),
    /// A parameter, by index.
    Parameter(usize),
    /// f(a).
    Unary(Unary, NodeId),
    /// a ∘ b.
    Binary(Binary, NodeId, NodeId),
}

/// Builds the graph: equal subexpressions become one node, operations on numbers are done at once.
#[derive(Default)]
pub struct Graph {
    nodes: Vec<Node>,
    known: BTreeMap<Node, NodeId>,
    /// Whether each node depends on z.
    varies: Vec<bool>,
}

impl Graph {
    /// All nodes, operands first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The number that a node is, if it is one.
    pub fn constant_at(&self, id: NodeId) -> Option<Complex64> {
        match self.nodes[id] {
            Node::Constant(re, im) => Some(Complex64::new(f64::from_bits(re), f64::from_bits(im))),
            _ => None,
        }
    }

    /// Whether a node's value is another at another z.
    pub fn depends_on_variable(&self, id: NodeId) -> bool {
        self.varies[id]
    }

    /// The node of a number.
    pub fn constant(&mut self, value: Complex64) -> NodeId {
        self.node(Node::Constant(value.re.to_bits(), value.im.to_bits()))
    }

    /// The node of z.
    pub fn variable(&mut self) -> NodeId {
        self.node(Node::Variable)
    }

    /// The node of a parameter.
    pub fn parameter(&mut self, index: usize) -> NodeId {
        self.node(Node::Parameter(index))
    }

    /// f(a).
    pub fn unary(&mut self, operation: Unary, a: NodeId) -> NodeId {
        match self.constant_at(a) {
            Some(value) => self.constant(operation.value(value)),
            None => self.node(Node::Unary(operation, a)),
        }
    }

    /// a ∘ b.
    pub fn binary(&mut self, operation: Binary, a: NodeId, b: NodeId) -> NodeId {
        let (left, right) = (self.constant_at(a), self.constant_at(b));
        if let (Some(left), Some(right)) = (left, right) {
            return self.constant(operation.value(left, right));
        }
        let (zero, one) = (Some(Complex64::ZERO), Some(Complex64::ONE));
        match operation {
            Binary::Add if left == zero => b,
            Binary::Add | Binary::Subtract if right == zero => a,
            Binary::Multiply if left == one => b,
            Binary::Multiply | Binary::Divide if right == one => a,
            Binary::Power => self.power(a, b),
            _ if operation.commutes() && b < a => self.node(Node::Binary(operation, b, a)),
            _ => self.node(Node::Binary(operation, a, b)),
        }
    }

    /// a^b: products where b is a small whole number, exp where a is Euler's number.
    fn power(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if self.constant_at(a) == Some(std::f64::consts::E.into()) {
            return self.unary(Unary::Analytic(Analytic::Exp), b);
        }
        match self.constant_at(b) {
            Some(n) if n.im == 0.0 && n.re.trunc() == n.re && n.re.abs() <= LARGEST_MULTIPLIED_EXPONENT => {
                self.whole_power(a, n.re)
            }
            Some(half) if half == Complex64::new(0.5, 0.0) => self.unary(Unary::Analytic(Analytic::Sqrt), a),
            _ => self.node(Node::Binary(Binary::Power, a, b)),
        }
    }

    /// Repeated squaring; the squares are shared with other powers of the same base.
    fn whole_power(&mut self, a: NodeId, n: f64) -> NodeId {
        let mut left = n.abs() as u32;
        let mut product = None;
        let mut square = a;
        while left > 0 {
            if left & 1 == 1 {
                product = Some(product.map_or(square, |p| self.binary(Binary::Multiply, p, square)));
            }
            left >>= 1;
            if left > 0 {
                square = self.binary(Binary::Multiply, square, square);
            }
        }
        let one = self.constant(Complex64::ONE);
        let product = product.unwrap_or(one);
        if n < 0.0 { self.binary(Binary::Divide, one, product) } else { product }
    }

    fn node(&mut self, node: Node) -> NodeId {
        let next = self.nodes.len();
        let id = *self.known.entry(node).or_insert(next);
        if id == next {
            self.varies.push(match node {
                Node::Variable => true,
                Node::Constant(..) | Node::Parameter(_) => false,
                Node::Unary(_, a) => self.varies[a],
                Node::Binary(_, a, b) => self.varies[a] || self.varies[b],
            });
            self.nodes.push(node);
        }
        id
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_subexpressions_are_one_node() {
        let mut graph = Graph::default();
        let z = graph.variable();
        let (two, six) = (graph.constant(2.0.into()), graph.constant(6.0.into()));
        let square = graph.binary(Binary::Power, z, two);
        assert_eq!(square, graph.binary(Binary::Multiply, z, z));
        let sixth = graph.binary(Binary::Power, z, six);
        assert_eq!(graph.nodes()[sixth], Node::Binary(Binary::Multiply, square, sixth - 1));
        let sum = graph.binary(Binary::Add, sixth, square);
        assert_eq!(sum, graph.binary(Binary::Add, square, sixth));
    }

    #[test]
    fn numbers_are_folded() {
        let mut graph = Graph::default();
        let (a, b) = (graph.constant(3.0.into()), graph.constant(4.0.into()));
        let quotient = graph.binary(Binary::Divide, a, b);
        assert_eq!(graph.constant_at(quotient), Some(0.75.into()));
        let root = graph.unary(Unary::Analytic(Analytic::Sqrt), b);
        assert_eq!(graph.constant_at(root), Some(2.0.into()));
    }
}
