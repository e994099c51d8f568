//! Directives that say or set something: versions and messages.

use super::{Parser, Result};
use crate::source::{Diagnostic, Severity, Span};
use crate::syntax::{Keyword, Punct, Tok};

/// The newest language version known, times 100.
const NEWEST: u32 = 370;

impl Parser {
    /// `#version v;`, behind the word.
    pub(super) fn version_directive(&mut self) -> Result<()> {
        if let Tok::Identifier(name) = self.peek_operand()?.tok
            && self.name(name) == "unofficial"
        {
            self.next()?;
        }
        let start = self.peek_operand()?.span;
        let before = self.hold();
        let value = self.float();
        self.release(before);
        let value = value?;
        let span = start.to(self.last);
        let version = (100.0 * value + 0.5).floor();
        if version < 0.0 || version.is_nan() {
            return Err(Box::new(Diagnostic::error(span, format!("{value} is no language version"))));
        }
        if version > f64::from(NEWEST) {
            let text = format!("language version {value} is newer than 3.7");
            self.lenient(
                Diagnostic::warning(span, text).with_hint("the scene is read as one of version 3.7"),
            )?;
        }
        if !self.version.is_declared() && self.spoken {
            let text = "the first `#version` comes late: it changes how the whole picture is rendered";
            self.warn(Diagnostic::warning(span, text).with_hint("put it on the first line"));
        }
        self.version.set((version as u32).min(NEWEST));
        if !self.accept_raw(Punct::Semicolon)? && version >= 310.0 {
            self.warn(Diagnostic::warning(after(span), "`;` is missing").with_label(MISSING_SEMICOLON));
        }
        Ok(())
    }

    /// The semicolon behind an assignment. `required`: since version 3.5 it must not be left out; it may be doubled,
    /// as by `A = Macro();` where the macro's own text ends with one.
    pub(super) fn end_assignment(&mut self, span: Span, required: bool) -> Result<()> {
        if self.accept_raw(Punct::Semicolon)? {
            return if required { self.second_semicolon() } else { Ok(()) };
        }
        if !required {
            return Ok(());
        }
        let version = self.syntax_version();
        if version < 310 {
            return Ok(());
        }
        let missing = Diagnostic::warning(after(span), "`;` is missing").with_label(MISSING_SEMICOLON);
        if version < 350 {
            self.warn(missing);
            return Ok(());
        }
        let hint = "numbers, vectors and colors are assigned with `;` at the end since version 3.5";
        let mut missing = missing.with_hint(hint);
        // Only where a statement can begin it is sure that nothing else was meant.
        let next = match self.take_ahead() {
            Some(token) => {
                self.set_raw_ahead(token);
                token.tok
            }
            None => self.glance()?,
        };
        if let Tok::Punct(_) | Tok::Number(_) | Tok::String(_) = next {
            missing.severity = Severity::Error;
            return Err(Box::new(missing));
        }
        self.lenient(missing)
    }

    /// What may stand behind `X = number;` once more.
    #[inline]
    pub(super) fn second_semicolon(&mut self) -> Result<()> {
        if self.glance()? == Tok::Punct(Punct::Semicolon) {
            self.raw()?;
        }
        Ok(())
    }

    /// Where the reference refuses a text for a reason that helps nobody: a warning, unless it is to be
    /// refused here too.
    pub(super) fn lenient(&mut self, mut diagnostic: Diagnostic) -> Result<()> {
        if self.options.strict {
            diagnostic.severity = Severity::Error;
            return Err(Box::new(diagnostic));
        }
        self.warn(diagnostic);
        Ok(())
    }

    /// `#debug s` and its like, behind the word.
    pub(super) fn message_directive(&mut self, word: Keyword, span: Span) -> Result<()> {
        let text = self.string_value()?;
        let text = shortened(&text, if word == Keyword::Debug { (200, 159) } else { (160, 127) });
        let span = span.to(self.last);
        match word {
            Keyword::Error => {
                return Err(Box::new(Diagnostic::error(span, format!("halted by `#error`: {text}"))));
            }
            Keyword::Warning => self.warn(Diagnostic::warning(span, text)),
            Keyword::Debug => self.messages.debug.push_str(&text),
            word => {
                let message = format!("`#{}` is read as `#debug`", word.text());
                self.warn(Diagnostic::warning(span, message));
                self.messages.debug.push_str(&text);
            }
        }
        Ok(())
    }

    /// `max_trace_level n` at top level, behind the word.
    pub(super) fn max_trace_level_statement(&mut self, span: Span) -> Result<()> {
        if self.syntax_version() >= 300 {
            let text = "`max_trace_level` belongs in `global_settings`";
            self.warn(Diagnostic::warning(span, text));
        }
        let level = self.float()?;
        self.scene.scene.globals.max_trace_level = level.clamp(1.0, 256.0) as u32;
        Ok(())
    }
}

const MISSING_SEMICOLON: &str = "expected `;` behind this";

/// The last byte of a span.
fn after(span: Span) -> Span {
    Span { start: span.end.saturating_sub(1).max(span.start), ..span }
}

/// Text longer than the first length is cut to the second; characters above 127 become spaces.
fn shortened(text: &str, (longest, cut): (usize, usize)) -> String {
    let plain = |c: char| if c.is_ascii() { c } else { ' ' };
    if text.chars().count() <= longest {
        return text.chars().map(plain).collect();
    }
    text.chars().map(plain).take(cut - 3).chain("...".chars()).collect()
}
