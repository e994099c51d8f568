//! Scene text with its files, places in it, and what is said about them.

mod diagnostic;
mod files;

pub use diagnostic::{Diagnostic, Label, Severity};
pub use files::{FileId, Files, Span, Text};
