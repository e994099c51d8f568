//! An expression as a graph: equal subexpressions are one node, constants are folded as it grows.

use super::external::Callee;
use super::number::{Binary, Number, Unary};
use super::recursion::Itself;
use std::collections::HashMap;

/// A node of an [`Expression`]; what it depends on has smaller numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(u32);

impl Node {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Term {
    /// The bits of a number.
    Constant(u64),
    Parameter(u32),
    /// The counter of a `sum` or `prod`, by the loop's number.
    Counter(u32),
    Unary(Unary, Node),
    /// A whole power found by multiplications.
    Power(Node, i32),
    Binary(Binary, Node, Node),
    /// One of three by the sign of the first: negative, zero, positive.
    Choice(Node, [Node; 3]),
    Loop {
        product: bool,
        counter: u32,
        from: Node,
        to: Node,
        body: Node,
    },
    /// `callees[callee]`.
    Call {
        callee: u32,
        arguments: Box<[Node]>,
    },
    /// A component of a vector-valued call.
    Component(Node, u8),
}

/// A function's body.
#[derive(Clone, Debug, Default)]
pub struct Expression {
    pub(super) terms: Vec<Term>,
    pub(super) callees: Vec<Callee>,
    pub(super) root: Option<Node>,
    numbers: HashMap<Term, Node>,
    loops: u32,
}

/// Longest expression, in nodes, that a copied callee may make.
const LARGEST_COPY: usize = 4096;

impl Expression {
    pub fn constant(&mut self, value: f64) -> Node {
        self.node(Term::Constant(value.to_bits()))
    }

    pub fn parameter(&mut self, index: usize) -> Node {
        self.node(Term::Parameter(index as u32))
    }

    pub fn unary(&mut self, f: Unary, a: Node) -> Node {
        match self.value(a) {
            Some(v) => self.constant(v.unary(f)),
            None => self.node(Term::Unary(f, a)),
        }
    }

