use super::directives::Block;
use super::kept::Kept;
use super::messages::Messages;
use super::options::Options;
use super::stream::Frame;
use super::symbols::{Binding, Symbols};
use super::version::Version;
use super::{Result, Value};
use crate::camera::Camera;
use crate::function::Surroundings;
use crate::material::{Layer, Texture};
use crate::scene::Scene;
use crate::source::{Diagnostic, FileId, Files, Span};
use crate::syntax::{Directive, Interner, Keyword, Punct, Symbol, Tok, Token};
use std::collections::HashMap;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;

/// The grammar's view of the text: tokens with directives carried out and macros expanded.
pub struct Parser {
    /// The scene so far, and the defaults in force.
    pub(crate) scene: SceneBuilder,
    pub(super) options: Options,
    pub(super) files: Files,
    pub(super) names: Interner,
    /// Texts being read, the innermost last.
    pub(super) frames: Vec<Frame>,
    /// Open conditionals and loops, the innermost last.
    pub(super) blocks: Vec<Block>,
    pub(super) symbols: Symbols,
    pub(super) messages: Messages,
    pub(super) version: Version,
    /// Where the token taken last stands.
    pub(super) last: Span,
    pub(super) ahead: Ahead,
    /// Compiled expressions of kept text.
    pub(super) programs: Vec<super::program::Program>,
    hold: Option<Hold>,
    /// Open braces, parentheses and brackets.
    nesting: usize,
    braces: Vec<Span>,
    /// Whether a statement was read that a version or a second camera comes too late for.
    pub(super) spoken: bool,
    pub(super) camera_given: bool,
    /// Files read so far.
    pub(super) loaded: HashMap<PathBuf, FileId>,
    /// Files included so far, with the tokens of those that came more than once.
    pub(super) included: HashMap<FileId, Option<Rc<Kept>>>,
    /// Images read so far.
    pub(super) images: Vec<super::grammar::LoadedImage>,
    /// What is said when a name is used.
    pub(super) deprecated: HashMap<Symbol, Arc<str>>,
    /// The name on the left of `= function`, until the word is read.
    pub(super) declaring: Option<Symbol>,
    /// Passes of loops and calls of macros so far.
    pub(super) passes: u64,
    pub(super) watch: super::limits::Watch,
    /// Text of files that was skipped before: from where, to which directive.
    pub(super) skips: HashMap<(FileId, u32), (Directive, Span)>,
    pub(super) text: super::string::TextState,
    pub(super) random: Vec<u32>,
    pub(super) queries: super::world_query::Queries,
    pub(super) text_files: Vec<Option<super::textfile::TextFile>>,
    /// Bytes that `#write` has written so far.
    pub(super) written: u64,
}

/// What statements add to while the text is read.
pub(crate) struct SceneBuilder {
    pub scene: Scene,
    /// The default texture: one layer.
    pub default_layer: Layer,
    pub default_camera: Camera,
    /// Whether `assumed_gamma` was given.
    pub gamma_given: bool,
    /// The texture read last: one written the same way from the same identifier shares it.
    pub recent_texture: Option<Arc<Texture>>,
    /// Whether `noise_generator` was given.
    pub noise_given: bool,
    /// What functions ask of the scene.
    pub surroundings: Arc<Surroundings>,
}

/// The token seen but not taken.
#[derive(Clone, Copy)]
pub(super) enum Ahead {
    None,
    /// Fit for the grammar.
    Ready(Token),
    /// As it stands in the text: perhaps a directive or a macro's name.
    Raw(Token),
}

/// Where directives and macro names wait: outside any bracket of the right side of an assignment, since
/// what comes next must find the assignment done.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Hold {
    frames: usize,
    nesting: usize,
}

impl Parser {
    pub(super) fn new(options: Options, scene: SceneBuilder) -> Self {
        let watch = super::limits::Watch::new(&options.limits);
        Self {
            scene,
            version: Version::new(options.start_version),
            options,
            files: Files::default(),
            names: Interner::default(),
            frames: Vec::new(),
            blocks: Vec::new(),
            symbols: Symbols::new(),
            messages: Messages::default(),
            last: Span::default(),
            ahead: Ahead::None,
            programs: Vec::new(),
            hold: None,
            nesting: 0,
            braces: Vec::new(),
            spoken: false,
            camera_given: false,
            loaded: HashMap::new(),
            included: HashMap::new(),
            images: Vec::new(),
            deprecated: HashMap::new(),
            declaring: None,
            passes: 0,
            watch,
            skips: HashMap::new(),
            text: Default::default(),
            random: Vec::new(),
            queries: Default::default(),
            text_files: Vec::new(),
            written: 0,
        }
    }

    /// The next token, left in place.
    #[inline]
    pub fn peek(&mut self) -> Result<Token> {
        match self.ahead {
            Ahead::Ready(token) => Ok(token),
            _ => self.fetch(false),
        }
    }

