//! Targa: palette, RGB and grey, plain or in runs.

use super::{Bytes, Decoded, Profile, Samples, area};

struct Header {
    /// 1 palette, 2 RGB, 3 grey.
    kind: u8,
    runs: bool,
    width: usize,
    height: usize,
    /// Bits per pixel.
    depth: u8,
    from_top: bool,
}

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let mut input = Bytes::new(bytes);
    let h = input.take(18)?;
    let short = |i: usize| usize::from(u16::from_le_bytes([h[i], h[i + 1]]));
    let header = Header {
        kind: h[2] & 7,
        runs: h[2] & 8 != 0,
        width: short(12),
        height: short(14),
        depth: h[16],
        from_top: h[17] & 0x20 != 0,
    };
    let (name, colors, color_depth) = (usize::from(h[0]), short(5), h[7]);
    input.take(name)?;
    let map = if h[1] == 1 { read_colors(&mut input, colors, color_depth)? } else { Vec::new() };
    area(header.width, header.height)?;
    let pixels = if header.runs { packets(&mut input, &header)? } else { plain(&mut input, &header)? };
    let samples = samples(&header, pixels, map)?;
    Ok(Decoded { width: header.width, height: header.height, samples, profile: Profile::PerhapsSrgb })
}

fn read_colors(input: &mut Bytes, count: usize, depth: u8) -> Result<Vec<[u8; 4]>, String> {
    (0..count).map(|_| Ok(color(input.take(usize::from(depth).div_ceil(8))?, depth))).collect()
}

/// 5 bits per channel become the upper bits of a byte; the 16th bit is alpha.
fn color(b: &[u8], depth: u8) -> [u8; 4] {
    match *b {
        [lo, hi] => {
            let v = u16::from_le_bytes([lo, hi]);
            let part = |shift: u16| (((v >> shift) & 31) * 8) as u8;
            let alpha = if depth == 16 && v & 0x8000 == 0 { 0 } else { 255 };
            [part(10), part(5), part(0), alpha]
        }
        [b, g, r] => [r, g, b, 255],
        [b, g, r, a, ..] => [r, g, b, a],
        [v] => [v, v, v, 255],
        [] => [0, 0, 0, 255],
    }
}

fn size(header: &Header) -> usize {
    usize::from(header.depth).div_ceil(8)
}

/// The bytes of the pixels, in file order.
fn plain(input: &mut Bytes, header: &Header) -> Result<Vec<u8>, String> {
    Ok(input.take(header.width * header.height * size(header))?.to_vec())
}

/// Pixels from packets. A run that crosses the end of a row goes on at the beginning of the same row.
fn packets(input: &mut Bytes, header: &Header) -> Result<Vec<u8>, String> {
    let size = size(header);
    let (width, count) = (header.width, header.width * header.height);
    let mut pixels = vec![0; count * size];
    let mut at = 0;
    while at < count {
        let code = input.byte()?;
        let n = usize::from(code & 127) + 1;
        let row = at / width * width;
        let run = if code & 128 != 0 { Some(input.take(size)?) } else { None };
        for i in at..(at + n).min(count) {
            let (place, bytes) = match run {
                Some(bytes) => (row + i % width, bytes),
                None => (i, input.take(size)?),
            };
            pixels[place * size..(place + 1) * size].copy_from_slice(bytes);
        }
        at += n;
    }
    Ok(pixels)
}

fn samples(header: &Header, pixels: Vec<u8>, palette: Vec<[u8; 4]>) -> Result<Samples, String> {
    let size = size(header);
    let line = header.width * size;
    let rows: Vec<&[u8]> = match (line, header.from_top) {
        (0, _) => Vec::new(),
        (_, true) => pixels.chunks_exact(line).collect(),
        (_, false) => pixels.chunks_exact(line).rev().collect(),
    };
    let pixels = rows.into_iter().flat_map(|row| row.chunks_exact(size));
    match (header.kind, header.depth) {
        (1, 8) => Ok(Samples::Palette {
            indices: pixels.map(|b| b[0]).collect(),
            palette: super::widened(palette),
            alpha: false,
        }),
        (3, 8) => {
            Ok(Samples::Bytes { channels: 1, data: pixels.map(|b| b[0]).collect(), truncated_grey: false })
        }
        (2, 16 | 32) => {
            let data = pixels.flat_map(|b| color(b, header.depth)).collect();
            Ok(Samples::Bytes { channels: 4, data, truncated_grey: false })
        }
        (2, 15 | 24) => {
            let data = pixels.flat_map(|b| color(b, header.depth).into_iter().take(3)).collect();
            Ok(Samples::Bytes { channels: 3, data, truncated_grey: false })
        }
        (kind, depth) => Err(format!("type {kind} with {depth} bits cannot be read")),
    }
}