    pub fn binary(&mut self, f: Binary, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b)) {
            (Some(v), Some(w)) => return self.constant(v.binary(f, w)),
            (None, Some(w)) => {
                if let Some(simpler) = self.with_constant(f, a, w) {
                    return simpler;
                }
            }
            _ => {}
        }
        if f == Binary::Mul && a == b {
            return self.unary(Unary::Square, a);
        }
        self.node(Term::Binary(f, a, b))
    }

    /// Shorter forms of operations with a constant on the right.
    fn with_constant(&mut self, f: Binary, a: Node, k: f64) -> Option<Node> {
        match f {
            Binary::Mul | Binary::Div | Binary::Pow if k == 1.0 => Some(a),
            Binary::Mul if k == -1.0 => Some(self.unary(Unary::Neg, a)),
            Binary::Sub if k == 0.0 && k.is_sign_positive() => Some(a),
            Binary::Sub => {
                let negated = self.constant(-k);
                Some(self.node(Term::Binary(Binary::Add, a, negated)))
            }
            Binary::Div => {
                let reciprocal = self.constant(1.0 / k);
                Some(self.node(Term::Binary(Binary::Mul, a, reciprocal)))
            }
            Binary::Pow if k == 0.0 => Some(self.constant(1.0)),
            Binary::Pow if k == 2.0 => Some(self.unary(Unary::Square, a)),
            Binary::Pow if (3.0..=8.0).contains(&k) && k.trunc() == k => {
                Some(self.node(Term::Power(a, k as i32)))
            }
            _ => None,
        }
    }

    pub fn choice(&mut self, test: Node, branches: [Node; 3]) -> Node {
        let [negative, zero, positive] = branches;
        if negative == zero && zero == positive {
            return zero;
        }
        match self.value(test) {
            Some(v) if v < 0.0 => negative,
            Some(0.0) => zero,
            Some(_) => positive,
            None => self.node(Term::Choice(test, branches)),
        }
    }

    /// A new counter for a `sum` or `prod`.
    pub fn counter(&mut self) -> Node {
        self.loops += 1;
        self.node(Term::Counter(self.loops - 1))
    }

    /// The sum or product of `body` for `counter` = `from`, `from` + 1, … while not above `to`.
    pub fn fold(&mut self, product: bool, counter: Node, range: [Node; 2], body: Node) -> Node {
        let Term::Counter(counter) = self.terms[counter.index()] else {
            unreachable!("only a counter is counted");
        };
        self.node(Term::Loop { product, counter, from: range[0], to: range[1], body })
    }

    pub fn component(&mut self, call: Node, index: u8) -> Node {
        self.node(Term::Component(call, index))
    }

    pub(super) fn call(&mut self, callee: Callee, arguments: &[Node]) -> Node {
        let same = |c: &Callee| match (c, &callee) {
            (Callee::Internal(a), Callee::Internal(b)) => a.number() == b.number(),
            (Callee::Function(a), Callee::Function(b)) => std::sync::Arc::ptr_eq(a, b),
            (Callee::Field(a), Callee::Field(b)) => std::sync::Arc::ptr_eq(a, b),
            (Callee::Vector(a), Callee::Vector(b)) => std::sync::Arc::ptr_eq(a, b),
            (Callee::Itself(_), Callee::Itself(_)) => true,
            _ => false,
        };
        let index = self.callees.iter().position(same).unwrap_or_else(|| {
            self.callees.push(callee);
            self.callees.len() - 1
        });
        self.node(Term::Call { callee: index as u32, arguments: arguments.into() })
    }

    /// A call of the function that the expression is the body of.
    pub fn call_itself(&mut self, arguments: &[Node]) -> Node {
        let known = self.callees.iter().find(|c| matches!(c, Callee::Itself(_))).cloned();
        self.call(known.unwrap_or_else(|| Callee::Itself(Itself::default())), arguments)
    }

    /// Copies another function's body with these arguments; `None` if that would make too long an
    /// expression.
    pub(super) fn inline(&mut self, body: &Expression, arguments: &[Node]) -> Option<Node> {
        let root = body.root?;
        if self.terms.len() + root.index() > LARGEST_COPY {
            return None;
        }
        let first_loop = self.loops;
        self.loops += body.loops;
        let mut copies: Vec<Node> = Vec::with_capacity(root.index() + 1);
        for term in &body.terms[..=root.index()] {
            let at = |n: &Node| copies[n.index()];
            let copy = match term {
                Term::Constant(bits) => self.node(Term::Constant(*bits)),
                Term::Parameter(index) => arguments[*index as usize],
                Term::Counter(number) => self.node(Term::Counter(first_loop + number)),
                Term::Unary(f, a) => self.unary(*f, at(a)),
                Term::Power(a, n) => match self.value(at(a)) {
                    Some(v) => self.constant(v.powi(*n)),
                    None => self.node(Term::Power(at(a), *n)),
                },
                Term::Binary(f, a, b) => self.binary(*f, at(a), at(b)),
                Term::Choice(test, branches) => self.choice(at(test), branches.map(|b| at(&b))),
                Term::Loop { product, counter, from, to, body } => self.node(Term::Loop {
                    product: *product,
                    counter: first_loop + counter,
                    from: at(from),
                    to: at(to),
                    body: at(body),
                }),
                Term::Call { callee, arguments } => {
                    let arguments: Vec<Node> = arguments.iter().map(at).collect();
                    self.call(body.callees[*callee as usize].clone(), &arguments)
                }
                Term::Component(call, index) => self.component(at(call), *index),
            };
            copies.push(copy);
        }
        copies.last().copied()
    }

    /// The number that a node always stands for.
    pub fn value(&self, node: Node) -> Option<f64> {
        match self.terms[node.index()] {
            Term::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    fn node(&mut self, term: Term) -> Node {
        if let Some(&node) = self.numbers.get(&term) {
            return node;
        }
        let node = Node(self.terms.len() as u32);
        self.terms.push(term.clone());
        self.numbers.insert(term, node);
        node
    }

    /// Makes `root` the value of the whole; nothing more can be added.
    pub(super) fn finish(&mut self, root: Node) {
        self.root = Some(root);
        self.numbers = HashMap::new();
    }
}

impl Term {
    /// What this needs first, in the order of evaluation.
    pub(super) fn operands(&self) -> smallvec::SmallVec<[Node; 4]> {
        match self {
            Term::Constant(_) | Term::Parameter(_) | Term::Counter(_) => smallvec::smallvec![],
            Term::Unary(_, a) | Term::Power(a, _) | Term::Component(a, _) => smallvec::smallvec![*a],
            Term::Binary(_, a, b) => smallvec::smallvec![*a, *b],
            Term::Choice(test, [a, b, c]) => smallvec::smallvec![*test, *a, *b, *c],
            Term::Loop { from, to, body, .. } => smallvec::smallvec![*from, *to, *body],
            Term::Call { arguments, .. } => arguments.iter().copied().collect(),
        }
    }
}
