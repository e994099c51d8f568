//! Image files to samples. Formats whose quirks the language shows have decoders of their own here.

mod bmp;
mod exr;
mod gif;
mod hdr;
mod jpeg;
mod png;
mod pnm;
mod tga;
mod tiff;

use super::Curve;

/// A decoded file: rows from the top.
#[derive(Debug)]
pub struct Decoded {
    pub width: usize,
    pub height: usize,
    pub samples: Samples,
    pub profile: Profile,
}

#[derive(Debug)]
pub enum Samples {
    /// Red, green, blue, alpha of each entry.
    Palette {
        indices: Vec<u8>,
        palette: Vec<[u16; 4]>,
        /// Whether files of the kind can have transparent colours.
        alpha: bool,
    },
    /// 1 to 4 channels: grey, grey and alpha, RGB, RGB and alpha.
    Bytes {
        channels: usize,
        data: Vec<u8>,
        /// Grey levels are cut to whole numbers after decoding.
        truncated_grey: bool,
    },
    Words {
        channels: usize,
        data: Vec<u16>,
        max: u16,
    },
    Floats {
        channels: usize,
        data: Vec<f32>,
        premultiplied: bool,
        /// Whether grey values are those of the multiplied colours all the same.
        dim: bool,
    },
}

/// What a file, or its format, says about its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Profile {
    /// The file names its curve.
    Curve(Curve),
    /// Values are light.
    Light,
    /// Nothing is said, and sRGB is likely.
    PerhapsSrgb,
    /// Nothing is said.
    Unknown,
}

/// The formats that scenes name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    Png,
    Jpeg,
    Gif,
    Tga,
    Bmp,
    /// PGM and PPM.
    Pnm,
    Tiff,
    Hdr,
    Exr,
}

impl Format {
    /// The format of a file name's extension.
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, extension) = name.rsplit_once('.')?;
        Some(match extension.to_ascii_lowercase().as_str() {
            "png" => Format::Png,
            "jpg" | "jpeg" => Format::Jpeg,
            "gif" => Format::Gif,
            "tga" => Format::Tga,
            "bmp" => Format::Bmp,
            "pgm" | "ppm" | "pnm" => Format::Pnm,
            "tif" | "tiff" => Format::Tiff,
            "hdr" => Format::Hdr,
            "exr" => Format::Exr,
            _ => return None,
        })
    }

    /// Decodes the contents of a file, or says what is wrong with it.
    pub fn decode(self, bytes: &[u8]) -> Result<Decoded, String> {
        let decoded = match self {
            Format::Png => png::decode(bytes),
            Format::Jpeg => jpeg::decode(bytes),
            Format::Gif => gif::decode(bytes),
            Format::Tga => tga::decode(bytes),
            Format::Bmp => bmp::decode(bytes),
            Format::Pnm => pnm::decode(bytes),
            Format::Tiff => tiff::decode(bytes),
            Format::Hdr => hdr::decode(bytes),
            Format::Exr => exr::decode(bytes),
        }?;
        match decoded.width.min(decoded.height) {
            0 => Err("the image is empty".to_owned()),
            _ => Ok(decoded),
        }
    }
}

/// Colours of bytes as ones of 16 bits.
fn widened(palette: Vec<[u8; 4]>) -> Vec<[u16; 4]> {
    palette.into_iter().map(|color| color.map(|v| u16::from(v) * 257)).collect()
}

/// More pixels than this are refused.
const MOST_PIXELS: usize = 1 << 28;

/// Number of pixels, if that many are allowed.
fn area(width: usize, height: usize) -> Result<usize, String> {
    match width.checked_mul(height) {
        Some(n) if n <= MOST_PIXELS => Ok(n),
        _ => Err(format!("{width} x {height} pixels are too many")),
    }
}

/// Reads binary files from the front; the end of the file is an error.
struct Bytes<'a> {
    rest: &'a [u8],
}

impl<'a> Bytes<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    fn take(&mut self, n: usize) -> Result<&'a [u8], String> {
        let (taken, rest) = self.rest.split_at_checked(n).ok_or("the file ends too early")?;
        self.rest = rest;
        Ok(taken)
    }

    fn byte(&mut self) -> Result<u8, String> {
        Ok(self.take(1)?[0])
    }

    /// Little-endian.
    fn short(&mut self) -> Result<u16, String> {
        let b = self.take(2)?;
        Ok(u16::from_le_bytes([b[0], b[1]]))
    }

    /// Little-endian.
    fn long(&mut self) -> Result<u32, String> {
        let b = self.take(4)?;
        Ok(u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
    }
}
