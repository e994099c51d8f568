//! Image files and function images, and the maps made from them.

use crate::interp::lookup::Kind;
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result};
use crate::pattern::image::decode::{Decoded, Format, Profile, Samples};
use crate::pattern::image::{
    Curve, Image, ImageMap, ImagePattern, ImageValue, Interpolation, MapKind, Reading,
};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok};
use std::path::PathBuf;
use std::sync::Arc;

/// The statement that an image stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ImageUse {
    Colors,
    Bumps,
    Pattern,
    Materials,
}

/// A file with the way it was read, and what came of it.
pub(in crate::interp) type LoadedImage = (PathBuf, Format, Reading, Arc<Image>);

/// What image statements say besides how the image lies.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ImageSettings {
    pub bump_size: Option<f64>,
    pub use_alpha: bool,
}

impl Parser {
    /// `image_pattern { … }`; its keyword has been taken.
    pub(super) fn image_pattern(&mut self) -> Result<ImagePattern> {
        self.expect_punct(Punct::LeftBrace)?;
        let (map, settings) = self.image_with_settings(ImageUse::Pattern)?;
        self.close_block(&items::IMAGE_PATTERN)?;
        Ok(ImagePattern { map, value: if settings.use_alpha { ImageValue::Alpha } else { ImageValue::Grey } })
    }

    /// An image and its settings, inside the braces.
    pub(super) fn image_with_settings(&mut self, place: ImageUse) -> Result<(ImageMap, ImageSettings)> {
        self.old_orientation()?;
        let image = self.image(place != ImageUse::Colors)?;
        let (mut map, mut settings) = (ImageMap::new(image), ImageSettings::default());
        while self.image_setting(&mut map, &mut settings, place)? {}
        Ok((map, settings))
    }

    /// A vector in first place once gave the orientation.
    fn old_orientation(&mut self) -> Result<()> {
        let token = self.peek()?;
        if self.at_expression()? && !matches!(token.tok, Tok::String(_)) {
            self.vector()?;
            self.warn(Diagnostic::warning(token.span, "the orientation of an image is no longer used"));
        }
        Ok(())
    }

    /// An image file with `gamma` and `premultiplied`, or a function image.
    pub(crate) fn image(&mut self, raw: bool) -> Result<Arc<Image>> {
        let token = self.peek()?;
        let format = match token.tok {
            Tok::Word(Keyword::Function) => return self.image_of_function(),
            Tok::Word(Keyword::Iff) => return self.iff_image(),
            Tok::Word(Keyword::Sys) => {
                let message = "`sys` means pictures in the system's own format, and this system has none";
                let hint = "name the type of the file, such as `png` or `jpeg`";
                return Err(Box::new(Diagnostic::error(token.span, message).with_hint(hint)));
            }
            Tok::Word(word) => format_of_word(word),
            Tok::Identifier(name) if self.symbols.value(name).is_none() => {
                return Err(self.unexpected_among(token, items::IMAGE_TYPES.noun, items::IMAGE_TYPES.words));
            }
            _ => None,
        };
        if format.is_some() {
            self.next()?;
        }
        let span = self.peek()?.span;
        let name = self.file_name()?;
        let Some((format, kind)) = format.or_else(|| Format::of_name(&name).map(|f| (f, kind_of_format(f))))
        else {
            let message = "the file name has no extension that tells the kind of image";
            return Err(Box::new(Diagnostic::error(span, message)));
        };
        let (written, premultiplied) = self.image_coding()?;
        let working = self.scene.gamma_given.then_some(self.scene.scene.globals.gamma);
        let version = match working {
            Some(_) => self.effective_version(),
            None => self.version.for_images(),
        };
        let reading = Reading { raw, version, working, written, premultiplied };
        self.image_file(&name, format, kind, reading, span)
    }

