//! The functions of the language: one file per kind of result or argument.

mod arithmetic;
mod date;
mod geometric;
mod query;
mod text;

use super::expr::Number;
use super::{Parser, Result};
use crate::syntax::{Keyword, Punct, Token};

pub(super) use arithmetic::{Partial, partial, pure, truncate};
pub(super) use date::{format_date, has_date};
pub(super) use text::{format_fixed, format_general, format_short};

/// Words that begin a number or vector: functions, and names whose value depends on the scene.
pub(super) fn is_numeric(word: Keyword) -> bool {
    arithmetic::is_function(word) || geometric::is_function(word) || query::is_function(word)
}

impl Parser {
    /// A function's call or a name with a value; `None` if `word` is neither.
    pub(super) fn numeric_word(&mut self, word: Keyword, token: Token) -> Result<Option<Number>> {
        if arithmetic::is_function(word) {
            self.take(token)?;
            return self.arithmetic(word, token.span).map(|v| Some(Number::Scalar(v)));
        }
        if geometric::is_function(word) {
            self.take(token)?;
            return self.geometric(word, token.span).map(Some);
        }
        if query::is_function(word) {
            self.take(token)?;
            return self.query(word, token.span).map(|v| Some(Number::Scalar(v)));
        }
        Ok(None)
    }

    /// `(argument)` or `(argument, argument …)` of a function: `read` reads what stands between.
    pub(super) fn in_parens<T>(&mut self, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        self.expect_punct(Punct::LeftParen)?;
        let value = read(self)?;
        self.expect_punct(Punct::RightParen)?;
        Ok(value)
    }

    /// `(a, b)`, both numbers.
    fn two_floats(&mut self) -> Result<(f64, f64)> {
        self.in_parens(|p| {
            let a = p.float()?;
            p.comma()?;
            Ok((a, p.float()?))
        })
    }
}
