//! Numeric expressions: numbers, and tuples of 2 to 5 of them.

use super::comparison::Comparison;
use super::directives::TINY;
use super::program::Level;
use super::{Parser, Result, Value};
use crate::color::Color;
use crate::math::{Vec2, Vec3};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Tok, Token};

/// What an expression yields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Number {
    Scalar(f64),
    /// 2 to 5 components, the others 0. With one it is a number taken out of a vector, `v.y`, and the vector's other
    /// components follow: where a vector is wanted, the reference replaces only the first one by the number.
    Tuple(u8, [f64; 5]),
}

use Number::{Scalar, Tuple};

/// The version, times 100, from which on `1 -1` is one number.
const FIRST_TO_JOIN: u32 = 150;

/// Weights of red, green and blue in a grey value.
const GREY: [f64; 3] = [0.297, 0.589, 0.114];

impl Number {
    pub fn vector(v: Vec3) -> Self {
        Tuple(3, [v.x, v.y, v.z, 0.0, 0.0])
    }

    /// All five components; a scalar fills `count` of them.
    pub fn filled(self, count: usize) -> [f64; 5] {
        match self {
            Scalar(v) => std::array::from_fn(|i| if i < count { v } else { 0.0 }),
            Tuple(_, v) => v,
        }
    }

    /// A number without the vector that it was taken out of.
    pub fn plain(self) -> Self {
        match self {
            Tuple(1, v) => Scalar(v[0]),
            other => other,
        }
    }

    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        match self {
            Scalar(v) => Scalar(f(v)),
            Tuple(1, v) => Tuple(1, [f(v[0]), v[1], v[2], v[3], v[4]]),
            Tuple(n, v) => Tuple(n, std::array::from_fn(|i| if i < n as usize { f(v[i]) } else { 0.0 })),
        }
    }

    /// Component by component; a scalar is replicated, a shorter tuple padded with 0.
    #[inline]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        match (self, other.plain()) {
            (Scalar(a), Scalar(b)) => return Scalar(f(a, b)),
            (Tuple(1, _), Scalar(b)) => return self.map(|a| f(a, b)),
            _ => {}
        }
        let n = self.len().max(other.len());
        let (a, b) = (self.plain().filled(n), other.plain().filled(n));
        Tuple(n as u8, std::array::from_fn(|i| if i < n { f(a[i], b[i]) } else { 0.0 }))
    }

    pub fn len(self) -> usize {
        match self {
            Scalar(_) => 1,
            Tuple(n, _) => n as usize,
        }
    }

    /// As a variable keeps it: five components are a colour.
    pub fn into_value(self) -> Value {
        match self {
            Scalar(v) | Tuple(1, [v, ..]) => Value::Float(v),
            Tuple(5, v) => Value::Color(Color::from_components(v.map(|c| c as f32))),
            Tuple(n, v) => Value::Vector(n, v),
        }
    }

    pub fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Float(v) => Some(Scalar(*v)),
            Value::Vector(n, v) => Some(Tuple(*n, *v)),
            Value::Color(c) => Some(Tuple(5, c.components().map(f64::from))),
            _ => None,
        }
    }
}

pub(super) fn truth(v: f64) -> bool {
    v.abs() > TINY
}

pub(super) fn number(b: bool) -> f64 {
    f64::from(u8::from(b))
}

impl Parser {
    /// A number, at the additive level (no comparison outside parentheses).
    pub fn float(&mut self) -> Result<f64> {
        if let Some(v) = self.compiled(Level::Additive) {
            return Ok(v);
        }
        let start = self.peek_operand()?.span;
        let value = self.sum()?;
        self.scalar(value, start)
    }

    /// The only component of a number.
    #[inline]
    pub(super) fn scalar(&mut self, value: Number, start: Span) -> Result<f64> {
        match value {
            Scalar(v) | Tuple(1, [v, ..]) => Ok(v),
            Tuple(n, _) => Err(self.not_a_number(n, start)),
        }
    }

    fn not_a_number(&self, n: u8, start: Span) -> Box<Diagnostic> {
        let found = if n == 5 { "a color".to_owned() } else { format!("a {n}-component vector") };
        Box::new(Diagnostic::error(start.to(self.last), format!("expected a number, found {found}")))
    }

    /// A 3-vector; a number is replicated, 2 components are padded with 0.
    pub fn vector(&mut self) -> Result<Vec3> {
        let start = self.peek_operand()?.span;
        let value = self.sum()?;
        let v = self.tuple(value, 3, start)?;
        Ok(Vec3::new(v[0], v[1], v[2]))
    }

