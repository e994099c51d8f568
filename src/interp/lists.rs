//! Long lists of vectors, as meshes have them.

use super::stream::Source;
use super::{Parser, Result};
use crate::syntax::{Plain, Punct, Tok};

/// Most numbers behind a vector of a list.
const MOST_NUMBERS: usize = 3;

impl Parser {
    /// Reads `count` vectors of `components` numbers, with optional commas between them. Those written with
    /// plain numbers are read straight from the file.
    pub(crate) fn vector_list(
        &mut self,
        count: usize,
        components: usize,
        sink: &mut dyn FnMut([f64; 5]),
    ) -> Result<()> {
        let mut left = count;
        while left > 0 {
            left -= self.plain(|plain| {
                let mut read = 0;
                while read < left
                    && let Some(v) = plain.vector(components)
                {
                    sink(v);
                    read += 1;
                }
                read
            })?;
            if left > 0 {
                sink(self.list_vector(components)?);
                left -= 1;
            }
        }
        Ok(())
    }

    /// Reads `count` vectors of `components` numbers, each with up to 3 numbers of its own behind it.
    pub(crate) fn numbered_vector_list(
        &mut self,
        count: usize,
        components: usize,
        sink: &mut dyn FnMut([f64; 5], &[f64]),
    ) -> Result<()> {
        let mut left = count;
        while left > 0 {
            left -= self.plain(|plain| {
                let mut read = 0;
                while read < left && plain_numbered(plain, components, sink) {
                    read += 1;
                }
                read
            })?;
            if left > 0 {
                let v = self.list_vector(components)?;
                let (mut numbers, mut n) = ([0.0; MOST_NUMBERS], 0);
                while n < MOST_NUMBERS && self.at_number()? {
                    numbers[n] = self.float()?;
                    n += 1;
                    self.comma()?;
                }
                sink(v, &numbers[..n]);
                left -= 1;
            }
        }
        Ok(())
    }

    fn list_vector(&mut self, components: usize) -> Result<[f64; 5]> {
        let start = self.peek_operand()?.span;
        let value = self.sum()?;
        let v = self.tuple(value, components, start)?;
        self.comma()?;
        Ok(v)
    }

    /// Whether a number comes next, and no vector.
    fn at_number(&mut self) -> Result<bool> {
        if self.peek_operand()?.tok == Tok::Punct(Punct::Less) {
            return Ok(false);
        }
        match self.peek_value()? {
            Some(value) => Ok(matches!(value, super::Value::Float(_))),
            None => self.at_expression(),
        }
    }

    /// Lets `read` take plain text where the innermost text is a file; how much it says it took.
    fn plain(&mut self, read: impl FnOnce(&mut Plain) -> usize) -> Result<usize> {
        let Some(start) = self.file_position()? else { return Ok(0) };
        let Some(frame) = self.frames.last_mut() else { return Ok(0) };
        let Source::File { lexer, .. } = &frame.source else { return Ok(0) };
        let text = lexer.text().clone();
        let mut plain = Plain::new(&text, start);
        let taken = read(&mut plain);
        let end = plain.position();
        if end == start {
            return Ok(taken);
        }
        frame.read_from(end);
        self.last.start = end as u32 - 1;
        self.last.end = end as u32;
        self.take_ahead();
        Ok(taken)
    }

    /// Where the next token begins, if the innermost text is a file and nothing is in between.
    fn file_position(&mut self) -> Result<Option<usize>> {
        let token = self.peek()?;
        let Some(frame) = self.frames.last() else { return Ok(None) };
        let Source::File { lexer, .. } = &frame.source else { return Ok(None) };
        let here = frame.at > 0 && frame.text[frame.at - 1].span == token.span;
        Ok((here && lexer.file() == token.span.file).then_some(token.span.start as usize))
    }
}

/// A plain vector and the plain numbers behind it, if all of it is plain.
fn plain_numbered(plain: &mut Plain, components: usize, sink: &mut dyn FnMut([f64; 5], &[f64])) -> bool {
    let before = plain.position();
    let Some(v) = plain.vector(components) else { return false };
    let (mut numbers, mut n) = ([0.0; MOST_NUMBERS], 0);
    while n < MOST_NUMBERS
        && let Some(number) = plain.number()
    {
        numbers[n] = number;
        n += 1;
    }
    if !plain.at_list_end() {
        plain.seek(before);
        return false;
    }
    sink(v, &numbers[..n]);
    true
}
