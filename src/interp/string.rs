//! Strings: literals, their escapes and characters, and the functions that make strings.

use super::builtin::{format_date, format_fixed, format_short, has_date};
use super::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, StringId, Tok};
use std::sync::Arc;

/// How bytes above 127 in strings are read, and literals already read.
#[derive(Debug, Default)]
pub(super) struct TextState {
    utf8: bool,
    /// By number; only literals whose meaning never changes.
    literals: Vec<Option<Arc<str>>>,
}

/// How a date is written if nothing else is said.
const DATE_FORMAT: &str = "%Y-%m-%d %H:%M:%SZ";

impl Parser {
    /// `charset utf8` or another one.
    pub(crate) fn set_charset(&mut self, utf8: bool) {
        self.text.utf8 = utf8;
    }

    /// Whether strings are read as UTF-8.
    pub(crate) fn is_utf8(&self) -> bool {
        self.text.utf8
    }

    /// Whether a string expression comes next.
    pub(super) fn at_string(&mut self) -> Result<bool> {
        use Keyword::*;
        Ok(match self.peek_operand()?.tok {
            Tok::String(_) => true,
            Tok::Word(word) => {
                matches!(word, Str | Vstr | Concat | Substr | Chr | Strupr | Strlwr | Datetime)
            }
            Tok::Identifier(name) => match self.symbols.value(name) {
                Some(Value::String(_)) => true,
                Some(Value::Array(_)) => matches!(self.peek_value()?, Some(Value::String(_))),
                _ => false,
            },
            _ => false,
        })
    }

    /// A string expression.
    pub fn string(&mut self) -> Result<String> {
        self.string_value().map(|s| s.as_ref().to_owned())
    }

    /// A string naming a file: literals keep their backslashes.
    pub fn file_name(&mut self) -> Result<String> {
        let token = self.peek_operand()?;
        let Tok::String(id) = token.tok else { return self.string() };
        self.take(token)?;
        Ok(String::from_utf8_lossy(self.names.literal(id)).replace("\\\"", "\""))
    }

    pub(super) fn string_value(&mut self) -> Result<Arc<str>> {
        let token = self.peek_operand()?;
        match token.tok {
            Tok::String(id) => {
                self.take(token)?;
                self.literal(id, token.span)
            }
            Tok::Word(word) => self.string_function(word).map(Arc::from),
            Tok::Identifier(_) => match self.peek_value()? {
                Some(Value::String(s)) => {
                    self.take_value()?;
                    Ok(s)
                }
                _ => Err(self.unexpected("a string")),
            },
            _ => Err(self.unexpected("a string")),
        }
    }

    fn string_function(&mut self, word: Keyword) -> Result<String> {
        let token = self.peek()?;
        let read = match word {
            Keyword::Str => Self::str_function,
            Keyword::Vstr => Self::vstr_function,
            Keyword::Concat => Self::concat_function,
            Keyword::Substr => Self::substr_function,
            Keyword::Chr => Self::chr_function,
            Keyword::Strupr => |p: &mut Self| p.string().map(|s| s.to_ascii_uppercase()),
            Keyword::Strlwr => |p: &mut Self| p.string().map(|s| s.to_ascii_lowercase()),
            Keyword::Datetime => Self::datetime_function,
            _ => return Err(self.unexpected("a string")),
        };
        self.take(token)?;
        self.in_parens(read)
    }

    /// `str(v, L, P)`.
    fn str_function(&mut self) -> Result<String> {
        let v = self.float()?;
        self.comma()?;
        let (width, precision) = self.format()?;
        Ok(format_short(v, width, precision))
    }

    /// `vstr(n, v, separator, L, P)`.
    fn vstr_function(&mut self) -> Result<String> {
        let count = self.float()?.clamp(2.0, 5.0) as usize;
        self.comma()?;
        // A lone number fills the first component only.
        let v = self.sum()?.filled(1);
        self.comma()?;
        let separator = self.string_value()?;
        self.comma()?;
        let (width, precision) = self.format()?;
        let parts: Vec<String> = v[..count].iter().map(|&c| format_fixed(c, width, precision)).collect();
        Ok(parts.join(&separator))
    }

    /// `L, P`.
    fn format(&mut self) -> Result<(i32, i32)> {
        let width = self.float()? as i32;
        self.comma()?;
        Ok((width, self.float()? as i32))
    }

    fn concat_function(&mut self) -> Result<String> {
        let mut text = self.string()?;
        loop {
            self.comma()?;
            if self.peek()?.tok == Tok::Punct(Punct::RightParen) {
                return Ok(text);
            }
            text.push_str(&self.string_value()?);
            if text.len() > LONGEST {
                return Err(Box::new(Diagnostic::error(self.last, "this string is too long")));
            }
        }
    }

