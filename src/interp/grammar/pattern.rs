//! Patterns, and what may be written after them in pigments, normals, textures and densities alike.

use crate::interp::{FileKind, Parser, Result};
use crate::material::GreyPigment;
use crate::math::Vec3;
use crate::pattern::{
    self, Altitude, Fractal, FractalKind, Gradient, Magnet, Modifier, Pattern, Signal, Slope, SlopeDirection,
    Wave,
};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok, Token};
use crate::world::ObjectQuery;
use std::sync::Arc;

/// The statement that a pattern stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    Pigment,
    Normal,
    Texture,
    Density,
    Function,
}

impl Parser {
    /// A pattern with its parameters, if one comes. [`Parser::end_pattern`] follows after its list.
    pub(super) fn pattern(&mut self, place: Place) -> Result<Option<Arc<dyn Pattern>>> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(None) };
        if let Some(pattern) = plain_pattern(word) {
            self.next()?;
            return Ok(Some(pattern));
        }
        if !is_pattern_with_parameters(word) {
            return Ok(None);
        }
        if word == Keyword::Facets && place != Place::Normal {
            return Err(Box::new(Diagnostic::error(token.span, "`facets` is a pattern for normals only")));
        }
        if place == Place::Function && matches!(word, Keyword::Slope | Keyword::Facets | Keyword::Tiling) {
            let message = format!("`{}` cannot be used in a function", word.text());
            return Err(Box::new(Diagnostic::error(token.span, message)));
        }
        self.next()?;
        let pattern = self.pattern_parameters(word)?;
        if place == Place::Function {
            self.end_pattern(token)?;
        }
        Ok(Some(pattern))
    }

    /// The end of a pattern's list. The list of an object stands in the braces with it.
    pub(super) fn end_pattern(&mut self, keyword: Token) -> Result<()> {
        if keyword.tok == Tok::Word(Keyword::Object) {
            self.expect_punct(Punct::RightBrace)?;
        }
        Ok(())
    }

    fn pattern_parameters(&mut self, word: Keyword) -> Result<Arc<dyn Pattern>> {
        Ok(match word {
            Keyword::DensityFile => Arc::new(self.density_file()?),
            Keyword::Facets => Arc::new(pattern::Facets::default()),
            Keyword::Gradient => Arc::new(Gradient::new(self.vector()?)),
            Keyword::Spiral1 => Arc::new(pattern::Spiral::single(self.float()?)),
            Keyword::Spiral2 => Arc::new(pattern::Spiral::double(self.float()?)),
            Keyword::Mandel => Arc::new(self.mandel(FractalKind::Power(2))?),
            Keyword::Julia => Arc::new(self.julia(FractalKind::Power(2))?),
            Keyword::Magnet => Arc::new(self.magnet()?),
            Keyword::Slope => Arc::new(self.slope()?),
            Keyword::Tiling => Arc::new(self.tiling()?),
            Keyword::Function => Arc::new(pattern::Function(self.function_body_xyz()?)),
            Keyword::Object => {
                self.expect_punct(Punct::LeftBrace)?;
                let object = self.required_object()?;
                Arc::new(pattern::InsideOut(Arc::new(ObjectQuery::new(&object))))
            }
            Keyword::ImagePattern => Arc::new(self.image_pattern()?),
            Keyword::Pavement => Arc::new(pattern::Pavement::default()),
            Keyword::PigmentPattern => {
                let base = (*self.scene.default_layer.pigment).clone();
                Arc::new(GreyPigment(Arc::new(self.braced_pigment(base)?)))
            }
            _ => return Err(self.unexpected("a pattern")),
        })
    }

    /// `df3 "name"`.
    fn density_file(&mut self) -> Result<pattern::DensityFile> {
        self.expect(Keyword::Df3)?;
        let span = self.peek()?.span;
        let name = self.file_name()?;
        let path = self.require_file(&name, FileKind::Df3, span)?;
        let failed = |e: String| Box::new(Diagnostic::error(span, format!("cannot read `{name}`: {e}")));
        let bytes = std::fs::read(&path).map_err(|e| failed(e.to_string()))?;
        pattern::DensityFile::new(&bytes).map_err(failed)
    }

    fn tiling(&mut self) -> Result<pattern::Tiling> {
        let token = self.peek()?;
        let number = self.float()?;
        match pattern::Tiling::new(number.clamp(0.0, 99.0) as u32) {
            Some(tiling) => Ok(tiling),
            None => {
                let message = format!("tilings have the numbers 1 to {}", pattern::Tiling::COUNT);
                Err(Box::new(Diagnostic::error(token.span, message)))
            }
        }
    }

    fn iterations(&mut self) -> Result<u32> {
        let n = self.float()?;
        Ok(n.clamp(0.0, 1e9) as u32)
    }

    fn mandel(&mut self, kind: FractalKind) -> Result<Fractal> {
        Ok(Fractal::new(kind, None, self.iterations()?))
    }

    fn julia(&mut self, kind: FractalKind) -> Result<Fractal> {
        let constant = self.vector2()?;
        self.comma()?;
        Ok(Fractal::new(kind, Some(constant.to_array()), self.iterations()?))
    }

    fn magnet(&mut self) -> Result<Fractal> {
        let token = self.peek()?;
        let kind = match self.float()? as i64 {
            1 => Magnet::First,
            2 => Magnet::Second,
            _ => {
                return Err(Box::new(Diagnostic::error(
                    token.span,
                    "there are magnets of type 1 and 2 only",
                )));
            }
        };
        if self.accept(Keyword::Mandel)? {
            self.mandel(FractalKind::Magnet(kind))
        } else {
            self.expect(Keyword::Julia)?;
            self.julia(FractalKind::Magnet(kind))
        }
    }

    /// `V`, or `{ V | point_at Q [, low, high] [altitude W [, low, high]] }`.
    fn slope(&mut self) -> Result<Slope> {
        if !self.accept_punct(Punct::LeftBrace)? {
            let direction = self.slope_direction()?;
            return Ok(Slope { direction, low: 0.0, high: 0.0, altitude: None });
        }
        let direction = if self.accept(Keyword::PointAt)? {
            SlopeDirection::PointAt(self.vector()?)
        } else {
            self.slope_direction()?
        };
        let (low, high) = self.slope_range()?;
        let mut slope = Slope { direction, low, high, altitude: None };
        if self.accept(Keyword::Altitude)? {
            let direction = self.vector()?;
            let (low, high) = self.slope_range()?;
            slope.altitude = Some(Altitude { direction, low, high });
        }
        self.expect_punct(Punct::RightBrace)?;
        Ok(slope)
    }

    fn slope_range(&mut self) -> Result<(f64, f64)> {
        self.comma()?;
        if !self.at_expression()? {
            return Ok((0.0, 0.0));
        }
        let low = self.float()?;
        self.comma()?;
        Ok((low, if self.at_expression()? { self.float()? } else { 0.0 }))
    }

    /// One of the settings that all uses of patterns share: transformations and warps, turbulence, frequency
    /// and wave, and the settings of single patterns. False if none comes.
    pub(super) fn signal_modifier(&mut self, signal: &mut Signal) -> Result<bool> {
        if let Some(transform) = self.transformation()? {
            signal.transform(&transform);
            return Ok(true);
        }
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        if self.wave(word, signal)? {
            return Ok(true);
        }
        match word {
            Keyword::Turbulence => {
                self.next()?;
                signal.turbulence.amount = self.vector()?;
            }
            Keyword::Octaves | Keyword::Omega | Keyword::Lambda => {
                self.octaves(&mut signal.turbulence)?;
            }
            Keyword::Frequency => {
                self.next()?;
                signal.frequency = self.single()?;
            }
            Keyword::Phase => {
                self.next()?;
                signal.phase = self.single()?;
            }
            Keyword::NoiseGenerator => {
                self.next()?;
                signal.noise_generator |= self.noise_generator()?;
            }
            Keyword::Warp => {
                self.next()?;
                let warp = self.warp()?;
                signal.chain.warp(warp);
            }
            _ => return self.pattern_modifier(word, signal),
        }
        Ok(true)
    }

    /// A number that is kept in single precision.
    pub(super) fn single(&mut self) -> Result<f64> {
        Ok(f64::from(self.float()? as f32))
    }

    fn slope_direction(&mut self) -> Result<SlopeDirection> {
        let span = self.peek()?.span;
        let direction = self.vector()?;
        self.demand(direction != Vec3::ZERO, span, "a slope needs a direction")?;
        Ok(SlopeDirection::Along(direction))
    }

    /// How a fractal is colored inside or outside, and a factor.
    fn coloring(&mut self, word: Keyword) -> Result<(u32, f64)> {
        let span = self.peek()?.span;
        let kind = self.float()?.trunc();
        let most = if word == Keyword::Interior { 6.0 } else { 8.0 };
        let text = format!("`{}` has the types 0 to {most}", word.text());
        self.demand((0.0..=most).contains(&kind), span, &text)?;
        self.comma()?;
        if self.at_expression()? {
            return Ok((kind as u32, self.float()?));
        }
        let text = format!("`{}` has no factor: 1 is taken", word.text());
        self.lenient(Diagnostic::warning(self.last_span(), text))?;
        Ok((kind as u32, 1.0))
    }

    fn noise_generator(&mut self) -> Result<u32> {
        let token = self.peek()?;
        let n = self.float()?;
        let text = "noise generators have the numbers 1 to 3";
        self.demand((0.0..4.0).contains(&n.trunc()), token.span, text)?;
        Ok(n as u32)
    }

    /// `octaves`, `omega` or `lambda`, which comes.
    pub(super) fn octaves(&mut self, turbulence: &mut pattern::Turbulence) -> Result<()> {
        match self.next()?.tok {
            Tok::Word(Keyword::Octaves) => turbulence.octaves = self.float()?.clamp(1.0, 10.0) as u32,
            Tok::Word(Keyword::Omega) => turbulence.omega = self.single()?,
            _ => turbulence.lambda = self.single()?,
        }
        Ok(())
    }

    fn wave(&mut self, word: Keyword, signal: &mut Signal) -> Result<bool> {
        let wave = match word {
            Keyword::RampWave => Wave::Ramp,
            Keyword::TriangleWave => Wave::Triangle,
            Keyword::SineWave => Wave::Sine,
            Keyword::ScallopWave => Wave::Scallop,
            Keyword::CubicWave => Wave::Cubic,
            Keyword::PolyWave => {
                self.next()?;
                if self.at_expression()? {
                    signal.poly_exponent = self.single()?;
                }
                signal.wave = Wave::Poly(signal.poly_exponent);
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        signal.wave = wave;
        Ok(true)
    }

    /// A setting of one pattern; an error if the pattern is another.
    fn pattern_modifier(&mut self, word: Keyword, signal: &mut Signal) -> Result<bool> {
        if !is_pattern_modifier(word) {
            return Ok(false);
        }
        let token = self.next()?;
        let modifier = match word {
            Keyword::AgateTurb => Modifier::AgateTurbulence(self.single()?),
            Keyword::BrickSize => Modifier::BrickSize(self.vector()?),
            Keyword::Mortar => Modifier::Mortar(self.single()?),
            Keyword::Control0 => Modifier::Control0(self.single()?),
            Keyword::Control1 => Modifier::Control1(self.single()?),
            Keyword::Metric => Modifier::Metric(self.vector()?.x),
            Keyword::Form => Modifier::Form(self.vector()?),
            Keyword::Offset => Modifier::Offset(self.float()?),
            Keyword::Solid => Modifier::Solid(true),
            Keyword::Size => Modifier::Size(self.float()?),
            Keyword::Coords => Modifier::Coords(self.float()?),
            Keyword::Exponent => Modifier::Exponent(self.fractal_exponent()?),
            Keyword::Exterior | Keyword::Interior => {
                let (kind, factor) = self.coloring(word)?;
                if word == Keyword::Exterior {
                    Modifier::Exterior(kind, factor)
                } else {
                    Modifier::Interior(kind, factor)
                }
            }
            Keyword::Interpolate => Modifier::Interpolate(self.small_number()?),
            Keyword::NumberOfSides => Modifier::Sides(self.small_number()?),
            Keyword::NumberOfTiles => Modifier::Tiles(self.small_number()?),
            _ => Modifier::Number(self.small_number()?),
        };
        match signal.pattern.modified(modifier) {
            Some(pattern) => signal.pattern = pattern,
            None => {
                let message = format!("`{}` does not apply to this pattern", word.text());
                return Err(Box::new(Diagnostic::error(token.span, message)));
            }
        }
        Ok(true)
    }

    fn small_number(&mut self) -> Result<u32> {
        Ok(self.float()?.clamp(0.0, 99.0) as u32)
    }

    fn fractal_exponent(&mut self) -> Result<u32> {
        let token = self.peek()?;
        let exponent = self.float()?;
        if (2.0..34.0).contains(&exponent) {
            return Ok(exponent as u32);
        }
        self.warn(Diagnostic::warning(token.span, "fractals have exponents from 2 to 33; 2 is used"));
        Ok(2)
    }
}

/// Patterns that are no more than their keyword.
fn plain_pattern(word: Keyword) -> Option<Arc<dyn Pattern>> {
    use pattern::*;
    Some(match word {
        Keyword::Agate => Arc::new(Agate::default()),
        Keyword::Aoi => Arc::new(Aoi),
        Keyword::Boxed => Arc::new(Boxed),
        Keyword::Bozo => Arc::new(Bozo),
        Keyword::Brick => Arc::new(Brick::default()),
        Keyword::Bumps => Arc::new(Bumps),
        Keyword::Cells => Arc::new(Cells),
        Keyword::Checker => Arc::new(Checker),
        Keyword::Crackle => Arc::new(Crackle::default()),
        Keyword::Cubic => Arc::new(Cubic),
        Keyword::Cylindrical => Arc::new(Cylindrical),
        Keyword::Dents => Arc::new(Dents),
        Keyword::Granite => Arc::new(Granite),
        Keyword::Hexagon => Arc::new(Hexagon),
        Keyword::Leopard => Arc::new(Leopard),
        Keyword::Marble => Arc::new(Marble),
        Keyword::Onion => Arc::new(Onion),
        Keyword::Planar => Arc::new(Planar),
        Keyword::Quilted => Arc::new(Quilted::default()),
        Keyword::Radial => Arc::new(Radial),
        Keyword::Ripples => Arc::new(Ripples),
        Keyword::Spherical => Arc::new(Spherical),
        Keyword::Spotted => Arc::new(Spotted),
        Keyword::Square => Arc::new(Square),
        Keyword::Triangular => Arc::new(Triangular),
        Keyword::Waves => Arc::new(Waves),
        Keyword::Wood => Arc::new(Wood),
        Keyword::Wrinkles => Arc::new(Wrinkles),
        _ => return None,
    })
}

fn is_pattern_with_parameters(word: Keyword) -> bool {
    use Keyword::*;
    matches!(
        word,
        DensityFile
            | Facets
            | Function
            | Gradient
            | ImagePattern
            | Julia
            | Magnet
            | Mandel
            | Object
            | Pavement
            | PigmentPattern
            | Slope
            | Spiral1
            | Spiral2
            | Tiling
    )
}

fn is_pattern_modifier(word: Keyword) -> bool {
    use Keyword::*;
    matches!(
        word,
        AgateTurb
            | BrickSize
            | Control0
            | Control1
            | Coords
            | Exponent
            | Exterior
            | Form
            | Interior
            | Interpolate
            | Metric
            | Mortar
            | NumberOfSides
            | NumberOfTiles
            | Offset
            | Pattern
            | Size
            | Solid
    )
}

/// Unit vector along which a warp lies; z if it is 0.
pub(super) fn direction(v: Vec3) -> Vec3 {
    v.normalize_or(Vec3::Z)
}
