//! Text files that a scene reads and writes: `#fopen`, `#read`, `#write`, `#fclose`.

use super::builtin::format_general;
use super::expr::Number;
use super::limits::MEGABYTE;
use super::lookup::Kind;
use super::places::Access;
use super::symbols::{Binding, GLOBAL};
use super::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Lexer, Punct, Symbol, Tok, Token};
use std::fs::{File, OpenOptions};
use std::io::{BufWriter, Write};
use std::path::PathBuf;

/// An open text file.
#[derive(Debug)]
pub(super) enum TextFile {
    Reader { lexer: Lexer, waiting: Vec<Token>, at: usize, done: bool },
    Writer { file: BufWriter<File>, path: PathBuf },
}

/// Tokens read from a data file at a time.
const BATCH: usize = 256;

impl Parser {
    /// `#fopen Handle "name" read|write|append`.
    pub(super) fn fopen_directive(&mut self) -> Result<()> {
        let name = self.raw()?;
        let Tok::Identifier(handle) = name.tok else {
            return Err(self.unexpected_token(name, "a name for the file"));
        };
        let start = self.peek()?.span;
        let file_name = self.file_name()?;
        let span = start.to(self.last);
        let mode = self.next()?;
        let opened = match mode.tok {
            Tok::Word(Keyword::Read) => self.open_reader(&file_name, span)?,
            Tok::Word(Keyword::Write) => self.open_writer(&file_name, false, span)?,
            Tok::Word(Keyword::Append) => self.open_writer(&file_name, true, span)?,
            _ => return Err(self.unexpected_token(mode, "`read`, `write` or `append`")),
        };
        self.text_files.push(Some(opened));
        self.symbols.bind(handle, GLOBAL, Binding::File(self.text_files.len() - 1));
        Ok(())
    }

    fn open_reader(&mut self, name: &str, span: Span) -> Result<TextFile> {
        let path = self.require_file(name, Kind::Data, span)?;
        let file = self.load(&path, &path.display().to_string(), span)?;
        Ok(TextFile::Reader { lexer: self.lexer(file), waiting: Vec::new(), at: 0, done: false })
    }

    fn open_writer(&mut self, name: &str, append: bool, span: Span) -> Result<TextFile> {
        let path = PathBuf::from(name);
        self.check_place(&path, Access::Write, span)?;
        if path.metadata().is_ok_and(|there| !there.is_file()) {
            let message = format!("cannot open `{name}`: it is no plain file");
            return Err(Box::new(Diagnostic::error(span, message)));
        }
        let mut how = OpenOptions::new();
        how.create(true);
        if append {
            how.append(true)
        } else {
            how.write(true).truncate(true)
        };
        // A text read before is not the file's text any more.
        self.loaded.remove(&path);
        match how.open(&path) {
            Ok(file) => Ok(TextFile::Writer { file: BufWriter::new(file), path }),
            Err(why) => Err(Box::new(Diagnostic::error(span, format!("cannot open `{name}`: {why}")))),
        }
    }

    /// The handle that comes next, its number and place.
    fn handle(&mut self) -> Result<(Symbol, usize, Span)> {
        let token = self.raw()?;
        if let Tok::Identifier(symbol) = token.tok
            && let Some(Binding::File(index)) = self.symbols.binding(symbol)
        {
            return Ok((symbol, *index, token.span));
        }
        Err(self.unexpected_token(token, "an open file"))
    }

    pub(super) fn fclose_directive(&mut self) -> Result<()> {
        let token = self.raw()?;
        let Tok::Identifier(symbol) = token.tok else {
            return Err(self.unexpected_token(token, "an open file"));
        };
        match self.symbols.binding(symbol) {
            Some(&Binding::File(index)) => self.close(symbol, index, token.span),
            _ => Ok(()),
        }
    }

    fn close(&mut self, symbol: Symbol, index: usize, span: Span) -> Result<()> {
        self.symbols.remove(symbol, GLOBAL);
        if let Some(TextFile::Writer { mut file, path }) = self.text_files[index].take() {
            file.flush().map_err(|why| write_error(&path, &why, span))?;
        }
        Ok(())
    }

    /// Writes out what is still waiting, at the end of the scene.
    pub(super) fn close_all(&mut self) -> Result<()> {
        for file in &mut self.text_files {
            if let Some(TextFile::Writer { mut file, path }) = file.take() {
                file.flush().map_err(|why| write_error(&path, &why, self.last))?;
            }
        }
        Ok(())
    }

    /// `#read(Handle, ID, …)`: the file is closed with its last item.
    pub(super) fn read_directive(&mut self) -> Result<()> {
        self.expect_punct(Punct::LeftParen)?;
        let (symbol, index, span) = self.handle()?;
        let mut open = true;
        loop {
            self.comma()?;
            if self.accept_punct(Punct::RightParen)? {
                return Ok(());
            }
            let target = self.assignment_target()?;
            if !open {
                continue;
            }
            match self.data_item(index, span)? {
                Some(value) => {
                    self.declare_target(target, value)?;
                    // The comma behind an item is taken, or whatever stands there.
                    open = self.data_token(index)?.is_some();
                }
                None => open = false,
            }
            if !open {
                self.close(symbol, index, span)?;
            }
        }
    }

    fn data_token(&mut self, index: usize) -> Result<Option<Token>> {
        let Some(Some(TextFile::Reader { lexer, waiting, at, done })) = self.text_files.get_mut(index) else {
            return Err(Box::new(Diagnostic::error(self.last, "this file is not open for reading")));
        };
        if *at == waiting.len() && !*done {
            waiting.clear();
            *at = 0;
            *done = lexer.fill(&mut self.names, waiting, BATCH)?;
        }
        let token = waiting.get(*at).copied();
        *at += usize::from(token.is_some());
        Ok(token)
    }

