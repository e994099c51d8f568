//! Productions that other files of the grammar call and that are still to come.

use crate::interp::{Parser, Result};
use crate::scene::Object;

impl Parser {
    /// `light_source { … }`; the word is the next token.
    pub(crate) fn light_source_statement(&mut self) -> Result<Object> {
        todo!()
    }
}