    pub fn vector2(&mut self) -> Result<Vec2> {
        let start = self.peek_operand()?.span;
        let value = self.sum()?;
        let v = self.tuple(value, 2, start)?;
        Ok(Vec2::new(v[0], v[1]))
    }

    pub fn vector4(&mut self) -> Result<[f64; 4]> {
        let start = self.peek_operand()?.span;
        let value = self.sum()?;
        let v = self.tuple(value, 4, start)?;
        Ok([v[0], v[1], v[2], v[3]])
    }

    /// At most `count` components.
    pub(super) fn tuple(&mut self, value: Number, count: usize, start: Span) -> Result<[f64; 5]> {
        if value.len() > count {
            let message = format!("expected a vector of {count} components, found {}", value.len());
            return Err(Box::new(Diagnostic::error(start.to(self.last), message)));
        }
        Ok(value.filled(count))
    }

    /// A full comparison-level number as in `#if (…)` and map keys.
    pub fn condition(&mut self) -> Result<f64> {
        if let Some(v) = self.compiled(Level::Full) {
            return Ok(v);
        }
        let start = self.peek_operand()?.span;
        let value = self.full()?;
        self.scalar(value, start)
    }

    /// The optional number of a boolean option: absent means on, on iff it is above 0.
    pub fn flag(&mut self) -> Result<bool> {
        if self.at_color_word()? || !self.at_expression()? {
            return Ok(true);
        }
        Ok(self.float()? > 0.0)
    }

    /// Any expression value: a float, a vector, a colour or a string.
    pub fn expression(&mut self) -> Result<Value> {
        if self.at_string()? {
            return Ok(Value::String(self.string_value()?));
        }
        if self.at_color_word()? {
            return Ok(Value::Color(self.color()?));
        }
        // A colour was never a list's item: its sums need no parentheses.
        let is_color = matches!(self.peek_value()?, Some(Value::Color(_)));
        let value = if is_color { self.additive()? } else { self.sum()? };
        Ok(value.into_value())
    }

    /// The loosest level: `c ? a : b`.
    pub(super) fn full(&mut self) -> Result<Number> {
        let start = self.peek_operand()?.span;
        let value = self.logical()?;
        if self.peek()?.tok != Tok::Punct(Punct::Question) {
            return Ok(value);
        }
        let chosen = truth(self.scalar(value, start)?);
        self.next()?;
        self.deeper()?;
        let yes = self.full()?;
        self.expect_punct(Punct::Colon)?;
        let no = self.full()?;
        self.shallower();
        Ok(if chosen { yes } else { no })
    }

    /// `&` and `|`, of equal precedence.
    fn logical(&mut self) -> Result<Number> {
        let mut left = self.relational()?;
        loop {
            let op: fn(f64, f64) -> f64 = match self.peek()?.tok {
                Tok::Punct(Punct::And) => |a, b| number(truth(a) && truth(b)),
                Tok::Punct(Punct::Or) => |a, b| number(truth(a) || truth(b)),
                _ => return Ok(left),
            };
            self.next()?;
            let right = self.relational()?;
            left = left.with(right, op);
        }
    }

    /// Comparisons, of equal precedence.
    fn relational(&mut self) -> Result<Number> {
        let mut left = if self.at_string()? { self.string_comparison()? } else { self.additive()? };
        loop {
            let token = self.peek()?;
            let Some(comparison) = Comparison::from_token(token.tok) else { return Ok(left) };
            self.take(token)?;
            let right = self.additive()?;
            left = left.with(right, |a, b| comparison.of(a, b));
        }
    }

    fn string_comparison(&mut self) -> Result<Number> {
        let left = self.string_value()?;
        let token = self.peek()?;
        let Some(comparison) = Comparison::from_token(token.tok) else {
            return Err(self.unexpected("a comparison of two strings"));
        };
        self.take(token)?;
        let order = left.chars().cmp(self.string_value()?.chars());
        Ok(Scalar(number(comparison.holds(order))))
    }

    /// What every argument in the language is: a sum. Before version 1.5 a sum needs parentheses, so that `<1 -1 0>`
    /// has three components.
    #[inline]
    pub(super) fn sum(&mut self) -> Result<Number> {
        if self.joins() { self.additive() } else { self.unary() }
    }

    /// Whether numbers are joined outside of parentheses, too.
    #[inline]
    pub(super) fn joins(&self) -> bool {
        self.syntax_version() >= FIRST_TO_JOIN
    }

