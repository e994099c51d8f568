//! PGM and PPM, as text (P2, P3) and binary (P5, P6).

use super::{Bytes, Decoded, Profile, Samples, area};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let mut input = Bytes::new(bytes);
    let magic = input.take(2)?;
    let (channels, text) = match magic {
        b"P2" => (1, true),
        b"P3" => (3, true),
        b"P5" => (1, false),
        b"P6" => (3, false),
        _ => return Err("this is no PGM or PPM file".to_owned()),
    };
    let (width, height) = (number(&mut input)? as usize, number(&mut input)? as usize);
    let count = area(width, height)? * channels;
    let max = number(&mut input)?;
    let max = u16::try_from(max).ok().filter(|&m| m > 0).ok_or("the largest value must be 1 to 65535")?;
    let samples = if text {
        let data =
            (0..count).map(|_| Ok(number(&mut input)?.min(65535) as u16)).collect::<Result<_, String>>()?;
        Samples::Words { channels, data, max }
    } else if max > 255 {
        let data = input.take(2 * count)?.chunks_exact(2).map(|b| u16::from_be_bytes([b[0], b[1]]));
        Samples::Words { channels, data: data.collect(), max }
    } else if max == 255 {
        Samples::Bytes { channels, data: input.take(count)?.to_vec(), truncated_grey: false }
    } else {
        let data = input.take(count)?.iter().map(|&b| u16::from(b));
        Samples::Words { channels, data: data.collect(), max }
    };
    Ok(Decoded { width, height, samples, profile: Profile::Unknown })
}

/// The next number after blanks and comments, with the one blank behind it.
fn number(input: &mut Bytes) -> Result<u32, String> {
    let mut value = None;
    loop {
        let byte = match input.byte() {
            Ok(byte) => byte,
            // The last number of a text file may end it.
            Err(error) => return value.ok_or(error),
        };
        match (byte, value) {
            (b'0'..=b'9', _) => {
                let digits = value.unwrap_or(0_u32).saturating_mul(10);
                value = Some(digits.saturating_add(u32::from(byte - b'0')));
            }
            (b'#', None) => while input.byte()? != b'\n' {},
            (b, Some(value)) if b.is_ascii_whitespace() => return Ok(value),
            (b, None) if b.is_ascii_whitespace() => (),
            _ => return Err("expected a number in the header".to_owned()),
        }
    }
}
