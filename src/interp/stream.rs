//! The token stream: files as they are read, kept text as it is replayed.

use super::kept::Kept;
use super::{Parser, Result};
use crate::source::{Diagnostic, FileId, Label, Span};
use crate::syntax::{Directive, Keyword, Lexer, Punct, Symbol, Tok, Token};
use std::rc::Rc;

/// How many tokens a file's lexer hands over at a time.
const BATCH: usize = 256;

/// One text being read.
#[derive(Debug)]
pub(super) struct Frame {
    /// For files that are read for the first time the tokens at hand, else the whole text.
    pub text: Rc<Kept>,
    pub at: usize,
    pub end: usize,
    pub source: Source,
    /// How many blocks were open when the frame began.
    pub blocks: usize,
    /// The directive or call that began it.
    pub call: Span,
}

#[derive(Debug)]
pub(super) enum Source {
    File {
        lexer: Lexer,
        /// Whether `tokens` hold all that is left.
        done: bool,
        /// Whether the text is the whole file's, kept from an earlier time.
        kept: bool,
    },
    /// A loop of a file.
    Loop,
    Macro(Symbol),
    /// Tokens put back.
    Again,
}

impl Frame {
    pub fn file(lexer: Lexer, blocks: usize, call: Span) -> Self {
        let source = Source::File { lexer, done: false, kept: false };
        Self { text: Rc::default(), at: 0, end: 0, source, blocks, call }
    }

    /// A file whose tokens are known.
    pub fn kept_file(lexer: Lexer, text: Rc<Kept>, blocks: usize, call: Span) -> Self {
        let end = text.tokens.len();
        Self { text, at: 0, end, source: Source::File { lexer, done: true, kept: true }, blocks, call }
    }

    pub fn kept(text: Rc<Kept>, range: (usize, usize), source: Source, blocks: usize, call: Span) -> Self {
        Self { text, at: range.0, end: range.1, source, blocks, call }
    }

    /// Whether the frame has a symbol table of its own.
    pub fn has_scope(&self) -> bool {
        matches!(self.source, Source::File { .. } | Source::Macro(_))
    }

    fn is_file(&self) -> bool {
        matches!(self.source, Source::File { .. })
    }

    /// Whether tokens come and go: then nothing can be told by where they stand.
    #[inline]
    pub fn streams(&self) -> bool {
        matches!(self.source, Source::File { kept: false, .. })
    }

    /// Goes on reading the file's text at byte `at`.
    pub fn read_from(&mut self, at: usize) {
        let Source::File { lexer, done, kept } = &mut self.source else { return };
        lexer.seek(at);
        (*done, *kept) = (false, false);
        match Rc::get_mut(&mut self.text) {
            Some(text) => text.tokens.clear(),
            None => self.text = Rc::default(),
        }
        (self.at, self.end) = (0, 0);
    }

    pub fn file_id(&self) -> Option<FileId> {
        match &self.source {
            Source::File { lexer, .. } => Some(lexer.file()),
            _ => self.text.tokens.first().map(|t| t.span.file),
        }
    }
}

impl Parser {
    /// The next token of the text as it stands: directives and macro names included.
    pub(super) fn raw(&mut self) -> Result<Token> {
        loop {
            let Some(frame) = self.frames.last_mut() else {
                return Ok(Token { tok: Tok::End, span: self.last });
            };
            if frame.at < frame.end {
                let token = frame.text[frame.at];
                frame.at += 1;
                return Ok(token);
            }
            if self.refill()? {
                continue;
            }
            if self.frames.len() == 1 {
                return self.at_end();
            }
            self.leave_frame()?;
        }
    }

    /// The next token of the innermost text alone; `None` at its end.
    pub(super) fn raw_here(&mut self) -> Result<Option<Token>> {
        let Some(frame) = self.frames.last_mut() else { return Ok(None) };
        if frame.at == frame.end && !self.refill()? {
            return Ok(None);
        }
        Ok(self.frames.last_mut().map(|frame| {
            frame.at += 1;
            frame.text[frame.at - 1]
        }))
    }

