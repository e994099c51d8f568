//! `blob { threshold T components … }`.

use super::object::from_shape;
use super::texture::joined;
use crate::interp::{Parser, Result};
use crate::material::{Attached, Texture};
use crate::scene::{Body, Object};
use crate::shape::{Blob, BlobComponent, Empty};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::sync::Arc;

impl Parser {
    pub(super) fn blob(&mut self, keyword: Token) -> Result<Object> {
        let mut threshold = 1.0;
        let mut components = Vec::new();
        let mut textures = Vec::new();
        let mut written = 0;
        loop {
            if self.accept(Keyword::Threshold)? {
                threshold = self.float()?;
                continue;
            }
            let token = self.peek()?;
            let component = match token.tok {
                Tok::Word(Keyword::Sphere) => self.blob_sphere(&mut textures)?,
                Tok::Word(Keyword::Cylinder) => self.blob_cylinder(&mut textures, token.span)?,
                Tok::Word(Keyword::Component) => self.old_component()?,
                _ => break,
            };
            components.extend(component);
            written += 1;
        }
        if written == 0 {
            if self.options.strict {
                self.lenient(Diagnostic::warning(keyword.span, "this blob has no component"))?;
            }
            return Ok(self.degenerate(keyword.span, "blob", "it has no component"));
        }
        let mut object = from_shape(Blob::new(components, threshold));
        object.part_textures = textures;
        Ok(object)
    }

    /// `sphere { C, r, [strength] s modifiers }`
    fn blob_sphere(&mut self, textures: &mut Vec<Attached<Texture>>) -> Result<Option<BlobComponent>> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        let center = self.vector()?;
        self.comma()?;
        let radius = self.float()?;
        let strength = self.strength()?;
        let component = BlobComponent::sphere(center, radius, strength);
        self.component_modifiers(component, textures)
    }

    /// `cylinder { A, B, r, [strength] s modifiers }`
    fn blob_cylinder(
        &mut self,
        textures: &mut Vec<Attached<Texture>>,
        span: Span,
    ) -> Result<Option<BlobComponent>> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        let base = self.vector()?;
        self.comma()?;
        let cap = self.vector()?;
        if base == cap {
            return Err(Box::new(Diagnostic::error(span, "the cylinder's two ends are one point")));
        }
        self.comma()?;
        let radius = self.float()?;
        let strength = self.strength()?;
        let component = BlobComponent::cylinder(base, cap, radius, strength);
        self.component_modifiers(component, textures)
    }

    /// `component s, r, C`
    fn old_component(&mut self) -> Result<Option<BlobComponent>> {
        self.next()?;
        let strength = self.float()?;
        self.comma()?;
        let radius = self.float()?;
        self.comma()?;
        let center = self.vector()?;
        Ok(BlobComponent::sphere(center, radius, strength))
    }

    fn strength(&mut self) -> Result<f64> {
        self.comma()?;
        self.accept(Keyword::Strength)?;
        self.float()
    }

    /// Transformations and textures up to the closing brace.
    fn component_modifiers(
        &mut self,
        component: Option<BlobComponent>,
        textures: &mut Vec<Attached<Texture>>,
    ) -> Result<Option<BlobComponent>> {
        // Collects them as an object does.
        let mut stand_in = Object::new(Body::Shape(Arc::new(Empty::new("blob"))));
        while !self.accept_punct(Punct::RightBrace)? {
            if let Some(t) = self.transformation()? {
                stand_in.apply(&t);
                continue;
            }
            let surface = [Keyword::Texture, Keyword::Pigment, Keyword::Normal, Keyword::Finish];
            let taken = match self.peek()?.tok {
                Tok::Word(word) if surface.contains(&word) => self.object_texture_item(&mut stand_in)?,
                _ => false,
            };
            if !taken {
                return Err(self.unexpected("a transformation, a texture or `}`"));
            }
        }
        let texture = (!stand_in.textures.is_empty()).then(|| {
            textures.push(Attached::new(Arc::new(joined(&stand_in.textures))));
            textures.len() as u32 - 1
        });
        Ok(component.map(|c| c.transformed(&stand_in.transform).with_texture(texture)))
    }
}
