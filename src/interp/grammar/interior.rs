//! `interior { … }`.

use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Attached, Interior};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

impl Parser {
    pub fn interior_statement(&mut self) -> Result<Attached<Interior>> {
        let interior = self.interior_statement_from(Interior::default())?;
        Ok(Attached::new(Arc::new(interior)))
    }

    /// An interior made by changing `base`.
    pub fn interior_statement_from(&mut self, base: Interior) -> Result<Interior> {
        self.expect(Keyword::Interior)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut interior = base;
        if let Some(Value::Interior(named)) = self.peek_value()? {
            self.take_value()?;
            interior = (*named).clone();
        }
        while self.interior_item(&mut interior)? {}
        self.close_block(&items::INTERIOR)?;
        Ok(interior)
    }

    fn interior_item(&mut self, interior: &mut Interior) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        if word == Keyword::Media {
            let media = self.media_statement()?;
            interior.media.push(placed_media(&media));
            return Ok(true);
        }
        match word {
            Keyword::Ior => interior.ior = self.next().and_then(|_| self.float())? as f32,
            Keyword::Dispersion => interior.dispersion = self.next().and_then(|_| self.float())? as f32,
            Keyword::DispersionSamples => {
                self.next()?;
                interior.dispersion_samples = self.dispersion_samples()?;
            }
            Keyword::Caustics => interior.caustics = self.next().and_then(|_| self.float())? as f32,
            Keyword::FadeDistance => interior.fade_distance = self.next().and_then(|_| self.float())?,
            Keyword::FadePower => interior.fade_power = self.next().and_then(|_| self.float())?,
            Keyword::FadeColor => interior.fade_color = self.next().and_then(|_| self.rgb())?,
            Keyword::Refraction => {
                self.next()?;
                self.float()?;
                self.warn(Diagnostic::warning(token.span, "`refraction` has no effect in an interior"));
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn dispersion_samples(&mut self) -> Result<u32> {
        let token = self.peek()?;
        let samples = self.float()?;
        if (2.0..1e6).contains(&samples) {
            return Ok(samples as u32);
        }
        Err(Box::new(Diagnostic::error(token.span, "dispersion needs at least 2 samples")))
    }
}

/// The medium with its placement put into it.
fn placed_media(media: &Attached<crate::material::Media>) -> Arc<crate::material::Media> {
    if media.transform.is_identity() {
        return media.value.clone();
    }
    let mut placed = (*media.value).clone();
    placed.transform = placed.transform.then(&media.transform);
    Arc::new(placed)
}
