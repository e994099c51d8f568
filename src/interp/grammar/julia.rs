//! `julia_fractal { <c> settings }`.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::scene::Object;
use crate::shape::{Julia, JuliaError, JuliaFunction, JuliaSettings};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok, Token};

/// More iterations than this only cost time: an iterate is then as fine as rounding.
const MAX_ITERATIONS: f64 = 100_000.0;

impl Parser {
    pub(super) fn julia_fractal(&mut self, keyword: Token) -> Result<Object> {
        let mut settings = JuliaSettings { c: self.vector4()?, ..Default::default() };
        while self.julia_setting(&mut settings)? {}
        let message = match Julia::new(&settings) {
            Ok(julia) => return Ok(from_shape(julia)),
            Err(JuliaError::NoSlice) => "the slice's normal has no direction",
            Err(JuliaError::SliceAlongFourth) => "the fourth component of the slice's normal must not be 0",
            Err(JuliaError::NotForQuaternions) => {
                let message = "quaternions know `sqr` and `cube` only: `sqr` is taken";
                self.lenient(Diagnostic::warning(keyword.span, message).with_hint("write `hypercomplex`"))?;
                let square = JuliaSettings { function: JuliaFunction::Square, ..settings };
                match Julia::new(&square) {
                    Ok(julia) => return Ok(from_shape(julia)),
                    Err(_) => "the slice's normal does not cut the fourth axis",
                }
            }
        };
        Err(Box::new(Diagnostic::error(keyword.span, message)))
    }

    fn julia_setting(&mut self, settings: &mut JuliaSettings) -> Result<bool> {
        let Tok::Word(word) = self.peek()?.tok else { return Ok(false) };
        if let Some(function) = function_of_word(word) {
            self.next()?;
            settings.function = function;
            return Ok(true);
        }
        match word {
            Keyword::Quaternion | Keyword::Hypercomplex => {
                self.next()?;
                settings.hypercomplex = word == Keyword::Hypercomplex;
            }
            Keyword::Pwr => {
                self.next()?;
                self.expect_punct(Punct::LeftParen)?;
                let re = self.float()?;
                self.comma()?;
                let im = self.float()?;
                self.expect_punct(Punct::RightParen)?;
                settings.function = JuliaFunction::Power([re, im]);
            }
            Keyword::MaxIteration => {
                self.next()?;
                settings.iterations = self.float()?.clamp(1.0, MAX_ITERATIONS) as u32;
            }
            Keyword::Precision => {
                self.next()?;
                settings.precision = self.float()?.max(1.0);
            }
            Keyword::Slice => {
                self.next()?;
                settings.slice_normal = self.vector4()?;
                self.comma()?;
                settings.slice_distance = self.float()?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}

fn function_of_word(word: Keyword) -> Option<JuliaFunction> {
    use JuliaFunction as F;
    Some(match word {
        Keyword::Sqr => F::Square,
        Keyword::Cube => F::Cube,
        Keyword::Exp => F::Exp,
        Keyword::Reciprocal => F::Reciprocal,
        Keyword::Sin => F::Sin,
        Keyword::Asin => F::Asin,
        Keyword::Sinh => F::Sinh,
        Keyword::Asinh => F::Asinh,
        Keyword::Cos => F::Cos,
        Keyword::Acos => F::Acos,
        Keyword::Cosh => F::Cosh,
        Keyword::Acosh => F::Acosh,
        Keyword::Tan => F::Tan,
        Keyword::Atan => F::Atan,
        Keyword::Tanh => F::Tanh,
        Keyword::Atanh => F::Atanh,
        Keyword::Ln => F::Ln,
        _ => return None,
    })
}
