//! Directives: conditionals, loops, and the dispatch of the others.

use super::kept::Kept;
use super::stream::{Frame, Source, missing_end};
use super::symbols::Binding;
use super::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Directive, Keyword, Punct, Symbol, Tok, Token};
use std::rc::Rc;

/// Below this a number counts as 0 in conditions, and two numbers as equal.
pub(super) const TINY: f64 = 1e-10;

/// A conditional or loop that is being carried out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    kind: Kind,
    /// Where the clause after the one being read stands, if known.
    target: u32,
    /// The directive that opened it.
    pub span: Span,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// A clause of `#if` that holds.
    If,
    /// A clause of `#switch` that holds, or one fallen into.
    Switch,
    /// `start` is the token behind `#while`.
    While { start: usize },
    /// `start` is the token behind the loop's head.
    For { symbol: Symbol, start: usize, end: f64, step: f64 },
}

impl Parser {
    /// Carries out one directive, behind its word.
    pub(super) fn directive(&mut self, directive: Directive, span: Span) -> Result<()> {
        use Keyword as K;
        // What a directive reads is its own matter: assignments that wait do not hold it up.
        let hold = self.release_all();
        let done = match directive.word {
            K::Declare => self.declare_directive(false),
            K::Local => self.declare_directive(true),
            K::If | K::Ifdef | K::Ifndef => self.open_if(directive, span),
            K::Else | K::Elseif => self.leave_clause(directive, span),
            K::Case | K::Range => self.next_case(directive, span),
            K::End => self.end_block(span),
            K::While => self.open_while(directive, span),
            K::For => self.open_for(directive, span),
            K::Switch => self.open_switch(span),
            K::Break => self.break_block(span),
            K::Macro => self.define_macro(directive, span),
            K::Include => self.include_directive(span),
            K::Version => self.version_directive(),
            K::Undef => self.undef_directive(),
            K::Default => self.default_statement(),
            K::Fopen => self.fopen_directive(),
            K::Fclose => self.fclose_directive(),
            K::Read => self.read_directive(),
            K::Write => self.write_directive(),
            K::Debug | K::Render | K::Statistics | K::Warning | K::Error => {
                self.message_directive(directive.word, span)
            }
            K::MaxTraceLevel => self.max_trace_level_statement(span),
            word => Err(Box::new(Diagnostic::error(span, format!("`#{}` is no directive", word.text())))),
        };
        self.release(hold);
        done
    }

    fn open_block(&mut self, kind: Kind, target: u32, span: Span) -> Result<()> {
        let limit = self.options.limits.blocks;
        if self.blocks.len() >= limit {
            let message = format!("more than {limit} conditionals and loops within each other");
            return Err(Box::new(Diagnostic::error(span, message)));
        }
        self.blocks.push(Block { kind, target, span });
        Ok(())
    }

    /// The innermost block of the innermost text.
    fn block(&mut self, span: Span, word: &str) -> Result<&mut Block> {
        let base = self.frames.last().map_or(0, |f| f.blocks);
        let open = self.blocks.len() > base;
        match self.blocks.last_mut() {
            Some(block) if open => Ok(block),
            _ => Err(stray(span, word)),
        }
    }

    /// `#if (…)`, `#ifdef (…)`, `#ifndef (…)`.
    fn open_if(&mut self, directive: Directive, span: Span) -> Result<()> {
        let holds = match directive.word {
            Keyword::If => self.condition_in_parens()?,
            word => self.defined_in_parens()? == (word == Keyword::Ifdef),
        };
        if holds {
            return self.open_block(Kind::If, directive.target, span);
        }
        let mut target = directive.target;
        loop {
            let (clause, at) = self.skip_clause(target, span)?;
            target = clause.target;
            match clause.word {
                Keyword::End => return Ok(()),
                Keyword::Else => return self.open_block(Kind::If, target, span),
                Keyword::Elseif => {
                    if self.condition_in_parens()? {
                        return self.open_block(Kind::If, target, span);
                    }
                }
                word => return Err(stray(at, word.text())),
            }
        }
    }