    /// `substr(s, start, length)`, `start` from 1.
    fn substr_function(&mut self) -> Result<String> {
        let s = self.string_value()?;
        self.comma()?;
        let start = self.float()?;
        self.comma()?;
        let length = self.float()?;
        let count = s.chars().count() as f64;
        let (start, length) = (start.trunc(), length.trunc());
        if !(start >= 0.0 && length >= 0.0 && start + length - 1.0 <= count) {
            let message = format!("substr() reaches outside its string of {count} characters");
            return Err(Box::new(Diagnostic::error(self.last, message)));
        }
        // What begins before the first character is empty.
        let taken = if start >= 1.0 { length as usize } else { 0 };
        Ok(s.chars().skip((start - 1.0) as usize).take(taken).collect())
    }

    fn chr_function(&mut self) -> Result<String> {
        let code = self.float()?.trunc();
        if !(0.0..65_536.0).contains(&code) {
            return Err(Box::new(Diagnostic::error(
                self.last,
                format!("{code} is no character (0 to 65535)"),
            )));
        }
        // The character 0 ends a string.
        let letter = Some(code as u32).filter(|c| *c != 0);
        Ok(letter
            .map(|c| char::from_u32(c).unwrap_or(char::REPLACEMENT_CHARACTER).into())
            .unwrap_or_default())
    }

    /// `datetime(days [, format])`.
    fn datetime_function(&mut self) -> Result<String> {
        let days = self.float()?;
        let text = "dates are those of the years 1400 to 9999";
        self.demand(has_date(days), self.last, text)?;
        self.comma()?;
        if self.peek()?.tok == Tok::Punct(Punct::RightParen) {
            return Ok(format_date(days, DATE_FORMAT));
        }
        let format = self.string_value()?;
        Ok(format_date(days, &format))
    }

    /// A literal with its escapes and bytes worked out.
    pub(super) fn literal(&mut self, id: StringId, span: Span) -> Result<Arc<str>> {
        let index = id.0 as usize;
        if let Some(Some(text)) = self.text.literals.get(index) {
            return Ok(text.clone());
        }
        let bytes = self.names.literal(id).to_vec();
        let text: Arc<str> = Arc::from(self.decode(&bytes, span)?);
        if bytes.is_ascii() {
            if index >= self.text.literals.len() {
                self.text.literals.resize(index + 1, None);
            }
            self.text.literals[index] = Some(text.clone());
        }
        Ok(text)
    }

    fn decode(&mut self, bytes: &[u8], span: Span) -> Result<String> {
        let mut out = String::with_capacity(bytes.len());
        let mut at = 0;
        while at < bytes.len() {
            let rest = &bytes[at..];
            at += match rest[0] {
                b'\\' => {
                    escape(rest, &mut out).map_err(|message| Box::new(Diagnostic::error(span, message)))?
                }
                b if b.is_ascii() => {
                    out.push(b as char);
                    1
                }
                b => self.high_byte(b, rest, span, &mut out),
            };
        }
        Ok(out)
    }

    /// A byte above 127, by the scene's character set; how many bytes it takes.
    fn high_byte(&mut self, byte: u8, rest: &[u8], span: Span, out: &mut String) -> usize {
        if self.text.utf8 {
            let length = byte.leading_ones().clamp(1, 4) as usize;
            let decoded = rest.get(..length).and_then(|b| std::str::from_utf8(b).ok()?.chars().next());
            // The language's characters have 16 bits.
            out.push(decoded.filter(|&c| c as u32 <= 0xFFFF).unwrap_or(char::REPLACEMENT_CHARACTER));
            return if decoded.is_some() { length } else { 1 };
        }
        if self.syntax_version() >= 350 {
            let text = "this string has bytes above 127, which `charset ascii` reads as spaces";
            let hint = "say `global_settings { charset utf8 }` before it";
            self.warn(Diagnostic::warning(span, text).with_hint(hint));
            out.push(' ');
        } else {
            out.push(byte as char);
        }
        1
    }
}

/// Longest string that functions may build, in bytes.
const LONGEST: usize = 1 << 24;

/// A backslash and what follows it; how many bytes they take.
fn escape(rest: &[u8], out: &mut String) -> std::result::Result<usize, String> {
    let c = match rest.get(1) {
        Some(b'a') => '\x07',
        Some(b'b') => '\x08',
        Some(b'f') => '\x0C',
        Some(b'n') => '\n',
        Some(b'r') => '\r',
        Some(b't') => '\t',
        Some(b'v') => '\x0B',
        Some(&b) if matches!(b, b'"' | b'\\' | b'\'') => b as char,
        Some(b'u') => {
            let digits = rest.get(2..6).and_then(|d| std::str::from_utf8(d).ok());
            let valid = digits.filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()));
            let Some(code) = valid.and_then(|d| u32::from_str_radix(d, 16).ok()) else {
                return Err("`\\u` needs exactly 4 hexadecimal digits".to_owned());
            };
            out.push(char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER));
            return Ok(6);
        }
        Some(&b) if b.is_ascii_graphic() => return Err(format!("illegal escape sequence `\\{}`", b as char)),
        _ => return Err("a backslash stands at the end of a line".to_owned()),
    };
    out.push(c);
    Ok(2)
}
