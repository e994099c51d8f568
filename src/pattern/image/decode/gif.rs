//! GIF: the first picture only, in the order of the file (interlaced rows stay where they are).

use super::{Bytes, Decoded, Profile, Samples, area};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let mut input = Bytes::new(bytes);
    if !matches!(input.take(6)?, b"GIF87a" | b"GIF89a") {
        return Err("this is no GIF file".to_owned());
    }
    input.take(4)?;
    let flags = input.byte()?;
    input.take(2)?;
    if flags & 0x80 == 0 {
        return Err("the file has no global palette".to_owned());
    }
    let colors = input.take(3 << ((flags & 7) + 1))?;
    let mut palette: Vec<[u8; 4]> = colors.chunks_exact(3).map(|c| [c[0], c[1], c[2], 255]).collect();
    loop {
        match input.byte()? {
            b'!' => {
                if let Some(clear) = extension(&mut input)?
                    && let Some(entry) = palette.get_mut(clear)
                {
                    entry[3] = 0;
                }
            }
            b',' => {
                let (width, height, indices) = picture(&mut input)?;
                let samples = Samples::Palette { indices, palette: super::widened(palette), alpha: true };
                return Ok(Decoded { width, height, samples, profile: Profile::PerhapsSrgb });
            }
            _ => return Err("the file has no picture".to_owned()),
        }
    }
}

/// The transparent index, if the extension names one.
fn extension(input: &mut Bytes) -> Result<Option<usize>, String> {
    let label = input.byte()?;
    let data = blocks(input)?;
    Ok(match data[..] {
        [flags, _, _, clear, ..] if label == 0xF9 && flags & 1 == 1 => Some(usize::from(clear)),
        _ => None,
    })
}

/// The contents of a chain of blocks.
fn blocks(input: &mut Bytes) -> Result<Vec<u8>, String> {
    let mut data = Vec::new();
    loop {
        match input.byte()? {
            0 => return Ok(data),
            n => data.extend_from_slice(input.take(usize::from(n))?),
        }
    }
}

fn picture(input: &mut Bytes) -> Result<(usize, usize, Vec<u8>), String> {
    input.take(4)?;
    let (width, height) = (usize::from(input.short()?), usize::from(input.short()?));
    if input.byte()? & 0x80 != 0 {
        return Err("a palette of the picture's own is not supported".to_owned());
    }
    let bits = input.byte()?;
    if !(1..=11).contains(&bits) {
        return Err("the code size is out of range".to_owned());
    }
    let data = blocks(input)?;
    Ok((width, height, unpack(&data, bits, area(width, height)?)))
}

/// The LZW compression of GIF. What is missing at the end is index 0.
fn unpack(data: &[u8], bits: u8, count: usize) -> Vec<u8> {
    let (clear, end) = (1_usize << bits, (1_usize << bits) + 1);
    let mut out: Vec<u8> = Vec::with_capacity(count);
    // Each code is a stretch of what was written before: where it begins, and its length.
    let mut table: Vec<(usize, usize)> = Vec::new();
    let (mut width, mut held, mut have) = (usize::from(bits) + 1, 0_u32, 0);
    let mut before: Option<(usize, usize)> = None;
    for &byte in data {
        held |= u32::from(byte) << have;
        have += 8;
        while have >= width {
            let code = (held & ((1 << width) - 1)) as usize;
            held >>= width;
            have -= width;
            if code == clear {
                (table, before, width) = (Vec::new(), None, usize::from(bits) + 1);
                continue;
            }
            let start = out.len();
            let known = code < clear || code < end + 1 + table.len();
            if code == end || start >= count || (!known && before.is_none()) {
                out.resize(count, 0);
                return out;
            }
            if code < clear {
                out.push(code as u8);
            } else if let Some(&(from, length)) = table.get(code.wrapping_sub(end + 1)) {
                (from..from + length).for_each(|i| out.push(out[i]));
            } else if let Some((from, length)) = before {
                (from..from + length).chain([from]).for_each(|i| out.push(out[i]));
            }
            if let Some((from, length)) = before
                && end + 1 + table.len() < 4096
            {
                table.push((from, length + 1));
            }
            before = Some((start, out.len() - start));
            if end + 1 + table.len() + usize::from(before.is_some()) > (1 << width) && width < 12 {
                width += 1;
            }
        }
    }
    out.resize(count, 0);
    out
}
