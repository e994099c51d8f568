//! Radiance RGBE pictures.

use super::{Bytes, Decoded, Profile, Samples, area};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let mut input = Bytes::new(bytes);
    if !line(&mut input)?.starts_with(b"#?") {
        return Err("this is no Radiance file".to_owned());
    }
    while !line(&mut input)?.is_empty() {}
    let (width, height) = size(line(&mut input)?)?;
    area(width, height)?;
    let mut data = Vec::with_capacity(3 * width * height);
    let mut row = vec![[0; 4]; width];
    for _ in 0..height {
        scan_line(&mut input, &mut row)?;
        data.extend(row.iter().flat_map(|&c| light(c)));
    }
    let samples = Samples::Floats { channels: 3, data, premultiplied: false, dim: false };
    Ok(Decoded { width, height, samples, profile: Profile::Light })
}

fn line<'a>(input: &mut Bytes<'a>) -> Result<&'a [u8], String> {
    let end = input.rest.iter().position(|&b| b == b'\n').ok_or("the header does not end")?;
    Ok(&input.take(end + 1)?[..end])
}

/// `-Y height +X width`.
fn size(line: &[u8]) -> Result<(usize, usize), String> {
    let text = std::str::from_utf8(line).unwrap_or_default();
    let parts: Vec<&str> = text.split_whitespace().collect();
    match parts[..] {
        ["-Y", height, "+X", width] => match (width.parse(), height.parse()) {
            (Ok(width), Ok(height)) => Ok((width, height)),
            _ => Err("the size is no number".to_owned()),
        },
        _ => Err("only pictures with rows from the top can be read".to_owned()),
    }
}

fn scan_line(input: &mut Bytes, row: &mut [[u8; 4]]) -> Result<(), String> {
    let encoded = matches!(input.rest, &[2, 2, hi, lo, ..] if hi < 128 && usize::from(u16::from_be_bytes([hi, lo])) == row.len());
    if encoded {
        input.take(4)?;
        for channel in 0..4 {
            runs(input, row, channel)?;
        }
        return Ok(());
    }
    // Plain pixels; (1, 1, 1, n) repeats the pixel before.
    let (mut x, mut shift) = (0, 0);
    while x < row.len() {
        let b = input.take(4)?;
        if b[..3] == [1, 1, 1] && x > 0 {
            let count = usize::from(b[3]) << shift.min(24);
            let end = (x + count).min(row.len());
            let before = row[x - 1];
            row[x..end].fill(before);
            x = end;
            shift += 8;
        } else {
            row[x] = [b[0], b[1], b[2], b[3]];
            x += 1;
            shift = 0;
        }
    }
    Ok(())
}

/// One channel of a row: runs of one value, and stretches of several.
fn runs(input: &mut Bytes, row: &mut [[u8; 4]], channel: usize) -> Result<(), String> {
    let mut x = 0;
    while x < row.len() {
        let code = usize::from(input.byte()?);
        let (count, run) = if code > 128 { (code - 128, true) } else { (code, false) };
        if count == 0 || x + count > row.len() {
            return Err("a run goes beyond the row".to_owned());
        }
        let value = if run { input.byte()? } else { 0 };
        for pixel in &mut row[x..x + count] {
            pixel[channel] = if run { value } else { input.byte()? };
        }
        x += count;
    }
    Ok(())
}

/// A mantissa stands for the middle of its step.
fn light([r, g, b, e]: [u8; 4]) -> [f32; 3] {
    if e == 0 {
        return [0.0; 3];
    }
    let scale = f64::from(i32::from(e) - 136).exp2();
    [r, g, b].map(|v| ((f64::from(v) + 0.5) * scale) as f32)
}
