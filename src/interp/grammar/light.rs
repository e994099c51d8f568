//! `light_source`.

use crate::color::Rgb;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::light::{AreaLight, CylinderBeam, Light, LightKind, SpotBeam};
use crate::math::{Transform, Vec3};
use crate::scene::{Body, LightSource, Object};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::sync::Arc;

/// A light while its statement is read: settings of an area may come before the area itself.
struct LightBuilder {
    source: LightSource,
    grid: AreaLight,
    has_area: bool,
}

impl LightBuilder {
    fn new(source: LightSource) -> Self {
        let none = AreaLight::new(Vec3::ZERO, Vec3::ZERO, 1, 1);
        let grid = source.light.area.clone();
        Self { has_area: grid.is_some(), grid: grid.unwrap_or(none), source }
    }

    fn apply(&mut self, t: &Transform) {
        let light = &mut self.source.light;
        *light = light.transformed(t);
        self.grid.axis1 = t.vector(self.grid.axis1);
        self.grid.axis2 = t.vector(self.grid.axis2);
        for body in [&mut self.source.looks_like, &mut self.source.projected_through].into_iter().flatten() {
            Arc::make_mut(body).apply(t);
        }
    }

    fn finished(mut self) -> LightSource {
        self.source.light.area = self.has_area.then_some(self.grid);
        self.source
    }
}

impl Parser {
    /// `light_source { … }`; the word is the next token.
    pub(crate) fn light_source_statement(&mut self) -> Result<Object> {
        self.expect(Keyword::LightSource)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut light = LightBuilder::new(self.light_begin()?);
        loop {
            if let Some(t) = self.transformation()? {
                light.apply(&t);
                continue;
            }
            let token = self.peek()?;
            match token.tok {
                Tok::Punct(Punct::RightBrace) => break,
                Tok::Punct(Punct::Comma) => {}
                Tok::Word(word) => {
                    self.next()?;
                    if self.light_kind_item(&mut light.source.light, word)?
                        || self.light_grid_item(&mut light, word)?
                        || self.light_item(&mut light.source.light, word)?
                        || self.light_body_item(&mut light.source, token)?
                    {
                        continue;
                    }
                    return Err(not_in_a_light(token.span, word));
                }
                _ => return Err(self.unexpected_item(&items::LIGHT)),
            }
            self.next()?;
        }
        let close = self.expect_punct(Punct::RightBrace)?;
        let fits = !light.grid.circular || (light.grid.size1 > 1 && light.grid.size2 > 1);
        self.demand(fits, close.span, "a circular area light has at least 2 lamps along each side")?;
        Ok(Object::new(Body::Light(Arc::new(light.finished()))))
    }

    /// An identifier with a light, or location and colour.
    fn light_begin(&mut self) -> Result<LightSource> {
        if let Some(Value::Object(object)) = self.peek_value()? {
            let token = self.peek()?;
            let Body::Light(source) = &object.body else {
                let text = "this object is not a light";
                return Err(Box::new(Diagnostic::error(token.span, text)));
            };
            self.take_value()?;
            let mut builder = LightBuilder::new((**source).clone());
            builder.apply(&object.transform);
            return Ok(builder.finished());
        }
        let location = self.vector()?;
        self.comma()?;
        let color = if self.at_expression()? { self.rgb()? } else { Rgb::ZERO };
        let light = Light { location, color, ..Light::default() };
        Ok(LightSource { light, looks_like: None, projected_through: None })
    }

