//! The other file types that POV-Ray writes.
//!
//! | type | channels | values |
//! |------|----------|--------|
//! | Targa, plain or run-length encoded, BMP | 3, or 4 with alpha | 8 bit, encoded |
//! | PPM | 3, or 1 in grey | 5 to 16 bit, encoded |
//! | JPEG | 3 | 8 bit, encoded |
//! | HDR | 3 | linear light, shared exponent |

use super::{Encoding, Picture, PictureError};
use crate::color::Gamma;
use image::codecs::{bmp::BmpEncoder, hdr::HdrEncoder, jpeg::JpegEncoder, tga::TgaEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageResult, Rgb};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Targa,
    /// Run-length encoded.
    PackedTarga,
    Ppm,
    Bmp,
    /// With the quality, 1 to 100.
    Jpeg(u8),
    Hdr,
}

/// The bytes of a file.
pub fn encode(picture: &Picture, encoding: &Encoding, kind: Kind) -> Result<Vec<u8>, PictureError> {
    let mut out = Vec::new();
    // Grey PPM files of the reference hold working values as they are.
    let plain_grey = encoding.grey && kind == Kind::Ppm;
    let e = Encoding {
        working: if plain_grey { Gamma::Unmanaged } else { encoding.working },
        bits: if kind == Kind::Ppm { encoding.bits } else { 8 },
        alpha: encoding.alpha && matches!(kind, Kind::Targa | Kind::PackedTarga | Kind::Bmp),
        grey: plain_grey,
        ..*encoding
    };
    let color = if e.alpha { ExtendedColorType::Rgba8 } else { ExtendedColorType::Rgb8 };
    let narrow = || e.samples(picture).iter().map(|&s| s as u8).collect::<Vec<u8>>();
    let (w, h) = (picture.width, picture.height);
    let result = match kind {
        Kind::Targa => TgaEncoder::new(&mut out).disable_rle().write_image(&narrow(), w, h, color),
        Kind::PackedTarga => return packed_targa(&narrow(), w, h, if e.alpha { 4 } else { 3 }),
        Kind::Bmp => BmpEncoder::new(&mut out).write_image(&narrow(), w, h, color),
        Kind::Jpeg(quality) => {
            JpegEncoder::new_with_quality(&mut out, quality).write_image(&narrow(), w, h, color)
        }
        Kind::Ppm => return Ok(ppm(&e.samples(picture), &e, w, h)),
        Kind::Hdr => hdr(picture, &e, &mut out),
    };
    match result {
        Ok(()) => Ok(out),
        Err(error) => Err(PictureError::Format { place: format!("{kind:?}"), message: error.to_string() }),
    }
}

