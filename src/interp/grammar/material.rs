//! `material { … }`, and everything about surfaces that stands in an object.

use super::texture::joined;
use crate::interp::value::Material;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Attached, Interior, Texture};
use crate::math::Transform;
use crate::scene::Object;
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

impl Parser {
    pub fn material_statement(&mut self) -> Result<Material> {
        self.expect(Keyword::Material)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut material = Material::default();
        if let Some(Value::Material(named)) = self.peek_value()? {
            self.take_value()?;
            material = (*named).clone();
        }
        loop {
            if let Some(transform) = self.transformation()? {
                material.transform(&transform);
                continue;
            }
            match self.peek()?.tok {
                Tok::Word(Keyword::Texture) => self.add_layer(&mut material.textures, Keyword::Texture)?,
                Tok::Word(Keyword::InteriorTexture) => {
                    self.add_layer(&mut material.interior_textures, Keyword::InteriorTexture)?;
                }
                Tok::Word(Keyword::Interior) => {
                    let interior = self.merged_interior(material.interior.take())?;
                    material.interior = Some(interior);
                }
                _ => break,
            }
        }
        self.close_block(&items::MATERIAL)?;
        Ok(material)
    }

    /// Reads an interior statement into the interior that is there already.
    fn merged_interior(&mut self, before: Option<Attached<Interior>>) -> Result<Attached<Interior>> {
        let Some(before) = before else { return self.interior_statement() };
        let interior = self.interior_statement_from(placed_interior(&before))?;
        Ok(Attached::new(Arc::new(interior)))
    }

    /// One item about an object's surface or interior; false if none comes.
    ///
    /// A texture becomes a layer on top of those that the object has. A pigment, normal or finish changes the
    /// top layer; without a texture it begins from the default one.
    pub fn object_texture_item(&mut self, object: &mut Object) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        match word {
            Keyword::Texture => self.add_layer(&mut object.textures, word)?,
            Keyword::InteriorTexture => self.add_layer(&mut object.interior_textures, word)?,
            Keyword::Pigment | Keyword::Normal | Keyword::Finish => {
                let mut texture = match object.textures.pop() {
                    Some(top) => joined(&[top]),
                    None => Texture::Layers(vec![self.scene.default_layer.clone()]),
                };
                let top = match &mut texture {
                    Texture::Layers(layers) => layers.last_mut(),
                    Texture::Patterned(_) => None,
                };
                let Some(top) = top else {
                    let message = "the parts of a patterned texture cannot be changed";
                    return Err(Box::new(Diagnostic::error(token.span, message)));
                };
                self.layer_part(top)?;
                object.textures.push(Attached::new(Arc::new(texture)));
            }
            Keyword::Interior => object.interior = Some(self.merged_interior(object.interior.take())?),
            Keyword::Material => {
                let material = self.material_statement()?;
                object.textures.extend(material.textures);
                object.interior_textures.extend(material.interior_textures);
                if material.interior.is_some() {
                    object.interior = material.interior;
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}

/// The interior with its placement put into its media.
fn placed_interior(attached: &Attached<Interior>) -> Interior {
    let mut interior = (*attached.value).clone();
    if !attached.transform.is_identity() {
        for media in &mut interior.media {
            let media = Arc::make_mut(media);
            media.transform = media.transform.then(&attached.transform);
        }
    }
    interior
}

impl Material {
    /// Moves what the material has so far.
    fn transform(&mut self, t: &Transform) {
        for texture in self.textures.iter_mut().chain(&mut self.interior_textures) {
            texture.transform = texture.transform.then(t);
        }
        if let Some(interior) = &mut self.interior {
            interior.transform = interior.transform.then(t);
        }
    }
}

impl Object {
    /// Old scenes write `ior` and `caustics` in a finish: the last layer that has them decides, even against the
    /// object's own interior.
    pub(super) fn take_interior_from_finish(&mut self) {
        let (mut ior, mut caustics) = (None, None);
        for texture in &self.textures {
            if let Texture::Layers(layers) = &*texture.value {
                for layer in layers {
                    ior = layer.finish.ior.or(ior);
                    caustics = layer.finish.caustics.or(caustics);
                }
            }
        }
        if ior.is_none() && caustics.is_none() {
            return;
        }
        let attached = self.interior.get_or_insert_with(|| Attached::new(Arc::new(Interior::default())));
        let interior = Arc::make_mut(&mut attached.value);
        interior.ior = ior.unwrap_or(interior.ior);
        interior.caustics = caustics.unwrap_or(interior.caustics);
    }
}
