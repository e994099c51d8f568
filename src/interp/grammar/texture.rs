//! `texture { … }`: plain ones with pigment, normal and finish, and patterned ones that choose between
//! textures.

use super::image::ImageUse;
use super::pattern::Place;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Attached, Layer, NormalKind, PatternedKind, PatternedTexture, Texture};
use crate::pattern::{BlendMap, Checker, Signal};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

/// Most layers of one texture.
const MOST_LAYERS: usize = 10_000;

impl Parser {
    /// One texture. It may have several layers if it begins with an identifier that has.
    pub fn texture_statement(&mut self) -> Result<Vec<Attached<Texture>>> {
        Ok(vec![Attached::new(Arc::new(self.braced_texture(Keyword::Texture)?))])
    }

    /// Textures one after another, which are layers from bottom to top.
    pub fn layered_texture_statement(&mut self) -> Result<Vec<Attached<Texture>>> {
        let mut layers = Vec::new();
        while layers.is_empty() || self.peek()?.tok == Tok::Word(Keyword::Texture) {
            self.add_layer(&mut layers, Keyword::Texture)?;
        }
        Ok(layers)
    }

    /// Reads one texture and lays it over the others.
    pub(super) fn add_layer(&mut self, layers: &mut Vec<Attached<Texture>>, word: Keyword) -> Result<()> {
        let start = self.peek()?.span;
        let mut texture = self.braced_texture(word)?;
        if let Some(below) = layers.last() {
            let patterned = |t: &Texture| matches!(t, Texture::Patterned(_));
            if patterned(&below.value) || patterned(&texture) {
                return Err(Box::new(Diagnostic::error(start, "patterned textures cannot be layered")));
            }
            if let Texture::Layers(new) = &mut texture
                && self.syntax_version() <= 310
            {
                new.iter_mut().for_each(|layer| Arc::make_mut(&mut layer.pigment).unfilter());
            }
        }
        layers.push(Attached::new(self.shared_texture(texture)));
        let count = |t: &Attached<Texture>| if let Texture::Layers(all) = &*t.value { all.len() } else { 1 };
        if layers.iter().map(count).sum::<usize>() > MOST_LAYERS {
            let message = format!("a texture has more than {MOST_LAYERS} layers");
            return Err(Box::new(Diagnostic::error(start, message)));
        }
        Ok(())
    }

    /// The texture itself, or the one read before it if they consist of the same parts: a scene that puts
    /// one texture on a thousand objects keeps it once.
    fn shared_texture(&mut self, texture: Texture) -> Arc<Texture> {
        if let Some(recent) = &self.scene.recent_texture
            && same_parts(recent, &texture)
        {
            return recent.clone();
        }
        let texture = Arc::new(texture);
        self.scene.recent_texture = Some(texture.clone());
        texture
    }

    /// A texture with its keyword (`texture` or `interior_texture`).
    pub(super) fn braced_texture(&mut self, word: Keyword) -> Result<Texture> {
        self.expect(word)?;
        self.expect_punct(Punct::LeftBrace)?;
        let texture = self.texture_body()?;
        self.close_block(&items::TEXTURE)?;
        Ok(texture)
    }

    /// What stands in a texture's braces, or in an entry of a texture map.
    pub(super) fn texture_body(&mut self) -> Result<Texture> {
        let start = self.peek()?.span;
        if self.syntax_version() < 300 {
            return self.old_texture_body();
        }
        if let Some(Value::Texture(named)) = self.peek_value()? {
            self.take_value()?;
            let texture = joined(&named);
            return match texture {
                Texture::Layers(layers) => self.plain_texture(layers),
                patterned => self.moved_texture(patterned),
            };
        }
        let texture = match self.peek()?.tok {
            Tok::Word(Keyword::Tiles) => self.tiles()?,
            Tok::Word(Keyword::MaterialMap) => self.material_map()?,
            _ => match self.patterned_texture()? {
                Some(texture) => texture,
                None => return self.plain_texture(vec![self.scene.default_layer.clone()]),
            },
        };
        self.check_depth(texture.depth(), start)?;
        self.check_cost(texture.cost(), start)?;
        Ok(texture)
    }

