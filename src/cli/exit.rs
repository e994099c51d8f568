//! Exit codes, and the errors that lead to them.

use std::fmt;

/// What the process says when it ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Exit {
    #[default]
    Done = 0,
    /// A scene was wrong, or a comparison fell short.
    Failed = 1,
    /// The command line was wrong.
    Usage = 2,
    /// A file or a needed program cannot be read, written or found.
    Unavailable = 3,
    /// Stopped by Ctrl-C.
    Interrupted = 130,
}

impl Exit {
    pub fn code(self) -> u8 {
        self as u8
    }
}

/// Why a command ended early: the exit code, and one message for stderr.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    pub exit: Exit,
    pub message: String,
    /// Whether the user has seen the message already.
    pub reported: bool,
}

impl Failure {
    fn new(exit: Exit, message: impl Into<String>) -> Self {
        Self { exit, message: message.into(), reported: false }
    }

    /// A wrong scene whose diagnostic has been drawn.
    pub fn reported(message: impl Into<String>) -> Self {
        Self { reported: true, ..Self::failed(message) }
    }

    pub fn failed(message: impl Into<String>) -> Self {
        Self::new(Exit::Failed, message)
    }

    pub fn usage(message: impl Into<String>) -> Self {
        Self::new(Exit::Usage, message)
    }

    pub fn unavailable(message: impl Into<String>) -> Self {
        Self::new(Exit::Unavailable, message)
    }

    pub fn interrupted(message: impl Into<String>) -> Self {
        Self::new(Exit::Interrupted, message)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl From<crate::picture::PictureError> for Failure {
    fn from(error: crate::picture::PictureError) -> Self {
        Failure::unavailable(error.to_string())
    }
}