    /// The next token where a value must begin: a macro's name is expanded even in an assignment.
    #[inline]
    pub(super) fn peek_operand(&mut self) -> Result<Token> {
        match self.ahead {
            Ahead::Ready(token) => Ok(token),
            _ => self.fetch(true),
        }
    }

    /// Brings the next token for the grammar.
    fn fetch(&mut self, operand: bool) -> Result<Token> {
        match self.plain_token() {
            Some(token) => Ok(token),
            None => self.fetch_through(operand),
        }
    }

    /// The next token, if it is at hand and means what it says.
    #[inline]
    fn plain_token(&mut self) -> Option<Token> {
        if self.has_ahead() {
            return None;
        }
        let frame = self.frames.last_mut()?;
        let token = *frame.text.tokens[..frame.end].get(frame.at)?;
        let is_plain = match token.tok {
            Tok::Number(_) | Tok::String(_) | Tok::Word(_) => true,
            Tok::Punct(punct) => punct != Punct::Hash,
            Tok::Identifier(_) | Tok::Directive(_) | Tok::End => false,
        };
        is_plain.then(|| {
            frame.at += 1;
            self.ahead = Ahead::Ready(token);
            token
        })
    }

    /// Carries directives out and expands macros until a token for the grammar comes.
    #[inline(never)]
    fn fetch_through(&mut self, operand: bool) -> Result<Token> {
        loop {
            let token = match self.take_ahead() {
                Some(token) => token,
                None => self.raw()?,
            };
            match token.tok {
                Tok::Directive(_) if self.holds() => {
                    self.ahead = Ahead::Raw(token);
                    return Ok(token);
                }
                Tok::Directive(directive) => {
                    self.last = token.span;
                    self.directive(directive, token.span)?;
                }
                Tok::Identifier(name) if self.symbols.is_macro(name) => {
                    if !operand && self.holds() {
                        self.ahead = Ahead::Raw(token);
                        return Ok(token);
                    }
                    self.call_macro(name, token.span)?;
                }
                Tok::Punct(Punct::Hash) => self.lone_hash(token)?,
                _ => {
                    if !self.deprecated.is_empty()
                        && let Tok::Identifier(name) = token.tok
                    {
                        self.warn_deprecated(token, name);
                    }
                    self.ahead = Ahead::Ready(token);
                    return Ok(token);
                }
            }
        }
    }

    /// `#` without a word of the language: an unknown directive, or nothing if no name follows.
    fn lone_hash(&mut self, token: Token) -> Result<()> {
        if let Tok::Identifier(_) = self.glance()? {
            let name = self.raw()?;
            return Err(self.unexpected_token(name, "a directive"));
        }
        self.warn(Diagnostic::warning(token.span, "this `#` has no directive behind it"));
        Ok(())
    }

    fn holds(&self) -> bool {
        self.hold.is_some_and(|h| self.frames.len() <= h.frames && self.nesting <= h.nesting)
    }

    /// From here on directives and macro names wait, until [`Parser::release`].
    pub(super) fn hold(&mut self) -> Option<Hold> {
        let hold = Hold { frames: self.frames.len(), nesting: self.nesting };
        self.hold.replace(hold)
    }

    /// What waited in a text that has ended waits in the one around it.
    pub(super) fn lower_hold(&mut self) {
        if let Some(hold) = &mut self.hold {
            hold.frames = hold.frames.min(self.frames.len());
        }
    }

    /// Nothing waits any more.
    pub(super) fn release_all(&mut self) -> Option<Hold> {
        self.hold.take()
    }

    pub(super) fn release(&mut self, before: Option<Hold>) {
        self.hold = before;
        self.lower_hold();
    }

    pub(super) fn take_ahead(&mut self) -> Option<Token> {
        match std::mem::replace(&mut self.ahead, Ahead::None) {
            Ahead::None => None,
            Ahead::Ready(token) | Ahead::Raw(token) => Some(token),
        }
    }

    pub(super) fn set_raw_ahead(&mut self, token: Token) {
        self.ahead = Ahead::Raw(token);
    }

    pub(super) fn has_ahead(&self) -> bool {
        !matches!(self.ahead, Ahead::None)
    }

    /// Takes the next token.
    #[inline]
    pub fn next(&mut self) -> Result<Token> {
        let token = self.peek()?;
        self.take(token)
    }

    /// Takes the token that `peek` showed.
    #[inline]
    pub(super) fn take(&mut self, token: Token) -> Result<Token> {
        self.ahead = Ahead::None;
        self.last = token.span;
        if let Tok::Punct(punct) = token.tok {
            self.count_brackets(punct, token.span)?;
        }
        Ok(token)
    }