/// Targa of type 10. A packet ends with its row: readers of the format's second version insist on it.
fn packed_targa(samples: &[u8], width: u32, height: u32, channels: usize) -> Result<Vec<u8>, PictureError> {
    let side = |n: u32| {
        let too_large = || format!("a Targa file has at most {} pixels each way", u16::MAX);
        u16::try_from(n).map(u16::to_le_bytes).map_err(|_| PictureError::Format {
            place: format!("{:?}", Kind::PackedTarga),
            message: too_large(),
        })
    };
    let mut out = vec![0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    out.extend(side(width)?);
    out.extend(side(height)?);
    // Bits of a pixel; rows from the top, and how many bits are alpha.
    out.extend([8 * channels as u8, 0x20 + if channels == 4 { 8 } else { 0 }]);
    for row in samples.chunks_exact(width as usize * channels) {
        packed_row(row, channels, &mut out);
    }
    Ok(out)
}

/// Packets of up to 128 pixels: equal ones (once, with the highest bit of the count set), or different ones.
fn packed_row(row: &[u8], channels: usize, out: &mut Vec<u8>) {
    let pixels: Vec<&[u8]> = row.chunks_exact(channels).collect();
    let equal = |at: usize| {
        let rest = &pixels[at..pixels.len().min(at + 128)];
        rest.iter().take_while(|p| **p == rest[0]).count()
    };
    let mut at = 0;
    while at < pixels.len() {
        let run = equal(at);
        let last = if run > 1 { at + run } else { pixels.len().min(at + 128) };
        let end = if run > 1 { last } else { (at + 1..last).find(|&i| equal(i) > 1).unwrap_or(last) };
        let count = (end - at - 1) as u8;
        let (head, kept) = if run > 1 { (0x80 | count, at..at + 1) } else { (count, at..end) };
        out.push(head);
        for p in &pixels[kept] {
            out.extend([p[2], p[1], p[0]]);
            out.extend(&p[3..]);
        }
        at = end;
    }
}

fn ppm(samples: &[u16], encoding: &Encoding, width: u32, height: u32) -> Vec<u8> {
    let magic = if encoding.grey { "P5" } else { "P6" };
    let mut out = format!("{magic}\n{width} {height}\n{}\n", encoding.max()).into_bytes();
    if encoding.bits > 8 {
        out.extend(samples.iter().flat_map(|s| s.to_be_bytes()));
    } else {
        out.extend(samples.iter().map(|&s| s as u8));
    }
    out
}

fn hdr(picture: &Picture, encoding: &Encoding, out: &mut Vec<u8>) -> ImageResult<()> {
    let pixels: Vec<_> = picture.pixels.iter().map(|p| Rgb(encoding.light(p.rgb).to_array())).collect();
    HdrEncoder::new(out).encode(&pixels, picture.width as usize, picture.height as usize)
}

#[cfg(test)]
mod tests {
    use super::super::Pixel;
    use super::*;
    use crate::color;

    fn sample() -> Picture {
        let mut p = Picture::new(3, 2);
        for (x, value) in [(0, 1.0), (1, 0.5), (2, 0.25)] {
            p.set(x, 0, Pixel::new(color::Rgb::splat(value), 0.0));
        }
        p
    }

    #[test]
    fn values_come_back() {
        let e = Encoding { alpha: true, ..Encoding::new(Gamma::Unmanaged) };
        for (kind, format) in [
            (Kind::Targa, image::ImageFormat::Tga),
            (Kind::PackedTarga, image::ImageFormat::Tga),
            (Kind::Bmp, image::ImageFormat::Bmp),
            (Kind::Ppm, image::ImageFormat::Pnm),
        ] {
            let bytes = encode(&sample(), &e, kind).unwrap();
            let image = image::load_from_memory_with_format(&bytes, format).unwrap().to_rgba8();
            let row: Vec<_> = (0..3).map(|x| image.get_pixel(x, 0).0[0]).collect();
            assert_eq!(row, [255, 128, 64], "{kind:?}");
            let clear = if kind == Kind::Ppm { 255 } else { 0 };
            assert_eq!(image.get_pixel(1, 1).0[3], clear, "{kind:?}");
        }
    }

    #[test]
    fn packets_end_with_their_rows() {
        let row = |v: &[u8]| {
            let mut out = Vec::new();
            packed_row(&v.iter().flat_map(|&v| [v, v, v]).collect::<Vec<_>>(), 3, &mut out);
            out
        };
        assert_eq!(row(&[7, 7, 7]), [0x82, 7, 7, 7]);
        assert_eq!(row(&[1, 2, 2]), [0, 1, 1, 1, 0x81, 2, 2, 2]);
        assert_eq!(row(&[1, 2]), [1, 1, 1, 1, 2, 2, 2]);
        assert_eq!(row(&[5; 130])[..4], [0xFF, 5, 5, 5]);
        let bytes = encode(&Picture::new(4, 2), &Encoding::new(Gamma::Unmanaged), Kind::PackedTarga).unwrap();
        assert_eq!(bytes[12..], [4, 0, 2, 0, 24, 0x20, 0x83, 0, 0, 0, 0x83, 0, 0, 0]);
    }

    #[test]
    fn ppm_may_have_other_depths_and_grey() {
        let e = Encoding { bits: 12, ..Encoding::new(Gamma::Unmanaged) };
        let bytes = encode(&sample(), &e, Kind::Ppm).unwrap();
        assert_eq!(&bytes[..12], b"P6\n3 2\n4095\n");
        assert_eq!(&bytes[12..20], &[15, 255, 15, 255, 15, 255, 8, 0]);
        let e = Encoding { grey: true, alpha: true, ..Encoding::new(Gamma::Power(1.0)) };
        assert_eq!(encode(&sample(), &e, Kind::Ppm).unwrap(), b"P5\n3 2\n255\n\xff\x80\x40\0\0\0");
    }

    #[test]
    fn light_is_kept_above_one() {
        let mut p = Picture::new(1, 1);
        p.set(0, 0, Pixel::new(color::Rgb::splat(4.0), 0.0));
        let bytes = encode(&p, &Encoding::new(Gamma::Power(1.0)), Kind::Hdr).unwrap();
        let image = image::load_from_memory(&bytes).unwrap().to_rgb32f();
        assert!((image.get_pixel(0, 0).0[0] - 4.0).abs() < 0.05);
        let jpeg = encode(&sample(), &Encoding::new(Gamma::Unmanaged), Kind::Jpeg(85)).unwrap();
        assert!(jpeg.starts_with(&[0xFF, 0xD8]));
    }
}
