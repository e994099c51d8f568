//! What is said about a scene while it is read.

use crate::source::{Diagnostic, Span};
use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};

#[derive(Debug, Default)]
pub(super) struct Messages {
    pub warnings: Vec<Diagnostic>,
    pub unsupported: Vec<String>,
    /// Output of `#debug` and its like.
    pub debug: String,
    seen: HashSet<(Option<(u32, u32)>, u64)>,
}

/// More warnings than this are counted, not kept.
const MOST_WARNINGS: usize = 1000;

impl Messages {
    /// Whether a warning of that text at that place is new.
    pub fn is_new(&mut self, span: Option<Span>, message: &str) -> bool {
        let mut hasher = DefaultHasher::new();
        message.hash(&mut hasher);
        self.warnings.len() < MOST_WARNINGS
            && self.seen.insert((span.map(|s| (s.file.0, s.start)), hasher.finish()))
    }
}
