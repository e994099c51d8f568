//! Objects: a keyword with a block, or an identifier.
//!
//! Every block begins with its parameters or with an identifier that holds any object, of which it becomes
//! a copy; modifiers follow in any order.

use crate::interp::{Parser, Result, Value};
use crate::material::{Attached, Layer, Texture};
use crate::scene::{Body, CsgOp, Object};
use crate::shape::Shape;
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::sync::Arc;

/// Combinations and regions inside each other; deeper ones would need more stack than a thread has.
const MAX_DEPTH: u32 = 256;

/// Reads what stands between a block's `{` and its modifiers. The token is the block's keyword.
pub(super) type Parameters = fn(&mut Parser, Token) -> Result<Object>;

impl Parser {
    /// An object if one comes next; its keyword or identifier is still to be taken.
    pub fn object(&mut self) -> Result<Option<Object>> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return self.object_identifier() };
        match word {
            Keyword::LightSource => self.light_source_statement().map(Some),
            Keyword::LightGroup => self.light_group().map(Some),
            _ => match parameters(word) {
                Some(parameters) => self.object_block(parameters).map(Some),
                None => Ok(None),
            },
        }
    }

    /// An object where one must come.
    pub fn required_object(&mut self) -> Result<Object> {
        match self.object()? {
            Some(object) => Ok(object),
            None => Err(self.unexpected("an object")),
        }
    }

    /// An object where one must come that stands for itself: without a texture it has the default one.
    pub(super) fn textured_object(&mut self) -> Result<Object> {
        let mut object = self.required_object()?;
        give_default(&mut object, &self.default_texture());
        Ok(object)
    }

    /// Takes an object if one comes and puts it into the scene.
    pub fn object_statement(&mut self) -> Result<bool> {
        let Some(mut object) = self.object()? else { return Ok(false) };
        let default = self.default_texture();
        give_default(&mut object, &default);
        self.scene.scene.objects.push(Arc::new(object));
        Ok(true)
    }

    fn object_identifier(&mut self) -> Result<Option<Object>> {
        let Some(Value::Object(object)) = self.peek_value()? else { return Ok(None) };
        self.take_value()?;
        Ok(Some((*object).clone()))
    }

    /// `keyword { parameters modifiers }` or `keyword { identifier modifiers }`.
    fn object_block(&mut self, parameters: Parameters) -> Result<Object> {
        let keyword = self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut object = match self.object_identifier()? {
            Some(copy) => copy,
            None => parameters(self, keyword)?,
        };
        self.object_modifiers(&mut object)?;
        object.count_materials();
        if object.depth() > MAX_DEPTH {
            let message = format!("objects are combined more than {MAX_DEPTH} levels deep");
            let hint = "put the parts side by side into one union instead of nesting them";
            return Err(Box::new(Diagnostic::error(keyword.span, message).with_hint(hint)));
        }
        Ok(object)
    }

    /// The default texture in force, shared with the object placed before where it is the same.
    fn default_texture(&self) -> Arc<Texture> {
        let layer = &self.scene.default_layer;
        let before = self.scene.scene.objects.last().and_then(|o| o.textures.first());
        match before {
            Some(a) if is_layer(&a.value, layer) => a.value.clone(),
            _ => Arc::new(Texture::Layers(vec![layer.clone()])),
        }
    }

    /// Warns that a shape comes to nothing.
    pub(super) fn degenerate(&mut self, span: Span, kind: &'static str, why: &str) -> Object {
        self.warn(Diagnostic::warning(span, format!("degenerate {kind}: {why}")).with_label("never visible"));
        from_shape(crate::shape::Empty::new(kind))
    }
}

pub(super) fn from_shape(shape: impl Shape + 'static) -> Object {
    Object::new(Body::Shape(Arc::new(shape)))
}

/// Whether a texture consists of exactly this layer.
fn is_layer(texture: &Texture, layer: &Layer) -> bool {
    let Texture::Layers(layers) = texture else { return false };
    let same_normal = |a: &Option<Arc<_>>, b: &Option<Arc<_>>| match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        _ => false,
    };
    matches!(&layers[..], [own] if Arc::ptr_eq(&own.pigment, &layer.pigment)
        && Arc::ptr_eq(&own.finish, &layer.finish)
        && same_normal(&own.normal, &layer.normal))
}

/// Gives an object without texture the default one. Below `cutaway_textures` only what is not cut takes it,
/// so that the rest shows what it cuts.
fn give_default(object: &mut Object, default: &Arc<Texture>) {
    if !object.textures.is_empty() || matches!(object.body, Body::Light(_)) {
        return;
    }
    match &mut object.body {
        Body::Csg { op, children } if object.flags.cutaway_textures => {
            let count = if *op == CsgOp::Difference { 1 } else { children.len() };
            for child in Arc::make_mut(children).iter_mut().take(count) {
                give_default(Arc::make_mut(child), default);
            }
        }
        _ => object.textures.push(Attached::new(default.clone())),
    }
}

/// How to read the parameters of a block that begins with `word`; `None` if it begins no object.
fn parameters(word: Keyword) -> Option<Parameters> {
    Some(match word {
        Keyword::Object => |p, _| p.required_object(),
        Keyword::Sphere => Parser::sphere,
        Keyword::Box => Parser::cuboid,
        Keyword::Plane => Parser::plane,
        Keyword::Cylinder => Parser::cylinder,
        Keyword::Cone => Parser::cone,
        Keyword::Torus => Parser::torus,
        Keyword::Isosurface => Parser::isosurface,
        Keyword::Disc => Parser::disc,
        Keyword::Triangle => Parser::triangle,
        Keyword::SmoothTriangle => Parser::smooth_triangle,
        Keyword::Polygon => Parser::polygon,
        Keyword::Quadric => Parser::quadric,
        Keyword::Cubic => Parser::cubic,
        Keyword::Quartic => Parser::quartic,
        Keyword::Poly => Parser::poly,
        Keyword::Polynomial => Parser::polynomial,
        Keyword::Text => Parser::text,
        Keyword::Mesh => Parser::mesh,
        Keyword::Mesh2 => Parser::mesh2,
        Keyword::Prism => Parser::prism,
        Keyword::Lathe => Parser::lathe,
        Keyword::Sor => Parser::sor,
        Keyword::Superellipsoid => Parser::superellipsoid,
        Keyword::Ovus => Parser::ovus,
        Keyword::SphereSweep => Parser::sphere_sweep,
        Keyword::Blob => Parser::blob,
        Keyword::BicubicPatch => Parser::bicubic_patch,
        Keyword::HeightField => Parser::height_field,
        Keyword::Parametric => Parser::parametric,
        Keyword::JuliaFractal => Parser::julia_fractal,
        Keyword::Union | Keyword::Composite => Parser::union,
        Keyword::Merge => Parser::merge,
        Keyword::Intersection => Parser::intersection,
        Keyword::Difference => Parser::difference,
        _ => return None,
    })
}
