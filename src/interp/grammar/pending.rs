//! Productions that other files of the grammar call and that are still to come.

use crate::interp::{Parser, Result};
use crate::scene::Object;

impl Parser {
    /// `light_source { … }`; the word is the next token.
    pub(crate) fn light_source_statement(&mut self) -> Result<Object> {
        todo!()
    }

    /// Takes one of `texture`, `pigment`, `normal`, `finish`, `interior`, `interior_texture` or `material` if it
    /// comes next, and adds it to `object`. False if something else comes.
    pub(crate) fn object_texture_item(&mut self, _object: &mut Object) -> Result<bool> {
        todo!()
    }
}
