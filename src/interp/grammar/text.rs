//! `text { ttf "font.ttf" "words" thickness, <offset> }`: letters as solids.

use crate::interp::{FileKind, Parser, Result};
use crate::math::{Transform, Vec2, Vec3};
use crate::scene::{Body, CsgOp, Object};
use crate::shape::font::{Charset, Letter, letters};
use crate::shape::{Empty, Glyph, Shape};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Token};
use std::sync::Arc;

/// Files of the fonts that `internal` names by number. They are read where the reference's include files
/// are; Glint has no fonts of its own.
const INTERNAL: [&str; 4] = ["povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"];

/// Degrees about x, y and z by which the reference turns every text, so that no ray runs along a cap.
const TILT: f64 = 0.001;

impl Parser {
    pub(super) fn text(&mut self, _keyword: Token) -> Result<Object> {
        let span = self.peek()?.span;
        let name = if self.accept(Keyword::Internal)? {
            let number = self.float()?.trunc();
            let known = (0.0..INTERNAL.len() as f64).contains(&number);
            INTERNAL[if known { number as usize } else { 0 }].to_owned()
        } else {
            self.expect(Keyword::Ttf)?;
            self.file_name()?
        };
        let path = self.require_file(&name, FileKind::Font, span)?;
        let font = std::fs::read(&path).map_err(|e| {
            Box::new(Diagnostic::error(span, format!("cannot read the font `{}`: {e}", path.display())))
        })?;
        self.comma()?;
        let words: Vec<u16> = self.string()?.encode_utf16().collect();
        self.comma()?;
        let thickness = self.float()?;
        self.comma()?;
        let offset = self.vector()?;
        let charset = if self.is_utf8() { Charset::Unicode } else { Charset::Ascii };
        let Some(letters) = letters(&font, &words, Vec2::new(offset.x, offset.y), charset) else {
            let message = format!("`{}` is not a TrueType font", path.display());
            return Err(Box::new(Diagnostic::error(span, message)));
        };
        // A blank is an empty shape: the reference counts it as an object too.
        let shape = |letter: Letter| -> Arc<dyn Shape> {
            match letter.outline.is_empty() {
                true => Arc::new(Empty::new("text")),
                false => Arc::new(Glyph::new(letter.outline, thickness)),
            }
        };
        let glyph = |letter| Arc::new(Object::new(Body::Shape(shape(letter))));
        let children = letters.into_iter().map(glyph).collect();
        let mut object = Object::new(Body::Csg { op: CsgOp::Union, children: Arc::new(children) });
        object.apply(&Transform::rotate(Vec3::splat(TILT)));
        Ok(object)
    }
}
