//! What is around the objects: `background`, `fog`, `rainbow`, `sky_sphere`.

use crate::color::{Color, Rgb};
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::math::Vec3;
use crate::math::noise::Turbulence;
use crate::pattern::BlendMap;
use crate::scene::{Background, Fog, Rainbow, SkySphere};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};

/// The sine between two directions that count as one.
const NEARLY_PARALLEL: f64 = 1e-10;

impl Parser {
    /// `background { color }`; the word is the next token.
    pub(crate) fn background_statement(&mut self) -> Result<()> {
        self.expect(Keyword::Background)?;
        self.expect_punct(Punct::LeftBrace)?;
        let color = self.color()?;
        self.expect_punct(Punct::RightBrace)?;
        let modern = self.effective_version() >= 370;
        self.scene.scene.background =
            if modern { Background::Translucent(color) } else { Background::Opaque(color.rgb) };
        Ok(())
    }

    /// `fog { … }`; the word is the next token.
    pub(crate) fn fog_statement(&mut self) -> Result<Fog> {
        self.expect(Keyword::Fog)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut fog = match self.peek_value()? {
            Some(Value::Fog(fog)) => {
                self.take_value()?;
                (*fog).clone()
            }
            _ => Fog::default(),
        };
        while !self.accept_punct(Punct::RightBrace)? {
            if let Some(t) = self.transformation()? {
                fog.up = t.vector(fog.up);
            } else if !self.fog_item(&mut fog)? {
                self.fog_color_or_number(&mut fog)?;
            }
        }
        fog.up = fog.up.normalize_or(Vec3::Y);
        Ok(fog)
    }

