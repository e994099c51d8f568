//! BMP: 1, 4, 8, 24 and 32 bits, rows from the bottom.

use super::{Bytes, Decoded, Profile, Samples, area};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let mut input = Bytes::new(bytes);
    if input.take(2)? != b"BM" {
        return Err("this is no BMP file".to_owned());
    }
    input.take(8)?;
    let offset = input.long()? as usize;
    let header = input.long()?;
    let old = header == 12;
    let (width, height) = if old {
        (i32::from(input.short()?), i32::from(input.short()?))
    } else {
        (input.long()? as i32, input.long()? as i32)
    };
    input.short()?;
    let bits = input.short()?;
    let compression = if old { 0 } else { input.long()? };
    if width <= 0 || height <= 0 {
        return Err("only rows from the bottom up can be read".to_owned());
    }
    let (width, height) = (width as usize, height as usize);
    area(width, height)?;
    let palette = bytes.get(14 + header as usize..).ok_or("the file ends too early")?;
    let palette = colors(palette.get(..offset.saturating_sub(14 + header as usize)).unwrap_or(palette), old);
    let palette = super::widened(palette);
    let pixels = bytes.get(offset..).ok_or("the file ends too early")?;
    let samples = match (bits, compression) {
        (1 | 4 | 8, 0) => {
            Samples::Palette { indices: packed(pixels, width, height, bits.into())?, palette, alpha: false }
        }
        (8, 1) | (4, 2) => {
            Samples::Palette { indices: runs(pixels, width, height, bits == 4)?, palette, alpha: false }
        }
        (24 | 32, 0 | 3) => direct(pixels, width, height, usize::from(bits) / 8)?,
        _ => return Err(format!("{bits} bits with compression {compression} cannot be read")),
    };
    Ok(Decoded { width, height, samples, profile: Profile::PerhapsSrgb })
}

/// Blue, green, red and, in newer files, a spare byte.
fn colors(bytes: &[u8], old: bool) -> Vec<[u8; 4]> {
    bytes.chunks_exact(if old { 3 } else { 4 }).take(256).map(|c| [c[2], c[1], c[0], 255]).collect()
}

/// The rows from the top; in the file each fills whole groups of four bytes.
fn rows(pixels: &[u8], height: usize, bytes: usize) -> Result<impl Iterator<Item = &[u8]>, String> {
    let line = bytes.div_ceil(4) * 4;
    let lines = pixels.get(..line * (height - 1) + bytes).ok_or("the file ends too early")?;
    Ok((0..height).rev().map(move |y| &lines[y * line..y * line + bytes]))
}

fn packed(pixels: &[u8], width: usize, height: usize, bits: usize) -> Result<Vec<u8>, String> {
    let sample = |row: &[u8], x: usize| {
        let bit = x * bits;
        (row[bit / 8] >> (8 - bits - bit % 8)) & ((1_u16 << bits) - 1) as u8
    };
    let rows = rows(pixels, height, (width * bits).div_ceil(8))?;
    Ok(rows.flat_map(|row| (0..width).map(move |x| sample(row, x))).collect())
}

fn direct(pixels: &[u8], width: usize, height: usize, channels: usize) -> Result<Samples, String> {
    let mut data = Vec::with_capacity(width * height * channels);
    for row in rows(pixels, height, width * channels)? {
        for c in row.chunks_exact(channels) {
            data.extend([c[2], c[1], c[0]]);
            data.extend(c.get(3));
        }
    }
    Ok(Samples::Bytes { channels, data, truncated_grey: false })
}

/// Run-length encoding with one index per byte, or two of 4 bits each.
fn runs(pixels: &[u8], width: usize, height: usize, halves: bool) -> Result<Vec<u8>, String> {
    let mut input = Bytes::new(pixels);
    let mut indices = vec![0; width * height];
    let (mut x, mut y) = (0, 0);
    let mut put = |x: usize, y: usize, v: u8| {
        if x < width && y < height {
            indices[(height - 1 - y) * width + x] = v;
        }
    };
    let pick = |byte: u8, i: usize| match (halves, i % 2) {
        (false, _) => byte,
        (true, 0) => byte >> 4,
        (true, _) => byte & 15,
    };
    while y < height {
        match (input.byte()?, input.byte()?) {
            (0, 0) => (x, y) = (0, y + 1),
            (0, 1) => break,
            (0, 2) => (x, y) = (x + usize::from(input.byte()?), y + usize::from(input.byte()?)),
            (0, n) => {
                let n = usize::from(n);
                let size = if halves { n.div_ceil(2) } else { n };
                let bytes = input.take(size)?;
                (0..n).for_each(|i| put(x + i, y, pick(bytes[if halves { i / 2 } else { i }], i)));
                input.take(size % 2)?;
                x += n;
            }
            (n, byte) => {
                (0..usize::from(n)).for_each(|i| put(x + i, y, pick(byte, i)));
                x += usize::from(n);
            }
        }
    }
    Ok(indices)
}
