//! Text kept for replay, with what was compiled of it.

use super::evaluate::run;
use super::program::{Level, Program, compile};
use super::{Parser, parser::Ahead};
use crate::syntax::{Punct, Tok, Token};
use std::cell::{Cell, OnceCell};
use std::ops::Index;

/// Tokens of a loop or macro (or those at hand of a file).
#[derive(Debug, Default)]
pub(super) struct Kept {
    pub tokens: Vec<Token>,
    /// For each token what is known of the expression that begins there.
    marks: OnceCell<Box<[Cell<u32>]>>,
}

/// Nothing: no expression was read there.
const FRESH: u32 = 0;
/// An expression was read once.
const SEEN: u32 = 1;
/// The expression there cannot be compiled.
const HARD: u32 = 2;
/// The first number of a program, plus its index.
const PROGRAM: u32 = 3;

impl Kept {
    pub fn new(tokens: Vec<Token>) -> Self {
        Self { tokens, marks: OnceCell::new() }
    }

    #[inline]
    fn mark(&self, at: usize) -> &Cell<u32> {
        &self.marks.get_or_init(|| vec![Cell::new(FRESH); self.tokens.len()].into_boxed_slice())[at]
    }
}

impl Index<usize> for Kept {
    type Output = Token;

    #[inline]
    fn index(&self, at: usize) -> &Token {
        &self.tokens[at]
    }
}

impl Parser {
    /// The number that comes next, if it stands in kept text and a program gives it. Else nothing is taken.
    #[inline]
    pub(super) fn compiled(&mut self, level: Level) -> Option<f64> {
        let frame = self.frames.last()?;
        if frame.streams() || !self.joins() {
            return None;
        }
        let at = match self.ahead {
            Ahead::None => frame.at,
            Ahead::Ready(token) => frame.at.checked_sub(1).filter(|&at| frame.text[at] == token)?,
            Ahead::Raw(_) => return None,
        };
        if at >= frame.end {
            return None;
        }
        let mark = frame.text.mark(at);
        let number = match mark.get() {
            FRESH => {
                mark.set(SEEN);
                return None;
            }
            HARD => return None,
            SEEN => self.compile_at(at, level)?,
            number => number,
        };
        self.run_program((number - PROGRAM) as usize, level)
    }

    /// `X = expression;` in kept text, where X is a number already and a program gives the value: done in one
    /// step. False if it is anything else; nothing is taken then.
    #[inline]
    pub(super) fn fast_assignment(&mut self, local: bool) -> bool {
        if self.has_ahead() || !self.deprecated.is_empty() {
            return false;
        }
        let Some(frame) = self.frames.last_mut() else { return false };
        let start = frame.at;
        if frame.streams() || start + 3 > frame.end {
            return false;
        }
        let (name, equal) = (frame.text[start].tok, frame.text[start + 1].tok);
        let (Tok::Identifier(name), Tok::Punct(Punct::Equal)) = (name, equal) else { return false };
        frame.at = start + 2;
        let done = self.symbols.is_plain_float(name, local)
            && match self.compiled(Level::Additive) {
                Some(value) => self.accept_kept(Punct::Semicolon) && self.symbols.set_float(name, value),
                None => false,
            };
        if !done && let Some(frame) = self.frames.last_mut() {
            frame.at = start;
        }
        done
    }

    /// `(condition)` in kept text, by a program. Nothing is taken if it is anything else.
    #[inline]
    pub(super) fn fast_condition(&mut self) -> Option<f64> {
        if self.has_ahead() {
            return None;
        }
        let frame = self.frames.last()?;
        let start = frame.at;
        if !self.accept_kept(Punct::LeftParen) {
            return None;
        }
        let value = self.compiled(Level::Full);
        if value.is_some() && self.accept_kept(Punct::RightParen) {
            return value;
        }
        self.frames.last_mut()?.at = start;
        None
    }

    /// Takes the next token of kept text if it is `punct`.
    #[inline]
    fn accept_kept(&mut self, punct: Punct) -> bool {
        let Some(frame) = self.frames.last_mut() else { return false };
        if frame.streams() || frame.at >= frame.end {
            return false;
        }
        let token = frame.text[frame.at];
        let found = token.tok == Tok::Punct(punct);
        if found {
            frame.at += 1;
            self.last = token.span;
        }
        found
    }

    fn compile_at(&mut self, at: usize, level: Level) -> Option<u32> {
        let frame = self.frames.last()?;
        let clock = f64::from(self.options.frame.clock);
        let compiled = compile(&frame.text.tokens[..frame.end], at, level, clock);
        let number = PROGRAM + self.programs.len() as u32;
        frame.text.mark(at).set(if compiled.is_some() { number } else { HARD });
        self.programs.push(compiled?);
        Some(number)
    }

    #[inline]
    fn run_program(&mut self, index: usize, level: Level) -> Option<f64> {
        let Program { ops, level: known, end, after } = &self.programs[index];
        if *known != level || after.is_some_and(|name| self.symbols.is_macro(name)) {
            return None;
        }
        let value = run(ops, &self.symbols)?;
        let frame = self.frames.last_mut()?;
        frame.at = *end;
        self.last = frame.text[*end - 1].span;
        self.ahead = Ahead::None;
        Some(value)
    }
}
