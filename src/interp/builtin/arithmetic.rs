//! Functions from numbers to a number.

use super::super::directives::TINY;
use crate::interp::{Parser, Result};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok};

pub(super) fn is_function(word: Keyword) -> bool {
    use Keyword::*;
    pure(word).is_some()
        || partial(word).is_some()
        || matches!(word, Atan2 | Pow | Div | Mod | Min | Max | Select)
        || matches!(word, BitwiseAnd | BitwiseOr | BitwiseXor | Seed | Rand)
}

/// Functions of one number that are defined everywhere.
pub(in crate::interp) fn pure(word: Keyword) -> Option<fn(f64) -> f64> {
    use Keyword::*;
    Some(match word {
        Abs => f64::abs,
        Ceil => f64::ceil,
        Floor => f64::floor,
        Exp => f64::exp,
        Sin => f64::sin,
        Cos => f64::cos,
        Tan => f64::tan,
        Atan => f64::atan,
        Sinh => f64::sinh,
        Cosh => f64::cosh,
        Tanh => f64::tanh,
        Asinh => f64::asinh,
        Acosh => f64::acosh,
        Atanh => f64::atanh,
        Int => truncate,
        Degrees => |v| v * (180.0 / std::f64::consts::PI),
        Radians => |v| v * (std::f64::consts::PI / 180.0),
        _ => return None,
    })
}

/// A function of one number that is not defined everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::interp) enum Partial {
    Sqrt,
    Ln,
    Log,
    Acos,
    Asin,
}

pub(in crate::interp) fn partial(word: Keyword) -> Option<Partial> {
    Some(match word {
        Keyword::Sqrt => Partial::Sqrt,
        Keyword::Ln => Partial::Ln,
        Keyword::Log => Partial::Log,
        Keyword::Acos => Partial::Acos,
        Keyword::Asin => Partial::Asin,
        _ => return None,
    })
}

impl Partial {
    /// The value where the function is defined.
    pub fn of(self, v: f64) -> Option<f64> {
        match self {
            Partial::Sqrt => (v >= 0.0 || v.is_nan()).then(|| v.sqrt()),
            Partial::Ln => (v > 0.0 || v.is_nan()).then(|| v.ln()),
            Partial::Log => (v > 0.0 || v.is_nan()).then(|| v.log10()),
            Partial::Acos => (v.abs() <= 1.0 || v.is_nan()).then(|| v.acos()),
            Partial::Asin => (v.abs() <= 1.0 || v.is_nan()).then(|| v.asin()),
        }
    }
}

/// Towards 0 through a 32-bit integer; what does not fit gives the smallest one.
pub(in crate::interp) fn truncate(v: f64) -> f64 {
    f64::from(integer(v))
}

pub(in crate::interp) fn integer(v: f64) -> i32 {
    if v > -2_147_483_649.0 && v < 2_147_483_648.0 { v as i32 } else { i32::MIN }
}

/// Multiplier and increment of the random number generator.
const FACTOR: u32 = 1_812_433_253;
const STEP: u32 = 12_345;

impl Parser {
    pub(super) fn arithmetic(&mut self, word: Keyword, span: Span) -> Result<f64> {
        if let Some(f) = pure(word) {
            return self.in_parens(Parser::condition).map(f);
        }
        if let Some(function) = partial(word) {
            return self.bounded(word, function, span);
        }
        match word {
            Keyword::Atan2 | Keyword::Pow | Keyword::Div | Keyword::Mod => self.binary(word, span),
            Keyword::Min => self.fold(f64::min),
            Keyword::Max => self.fold(f64::max),
            Keyword::BitwiseAnd => self.fold(|a, b| f64::from(integer(a) & integer(b))),
            Keyword::BitwiseOr => self.fold(|a, b| f64::from(integer(a) | integer(b))),
            Keyword::BitwiseXor => self.fold(|a, b| f64::from(integer(a) ^ integer(b))),
            Keyword::Select => self.select(),
            Keyword::Seed => self.seed(),
            _ => self.rand(span),
        }
    }

    fn bounded(&mut self, word: Keyword, function: Partial, span: Span) -> Result<f64> {
        let v = self.in_parens(Parser::condition)?;
        if let Some(value) = function.of(v) {
            return Ok(value);
        }
        let span = span.to(self.last);
        let range = match function {
            Partial::Sqrt => "at least 0",
            Partial::Ln | Partial::Log => "above 0",
            Partial::Acos | Partial::Asin => {
                let message = format!("{}({v}) is not defined: taken at {}", word.text(), v.clamp(-1.0, 1.0));
                self.warn(Diagnostic::warning(span, message));
                return Ok(function.of(v.clamp(-1.0, 1.0)).unwrap_or(v));
            }
        };
        let message = format!("{}({v}) is not defined: the argument must be {range}", word.text());
        Err(Box::new(Diagnostic::error(span, message)))
    }

    fn binary(&mut self, word: Keyword, span: Span) -> Result<f64> {
        let (a, b) = self.two_floats()?;
        let span = span.to(self.last);
        let undefined = |text: &str| Err(Box::new(Diagnostic::error(span, text)));
        Ok(match word {
            Keyword::Atan2 if a.abs() <= TINY && b.abs() <= TINY => {
                return undefined("atan2(0, 0) is not defined");
            }
            Keyword::Atan2 => a.atan2(b),
            Keyword::Pow if a == 0.0 && b == 0.0 => return undefined("pow(0, 0) is not defined"),
            Keyword::Pow => a.powf(b),
            Keyword::Div => truncate(a / b),
            _ => a % b,
        })
    }

    /// `(a, b, …)`: one or more numbers taken together from the left.
    fn fold(&mut self, f: impl Fn(f64, f64) -> f64) -> Result<f64> {
        self.in_parens(|p| {
            let mut value = p.float()?;
            loop {
                p.comma()?;
                if p.peek()?.tok == Tok::Punct(Punct::RightParen) {
                    return Ok(value);
                }
                value = f(value, p.float()?);
            }
        })
    }

    /// `select(A, B, C)` and `select(A, B, C, D)`.
    fn select(&mut self) -> Result<f64> {
        self.in_parens(|p| {
            let mut read = || -> Result<f64> {
                let v = p.float()?;
                p.comma()?;
                Ok(v)
            };
            let (a, below, c) = (read()?, read()?, read()?);
            let above = if p.peek()?.tok == Tok::Punct(Punct::RightParen) { c } else { p.float()? };
            Ok(if a < 0.0 {
                below
            } else if a == 0.0 {
                c
            } else {
                above
            })
        })
    }

    /// A new stream of random numbers; its number.
    fn seed(&mut self) -> Result<f64> {
        let start = self.in_parens(Parser::condition)?;
        self.random.push(integer(start) as u32);
        Ok((self.random.len() - 1) as f64)
    }

    fn rand(&mut self, span: Span) -> Result<f64> {
        let stream = integer(self.in_parens(Parser::condition)?);
        match usize::try_from(stream).ok().and_then(|i| self.random.get_mut(i)) {
            Some(state) => {
                *state = state.wrapping_mul(FACTOR).wrapping_add(STEP);
                Ok(f64::from(*state) / f64::from(u32::MAX))
            }
            None => {
                let message = format!("there is no random stream {stream}");
                Err(Box::new(
                    Diagnostic::error(span.to(self.last), message).with_hint("make one with seed()"),
                ))
            }
        }
    }
}
