//! `parametric { fx, fy, fz <u0, v0>, <u1, v1> settings }`.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::math::field::Field;
use crate::scene::Object;
use crate::shape::Parametric;
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Tok, Token};
use std::sync::Arc;

/// Depths that `precompute` takes.
const DEPTHS: std::ops::RangeInclusive<f64> = 1.0..=20.0;

impl Parser {
    pub(super) fn parametric(&mut self, _keyword: Token) -> Result<Object> {
        let functions = [self.coordinate()?, self.coordinate()?, self.coordinate()?];
        let low = self.vector2()?;
        self.comma()?;
        let high = self.vector2()?;
        let mut surface = Parametric::new(functions, low.min(high), low.max(high));
        while self.parametric_setting(&mut surface)? {}
        Ok(from_shape(surface))
    }

    /// `function { … }` of u and v, and a comma.
    fn coordinate(&mut self) -> Result<Arc<dyn Field>> {
        self.expect(Keyword::Function)?;
        let function = self.function_body_xyz()?;
        self.comma()?;
        Ok(function)
    }

    fn parametric_setting(&mut self, surface: &mut Parametric) -> Result<bool> {
        let Tok::Word(word) = self.peek()?.tok else { return Ok(false) };
        match word {
            Keyword::ContainedBy => surface.container = self.container()?,
            Keyword::Accuracy => surface.accuracy = self.positive_setting(surface.accuracy)?,
            Keyword::MaxGradient => surface.max_gradient = self.positive_setting(surface.max_gradient)?,
            Keyword::Precompute => self.precompute()?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// `precompute depth, x, y, z`: which bounds the reference keeps in memory. It changes no picture.
    fn precompute(&mut self) -> Result<()> {
        let word = self.next()?;
        let depth = self.float()?;
        if !DEPTHS.contains(&depth) {
            let message = format!("the depth must be from {} to {}", DEPTHS.start(), DEPTHS.end());
            self.lenient(Diagnostic::warning(word.span, message))?;
        }
        loop {
            self.comma()?;
            let axis = [Keyword::X, Keyword::Y, Keyword::Z].map(Tok::Word);
            if !axis.contains(&self.peek()?.tok) {
                return Ok(());
            }
            self.next()?;
        }
    }
}
