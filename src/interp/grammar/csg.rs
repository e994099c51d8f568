//! Combinations of objects.

use crate::interp::{Parser, Result};
use crate::scene::{Body, CsgOp, Object};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::sync::Arc;

impl Parser {
    pub(super) fn union(&mut self, keyword: Token) -> Result<Object> {
        if keyword.tok == Tok::Word(Keyword::Composite) {
            let warning = Diagnostic::warning(keyword.span, "`composite` is an old word for `union`");
            self.warn(warning.with_hint("write `union`"));
        }
        self.combination(keyword, CsgOp::Union)
    }

    pub(super) fn merge(&mut self, keyword: Token) -> Result<Object> {
        self.combination(keyword, CsgOp::Merge)
    }

    pub(super) fn intersection(&mut self, keyword: Token) -> Result<Object> {
        self.combination(keyword, CsgOp::Intersection)
    }

    pub(super) fn difference(&mut self, keyword: Token) -> Result<Object> {
        self.combination(keyword, CsgOp::Difference)
    }

    fn combination(&mut self, keyword: Token, op: CsgOp) -> Result<Object> {
        let mut children = Vec::new();
        while let Some(child) = self.child()? {
            if matches!(op, CsgOp::Intersection | CsgOp::Difference) && !child.is_solid() {
                let message = "this has no inside: in an intersection or difference it contains nothing";
                self.warn(Diagnostic::warning(keyword.span, message));
            }
            children.push(Arc::new(child));
        }
        if children.len() < 2 {
            let message = "a combination should have at least 2 objects";
            self.warn(Diagnostic::warning(keyword.span, message));
        }
        let mut object = Object::new(Body::Csg { op, children: Arc::new(children) });
        object.flags.no_shadow = all_without_shadow(&object);
        Ok(object)
    }

    /// A child of a combination: any object but a bare identifier.
    fn child(&mut self) -> Result<Option<Object>> {
        if matches!(self.peek()?.tok, Tok::Identifier(_)) {
            return Ok(None);
        }
        self.object()
    }

    /// `light_group { objects modifiers }`.
    pub(super) fn light_group(&mut self) -> Result<Object> {
        self.expect(Keyword::LightGroup)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut children = Vec::new();
        while let Some(child) = self.object()? {
            children.push(Arc::new(child));
        }
        let body = |global_lights| CsgOp::LightGroup { global_lights };
        let mut object = Object::new(Body::Csg { op: body(false), children: Arc::new(children) });
        while !self.accept_punct(Punct::RightBrace)? {
            let span = self.peek()?.span;
            if let Some(t) = self.transformation()? {
                object.apply(&t);
            } else if self.accept(Keyword::GlobalLights)? {
                let on = self.flag()?;
                if let Body::Csg { op, .. } = &mut object.body {
                    *op = body(on);
                }
            } else if self.accept(Keyword::Photons)? {
                self.object_photons(&mut object, span)?;
            } else {
                return Err(self.unexpected("an object, a transformation, `global_lights`, `photons` or `}`"));
            }
        }
        Ok(object)
    }
}

/// Whether every child that is not a light casts no shadow.
fn all_without_shadow(object: &Object) -> bool {
    let Body::Csg { children, .. } = &object.body else { return false };
    let mut bodies = children.iter().filter(|c| !matches!(c.body, Body::Light(_))).peekable();
    bodies.peek().is_some() && bodies.all(|c| c.flags.no_shadow)
}