    /// Items that give the beam its shape.
    fn light_kind_item(&mut self, light: &mut Light, word: Keyword) -> Result<bool> {
        match word {
            Keyword::Spotlight => light.kind = LightKind::Spot(SpotBeam::default()),
            Keyword::Cylinder => light.kind = LightKind::Cylinder(CylinderBeam::default()),
            Keyword::Parallel => light.parallel = true,
            Keyword::PointAt if light.parallel || light.kind != LightKind::Point => {
                light.point_at = self.vector()?;
            }
            Keyword::Radius | Keyword::Falloff | Keyword::Tightness if light.kind != LightKind::Point => {
                let value = self.float()?;
                set_beam(&mut light.kind, word, value);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn light_grid_item(&mut self, light: &mut LightBuilder, word: Keyword) -> Result<bool> {
        if word == Keyword::ColorMap {
            let span = self.last;
            self.color_map()?;
            self.warn(Diagnostic::warning(span, "a `color_map` changes nothing in a light source"));
            return Ok(true);
        }
        let grid = &mut light.grid;
        match word {
            Keyword::AreaLight => {
                grid.axis1 = self.vector()?;
                self.comma()?;
                grid.axis2 = self.vector()?;
                self.comma()?;
                grid.size1 = self.lamp_count()?;
                self.comma()?;
                grid.size2 = self.lamp_count()?;
                light.has_area = true;
            }
            Keyword::Adaptive => grid.adaptive = self.float()?.max(0.0) as u32,
            Keyword::Jitter => grid.jitter = true,
            Keyword::Circular => grid.circular = true,
            Keyword::Orient => grid.orient = true,
            Keyword::AreaIllumination => grid.illumination = self.flag()?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Lamps along one side of an area light.
    fn lamp_count(&mut self) -> Result<u32> {
        let token = self.peek()?;
        let count = self.float()?;
        if (1.0..=MOST_LAMPS).contains(&count) {
            return Ok(count as u32);
        }
        let text = format!("an area light has 1 to {MOST_LAMPS} lamps along each side");
        Err(Box::new(Diagnostic::error(token.span, text)))
    }

    fn light_item(&mut self, light: &mut Light, word: Keyword) -> Result<bool> {
        match word {
            Keyword::Shadowless => light.shadowless = true,
            Keyword::FadeDistance => light.fade_distance = self.float()?,
            Keyword::FadePower => light.fade_power = self.float()?,
            Keyword::MediaAttenuation => light.media_attenuation = self.flag()?,
            Keyword::MediaInteraction => light.media_interaction = self.flag()?,
            Keyword::Photons => self.light_photons(light)?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Objects that belong to the light.
    fn light_body_item(&mut self, source: &mut LightSource, token: Token) -> Result<bool> {
        match token.tok {
            Tok::Word(Keyword::LooksLike) => {
                let mut body = self.light_body(Parser::textured_object)?;
                body.apply(&Transform::translate(source.light.location));
                body.flags.no_shadow = true;
                source.looks_like = Some(Arc::new(body));
            }
            Tok::Word(Keyword::ProjectedThrough) => {
                let mut body = self.light_body(Parser::required_object)?;
                if !body.textures.is_empty() || body.interior.is_some() {
                    let text = "texture and interior of a `projected_through` object are left out";
                    self.warn(Diagnostic::warning(token.span, text));
                }
                body.textures.clear();
                body.interior = None;
                source.projected_through = Some(Arc::new(body));
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// `{ object transformations }`.
    fn light_body(&mut self, object: fn(&mut Parser) -> Result<Object>) -> Result<Object> {
        self.expect_punct(Punct::LeftBrace)?;
        let mut body = object(self)?;
        while let Some(t) = self.transformation()? {
            body.apply(&t);
        }
        self.expect_punct(Punct::RightBrace)?;
        Ok(body)
    }

    /// `{ … }` behind `photons`.
    fn light_photons(&mut self, light: &mut Light) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            let token = self.peek()?;
            match token.tok {
                Tok::Word(Keyword::Refraction) => {
                    self.next()?;
                    light.photons.refraction = Some(self.flag()?);
                }
                Tok::Word(Keyword::Reflection) => {
                    self.next()?;
                    light.photons.reflection = Some(self.flag()?);
                }
                Tok::Word(Keyword::AreaLight) => {
                    self.next()?;
                    light.photons.area_light = true;
                }
                _ => return Err(self.unexpected("`refraction`, `reflection`, `area_light` or `}`")),
            }
        }
        Ok(())
    }
}

/// Lamps along one side of an area light.
const MOST_LAMPS: f64 = 4096.0;

/// Angles of a spotlight are written in degrees.
fn set_beam(kind: &mut LightKind, word: Keyword, value: f64) {
    let (place, value) = match (kind, word) {
        (LightKind::Spot(beam), Keyword::Radius) => (&mut beam.radius, value.to_radians()),
        (LightKind::Spot(beam), Keyword::Falloff) => (&mut beam.falloff, value.to_radians()),
        (LightKind::Spot(beam), _) => (&mut beam.tightness, value),
        (LightKind::Cylinder(beam), Keyword::Radius) => (&mut beam.radius, value),
        (LightKind::Cylinder(beam), Keyword::Falloff) => (&mut beam.falloff, value),
        (LightKind::Cylinder(beam), _) => (&mut beam.tightness, value),
        (LightKind::Point, _) => return,
    };
    *place = value;
}

fn not_in_a_light(span: Span, word: Keyword) -> Box<Diagnostic> {
    let error = Diagnostic::error(span, format!("`{}` does not fit here in a light source", word.text()));
    Box::new(match word {
        Keyword::PointAt => error.with_hint("say `spotlight`, `cylinder` or `parallel` before it"),
        Keyword::Radius | Keyword::Falloff | Keyword::Tightness => {
            error.with_hint("say `spotlight` or `cylinder` before it")
        }
        _ => error,
    })
}