    /// `+` and `-`.
    fn additive(&mut self) -> Result<Number> {
        let mut left = self.multiplicative()?;
        loop {
            let token = self.peek()?;
            match token.tok {
                Tok::Punct(Punct::Plus) => {
                    self.take(token)?;
                    let right = self.multiplicative()?;
                    left = left.with(right, |a, b| a + b);
                }
                Tok::Punct(Punct::Minus) => {
                    self.take(token)?;
                    let right = self.multiplicative()?;
                    left = left.with(right, |a, b| a - b);
                }
                _ => return Ok(left),
            }
        }
    }

    fn multiplicative(&mut self) -> Result<Number> {
        let mut left = self.unary()?;
        loop {
            let token = self.peek()?;
            match token.tok {
                Tok::Punct(Punct::Star) => {
                    self.take(token)?;
                    let right = self.unary()?;
                    left = left.with(right, |a, b| a * b);
                }
                Tok::Punct(Punct::Slash) => {
                    self.take(token)?;
                    let right = self.unary()?;
                    left = self.quotient(left, right, token.span);
                }
                _ => return Ok(left),
            }
        }
    }

    /// Division; by an exact 0 it gives infinity, with a warning.
    fn quotient(&mut self, left: Number, right: Number, span: Span) -> Number {
        let n = left.len().max(right.len());
        if right.plain().filled(n)[..n].contains(&0.0) {
            self.warn(Diagnostic::warning(span, "division by zero").with_label("the result is infinite"));
        }
        left.with(right, |a, b| if b == 0.0 { f64::INFINITY } else { a / b })
    }

    fn unary(&mut self) -> Result<Number> {
        let token = self.peek_operand()?;
        let op: fn(f64) -> f64 = match token.tok {
            Tok::Punct(Punct::Minus) => |a| -a,
            Tok::Punct(Punct::Plus) => |a| a,
            Tok::Punct(Punct::Not) => |a| number(!truth(a)),
            _ => return self.primary(token),
        };
        self.take(token)?;
        self.deeper()?;
        let value = self.unary()?.map(op);
        self.shallower();
        Ok(value)
    }

    fn primary(&mut self, token: Token) -> Result<Number> {
        let value = match token.tok {
            Tok::Number(v) => {
                self.take(token)?;
                Scalar(v)
            }
            Tok::Identifier(name) => self.variable(name, token)?,
            Tok::Punct(Punct::LeftParen) => {
                self.take(token)?;
                let value = self.full()?;
                self.expect_punct(Punct::RightParen)?;
                value.plain()
            }
            Tok::Punct(Punct::Less) => self.vector_literal(token)?,
            Tok::Word(word) => match constant(word) {
                Some(value) => {
                    self.take(token)?;
                    value
                }
                None => match self.numeric_word(word, token)? {
                    Some(value) => value,
                    None => return Err(self.unexpected("a number or a vector")),
                },
            },
            _ => return Err(self.unexpected("a number or a vector")),
        };
        self.member(value)
    }

    #[inline]
    fn variable(&mut self, name: Symbol, token: Token) -> Result<Number> {
        match self.symbols.value(name) {
            Some(&Value::Float(v)) => {
                self.take(token)?;
                Ok(Scalar(v))
            }
            Some(&Value::Vector(n, v)) => {
                self.take(token)?;
                Ok(Tuple(n, v))
            }
            Some(_) => self.other_variable(token),
            None => Err(self.unexpected("a number or a vector")),
        }
    }

    /// A colour, an array's element, or a call of a function or spline.
    fn other_variable(&mut self, token: Token) -> Result<Number> {
        let Some(value) = self.peek_value()? else {
            return Err(self.unexpected("a number or a vector"));
        };
        if let Value::Function(_) | Value::Spline(_) = value {
            let call = self.take_value()?;
            let result = self.call(&call)?;
            return Number::from_value(&result).ok_or_else(|| self.wrong_kind(&result, token.span));
        }
        let number = Number::from_value(&value).ok_or_else(|| self.wrong_kind(&value, token.span))?;
        self.take_value()?;
        Ok(number)
    }

    fn wrong_kind(&self, value: &Value, span: Span) -> Box<Diagnostic> {
        Box::new(Diagnostic::error(span, format!("expected a number or a vector, found a {}", value.kind())))
    }

    /// `<a, b [, c [, d [, e]]]>`.
    fn vector_literal(&mut self, open: Token) -> Result<Number> {
        self.take(open)?;
        self.deeper()?;
        let (mut n, mut v) = (0, [0.0; 5]);
        while self.peek()?.tok != Tok::Punct(Punct::Greater) {
            if n == 5 {
                return Err(self.unexpected("`>`: a vector has at most 5 components"));
            }
            v[n] = self.float()?;
            n += 1;
            self.comma()?;
        }
        let close = self.next()?;
        self.shallower();
        if n < 2 {
            let span = open.span.to(close.span);
            return Err(Box::new(Diagnostic::error(span, "a vector has at least 2 components")));
        }
        Ok(Tuple(n as u8, v))
    }

