//! User functions: `function { … }`.
//!
//! The grammar builds an [`Expression`]; that is compiled once to a [`program::Program`], which runs on
//! numbers and on ranges of numbers ([`Interval`]).

mod compile;
mod expr;
mod external;
mod image;
mod internal;
mod interval;
mod number;
pub mod patience;
mod program;
mod recursion;
mod slope;
mod surroundings;

pub use expr::{Expression, Node};
pub use external::{VectorFunction, VectorKind};
pub use image::FunctionImage;
pub use internal::Internal;
pub use interval::Interval;
pub use number::{Binary, Number, Unary};
pub use recursion::{LARGEST_RECURSION, went_too_deep};
pub use slope::Slope;
pub use surroundings::Surroundings;

use crate::color::Color;
use crate::math::field::{Enclosure, Field};
use crate::math::{Aabb, Vec3};
use compile::{Choices, compile};
use external::Callee;
use program::Program;
use recursion::Itself;
use std::sync::Arc;

/// A function of the scene language.
#[derive(Clone, Debug)]
pub struct Function {
    arity: usize,
    body: Body,
}

#[derive(Clone, Debug)]
enum Body {
    Expression(Arc<Compiled>),
    Callee(Callee),
}

#[derive(Debug)]
struct Compiled {
    expression: Expression,
    on_numbers: Program,
    on_ranges: Program,
    /// How many functions call each other below this one.
    depth: u32,
}

impl Compiled {
    /// The function's name for itself, if it calls itself.
    fn itself(&self) -> Option<&Itself> {
        self.expression.callees.iter().find_map(|c| match c {
            Callee::Itself(itself) => Some(itself),
            _ => None,
        })
    }
}

/// What a call gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FunctionValue {
    Float(f64),
    /// The number of components, 2 to 5, and the components.
    Vector(u8, [f64; 5]),
    Color(Color),
}

/// Why an expression cannot be compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TooComplex {
    /// More intermediate values than the largest register file holds.
    Values,
    /// More functions calling each other than the stack allows.
    Depth,
}

/// Most functions that call each other, each too long to be copied into its caller.
const LARGEST_DEPTH: u32 = 64;

impl Function {
    /// The function of `arity` parameters with the value `root`.
    pub fn new(mut expression: Expression, root: Node, arity: usize) -> Result<Self, TooComplex> {
        expression.finish(root);
        let depth = 1 + expression.callees.iter().map(Callee::depth).max().unwrap_or(0);
        if depth > LARGEST_DEPTH {
            return Err(TooComplex::Depth);
        }
        let on_numbers = compile(&expression, arity, Choices::Jumps).ok_or(TooComplex::Values)?;
        let on_ranges = compile(&expression, arity, Choices::All).ok_or(TooComplex::Values)?;
        let compiled = Arc::new(Compiled { expression, on_numbers, on_ranges, depth });
        if let Some(itself) = compiled.itself() {
            itself.is(&compiled);
        }
        Ok(Self { arity, body: Body::Expression(compiled) })
    }

    pub fn from_internal(internal: Internal) -> Self {
        Self { arity: internal.arity(), body: Body::Callee(Callee::Internal(internal)) }
    }

    /// A function of a point.
    pub fn from_field(field: Arc<dyn Field>) -> Self {
        Self { arity: 3, body: Body::Callee(Callee::Field(field)) }
    }

    pub fn from_vector(function: Arc<dyn VectorFunction>) -> Self {
        Self { arity: function.arity(), body: Body::Callee(Callee::Vector(function)) }
    }

    /// The number of arguments.
    pub fn arity(&self) -> usize {
        self.arity
    }

    /// What kind of vector the value is; `None` if it is a number.
    pub fn vector_kind(&self) -> Option<VectorKind> {
        match &self.body {
            Body::Callee(Callee::Vector(v)) => Some(v.kind()),
            _ => None,
        }
    }

    /// The value for as many arguments as [`Function::arity`] says.
    pub fn call(&self, arguments: &[f64]) -> FunctionValue {
        match &self.body {
            Body::Callee(Callee::Vector(v)) => match v.kind() {
                VectorKind::Vector(n) => FunctionValue::Vector(n, v.value(arguments)),
                VectorKind::Color => {
                    FunctionValue::Color(Color::from_components(v.value(arguments).map(|c| c as f32)))
                }
            },
            _ => FunctionValue::Float(self.number(arguments)),
        }
    }

    /// The value of a function that gives numbers; a vector's first component.
    #[inline]
    pub fn number<N: Number>(&self, arguments: &[N]) -> N {
        match &self.body {
            Body::Expression(compiled) if N::RANGES => compiled.on_ranges.run(arguments),
            Body::Expression(compiled) => compiled.on_numbers.run(arguments),
            Body::Callee(callee) => callee.number(arguments),
        }
    }

    /// How many functions and what they call stand within each other.
    pub fn depth(&self) -> u32 {
        match &self.body {
            Body::Expression(compiled) => compiled.depth,
            Body::Callee(callee) => callee.depth(),
        }
    }

    /// A call within another function's expression. For vectors, of the whole: take a component of it.
    pub fn call_in(self: &Arc<Self>, expression: &mut Expression, arguments: &[Node]) -> Node {
        match &self.body {
            Body::Callee(callee) => expression.call(callee.clone(), arguments),
            Body::Expression(compiled) if compiled.itself().is_some() => {
                expression.call(Callee::Function(self.clone()), arguments)
            }
            Body::Expression(compiled) => match expression.inline(&compiled.expression, arguments) {
                Some(node) => node,
                None => expression.call(Callee::Function(self.clone()), arguments),
            },
        }
    }
}

/// A function of a point gives a number everywhere.
impl Field for Function {
    fn value(&self, p: Vec3) -> f64 {
        self.number(&p.to_array())
    }

    fn depth(&self) -> u32 {
        Function::depth(self)
    }

    fn range(&self, b: &Aabb) -> Option<(f64, f64)> {
        let sides: [Interval; 3] = std::array::from_fn(|i| Interval::new(b.min[i], b.max[i]));
        let range = self.number(&sides);
        (range != Interval::WHOLE).then_some((range.lo, range.hi))
    }

    fn enclosure(&self, b: &Aabb) -> Option<Enclosure> {
        let coordinate = |i| Slope::coordinate(i, Interval::new(b.min[i], b.max[i]));
        let found = self.number(&[0, 1, 2].map(coordinate));
        let ends = |i: Interval| (i.lo, i.hi);
        Some(Enclosure { range: ends(found.value), gradient: found.by.map(ends) })
    }
}

#[cfg(test)]
mod tests;