    /// Whether the word taken last was the last one of a macro.
    pub(super) fn is_end_of_macro(&self) -> bool {
        let frame = self.frames.last();
        !self.has_ahead() && frame.is_some_and(|f| f.at == f.end && matches!(f.source, Source::Macro(_)))
    }

    /// Reads on in the innermost text if it is a file; whether there are more tokens now.
    fn refill(&mut self) -> Result<bool> {
        match self.frames.len() {
            0 => Ok(false),
            n => {
                self.watch()?;
                self.refill_frame(n - 1)
            }
        }
    }

    fn refill_frame(&mut self, index: usize) -> Result<bool> {
        let frame = &mut self.frames[index];
        let Source::File { lexer, done, .. } = &mut frame.source else { return Ok(false) };
        if *done {
            return Ok(false);
        }
        // Tokens that come and go are never shared: kept text is copied out of them.
        let Some(Kept { tokens, .. }) = Rc::get_mut(&mut frame.text) else { return Ok(false) };
        tokens.clear();
        (frame.at, frame.end) = (0, 0);
        *done = lexer.fill(&mut self.names, tokens, BATCH)?;
        frame.end = tokens.len();
        Ok(frame.end > 0)
    }

    /// The end of the main text: every block must be closed.
    fn at_end(&mut self) -> Result<Token> {
        self.check_blocks()?;
        let span = match self.frames.last().map(|f| &f.source) {
            Some(Source::File { lexer, .. }) => lexer.end_span(),
            _ => self.last,
        };
        Ok(Token { tok: Tok::End, span })
    }

    fn leave_frame(&mut self) -> Result<()> {
        self.check_blocks()?;
        if let Some(frame) = self.frames.pop()
            && frame.has_scope()
        {
            self.symbols.leave();
        }
        self.lower_hold();
        Ok(())
    }

    pub(super) fn enter_frame(&mut self, frame: Frame) {
        self.put_back_ahead();
        self.frames.push(frame);
    }

    /// A token seen too early stands behind the text that now begins.
    fn put_back_ahead(&mut self) {
        if let Some(token) = self.take_ahead() {
            let text = Rc::new(Kept::new(vec![token]));
            let blocks = self.blocks.len();
            self.frames.push(Frame::kept(text, (0, 1), Source::Again, blocks, token.span));
        }
    }

    /// The token after the one seen ahead (or the next one), as it stands, without reading past it.
    pub(super) fn glance(&mut self) -> Result<Tok> {
        for index in (0..self.frames.len()).rev() {
            let frame = &self.frames[index];
            if frame.at < frame.end || (frame.is_file() && self.refill_frame(index)?) {
                let frame = &self.frames[index];
                return Ok(frame.text[frame.at].tok);
            }
        }
        Ok(Tok::End)
    }

    /// Takes the next token as it stands if it is `punct`.
    pub(super) fn accept_raw(&mut self, punct: Punct) -> Result<bool> {
        let token = match self.take_ahead() {
            Some(token) => token,
            None => self.raw()?,
        };
        if token.tok == Tok::Punct(punct) {
            self.last = token.span;
            return Ok(true);
        }
        self.set_raw_ahead(token);
        Ok(false)
    }

    /// Everything up to and including the `#end` of the block that `first` opens, with targets filled in.
    pub(super) fn capture(&mut self, first: Token) -> Result<Vec<Token>> {
        let mut kept = vec![first];
        let mut depth = 1;
        while depth > 0 {
            let Some(token) = self.raw_here()? else {
                return Err(missing_end(first));
            };
            if let Tok::Directive(d) = token.tok {
                depth += i32::from(opens_block(d.word));
                depth -= i32::from(d.word == Keyword::End);
            }
            kept.push(token);
            if kept.len() > self.options.limits.kept_tokens {
                return Err(Box::new(
                    Diagnostic::error(first.span, "this loop or macro is too long to keep")
                        .with_hint("`--limit tokens=N` allows more"),
                ));
            }
        }
        link(&mut kept);
        Ok(kept)
    }

