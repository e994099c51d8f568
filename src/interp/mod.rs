//! Tokens to a scene.
//!
//! Three layers: the token stream (files, directives, macros, loops), expressions and symbols, and the
//! grammar of scene statements, which pulls tokens and never sees a directive.

pub mod embedded;
mod grammar;
mod parser;
mod value;

pub use parser::Parser;
pub use value::Value;

use crate::source::Diagnostic;

/// The first error ends a scene.
pub type Result<T> = std::result::Result<T, Box<Diagnostic>>;
