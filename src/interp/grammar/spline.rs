//! `spline { … }` and the values of splines in expressions.

use crate::interp::{Parser, Result, Value};
use crate::math::{Spline, SplineKind, SplineValue};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

impl Parser {
    /// `spline { [Id] [kind] t, value … }`; the word is the next token.
    pub(crate) fn spline_statement(&mut self) -> Result<Value> {
        self.spline().map(Value::Spline)
    }

    pub(super) fn spline(&mut self) -> Result<Arc<Spline>> {
        let word = self.expect(Keyword::Spline)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut spline = match self.peek_value()? {
            Some(Value::Spline(base)) => {
                self.take_value()?;
                (*base).clone()
            }
            _ => Spline::new(SplineKind::Linear),
        };
        if let Some(kind) = self.spline_kind()? {
            spline.kind = kind;
        }
        // Components that a point lacks are those of the point written before it, as the reference has it.
        let mut point = [0.0; 5];
        while self.at_expression()? {
            let t = self.float()?;
            self.comma()?;
            let dimension = self.spline_point(&mut point)?;
            spline.insert(t, dimension, point);
            self.comma()?;
        }
        let close = self.expect_punct(Punct::RightBrace)?;
        if spline.is_empty() {
            let message = "a spline has at least one point";
            let error = Diagnostic::error(word.span.to(close.span), message);
            return Err(Box::new(error.with_hint("write a number and a vector for each point")));
        }
        Ok(Arc::new(spline))
    }

    /// Reads the components of a point; returns how many there are.
    fn spline_point(&mut self, point: &mut SplineValue) -> Result<usize> {
        let token = self.peek()?;
        let (dimension, value) = match self.expression()? {
            Value::Float(v) => (2, [v; 5]),
            Value::Vector(n, v) => (usize::from(n), v),
            Value::Color(c) => (5, c.components().map(f64::from)),
            other => {
                let message = format!("a spline goes through numbers and vectors, not a {}", other.kind());
                return Err(Box::new(Diagnostic::error(token.span, message)));
            }
        };
        point[..dimension].copy_from_slice(&value[..dimension]);
        Ok(dimension)
    }

    fn spline_kind(&mut self) -> Result<Option<SplineKind>> {
        let kind = match self.peek()?.tok {
            Tok::Word(Keyword::LinearSpline) => SplineKind::Linear,
            Tok::Word(Keyword::QuadraticSpline) => SplineKind::Quadratic,
            Tok::Word(Keyword::CubicSpline) => SplineKind::Cubic,
            Tok::Word(Keyword::NaturalSpline) => SplineKind::Natural,
            _ => return Ok(None),
        };
        self.next()?;
        Ok(Some(kind))
    }

    /// `(t [, kind])` after a spline's name.
    pub(super) fn call_spline(&mut self, spline: &Spline) -> Result<Value> {
        self.expect_punct(Punct::LeftParen)?;
        let t = self.float()?;
        self.comma()?;
        let kind = self.spline_kind()?.unwrap_or(spline.kind);
        self.expect_punct(Punct::RightParen)?;
        Ok(Value::Vector(spline.dimension() as u8, spline.value_as(t, kind)))
    }
}