    /// `gamma` and `premultiplied` behind a file's name.
    fn image_coding(&mut self) -> Result<(Option<Curve>, Option<bool>)> {
        let written = if self.accept(Keyword::Gamma)? { Some(self.curve()?) } else { None };
        let premultiplied =
            if self.accept(Keyword::Premultiplied)? { Some(self.float()? > 0.0) } else { None };
        Ok((written, premultiplied))
    }

    /// `iff "file"`, whose format is not decoded: a small black picture stands for it. It has a full palette, as the
    /// format's pictures have, so that every setting fits.
    fn iff_image(&mut self) -> Result<Arc<Image>> {
        let span = self.next()?.span;
        self.file_name()?;
        self.image_coding()?;
        self.unsupported(span.to(self.last), "an image of type `iff`");
        let black = vec![[0, 0, 0, u16::MAX]; 256];
        let samples = Samples::Palette { indices: vec![0; 4], palette: black, alpha: false };
        let decoded = Decoded { width: 2, height: 2, samples, profile: Profile::Unknown };
        Ok(Arc::new(Image::new(decoded, &Reading::RAW)))
    }

    fn curve(&mut self) -> Result<Curve> {
        if self.accept(Keyword::Srgb)? {
            return Ok(Curve::Srgb);
        }
        let token = self.peek()?;
        let gamma = self.float()?;
        if gamma > 0.0 {
            return Ok(Curve::Power(gamma));
        }
        Err(Box::new(Diagnostic::error(token.span, "gamma must be above 0")))
    }

    /// Reads a file, unless it has been read in the same way before.
    fn image_file(
        &mut self,
        name: &str,
        format: Format,
        kind: Kind,
        reading: Reading,
        span: Span,
    ) -> Result<Arc<Image>> {
        let path = self.require_file(name, kind, span)?;
        let seen = self.images.iter().find(|(p, f, r, _)| *p == path && *f == format && *r == reading);
        if let Some((.., image)) = seen {
            return Ok(image.clone());
        }
        let failed =
            |e: String| Box::new(Diagnostic::error(span, format!("cannot read the image `{name}`: {e}")));
        let bytes = std::fs::read(&path).map_err(|e| failed(e.to_string()))?;
        let image = Arc::new(Image::new(format.decode(&bytes).map_err(failed)?, &reading));
        self.images.push((path, format, reading, image.clone()));
        Ok(image)
    }

    /// Function images hold values as they are used.
    fn image_of_function(&mut self) -> Result<Arc<Image>> {
        let function = self.function_image()?;
        let (channels, data) = match function.is_color() {
            true => (4, function.colors().concat()),
            false => (1, function.greys()),
        };
        self.check_functions()?;
        let samples = Samples::Words { channels, data, max: u16::MAX };
        let (width, height) = (function.width as usize, function.height as usize);
        Ok(Arc::new(Image::new(Decoded { width, height, samples, profile: Profile::Unknown }, &Reading::RAW)))
    }

