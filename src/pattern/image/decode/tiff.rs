//! TIFF. Samples of 16 bits are reduced to 8, colours of palettes are not. Alpha is taken to have been multiplied
//! into the colours; colours without it count as opaque, as if the file said so.

use super::{Decoded, Profile, Samples, area};
use image::{DynamicImage, ImageFormat};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    if let Some((as_grey, palette)) = without_palette(bytes) {
        let image = image::load_from_memory_with_format(&as_grey, ImageFormat::Tiff);
        let image = image.map_err(|e| e.to_string())?.into_luma8();
        let (width, height) = (image.width() as usize, image.height() as usize);
        area(width, height)?;
        let samples = Samples::Palette { indices: image.into_raw(), palette, alpha: false };
        return Ok(Decoded { width, height, samples, profile: Profile::Unknown });
    }
    let image = image::load_from_memory_with_format(bytes, ImageFormat::Tiff).map_err(|e| e.to_string())?;
    let (width, height) = (image.width() as usize, image.height() as usize);
    area(width, height)?;
    let (channels, data) = match image {
        DynamicImage::ImageLuma8(image) => (1, image.into_raw()),
        DynamicImage::ImageLuma16(image) => (1, image.into_raw().into_iter().map(reduced).collect()),
        DynamicImage::ImageRgb16(image) => (3, image.into_raw().into_iter().map(reduced).collect()),
        DynamicImage::ImageRgba16(image) => (4, image.into_raw().into_iter().map(reduced).collect()),
        image if image.color().has_alpha() => (4, image.into_rgba8().into_raw()),
        image => (3, image.into_rgb8().into_raw()),
    };
    let samples = match channels {
        4 if data.chunks_exact(4).all(|c| c[3] == 255) => {
            Samples::Bytes { channels, data, truncated_grey: false }
        }
        4 => Samples::Floats {
            channels,
            data: data.chunks_exact(4).flat_map(separated).collect(),
            premultiplied: false,
            dim: true,
        },
        _ => {
            let data = data.chunks_exact(channels).flat_map(|c| c.iter().copied().chain([255])).collect();
            Samples::Bytes { channels: channels + 1, data, truncated_grey: false }
        }
    };
    Ok(Decoded { width, height, samples, profile: Profile::Unknown })
}

/// A file of palette indices as one of grey values, which are the indices, and its palette; `None` for other files.
fn without_palette(bytes: &[u8]) -> Option<(Vec<u8>, Vec<[u16; 4]>)> {
    let big_endian = match bytes.get(..4)? {
        b"II*\0" => false,
        b"MM\0*" => true,
        _ => return None,
    };
    let short = |at: usize| {
        let pair = bytes.get(at..at.checked_add(2)?)?.try_into().ok()?;
        Some(if big_endian { u16::from_be_bytes(pair) } else { u16::from_le_bytes(pair) })
    };
    let long = |at: usize| {
        let four = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
        Some(if big_endian { u32::from_be_bytes(four) } else { u32::from_le_bytes(four) } as usize)
    };
    let directory = long(4)?;
    let entries = usize::from(short(directory)?);
    let entry = |tag: u16| (0..entries).map(|i| directory + 2 + 12 * i).find(|&at| short(at) == Some(tag));
    let (bits, meaning, colors) = (entry(258)?, entry(262)?, entry(320)?);
    if short(meaning + 8)? != 3 || short(bits + 8)? != 8 || long(colors + 4)? != 3 * 256 {
        return None;
    }
    let table = long(colors + 8)?;
    let level = |channel: usize, i: usize| short(table.checked_add(2 * (256 * channel + i))?);
    let palette = (0..256)
        .map(|i| Some([level(0, i)?, level(1, i)?, level(2, i)?, u16::MAX]))
        .collect::<Option<_>>()?;
    let mut as_grey = bytes.to_vec();
    // Grey values, black is 0.
    as_grey[meaning + 8..meaning + 10].copy_from_slice(if big_endian { &[0, 1] } else { &[1, 0] });
    Some((as_grey, palette))
}

fn reduced(v: u16) -> u8 {
    (v >> 8) as u8
}

/// Multiplied by alpha in whole steps, then divided again.
fn separated(c: &[u8]) -> [f32; 4] {
    let alpha = f32::from(c[3]);
    let channel = |v: u8| match c[3] {
        0 => 0.0,
        _ => (f32::from(v) * alpha / 255.0).round() / alpha,
    };
    [channel(c[0]), channel(c[1]), channel(c[2]), alpha / 255.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two pixels of a palette, in either byte order.
    fn file(big_endian: bool) -> Vec<u8> {
        let short = |v: u16| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() };
        let long = |v: u32| if big_endian { v.to_be_bytes() } else { v.to_le_bytes() };
        let mut out = if big_endian { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
        out.extend(long(12));
        out.extend([5, 9, 0, 0]);
        let fields = [
            (256, 3, 1, 2),
            (257, 3, 1, 1),
            (258, 3, 1, 8),
            (259, 3, 1, 1),
            (262, 3, 1, 3),
            (273, 4, 1, 8),
            (277, 3, 1, 1),
            (278, 3, 1, 1),
            (279, 4, 1, 2),
            (320, 3, 768, 12 + 2 + 10 * 12 + 4),
        ];
        out.extend(short(fields.len() as u16));
        for (tag, kind, count, value) in fields {
            out.extend(short(tag));
            out.extend(short(kind));
            out.extend(long(count));
            match (kind, count) {
                (3, 1) => out.extend([short(value as u16), [0, 0]].concat()),
                _ => out.extend(long(value)),
            }
        }
        out.extend(long(0));
        for channel in 0..3u16 {
            out.extend((0..256u16).flat_map(|i| short(i * 256 + channel)));
        }
        out
    }

    #[test]
    fn palettes_are_read() {
        for big_endian in [false, true] {
            let decoded = decode(&file(big_endian)).unwrap();
            assert_eq!((decoded.width, decoded.height), (2, 1));
            let Samples::Palette { indices, palette, .. } = decoded.samples else { panic!("no palette") };
            assert_eq!((indices, palette[9]), (vec![5, 9], [9 * 256, 9 * 256 + 1, 9 * 256 + 2, u16::MAX]));
        }
        // A table that is not all there.
        assert!(decode(&file(true)[..900]).is_err());
    }
}
