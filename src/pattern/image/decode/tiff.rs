//! TIFF. Samples of 16 bits are reduced to 8, and alpha is taken to have been multiplied into the colours; colours
//! without it count as opaque, as if the file said so.

use super::{Decoded, Profile, Samples, area};
use image::{DynamicImage, ImageFormat};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
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
        4 => Samples::Floats {
            channels,
            data: data.chunks_exact(4).flat_map(separated).collect(),
            premultiplied: false,
        },
        _ => {
            let data = data.chunks_exact(channels).flat_map(|c| c.iter().copied().chain([255])).collect();
            Samples::Bytes { channels: channels + 1, data, truncated_grey: false }
        }
    };
    Ok(Decoded { width, height, samples, profile: Profile::Unknown })
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
