//! `warp { … }`.

use super::pattern::direction;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result};
use crate::math::Vec3;
use crate::pattern::Turbulence;
use crate::pattern::warp::{BlackHole, Planar, Polar, PolarKind, Repeat, Repetition, Warp};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};

impl Parser {
    /// A warp; its keyword has been taken.
    pub(super) fn warp(&mut self) -> Result<Warp> {
        self.expect_punct(Punct::LeftBrace)?;
        let token = self.next()?;
        let warp = match token.tok {
            Tok::Word(Keyword::Turbulence) => Warp::Turbulence(self.turbulence_warp()?),
            Tok::Word(Keyword::Repeat) => Warp::Repeat(self.repeat_warp()?),
            Tok::Word(Keyword::BlackHole) => Warp::BlackHole(self.black_hole()?),
            Tok::Word(Keyword::Spherical) => Warp::Polar(self.polar(PolarKind::Spherical)?),
            Tok::Word(Keyword::Cylindrical) => Warp::Polar(self.polar(PolarKind::Cylindrical)?),
            Tok::Word(Keyword::Toroidal) => {
                Warp::Polar(self.polar(PolarKind::Toroidal { major_radius: 1.0 })?)
            }
            Tok::Word(Keyword::Planar) => Warp::Planar(self.planar_warp()?),
            Tok::Word(Keyword::Cubic) => Warp::Cubic,
            _ => return Err(self.unexpected_among(token, items::WARP.noun, items::WARP.words)),
        };
        self.expect_punct(Punct::RightBrace)?;
        Ok(warp)
    }

    fn turbulence_warp(&mut self) -> Result<Turbulence> {
        let mut turbulence = Turbulence { amount: self.vector()?, ..Turbulence::default() };
        while let Tok::Word(Keyword::Octaves | Keyword::Omega | Keyword::Lambda) = self.peek()?.tok {
            self.octaves(&mut turbulence)?;
        }
        Ok(turbulence)
    }

    fn repeat_warp(&mut self) -> Result<Repeat> {
        let token = self.peek()?;
        let v = self.vector()?;
        let axes: Vec<usize> = (0..3).filter(|&axis| v[axis] != 0.0).collect();
        let [axis] = axes[..] else {
            let message = "a repeat warp has a width along exactly one axis";
            return Err(Box::new(Diagnostic::error(token.span, message)));
        };
        let width = f64::from(v[axis] as f32);
        let mut repeat = Repeat { axis, width, offset: Vec3::ZERO, flip: [false; 3] };
        loop {
            if self.accept(Keyword::Offset)? {
                repeat.offset = self.vector()?;
            } else if self.accept(Keyword::Flip)? {
                repeat.flip = self.vector()?.to_array().map(|c| c != 0.0);
            } else {
                return Ok(repeat);
            }
        }
    }

    fn black_hole(&mut self) -> Result<BlackHole> {
        let centre = self.vector()?;
        self.comma()?;
        let radius = self.float()?;
        let mut hole =
            BlackHole { centre, radius, strength: 1.0, falloff: 2.0, inverse: false, repeat: None };
        let (mut uncertainty, mut acts) = (Vec3::ZERO, true);
        while let Tok::Word(word) = self.peek()?.tok {
            match word {
                Keyword::Strength => hole.strength = self.next().and_then(|_| self.float())?,
                Keyword::Falloff => hole.falloff = self.next().and_then(|_| self.float())?,
                Keyword::Inverse => {
                    self.next()?;
                    hole.inverse = true;
                }
                Keyword::Type => acts = self.next().and_then(|_| self.float())? as i64 == 0,
                Keyword::Repeat => {
                    self.next()?;
                    hole.repeat = Some(Repetition { block: self.vector()?, uncertainty });
                    hole.fit();
                }
                Keyword::Turbulence => {
                    self.next()?;
                    uncertainty = self.vector()?;
                    if let Some(repeat) = &mut hole.repeat {
                        repeat.uncertainty = uncertainty;
                    }
                    hole.fit();
                }
                _ => break,
            }
        }
        if !acts {
            hole.strength = 0.0;
        }
        Ok(hole)
    }

    fn polar(&mut self, kind: PolarKind) -> Result<Polar> {
        let mut polar = Polar { kind, orientation: Vec3::Z, distance_exponent: 0.0 };
        loop {
            if self.accept(Keyword::Orientation)? {
                polar.orientation = direction(self.vector()?);
            } else if self.accept(Keyword::DistExp)? {
                polar.distance_exponent = self.float()?;
            } else if let PolarKind::Toroidal { major_radius } = &mut polar.kind
                && self.accept(Keyword::MajorRadius)?
            {
                *major_radius = self.float()?;
            } else {
                return Ok(polar);
            }
        }
    }

    /// Orientation and offset may be left out.
    fn planar_warp(&mut self) -> Result<Planar> {
        if !self.at_expression()? {
            return Ok(Planar::new(Vec3::Z, 0.0));
        }
        let orientation = self.vector()?;
        self.comma()?;
        Ok(Planar::new(orientation, self.float()?))
    }
}