    /// `#else` or `#elseif` behind a clause that held: on to the end. In a `#switch` it is fallen into.
    fn leave_clause(&mut self, directive: Directive, span: Span) -> Result<()> {
        let word = directive.word.text();
        let block = self.block(span, word)?;
        match block.kind {
            Kind::If => {
                let opener = block.span;
                self.blocks.pop();
                self.skip_to_end(directive.target, opener)
            }
            Kind::Switch if directive.word == Keyword::Else => {
                block.target = directive.target;
                Ok(())
            }
            _ => Err(stray(span, word)),
        }
    }

    /// Skips behind the `#end` of the innermost block.
    fn skip_to_end(&mut self, mut target: u32, opener: Span) -> Result<()> {
        loop {
            let (clause, _) = self.skip_clause(target, opener)?;
            if clause.word == Keyword::End {
                return Ok(());
            }
            target = clause.target;
        }
    }

    fn end_block(&mut self, span: Span) -> Result<()> {
        let block = *self.block(span, "end")?;
        match block.kind {
            Kind::If | Kind::Switch => {
                self.blocks.pop();
                Ok(())
            }
            Kind::While { start } => {
                self.seek(start);
                self.count_pass(span)?;
                if !self.condition_in_parens()? {
                    self.blocks.pop();
                    self.seek(block.target as usize + 1);
                }
                Ok(())
            }
            Kind::For { symbol, start, end, step } => self.next_pass(symbol, start, end, step, block),
        }
    }

    fn seek(&mut self, at: usize) {
        if let Some(frame) = self.frames.last_mut() {
            frame.at = at.min(frame.end);
        }
    }

    /// Keeps a loop that stands in a file, to be replayed. False if it is kept already.
    fn keep_loop(&mut self, directive: Directive, span: Span) -> Result<bool> {
        if directive.target != Directive::UNKNOWN {
            return Ok(false);
        }
        let kept = self.capture(Token { tok: Tok::Directive(directive), span })?;
        let range = (0, kept.len());
        let frame = Frame::kept(Rc::new(Kept::new(kept)), range, Source::Loop, self.blocks.len(), span);
        self.enter_frame(frame);
        Ok(true)
    }

    fn position(&self) -> usize {
        self.frames.last().map_or(0, |f| f.at)
    }

    fn open_while(&mut self, directive: Directive, span: Span) -> Result<()> {
        if self.keep_loop(directive, span)? {
            return Ok(());
        }
        let start = self.position();
        let depth = self.frames.len();
        if !self.condition_in_parens()? {
            self.seek(directive.target as usize + 1);
            return Ok(());
        }
        if self.frames.len() != depth {
            return Err(missing_end(Token { tok: Tok::Directive(directive), span }));
        }
        self.open_block(Kind::While { start }, directive.target, span)
    }

    /// `#for (ID, start, end, step)`.
    fn open_for(&mut self, directive: Directive, span: Span) -> Result<()> {
        if self.keep_loop(directive, span)? {
            return Ok(());
        }
        self.expect_punct(Punct::LeftParen)?;
        let name = self.raw()?;
        let Tok::Identifier(symbol) = name.tok else {
            return Err(self.unexpected_token(name, "a name for the loop's variable"));
        };
        self.comma()?;
        let start = self.float()?;
        self.comma()?;
        let end = self.float()?;
        self.comma()?;
        let step = if self.peek()?.tok == Tok::Punct(Punct::RightParen) { 1.0 } else { self.float()? };
        self.expect_punct(Punct::RightParen)?;
        if step.abs() < TINY {
            return Err(Box::new(Diagnostic::error(span, "the step of a `#for` loop is 0")));
        }
        self.assign_local(symbol, Value::Float(start), name.span)?;
        if !goes_on(start, end, step) {
            self.seek(directive.target as usize + 1);
            return Ok(());
        }
        let kind = Kind::For { symbol, start: self.position(), end, step };
        self.open_block(kind, directive.target, span)
    }

