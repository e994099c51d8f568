//! Numbers as text and back, by the rules of C.

/// Most characters of a number that [`format_short`] makes.
const LONGEST: usize = 254;

/// As [`format_fixed`]; what would be too long is written as `%L.Pg` of C.
pub(in crate::interp) fn format_short(v: f64, width: i32, precision: i32) -> String {
    let fixed = format_fixed(v, width, precision);
    if fixed.len() <= LONGEST {
        return fixed;
    }
    let significant = if precision < 0 { 6 } else { precision.clamp(1, MOST_DIGITS) as usize };
    let general = padded(general(v, significant), width, v.is_finite());
    if general.len() <= LONGEST { general } else { "<invalid>".to_owned() }
}

/// More digits or characters are not written.
const MOST_DIGITS: i32 = 4096;

/// `%L.Pf` of C: `width` below 0 pads with zeros, `precision` below 0 means 6 digits.
pub(in crate::interp) fn format_fixed(v: f64, width: i32, precision: i32) -> String {
    let digits = if precision < 0 { 6 } else { precision.min(MOST_DIGITS) as usize };
    let plain = if v.is_finite() { format!("{v:.digits$}") } else { not_finite(v) };
    padded(plain, width, v.is_finite())
}

fn padded(plain: String, width: i32, zeros: bool) -> String {
    let wide = width.unsigned_abs().min(MOST_DIGITS as u32) as usize;
    if plain.len() >= wide {
        plain
    } else if width < 0 && zeros {
        let (sign, size) = plain.split_at(usize::from(plain.starts_with('-')));
        format!("{sign}{size:0>rest$}", rest = wide - sign.len())
    } else {
        format!("{plain:>wide$}")
    }
}

fn not_finite(v: f64) -> String {
    let text = match (v.is_nan(), v.is_sign_negative()) {
        (true, true) => "-nan",
        (true, false) => "nan",
        (false, true) => "-inf",
        (false, false) => "inf",
    };
    text.to_owned()
}

/// `%g` of C: 6 significant digits, no zeros at the end.
pub(in crate::interp) fn format_general(v: f64) -> String {
    general(v, 6)
}

fn general(v: f64, significant: usize) -> String {
    if !v.is_finite() {
        return not_finite(v);
    }
    if v == 0.0 {
        return if v.is_sign_negative() { "-0".to_owned() } else { "0".to_owned() };
    }
    let scientific = format!("{v:.*e}", significant - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if exponent >= -4 && exponent < significant as i32 {
        let digits = (significant as i32 - 1 - exponent) as usize;
        return without_zeros(&format!("{v:.digits$}")).to_owned();
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", without_zeros(mantissa), exponent.abs())
}

fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// `atof` of C: leading space is skipped, what follows the number ignored, no number is 0.
pub(in crate::interp) fn leading_number(text: &str) -> f64 {
    let text = text.trim_start_matches([' ', '\t', '\n', '\r', '\x0B', '\x0C']);
    let (sign, size) = match text.as_bytes().first() {
        Some(b'-') => (-1.0, &text[1..]),
        Some(b'+') => (1.0, &text[1..]),
        _ => (1.0, text),
    };
    let bytes = size.as_bytes();
    if bytes.len() > 2 && bytes[0] == b'0' && (bytes[1] | 32) == b'x' {
        return sign * hexadecimal(&bytes[2..]);
    }
    for (word, value) in [("infinity", f64::INFINITY), ("inf", f64::INFINITY), ("nan", f64::NAN)] {
        if bytes.len() >= word.len() && bytes[..word.len()].eq_ignore_ascii_case(word.as_bytes()) {
            return sign * value;
        }
    }
    size[..decimal_length(bytes)].parse().map_or(0.0, |size: f64| sign * size)
}

/// How many bytes of `text` make a decimal number.
fn decimal_length(text: &[u8]) -> usize {
    let digits = |from: usize| text[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut end = digits(0);
    let mut any = end > 0;
    if text.get(end) == Some(&b'.') {
        let fraction = digits(end + 1);
        any |= fraction > 0;
        end += 1 + fraction;
    }
    if !any {
        return 0;
    }
    if text.get(end).is_some_and(|b| b | 32 == b'e') {
        let sign = usize::from(matches!(text.get(end + 1), Some(b'+' | b'-')));
        if end + 1 + sign < text.len() {
            let exponent = digits(end + 1 + sign);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
    }
    end
}

/// Digits behind `0x`, with an optional fraction and binary exponent.
fn hexadecimal(text: &[u8]) -> f64 {
    let (mut value, mut scale, mut point, mut at) = (0.0, 1.0, false, 0);
    while let Some(&b) = text.get(at) {
        match (b as char).to_digit(16) {
            Some(d) => {
                value = value * 16.0 + f64::from(d);
                scale *= if point { 16.0 } else { 1.0 };
            }
            None if b == b'.' && !point => point = true,
            None => break,
        }
        at += 1;
    }
    let power = match text.get(at) {
        Some(b'p' | b'P') => leading_number(&String::from_utf8_lossy(&text[at + 1..])).trunc(),
        _ => 0.0,
    };
    value / scale * power.exp2()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn general_format_is_that_of_c() {
        let cases = [
            (1.0 / 3.0, "0.333333"),
            (1e10, "1e+10"),
            (100000.0, "100000"),
            (1e6, "1e+06"),
            (-0.0001, "-0.0001"),
            (0.00001, "1e-05"),
            (123456.7, "123457"),
            (999999.5, "1e+06"),
            (0.0, "0"),
            (f64::INFINITY, "inf"),
        ];
        for (v, text) in cases {
            assert_eq!(format_general(v), text);
        }
    }

    #[test]
    fn fixed_format_pads_and_gives_way() {
        assert_eq!(format_fixed(2.5, 0, 0), "2");
        assert_eq!(format_fixed(3.5, 0, 0), "4");
        assert_eq!(format_fixed(-2.7486, -10, 3), "-00002.749");
        assert_eq!(format_short(1e300, 0, 2), "1e+300");
        assert_eq!(format_short(-1.5e300, -12, 2), "-0001.5e+300");
        assert_eq!(format_short(2.5, 255, 2), "<invalid>");
        assert_eq!(format_fixed(f64::INFINITY, -5, 2), "  inf");
    }

    #[test]
    fn numbers_lead_a_text() {
        let cases = [
            ("1e3", 1000.0),
            ("abc", 0.0),
            (" 12xyz", 12.0),
            ("0x10", 16.0),
            ("-.5e", -0.5),
            ("1e+", 1.0),
            ("", 0.0),
            (".", 0.0),
            ("-7.", -7.0),
        ];
        for (text, v) in cases {
            assert_eq!(leading_number(text), v, "{text}");
        }
    }
}
