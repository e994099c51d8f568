//! Textures as versions before 3.0 wrote them: colours, patterns and finish items directly in the braces.

use super::finish::Albedo;
use super::pattern::Place;
use crate::color::Rgb;
use crate::interp::{Parser, Result, Value};
use crate::material::{Layer, Normal, NormalKind, Pigment, Texture};
use crate::pattern::Wave;
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Tok};
use std::sync::Arc;

impl Parser {
    pub(super) fn old_texture_body(&mut self) -> Result<Texture> {
        let mut layers = vec![self.scene.default_layer.clone()];
        if let Some(Value::Texture(named)) = self.peek_value()? {
            self.take_value()?;
            match super::texture::joined(&named) {
                Texture::Layers(named) => layers = named,
                patterned => return Ok(patterned),
            }
        }
        match self.peek()?.tok {
            Tok::Word(Keyword::Tiles) => return self.tiles(),
            Tok::Word(Keyword::MaterialMap) => return self.material_map(),
            _ => {}
        }
        let mut albedo = Albedo::default();
        while self.old_texture_item(&mut layers, &mut albedo)? {}
        Ok(Texture::Layers(layers))
    }

    /// A number that stands alone is the finish's `crand`.
    fn old_crand(&mut self, layer: &mut Layer) -> Result<bool> {
        let token = self.peek()?;
        if !matches!(token.tok, Tok::Number(_)) {
            return Ok(false);
        }
        Arc::make_mut(&mut layer.finish).crand = self.single()? as f32;
        self.warn(Diagnostic::warning(token.span, "a number in a texture is read as `crand`"));
        Ok(true)
    }

    fn old_texture_item(&mut self, layers: &mut [Layer], albedo: &mut Albedo) -> Result<bool> {
        if let Some(transform) = self.transformation()? {
            layers.iter_mut().for_each(|layer| layer.transform(&transform));
            return Ok(true);
        }
        let Some(top) = layers.last_mut() else { return Ok(false) };
        match self.peek_value()? {
            Some(Value::Pigment(pigment)) => top.pigment = pigment,
            Some(Value::Normal(normal)) => top.normal = normal,
            Some(Value::Finish(finish)) => top.finish = finish,
            _ => return self.old_layer_item(top, albedo),
        }
        self.take_value()?;
        Ok(true)
    }

    fn old_layer_item(&mut self, layer: &mut Layer, albedo: &mut Albedo) -> Result<bool> {
        if self.old_crand(layer)? || self.layer_part(layer)? {
            return Ok(true);
        }
        if self.accept(Keyword::Ambient)? {
            let ambient = self.float()? as f32;
            Arc::make_mut(&mut layer.finish).ambient = Rgb::new(ambient, ambient, ambient);
            return Ok(true);
        }
        if self.finish_item(Arc::make_mut(&mut layer.finish), albedo)? {
            return Ok(true);
        }
        if let Tok::Word(
            Keyword::Bumps | Keyword::Dents | Keyword::Ripples | Keyword::Waves | Keyword::Wrinkles,
        ) = self.peek()?.tok
        {
            layer.normal = Some(Arc::new(self.old_normal()?));
            return Ok(true);
        }
        if self.peek()?.tok == Tok::Word(Keyword::BumpMap) {
            let mut normal = Normal::default();
            self.normal_type(&mut normal)?;
            layer.normal = Some(Arc::new(normal));
            return Ok(true);
        }
        let mut pigment: Pigment = (*layer.pigment).clone();
        let typed = self.pigment_type(&mut pigment, Place::Pigment)?;
        if typed {
            // Marble and wood had no wave of their own then.
            pigment.signal.wave = Wave::Ramp;
        }
        let mut modified = false;
        while let word = self.peek()?.tok
            && self.pigment_modifier(&mut pigment, Place::Pigment)?
        {
            modified = true;
            // They are the whole texture's, its normal's too.
            let signal = layer.normal.as_mut().map(|normal| &mut Arc::make_mut(normal).signal);
            match (word, signal) {
                (Tok::Word(Keyword::Frequency), Some(signal)) => signal.frequency = pigment.signal.frequency,
                (Tok::Word(Keyword::Phase), Some(signal)) => signal.phase = pigment.signal.phase,
                _ => {}
            }
        }
        if typed || modified {
            pigment.settle();
            layer.pigment = Arc::new(pigment);
        }
        Ok(typed || modified)
    }

    /// A pattern for normals with its amount.
    fn old_normal(&mut self) -> Result<Normal> {
        let mut normal = Normal::default();
        if let Some(pattern) = self.pattern(Place::Normal)? {
            normal.kind = NormalKind::Patterned;
            normal.signal.set_pattern(pattern);
        }
        if self.at_expression()? {
            normal.amount = self.single()?;
        }
        Ok(normal)
    }
}
