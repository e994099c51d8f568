//! Diagnostics as the user sees them: source line, caret, the way that led there.

use super::excerpt::Excerpt;
use crate::source::{Diagnostic, FileId, Files, Label, Severity, Span};
use codespan_reporting::diagnostic as drawn;
use codespan_reporting::files::{Error, Files as DrawnFiles};
use codespan_reporting::term;
use codespan_reporting::term::termcolor::{ColorChoice, StandardStream};
use std::collections::HashMap;
use std::io::IsTerminal;
use std::ops::Range;

/// Draws a diagnostic on stderr.
pub fn show(diagnostic: &Diagnostic, files: &Files, ascii: bool) {
    if ascii {
        eprint!("{}", render_ascii(diagnostic, files));
        return;
    }
    let texts = Texts::of(diagnostic, files);
    let choice = if colored() { ColorChoice::Auto } else { ColorChoice::Never };
    let mut stderr = StandardStream::stderr(choice);
    if term::emit_to_write_style(&mut stderr, &config(), &texts, &drawing(diagnostic, &texts)).is_err() {
        eprintln!("{}", line(diagnostic, files));
    }
}

/// The diagnostic as [`show`] draws it, without colours.
pub fn render(diagnostic: &Diagnostic, files: &Files) -> String {
    let texts = Texts::of(diagnostic, files);
    term::emit_into_string(&config(), &texts, &drawing(diagnostic, &texts))
        .unwrap_or_else(|_| line(diagnostic, files))
}

/// The same in ASCII, `?` for what has no place in it.
fn render_ascii(diagnostic: &Diagnostic, files: &Files) -> String {
    let texts = Texts::of(diagnostic, files);
    let config = term::Config { chars: term::Chars::ascii(), ..config() };
    let drawn = term::emit_into_string(&config, &texts, &drawing(diagnostic, &texts));
    let text = drawn.unwrap_or_else(|_| line(diagnostic, files)).replace('…', "...");
    text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect()
}

/// One line: place and message.
pub fn line(diagnostic: &Diagnostic, files: &Files) -> String {
    let Some(span) = diagnostic.span else { return diagnostic.message.clone() };
    let (line, column) = position(files.text(span.file), span.start as usize);
    format!("{}:{line}:{column}: {}", files.name(span.file), diagnostic.message)
}

/// Line and column of a byte, both counted from 1.
fn position(text: &[u8], at: usize) -> (usize, usize) {
    let before = &text[..at.min(text.len())];
    let line = before.iter().filter(|&&b| b == b'\n').count() + 1;
    let start = before.iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
    (line, before.len() - start + 1)
}

/// Whether stderr wants colours.
pub fn colored() -> bool {
    let plain = std::env::var_os("NO_COLOR").is_some_and(|v| !v.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|t| t == "dumb");
    !plain && !dumb && std::io::stderr().is_terminal()
}

fn config() -> term::Config {
    term::Config { tab_width: 4, ..term::Config::default() }
}

fn drawing(d: &Diagnostic, texts: &Texts) -> drawn::Diagnostic<u32> {
    let severity = match d.severity {
        Severity::Error => drawn::Severity::Error,
        Severity::Warning => drawn::Severity::Warning,
        Severity::Note => drawn::Severity::Note,
    };
    let primary = d.span.map(|s| drawn::Label::primary(s.file.0, texts.shown(s)).with_message(&d.label));
    let secondary =
        |l: &Label| drawn::Label::secondary(l.span.file.0, texts.shown(l.span)).with_message(&l.message);
    let labels = primary.into_iter().chain(d.labels.iter().chain(&d.trace).map(secondary)).collect();
    let notes = d.hint.iter().map(|h| format!("help: {h}")).collect();
    drawn::Diagnostic::new(severity).with_message(&d.message).with_labels(labels).with_notes(notes)
}

fn range(span: Span) -> Range<usize> {
    span.start as usize..(span.end as usize).max(span.start as usize)
}

/// What is shown of the texts that a diagnostic points into.
struct Texts<'a> {
    files: &'a Files,
    texts: HashMap<u32, Excerpt>,
}

impl<'a> Texts<'a> {
    fn of(diagnostic: &Diagnostic, files: &'a Files) -> Self {
        let more = diagnostic.labels.iter().chain(&diagnostic.trace).map(|l| l.span);
        let mut spans = HashMap::<u32, Vec<_>>::new();
        for span in diagnostic.span.into_iter().chain(more) {
            spans.entry(span.file.0).or_default().push(range(span));
        }
        let excerpt = |(id, spans): (u32, Vec<_>)| (id, Excerpt::of(files.text(FileId(id)), &spans));
        Self { files, texts: spans.into_iter().map(excerpt).collect() }
    }

