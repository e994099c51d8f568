use super::Keyword;
use crate::source::Span;

/// An interned identifier.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(pub u32);

/// An interned string literal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StringId(pub u32);

/// One token of scene text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Token {
    pub tok: Tok,
    pub span: Span,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tok {
    Number(f64),
    /// A string literal as written between its quotes, escapes not yet processed.
    String(StringId),
    Word(Keyword),
    Identifier(Symbol),
    Punct(Punct),
    /// The end of all text.
    End,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Punct {
    LeftBrace,
    RightBrace,
    LeftParen,
    RightParen,
    LeftBracket,
    RightBracket,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    Equal,
    NotEqual,
    Not,
    Comma,
    Semicolon,
    Colon,
    Question,
    Dot,
    Plus,
    Minus,
    Star,
    Slash,
    And,
    Or,
    Hash,
    /// `@ $ % ^ ~ '` and the back-quote: tokens that nothing accepts.
    Other,
}
