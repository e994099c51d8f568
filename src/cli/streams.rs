//! What is said while scenes are read and rendered, stream by stream: to stderr, and to files that POV-Ray's options
//! name.

use super::diagnostic;
use super::exit::{Exit, Failure};
use crate::source::{Diagnostic, Files};
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::Mutex;

/// The streams that POV-Ray knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stream {
    /// What scenes print.
    Debug,
    Warning,
    /// Errors that end a scene.
    Fatal,
    /// Notes and progress.
    Render,
    /// The line about a finished picture.
    Statistic,
}

impl Stream {
    pub const ALL: [Stream; 5] =
        [Stream::Debug, Stream::Warning, Stream::Fatal, Stream::Render, Stream::Statistic];
}

/// Where the streams go.
#[derive(Debug, Default)]
pub struct Streams {
    silent: [bool; 5],
    files: [Option<Mutex<File>>; 5],
    /// Gets everything.
    all: Option<Mutex<File>>,
}

impl Streams {
    /// All of them on stderr; if `quiet`, errors alone.
    pub fn new(quiet: bool) -> Self {
        Self { silent: Stream::ALL.map(|stream| quiet && stream != Stream::Fatal), ..Self::default() }
    }

    /// On stderr or not.
    pub fn set_console(&mut self, stream: Stream, on: bool) {
        self.silent[stream as usize] = !on;
    }

    /// Also to a file; `None` stands for all streams.
    pub fn open(&mut self, stream: Option<Stream>, path: &Path, append: bool) -> Result<(), Failure> {
        let file =
            if append { File::options().create(true).append(true).open(path) } else { File::create(path) };
        let file = file.map_err(|e| Failure::unavailable(format!("{}: {e}", path.display())))?;
        let place = match stream {
            Some(stream) => &mut self.files[stream as usize],
            None => &mut self.all,
        };
        *place = Some(Mutex::new(file));
        Ok(())
    }

    pub fn is_on_console(&self, stream: Stream) -> bool {
        !self.silent[stream as usize]
    }

    /// Text that ends its own lines.
    pub fn say(&self, stream: Stream, text: &str) {
        if self.is_on_console(stream) {
            eprint!("{text}");
        }
        self.note_down(stream, text);
    }

    /// A diagnostic: drawn on stderr, one line in files.
    pub fn show(&self, diagnostic: &Diagnostic, files: &Files, ascii: bool) {
        let (stream, word) = match diagnostic.severity {
            crate::source::Severity::Error => (Stream::Fatal, "error"),
            _ => (Stream::Warning, "warning"),
        };
        if self.is_on_console(stream) {
            diagnostic::show(diagnostic, files, ascii);
        }
        self.note_down(stream, &format!("{word}: {}\n", diagnostic::line(diagnostic, files)));
    }

    /// Says what went wrong, if nobody has yet.
    pub fn complain(&self, failure: &Failure) {
        if failure.reported {
            return;
        }
        let word = if failure.exit == Exit::Interrupted { "" } else { "error: " };
        self.say(Stream::Fatal, &format!("{word}{failure}\n"));
    }

    /// A full disk must not end a render.
    fn note_down(&self, stream: Stream, text: &str) {
        for file in [&self.files[stream as usize], &self.all].into_iter().flatten() {
            let mut file = file.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
            let _ = file.write_all(text.as_bytes());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quiet_leaves_errors() {
        let streams = Streams::new(true);
        let on = |s: &Stream| streams.is_on_console(*s);
        assert_eq!(Stream::ALL.iter().filter(|s| on(s)).collect::<Vec<_>>(), [&Stream::Fatal]);
        let streams = Streams::new(false);
        assert!(Stream::ALL.iter().all(|s| streams.is_on_console(*s)));
    }
}
