//! `height_field { image settings }`.

use super::object::from_shape;
use crate::color::grey;
use crate::interp::{FileKind, Parser, Result};
use crate::pattern::image::decode::{Format, Samples};
use crate::pattern::image::{Image, Storage};
use crate::scene::Object;
use crate::shape::HeightField;
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Tok, Token};

/// Heights row by row from the top of a picture.
struct Heights {
    width: usize,
    height: usize,
    samples: Vec<u16>,
}

impl Parser {
    pub(super) fn height_field(&mut self, keyword: Token) -> Result<Object> {
        let heights = self.heights()?;
        let (mut smooth, mut water_level) = (false, 0.0);
        loop {
            if self.accept(Keyword::Smooth)? {
                smooth = true;
            } else if self.accept(Keyword::WaterLevel)? {
                water_level = self.float()?;
            } else {
                break;
            }
        }
        let Heights { width, height, samples } = heights;
        // The picture's bottom row lies at z = 0.
        let rows = samples.chunks_exact(width).rev().flatten().copied().collect();
        match HeightField::new(width, height, rows, smooth, water_level) {
            Some(field) => Ok(from_shape(field)),
            None => Ok(self.degenerate(keyword.span, "height_field", "it needs at least 2 by 2 samples")),
        }
    }

    fn heights(&mut self) -> Result<Heights> {
        match self.peek()?.tok {
            Tok::Word(Keyword::Function) => {
                let function = self.function_image()?;
                let (width, height) = (function.width as usize, function.height as usize);
                let samples = function.greys();
                self.check_functions()?;
                Ok(Heights { width, height, samples })
            }
            Tok::Word(Keyword::Pot) => self.pot_heights(),
            _ => {
                let image = self.image(true)?;
                let (width, height) = (image.width, image.height);
                let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
                let samples = places.map(|(x, y)| height_of(&image, x, y)).collect();
                Ok(Heights { width, height, samples })
            }
        }
    }

    /// `pot "file"`: a GIF file whose right half holds the low bytes of the left half's heights.
    fn pot_heights(&mut self) -> Result<Heights> {
        self.next()?;
        let span = self.peek()?.span;
        let name = self.file_name()?;
        let path = self.require_file(&name, FileKind::Pot, span)?;
        let failed = |e: String| Box::new(Diagnostic::error(span, format!("cannot read `{name}`: {e}")));
        let bytes = std::fs::read(&path).map_err(|e| failed(e.to_string()))?;
        let decoded = Format::Gif.decode(&bytes).map_err(failed)?;
        let Samples::Palette { indices, .. } = decoded.samples else {
            return Err(failed("it has no palette".to_owned()));
        };
        let width = decoded.width / 2;
        let row = |row: &[u8]| -> Vec<u16> {
            (0..width).map(|x| u16::from_be_bytes([row[x], row[x + width]])).collect()
        };
        let samples = indices.chunks_exact(decoded.width).flat_map(row).collect();
        Ok(Heights { width, height: decoded.height, samples })
    }
}

/// What a pixel means as a height. Of two bytes red is the high one and green the low one.
fn height_of(image: &Image, x: usize, y: usize) -> u16 {
    if let Some(index) = image.index(x, y) {
        return 256 * u16::from(index);
    }
    let c = image.texel(x, y).rgb;
    match image.storage() {
        Storage::Bytes { channels: 1 | 2 } => 257 * (c.x * 255.0).round() as u16,
        Storage::Bytes { .. } => ((256.0 * f64::from(c.x) + f64::from(c.y)) * 255.0 + ROUNDING) as u16,
        _ if c.x == c.y && c.x == c.z => (f64::from(c.x) * 65535.0 + ROUNDING) as u16,
        _ => (65535.0 * grey(c)) as u16,
    }
}

/// Single precision values of whole levels may lie this much below them.
const ROUNDING: f64 = 1e-2;
