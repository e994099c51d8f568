//! Scene text to tokens. The only user of `logos`.

mod keyword;
mod token;

pub use keyword::{Keyword, SPELLINGS};
pub use token::{Punct, StringId, Symbol, Tok, Token};
