//! `function { … }`: user functions, their calls, and the bodies that other statements contain.

use super::pattern::Place;
use crate::function::{
    Binary, Expression, Function, FunctionImage, FunctionValue, Internal, Node, TooComplex, Unary, VectorKind,
};
use crate::interp::{Parser, Result, Value};
use crate::material::PigmentField;
use crate::math::field::Field;
use crate::pattern::{PatternField, Signal};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Tok, Token};
use std::sync::Arc;

/// Most parameters of a function.
const LARGEST_ARITY: usize = 55;

/// Deepest nesting of parentheses and calls in an expression.
const LARGEST_NESTING: usize = 200;

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
        let parameters = match self.peek()?.tok {
            Tok::Punct(Punct::LeftParen) => Some(self.parameter_list()?),
            _ => None,
        };
        self.function_braces(parameters, word.span).map(Value::Function)
    }

    /// `{ … }` with an expression in x, y and z; the brace is the next token.
    pub(crate) fn function_body_xyz(&mut self) -> Result<Arc<dyn Field>> {
        let open = self.expect_punct(Punct::LeftBrace)?;
        let function: Arc<dyn Field> = self.expression_function(coordinates(), open.span)?;
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
        let function = self.function_braces(None, word.span)?;
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

    fn function_braces(&mut self, parameters: Option<Vec<Name>>, word: Span) -> Result<Arc<Function>> {
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
            _ => self.expression_function(parameters.unwrap_or_else(coordinates), open.span)?,
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
        Ok(match word {
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
        })
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

    fn expression_function(&mut self, parameters: Vec<Name>, open: Span) -> Result<Arc<Function>> {
        let arity = parameters.len();
        let mut body =
            Body { expression: Expression::default(), parameters, counters: Vec::new(), nesting: 0 };
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

/// Operators and operands, loosest first.
impl Parser {
    fn function_expression(&mut self, body: &mut Body) -> Result<Operand> {
        self.function_deeper(body)?;
        let value = self.left_to_right(body, &[(Punct::Or, Binary::Or)], Self::function_conjunction)?;
        body.nesting -= 1;
        Ok(value)
    }

    fn function_deeper(&mut self, body: &mut Body) -> Result<()> {
        body.nesting += 1;
        if body.nesting > LARGEST_NESTING {
            let span = self.peek()?.span;
            let message = format!("parentheses and calls are nested more than {LARGEST_NESTING} deep");
            return Err(Box::new(Diagnostic::error(span, message)));
        }
        Ok(())
    }

    fn function_conjunction(&mut self, body: &mut Body) -> Result<Operand> {
        self.left_to_right(body, &[(Punct::And, Binary::And)], Self::function_comparison)
    }

    /// Comparisons. In a chain the reference folds two constants at the end before it compares with what
    /// stands on their left: `a = 2 = 1` is `a = (2 = 1)`.
    fn function_comparison(&mut self, body: &mut Body) -> Result<Operand> {
        let mut left = self.function_sum(body)?;
        let mut last: Option<(Node, Binary, f64)> = None;
        while let Some(f) = self.accept_operator(&COMPARISONS)? {
            let right = self.function_sum(body)?;
            let constant = body.expression.value(right.node);
            let (a, f, b) = match (last, constant) {
                (Some((a, before, k)), Some(constant)) => {
                    let k = body.expression.constant(k);
                    let constant = body.expression.constant(constant);
                    (a, before, body.expression.binary(f, k, constant))
                }
                _ => (left.node, f, right.node),
            };
            left = Operand::new(body.expression.binary(f, a, b));
            last = body.expression.value(b).map(|k| (a, f, k));
        }
        Ok(left)
    }

    fn function_sum(&mut self, body: &mut Body) -> Result<Operand> {
        self.left_to_right(
            body,
            &[(Punct::Plus, Binary::Add), (Punct::Minus, Binary::Sub)],
            Self::function_product,
        )
    }

    fn function_product(&mut self, body: &mut Body) -> Result<Operand> {
        let mut left = self.function_signed(body)?;
        while let Some(f) =
            self.accept_operator(&[(Punct::Star, Binary::Mul), (Punct::Slash, Binary::Div)])?
        {
            let span = self.peek()?.span;
            let right = self.function_signed(body)?;
            if f == Binary::Div && right.bare && body.expression.value(right.node) == Some(0.0) {
                return Err(Box::new(Diagnostic::error(span, "division by zero")));
            }
            left = Operand::new(body.expression.binary(f, left.node, right.node));
        }
        Ok(left)
    }

    fn left_to_right(
        &mut self,
        body: &mut Body,
        operators: &[(Punct, Binary)],
        operand: fn(&mut Self, &mut Body) -> Result<Operand>,
    ) -> Result<Operand> {
        let mut left = operand(self, body)?;
        while let Some(f) = self.accept_operator(operators)? {
            let right = operand(self, body)?;
            left = Operand::new(body.expression.binary(f, left.node, right.node));
        }
        Ok(left)
    }

    fn accept_operator(&mut self, operators: &[(Punct, Binary)]) -> Result<Option<Binary>> {
        let Tok::Punct(punct) = self.peek()?.tok else { return Ok(None) };
        let Some(&(_, f)) = operators.iter().find(|o| o.0 == punct) else { return Ok(None) };
        self.next()?;
        Ok(Some(f))
    }

    /// An operand with at most one sign.
    fn function_signed(&mut self, body: &mut Body) -> Result<Operand> {
        if self.accept_punct(Punct::Minus)? {
            let operand = self.function_operand(body)?;
            return Ok(Operand::new(body.expression.unary(Unary::Neg, operand.node)));
        }
        self.accept_punct(Punct::Plus)?;
        self.function_operand(body)
    }

    fn function_operand(&mut self, body: &mut Body) -> Result<Operand> {
        let token = self.peek()?;
        match token.tok {
            Tok::Number(value) => {
                self.next()?;
                Ok(Operand { node: body.expression.constant(value), bare: true })
            }
            Tok::Punct(Punct::LeftParen) => {
                self.next()?;
                let inner = self.function_expression(body)?;
                self.expect_punct(Punct::RightParen)?;
                Ok(Operand::new(inner.node))
            }
            Tok::Word(word) => self.function_word(body, word),
            Tok::Identifier(symbol) => self.function_identifier(body, symbol, token),
            _ => Err(self.unexpected("a number, a parameter or a function")),
        }
    }

    fn function_identifier(&mut self, body: &mut Body, symbol: Symbol, token: Token) -> Result<Operand> {
        if let Some(node) = body.argument(Name::Identifier(symbol)) {
            self.next()?;
            return Ok(Operand::new(node));
        }
        match self.peek_value()? {
            Some(Value::Float(value)) => {
                self.take_value()?;
                Ok(Operand { node: body.expression.constant(value), bare: true })
            }
            Some(Value::Function(function)) => {
                self.take_value()?;
                self.function_call(body, &function, token)
            }
            Some(other) => {
                let message = format!("a function's expression cannot use a {}", other.kind());
                let hint = match other {
                    Value::Vector(..) | Value::Color(_) => {
                        "declare the component as a number outside the function"
                    }
                    Value::Spline(_) => "declare a function of it: `function { spline { … } }`",
                    _ => "it can use numbers, functions and the function's parameters",
                };
                Err(Box::new(Diagnostic::error(token.span, message).with_hint(hint)))
            }
            None => Err(self.unexpected("a number, a parameter or a function")),
        }
    }

    /// `F(a, b, …)`, with `.member` if the function gives vectors.
    fn function_call(&mut self, body: &mut Body, function: &Arc<Function>, name: Token) -> Result<Operand> {
        let (arguments, span) = self.function_arguments(body)?;
        if arguments.len() != function.arity() {
            let (given, wanted) = (arguments.len(), function.arity());
            let message = format!("this function has {wanted} parameters, and {given} arguments are given");
            return Err(Box::new(Diagnostic::error(name.span.to(span), message)));
        }
        let call = function.call_in(&mut body.expression, &arguments);
        match function.vector_kind() {
            None => Ok(Operand::new(call)),
            Some(kind) => self.function_member(body, call, kind).map(Operand::new),
        }
    }

    /// `(a, b, …)`; also where the list ends.
    fn function_arguments(&mut self, body: &mut Body) -> Result<(Vec<Node>, Span)> {
        self.expect_punct(Punct::LeftParen)?;
        let mut arguments = vec![self.function_expression(body)?.node];
        while self.accept_punct(Punct::Comma)? {
            arguments.push(self.function_expression(body)?.node);
        }
        let close = self.expect_punct(Punct::RightParen)?;
        Ok((arguments, close.span))
    }

    fn function_member(&mut self, body: &mut Body, call: Node, kind: VectorKind) -> Result<Node> {
        if self.peek()?.tok != Tok::Punct(Punct::Dot) {
            return Err(self.unexpected("`.` and a component, since this function gives a vector"));
        }
        self.next()?;
        let token = self.peek()?;
        let e = &mut body.expression;
        let component = match token.tok {
            Tok::Word(Keyword::X | Keyword::U | Keyword::Red) => 0,
            Tok::Word(Keyword::Y | Keyword::V | Keyword::Green) => 1,
            Tok::Word(Keyword::Z | Keyword::Blue) => 2,
            Tok::Word(Keyword::T | Keyword::Filter) => 3,
            Tok::Word(Keyword::Transmit) => 4,
            Tok::Word(Keyword::Gray) if kind.components() >= 3 => {
                self.next()?;
                return Ok(weighted(e, call, &[0.297, 0.589, 0.114]));
            }
            Tok::Identifier(symbol) if self.name(symbol) == "hf" && kind.components() >= 2 => {
                self.next()?;
                return Ok(weighted(e, call, &[0.996093, 0.996093 / 255.0]));
            }
            _ => return Err(self.unexpected("the name of a component")),
        };
        self.next()?;
        if usize::from(component) >= kind.components() {
            let message = format!("this function gives only {} components", kind.components());
            return Err(Box::new(Diagnostic::error(token.span, message)));
        }
        Ok(e.component(call, component))
    }
}

/// Words.
impl Parser {
    fn function_word(&mut self, body: &mut Body, word: Keyword) -> Result<Operand> {
        if let Some(name) = coordinate(word) {
            self.next()?;
            let node = body.argument(name).unwrap_or_else(|| body.expression.constant(0.0));
            return Ok(Operand::new(node));
        }
        if let Some(f) = unary(word) {
            return self.function_of_one(body, f);
        }
        match word {
            Keyword::Pi | Keyword::Clock => {
                self.next()?;
                let value = if word == Keyword::Pi { std::f64::consts::PI } else { self.clock() };
                Ok(Operand { node: body.expression.constant(value), bare: true })
            }
            Keyword::Select => self.function_select(body),
            Keyword::Sum | Keyword::Prod => self.function_fold(body, word),
            _ => match binary(word) {
                Some(f) => self.function_of_two(body, f),
                None => Err(self.unexpected("a number, a parameter or a function")),
            },
        }
    }

    fn function_of_one(&mut self, body: &mut Body, f: Unary) -> Result<Operand> {
        let word = self.next()?;
        let (arguments, end) = self.function_arguments(body)?;
        match arguments[..] {
            [a] => Ok(Operand::new(body.expression.unary(f, a))),
            _ => Err(wrong_count(word, end, "one argument")),
        }
    }

    fn function_of_two(&mut self, body: &mut Body, f: Binary) -> Result<Operand> {
        let word = self.next()?;
        let (arguments, end) = self.function_arguments(body)?;
        let many = matches!(f, Binary::Min | Binary::Max);
        match arguments[..] {
            [a, b] => Ok(Operand::new(body.expression.binary(f, a, b))),
            [a, ref rest @ ..] if many && !rest.is_empty() => {
                Ok(Operand::new(rest.iter().fold(a, |a, &b| body.expression.binary(f, a, b))))
            }
            _ => Err(wrong_count(word, end, if many { "two or more arguments" } else { "two arguments" })),
        }
    }

    fn function_select(&mut self, body: &mut Body) -> Result<Operand> {
        let word = self.next()?;
        let (arguments, end) = self.function_arguments(body)?;
        let (test, branches) = match arguments[..] {
            [test, negative, other] => (test, [negative, other, other]),
            [test, negative, zero, positive] => (test, [negative, zero, positive]),
            _ => return Err(wrong_count(word, end, "three or four arguments")),
        };
        Ok(Operand::new(body.expression.choice(test, branches)))
    }

    /// `sum(i, a, b, body)` or `prod(…)`.
    fn function_fold(&mut self, body: &mut Body, word: Keyword) -> Result<Operand> {
        self.next()?;
        self.expect_punct(Punct::LeftParen)?;
        let name = self.counter_name(body)?;
        self.expect_punct(Punct::Comma)?;
        let from = self.function_expression(body)?.node;
        self.expect_punct(Punct::Comma)?;
        let to = self.function_expression(body)?.node;
        self.expect_punct(Punct::Comma)?;
        let counter = body.expression.counter();
        body.counters.push((name, counter));
        let term = self.function_expression(body)?.node;
        body.counters.pop();
        self.expect_punct(Punct::RightParen)?;
        Ok(Operand::new(body.expression.fold(word == Keyword::Prod, counter, [from, to], term)))
    }

    /// A counter may have the name of a counter or a parameter around; a parameter hides it.
    fn counter_name(&mut self, body: &Body) -> Result<Name> {
        if let Tok::Identifier(symbol) = self.peek()?.tok
            && body.knows(Name::Identifier(symbol))
        {
            self.next()?;
            return Ok(Name::Identifier(symbol));
        }
        self.parameter_name("the name of a counter")
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

const COMPARISONS: [(Punct, Binary); 6] = [
    (Punct::Less, Binary::Less),
    (Punct::LessEqual, Binary::LessEqual),
    (Punct::Equal, Binary::Equal),
    (Punct::NotEqual, Binary::NotEqual),
    (Punct::GreaterEqual, Binary::GreaterEqual),
    (Punct::Greater, Binary::Greater),
];

fn unary(word: Keyword) -> Option<Unary> {
    Some(match word {
        Keyword::Sin => Unary::Sin,
        Keyword::Cos => Unary::Cos,
        Keyword::Tan => Unary::Tan,
        Keyword::Asin => Unary::Asin,
        Keyword::Acos => Unary::Acos,
        Keyword::Atan => Unary::Atan,
        Keyword::Sinh => Unary::Sinh,
        Keyword::Cosh => Unary::Cosh,
        Keyword::Tanh => Unary::Tanh,
        Keyword::Asinh => Unary::Asinh,
        Keyword::Acosh => Unary::Acosh,
        Keyword::Atanh => Unary::Atanh,
        Keyword::Abs => Unary::Abs,
        Keyword::Radians => Unary::Radians,
        Keyword::Degrees => Unary::Degrees,
        Keyword::Floor => Unary::Floor,
        Keyword::Ceil => Unary::Ceil,
        Keyword::Int => Unary::Int,
        Keyword::Sqrt => Unary::Sqrt,
        Keyword::Exp => Unary::Exp,
        Keyword::Ln => Unary::Ln,
        Keyword::Log => Unary::Log10,
        _ => return None,
    })
}

fn binary(word: Keyword) -> Option<Binary> {
    Some(match word {
        Keyword::Div => Binary::IntDiv,
        Keyword::Mod => Binary::Mod,
        Keyword::Atan2 => Binary::Atan2,
        Keyword::Pow => Binary::Pow,
        Keyword::Min => Binary::Min,
        Keyword::Max => Binary::Max,
        _ => return None,
    })
}

/// The sum of a call's components with these weights.
fn weighted(e: &mut Expression, call: Node, weights: &[f64]) -> Node {
    let mut sum = e.constant(0.0);
    for (i, &weight) in weights.iter().enumerate() {
        let (component, weight) = (e.component(call, i as u8), e.constant(weight));
        let product = e.binary(Binary::Mul, component, weight);
        sum = if i == 0 { product } else { e.binary(Binary::Add, sum, product) };
    }
    sum
}

fn wrong_count(word: Token, end: Span, expected: &str) -> Box<Diagnostic> {
    let name = match word.tok {
        Tok::Word(word) => word.text(),
        _ => "the function",
    };
    Box::new(Diagnostic::error(word.span.to(end), format!("`{name}` takes {expected}")))
}
