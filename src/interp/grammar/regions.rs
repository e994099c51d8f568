//! `clipped_by` and `bounded_by`.

use crate::interp::{Parser, Result};
use crate::scene::{Body, Object};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct};
use std::sync::Arc;

impl Parser {
    /// After `clipped_by`: the block.
    pub(super) fn clipped_by(&mut self, object: &mut Object, span: Span) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        if self.accept(Keyword::BoundedBy)? {
            self.expect_punct(Punct::RightBrace)?;
            if !object.clipped_by.is_empty() {
                return Err(already(span, "clipped_by", "bounded_by"));
            }
            object.clip_by(object.bounded_by.clone());
            return Ok(());
        }
        let regions = self.regions()?;
        object.clip_by(regions);
        Ok(())
    }

    /// After `bounded_by`: the block.
    pub(super) fn bounded_by(&mut self, object: &mut Object, span: Span) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        if self.accept(Keyword::ClippedBy)? {
            self.expect_punct(Punct::RightBrace)?;
            if !object.bounded_by.is_empty() {
                return Err(already(span, "bounded_by", "clipped_by"));
            }
            object.bound_by(object.clipped_by.clone());
            return Ok(());
        }
        let regions = self.regions()?;
        object.bound_by(regions);
        Ok(())
    }

    /// Objects with transformations after them, up to the closing brace.
    fn regions(&mut self) -> Result<Vec<Arc<Object>>> {
        let mut regions = Vec::new();
        loop {
            let span = self.peek()?.span;
            let Some(region) = self.object()? else { break };
            if region.is_textured() || !region.is_solid() {
                let message = "an object that clips or bounds can neither be textured nor be without inside";
                return Err(Box::new(Diagnostic::error(span, message)));
            }
            regions.push(region);
        }
        if regions.is_empty() {
            return Err(self.unexpected("an object"));
        }
        while let Some(t) = self.transformation()? {
            regions.iter_mut().for_each(|r| r.apply(&t));
        }
        self.expect_punct(Punct::RightBrace)?;
        Ok(regions.into_iter().map(Arc::new).collect())
    }
}

fn already(span: Span, word: &str, other: &str) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(span, format!("`{word} {{ {other} }}` must be the object's first `{word}`")))
}

impl Object {
    /// Whether it, or any object in it, has a texture.
    fn is_textured(&self) -> bool {
        let own =
            !(self.textures.is_empty() && self.interior_textures.is_empty() && self.part_textures.is_empty());
        own || self.children().iter().any(|c| c.is_textured())
    }

    /// Whether it, and every object in it, has an inside.
    pub(super) fn is_solid(&self) -> bool {
        match &self.body {
            Body::Shape(shape) => shape.is_solid(),
            Body::Csg { children, .. } => children.iter().all(|c| c.is_solid()),
            Body::Light(_) => false,
        }
    }

    fn children(&self) -> &[Arc<Object>] {
        match &self.body {
            Body::Csg { children, .. } => children,
            _ => &[],
        }
    }
}
