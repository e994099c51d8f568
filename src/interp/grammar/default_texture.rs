//! The texture part of `#default { … }`.

use crate::interp::{Parser, Result};
use crate::material::Texture;
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Tok};
use std::sync::Arc;

impl Parser {
    /// One of `texture`, `pigment`, `normal`, `finish` in a default statement; false if none comes.
    pub fn default_texture_item(&mut self) -> Result<bool> {
        let token = self.peek()?;
        match token.tok {
            Tok::Word(Keyword::Texture) => match self.braced_texture(Keyword::Texture)? {
                Texture::Layers(mut layers) if layers.len() == 1 => {
                    self.scene.default_layer = layers.swap_remove(0);
                }
                _ => {
                    let message = "the default texture cannot be layered or patterned";
                    return Err(Box::new(Diagnostic::error(token.span, message)));
                }
            },
            Tok::Word(Keyword::Pigment) => self.scene.default_layer.pigment = self.pigment_statement()?,
            Tok::Word(Keyword::Normal) => {
                self.scene.default_layer.normal = Some(self.normal_statement()?);
            }
            Tok::Word(Keyword::Finish) => {
                let finish = self.finish_statement()?;
                self.scene.default_layer.finish = Arc::clone(&finish);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}