    /// Pigment, normal, finish and transformations; parts change those of the top layer.
    fn plain_texture(&mut self, mut layers: Vec<Layer>) -> Result<Texture> {
        self.texture_parts_by_name(&mut layers)?;
        while self.texture_part(&mut layers)? {}
        Ok(Texture::Layers(layers))
    }

    /// Identifiers of a pigment, a normal and a finish, without braces, at the beginning.
    fn texture_parts_by_name(&mut self, layers: &mut [Layer]) -> Result<()> {
        let Some(top) = layers.last_mut() else { return Ok(()) };
        loop {
            match self.peek_value()? {
                Some(Value::Pigment(pigment)) => top.pigment = pigment,
                Some(Value::Normal(normal)) => top.normal = normal,
                Some(Value::Finish(finish)) => top.finish = finish,
                _ => return Ok(()),
            }
            self.take_value()?;
        }
    }

    fn texture_part(&mut self, layers: &mut [Layer]) -> Result<bool> {
        if let Some(transform) = self.transformation()? {
            layers.iter_mut().for_each(|layer| layer.transform(&transform));
            return Ok(true);
        }
        match layers.last_mut() {
            Some(top) => self.layer_part(top),
            None => Ok(false),
        }
    }

    /// `pigment`, `normal` or `finish`, changing those of a layer.
    pub(super) fn layer_part(&mut self, layer: &mut Layer) -> Result<bool> {
        let token = self.peek()?;
        match token.tok {
            Tok::Word(Keyword::Pigment) => {
                let pigment = self.pigment_statement_from((*layer.pigment).clone())?;
                layer.pigment = Arc::new(pigment);
            }
            Tok::Word(Keyword::Normal) => {
                let base = layer.normal.as_deref().cloned().unwrap_or_default();
                let normal = self.normal_statement_from(base)?;
                if matches!(normal.kind, NormalKind::Flat) {
                    self.lenient(Diagnostic::warning(token.span, "this normal has no pattern"))?;
                }
                layer.normal = Some(Arc::new(normal));
            }
            Tok::Word(Keyword::Finish) => {
                let finish = self.finish_statement_from((*layer.finish).clone())?;
                layer.finish = Arc::new(finish);
            }
            Tok::Word(Keyword::NoBumpScale) => {
                self.next()?;
                if let Some(normal) = &mut layer.normal {
                    Arc::make_mut(normal).scale_bumps = false;
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// A named patterned texture can only be moved.
    pub(super) fn moved_texture(&mut self, mut texture: Texture) -> Result<Texture> {
        while let Some(transform) = self.transformation()? {
            texture.transform(&transform);
        }
        Ok(texture)
    }

    /// A texture with a pattern and its map or list, if a pattern comes.
    fn patterned_texture(&mut self) -> Result<Option<Texture>> {
        let token = self.peek()?;
        let mut signal = Signal::default();
        let (kind, mut map) = match token.tok {
            Tok::Word(Keyword::UvMapping) => {
                self.next()?;
                let inner = self.texture_body()?;
                let texture =
                    PatternedTexture::new(PatternedKind::Uv, signal, BlendMap::new(vec![(0.0, inner)]));
                return Ok(Some(Texture::Patterned(Arc::new(texture))));
            }
            Tok::Word(Keyword::Average) => {
                self.next()?;
                (PatternedKind::Average, None)
            }
            _ => match self.pattern(Place::Texture)? {
                Some(pattern) => {
                    let items = pattern.character().items;
                    signal.set_pattern(pattern);
                    let list = items.map(|n| self.texture_list(n)).transpose()?;
                    self.end_pattern(token)?;
                    (PatternedKind::Blended, list)
                }
                None => return Ok(None),
            },
        };
        let is_list = map.is_some();
        let mut scale_bumps = true;
        loop {
            if self.accept(Keyword::NoBumpScale)? {
                scale_bumps = false;
            } else if !is_list && self.accept(Keyword::TextureMap)? {
                map = Some(self.texture_map(matches!(kind, PatternedKind::Average))?);
            } else if !self.signal_modifier(&mut signal)? {
                break;
            }
        }
        let Some(map) = map else {
            if matches!(self.peek()?.tok, Tok::Identifier(_)) {
                return Err(self.unexpected("`texture_map`"));
            }
            return Err(Box::new(Diagnostic::error(
                token.span,
                "a patterned texture must have a texture_map",
            )));
        };
        let mut texture = PatternedTexture::new(kind, signal, map);
        texture.scale_bumps = scale_bumps;
        Ok(Some(Texture::Patterned(Arc::new(texture))))
    }

    /// Textures, filled up with default ones.
    fn texture_list(&mut self, items: usize) -> Result<BlendMap<Texture>> {
        let mut list = Vec::new();
        while list.len() < items && self.peek()?.tok == Tok::Word(Keyword::Texture) {
            list.push((list.len() as f32, self.braced_texture(Keyword::Texture)?));
            self.comma()?;
        }
        while list.len() < items {
            list.push((list.len() as f32, Texture::Layers(vec![self.scene.default_layer.clone()])));
        }
        Ok(BlendMap::new(list))
    }

    /// `material_map { image texture… }`.
    pub(super) fn material_map(&mut self) -> Result<Texture> {
        self.expect(Keyword::MaterialMap)?;
        self.expect_punct(Punct::LeftBrace)?;
        let (image, _) = self.image_with_settings(ImageUse::Materials)?;
        let mut textures = vec![(0.0, self.braced_texture(Keyword::Texture)?)];
        while self.peek()?.tok == Tok::Word(Keyword::Texture) {
            textures.push((0.0, self.braced_texture(Keyword::Texture)?));
        }
        self.expect_punct(Punct::RightBrace)?;
        let mut signal = Signal::default();
        while self.signal_modifier(&mut signal)? {}
        let kind = PatternedKind::Material(image);
        Ok(Texture::Patterned(Arc::new(PatternedTexture::new(kind, signal, BlendMap::new(textures)))))
    }

    /// `tiles { texture… tile2 texture… }`: a checker in the old way of writing.
    pub(super) fn tiles(&mut self) -> Result<Texture> {
        self.expect(Keyword::Tiles)?;
        self.expect_punct(Punct::LeftBrace)?;
        let first = joined(&self.layered_texture_statement()?);
        self.expect(Keyword::Tile2)?;
        let second = joined(&self.layered_texture_statement()?);
        self.expect_punct(Punct::RightBrace)?;
        let map = BlendMap::new(vec![(0.0, second), (1.0, first)]);
        let mut signal = Signal::new(Arc::new(Checker));
        while self.signal_modifier(&mut signal)? {}
        Ok(Texture::Patterned(Arc::new(PatternedTexture::new(PatternedKind::Blended, signal, map))))
    }
}

/// One texture with the layers of several, their placements put into their patterns.
pub(super) fn joined(attached: &[Attached<Texture>]) -> Texture {
    let placed = |a: &Attached<Texture>| {
        let mut texture = (*a.value).clone();
        if !a.transform.is_identity() {
            texture.transform(&a.transform);
        }
        texture
    };
    if let [only] = attached {
        return placed(only);
    }
    let mut layers = Vec::new();
    for a in attached {
        match placed(a) {
            Texture::Layers(more) => layers.extend(more),
            patterned => return patterned,
        }
    }
    Texture::Layers(layers)
}

/// Whether both are stacks of the very same pigments, normals and finishes.
fn same_parts(a: &Texture, b: &Texture) -> bool {
    let (Texture::Layers(a), Texture::Layers(b)) = (a, b) else { return false };
    let same_normal = |a: &Layer, b: &Layer| match (&a.normal, &b.normal) {
        (None, None) => true,
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        _ => false,
    };
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| {
            Arc::ptr_eq(&a.pigment, &b.pigment) && Arc::ptr_eq(&a.finish, &b.finish) && same_normal(a, b)
        })
}
