//! Transformations: `translate`, `rotate`, `scale`, `matrix`, `transform`.

use crate::interp::directives::TINY;
use crate::interp::{Parser, Result, Value};
use crate::math::{Transform, Vec3};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok};

impl Parser {
    /// A transformation (`translate`, `rotate`, `scale`, `matrix`, `transform …`) if one comes.
    pub fn transformation(&mut self) -> Result<Option<Transform>> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(None) };
        Ok(Some(match word {
            Keyword::Translate => {
                self.next()?;
                Transform::translate(self.vector()?)
            }
            Keyword::Rotate => {
                self.next()?;
                Transform::rotate(self.vector()?)
            }
            Keyword::Scale => {
                self.next()?;
                self.scaling()?
            }
            Keyword::Matrix => {
                self.next()?;
                self.matrix(token.span)?
            }
            Keyword::Transform => self.transform_statement()?,
            _ => return Ok(None),
        }))
    }

    /// A factor of exactly 0 counts as 1.
    fn scaling(&mut self) -> Result<Transform> {
        let start = self.peek_operand()?.span;
        let v = self.vector()?;
        if v.to_array().contains(&0.0) {
            let span = start.to(self.last);
            self.warn(Diagnostic::warning(span, "scaling by 0 is not possible: taken as 1"));
        }
        Ok(Transform::scale(Vec3::from_array(v.to_array().map(|c| if c == 0.0 { 1.0 } else { c }))))
    }

    /// `<m00, m01, m02, m10, … m32>`.
    fn matrix(&mut self, span: Span) -> Result<Transform> {
        self.expect_punct(Punct::Less)?;
        self.deeper()?;
        let mut m = [0.0; 12];
        for v in &mut m {
            *v = self.float()?;
            self.comma()?;
        }
        self.expect_punct(Punct::Greater)?;
        self.shallower();
        let span = span.to(self.last);
        for column in 0..3 {
            if (0..3).all(|row| m[3 * row + column].abs() < TINY) {
                m[4 * column] = 1.0;
                let text = "a column of this matrix is 0: its diagonal element is taken as 1";
                self.warn(Diagnostic::warning(span, text));
            }
        }
        Transform::from_rows(m).ok_or_else(|| {
            Box::new(
                Diagnostic::error(span, "this matrix cannot be inverted")
                    .with_hint("its three rows must not lie in one plane"),
            )
        })
    }

    /// `transform ID` or `transform { … }`, `transform` next.
    pub(in crate::interp) fn transform_statement(&mut self) -> Result<Transform> {
        self.expect(Keyword::Transform)?;
        if let Some(t) = self.transform_identifier()? {
            return Ok(t);
        }
        self.expect_punct(Punct::LeftBrace)?;
        let (mut whole, mut inverse) = (Transform::IDENTITY, false);
        loop {
            if let Some(t) = self.transformation()? {
                whole = whole.then(&t);
            } else if let Some(t) = self.transform_identifier()? {
                whole = whole.then(&t);
            } else if self.accept(Keyword::Inverse)? {
                inverse = true;
            } else if self.accept_punct(Punct::RightBrace)? {
                return Ok(if inverse { whole.inverted() } else { whole });
            } else {
                return Err(self.unexpected("a transformation or `}`"));
            }
        }
    }

    fn transform_identifier(&mut self) -> Result<Option<Transform>> {
        match self.peek_value()? {
            Some(Value::Transform(t)) => {
                self.take_value()?;
                Ok(Some(*t))
            }
            _ => Ok(None),
        }
    }
}
