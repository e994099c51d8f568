use super::{Directive, Interner, Punct, SPELLINGS, Symbol, Tok, Token, parse_number};
use crate::source::{Diagnostic, FileId, Span, Text};
use logos::{FilterResult, Logos, Skip};

/// What the scanner tells apart; [`Lexer`] gives it meaning.
#[derive(Logos, Clone, Copy, Debug, PartialEq)]
#[logos(utf8 = false, error = Fault)]
#[logos(skip r"[ \t\r\n\x0B\x0C\x00\x1A]+")]
enum Lexeme {
    #[regex(r"[A-Za-z_][A-Za-z0-9_]*")]
    Name,
    #[regex(r"([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]*)?")]
    Number,
    #[token("\"", string)]
    String,
    #[token("//", line_comment)]
    #[token("/*", block_comment)]
    Comment,
    #[token("{", |_| Punct::LeftBrace)]
    #[token("}", |_| Punct::RightBrace)]
    #[token("(", |_| Punct::LeftParen)]
    #[token(")", |_| Punct::RightParen)]
    #[token("[", |_| Punct::LeftBracket)]
    #[token("]", |_| Punct::RightBracket)]
    #[token("<", |_| Punct::Less)]
    #[token(">", |_| Punct::Greater)]
    #[token("<=", |_| Punct::LessEqual)]
    #[token(">=", |_| Punct::GreaterEqual)]
    #[token("=", |_| Punct::Equal)]
    #[token("!=", |_| Punct::NotEqual)]
    #[token("!", |_| Punct::Not)]
    #[token(",", |_| Punct::Comma)]
    #[token(";", |_| Punct::Semicolon)]
    #[token(":", |_| Punct::Colon)]
    #[token("?", |_| Punct::Question)]
    #[token(".", |_| Punct::Dot)]
    #[token("+", |_| Punct::Plus)]
    #[token("-", |_| Punct::Minus)]
    #[token("*", |_| Punct::Star)]
    #[token("/", |_| Punct::Slash)]
    #[token("&", |_| Punct::And)]
    #[token("|", |_| Punct::Or)]
    #[token("#", |_| Punct::Hash)]
    #[token("^", |_| Punct::Caret)]
    #[regex(r"[@$%~'`]", |_| Punct::Other)]
    Punct(Punct),
}

/// Why text is not a token.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Fault {
    #[default]
    Character,
    OpenComment,
    OpenString,
    StringTooLong,
}

/// Longest identifier and longest string literal, in bytes.
const LONGEST_TEXT: usize = 255;

/// `/* … */`, which nest.
fn block_comment(lexer: &mut logos::Lexer<Lexeme>) -> FilterResult<(), Fault> {
    let rest = lexer.remainder();
    let (mut depth, mut at) = (1, 0);
    while at + 1 < rest.len() {
        match (rest[at], rest[at + 1]) {
            (b'*', b'/') => (depth, at) = (depth - 1, at + 2),
            (b'/', b'*') => (depth, at) = (depth + 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            lexer.bump(at);
            return FilterResult::Skip;
        }
    }
    FilterResult::Error(Fault::OpenComment)
}

fn line_comment(lexer: &mut logos::Lexer<Lexeme>) -> Skip {
    let rest = lexer.remainder();
    lexer.bump(rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len()));
    Skip
}

/// Up to the closing quote; a backslash keeps the character after it from closing the string.
fn string(lexer: &mut logos::Lexer<Lexeme>) -> Result<(), Fault> {
    let rest = lexer.remainder();
    let mut at = 0;
    while let Some(&b) = rest.get(at) {
        match b {
            b'"' if at > LONGEST_TEXT => return Err(Fault::StringTooLong),
            b'"' => {
                lexer.bump(at + 1);
                return Ok(());
            }
            b'\\' => at += 2,
            _ => at += 1,
        }
    }
    Err(Fault::OpenString)
}

/// Reads one file's text, token by token.
#[derive(Debug)]
pub struct Lexer {
    text: Text,
    file: FileId,
    at: usize,
}

impl Lexer {
    pub fn new(file: FileId, text: Text) -> Self {
        Self { text, file, at: 0 }
    }

    pub fn file(&self) -> FileId {
        self.file
    }

    pub fn text(&self) -> &Text {
        &self.text
    }

    /// Where the next token is looked for.
    pub fn position(&self) -> usize {
        self.at
    }

    /// Goes on reading at another byte.
    pub fn seek(&mut self, at: usize) {
        self.at = at;
    }

