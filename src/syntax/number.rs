/// Powers of ten that a double holds exactly.
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// The double nearest to a decimal number (`12`, `.5`, `5.`, `1e-3`; no sign) that fills `text`.
pub fn parse_number(text: &[u8]) -> f64 {
    leading_number(text).map_or(0.0, |(v, _)| v)
}

/// The double nearest to the decimal number that `text` begins with, and its length; `None` if it begins
/// with none.
///
/// Where the digits fit 53 bits and the power of ten is exact, one multiplication or division rounds
/// correctly (Clinger, "How to Read Floating Point Numbers Accurately", 1990); else the library does it.
#[inline]
pub fn leading_number(text: &[u8]) -> Option<(f64, usize)> {
    let (mut digits, mut significant) = (0u64, 0);
    let mut read = |from: usize| {
        let mut at = from;
        while let Some(d) = text.get(at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
            digits = digits.wrapping_mul(10).wrapping_add(u64::from(d));
            significant += usize::from(digits != 0);
            at += 1;
        }
        at
    };
    let mut at = read(0);
    let whole = at;
    let mut exponent = 0;
    if text.get(at) == Some(&b'.') {
        let end = read(at + 1);
        if end == 1 {
            return None;
        }
        exponent = at as i64 + 1 - end as i64;
        at = end;
    } else if whole == 0 {
        return None;
    }
    let mantissa = at;
    if let Some(length) = exponent_length(&text[at..]) {
        exponent += written_exponent(&text[at + 1..at + length]);
        at += length;
    }
    let written = if text[at - 1].is_ascii_digit() || text[at - 1] == b'.' { at } else { mantissa };
    if significant <= 19 && digits <= 1 << 53 {
        if (0..=22).contains(&exponent) {
            return Some((digits as f64 * EXACT_POWERS[exponent as usize], at));
        }
        if (-22..0).contains(&exponent) {
            return Some((digits as f64 / EXACT_POWERS[-exponent as usize], at));
        }
    }
    let value = std::str::from_utf8(&text[..written]).ok().and_then(|s| s.parse().ok()).unwrap_or(0.0);
    Some((value, at))
}

/// How many bytes `e`, a sign and digits take, if they come; sign and digits may be left away.
fn exponent_length(text: &[u8]) -> Option<usize> {
    if !matches!(text.first(), Some(b'e' | b'E')) {
        return None;
    }
    let sign = 1 + usize::from(matches!(text.get(1), Some(b'+' | b'-')));
    Some(sign + text[sign..].iter().take_while(|b| b.is_ascii_digit()).count())
}

/// The number after `e`, held within a range that no double exceeds.
fn written_exponent(text: &[u8]) -> i64 {
    let (negative, digits) = match text.first() {
        Some(b'-') => (true, &text[1..]),
        Some(b'+') => (false, &text[1..]),
        _ => (false, text),
    };
    let size = digits.iter().fold(0i64, |v, b| (v * 10 + i64::from(b - b'0')).min(1_000_000));
    if negative { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::{leading_number, parse_number};

    #[test]
    fn equals_the_library_bit_for_bit() {
        for text in [
            "0",
            "1",
            "5.",
            ".5",
            "1e2",
            "0.1",
            "3.14159265358979",
            "1E-3",
            "1e+3",
            "123456789012345678901234567890",
            "9007199254740993",
            "9007199254740992",
            "1e22",
            "1e23",
            "1e-22",
            "1e-23",
            "4.9e-324",
            "1.7976931348623157e308",
            "0.000000000000000000000000000001",
            "00000000000000000000012.5",
            "8.41982784728",
            "1e400",
            "1e-400",
            "2.2250738585072011e-308",
            "18446744073709551617",
            "0.1000000014901161193847656",
        ] {
            let expected: f64 = text.parse().unwrap();
            assert_eq!(parse_number(text.as_bytes()).to_bits(), expected.to_bits(), "{text}");
        }
    }

    #[test]
    fn a_number_ends_where_it_must() {
        for (text, length) in
            [("1e", 2), ("1e+", 3), ("1ex", 2), ("2.5e3x", 5), ("7.,", 2), ("0.5>", 3), ("3<", 1)]
        {
            assert_eq!(leading_number(text.as_bytes()).unwrap().1, length, "{text}");
        }
        for text in ["", ".", "e5", "-1", ".e1"] {
            assert_eq!(leading_number(text.as_bytes()), None, "{text}");
        }
    }

    proptest::proptest! {
        #[test]
        fn any_written_double_reads_back(v in proptest::num::f64::POSITIVE) {
            for text in [format!("{v}"), format!("{v:e}"), format!("{v:.6}")] {
                let expected: f64 = text.parse().unwrap();
                proptest::prop_assert_eq!(parse_number(text.as_bytes()).to_bits(), expected.to_bits());
            }
        }
    }
}
