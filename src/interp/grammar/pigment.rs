//! `pigment { … }`, and `density { … }`, which is a pigment for media.

use super::image::ImageUse;
use super::pattern::Place;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Pigment, PigmentKind, PigmentMap};
use crate::pattern::{BlendMap, Pattern};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

/// Pigments, normals and textures nest this deep at most, so that evaluating them keeps within the stack.
pub(super) const DEEPEST: u32 = 100;

/// Most pigments, normals and textures that one point may ask for.
const MOST_ASKED: f64 = 1e6;

impl Parser {
    /// A pigment made from the default one.
    pub fn pigment_statement(&mut self) -> Result<Arc<Pigment>> {
        let base = self.default_pigment(Place::Pigment);
        self.pigment_statement_from(base).map(Arc::new)
    }

    /// A pigment made by changing `base`.
    pub fn pigment_statement_from(&mut self, base: Pigment) -> Result<Pigment> {
        self.expect(Keyword::Pigment)?;
        self.braced_pigment(base)
    }

    /// A pigment that gives the density of a medium; black without a pattern.
    pub fn density_statement(&mut self) -> Result<Arc<Pigment>> {
        self.expect(Keyword::Density)?;
        self.expect_punct(Punct::LeftBrace)?;
        let base = self.default_pigment(Place::Density);
        let density = self.pigment_body(base, Place::Density)?;
        self.close_block(&items::DENSITY)?;
        Ok(Arc::new(density))
    }

    pub(super) fn default_pigment(&self, place: Place) -> Pigment {
        match place {
            Place::Density => Pigment::default(),
            _ => (*self.scene.default_layer.pigment).clone(),
        }
    }

    pub(super) fn braced_pigment(&mut self, base: Pigment) -> Result<Pigment> {
        self.expect_punct(Punct::LeftBrace)?;
        let pigment = self.pigment_body(base, Place::Pigment)?;
        self.close_block(&items::PIGMENT)?;
        Ok(pigment)
    }

    /// An identifier, a type and modifiers, each of which may be left out.
    pub(super) fn pigment_body(&mut self, base: Pigment, place: Place) -> Result<Pigment> {
        let start = self.peek()?.span;
        let mut pigment = base;
        let named = match self.peek_value()? {
            Some(Value::Pigment(p)) if place != Place::Density => Some(p),
            Some(Value::Density(p)) if place == Place::Density => Some(p),
            _ => None,
        };
        if let Some(p) = &named {
            self.take_value()?;
            pigment = (**p).clone();
        }
        let typed = self.pigment_type(&mut pigment, place)?;
        if !typed && named.is_none() && place != Place::Density {
            self.warn(Diagnostic::warning(
                start,
                "this pigment has no color or pattern, or not in first place",
            ));
        }
        while self.pigment_modifier(&mut pigment, place)? {}
        if matches!(pigment.kind, PigmentKind::Average) && pigment.map.is_none() {
            return Err(Box::new(Diagnostic::error(start, "an average must have a pigment_map")));
        }
        pigment.settle();
        self.check_depth(pigment.depth(), start)?;
        self.check_cost(pigment.cost(), start)?;
        Ok(pigment)
    }

    /// Maps of maps multiply: what would take this long at every point is refused before it begins.
    pub(super) fn check_cost(&self, cost: f64, span: Span) -> Result<()> {
        if cost <= MOST_ASKED {
            return Ok(());
        }
        let message =
            "pigments, normals or textures within each other: one point asks for more than a million";
        Err(Box::new(Diagnostic::error(span, message)))
    }

    pub(in crate::interp) fn check_depth(&self, depth: u32, span: Span) -> Result<()> {
        if depth <= DEEPEST {
            return Ok(());
        }
        let message =
            format!("pigments, normals, textures or functions nested more than {DEEPEST} levels deep");
        Err(Box::new(Diagnostic::error(span, message)))
    }

    /// A colour or a pattern, if one comes.
    pub(super) fn pigment_type(&mut self, pigment: &mut Pigment, place: Place) -> Result<bool> {
        let typed = self.named_type(pigment, place)?;
        pigment.typed |= typed;
        Ok(typed)
    }