    /// `.x`, `.red` and so on; a number is a tuple of one component.
    #[inline]
    fn member(&mut self, value: Number) -> Result<Number> {
        if self.peek()?.tok == Tok::Punct(Punct::Dot) { self.named_component(value) } else { Ok(value) }
    }

    fn named_component(&mut self, value: Number) -> Result<Number> {
        self.next()?;
        let (n, v) = (value.len(), value.filled(1));
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else {
            return Err(self.unexpected("the name of a component"));
        };
        if word == Keyword::Gray {
            self.next()?;
            let grey = (0..3).map(|i| v[i] * GREY[i]).sum();
            return Ok(if n == 1 { Scalar(grey) } else { Tuple(1, [grey, v[1], v[2], v[3], v[4]]) });
        }
        let Some(index) = component_index(word) else {
            return Err(self.unexpected("the name of a component"));
        };
        self.next()?;
        if usize::from(index) >= n {
            let message = match n {
                1 => "a number has one component, `.x`".to_owned(),
                _ => format!("this vector has only {n} components"),
            };
            return Err(Box::new(Diagnostic::error(token.span, message)));
        }
        let part = v[index as usize];
        Ok(if n == 1 { Scalar(part) } else { Tuple(1, [part, v[1], v[2], v[3], v[4]]) })
    }

    /// Whether the next token can begin a colour or numeric expression.
    pub fn at_expression(&mut self) -> Result<bool> {
        use Punct::*;
        Ok(match self.peek_operand()?.tok {
            Tok::Number(_) => true,
            Tok::Punct(p) => matches!(p, Less | LeftParen | Minus | Plus | Not),
            Tok::Word(word) => constant(word).is_some() || is_numeric_word(word) || is_color_word(word),
            Tok::Identifier(_) => match self.peek_value()? {
                Some(Value::Float(_) | Value::Vector(..) | Value::Color(_)) => true,
                Some(Value::Function(_) | Value::Spline(_)) => self.glance()? == Tok::Punct(LeftParen),
                _ => false,
            },
            _ => false,
        })
    }

    pub(super) fn at_color_word(&mut self) -> Result<bool> {
        Ok(matches!(self.peek_operand()?.tok, Tok::Word(word) if is_color_word(word)))
    }
}

pub(super) fn is_color_word(word: Keyword) -> bool {
    use Keyword::*;
    matches!(
        word,
        Color
            | Rgb
            | Rgbf
            | Rgbt
            | Rgbft
            | Srgb
            | Srgbf
            | Srgbt
            | Srgbft
            | Red
            | Green
            | Blue
            | Filter
            | Transmit
    )
}

/// Words that take no argument and never change.
fn constant(word: Keyword) -> Option<Number> {
    const fn unit(axis: usize, n: u8) -> Number {
        let mut v = [0.0; 5];
        v[axis] = 1.0;
        Tuple(n, v)
    }
    Some(match word {
        Keyword::X => unit(0, 3),
        Keyword::Y => unit(1, 3),
        Keyword::Z => unit(2, 3),
        Keyword::U => unit(0, 2),
        Keyword::V => unit(1, 2),
        Keyword::T => unit(3, 4),
        Keyword::True | Keyword::Yes | Keyword::On => Scalar(1.0),
        Keyword::False | Keyword::No | Keyword::Off => Scalar(0.0),
        Keyword::Pi => Scalar(std::f64::consts::PI),
        _ => return None,
    })
}

/// Words that begin a number or vector and take arguments, or whose value depends on the scene.
fn is_numeric_word(word: Keyword) -> bool {
    super::builtin::is_numeric(word)
}

/// A word for a number that never changes.
pub(super) fn scalar_constant(word: Keyword) -> Option<f64> {
    match constant(word) {
        Some(Scalar(v)) => Some(v),
        _ => None,
    }
}

/// Which component the word behind a `.` names.
pub(super) fn component_index(word: Keyword) -> Option<u8> {
    Some(match word {
        Keyword::X | Keyword::U | Keyword::Red => 0,
        Keyword::Y | Keyword::V | Keyword::Green => 1,
        Keyword::Z | Keyword::Blue => 2,
        Keyword::T | Keyword::Filter => 3,
        Keyword::Transmit => 4,
        _ => return None,
    })
}
