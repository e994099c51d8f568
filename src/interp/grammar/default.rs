//! `#default { … }`.

use crate::interp::{Parser, Result};
use crate::syntax::{Keyword, Punct};

impl Parser {
    /// The braces behind `#default`.
    pub(in crate::interp) fn default_statement(&mut self) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            let token = self.peek()?;
            if self.default_texture_item()? {
                continue;
            }
            if token.tok == crate::syntax::Tok::Word(Keyword::Camera) {
                self.scene.default_camera = self.camera_statement()?;
                if !self.camera_given {
                    self.scene.scene.camera = self.scene.default_camera.clone();
                }
            } else if self.accept(Keyword::Radiosity)? {
                self.default_importance()?;
            } else {
                return Err(self.unexpected("a texture, pigment, normal, finish, camera or `}`"));
            }
        }
        Ok(())
    }

    pub(super) fn importance(&mut self) -> Result<f32> {
        let span = self.peek()?.span;
        let value = self.float()?;
        self.demand(value > 0.0 && value <= 1.0, span, "`importance` is above 0 and at most 1")?;
        Ok(value as f32)
    }

    /// `{ importance f }`.
    fn default_importance(&mut self) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        while self.accept(Keyword::Importance)? {
            self.scene.scene.globals.importance = self.importance()?;
        }
        self.expect_punct(Punct::RightBrace).map(|_| ())
    }
}