    fn get(&self, id: u32) -> Result<&Excerpt, Error> {
        self.texts.get(&id).ok_or(Error::FileMissing)
    }

    /// A span's place in its excerpt.
    fn shown(&self, span: Span) -> Range<usize> {
        let place = range(span);
        self.texts.get(&span.file.0).map_or(0..0, |e| e.shown(place.start)..e.shown(place.end))
    }
}

impl<'a> DrawnFiles<'a> for Texts<'_> {
    type FileId = u32;
    type Name = String;
    type Source = &'a str;

    fn name(&'a self, id: u32) -> Result<String, Error> {
        Ok(self.files.name(FileId(id)).to_owned())
    }

    fn source(&'a self, id: u32) -> Result<&'a str, Error> {
        Ok(&self.get(id)?.text)
    }

    fn line_index(&'a self, id: u32, byte: usize) -> Result<usize, Error> {
        Ok(self.get(id)?.line_index(byte))
    }

    fn line_range(&'a self, id: u32, line: usize) -> Result<Range<usize>, Error> {
        Ok(self.get(id)?.line_range(line))
    }

    fn column_number(&'a self, id: u32, line: usize, byte: usize) -> Result<usize, Error> {
        Ok(self.get(id)?.column(self.files.text(FileId(id)), line, byte))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files(text: &[u8]) -> (Files, FileId) {
        let mut files = Files::default();
        let id = files.add("leaf.pov".into(), None, text.to_vec().into());
        (files, id)
    }

    #[test]
    fn the_source_line_is_shown_with_a_caret() {
        let (files, file) = files(b"sphere {\n  spere 1\n}\n");
        let span = Span { file, start: 11, end: 16 };
        let d = Diagnostic::error(span, "unknown word `spere`")
            .with_label("expected a vector")
            .with_hint("did you mean `sphere`?");
        let text = render(&d, &files);
        for part in [
            "error: unknown word `spere`",
            "leaf.pov:2:3",
            "  spere 1",
            "^^^^^ expected a vector",
            "help: did you",
        ] {
            assert!(text.contains(part), "{part:?} is missing in\n{text}");
        }
        assert_eq!(line(&d, &files), "leaf.pov:2:3: unknown word `spere`");
    }

    #[test]
    fn bytes_that_are_no_text_do_no_harm() {
        let (files, file) = files(b"// \xff\xfe caf\xe9\r\nbox\n");
        let d = Diagnostic::warning(Span { file, start: 12, end: 15 }, "a box");
        assert!(render(&d, &files).contains("leaf.pov:2:1"), "{}", render(&d, &files));
    }

    #[test]
    fn ascii_is_for_programs_that_read_along() {
        let (files, file) = files("sphere { caf\u{e9} }\n".as_bytes());
        let d = Diagnostic::error(Span { file, start: 9, end: 14 }, "unknown word `caf\u{e9}` …");
        let text = render_ascii(&d, &files);
        assert!(text.is_ascii() && text.contains("unknown word `caf?` ...") && text.contains("^"), "{text}");
    }

    /// Scenes that programs write may be one line of megabytes.
    #[test]
    fn long_lines_are_cut() {
        let around = "sphere { 0, 1 } ".repeat(200_000);
        let (files, file) = files(format!("{around}spere{around}").as_bytes());
        let start = around.len() as u32;
        let d = Diagnostic::error(Span { file, start, end: start + 5 }, "unknown word").with_label("here");
        let text = render_ascii(&d, &files);
        assert!(text.len() < 1000, "{}", text.len());
        assert!(text.contains(&format!("leaf.pov:1:{}", start + 1)), "{text}");
        let column = |word: &str| text.lines().find_map(|l| l.find(word)).unwrap();
        assert_eq!(column("spere"), column("^^^^^ here"), "{text}");
        assert!(text.contains(" ...") && text.contains("...\n"), "{text}");
    }

    #[test]
    fn the_way_is_shown() {
        let (mut files, file) = files(b"#include \"a.inc\"\n");
        let inner = files.add("a.inc".into(), None, b"oops\n".to_vec().into());
        let mut d = Diagnostic::error(Span { file: inner, start: 0, end: 4 }, "unknown word");
        d.trace.push(Label {
            span: Span { file, start: 9, end: 16 },
            message: "in a file included here".into(),
        });
        let text = render(&d, &files);
        assert!(text.contains("a.inc:1:1") && text.contains("in a file included here"), "{text}");
    }

    /// A span at the very end of a file, as an unexpected end has.
    #[test]
    fn the_end_of_a_file_can_be_pointed_at() {
        let (files, file) = files(b"sphere {");
        let d = Diagnostic::error(Span { file, start: 8, end: 8 }, "the file ends inside `sphere`");
        assert!(render(&d, &files).contains("leaf.pov:1:9"));
    }
}
