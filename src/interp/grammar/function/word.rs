//! Words in a function's expression: coordinates, functions of numbers, `select`, `sum`, `prod`.

use super::{Body, Name, Operand, coordinate};
use crate::function::{Binary, Unary};
use crate::interp::{Parser, Result};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};

/// Words.
impl Parser {
    pub(super) fn function_word(&mut self, body: &mut Body, word: Keyword) -> Result<Operand> {
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

fn wrong_count(word: Token, end: Span, expected: &str) -> Box<Diagnostic> {
    let name = match word.tok {
        Tok::Word(word) => word.text(),
        _ => "the function",
    };
    Box::new(Diagnostic::error(word.span.to(end), format!("`{name}` takes {expected}")))
}
