//! `finish { … }`.

use crate::color::Rgb;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::material::{Finish, Reflection};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

/// Which terms were given as an `albedo`, to be scaled once exponents are known.
#[derive(Clone, Copy, Default)]
pub(super) struct Albedo {
    diffuse: bool,
    phong: bool,
    specular: bool,
}

impl Parser {
    /// A finish made from the default one.
    pub fn finish_statement(&mut self) -> Result<Arc<Finish>> {
        let base = (*self.scene.default_layer.finish).clone();
        self.finish_statement_from(base).map(Arc::new)
    }

    /// A finish made by changing `base`.
    pub fn finish_statement_from(&mut self, base: Finish) -> Result<Finish> {
        self.expect(Keyword::Finish)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut finish = base;
        if let Some(Value::Finish(named)) = self.peek_value()? {
            self.take_value()?;
            finish = (*named).clone();
        }
        let mut albedo = Albedo::default();
        while self.finish_item(&mut finish, &mut albedo)? {}
        self.close_block(&items::FINISH)?;
        albedo.scale(&mut finish);
        Ok(finish)
    }

    /// One item, if it comes.
    pub(super) fn finish_item(&mut self, finish: &mut Finish, albedo: &mut Albedo) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        if self.finish_number(word, finish)? {
            return Ok(true);
        }
        match word {
            Keyword::Ambient => finish.ambient = self.next().and_then(|_| self.rgb())?,
            Keyword::Emission => finish.emission = self.next().and_then(|_| self.rgb())?,
            Keyword::Diffuse => {
                self.next()?;
                albedo.diffuse = self.accept(Keyword::Albedo)?;
                finish.diffuse = self.float()? as f32;
                self.comma()?;
                finish.diffuse_back = if self.at_expression()? { self.float()? as f32 } else { 0.0 };
                (finish.raw_diffuse, finish.raw_diffuse_back) = (finish.diffuse, finish.diffuse_back);
            }
            Keyword::Phong => {
                self.next()?;
                albedo.phong = self.accept(Keyword::Albedo)?;
                finish.phong = self.float()? as f32;
            }
            Keyword::Specular => {
                self.next()?;
                albedo.specular = self.accept(Keyword::Albedo)?;
                finish.specular = self.float()? as f32;
            }
            Keyword::Metallic => {
                self.next()?;
                finish.metallic = self.optional_number(1.0)?;
            }
            Keyword::ConserveEnergy => {
                self.next()?;
                finish.conserve_energy = true;
            }
            Keyword::Irid => self.irid(finish)?,
            Keyword::Reflection => {
                self.next()?;
                self.reflection(&mut finish.reflection)?;
            }
            Keyword::ReflectionExponent => {
                self.next()?;
                finish.reflection.power = self.reciprocal()?;
            }
            Keyword::Subsurface => self.subsurface(finish)?,
            Keyword::Refraction | Keyword::Ior | Keyword::Caustics => self.old_finish_item(word, finish)?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Items that are one number.
    fn finish_number(&mut self, word: Keyword, finish: &mut Finish) -> Result<bool> {
        let place = match word {
            Keyword::Brilliance => &mut finish.brilliance,
            Keyword::Crand => &mut finish.crand,
            Keyword::PhongSize => &mut finish.phong_size,
            Keyword::Roughness => {
                let token = self.next()?;
                let roughness = self.float()?;
                if roughness == 0.0 {
                    self.warn(Diagnostic::warning(token.span, "roughness is 0: highlights vanish"));
                }
                finish.specular_exponent = (1.0 / roughness) as f32;
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        *place = self.float()? as f32;
        Ok(true)
    }

    fn optional_number(&mut self, default: f32) -> Result<f32> {
        Ok(if self.at_expression()? { self.float()? as f32 } else { default })
    }

    /// One over a number; 0 for 0.
    fn reciprocal(&mut self) -> Result<f32> {
        let v = self.float()?;
        Ok(if v == 0.0 { 0.0 } else { (1.0 / v) as f32 })
    }

    fn irid(&mut self, finish: &mut Finish) -> Result<()> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        finish.irid = self.float()? as f32;
        loop {
            if self.accept(Keyword::Thickness)? {
                finish.irid_thickness = self.float()? as f32;
            } else if self.accept(Keyword::Turbulence)? {
                finish.irid_turbulence = self.float()? as f32;
            } else {
                break;
            }
        }
        self.expect_punct(Punct::RightBrace)?;
        Ok(())
    }

    /// A colour, or `{ [min] [, max] items }`; nothing at all changes nothing.
    fn reflection(&mut self, reflection: &mut Reflection) -> Result<()> {
        if !self.accept_punct(Punct::LeftBrace)? {
            if !self.at_expression()? {
                return Ok(());
            }
            let color = self.rgb()?;
            *reflection =
                Reflection { min: color, max: color, falloff: 1.0, fresnel: false, ..reflection.clone() };
            return Ok(());
        }
        let mut colors = Vec::new();
        if self.peek()?.tok == Tok::Punct(Punct::Comma) {
            colors.push(Rgb::ZERO);
            self.comma()?;
        }
        while colors.len() < 2 && self.at_expression()? {
            colors.push(self.rgb()?);
            self.comma()?;
        }
        let max = colors.last().copied().unwrap_or_default();
        let mut min = colors.first().copied().unwrap_or_default();
        let mut read = Reflection { min, max, falloff: 1.0, fresnel: false, ..reflection.clone() };
        while let Tok::Word(word) = self.peek()?.tok {
            match word {
                Keyword::Fresnel => read.fresnel = self.next().and_then(|_| self.fresnel_flag())?,
                Keyword::Falloff => read.falloff = self.next().and_then(|_| self.float())? as f32,
                Keyword::Exponent => read.power = self.next().and_then(|_| self.reciprocal())?,
                Keyword::Metallic => read.metallic = self.next().and_then(|_| self.optional_number(1.0))?,
                _ => break,
            }
        }
        if read.fresnel && colors.len() < 2 {
            min = Rgb::ZERO;
        }
        read.min = min;
        self.close_block(&items::REFLECTION)?;
        *reflection = read;
        Ok(())
    }

    /// On, off, or left away; an old way of writing it has an index of refraction here.
    fn fresnel_flag(&mut self) -> Result<bool> {
        if !self.at_expression()? {
            return Ok(true);
        }
        let span = self.peek()?.span;
        let value = self.float()?.trunc();
        self.demand(value == 0.0 || value == 1.0, span, "`fresnel` is on or off")?;
        Ok(value > 0.0)
    }

    fn subsurface(&mut self, finish: &mut Finish) -> Result<()> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        loop {
            if self.accept(Keyword::Translucency)? {
                finish.subsurface = Some(self.rgb()?);
            } else if self.accept(Keyword::Anisotropy)? {
                self.rgb()?;
            } else {
                break;
            }
        }
        self.expect_punct(Punct::RightBrace)?;
        Ok(())
    }

    /// What old versions wrote in a finish and new ones write in an interior.
    fn old_finish_item(&mut self, word: Keyword, finish: &mut Finish) -> Result<()> {
        let token = self.next()?;
        let value = self.float()? as f32;
        let message = format!("`{}` belongs in an interior, not in a finish", word.text());
        self.warn(Diagnostic::warning(token.span, message));
        match word {
            Keyword::Refraction => finish.refraction = value,
            Keyword::Ior => finish.ior = Some(value),
            _ => finish.caustics = Some(value),
        }
        Ok(())
    }
}

impl Albedo {
    /// Makes up for the light that brilliance and exponents take away.
    pub(super) fn scale(self, finish: &mut Finish) {
        if self.diffuse {
            let factor = (finish.brilliance + 1.0) / 2.0;
            finish.diffuse *= factor;
            finish.diffuse_back *= factor;
        }
        if self.phong {
            finish.phong *= (finish.phong_size + 1.0) / 2.0;
        }
        if self.specular {
            let n = f64::from(finish.specular_exponent);
            finish.specular *= ((n + 2.0) / (4.0 * (2.0 - (-n / 2.0).exp2()))) as f32;
        }
    }
}
