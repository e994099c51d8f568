//! Functions that call themselves.

use super::Compiled;
use super::number::Number;
use std::cell::Cell;
use std::sync::{Arc, OnceLock, Weak};

/// Most calls of one function within each other.
pub const LARGEST_RECURSION: u32 = 2000;

thread_local! {
    /// Calls that are open now.
    static DEPTH: Cell<u32> = const { Cell::new(0) };
    /// Whether the outermost open call, or the last one, went too deep.
    static TOO_DEEP: Cell<bool> = const { Cell::new(false) };
}

/// Whether the last call of a function on this thread called itself too often; its value means nothing.
pub fn went_too_deep() -> bool {
    TOO_DEEP.get()
}

/// A function as its own body sees it: known once it is compiled.
#[derive(Clone, Debug, Default)]
pub(super) struct Itself(Arc<OnceLock<Weak<Compiled>>>);

impl Itself {
    pub fn is(&self, function: &Arc<Compiled>) {
        // Set once: every function has a cell of its own.
        let _ = self.0.set(Arc::downgrade(function));
    }

    /// The value on numbers. On ranges all branches are looked at, so that nothing would end the calls.
    pub fn number<N: Number>(&self, arguments: &[N]) -> N {
        if N::RANGES {
            return N::UNKNOWN;
        }
        let Some(function) = self.0.get().and_then(Weak::upgrade) else { return N::UNKNOWN };
        let depth = DEPTH.get();
        if depth == 0 {
            TOO_DEEP.set(false);
        }
        if depth >= LARGEST_RECURSION {
            TOO_DEEP.set(true);
        }
        // One call that went too deep spoils them all.
        if TOO_DEEP.get() {
            return N::UNKNOWN;
        }
        DEPTH.set(depth + 1);
        let value = function.on_numbers.run(arguments);
        DEPTH.set(depth);
        value
    }
}