    /// The place behind the last byte.
    pub fn end_span(&self) -> Span {
        let end = self.text.len() as u32;
        Span { file: self.file, start: end, end }
    }

    /// Appends up to `limit` tokens. Stops early at the end of the text (`Ok(true)`), and in front of
    /// text that is no token; calling again then reports it.
    pub fn fill(
        &mut self,
        names: &mut Interner,
        out: &mut Vec<Token>,
        limit: usize,
    ) -> Result<bool, Box<Diagnostic>> {
        let text = self.text.clone();
        let mut scanner = Lexeme::lexer(&text[..]);
        scanner.bump(self.at);
        for _ in 0..limit {
            match next(&mut scanner, self.file, names) {
                Ok(Some(token)) => out.push(token),
                Ok(None) => {
                    self.at = text.len();
                    return Ok(true);
                }
                Err(_) if !out.is_empty() => return Ok(false),
                Err(diagnostic) => return Err(diagnostic),
            }
            self.at = scanner.span().end;
        }
        Ok(false)
    }
}

fn next(
    scanner: &mut logos::Lexer<Lexeme>,
    file: FileId,
    names: &mut Interner,
) -> Result<Option<Token>, Box<Diagnostic>> {
    let Some(lexeme) = scanner.next() else {
        return Ok(None);
    };
    let range = scanner.span();
    let mut span = Span { file, start: range.start as u32, end: range.end as u32 };
    let tok = match lexeme.map_err(|fault| explain(fault, span, scanner))? {
        Lexeme::Punct(Punct::Hash) => {
            let (tok, end) = directive(scanner, names);
            span.end = end as u32;
            tok
        }
        Lexeme::Punct(punct) => Tok::Punct(punct),
        Lexeme::Number => number(scanner, span)?,
        Lexeme::Name => name(scanner.slice(), span, names)?,
        Lexeme::String => {
            let slice = scanner.slice();
            Tok::String(names.string(&slice[1..slice.len() - 1]))
        }
        Lexeme::Comment => return next(scanner, file, names),
    };
    Ok(Some(Token { tok, span }))
}

fn name(slice: &[u8], span: Span, names: &mut Interner) -> Result<Tok, Box<Diagnostic>> {
    if slice.len() > LONGEST_TEXT {
        return Err(Box::new(Diagnostic::error(
            span,
            format!("a name has more than {LONGEST_TEXT} characters"),
        )));
    }
    let symbol = names.name(slice);
    Ok(match SPELLINGS.get(symbol.0 as usize) {
        Some((_, word)) => Tok::Word(*word),
        None => Tok::Identifier(Symbol(symbol.0)),
    })
}

fn number(scanner: &logos::Lexer<Lexeme>, span: Span) -> Result<Tok, Box<Diagnostic>> {
    if scanner.slice().contains(&b'.') && scanner.remainder().first() == Some(&b'.') {
        return Err(Box::new(
            Diagnostic::error(span, "a number has two decimal points").with_label("a second point follows"),
        ));
    }
    Ok(Tok::Number(parse_number(scanner.slice())))
}

/// The word after `#`, and where it ends; a lone `#` if none follows.
fn directive(scanner: &mut logos::Lexer<Lexeme>, names: &mut Interner) -> (Tok, usize) {
    let mut ahead = scanner.clone();
    if ahead.next() == Some(Ok(Lexeme::Name)) {
        let symbol = names.name(ahead.slice());
        if let Some((_, word)) = SPELLINGS.get(symbol.0 as usize) {
            *scanner = ahead;
            let directive = Directive { word: *word, target: Directive::UNKNOWN };
            return (Tok::Directive(directive), scanner.span().end);
        }
    }
    (Tok::Punct(Punct::Hash), scanner.span().end)
}

fn explain(fault: Fault, mut span: Span, scanner: &logos::Lexer<Lexeme>) -> Box<Diagnostic> {
    span.end = span.end.max(span.start + 1);
    Box::new(match fault {
        Fault::Character => {
            let byte = scanner.slice().first().copied().unwrap_or(0);
            Diagnostic::error(span, format!("illegal character (byte {byte}) in scene text"))
                .with_hint("outside strings and comments only ASCII is allowed")
        }
        Fault::OpenComment => Diagnostic::error(span, "this comment has no end")
            .with_hint("block comments nest: each `/*` needs its `*/`"),
        Fault::OpenString => Diagnostic::error(span, "this string has no closing quote"),
        Fault::StringTooLong => {
            Diagnostic::error(span, format!("a string literal has more than {LONGEST_TEXT} bytes"))
                .with_hint("join shorter ones with concat()")
        }
    })
}
