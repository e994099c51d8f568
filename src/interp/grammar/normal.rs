//! `normal { … }`.

use super::image::ImageUse;
use super::pattern::Place;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Normal, NormalKind};
use crate::pattern::BlendMap;
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

impl Parser {
    /// A normal made from the default one, or from nothing.
    pub fn normal_statement(&mut self) -> Result<Arc<Normal>> {
        let base = self.default_normal();
        self.normal_statement_from(base).map(Arc::new)
    }

    /// A normal made by changing `base`.
    pub fn normal_statement_from(&mut self, base: Normal) -> Result<Normal> {
        self.expect(Keyword::Normal)?;
        self.expect_punct(Punct::LeftBrace)?;
        let normal = self.normal_body(base)?;
        self.close_block(&items::NORMAL)?;
        Ok(normal)
    }

    pub(super) fn default_normal(&self) -> Normal {
        self.scene.default_layer.normal.as_deref().cloned().unwrap_or_default()
    }

    /// An identifier, a pattern, an amount and modifiers, each of which may be left out.
    pub(super) fn normal_body(&mut self, base: Normal) -> Result<Normal> {
        let start = self.peek()?.span;
        let mut normal = base;
        if let Some(Value::Normal(named)) = self.peek_value()? {
            self.take_value()?;
            normal = named.as_deref().cloned().unwrap_or_default();
        }
        self.normal_type(&mut normal)?;
        while self.normal_modifier(&mut normal)? {}
        if matches!(normal.kind, NormalKind::Average) && normal.map.is_none() {
            return Err(Box::new(Diagnostic::error(start, "an average must have a normal_map")));
        }
        normal.settle();
        self.check_depth(normal.depth(), start)?;
        self.check_cost(normal.cost(), start)?;
        Ok(normal)
    }

    pub(super) fn normal_type(&mut self, normal: &mut Normal) -> Result<()> {
        let token = self.peek()?;
        match token.tok {
            Tok::Word(Keyword::UvMapping) => {
                self.next()?;
                let base = normal.clone();
                normal.kind = NormalKind::Uv(Arc::new(self.normal_body(base)?));
                return Ok(());
            }
            Tok::Word(Keyword::BumpMap) => {
                self.next()?;
                self.expect_punct(Punct::LeftBrace)?;
                let (map, settings) = self.image_with_settings(ImageUse::Bumps)?;
                self.close_block(&items::BUMP_MAP)?;
                normal.kind = NormalKind::Image(map);
                normal.amount = settings.bump_size.unwrap_or(normal.amount);
            }
            Tok::Word(Keyword::Average) => {
                self.next()?;
                normal.kind = NormalKind::Average;
                normal.map = None;
            }
            _ => {
                if let Some(pattern) = self.pattern(Place::Normal)? {
                    normal.kind = NormalKind::Patterned;
                    let items = pattern.character().items;
                    normal.signal.set_pattern(pattern);
                    if let Some(items) = items {
                        normal.map = self.normal_list(items)?;
                        self.end_pattern(token)?;
                    }
                }
            }
        }
        self.amount(normal)
    }

    /// The number after the pattern.
    fn amount(&mut self, normal: &mut Normal) -> Result<()> {
        self.comma()?;
        if self.at_expression()? {
            normal.amount = self.single()?;
        }
        Ok(())
    }

    /// Normals, filled up with default ones; `None` if there are none.
    fn normal_list(&mut self, items: usize) -> Result<Option<BlendMap<Arc<Normal>>>> {
        let mut list = Vec::new();
        while list.len() < items && self.peek()?.tok == Tok::Word(Keyword::Normal) {
            list.push((list.len() as f32, self.normal_statement()?));
            self.comma()?;
        }
        if list.is_empty() {
            return Ok(None);
        }
        while list.len() < items {
            list.push((list.len() as f32, Arc::new(self.default_normal())));
        }
        Ok(Some(BlendMap::new(list)))
    }

    fn normal_modifier(&mut self, normal: &mut Normal) -> Result<bool> {
        let token = self.peek()?;
        match token.tok {
            Tok::Word(word @ (Keyword::NormalMap | Keyword::SlopeMap)) if !may_have(normal, word) => {
                let message = format!("this kind of normal cannot have a `{}`", word.text());
                return Err(Box::new(Diagnostic::error(token.span, message)));
            }
            Tok::Word(Keyword::NormalMap) => {
                self.next()?;
                let average = matches!(normal.kind, NormalKind::Average);
                normal.map = Some(self.normal_map(average)?);
            }
            Tok::Word(Keyword::SlopeMap) => {
                self.next()?;
                normal.slopes = Some(self.slope_map()?);
            }
            Tok::Word(Keyword::BumpSize) => {
                self.next()?;
                normal.amount = self.single()?;
            }
            Tok::Word(Keyword::Accuracy) => {
                self.next()?;
                normal.accuracy = self.single()?;
            }
            Tok::Word(Keyword::NoBumpScale) => {
                self.next()?;
                normal.scale_bumps = false;
            }
            _ => return self.signal_modifier(&mut normal.signal),
        }
        Ok(true)
    }
}

/// Whether the normal's pattern goes with that map. One without a pattern keeps it for a later one.
fn may_have(normal: &Normal, map: Keyword) -> bool {
    let pattern = &normal.signal.pattern;
    match normal.kind {
        NormalKind::Patterned => {
            pattern.character().items.is_none()
                && (map == Keyword::SlopeMap || !pattern.is_for_normals_only())
        }
        NormalKind::Flat => true,
        NormalKind::Average => map == Keyword::NormalMap,
        NormalKind::Image(_) | NormalKind::Uv(_) => false,
    }
}
