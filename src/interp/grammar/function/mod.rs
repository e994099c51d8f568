//! `function { … }`: user functions, their calls, and the bodies that other statements contain.

mod operand;
mod word;

use super::pattern::Place;
use crate::function::{
    Expression, Function, FunctionImage, FunctionValue, Internal, Node, TooComplex, VectorKind,
};
use crate::interp::{Parser, Result, Value};
use crate::material::PigmentField;
use crate::math::field::Field;
use crate::pattern::{PatternField, Signal};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Tok};
use std::sync::Arc;

/// Most parameters of a function.
const LARGEST_ARITY: usize = 55;

/// Largest side of a picture made by a function.
const LARGEST_SIDE: f64 = 32_768.0;

/// About what a sample of such a picture takes while it is made.
const BYTES_PER_TEXEL: u64 = 16;

/// A name that stands for an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Name {
    Identifier(Symbol),
    /// x and u are one, and so are y and v.
    Coordinate(usize),
}

/// A function's body while it is read.
struct Body {
    expression: Expression,
    parameters: Vec<Name>,
    /// Counters of the sums and products around, the innermost last.
    counters: Vec<(Name, Node)>,
    nesting: usize,
    /// The name that is being declared.
    itself: Option<Symbol>,
}

/// Part of an expression.
#[derive(Clone, Copy)]
struct Operand {
    node: Node,
    /// A single number or name of one, without parentheses.
    bare: bool,
}

impl Operand {
    fn new(node: Node) -> Self {
        Self { node, bare: false }
    }
}

impl Parser {
    /// `function [(a, b, …)] { … }`; the word is the next token.
    pub(crate) fn function_statement(&mut self) -> Result<Value> {
        let word = self.expect(Keyword::Function)?;
        let itself = self.declaring.take();
        let parameters = match self.peek()?.tok {
            Tok::Punct(Punct::LeftParen) => Some(self.parameter_list()?),
            _ => None,
        };
        self.function_braces(parameters, itself, word.span).map(Value::Function)
    }

    /// `{ … }` with an expression in x, y and z; the brace is the next token.
    pub(crate) fn function_body_xyz(&mut self) -> Result<Arc<dyn Field>> {
        let open = self.expect_punct(Punct::LeftBrace)?;
        let function: Arc<dyn Field> = self.expression_function(coordinates(), None, open.span)?;
        self.expect_punct(Punct::RightBrace)?;
        Ok(function)
    }

    /// `function W, H { … }` in place of an image file; the word is the next token.
    pub(crate) fn function_image(&mut self) -> Result<FunctionImage> {
        let word = self.expect(Keyword::Function)?;
        let width = self.float()?;
        self.comma()?;
        let height = self.float()?;
        let span = word.span.to(self.peek()?.span);
        let function = self.function_braces(None, None, word.span)?;
        let side = |v: f64| v.clamp(1.0, LARGEST_SIDE) as u32;
        self.reserve(BYTES_PER_TEXEL * u64::from(side(width)) * u64::from(side(height)), span)?;
        if !matches!(function.vector_kind(), None | Some(VectorKind::Color)) || function.arity() != 3 {
            let message = "a picture cannot be made of this kind of function";
            let error = Diagnostic::error(span, message)
                .with_hint("use an expression in x, y and z, or `pattern { … }` or `pigment { … }`");
            return Err(Box::new(error));
        }
        Ok(FunctionImage { width: side(width), height: side(height), function })
    }

    fn function_braces(
        &mut self,
        parameters: Option<Vec<Name>>,
        itself: Option<Symbol>,
        word: Span,
    ) -> Result<Arc<Function>> {
        let open = self.expect_punct(Punct::LeftBrace)?;
        let kind = self.peek()?;
        let function = match kind.tok {
            Tok::Word(Keyword::Internal) => self.internal_function()?,
            Tok::Word(
                special @ (Keyword::Pattern | Keyword::Pigment | Keyword::Transform | Keyword::Spline),
            ) => {
                if parameters.is_some() {
                    let message = format!("a `{}` function has no list of parameters", special.text());
                    let error = Diagnostic::error(word.to(open.span), message).with_hint("leave it out");
                    return Err(Box::new(error));
                }
                Arc::new(self.special_function(special)?)
            }
            _ => self.expression_function(parameters.unwrap_or_else(coordinates), itself, open.span)?,
        };
        self.expect_punct(Punct::RightBrace)?;
        Ok(function)
    }

    /// `(a, b, …)`: undeclared names, or x, y, z, u, v.
    fn parameter_list(&mut self) -> Result<Vec<Name>> {
        self.expect_punct(Punct::LeftParen)?;
        let mut names = Vec::new();
        loop {
            names.push(self.parameter_name("the name of a parameter")?);
            let next = self.peek()?;
            if names.len() > LARGEST_ARITY {
                let message = format!("a function has at most {LARGEST_ARITY} parameters");
                return Err(Box::new(Diagnostic::error(next.span, message)));
            }
            self.comma()?;
            if next.tok == Tok::Punct(Punct::RightParen) {
                self.next()?;
                return Ok(names);
            }
        }
    }

