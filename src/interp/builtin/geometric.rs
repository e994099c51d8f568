//! Functions whose result is a vector, or whose arguments are.

use super::super::expr::Number;
use crate::interp::{Parser, Result};
use crate::math::{Transform, Vec3};
use crate::source::{Diagnostic, Span};
use crate::syntax::Keyword;

pub(super) fn is_function(word: Keyword) -> bool {
    use Keyword::*;
    matches!(
        word,
        Vcross
            | Vnormalize
            | Vrotate
            | VaxisRotate
            | Vturbulence
            | Vdot
            | Vlength
            | MinExtent
            | MaxExtent
            | Trace
    )
}

impl Parser {
    pub(super) fn geometric(&mut self, word: Keyword, span: Span) -> Result<Number> {
        let vector = match word {
            Keyword::Vdot => return self.two_vectors().map(|(a, b)| Number::Scalar(a.dot(b))),
            Keyword::Vlength => return self.in_parens(Parser::vector).map(|v| Number::Scalar(v.length())),
            Keyword::Vcross => self.two_vectors().map(|(a, b)| a.cross(b))?,
            Keyword::Vrotate => self.two_vectors().map(|(v, angles)| Transform::rotate(angles).point(v))?,
            Keyword::Vnormalize => self.normalized(span)?,
            Keyword::VaxisRotate => self.rotated_about_axis()?,
            Keyword::Vturbulence => self.turbulence()?,
            Keyword::MinExtent | Keyword::MaxExtent => self.extent(word)?,
            _ => self.trace_query()?,
        };
        Ok(Number::vector(vector))
    }

    fn two_vectors(&mut self) -> Result<(Vec3, Vec3)> {
        self.in_parens(|p| {
            let a = p.vector()?;
            p.comma()?;
            Ok((a, p.vector()?))
        })
    }

    fn normalized(&mut self, span: Span) -> Result<Vec3> {
        let v = self.in_parens(Parser::vector)?;
        if v == Vec3::ZERO {
            if self.syntax_version() >= 350 {
                let span = span.to(self.last);
                self.warn(Diagnostic::warning(span, "a vector of length 0 has no direction: left as it is"));
            }
            return Ok(v);
        }
        Ok(v / v.length())
    }

    /// `vaxis_rotate(v, axis, degrees)`.
    fn rotated_about_axis(&mut self) -> Result<Vec3> {
        let (v, axis, degrees) = self.in_parens(|p| {
            let v = p.vector()?;
            p.comma()?;
            let axis = p.vector()?;
            p.comma()?;
            Ok((v, axis, p.float()?))
        })?;
        let length = axis.length();
        if length == 0.0 {
            return Ok(v);
        }
        let n = axis / length;
        let (sin, cos) = degrees.to_radians().sin_cos();
        Ok(v * cos + n.cross(v) * sin + n * n.dot(v) * (1.0 - cos))
    }
}