    fn next_pass(&mut self, symbol: Symbol, start: usize, end: f64, step: f64, block: Block) -> Result<()> {
        self.count_pass(block.span)?;
        let Some(Value::Float(value)) = self.symbols.value(symbol) else {
            let message = format!("the loop's variable `{}` is no number any more", self.name(symbol));
            return Err(Box::new(Diagnostic::error(block.span, message)));
        };
        let value = value + step;
        match self.symbols.float_mut(symbol) {
            Some(place) => *place = value,
            None => self.assign_local(symbol, Value::Float(value), block.span)?,
        }
        if goes_on(value, end, step) {
            self.seek(start);
        } else {
            self.blocks.pop();
            self.seek(block.target as usize + 1);
        }
        Ok(())
    }

    /// `#switch (e)`, up to the first clause that matches.
    fn open_switch(&mut self, span: Span) -> Result<()> {
        self.expect_punct(Punct::LeftParen)?;
        let value = self.condition()?;
        self.expect_punct(Punct::RightParen)?;
        self.deeper()?;
        let (mut clause, mut at) = self.first_case(span)?;
        self.shallower();
        loop {
            let target = clause.target;
            let matches = match clause.word {
                Keyword::End => return Ok(()),
                Keyword::Else => true,
                Keyword::Case | Keyword::Range => self.case_matches(clause.word, value)?,
                word => return Err(stray(at, word.text())),
            };
            if matches {
                return self.open_block(Kind::Switch, target, span);
            }
            (clause, at) = self.skip_clause(target, span)?;
        }
    }

    /// Takes the first clause of a `#switch`. Directives before it are carried out; nothing else may stand there.
    fn first_case(&mut self, span: Span) -> Result<(Directive, Span)> {
        let (frames, blocks) = (self.frames.len(), self.blocks.len());
        loop {
            let token = match self.take_ahead() {
                Some(token) => token,
                None => self.raw()?,
            };
            self.last = token.span;
            let inside = self.blocks.len() > blocks;
            match token.tok {
                _ if self.frames.len() < frames => return Err(no_case(span)),
                Tok::Directive(d) => match d.word {
                    Keyword::Case | Keyword::Range if !inside && self.frames.len() == frames => {
                        return Ok((d, token.span));
                    }
                    Keyword::End | Keyword::Else | Keyword::Elseif | Keyword::Break if !inside => {
                        return Err(no_case(span));
                    }
                    _ => self.directive(d, token.span)?,
                },
                Tok::Identifier(name) if self.symbols.is_macro(name) => self.call_macro(name, token.span)?,
                _ => return Err(no_case(span)),
            }
        }
    }

    /// `(v)` or `(a, b)` behind `#case` or `#range`.
    fn case_matches(&mut self, word: Keyword, value: f64) -> Result<bool> {
        self.expect_punct(Punct::LeftParen)?;
        let low = self.float()?;
        let matches = if word == Keyword::Range {
            self.comma()?;
            let high = self.float()?;
            low <= value && value <= high
        } else {
            (low - value).abs() < TINY
        };
        self.expect_punct(Punct::RightParen)?;
        Ok(matches)
    }

    /// `#case` or `#range` met behind a clause that matched: its value is read, and it is fallen into.
    fn next_case(&mut self, directive: Directive, span: Span) -> Result<()> {
        let word = directive.word;
        if self.block(span, word.text())?.kind != Kind::Switch {
            return Err(stray(span, word.text()));
        }
        self.case_matches(word, 0.0)?;
        if let Some(block) = self.blocks.last_mut() {
            block.target = directive.target;
        }
        Ok(())
    }