    /// An item that begins with a word; false for others.
    fn fog_item(&mut self, fog: &mut Fog) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        let place = match word {
            Keyword::Distance => &mut fog.distance,
            Keyword::FogOffset => &mut fog.offset,
            Keyword::FogAlt => &mut fog.altitude,
            Keyword::TurbDepth => &mut fog.turbulence_depth,
            Keyword::Omega => &mut fog.turbulence.omega,
            Keyword::Lambda => &mut fog.turbulence.lambda,
            Keyword::Up | Keyword::Turbulence => {
                self.next()?;
                let v = self.vector()?;
                *(if word == Keyword::Up { &mut fog.up } else { &mut fog.turbulence.amount }) = v;
                return Ok(true);
            }
            Keyword::Octaves => {
                self.next()?;
                fog.turbulence.octaves = self.float()?.clamp(1.0, 10.0) as u32;
                return Ok(true);
            }
            Keyword::FogType => {
                self.next()?;
                fog.kind = self.float()? as u32;
                if !(1..=2).contains(&fog.kind) {
                    self.warn(Diagnostic::warning(
                        token.span,
                        "there are fog types 1 and 2: this is read as 1",
                    ));
                    fog.kind = 1;
                }
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        *place = self.float()?;
        Ok(true)
    }

    /// A colour, or as old scenes have it a number for the distance.
    fn fog_color_or_number(&mut self, fog: &mut Fog) -> Result<()> {
        if !self.at_expression()? {
            return Err(self.unexpected_item(&items::FOG));
        }
        let token = self.peek()?;
        let number = match token.tok {
            Tok::Number(_) => true,
            Tok::Identifier(_) => matches!(self.peek_value()?, Some(Value::Float(_))),
            _ => false,
        };
        if !number {
            fog.color = self.color()?;
            return Ok(());
        }
        fog.distance = self.float()?;
        let text = "a number alone in a fog is its distance";
        self.warn(Diagnostic::warning(token.span, text).with_hint("write `distance` before it"));
        Ok(())
    }

    /// `rainbow { … }`; the word is the next token.
    pub(crate) fn rainbow_statement(&mut self) -> Result<Rainbow> {
        let word = self.expect(Keyword::Rainbow)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut rainbow = match self.peek_value()? {
            Some(Value::Rainbow(rainbow)) => {
                self.take_value()?;
                (*rainbow).clone()
            }
            _ => Rainbow::default(),
        };
        while !self.accept_punct(Punct::RightBrace)? {
            self.rainbow_item(&mut rainbow)?;
        }
        let refused = |message| Err(Box::new(Diagnostic::error(word.span, message)));
        match (rainbow.direction.try_normalize(), rainbow.up.try_normalize()) {
            (None, _) => return refused("the rainbow's direction is 0"),
            (_, None) => return refused("the rainbow's `up` is 0"),
            (Some(direction), Some(up)) if direction.cross(up).length() < NEARLY_PARALLEL => {
                return refused("the rainbow's direction and `up` are parallel");
            }
            (Some(direction), _) => rainbow.direction = direction,
        }
        Ok(rainbow)
    }

    fn rainbow_item(&mut self, rainbow: &mut Rainbow) -> Result<()> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Err(self.unexpected_item(&items::RAINBOW)) };
        if word == Keyword::ColorMap {
            self.next()?;
            rainbow.colors = self.color_map()?;
            return Ok(());
        }
        self.next()?;
        match word {
            Keyword::Angle => rainbow.angle = self.float()?.to_radians(),
            Keyword::Width => rainbow.width = self.float()?.to_radians(),
            Keyword::ArcAngle => rainbow.arc_angle = Some(self.turn()?.to_radians()),
            Keyword::FalloffAngle => rainbow.falloff_angle = Some(self.turn()?.to_radians()),
            Keyword::Distance => rainbow.distance = self.float()?,
            Keyword::Jitter => rainbow.jitter = self.float()?,
            Keyword::Direction => rainbow.direction = self.vector()?,
            Keyword::Up => rainbow.up = self.vector()?,
            _ => {
                let text = format!("`{}` does not fit into a rainbow", word.text());
                return Err(Box::new(Diagnostic::error(token.span, text)));
            }
        }
        Ok(())
    }

    /// An angle up to a full turn.
    fn turn(&mut self) -> Result<f64> {
        let span = self.peek()?.span;
        let angle = self.float()?;
        self.demand((0.0..=360.0).contains(&angle), span, "this angle is from 0 to 360 degrees")?;
        Ok(angle)
    }

    /// `sky_sphere { … }`; the word is the next token.
    pub(crate) fn sky_sphere_statement(&mut self) -> Result<SkySphere> {
        let keyword = self.expect(Keyword::SkySphere)?;
        self.expect_punct(Punct::LeftBrace)?;
        let mut sky = match self.peek_value()? {
            Some(Value::SkySphere(sky)) => {
                self.take_value()?;
                (*sky).clone()
            }
            _ => SkySphere { pigments: Vec::new(), emission: Rgb::ONE, transform: Default::default() },
        };
        while !self.accept_punct(Punct::RightBrace)? {
            if let Some(t) = self.transformation()? {
                sky.transform = sky.transform.then(&t);
                continue;
            }
            match self.peek()?.tok {
                Tok::Word(Keyword::Pigment) => sky.pigments.push(self.pigment_statement()?),
                Tok::Word(Keyword::Emission) => {
                    self.next()?;
                    sky.emission = self.rgb()?;
                }
                _ => return Err(self.unexpected("`pigment`, `emission`, a transformation or `}`")),
            }
        }
        if sky.pigments.is_empty() {
            let text = "a sky_sphere needs a pigment";
            return Err(Box::new(Diagnostic::error(keyword.span, text)));
        }
        Ok(sky)
    }
}

impl Default for Fog {
    fn default() -> Self {
        Self {
            kind: 1,
            color: Color::BLACK,
            distance: 0.0,
            offset: 0.0,
            altitude: 0.0,
            up: Vec3::Y,
            turbulence: Turbulence::default(),
            turbulence_depth: 0.5,
        }
    }
}

impl Default for Rainbow {
    fn default() -> Self {
        Self {
            angle: 0.0,
            width: 0.0,
            direction: Vec3::ZERO,
            up: Vec3::Y,
            distance: 1e7,
            jitter: 0.0,
            arc_angle: None,
            falloff_angle: None,
            colors: BlendMap::new(vec![(0.0, Color::BLACK)]),
        }
    }
}