    fn image_setting(
        &mut self,
        map: &mut ImageMap,
        settings: &mut ImageSettings,
        place: ImageUse,
    ) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        match word {
            Keyword::Once => {
                self.next()?;
                map.placement.once = true;
            }
            Keyword::MapType => map.placement.kind = self.map_type(place)?,
            Keyword::Interpolate => map.placement.interpolation = self.interpolation(place)?,
            Keyword::Repeat => {
                self.next()?;
                map.placement.repeat = self.vector2()?;
                if map.placement.repeat.min_element() <= 0.0 {
                    return Err(Box::new(Diagnostic::error(
                        token.span,
                        "`repeat` must be above 0 both ways",
                    )));
                }
            }
            Keyword::Offset => map.placement.offset = self.next().and_then(|_| self.vector2())?,
            Keyword::UseColor | Keyword::UseIndex => {
                self.next()?;
                map.use_index = word == Keyword::UseIndex;
            }
            Keyword::UseAlpha if place == ImageUse::Pattern => {
                self.next()?;
                settings.use_alpha = true;
            }
            Keyword::BumpSize if place == ImageUse::Bumps => {
                self.next()?;
                settings.bump_size = Some(self.single()?);
            }
            Keyword::Filter | Keyword::Transmit if place == ImageUse::Colors => {
                self.image_transparency(map)?
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn map_type(&mut self, place: ImageUse) -> Result<MapKind> {
        self.next()?;
        let token = self.peek()?;
        match self.float()? as i64 {
            0 => Ok(MapKind::Planar),
            1 => Ok(MapKind::Spherical),
            2 => Ok(MapKind::Cylindrical),
            5 => Ok(MapKind::Toroidal),
            _ if place != ImageUse::Colors => Ok(MapKind::Planar),
            _ => Err(Box::new(Diagnostic::error(token.span, "the types of maps are 0, 1, 2 and 5"))),
        }
    }

    fn interpolation(&mut self, place: ImageUse) -> Result<Interpolation> {
        self.next()?;
        let token = self.peek()?;
        match self.float()? as i64 {
            2 => Ok(Interpolation::Bilinear),
            3 => Ok(Interpolation::Bicubic),
            4 => Ok(Interpolation::Distance),
            _ if place != ImageUse::Colors => Ok(Interpolation::None),
            _ => Err(Box::new(Diagnostic::error(token.span, "the interpolations are 2, 3 and 4"))),
        }
    }

    /// `filter` or `transmit`, with `all f` or with a palette index and a number.
    fn image_transparency(&mut self, map: &mut ImageMap) -> Result<()> {
        let word = self.next()?;
        let filter = word.tok == Tok::Word(Keyword::Filter);
        if self.accept(Keyword::All)? {
            let value = self.float()? as f32;
            let place = if filter { &mut map.filter } else { &mut map.transmit };
            *place = value;
            for color in &mut map.palette {
                *(if filter { &mut color.filter } else { &mut color.transmit }) = value;
            }
            return Ok(());
        }
        let index = self.float()?.trunc();
        self.comma()?;
        let value = self.float()? as f32;
        if map.palette.is_empty() {
            let message = "only images with a palette have numbered colors; use `all`";
            return Err(Box::new(Diagnostic::error(word.span, message)));
        }
        let color = if index >= 0.0 { map.palette.get_mut(index as usize) } else { None };
        let Some(color) = color else {
            return Err(Box::new(Diagnostic::error(word.span, "the palette has no color of this number")));
        };
        *(if filter { &mut color.filter } else { &mut color.transmit }) = value;
        Ok(())
    }
}

fn format_of_word(word: Keyword) -> Option<(Format, Kind)> {
    Some(match word {
        Keyword::Png => (Format::Png, Kind::Png),
        Keyword::Jpeg => (Format::Jpeg, Kind::Jpeg),
        Keyword::Gif => (Format::Gif, Kind::Gif),
        Keyword::Tga => (Format::Tga, Kind::Tga),
        Keyword::Bmp => (Format::Bmp, Kind::Bmp),
        Keyword::Pgm => (Format::Pnm, Kind::Pgm),
        Keyword::Ppm => (Format::Pnm, Kind::Ppm),
        Keyword::Tiff => (Format::Tiff, Kind::Tiff),
        Keyword::Hdr => (Format::Hdr, Kind::Hdr),
        Keyword::Exr => (Format::Exr, Kind::Exr),
        _ => return None,
    })
}

fn kind_of_format(format: Format) -> Kind {
    match format {
        Format::Png => Kind::Png,
        Format::Jpeg => Kind::Jpeg,
        Format::Gif => Kind::Gif,
        Format::Tga => Kind::Tga,
        Format::Bmp => Kind::Bmp,
        Format::Pnm => Kind::Ppm,
        Format::Tiff => Kind::Tiff,
        Format::Hdr => Kind::Hdr,
        Format::Exr => Kind::Exr,
    }
}
