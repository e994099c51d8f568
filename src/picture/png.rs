//! PNG files of 8 and 16 bits a channel, with the chunks that say what the values mean.
//!
//! Values are always marked as sRGB (or with the gamma asked for), also those of scenes without gamma
//! handling: that is how a viewer shows them.

use super::{Encoding, FileGamma, Picture, PictureError};
use ::png::{BitDepth, ColorType, Compression, Encoder, ScaledFloat, SrgbRenderingIntent};

/// The bytes of a PNG file.
pub fn encode(picture: &Picture, encoding: &Encoding) -> Result<Vec<u8>, PictureError> {
    let color = match (encoding.grey, encoding.alpha) {
        (false, false) => ColorType::Rgb,
        (false, true) => ColorType::Rgba,
        (true, false) => ColorType::Grayscale,
        (true, true) => ColorType::GrayscaleAlpha,
    };
    let bytes = bytes(picture, encoding);
    let mut out = Vec::with_capacity(bytes.len() / 2 + 1024);
    let mut encoder = Encoder::new(&mut out, picture.width, picture.height);
    encoder.set_color(color);
    encoder.set_depth(if encoding.bits > 8 { BitDepth::Sixteen } else { BitDepth::Eight });
    encoder.set_compression(Compression::Fast);
    match encoding.file {
        FileGamma::Srgb => encoder.set_source_srgb(SrgbRenderingIntent::Perceptual),
        FileGamma::Power(g) => encoder.set_source_gamma(ScaledFloat::new((1.0 / g) as f32)),
    }
    let result =
        encoder.write_header().and_then(|mut w| w.write_image_data(&bytes).and_then(|()| w.finish()));
    match result {
        Ok(()) => Ok(out),
        Err(error) => Err(PictureError::Format { place: "PNG".into(), message: error.to_string() }),
    }
}

/// The samples as the file has them before it is compressed.
fn bytes(picture: &Picture, encoding: &Encoding) -> Vec<u8> {
    let bits = encoding.bits;
    let mut out = Vec::with_capacity(picture.pixels.len() * if bits > 8 { 8 } else { 4 });
    match bits {
        8 => encoding.each(picture, |samples| out.extend(samples.iter().map(|&s| s as u8))),
        0..8 => encoding.each(picture, |samples| out.extend(samples.iter().map(|&s| narrow(s, bits)))),
        _ => encoding.each(picture, |samples| out.extend(samples.iter().flat_map(|&s| wide(s, bits)))),
    }
    out
}

/// A big-endian 16-bit sample; the high bits of a narrower value are repeated below.
fn wide(s: u16, bits: u8) -> [u8; 2] {
    let filled = if bits == 16 { s } else { s << (16 - bits) | s >> (2 * bits - 16) };
    filled.to_be_bytes()
}

/// An 8-bit sample; the high bits of the narrower value are repeated below.
fn narrow(s: u16, bits: u8) -> u8 {
    (s << (8 - bits) | s >> (2 * bits - 8)) as u8
}

#[cfg(test)]
mod tests {
    use super::super::Pixel;
    use super::*;
    use crate::color::{Gamma, Rgb};

    fn decoded(bytes: &[u8]) -> (::png::OutputInfo, Vec<u8>, bool) {
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut data).unwrap();
        let srgb = reader.info().srgb.is_some();
        (info, data, srgb)
    }

    fn sample() -> Picture {
        let mut p = Picture::new(3, 2);
        p.set(0, 0, Pixel::new(Rgb::new(1.0, 0.5, 0.0), 0.0));
        p.set(2, 1, Pixel::new(Rgb::splat(0.25), 0.0));
        p
    }

    #[test]
    fn eight_bits_come_back() {
        let bytes = encode(&sample(), &Encoding::new(Gamma::Unmanaged)).unwrap();
        let (info, data, srgb) = decoded(&bytes);
        assert_eq!((info.width, info.height, info.color_type), (3, 2, ColorType::Rgb));
        assert_eq!((&data[..3], &data[15..]), (&[255, 128, 0][..], &[64, 64, 64][..]));
        assert!(srgb);
    }

    #[test]
    fn sixteen_bits_and_alpha_come_back() {
        let e = Encoding { bits: 16, alpha: true, ..Encoding::new(Gamma::Unmanaged) };
        let (info, data, _) = decoded(&encode(&sample(), &e).unwrap());
        assert_eq!((info.color_type, info.bit_depth), (ColorType::Rgba, BitDepth::Sixteen));
        assert_eq!(&data[..8], &[255, 255, 128, 0, 0, 0, 255, 255]);
        assert_eq!(&data[8..16], &[0; 8], "a pixel without a ray is clear");
    }

    #[test]
    fn odd_depths_repeat_their_high_bits() {
        assert_eq!([0xFFF, 0x801].map(|s| wide(s, 12)), [[0xFF, 0xFF], [0x80, 0x18]]);
        assert_eq!([31, 16, 0].map(|s| narrow(s, 5)), [255, 132, 0]);
    }
}
