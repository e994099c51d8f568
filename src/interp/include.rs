//! `#include`, and the texts behind it.

use super::kept::Kept;
use super::lookup::{Found, Kind, OTHER_CASE};
use super::options::{IncludeMode, SceneSource};
use super::places::Access;
use super::stream::{Frame, Source, link};
use super::{Parser, Result, embedded};
use crate::source::{Diagnostic, FileId, Span};
use crate::syntax::Lexer;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

/// Files are addressed with 32 bits.
const LARGEST: u64 = u32::MAX as u64;

/// Longer files are split into tokens each time that they are included.
const LONGEST_KEPT: usize = 1 << 20;

impl Parser {
    /// Opens the scene's own text.
    pub(super) fn open_main(&mut self, source: &SceneSource) -> Result<()> {
        let file = match source {
            SceneSource::Text { name, text } => self.files.add(name.clone(), None, Arc::new(text.clone())),
            SceneSource::Path(path) => self.load(path, &path.display().to_string(), Span::default())?,
        };
        let mut lexer = self.lexer(file);
        self.last = Span { file, start: 0, end: 0 };
        // Bytes above 127 at the very start announce UTF-8.
        let mark = lexer.text().iter().take_while(|b| !b.is_ascii()).count();
        if mark > 0 {
            lexer.seek(mark);
            self.set_charset(true);
        }
        self.frames.push(Frame::file(lexer, 0, self.last));
        Ok(())
    }

    /// Reads the file named by `Include_Header` before the scene.
    pub(super) fn open_header(&mut self) -> Result<()> {
        match self.options.include_header.clone() {
            Some(name) => self.include(&name.display().to_string(), self.last),
            None => Ok(()),
        }
    }

    /// `#include "file"`, behind the word.
    pub(super) fn include_directive(&mut self, span: Span) -> Result<()> {
        let name = self.file_name()?;
        self.include(&name, span.to(self.last))
    }

    fn include(&mut self, name: &str, span: Span) -> Result<()> {
        let open = self.frames.iter().filter(|f| matches!(f.source, Source::File { .. })).count();
        let limit = self.options.limits.open_files;
        if open >= limit {
            return Err(Box::new(
                Diagnostic::error(span, format!("more than {limit} files include each other"))
                    .with_hint("does a file include itself?"),
            ));
        }
        self.check_tables(span)?;
        let file = self.included_file(name, span)?;
        let lexer = self.lexer(file);
        let blocks = self.blocks.len();
        let frame = match self.kept_file(file) {
            Some(text) => Frame::kept_file(lexer, text, blocks, span),
            None => Frame::file(lexer, blocks, span),
        };
        self.enter_frame(frame);
        self.symbols.enter();
        Ok(())
    }

    /// The tokens of a file that is included again.
    fn kept_file(&mut self, file: FileId) -> Option<Rc<Kept>> {
        let before = self.included.insert(file, None);
        let text = match before? {
            Some(text) => text,
            None => {
                let mut lexer = self.lexer(file);
                let mut tokens = Vec::new();
                let is_short = lexer.text().len() <= LONGEST_KEPT;
                if !(is_short && lexer.fill(&mut self.names, &mut tokens, usize::MAX).ok()?) {
                    return None;
                }
                link(&mut tokens);
                Rc::new(Kept::new(tokens))
            }
        };
        self.included.insert(file, Some(text.clone()));
        Some(text)
    }

    /// A file of that name, or the embedded text.
    fn included_file(&mut self, name: &str, span: Span) -> Result<FileId> {
        let found = self.find_file(name, Kind::Include);
        let lenient = found.as_ref().is_none_or(|f| f.leniency.is_some());
        if lenient
            && self.options.includes != IncludeMode::Installed
            && let Some(file) = self.embedded_file(name)
        {
            return Ok(file);
        }
        let Some(found) = found else {
            self.refuse_special(name, span)?;
            return match self.embedded_in_other_case(name, span)? {
                Some(file) => Ok(file),
                None => Err(self.no_such_file(name, span)),
            };
        };
        if !self.loaded.contains_key(&found.path) {
            self.check_place(&found.path, Access::Read, span)?;
        }
        self.lenient_about(&found, name, span)?;
        let shown = found.path.display().to_string();
        self.load(&found.path, &shown, span)
    }

    fn embedded_file(&mut self, name: &str) -> Option<FileId> {
        let full = if name.ends_with(".inc") { name.to_owned() } else { format!("{name}.inc") };
        let text = embedded::lookup(&full)?;
        let shown = PathBuf::from(format!("<embedded>/{full}"));
        if let Some(&file) = self.loaded.get(&shown) {
            return Some(file);
        }
        let file = self.files.add(shown.display().to_string(), None, Arc::new(text.as_bytes().to_vec()));
        self.loaded.insert(shown, file);
        Some(file)
    }

    /// The embedded text whose name differs in capitals and small letters only, with a warning.
    fn embedded_in_other_case(&mut self, name: &str, span: Span) -> Result<Option<FileId>> {
        let lower = name.to_ascii_lowercase();
        if self.options.includes == IncludeMode::Installed || lower == name {
            return Ok(None);
        }
        let Some(file) = self.embedded_file(&lower) else { return Ok(None) };
        let path = PathBuf::from(self.files.name(file));
        self.lenient_about(&Found { path, leniency: Some(OTHER_CASE) }, name, span)?;
        Ok(Some(file))
    }

    /// A file's text; one read before is not read again.
    pub(super) fn load(&mut self, path: &Path, shown: &str, span: Span) -> Result<FileId> {
        if let Some(&file) = self.loaded.get(path) {
            return Ok(file);
        }
        let text = read(path).map_err(|why| {
            let mut diagnostic = Diagnostic::error(span, format!("cannot read `{shown}`: {why}"));
            if self.frames.is_empty() {
                diagnostic.span = None;
            }
            Box::new(diagnostic)
        })?;
        let file = self.files.add(shown.to_owned(), Some(path.to_owned()), Arc::new(text));
        self.loaded.insert(path.to_owned(), file);
        Ok(file)
    }

    pub(super) fn lexer(&self, file: FileId) -> Lexer {
        Lexer::new(file, self.files.text(file).clone())
    }
}

fn read(path: &Path) -> std::io::Result<Vec<u8>> {
    let size = std::fs::metadata(path)?.len();
    if size > LARGEST {
        return Err(std::io::Error::other("the file is larger than 4 GiB"));
    }
    std::fs::read(path)
}
