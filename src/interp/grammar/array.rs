//! Arrays: `array[n][m] { … }`, and subscripts.

use crate::interp::symbols::Reference;
use crate::interp::value::Array;
use crate::interp::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Tok, Token};

/// Most dimensions of an array.
const MOST_DIMENSIONS: usize = 5;

/// Most arrays within each other.
const DEEPEST: usize = 100;

/// An index may be this much too small.
const SLACK: f64 = 1e-10;

impl Parser {
    /// `array[n1][n2]… { elements }`, `array` next.
    pub(in crate::interp) fn array_statement(&mut self) -> Result<Array> {
        let start = self.expect(Keyword::Array)?.span;
        let mut sizes = Vec::new();
        while self.peek()?.tok == Tok::Punct(Punct::LeftBracket) {
            if sizes.len() == MOST_DIMENSIONS {
                return Err(self.unexpected(&format!("no more than {MOST_DIMENSIONS} dimensions")));
            }
            self.next()?;
            let written = self.float()?;
            let size = written + SLACK;
            self.expect_punct(Punct::RightBracket)?;
            if !(1.0..4e9).contains(&size) {
                let span = start.to(self.last);
                return Err(Box::new(Diagnostic::error(
                    span,
                    format!("an array cannot have {written} elements"),
                )));
            }
            sizes.push(size as usize);
        }
        if sizes.is_empty() {
            return Err(self.unexpected("`[` and the array's size"));
        }
        let count = sizes.iter().try_fold(1usize, |product, size| product.checked_mul(*size));
        let count = count.filter(|c| *c <= self.options.limits.array_elements).ok_or_else(|| {
            let limit = self.options.limits.array_elements;
            let message = format!("an array has more than {limit} elements");
            Box::new(
                Diagnostic::error(start.to(self.last), message).with_hint("`--limit elements=N` allows more"),
            )
        })?;
        self.reserve((count * size_of::<Option<Value>>()) as u64, start.to(self.last))?;
        let mut array = Array { elements: vec![None; count], kind: None, sizes, depth: 1 };
        if self.peek()?.tok == Tok::Punct(Punct::LeftBrace) {
            let mut at = 0;
            self.initializer(&mut array, 0, &mut at)?;
        }
        Ok(array)
    }

    /// `{ … }` of one dimension; `at` is the element that comes next.
    fn initializer(&mut self, array: &mut Array, dimension: usize, at: &mut usize) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        for _ in 0..array.sizes[dimension] {
            if dimension + 1 < array.sizes.len() {
                self.initializer(array, dimension + 1, at)?;
            } else {
                self.initial_element(array, *at)?;
                *at += 1;
            }
            self.comma()?;
        }
        self.expect_punct(Punct::RightBrace).map(|_| ())
    }

    fn initial_element(&mut self, array: &mut Array, at: usize) -> Result<()> {
        let start = self.peek_operand()?.span;
        let value = self.rvalue()?.value;
        let (kind, found) = (array.kind, value.kind());
        if kind.is_some_and(|k| k != found) {
            let message =
                format!("this array's elements are of the kind {}, not {found}", kind.unwrap_or(""));
            return Err(Box::new(Diagnostic::error(start.to(self.last), message)));
        }
        let depth = 1 + value.array_depth();
        check_array_depth(depth as usize, start.to(self.last))?;
        array.depth = array.depth.max(depth);
        array.kind = Some(found);
        array.elements[at] = Some(value);
        Ok(())
    }

    /// The element behind an array's name, which was just taken.
    pub(in crate::interp) fn element(&mut self, name: Symbol, span: Span) -> Result<Value> {
        let Some(Value::Array(array)) = self.symbols.value(name) else {
            return Err(self.unexpected("an array"));
        };
        // The name's table may be gone once the subscripts are read.
        let mut array = array.clone();
        loop {
            let index = self.flat_index(&array.sizes)?;
            let token = Token { tok: Tok::Identifier(name), span: span.to(self.last) };
            let value = array.elements[index].clone();
            match value {
                None => return Err(self.unset(token)),
                Some(Value::Array(inner)) if self.glance()? == Tok::Punct(Punct::LeftBracket) => {
                    array = inner
                }
                Some(value) => return Ok(value),
            }
        }
    }

    /// `[i][j]…` behind a variable that is about to be assigned to or referred to; false if none come.
    pub(in crate::interp) fn subscripts(&mut self, reference: &mut Reference, span: Span) -> Result<bool> {
        let before = reference.path.len();
        while self.glance()? == Tok::Punct(Punct::LeftBracket) {
            let sizes = match self.symbols.target(reference) {
                Some(Value::Array(array)) => array.sizes.clone(),
                _ => {
                    let span = span.to(self.last);
                    return Err(Box::new(Diagnostic::error(
                        span,
                        "this is no array, but a subscript follows",
                    )));
                }
            };
            let index = self.flat_index(&sizes)?;
            reference.path.push(index);
        }
        Ok(reference.path.len() > before)
    }

    /// One subscript per dimension, as the number of the element.
    fn flat_index(&mut self, sizes: &[usize]) -> Result<usize> {
        sizes.iter().try_fold(0, |flat, &size| {
            let open = self.expect_punct(Punct::LeftBracket)?;
            let value = self.float()?;
            self.expect_punct(Punct::RightBracket)?;
            let index = array_index(value, size).ok_or_else(|| {
                let span = open.span.to(self.last);
                let message = format!("subscript {value} is outside 0 to {}", size - 1);
                Box::new(Diagnostic::error(span, message))
            })?;
            Ok(flat * size + index)
        })
    }
}

/// More arrays within each other would not fit the stack.
pub(super) fn check_array_depth(depth: usize, span: Span) -> Result<()> {
    if depth <= DEEPEST {
        return Ok(());
    }
    Err(Box::new(Diagnostic::error(span, format!("arrays stand within each other more than {DEEPEST} deep"))))
}

/// The subscript that a number means; `None` outside `0..size`.
#[inline]
pub(in crate::interp) fn array_index(value: f64, size: usize) -> Option<usize> {
    let index = (value + SLACK).floor();
    (index >= 0.0 && index < size as f64).then_some(index as usize)
}
