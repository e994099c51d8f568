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
    /// `#` and the word after it. The interpreter carries directives out before the grammar sees them.
    Directive(Directive),
    /// The end of all text.
    End,
}

/// A directive's word, and in replayed text the token where its block goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Directive {
    pub word: Keyword,
    /// Index of the next clause (`#else`, `#case`, … `#end`) of the block that begins or goes on here, for a
    /// loop or macro of its `#end`; [`Directive::UNKNOWN`] in text that is not kept, and for other words.
    pub target: u32,
}

impl Directive {
    pub const UNKNOWN: u32 = u32::MAX;
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
    Caret,
    /// `@ $ % ~ '` and the back-quote: tokens that nothing accepts.
    Other,
}

impl Punct {
    /// The token as it is written.
    pub fn text(self) -> &'static str {
        match self {
            Punct::LeftBrace => "{",
            Punct::RightBrace => "}",
            Punct::LeftParen => "(",
            Punct::RightParen => ")",
            Punct::LeftBracket => "[",
            Punct::RightBracket => "]",
            Punct::Less => "<",
            Punct::Greater => ">",
            Punct::LessEqual => "<=",
            Punct::GreaterEqual => ">=",
            Punct::Equal => "=",
            Punct::NotEqual => "!=",
            Punct::Not => "!",
            Punct::Comma => ",",
            Punct::Semicolon => ";",
            Punct::Colon => ":",
            Punct::Question => "?",
            Punct::Dot => ".",
            Punct::Plus => "+",
            Punct::Minus => "-",
            Punct::Star => "*",
            Punct::Slash => "/",
            Punct::And => "&",
            Punct::Or => "|",
            Punct::Hash => "#",
            Punct::Caret => "^",
            Punct::Other => "@",
        }
    }
}