    /// Leaves the innermost loop, clause of a `#switch`, or macro.
    fn break_block(&mut self, span: Span) -> Result<()> {
        let base = self.frames.last().map_or(0, |f| f.blocks);
        while self.blocks.len() > base {
            let Some(block) = self.blocks.pop() else { break };
            match block.kind {
                Kind::If if block.target == Directive::UNKNOWN => {
                    self.skip_to_end(block.target, block.span)?
                }
                Kind::If => {}
                Kind::Switch => return self.skip_to_end(block.target, block.span),
                Kind::While { .. } | Kind::For { .. } => {
                    self.seek(block.target as usize + 1);
                    return Ok(());
                }
            }
        }
        match self.frames.last_mut() {
            Some(frame) if matches!(frame.source, Source::Macro(_)) => {
                frame.at = frame.end;
                Ok(())
            }
            _ => Err(stray(span, "break")),
        }
    }

    /// Every block opened in the innermost text must be closed at its end.
    pub(super) fn check_blocks(&mut self) -> Result<()> {
        let base = self.frames.last().map_or(0, |f| f.blocks);
        match self.blocks.last() {
            Some(block) if self.blocks.len() > base => {
                Err(missing_end(Token { tok: Tok::End, span: block.span }))
            }
            _ => Ok(()),
        }
    }

    /// Counts a pass of a loop or a call of a macro.
    pub(super) fn count_pass(&mut self, span: Span) -> Result<()> {
        self.passes += 1;
        if self.passes > self.options.limits.passes {
            let limit = self.options.limits.passes;
            let message = format!("more than {limit} passes of loops and calls of macros");
            return Err(Box::new(
                Diagnostic::error(span, message)
                    .with_hint("does a loop never end? `--limit passes=N` gives it more"),
            ));
        }
        self.watch()
    }

    /// `(condition)`.
    fn condition_in_parens(&mut self) -> Result<bool> {
        if let Some(value) = self.fast_condition() {
            return Ok(value.abs() > TINY);
        }
        self.expect_punct(Punct::LeftParen)?;
        let value = self.condition()?;
        self.expect_punct(Punct::RightParen)?;
        Ok(value.abs() > TINY)
    }

    /// `(ID)`, where a name or an array element may be defined or not.
    pub(super) fn defined_in_parens(&mut self) -> Result<bool> {
        let open = self.raw()?;
        if open.tok != Tok::Punct(Punct::LeftParen) {
            return Err(self.unexpected_token(open, "`(` and a name"));
        }
        self.deeper()?;
        let name = self.raw()?;
        let defined = match name.tok {
            Tok::Identifier(symbol) => self.is_defined(symbol, name.span)?,
            Tok::Word(_) => false,
            _ => return Err(self.unexpected_token(name, "a name")),
        };
        self.expect_punct(Punct::RightParen)?;
        Ok(defined)
    }

    fn is_defined(&mut self, symbol: Symbol, span: Span) -> Result<bool> {
        match self.symbols.binding(symbol) {
            None => Ok(false),
            Some(Binding::Macro(_) | Binding::File(_)) => Ok(true),
            Some(_) => {
                let Some(mut reference) = self.symbols.reference(symbol) else { return Ok(false) };
                if self.symbols.target(&reference).is_some() {
                    self.subscripts(&mut reference, span)?;
                }
                Ok(self.symbols.target(&reference).is_some())
            }
        }
    }
}

fn goes_on(value: f64, end: f64, step: f64) -> bool {
    if step > 0.0 { value < end + TINY } else { value > end - TINY }
}

fn no_case(span: Span) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(span, "`#switch` must be followed by `#case` or `#range`"))
}

fn stray(span: Span, word: &str) -> Box<Diagnostic> {
    Box::new(
        Diagnostic::error(span, format!("`#{word}` stands alone"))
            .with_label("no block that it belongs to is open in this file or macro"),
    )
}
