//! Maps: `color_map`, `pigment_map`, `normal_map`, `texture_map`, `slope_map`, `density_map`.

use super::pattern::Place;
use crate::color::Color;
use crate::interp::value::Map;
use crate::interp::{Parser, Result, Value};
use crate::material::{Normal, NormalKind, Pigment, Texture};
use crate::pattern::{BlendMap, ColorMap};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

/// Entries that a map can have at most.
const MOST_ENTRIES: usize = 256;

impl Parser {
    /// A map with its keyword, for an identifier to keep.
    pub fn map_statement(&mut self) -> Result<Value> {
        let token = self.next()?;
        let map = match token.tok {
            Tok::Word(Keyword::ColorMap) => Map::Colors(self.color_map()?),
            Tok::Word(Keyword::PigmentMap) => Map::Pigments(self.pigment_map(Place::Pigment, false)?),
            Tok::Word(Keyword::DensityMap) => Map::Densities(self.pigment_map(Place::Density, false)?),
            Tok::Word(Keyword::NormalMap) => Map::Normals(self.normal_map(false)?),
            Tok::Word(Keyword::TextureMap) => Map::Textures(self.texture_map(false)?),
            Tok::Word(Keyword::SlopeMap) => Map::Slopes(self.slope_map()?),
            _ => return Err(self.unexpected("a map")),
        };
        Ok(Value::Map(Arc::new(map)))
    }

    /// The braces of a map: an identifier alone (`chosen` takes out what it holds, if it fits), or entries.
    fn map_body<T>(
        &mut self,
        chosen: impl FnOnce(&Map) -> Option<BlendMap<T>>,
        mut entry: impl FnMut(&mut Self, &mut Vec<(f32, T)>) -> Result<()>,
    ) -> Result<BlendMap<T>> {
        let open = self.expect_punct(Punct::LeftBrace)?;
        if let Some(Value::Map(map)) = self.peek_value()? {
            let span = self.peek()?.span;
            let Some(map) = chosen(&map) else {
                return Err(Box::new(Diagnostic::error(span, "this is a map of another kind")));
            };
            self.take_value()?;
            self.expect_punct(Punct::RightBrace)?;
            return Ok(map);
        }
        let mut entries = Vec::new();
        while self.accept_punct(Punct::LeftBracket)? {
            entry(self, &mut entries)?;
            self.expect_punct(Punct::RightBracket)?;
        }
        self.expect_punct(Punct::RightBrace)?;
        match entries.len() {
            0 => Err(Box::new(Diagnostic::error(open.span, "a map must have at least one entry"))),
            1..=MOST_ENTRIES => Ok(BlendMap::new(entries)),
            _ => Err(Box::new(Diagnostic::error(open.span, "a map can have 256 entries at most"))),
        }
    }

    /// The number that starts an entry; in averages it may be left out.
    fn map_key(&mut self, average: bool) -> Result<f32> {
        if average && !self.at_expression()? {
            return Ok(1.0);
        }
        let key = self.float()?;
        self.comma()?;
        Ok(key as f32)
    }

    pub(super) fn color_map(&mut self) -> Result<ColorMap> {
        let chosen = |map: &Map| match map {
            Map::Colors(map) => Some(map.clone()),
            _ => None,
        };
        self.map_body(chosen, |parser, entries| parser.color_entry(entries))
    }

    /// `key, color`, or in the old way `key, key, color, color`.
    fn color_entry(&mut self, entries: &mut Vec<(f32, Color)>) -> Result<()> {
        let key = self.map_key(false)?;
        if self.at_color()? {
            entries.push((key, self.color()?));
            return Ok(());
        }
        match self.expression()? {
            Value::Float(second) => {
                self.comma()?;
                for key in [key, second as f32] {
                    if self.peek()?.tok != Tok::Word(Keyword::Color) {
                        return Err(self.unexpected("`color`"));
                    }
                    entries.push((key, self.color()?));
                }
            }
            Value::Vector(_, c) => {
                let color = self.color_parts(Color::from_components(c.map(|c| c as f32)))?;
                entries.push((key, color));
            }
            Value::Color(color) => {
                let color = self.color_parts(color)?;
                entries.push((key, color));
            }
            _ => return Err(self.unexpected("a color")),
        }
        Ok(())
    }

    /// Whether a word of colours comes.
    fn at_color(&mut self) -> Result<bool> {
        use Keyword::*;
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        Ok(matches!(word, Color | Rgb | Rgbf | Rgbt | Rgbft | Srgb | Srgbf | Srgbt | Srgbft)
            || matches!(word, Red | Green | Blue | Filter | Transmit))
    }

    /// `red f`, `filter f` and so on behind a colour.
    fn color_parts(&mut self, mut color: Color) -> Result<Color> {
        while let Tok::Word(word) = self.peek()?.tok {
            let part = match word {
                Keyword::Red => &mut color.rgb.x,
                Keyword::Green => &mut color.rgb.y,
                Keyword::Blue => &mut color.rgb.z,
                Keyword::Filter => &mut color.filter,
                Keyword::Transmit => &mut color.transmit,
                _ => break,
            };
            self.next()?;
            *part = self.float()? as f32;
        }
        Ok(color)
    }

    /// Also a density map, whose entries are densities.
    pub(super) fn pigment_map(&mut self, place: Place, average: bool) -> Result<BlendMap<Arc<Pigment>>> {
        let chosen = |map: &Map| match (map, place) {
            (Map::Pigments(map), Place::Pigment) | (Map::Densities(map), Place::Density) => Some(map.clone()),
            _ => None,
        };
        self.map_body(chosen, |parser, entries| {
            let key = parser.map_key(average)?;
            let base = parser.default_pigment(place);
            entries.push((key, Arc::new(parser.pigment_body(base, place)?)));
            Ok(())
        })
    }

    pub(super) fn normal_map(&mut self, average: bool) -> Result<BlendMap<Arc<Normal>>> {
        let chosen = |map: &Map| match map {
            Map::Normals(map) => Some(map.clone()),
            _ => None,
        };
        self.map_body(chosen, |parser, entries| {
            let key = parser.map_key(average)?;
            let (base, span) = (parser.default_normal(), parser.peek()?.span);
            let normal = parser.normal_body(base)?;
            if matches!(normal.kind, NormalKind::Flat) {
                parser.lenient(Diagnostic::warning(span, "this normal has no pattern"))?;
            }
            entries.push((key, Arc::new(normal)));
            Ok(())
        })
    }

    pub(super) fn texture_map(&mut self, average: bool) -> Result<BlendMap<Texture>> {
        let chosen = |map: &Map| match map {
            Map::Textures(map) => Some(map.clone()),
            _ => None,
        };
        self.map_body(chosen, |parser, entries| {
            let key = parser.map_key(average)?;
            entries.push((key, parser.texture_body()?));
            Ok(())
        })
    }

    pub(super) fn slope_map(&mut self) -> Result<BlendMap<(f64, f64)>> {
        let chosen = |map: &Map| match map {
            Map::Slopes(map) => Some(map.clone()),
            _ => None,
        };
        self.map_body(chosen, |parser, entries| {
            let key = parser.map_key(false)?;
            let v = parser.vector2()?;
            entries.push((key, (v.x, v.y)));
            Ok(())
        })
    }
}