    /// Skips to the next clause of the innermost block, or its `#end`, and takes that directive. `target`
    /// is where it stands if that is known; `opener` is who wants it.
    pub(super) fn skip_clause(&mut self, target: u32, opener: Span) -> Result<(Directive, Span)> {
        if target != Directive::UNKNOWN
            && let Some(frame) = self.frames.last_mut()
            && let Some(&Token { tok: Tok::Directive(d), span }) = frame.text.tokens.get(target as usize)
        {
            frame.at = target as usize + 1;
            return Ok((d, span));
        }
        let from = (self.last.file, self.last.end);
        // The word taken last may stand in a macro: then it does not tell where this text is.
        let here = self.frames.last().is_some_and(|f| f.at > 0 && f.text[f.at - 1].span == self.last);
        if here
            && let Some(&(d, span)) = self.skips.get(&from)
            && self.seek_file(span)
        {
            self.last = span;
            return Ok((d, span));
        }
        let (d, span) = self.find_clause(opener)?;
        if here && from.0 == span.file && from.1 <= span.start {
            self.skips.insert(from, (d, span));
        }
        self.last = span;
        Ok((d, span))
    }

    /// The next clause of the innermost block, or its `#end`.
    fn find_clause(&mut self, opener: Span) -> Result<(Directive, Span)> {
        let mut depth = 0;
        while let Some(token) = self.raw_here()? {
            let Tok::Directive(d) = token.tok else { continue };
            match d.word {
                Keyword::End if depth == 0 => return Ok((d, token.span)),
                Keyword::End => depth -= 1,
                word if opens_block(word) => depth += 1,
                word if depth == 0 && is_clause(word) => return Ok((d, token.span)),
                _ => {}
            }
        }
        Err(missing_end(Token { tok: Tok::End, span: opener }))
    }

    /// Goes on behind `span`, if the innermost text is that file.
    fn seek_file(&mut self, span: Span) -> bool {
        let Some(frame) = self.frames.last_mut() else { return false };
        let Source::File { lexer, kept: false, .. } = &frame.source else { return false };
        if lexer.file() != span.file {
            return false;
        }
        frame.read_from(span.end as usize);
        true
    }

    /// "in macro … called here", innermost first.
    pub(super) fn call_chain(&self) -> Vec<Label> {
        let inner = self.frames.iter().skip(1).rev();
        let mut chain = Vec::new();
        for frame in inner {
            let message = match &frame.source {
                Source::Macro(name) => format!("in macro `{}`, called here", self.name(*name)),
                Source::File { .. } => "in a file included here".to_owned(),
                Source::Loop | Source::Again => continue,
            };
            chain.push(Label { span: frame.call, message });
            if chain.len() == MOST_CALLS {
                break;
            }
        }
        chain
    }
}

/// How many calls a diagnostic lists.
const MOST_CALLS: usize = 12;

pub(super) fn missing_end(first: Token) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(first.span, "this has no `#end` in its file").with_label("opened here"))
}

/// Directives that an `#end` closes.
pub(super) fn opens_block(word: Keyword) -> bool {
    use Keyword::*;
    matches!(word, If | Ifdef | Ifndef | Switch | While | For | Macro)
}

fn is_clause(word: Keyword) -> bool {
    use Keyword::*;
    matches!(word, Else | Elseif | Case | Range)
}

/// Fills in the targets of every directive in kept text.
pub(super) fn link(tokens: &mut [Token]) {
    // The directive whose target comes next, and whether its block has clauses, for each open block.
    let mut open: Vec<(usize, bool)> = Vec::new();
    for at in 0..tokens.len() {
        let Tok::Directive(d) = tokens[at].tok else { continue };
        if opens_block(d.word) {
            let clauses = !matches!(d.word, Keyword::While | Keyword::For | Keyword::Macro);
            open.push((at, clauses));
        } else if d.word == Keyword::End {
            if let Some((from, _)) = open.pop() {
                set_target(&mut tokens[from], at);
            }
        } else if is_clause(d.word)
            && let Some((from, true)) = open.last_mut()
        {
            set_target(&mut tokens[*from], at);
            *from = at;
        }
    }
}

fn set_target(token: &mut Token, target: usize) {
    if let Tok::Directive(d) = &mut token.tok {
        d.target = target as u32;
    }
}
