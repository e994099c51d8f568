//! Pictures from files, as values that can be compared.

use super::PictureError;
use crate::color::srgb_from_linear;
use std::path::Path;

/// File values of a picture in steps of 1/255, not rounded: 16-bit files keep their fractions.
/// Colours are premultiplied by alpha, so that what is hidden does not count.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    pub width: u32,
    pub height: u32,
    /// Red, green, blue and alpha, each 0 to 255.
    pub pixels: Vec<[f32; 4]>,
}

impl Values {
    /// Whether anything shows through.
    pub fn has_alpha(&self) -> bool {
        self.pixels.iter().any(|p| p[3] < 255.0)
    }
}

/// Reads a picture of any format that the program knows. EXR light becomes sRGB values.
pub fn load(path: &Path) -> Result<Values, PictureError> {
    let place = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| PictureError::Io { place: place.clone(), error })?;
    from_bytes(&bytes).map_err(|message| PictureError::Format { place, message })
}

/// The same from the bytes of a file.
pub fn from_bytes(bytes: &[u8]) -> Result<Values, String> {
    const EXR_MAGIC: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];
    if bytes.starts_with(&EXR_MAGIC) {
        let ((width, height), channels) = exr_channels(bytes)?;
        let value = |c: f32| (srgb_from_linear(f64::from(c)).clamp(0.0, 1.0) * 255.0) as f32;
        let pixels =
            channels.iter().map(|c| [value(c[0]), value(c[1]), value(c[2]), c[3].clamp(0.0, 1.0) * 255.0]);
        return Ok(Values { width, height, pixels: pixels.collect() });
    }
    let image = image::load_from_memory(bytes).map_err(|e| e.to_string())?;
    let wide = image.to_rgba16();
    let pixel = |p: &image::Rgba<u16>| {
        let [r, g, b, a] = p.0.map(|c| f32::from(c) / 257.0);
        if p.0[3] == u16::MAX { [r, g, b, a] } else { [r * a / 255.0, g * a / 255.0, b * a / 255.0, a] }
    };
    Ok(Values { width: wide.width(), height: wide.height(), pixels: wide.pixels().map(pixel).collect() })
}

/// Width and height of a picture file, if it is one.
pub fn size(path: &Path) -> Option<(u32, u32)> {
    if path.extension().is_some_and(|e| e == "exr") {
        let meta = ::exr::meta::MetaData::read_from_file(path, false).ok()?;
        let size = meta.headers.first()?.layer_size;
        return Some((size.0 as u32, size.1 as u32));
    }
    image::ImageReader::open(path).ok()?.into_dimensions().ok()
}

/// Width and height, and the channels red, green, blue and alpha row by row.
type Channels = ((u32, u32), Vec<[f32; 4]>);

/// The linear channels of an EXR file.
pub fn exr_channels(bytes: &[u8]) -> Result<Channels, String> {
    use ::exr::prelude::*;
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, _| (size.0, vec![[0.0f32; 4]; size.0 * size.1]),
            |(width, pixels), at, (r, g, b, a): (f32, f32, f32, f32)| {
                pixels[at.y() * *width + at.x()] = [r, g, b, a]
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(std::io::Cursor::new(bytes))
        .map_err(|e| e.to_string())?;
    let size = image.layer_data.size;
    Ok(((size.0 as u32, size.1 as u32), image.layer_data.channel_data.pixels.1))
}

#[cfg(test)]
mod tests {
    use super::super::{Encoding, Picture, Pixel, png};
    use super::*;
    use crate::color::{Gamma, Rgb};

    #[test]
    fn eight_bit_values_are_whole_numbers() {
        let mut p = Picture::new(256, 1);
        for i in 0..256 {
            p.set(i, 0, Pixel::new(Rgb::splat(i as f32 / 255.0), 0.0));
        }
        let values = from_bytes(&png::encode(&p, &Encoding::new(Gamma::Unmanaged)).unwrap()).unwrap();
        for (i, v) in values.pixels.iter().enumerate() {
            assert_eq!(*v, [i as f32, i as f32, i as f32, 255.0]);
        }
        assert!(!values.has_alpha());
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        assert!(from_bytes(b"not a picture").is_err());
        assert!(from_bytes(&[0x76, 0x2f, 0x31, 0x01, 0, 0]).is_err());
    }
}
