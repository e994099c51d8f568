//! Images as the patterns and maps of surfaces use them.

pub mod decode;
mod map;
mod pattern;
mod transfer;

pub use map::{ImageMap, Interpolation, MapKind, OUTSIDE, Placement};
pub use pattern::{ImagePattern, ImageValue};
pub use transfer::{Curve, Reading};

use crate::color::Rgb;
use decode::{Decoded, Samples};

/// A picture in memory, its values as they are used.
#[derive(Debug)]
pub struct Image {
    pub width: usize,
    pub height: usize,
    texels: Texels,
    /// Whether colours are stored multiplied by alpha.
    pub premultiplied: bool,
    /// Whether grey values are multiplied by alpha though colours are not.
    dim: bool,
}

#[derive(Debug)]
enum Texels {
    Palette {
        indices: Vec<u8>,
        palette: Vec<Texel>,
        alpha: bool,
    },
    /// 1 to 4 bytes each: grey, grey and alpha, RGB, RGB and alpha.
    Bytes {
        channels: usize,
        data: Vec<u8>,
        curve: Box<[f32; 256]>,
    },
    Floats(Vec<Texel>),
}

/// How a picture's values are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    Palette,
    /// One byte for each of 1 to 4 channels.
    Bytes {
        channels: usize,
    },
    /// More than a byte for each channel.
    Deep,
}

/// Colour and alpha of one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texel {
    pub rgb: Rgb,
    pub alpha: f32,
}

impl Image {
    /// Gives a decoded file the meaning that `reading` finds in its values.
    pub fn new(decoded: Decoded, reading: &Reading) -> Self {
        let transfer = reading.transfer(decoded.profile);
        let (width, height) = (decoded.width, decoded.height);
        let (mut premultiplied, mut dim) = (false, false);
        let texels = match decoded.samples {
            Samples::Palette { indices, palette, alpha } => {
                let level = |v: u16| transfer.value(f64::from(v) / 65535.0);
                let color = |c: [u16; 4]| Texel {
                    rgb: Rgb::new(level(c[0]), level(c[1]), level(c[2])),
                    alpha: f32::from(c[3]) / 65535.0,
                };
                Texels::Palette { indices, palette: palette.into_iter().map(color).collect(), alpha }
            }
            Samples::Bytes { channels, data, truncated_grey } => {
                let level = |v: usize| transfer.value(v as f64 / 255.0);
                let curve =
                    std::array::from_fn(|v| if truncated_grey { truncated(level(v)) } else { level(v) });
                Texels::Bytes { channels, data, curve: Box::new(curve) }
            }
            Samples::Words { channels, data, max } => {
                let level = |v: u16| transfer.value(f64::from(v) / f64::from(max));
                let alpha = |v: u16| f32::from(v) / f32::from(max);
                Texels::Floats(data.chunks_exact(channels).map(|c| texel(c, level, alpha)).collect())
            }
            Samples::Floats { channels, data, premultiplied: multiplied, dim: is_dim } => {
                (premultiplied, dim) = (multiplied, is_dim);
                let level = |v: f32| transfer.value(f64::from(v));
                Texels::Floats(data.chunks_exact(channels).map(|c| texel(c, level, |a| a)).collect())
            }
        };
        let premultiplied = reading.premultiplied.unwrap_or(premultiplied);
        Self { width, height, texels, premultiplied, dim }
    }

    /// The texel in a column and a row, row 0 at the top; both must lie inside.
    #[inline]
    pub fn texel(&self, x: usize, y: usize) -> Texel {
        let i = y * self.width + x;
        match &self.texels {
            Texels::Palette { indices, palette, .. } => {
                palette.get(usize::from(indices[i])).copied().unwrap_or(Texel { rgb: Rgb::ZERO, alpha: 1.0 })
            }
            Texels::Bytes { channels, data, curve } => {
                let c = &data[i * channels..(i + 1) * channels];
                texel(c, |v| curve[usize::from(v)], |a| f32::from(a) / 255.0)
            }
            Texels::Floats(texels) => texels[i],
        }
    }

    pub fn storage(&self) -> Storage {
        match &self.texels {
            Texels::Palette { .. } => Storage::Palette,
            Texels::Bytes { channels, .. } => Storage::Bytes { channels: *channels },
            Texels::Floats(_) => Storage::Deep,
        }
    }

    /// The palette index of a texel; `None` if the image has no palette.
    #[inline]
    pub fn index(&self, x: usize, y: usize) -> Option<u8> {
        match &self.texels {
            Texels::Palette { indices, .. } => Some(indices[y * self.width + x]),
            _ => None,
        }
    }

    pub fn palette(&self) -> Option<&[Texel]> {
        match &self.texels {
            Texels::Palette { palette, .. } => Some(palette),
            _ => None,
        }
    }

    /// Whether there is room for transparency beside the colours.
    pub fn has_alpha(&self) -> bool {
        match &self.texels {
            Texels::Palette { palette, alpha, .. } => *alpha || palette.iter().any(|c| c.alpha != 1.0),
            Texels::Bytes { channels, .. } => channels % 2 == 0,
            Texels::Floats(texels) => texels.iter().any(|c| c.alpha != 1.0),
        }
    }

    /// Whether no texel lets light through.
    pub fn is_opaque(&self) -> bool {
        match &self.texels {
            Texels::Palette { palette, .. } => palette.iter().all(|c| c.alpha == 1.0),
            Texels::Bytes { channels, data, .. } => {
                channels % 2 == 1 || data.chunks_exact(*channels).all(|c| c[channels - 1] == 255)
            }
            Texels::Floats(texels) => texels.iter().all(|c| c.alpha == 1.0),
        }
    }
}

/// Grey, grey and alpha, RGB, or RGB and alpha.
#[inline]
fn texel<T: Copy>(c: &[T], level: impl Fn(T) -> f32, alpha: impl Fn(T) -> f32) -> Texel {
    match *c {
        [v] => Texel { rgb: Rgb::splat(level(v)), alpha: 1.0 },
        [v, a] => Texel { rgb: Rgb::splat(level(v)), alpha: alpha(a) },
        [r, g, b] => Texel { rgb: Rgb::new(level(r), level(g), level(b)), alpha: 1.0 },
        [r, g, b, a, ..] => Texel { rgb: Rgb::new(level(r), level(g), level(b)), alpha: alpha(a) },
        [] => Texel { rgb: Rgb::ZERO, alpha: 1.0 },
    }
}

/// What the language makes of a grey level of an 8-bit file: weighted as a colour and cut to a whole level.
fn truncated(level: f32) -> f32 {
    let grey = level * 0.297 + level * 0.589 + level * 0.114;
    (grey * 255.0).trunc() / 255.0
}
