//! Functions that ask about the scene, its variables, its files and its strings.

use crate::interp::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::Keyword;
use std::time::{SystemTime, UNIX_EPOCH};

pub(super) fn is_function(word: Keyword) -> bool {
    use Keyword::*;
    matches!(
        word,
        Clock
            | ClockOn
            | Version
            | Now
            | Val
            | Asc
            | Strlen
            | Strcmp
            | Defined
            | Dimensions
            | DimensionSize
            | FileExists
            | Inside
    )
}

/// Seconds from 1970 to 2000-01-01, where the language's days begin.
pub(in crate::interp) const EPOCH: f64 = 946_684_800.0;

impl Parser {
    pub(in crate::interp) fn clock(&self) -> f64 {
        f64::from(self.options.frame.clock)
    }

    pub(super) fn query(&mut self, word: Keyword, span: Span) -> Result<f64> {
        Ok(match word {
            Keyword::Clock => self.clock(),
            Keyword::ClockOn => f64::from(u8::from(self.options.frame.clock_on)),
            Keyword::Version => f64::from(self.syntax_version()) / 100.0,
            Keyword::Now => {
                let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(EPOCH, |d| d.as_secs_f64());
                (now - EPOCH) / 86_400.0
            }
            Keyword::Val => super::text::leading_number(&self.in_parens(Parser::string)?),
            Keyword::Asc => {
                self.in_parens(Parser::string)?.chars().next().map_or(0.0, |c| f64::from(c as u32))
            }
            Keyword::Strlen => self.in_parens(Parser::string)?.chars().count() as f64,
            Keyword::Strcmp => self.difference_of_strings()?,
            Keyword::Defined => f64::from(u8::from(self.defined_in_parens()?)),
            Keyword::Dimensions => self.in_parens(|p| p.array_sizes(span))?.len() as f64,
            Keyword::DimensionSize => self.dimension_size(span)?,
            Keyword::FileExists => {
                let name = self.in_parens(Parser::file_name)?;
                f64::from(u8::from(self.may_see(&name)))
            }
            _ => self.inside_query(span)?,
        })
    }

    /// The difference of the first characters that differ; a string that ends has 0 there.
    fn difference_of_strings(&mut self) -> Result<f64> {
        self.in_parens(|p| {
            let a = p.string()?;
            p.comma()?;
            let b = p.string()?;
            let (mut a, mut b) = (a.chars(), b.chars());
            loop {
                let (x, y) = (a.next(), b.next());
                let difference = x.map_or(0, |c| c as i32) - y.map_or(0, |c| c as i32);
                if difference != 0 || x.is_none() {
                    return Ok(f64::from(difference));
                }
            }
        })
    }

    fn array_sizes(&mut self, span: Span) -> Result<Vec<usize>> {
        match self.take_value()? {
            Value::Array(array) => Ok(array.sizes.clone()),
            other => {
                let message = format!("expected an array, found a {}", other.kind());
                Err(Box::new(Diagnostic::error(span.to(self.last), message)))
            }
        }
    }

    /// `dimension_size(A, d)`, `d` from 1; 0 where there is no such dimension.
    fn dimension_size(&mut self, span: Span) -> Result<f64> {
        self.in_parens(|p| {
            let sizes = p.array_sizes(span)?;
            p.comma()?;
            let d = super::arithmetic::integer(p.float()?);
            let index = usize::try_from(d).ok().and_then(|d| d.checked_sub(1));
            Ok(index.and_then(|i| sizes.get(i)).map_or(0.0, |&s| s as f64))
        })
    }
}