    fn parameter_name(&mut self, expected: &str) -> Result<Name> {
        let token = self.peek()?;
        let name = match token.tok {
            Tok::Word(word) => coordinate(word),
            Tok::Identifier(symbol) => {
                if let Some(value) = self.peek_value()? {
                    let message =
                        format!("`{}` is a {} already, not a new name", self.name(symbol), value.kind());
                    let error = Diagnostic::error(token.span, message)
                        .with_hint("choose a name that is not declared outside the function");
                    return Err(Box::new(error));
                }
                Some(Name::Identifier(symbol))
            }
            _ => None,
        };
        let Some(name) = name else { return Err(self.unexpected(expected)) };
        self.next()?;
        Ok(name)
    }

    /// `internal(n)`.
    fn internal_function(&mut self) -> Result<Arc<Function>> {
        let word = self.next()?;
        self.expect_punct(Punct::LeftParen)?;
        let number = self.float()?;
        let close = self.expect_punct(Punct::RightParen)?;
        let internal = Internal::new(number as u32, &self.scene.surroundings).filter(|_| number >= 0.0);
        let Some(internal) = internal else {
            let message = format!("there is no internal function {number}");
            let error = Diagnostic::error(word.span.to(close.span), message)
                .with_hint("they are numbered from 0 to 76, and 78");
            return Err(Box::new(error));
        };
        Ok(Arc::new(Function::from_internal(internal)))
    }

    fn special_function(&mut self, word: Keyword) -> Result<Function> {
        let surroundings = self.scene.surroundings.clone();
        let start = self.peek()?.span;
        let function = match word {
            Keyword::Pattern => {
                let signal = self.pattern_function()?;
                Function::from_field(Arc::new(PatternField { signal, surroundings }))
            }
            Keyword::Pigment => {
                let pigment = self.pigment_statement()?;
                Function::from_vector(Arc::new(PigmentField { pigment, surroundings }))
            }
            Keyword::Transform => Function::from_vector(Arc::new(self.transform_statement()?)),
            _ => Function::from_vector(self.spline()?),
        };
        self.check_depth(function.depth(), start)?;
        Ok(function)
    }

    /// `pattern { … }`.
    fn pattern_function(&mut self) -> Result<Signal> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut signal = Signal::default();
        match self.pattern(Place::Function)? {
            Some(pattern) => signal.set_pattern(pattern),
            None => return Err(self.unexpected("a pattern")),
        }
        while self.signal_modifier(&mut signal)? {}
        self.expect_punct(Punct::RightBrace)?;
        Ok(signal)
    }

    fn expression_function(
        &mut self,
        parameters: Vec<Name>,
        itself: Option<Symbol>,
        open: Span,
    ) -> Result<Arc<Function>> {
        let arity = parameters.len();
        let mut body =
            Body { expression: Expression::default(), parameters, counters: Vec::new(), nesting: 0, itself };
        let root = self.function_expression(&mut body)?;
        let span = open.to(self.peek()?.span);
        let function = Function::new(body.expression, root.node, arity).map_err(|why| {
            let message = match why {
                TooComplex::Values => "this function keeps too many intermediate values",
                TooComplex::Depth => "this function calls functions that call functions too many levels deep",
            };
            Box::new(Diagnostic::error(span, message).with_hint("split it, or declare parts as numbers"))
        })?;
        Ok(Arc::new(function))
    }
}

/// Calls in scene expressions.
impl Parser {
    /// The value of a function's or spline's call: `(` comes next, `called` is the identifier's value.
    pub(crate) fn call(&mut self, called: &Value) -> Result<Value> {
        match called {
            Value::Function(function) => self.call_function(function),
            Value::Spline(spline) => self.call_spline(spline),
            _ => Err(self.unexpected("a function or a spline")),
        }
    }

    fn call_function(&mut self, function: &Arc<Function>) -> Result<Value> {
        self.expect_punct(Punct::LeftParen)?;
        let mut arguments = smallvec::SmallVec::<[f64; 8]>::new();
        for i in 0..function.arity() {
            if i > 0 {
                self.comma()?;
            }
            if self.peek()?.tok == Tok::Punct(Punct::RightParen) {
                let message = format!("another argument: this function has {} parameters", function.arity());
                return Err(self.unexpected(&message));
            }
            arguments.push(self.float()?);
        }
        self.expect_punct(Punct::RightParen)?;
        self.settle_surroundings();
        let value = function.call(&arguments);
        self.check_functions()?;
        Ok(match value {
            FunctionValue::Float(v) => Value::Float(v),
            FunctionValue::Vector(n, v) => Value::Vector(n, v),
            FunctionValue::Color(c) => Value::Color(c),
        })
    }
}

impl Body {
    fn knows(&self, name: Name) -> bool {
        self.parameters.contains(&name) || self.counters.iter().any(|c| c.0 == name)
    }

    /// The parameter or counter of this name. Parameters go first; of equal names the first, of coordinates
    /// the last.
    fn argument(&mut self, name: Name) -> Option<Node> {
        let index = match name {
            Name::Identifier(_) => self.parameters.iter().position(|p| *p == name),
            Name::Coordinate(_) => self.parameters.iter().rposition(|p| *p == name),
        };
        match index {
            Some(index) => Some(self.expression.parameter(index)),
            None => self.counters.iter().rev().find(|c| c.0 == name).map(|c| c.1),
        }
    }
}

/// The parameters of a function without a list.
fn coordinates() -> Vec<Name> {
    (0..3).map(Name::Coordinate).collect()
}

fn coordinate(word: Keyword) -> Option<Name> {
    Some(Name::Coordinate(match word {
        Keyword::X | Keyword::U => 0,
        Keyword::Y | Keyword::V => 1,
        Keyword::Z => 2,
        _ => return None,
    }))
}
