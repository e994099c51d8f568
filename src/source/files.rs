use std::path::PathBuf;
use std::sync::Arc;

/// A text's bytes, in the memory that they were read into.
pub type Text = Arc<Vec<u8>>;

/// One text that was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct FileId(pub u32);

/// Bytes `start..end` of a file's text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Span {
    pub file: FileId,
    pub start: u32,
    pub end: u32,
}

impl Span {
    /// From the start of `self` to the end of `other`, if both lie in one file; else `self`.
    pub fn to(self, other: Span) -> Span {
        if self.file == other.file && other.end >= self.start {
            Span { end: other.end, ..self }
        } else {
            self
        }
    }
}

/// Every text read for a scene, kept for its diagnostics.
#[derive(Debug, Default)]
pub struct Files {
    files: Vec<File>,
}

#[derive(Debug)]
struct File {
    name: String,
    path: Option<PathBuf>,
    text: Text,
}

impl Files {
    /// `name` is what diagnostics show; `path` is `None` for embedded texts and standard input.
    pub fn add(&mut self, name: String, path: Option<PathBuf>, text: Text) -> FileId {
        self.files.push(File { name, path, text });
        FileId(self.files.len() as u32 - 1)
    }

    pub fn name(&self, id: FileId) -> &str {
        &self.files[id.0 as usize].name
    }

    pub fn path(&self, id: FileId) -> Option<&PathBuf> {
        self.files[id.0 as usize].path.as_ref()
    }

    pub fn text(&self, id: FileId) -> &Text {
        &self.files[id.0 as usize].text
    }

    /// Names of all texts in the order in which they were met, and where each was read from.
    pub fn names(&self) -> impl Iterator<Item = (&str, Option<&PathBuf>)> {
        self.files.iter().map(|f| (f.name.as_str(), f.path.as_ref()))
    }

    /// All texts in the order in which they were met.
    pub fn texts(&self) -> impl Iterator<Item = &[u8]> {
        self.files.iter().map(|f| &f.text[..])
    }
}