    fn named_type(&mut self, pigment: &mut Pigment, place: Place) -> Result<bool> {
        let token = self.peek()?;
        match token.tok {
            Tok::Word(Keyword::UvMapping) => {
                self.next()?;
                let base = pigment.clone();
                let inner = self.pigment_body(base, place)?;
                pigment.kind = PigmentKind::Uv(Arc::new(inner));
            }
            Tok::Word(Keyword::ImageMap) if place == Place::Pigment => {
                self.next()?;
                self.expect_punct(Punct::LeftBrace)?;
                let (map, _) = self.image_with_settings(ImageUse::Colors)?;
                self.close_block(&items::IMAGE_MAP)?;
                pigment.kind = PigmentKind::Image(map);
            }
            Tok::Word(Keyword::Average) => {
                self.next()?;
                pigment.kind = PigmentKind::Average;
                pigment.map = None;
            }
            _ => match self.pattern(place)? {
                Some(pattern) => {
                    self.set_pattern(pigment, pattern, place)?;
                    self.end_pattern(token)?;
                }
                None if self.at_expression()? => pigment.kind = PigmentKind::Plain(self.color()?),
                None => return Ok(false),
            },
        }
        Ok(true)
    }

    /// Gives the pigment its pattern, with the list that follows if the pattern takes one.
    fn set_pattern(&mut self, pigment: &mut Pigment, pattern: Arc<dyn Pattern>, place: Place) -> Result<()> {
        pigment.kind = PigmentKind::Patterned;
        let items = pattern.character().items;
        if let Some(items) = items {
            pigment.map = Some(self.pigment_list(&*pattern, items, place)?);
        }
        pigment.signal.set_pattern(pattern);
        Ok(())
    }

    /// Colours or pigments, filled up with default ones.
    fn pigment_list(&mut self, pattern: &dyn Pattern, items: usize, place: Place) -> Result<PigmentMap> {
        let word = if place == Place::Density { Keyword::Density } else { Keyword::Pigment };
        if self.peek()?.tok == Tok::Word(word) {
            let mut list = Vec::new();
            while list.len() < items && self.peek()?.tok == Tok::Word(word) {
                let item = match place {
                    Place::Density => self.density_statement()?,
                    _ => self.pigment_statement()?,
                };
                list.push((list.len() as f32, item));
                self.comma()?;
            }
            while list.len() < items {
                list.push((list.len() as f32, Arc::new(self.default_pigment(place))));
            }
            return Ok(PigmentMap::Pigments(BlendMap::new(list)));
        }
        let mut colors = pattern.colors();
        let mut read = 0;
        while read < items && self.at_expression()? {
            colors[read].1 = self.color()?;
            read += 1;
            self.comma()?;
        }
        Ok(PigmentMap::Colors(BlendMap::new(colors)))
    }

    pub(super) fn pigment_modifier(&mut self, pigment: &mut Pigment, place: Place) -> Result<bool> {
        let token = self.peek()?;
        match token.tok {
            Tok::Word(Keyword::ColorMap) => {
                self.allow_map(pigment, token.span, false)?;
                self.next()?;
                pigment.map = Some(PigmentMap::Colors(self.color_map()?));
            }
            Tok::Word(word @ (Keyword::PigmentMap | Keyword::DensityMap)) => {
                if (word == Keyword::DensityMap) != (place == Place::Density) {
                    return Err(self.unexpected("a map of the other kind"));
                }
                self.allow_map(pigment, token.span, true)?;
                self.next()?;
                let average = matches!(pigment.kind, PigmentKind::Average);
                pigment.map = Some(PigmentMap::Pigments(self.pigment_map(place, average)?));
            }
            Tok::Word(Keyword::QuickColor) => {
                self.next()?;
                pigment.quick_color = Some(self.color()?);
            }
            Tok::Word(Keyword::NoBumpScale) => {
                self.next()?;
            }
            _ => return self.signal_modifier(&mut pigment.signal),
        }
        Ok(true)
    }

    /// An error if the pigment cannot have a map.
    fn allow_map(&self, pigment: &Pigment, span: Span, average: bool) -> Result<()> {
        let fits = match pigment.kind {
            PigmentKind::Patterned => pigment.signal.pattern.character().items.is_none(),
            PigmentKind::Average => average,
            _ => !pigment.typed,
        };
        match fits {
            true => Ok(()),
            false => Err(Box::new(Diagnostic::error(span, "this kind of pigment cannot have such a map"))),
        }
    }
}
