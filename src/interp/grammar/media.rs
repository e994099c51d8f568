//! `media { … }`.

use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Attached, Media};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

impl Parser {
    pub fn media_statement(&mut self) -> Result<Attached<Media>> {
        self.expect(Keyword::Media)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut media = Media::new(self.syntax_version());
        if let Some(Value::Media(named)) = self.peek_value()? {
            self.take_value()?;
            media = (*named).clone();
        }
        while self.media_item(&mut media)? {}
        self.close_block(&items::MEDIA)?;
        Ok(Attached::new(Arc::new(media)))
    }

    fn media_item(&mut self, media: &mut Media) -> Result<bool> {
        if let Some(transform) = self.transformation()? {
            media.transform = media.transform.then(&transform);
            return Ok(true);
        }
        let Tok::Word(word) = self.peek()?.tok else { return Ok(false) };
        if self.media_number(word, media)? {
            return Ok(true);
        }
        match word {
            Keyword::Samples => {
                self.next()?;
                let least = self.whole_number(1)?;
                self.comma()?;
                let most = if self.at_expression()? { self.whole_number(1)? } else { least };
                if most < least {
                    let text = "an interval cannot have fewer samples at most than at least";
                    return Err(Box::new(Diagnostic::error(self.last, text)));
                }
                media.samples = (least, most);
            }
            Keyword::Collect => media.collect = self.next().and_then(|_| self.flag())?,
            Keyword::Absorption => media.absorption = self.next().and_then(|_| self.rgb())?,
            Keyword::Emission => media.emission = self.next().and_then(|_| self.rgb())?,
            Keyword::Scattering => self.scattering(media)?,
            Keyword::Density => media.densities.push(self.density_statement()?),
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn media_number(&mut self, word: Keyword, media: &mut Media) -> Result<bool> {
        match word {
            Keyword::Intervals => media.intervals = self.next().and_then(|_| self.whole_number(1))?,
            Keyword::Method => {
                self.next()?;
                let span = self.peek()?.span;
                media.method = self.whole_number(1)?;
                self.demand(media.method <= 3, span, "media are sampled by the methods 1, 2 and 3")?;
            }
            Keyword::AaLevel => media.aa_level = self.next().and_then(|_| self.whole_number(1))?,
            Keyword::Jitter => media.jitter = self.next().and_then(|_| self.float())? as f32,
            Keyword::AaThreshold => {
                self.next()?;
                let span = self.peek()?.span;
                media.aa_threshold = self.float()? as f32;
                self.demand(media.aa_threshold > 0.0, span, "`aa_threshold` must be above 0")?;
            }
            Keyword::Confidence => {
                self.next()?;
                let span = self.peek()?.span;
                media.confidence = self.float()? as f32;
                let inside = (0.0..1.0).contains(&media.confidence);
                self.demand(inside, span, "confidence is from 0 to less than 1")?;
            }
            Keyword::Variance => media.variance = self.next().and_then(|_| self.float())? as f32,
            Keyword::Ratio => media.ratio = self.next().and_then(|_| self.float())? as f32,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// A whole number from `least` up.
    fn whole_number(&mut self, least: u32) -> Result<u32> {
        let token = self.peek()?;
        let n = self.float()?;
        if n >= f64::from(least) && n < 1e9 {
            return Ok(n as u32);
        }
        Err(Box::new(Diagnostic::error(token.span, format!("expected a whole number from {least} up"))))
    }

    fn scattering(&mut self, media: &mut Media) -> Result<()> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        let token = self.peek()?;
        let kind = self.float()?;
        let known = (1.0..6.0).contains(&kind);
        if !known {
            self.warn(Diagnostic::warning(token.span, "scattering has the types 1 to 5: this is read as 1"));
        }
        media.scattering_type = if known { kind as u32 } else { 1 };
        self.comma()?;
        media.scattering = self.rgb()?;
        loop {
            let span = self.peek()?.span;
            if self.accept(Keyword::Eccentricity)? {
                let text = "`eccentricity` goes with scattering of type 5 alone";
                self.demand(media.scattering_type == 5, span, text)?;
                media.eccentricity = self.float()? as f32;
            } else if self.accept(Keyword::Extinction)? {
                media.extinction = self.float()? as f32;
            } else {
                break;
            }
        }
        self.expect_punct(Punct::RightBrace)?;
        Ok(())
    }
}
