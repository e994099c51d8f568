//! Parameters of surfaces given by functions.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::scene::Object;
use crate::shape::{Container, Isosurface};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};

/// Most crossings of one ray that are looked for.
const MOST_CROSSINGS: f64 = 10.0;

impl Parser {
    /// `function { … }` and settings in any order.
    pub(super) fn isosurface(&mut self, _keyword: Token) -> Result<Object> {
        self.expect(Keyword::Function)?;
        let mut surface = Isosurface::new(self.function_body_xyz()?);
        while self.isosurface_item(&mut surface)? {}
        Ok(from_shape(surface))
    }

    fn isosurface_item(&mut self, surface: &mut Isosurface) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        match word {
            Keyword::ContainedBy => surface.container = self.container()?,
            Keyword::Threshold => {
                self.next()?;
                surface.threshold = self.float()?;
            }
            Keyword::Accuracy => surface.accuracy = self.positive_setting(surface.accuracy)?,
            Keyword::MaxGradient => surface.max_gradient = self.positive_setting(surface.max_gradient)?,
            Keyword::Evaluate => {
                self.next()?;
                surface.evaluate = Some(self.evaluate()?);
            }
            Keyword::Open => {
                self.next()?;
                surface.open = true;
            }
            Keyword::MaxTrace => {
                let count = self.positive_setting(surface.max_trace as f64)?;
                if !(1.0..MOST_CROSSINGS + 1.0).contains(&count) {
                    let text = format!("`max_trace` is from 1 to {MOST_CROSSINGS}");
                    self.warn(Diagnostic::warning(self.last_span(), text));
                }
                surface.max_trace = count.clamp(1.0, MOST_CROSSINGS) as usize;
            }
            Keyword::AllIntersections => {
                self.next()?;
                surface.max_trace = MOST_CROSSINGS as usize;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// A word and its number; what is not above 0 leaves `default` in force.
    pub(super) fn positive_setting(&mut self, default: f64) -> Result<f64> {
        let word = self.next()?;
        let span = self.peek()?.span;
        let value = self.float()?;
        if value > 0.0 {
            return Ok(value);
        }
        self.warn_not_positive(word, span, default);
        Ok(default)
    }

    fn warn_not_positive(&mut self, word: Token, span: Span, default: f64) {
        let Tok::Word(word) = word.tok else { return };
        let message = format!("`{}` must be above 0: {default} is taken", word.text());
        self.warn(Diagnostic::warning(span, message));
    }

    fn evaluate(&mut self) -> Result<[f64; 3]> {
        let least = self.float()?;
        self.comma()?;
        let factor = self.float()?;
        self.comma()?;
        Ok([least, factor, self.float()?])
    }

    /// `contained_by { box { A, B } }` or `contained_by { sphere { C, r } }`; the word is the next token.
    pub(super) fn container(&mut self) -> Result<Container> {
        self.expect(Keyword::ContainedBy)?;
        self.expect_punct(Punct::LeftBrace)?;
        let kind = self.peek()?;
        let container = match kind.tok {
            Tok::Word(Keyword::Box) => {
                self.next()?;
                self.expect_punct(Punct::LeftBrace)?;
                let a = self.vector()?;
                self.comma()?;
                Container::cuboid(a, self.vector()?)
            }
            Tok::Word(Keyword::Sphere) => {
                self.next()?;
                self.expect_punct(Punct::LeftBrace)?;
                let center = self.vector()?;
                self.comma()?;
                Container::sphere(center, self.float()?)
            }
            _ => return Err(self.unexpected("a box or a sphere")),
        };
        self.expect_punct(Punct::RightBrace)?;
        self.expect_punct(Punct::RightBrace)?;
        Ok(container)
    }
}
