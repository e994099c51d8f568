//! How far a scene may go before it is refused.

use super::{Parser, Result};
use crate::function::{LARGEST_RECURSION, patience, went_too_deep};
use crate::source::{Diagnostic, Span};
use std::time::{Duration, Instant};

/// | name | limit | default |
/// |------|-------|---------|
/// | `includes` | files open at once, the main one included | 32 |
/// | `calls` | macro calls and includes within each other | 98 |
/// | `blocks` | conditionals and loops within each other | 200 |
/// | `nesting` | braces, parentheses and brackets within each other | 1,000 |
/// | `tokens` | words of one loop or macro body | 100 million |
/// | `passes` | passes of loops and calls of macros in all | 10^12 |
/// | `elements` | elements of one array | 100 million |
/// | `written` | megabytes that `#write` writes in all | 1,000 |
/// | `seconds` | time to read the scene | 3,600 |
/// | `memory` | megabytes of the program while it reads | three quarters of the machine's |
///
/// The first three are the reference's own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    pub open_files: usize,
    /// Symbol tables at once: two fixed ones, one per open include and one per macro call.
    pub symbol_tables: usize,
    pub blocks: usize,
    pub nesting: usize,
    pub kept_tokens: usize,
    pub passes: u64,
    pub array_elements: usize,
    /// Bytes of all text files together.
    pub written: u64,
    pub seconds: f64,
    /// In bytes; `None` where the machine does not tell.
    pub memory: Option<u64>,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            open_files: 32,
            symbol_tables: 100,
            blocks: 200,
            nesting: 1000,
            kept_tokens: 100_000_000,
            passes: 1_000_000_000_000,
            array_elements: 100_000_000,
            written: 1000 * MEGABYTE,
            seconds: 3600.0,
            memory: installed_memory().map(|bytes| bytes / 4 * 3),
        }
    }
}

/// Most levels of brackets: more would not fit the stack.
const MOST_NESTING: f64 = 4000.0;

impl Limits {
    /// Names that [`Limits::set`] knows.
    pub const NAMES: [&str; 10] = [
        "includes", "calls", "blocks", "nesting", "tokens", "passes", "elements", "written", "seconds",
        "memory",
    ];

    /// Sets a limit by its name; false if there is none of that name, or the value makes no sense.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        if !(1.0..=1e15).contains(&value) {
            return false;
        }
        match name {
            "includes" => self.open_files = value as usize,
            "calls" => self.symbol_tables = value as usize + 2,
            "blocks" => self.blocks = value as usize,
            "nesting" => self.nesting = value.min(MOST_NESTING) as usize,
            "tokens" => self.kept_tokens = value as usize,
            "passes" => self.passes = value as u64,
            "elements" => self.array_elements = value as usize,
            "written" => self.written = (value as u64).saturating_mul(MEGABYTE),
            "seconds" => self.seconds = value,
            "memory" => self.memory = Some((value as u64).saturating_mul(MEGABYTE)),
            _ => return false,
        }
        true
    }
}

pub(super) const MEGABYTE: u64 = 1 << 20;

/// Clock and memory are looked at after so many passes or batches of tokens.
const INTERVAL: u32 = 256;

/// When time is up, and how soon to look again.
#[derive(Debug)]
pub(super) struct Watch {
    end: Option<Instant>,
    wait: u32,
}

impl Watch {
    pub fn new(limits: &Limits) -> Self {
        let time = Duration::try_from_secs_f64(limits.seconds).ok();
        Self { end: time.and_then(|time| Instant::now().checked_add(time)), wait: INTERVAL }
    }
}

impl Parser {
    /// From now on functions called on this thread give up when the time to read the scene is over.
    pub(super) fn bound_functions(&self) {
        patience::give_up_at(self.watch.end);
    }

    /// The error if time ended while a function ran, or it called itself without end.
    pub(crate) fn check_functions(&self) -> Result<()> {
        if went_too_deep() {
            let message = format!("a function calls itself more than {LARGEST_RECURSION} times");
            return Err(Box::new(
                Diagnostic::error(self.last, message).with_hint("`select(condition, …)` must end the calls"),
            ));
        }
        if patience::gave_up() { self.look_at_resources() } else { Ok(()) }
    }

    /// Looks at clock and memory now and then.
    #[inline]
    pub(super) fn watch(&mut self) -> Result<()> {
        self.watch.wait -= 1;
        if self.watch.wait > 0 {
            return Ok(());
        }
        self.watch.wait = INTERVAL;
        self.look_at_resources()
    }

    #[cold]
    fn look_at_resources(&self) -> Result<()> {
        if self.watch.end.is_some_and(|end| Instant::now() > end) {
            let message =
                format!("reading the scene takes more than {} seconds", self.options.limits.seconds);
            return Err(Box::new(
                Diagnostic::error(self.last, message)
                    .with_hint("does a loop or a function never end? `--limit seconds=N` gives it more time"),
            ));
        }
        match (self.options.limits.memory, used_memory()) {
            (Some(limit), Some(used)) if used > limit => Err(self.out_of_memory(self.last, limit)),
            _ => Ok(()),
        }
    }

    /// Refuses to allocate more than the limit leaves.
    pub(crate) fn reserve(&self, bytes: u64, span: Span) -> Result<()> {
        match self.options.limits.memory {
            Some(limit) if bytes > MEGABYTE && used_memory().unwrap_or(0).saturating_add(bytes) > limit => {
                Err(self.out_of_memory(span, limit))
            }
            _ => Ok(()),
        }
    }

    fn out_of_memory(&self, span: Span, limit: u64) -> Box<Diagnostic> {
        let message = format!("reading the scene takes more than {} MB of memory", limit / MEGABYTE);
        Box::new(Diagnostic::error(span, message).with_hint("`--limit memory=N` gives it more"))
    }
}

/// Memory of the machine, in bytes.
fn installed_memory() -> Option<u64> {
    let table = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = table.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    Some(line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()? * 1024)
}

/// Memory that the program uses now, in bytes.
fn used_memory() -> Option<u64> {
    const PAGE: u64 = 4096;
    let table = std::fs::read_to_string("/proc/self/statm").ok()?;
    Some(table.split(' ').nth(1)?.parse::<u64>().ok()? * PAGE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn megabytes_do_not_overflow() {
        let mut limits = Limits::default();
        assert!(limits.set("written", 17_592_186_044_416.0) && limits.set("memory", 1e15));
        assert_eq!((limits.written, limits.memory), (u64::MAX, Some(u64::MAX)));
        assert!(!limits.set("written", 1e16) && !limits.set("write", 1.0));
    }
}
