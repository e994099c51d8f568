//! Tokens to a scene.
//!
//! Three layers: the token stream (files, directives, macros, loops), expressions and symbols, and the
//! grammar of scene statements, which pulls tokens and never sees a directive.

mod builtin;
mod comparison;
mod directives;
pub mod embedded;
mod evaluate;
mod expr;
mod grammar;
mod include;
mod interpret;
mod kept;
mod limits;
mod lists;
mod lookup;
mod macros;
mod messages;
mod options;
mod parser;
mod places;
mod program;
mod statements;
mod stream;
mod string;
mod suggest;
mod symbols;
#[cfg(test)]
mod tests;
mod textfile;
mod value;
mod version;
mod vocabulary;
mod world_query;

pub use interpret::{Outcome, interpret, interpret_str};
pub use limits::Limits;
pub use lookup::INCLUDE_FOLDERS;
pub(crate) use lookup::Kind as FileKind;
pub use options::{Frame, IncludeMode, Options, SceneSource};
pub use parser::Parser;
pub(crate) use places::Access;
pub use suggest::nearest_word;
pub use value::{Array, Material, Value};

use crate::source::Diagnostic;

/// The first error ends a scene.
pub type Result<T> = std::result::Result<T, Box<Diagnostic>>;