    /// A number, vector or string; `None` at the end of the file.
    fn data_item(&mut self, index: usize, span: Span) -> Result<Option<Value>> {
        let Some(token) = self.data_token(index)? else { return Ok(None) };
        let item = match token.tok {
            Tok::String(id) => Value::String(self.literal(id, token.span)?),
            Tok::Punct(Punct::Less) => self.data_vector(index, token.span)?,
            _ => Value::Float(self.data_number(index, Some(token), span)?),
        };
        Ok(Some(item))
    }

    fn data_number(&mut self, index: usize, first: Option<Token>, span: Span) -> Result<f64> {
        let mut sign = 1.0;
        let mut next = first;
        loop {
            match next.map(|t| t.tok) {
                Some(Tok::Number(v)) => return Ok(sign * v),
                Some(Tok::Punct(Punct::Minus)) => sign = -sign,
                Some(Tok::Punct(Punct::Plus)) => {}
                _ => {
                    let place = next.map_or(span, |t| t.span);
                    let text = "expected a number, a vector or a string in this data file";
                    return Err(Box::new(Diagnostic::error(place, text)));
                }
            }
            next = self.data_token(index)?;
        }
    }

    fn data_vector(&mut self, index: usize, open: Span) -> Result<Value> {
        let (mut n, mut v) = (0, [0.0; 5]);
        loop {
            let token = self.data_token(index)?;
            match token.map(|t| t.tok) {
                Some(Tok::Punct(Punct::Greater)) if n >= 2 => {
                    return Ok(Number::Tuple(n as u8, v).into_value());
                }
                Some(Tok::Punct(Punct::Comma)) if n > 0 => {}
                _ if n < 5 => {
                    v[n] = self.data_number(index, token, open)?;
                    n += 1;
                }
                _ => return Err(Box::new(Diagnostic::error(open, "a vector has 2 to 5 components"))),
            }
        }
    }

    /// `#write(Handle, item, …)`. A binary format counts for the numbers behind it up to the next comma.
    pub(super) fn write_directive(&mut self) -> Result<()> {
        self.expect_punct(Punct::LeftParen)?;
        let (_, index, span) = self.handle()?;
        let mut binary: Option<Format> = None;
        loop {
            let token = self.peek()?;
            let bytes = match (token.tok, binary) {
                (Tok::Punct(Punct::RightParen), _) => break,
                (Tok::Punct(Punct::Comma), _) => {
                    self.next()?;
                    binary = None;
                    continue;
                }
                (_, Some(format)) => format.encode(self.sum()?),
                (Tok::Word(word), None) if Format::from_word(word).is_some() => {
                    self.next()?;
                    binary = Format::from_word(word);
                    continue;
                }
                _ if self.at_string()? => self.string()?.into_bytes(),
                _ => written(self.sum()?).into_bytes(),
            };
            self.write_bytes(index, &bytes, span)?;
        }
        self.next().map(|_| ())
    }

    fn write_bytes(&mut self, index: usize, bytes: &[u8], span: Span) -> Result<()> {
        self.written += bytes.len() as u64;
        let limit = self.options.limits.written;
        if self.written > limit {
            let message = format!("the scene writes more than {} MB", limit / MEGABYTE);
            return Err(Box::new(
                Diagnostic::error(span, message).with_hint("`--limit written=N` lets it write more"),
            ));
        }
        match self.text_files.get_mut(index) {
            Some(Some(TextFile::Writer { file, path })) => {
                file.write_all(bytes).map_err(|why| write_error(path, &why, span))
            }
            _ => Err(Box::new(Diagnostic::error(span, "this file is not open for writing"))),
        }
    }
}

fn write_error(path: &std::path::Path, why: &std::io::Error, span: Span) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(span, format!("cannot write `{}`: {why}", path.display())))
}

/// A number as it is, a tuple with brackets and a space behind it.
fn written(value: Number) -> String {
    match value.plain() {
        Number::Scalar(v) => format_general(v),
        Number::Tuple(n, v) => {
            let parts: Vec<String> = v[..n as usize].iter().map(|&c| format_general(c)).collect();
            format!("<{}> ", parts.join(","))
        }
    }
}

/// A binary number format of `#write`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Format {
    bytes: usize,
    signed: bool,
    big_endian: bool,
}

impl Format {
    fn from_word(word: Keyword) -> Option<Self> {
        let (bytes, signed, big_endian) = match word {
            Keyword::Sint8 => (1, true, true),
            Keyword::Uint8 => (1, false, true),
            Keyword::Sint16be => (2, true, true),
            Keyword::Sint16le => (2, true, false),
            Keyword::Uint16be => (2, false, true),
            Keyword::Uint16le => (2, false, false),
            Keyword::Sint32be => (4, true, true),
            Keyword::Sint32le => (4, true, false),
            _ => return None,
        };
        Some(Self { bytes, signed, big_endian })
    }

    /// Every component, clamped to the range and rounded.
    fn encode(self, value: Number) -> Vec<u8> {
        let bits = 8 * self.bytes as i32 - i32::from(self.signed);
        let (low, high) = (if self.signed { -(2f64.powi(bits)) } else { 0.0 }, 2f64.powi(bits) - 1.0);
        let mut out = Vec::new();
        for &v in &value.filled(1)[..value.len()] {
            let rounded = (v.clamp(low, high) + 0.5).floor().min(high) as i64;
            let bytes = rounded.to_be_bytes();
            let used = &bytes[8 - self.bytes..];
            if self.big_endian { out.extend(used) } else { out.extend(used.iter().rev()) }
        }
        out
    }
}
