//! PNG, with the chunks that say what its values mean.

use super::{Curve, Decoded, Profile, Samples, area};
use png::{BitDepth, ColorType, Transformations};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(Transformations::IDENTITY);
    let mut reader = decoder.read_info().map_err(|e| e.to_string())?;
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    area(width, height)?;
    let mut data = vec![0; reader.output_buffer_size().ok_or("the image is too large")?];
    let frame = reader.next_frame(&mut data).map_err(|e| e.to_string())?;
    let info = reader.info();
    let profile = match (info.srgb, info.gama_chunk) {
        (Some(_), _) => Profile::Curve(Curve::Srgb),
        (None, Some(gamma)) if gamma.into_value() > 0.0 => {
            Profile::Curve(Curve::Power(1.0 / f64::from(gamma.into_value())))
        }
        _ => Profile::PerhapsSrgb,
    };
    let unpacked = |data: &[u8]| unpack(data, frame.line_size, width, height, frame.bit_depth);
    let samples = match (frame.color_type, frame.bit_depth) {
        (ColorType::Indexed, _) => {
            let palette = palette(info.palette.as_deref().unwrap_or_default(), info.trns.as_deref());
            Samples::Palette { indices: unpacked(&data), palette: super::widened(palette), alpha: true }
        }
        (color, BitDepth::Sixteen) => {
            let words = data.chunks_exact(2).map(|b| u16::from_be_bytes([b[0], b[1]])).collect();
            Samples::Words { channels: color.samples(), data: words, max: u16::MAX }
        }
        (ColorType::Grayscale, depth) => {
            let factor = 255 / ((1_u32 << depth as u32) - 1);
            let data = unpacked(&data).into_iter().map(|v| (u32::from(v) * factor) as u8).collect();
            Samples::Bytes { channels: 1, data, truncated_grey: true }
        }
        (color, _) => Samples::Bytes { channels: color.samples(), data, truncated_grey: false },
    };
    Ok(Decoded { width, height, samples, profile })
}

fn palette(colors: &[u8], alpha: Option<&[u8]>) -> Vec<[u8; 4]> {
    let alpha = |i: usize| alpha.and_then(|a| a.get(i)).copied().unwrap_or(255);
    colors.chunks_exact(3).enumerate().map(|(i, c)| [c[0], c[1], c[2], alpha(i)]).collect()
}

/// One byte per sample from rows of packed bits.
fn unpack(data: &[u8], line: usize, width: usize, height: usize, depth: BitDepth) -> Vec<u8> {
    let bits = depth as usize;
    let sample = |row: &[u8], x: usize| {
        let bit = x * bits;
        (row[bit / 8] >> (8 - bits - bit % 8)) & ((1_u16 << bits) - 1) as u8
    };
    let rows = data.chunks_exact(line.max(1)).take(height);
    rows.flat_map(|row| (0..width).map(move |x| sample(row, x))).collect()
}
