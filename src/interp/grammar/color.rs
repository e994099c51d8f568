//! Colours: `rgb …`, `color …`, and components by name.

use crate::color::{Color, Gamma, Rgb};
use crate::interp::expr::{Number, is_color_word};
use crate::interp::{Parser, Result};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Tok};

impl Parser {
    /// A colour item (`rgb …`, `color …`, `Id filter 0.5`, a bare vector …).
    pub fn color(&mut self) -> Result<Color> {
        let color = self.color_item(5)?;
        Ok(Color::from_components(color.map(|c| c as f32)))
    }

    /// A colour where filter and transmit mean nothing: a number is replicated to red, green and blue.
    pub fn rgb(&mut self) -> Result<Rgb> {
        let start = self.peek_operand()?.span;
        let color = self.color_item(3)?;
        if color[3] != 0.0 || color[4] != 0.0 {
            let text = "filter and transmit mean nothing here";
            self.warn(Diagnostic::warning(start.to(self.last), text));
        }
        Ok(Rgb::new(color[0] as f32, color[1] as f32, color[2] as f32))
    }

    /// The five components; a plain number fills `spread` of them. A colour that is left away, alone or behind
    /// `color`, is black.
    fn color_item(&mut self, spread: usize) -> Result<[f64; 5]> {
        self.accept(Keyword::Color)?;
        let first = self.peek_operand()?;
        let mut color = match first.tok {
            Tok::Word(word) if is_color_word(word) => match components(word) {
                Some(parts) => {
                    self.take(first)?;
                    self.color_word(word, parts, first.span)?
                }
                None => [0.0; 5],
            },
            _ if self.at_expression()? => self.full()?.plain().filled(spread),
            Tok::Identifier(_) => return Err(self.unexpected("a color")),
            _ => [0.0; 5],
        };
        while self.component(&mut color)? {}
        Ok(color)
    }

    /// What follows `rgb` and its like: `parts` says which components a plain number fills.
    fn color_word(&mut self, word: Keyword, parts: Parts, span: Span) -> Result<[f64; 5]> {
        let value = self.full()?.plain();
        let mut color = match value {
            Number::Scalar(v) => parts.spread(v),
            // The vector's 4th component is the transmit of `rgbt`.
            Number::Tuple(n, v) if n <= 4 && parts.transmit && !parts.filter => [v[0], v[1], v[2], 0.0, v[3]],
            Number::Tuple(_, v) => v,
        };
        if value.len() > parts.count() {
            let span = span.to(self.last);
            let message =
                format!("`{}` has {} components, but {} are given", word.text(), parts.count(), value.len());
            self.warn(Diagnostic::warning(span, message));
        }
        if parts.srgb {
            let gamma = self.working_gamma(span)?;
            for c in &mut color[..3] {
                *c = gamma.encode(f64::from(decoded(*c as f32)));
            }
        }
        Ok(color)
    }

    fn working_gamma(&mut self, span: Span) -> Result<Gamma> {
        if self.scene.gamma_given {
            return Ok(self.scene.scene.globals.gamma);
        }
        Err(Box::new(
            Diagnostic::error(span, "`srgb` colors need to know the scene's gamma")
                .with_hint("say `global_settings { assumed_gamma 1.0 }` before them"),
        ))
    }

    /// `red f` and its like; false if none comes.
    fn component(&mut self, color: &mut [f64; 5]) -> Result<bool> {
        let token = self.peek()?;
        let index = match token.tok {
            Tok::Word(Keyword::Red) => 0,
            Tok::Word(Keyword::Green) => 1,
            Tok::Word(Keyword::Blue) => 2,
            Tok::Word(Keyword::Filter) => 3,
            Tok::Word(Keyword::Alpha) => {
                self.warn(Diagnostic::warning(token.span, "`alpha` is an old word for `filter`"));
                3
            }
            Tok::Word(Keyword::Transmit) => 4,
            _ => return Ok(false),
        };
        self.take(token)?;
        color[index] = self.float()?;
        Ok(true)
    }
}

/// Which components a colour word speaks of.
#[derive(Clone, Copy)]
struct Parts {
    filter: bool,
    transmit: bool,
    srgb: bool,
}

impl Parts {
    fn count(self) -> usize {
        3 + usize::from(self.filter) + usize::from(self.transmit)
    }

    fn spread(self, v: f64) -> [f64; 5] {
        let only = |on: bool| if on { v } else { 0.0 };
        [v, v, v, only(self.filter), only(self.transmit)]
    }
}

fn components(word: Keyword) -> Option<Parts> {
    let (filter, transmit, srgb) = match word {
        Keyword::Rgb => (false, false, false),
        Keyword::Rgbf => (true, false, false),
        Keyword::Rgbt => (false, true, false),
        Keyword::Rgbft => (true, true, false),
        Keyword::Srgb => (false, false, true),
        Keyword::Srgbf => (true, false, true),
        Keyword::Srgbt => (false, true, true),
        Keyword::Srgbft => (true, true, true),
        _ => return None,
    };
    Some(Parts { filter, transmit, srgb })
}

/// The light of an sRGB value, in single precision as the language computes it.
fn decoded(c: f32) -> f32 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}