    fn count_brackets(&mut self, punct: Punct, span: Span) -> Result<()> {
        match punct {
            Punct::LeftBrace => {
                self.braces.push(span);
                self.deeper()
            }
            Punct::LeftParen | Punct::LeftBracket => self.deeper(),
            Punct::RightBrace => {
                self.braces.pop();
                self.shallower();
                Ok(())
            }
            Punct::RightParen | Punct::RightBracket => {
                self.shallower();
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Counts a level of nesting; the limit keeps recursion within the stack.
    pub(super) fn deeper(&mut self) -> Result<()> {
        self.nesting += 1;
        if self.nesting > self.options.limits.nesting {
            let limit = self.options.limits.nesting;
            return Err(Box::new(Diagnostic::error(
                self.last,
                format!("nested more than {limit} levels deep"),
            )));
        }
        Ok(())
    }

    pub(super) fn shallower(&mut self) {
        self.nesting = self.nesting.saturating_sub(1);
    }

    /// Takes the next token if it is `word`.
    pub fn accept(&mut self, word: Keyword) -> Result<bool> {
        let token = self.peek()?;
        if token.tok == Tok::Word(word) {
            self.take(token)?;
            return Ok(true);
        }
        Ok(false)
    }

    #[inline]
    pub fn accept_punct(&mut self, punct: Punct) -> Result<bool> {
        let token = self.peek()?;
        if token.tok == Tok::Punct(punct) {
            self.take(token)?;
            return Ok(true);
        }
        Ok(false)
    }

    pub fn expect(&mut self, word: Keyword) -> Result<Token> {
        let token = self.peek()?;
        match token.tok == Tok::Word(word) {
            true => self.take(token),
            false => Err(self.unexpected(&format!("`{}`", word.text()))),
        }
    }

    pub fn expect_punct(&mut self, punct: Punct) -> Result<Token> {
        let token = self.peek()?;
        match token.tok == Tok::Punct(punct) {
            true => self.take(token),
            false => Err(self.unexpected(&format!("`{}`", punct.text()))),
        }
    }

    /// Takes a comma if one comes: between list items they are optional.
    #[inline]
    pub fn comma(&mut self) -> Result<()> {
        self.accept_punct(Punct::Comma).map(|_| ())
    }

    /// The value of the identifier that comes next (array elements resolved), left in place; `None` if no
    /// declared identifier comes.
    pub fn peek_value(&mut self) -> Result<Option<Value>> {
        let token = self.peek_operand()?;
        let Tok::Identifier(name) = token.tok else { return Ok(None) };
        match self.symbols.value(name) {
            Some(Value::Array(_)) => {}
            value => return Ok(value.cloned()),
        }
        if self.glance()? == Tok::Punct(Punct::LeftBracket) {
            self.take(token)?;
            let value = self.element(name, token.span)?;
            self.put_element_ahead(value, token.span.to(self.last));
        }
        Ok(match self.peek_operand()?.tok {
            Tok::Identifier(name) => self.symbols.value(name).cloned(),
            _ => None,
        })
    }

    /// Makes a value the next token.
    pub(super) fn put_element_ahead(&mut self, value: Value, span: Span) {
        self.symbols.bind(Symbols::ELEMENT, super::symbols::GLOBAL, Binding::Value(value));
        self.ahead = Ahead::Ready(Token { tok: Tok::Identifier(Symbols::ELEMENT), span });
    }

    /// Takes the identifier (with its array subscripts) whose value `peek_value` showed.
    pub fn take_value(&mut self) -> Result<Value> {
        match self.peek_value()? {
            Some(value) => {
                let token = self.peek()?;
                self.take(token)?;
                Ok(value)
            }
            None => Err(self.unexpected("an identifier")),
        }
    }

    /// The spelling of an identifier.
    pub fn name(&self, symbol: Symbol) -> &str {
        self.names.spelling(symbol)
    }

    /// An error unless the condition holds.
    pub(super) fn demand(&self, holds: bool, span: Span, text: &str) -> Result<()> {
        if holds { Ok(()) } else { Err(Box::new(Diagnostic::error(span, text))) }
    }

    pub fn warn(&mut self, mut diagnostic: Diagnostic) {
        if self.messages.is_new(diagnostic.span, &diagnostic.message) {
            if diagnostic.trace.is_empty() {
                diagnostic.trace = self.call_chain();
            }
            self.messages.warnings.push(diagnostic);
        }
    }

    /// Notes a known feature that is not rendered yet: one warning, one entry in `unsupported`.
    pub fn unsupported(&mut self, span: Span, feature: &str) {
        if self.messages.unsupported.iter().any(|f| f == feature) {
            return;
        }
        self.messages.unsupported.push(feature.to_owned());
        self.warn(Diagnostic::warning(
            span,
            format!("{feature} is not rendered yet: it is read and left out"),
        ));
    }

    /// Where the token taken last stands.
    pub fn last_span(&self) -> Span {
        self.last
    }

    /// The innermost open brace.
    pub(super) fn open_brace(&self) -> Option<Span> {
        self.braces.last().copied()
    }

    /// Syntax version times 100 (`V` in the language's rules), 370 until declared otherwise.
    pub fn syntax_version(&self) -> u32 {
        self.version.syntax()
    }

    /// Effective version times 100 (`E`), 362 until declared.
    pub fn effective_version(&self) -> u32 {
        self.version.effective()
    }
}
