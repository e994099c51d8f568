//! Scene text to tokens. The only user of `logos`.

mod interner;
mod keyword;
mod lexer;
mod number;
mod plain;
mod token;

pub use interner::Interner;
pub use keyword::{Keyword, SPELLINGS};
pub use lexer::Lexer;
pub use number::{leading_number, parse_number};
pub use plain::Plain;
pub use token::{Directive, Punct, StringId, Symbol, Tok, Token};
