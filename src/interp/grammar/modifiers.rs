//! What may follow an object's parameters, up to its closing brace.

use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result};
use crate::scene::{Body, CsgOp, Object};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok};

/// Shapes that take `sturm`. Roots are exact either way, so it changes nothing.
const STURM: [&str; 9] = ["torus", "lathe", "sor", "prism", "blob", "cubic", "quartic", "poly", "polynomial"];
/// Shapes that take `hierarchy`. Trees are used either way, so it changes nothing.
const HIERARCHY: [&str; 4] = ["blob", "height_field", "mesh", "mesh2"];

impl Parser {
    /// Modifiers and the closing brace.
    pub(super) fn object_modifiers(&mut self, object: &mut Object) -> Result<()> {
        while !self.accept_punct(Punct::RightBrace)? {
            if let Some(t) = self.transformation()? {
                object.apply(&t);
            } else if !self.object_texture_item(object)? && !self.object_option(object)? {
                return Err(self.unexpected_item(&items::OBJECT));
            }
        }
        let fits = object.interior_textures.is_empty() || !object.textures.is_empty();
        self.demand(fits, self.last, "an `interior_texture` needs a `texture` beside it")?;
        object.take_interior_from_finish();
        Ok(())
    }

    /// One option if it comes next.
    fn object_option(&mut self, object: &mut Object) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        if !is_option(word) {
            return Ok(false);
        }
        self.next()?;
        match word {
            Keyword::ClippedBy => self.clipped_by(object, token.span)?,
            Keyword::BoundedBy => self.bounded_by(object, token.span)?,
            Keyword::NoShadow => object.flags.no_shadow = true,
            Keyword::NoImage => object.flags.no_image = self.flag()?,
            Keyword::NoReflection => object.flags.no_reflection = self.flag()?,
            Keyword::NoRadiosity => object.flags.no_radiosity = self.flag()?,
            Keyword::DoubleIlluminate => object.flags.double_illuminate = self.flag()?,
            Keyword::Hollow => object.flags.hollow = Some(self.flag()?),
            Keyword::Inverse => self.inverse(object, token.span),
            Keyword::UvMapping => uv_mapping(object, token.span)?,
            Keyword::Sturm => self.shape_flag(object, token.span, "sturm", &STURM)?,
            Keyword::Hierarchy => self.shape_flag(object, token.span, "hierarchy", &HIERARCHY)?,
            Keyword::SplitUnion => self.split_union(object, token.span)?,
            Keyword::CutawayTextures => cutaway_textures(object, token.span)?,
            Keyword::Photons => self.object_photons(object, token.span)?,
            Keyword::Radiosity => self.object_radiosity(object)?,
            Keyword::Dtag => {
                self.string()?;
            }
            _ => self.quick_color(token.span)?,
        }
        Ok(true)
    }

    fn inverse(&mut self, object: &mut Object, span: Span) {
        let is_patch = match &object.body {
            Body::Shape(shape) => !shape.is_solid(),
            Body::Csg { .. } => false,
            Body::Light(_) => true,
        };
        if is_patch {
            self.warn(Diagnostic::warning(span, "this object has no inside that could be inverted"));
        } else {
            object.flags.inverse = !object.flags.inverse;
        }
    }

    /// An option that only some shapes take and that their pictures do not depend on.
    fn shape_flag(&mut self, object: &Object, span: Span, word: &str, takers: &[&str]) -> Result<()> {
        self.flag()?;
        match &object.body {
            Body::Shape(shape) if takers.contains(&shape.kind()) => Ok(()),
            _ => Err(Box::new(
                Diagnostic::error(span, format!("`{word}` cannot be used with this object"))
                    .with_hint(format!("it belongs to {}", takers.join(", "))),
            )),
        }
    }

    fn split_union(&mut self, object: &mut Object, span: Span) -> Result<()> {
        if !matches!(object.body, Body::Csg { op: CsgOp::Union | CsgOp::Merge, .. }) {
            return Err(Box::new(Diagnostic::error(span, "`split_union` belongs to a union")));
        }
        object.flags.split_union = Some(self.float()? > 0.0);
        Ok(())
    }

    /// After `photons`: the block.
    pub(super) fn object_photons(&mut self, object: &mut Object, span: Span) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            if self.accept(Keyword::Target)? {
                object.photons.target = Some(if self.at_expression()? { self.float()? as f32 } else { 1.0 });
            } else if self.accept(Keyword::Refraction)? {
                object.photons.refraction = Some(self.float()? > 0.0);
            } else if self.accept(Keyword::Reflection)? {
                object.photons.reflection = Some(self.float()? > 0.0);
            } else if self.accept(Keyword::PassThrough)? {
                object.photons.pass_through = self.flag()?;
            } else if self.accept(Keyword::Collect)? {
                object.photons.collect = self.flag()?;
            } else {
                let words = "`target`, `refraction`, `reflection`, `pass_through`, `collect` or `}`";
                return Err(self.unexpected(words));
            }
        }
        let p = &mut object.photons;
        if p.pass_through && p.target.is_some() && p.refraction == Some(true) {
            p.refraction = Some(false);
            let message = "a target that photons pass through cannot refract them: refraction is turned off";
            self.warn(Diagnostic::warning(span, message));
        }
        Ok(())
    }

    /// After `radiosity`: the block.
    fn object_radiosity(&mut self, object: &mut Object) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            self.expect(Keyword::Importance)?;
            object.importance = Some(self.importance()?);
        }
        Ok(())
    }

    /// After `color`: read, warned about and left out, as it always was.
    fn quick_color(&mut self, span: Span) -> Result<()> {
        self.color()?;
        let warning = Diagnostic::warning(span, "a color does not belong to an object: it is left out");
        self.warn(warning.with_hint("write `pigment { color … }`"));
        Ok(())
    }
}

fn is_option(word: Keyword) -> bool {
    matches!(
        word,
        Keyword::ClippedBy
            | Keyword::BoundedBy
            | Keyword::NoShadow
            | Keyword::NoImage
            | Keyword::NoReflection
            | Keyword::NoRadiosity
            | Keyword::DoubleIlluminate
            | Keyword::Hollow
            | Keyword::Inverse
            | Keyword::UvMapping
            | Keyword::Sturm
            | Keyword::Hierarchy
            | Keyword::SplitUnion
            | Keyword::CutawayTextures
            | Keyword::Photons
            | Keyword::Radiosity
            | Keyword::Dtag
            | Keyword::Color
    )
}

fn uv_mapping(object: &mut Object, span: Span) -> Result<()> {
    if !object.textures.is_empty() {
        return Err(Box::new(Diagnostic::error(span, "`uv_mapping` must come before the object's texture")));
    }
    object.flags.uv_mapping = true;
    Ok(())
}

fn cutaway_textures(object: &mut Object, span: Span) -> Result<()> {
    if !matches!(object.body, Body::Csg { op: CsgOp::Intersection | CsgOp::Difference, .. }) {
        let message = "`cutaway_textures` belongs to an intersection or a difference";
        return Err(Box::new(Diagnostic::error(span, message)));
    }
    object.flags.cutaway_textures = true;
    Ok(())
}
